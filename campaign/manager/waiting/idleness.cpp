#include "campaign/manager/waiting/idleness.hpp"

#include <utility>

namespace eerie::manager {

std::optional<Idleness::Moment> Idleness::look(const CampaignView& view) {
  const std::size_t finished = view.done + view.failed;
  const bool is_idle = view.running == 0 && finished + view.paused == view.total && !view.stopping;
  // A short job may begin and end between two views.
  if (!is_idle || (finished_ && finished != *finished_)) has_worked_ = true;
  finished_ = finished;
  if (!is_idle || !has_worked_) return std::nullopt;
  has_worked_ = false;
  return view.failed > std::exchange(failed_, view.failed) ? Moment::idle_with_new_failures
                                                           : Moment::idle;
}

}  // namespace eerie::manager
