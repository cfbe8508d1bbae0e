#include "campaign/manager/waiting/news.hpp"

#include "campaign/process/hook.hpp"

namespace eerie::manager {
namespace fs = std::filesystem;

News news_of(Idleness::Moment moment, const CampaignView& view) {
  return {.event = moment == Idleness::Moment::idle ? "idle" : "failed",
          .jobs = Tally{view.total, view.done, view.failed, view.paused, view.paused}};
}

std::string tell(const std::string& program, const fs::path& database, const News& news) {
  process::Hook::Facts facts = {
      {"EERIE_EVENT", news.event},
      {"EERIE_DATABASE", database.empty() ? "" : fs::absolute(database).string()}};
  if (!news.sweep.empty()) facts.emplace_back("EERIE_SWEEP", news.sweep);
  if (!news.message.empty()) facts.emplace_back("EERIE_MESSAGE", news.message);
  if (news.jobs)
    for (const auto& [name, count] :
         {std::pair("EERIE_JOBS", news.jobs->total), std::pair("EERIE_DONE", news.jobs->done),
          std::pair("EERIE_FAILED", news.jobs->failed), std::pair("EERIE_LEFT", news.jobs->left)})
      facts.emplace_back(name, std::to_string(count));
  return process::Hook(program).tell(news.event, facts);
}

}  // namespace eerie::manager
