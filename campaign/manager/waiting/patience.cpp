#include "campaign/manager/waiting/patience.hpp"

#include <fmt/format.h>

#include "campaign/process/signals.hpp"
#include "db/store/error.hpp"

namespace eerie::manager {
namespace {

constexpr std::chrono::milliseconds short_wait{500}, usual_wait{10'000};

}  // namespace

LessPatience::LessPatience(db::Connection& connection) : connection_(connection) {
  connection_.wait_at_most(short_wait);
}

LessPatience::~LessPatience() { connection_.wait_at_most(usual_wait); }

void when_free(db::Connection& connection, const std::function<void()>& write,
               const std::function<void(const std::string&)>& note) {
  const LessPatience patience(connection);
  for (bool is_told = false; true; is_told = true) {
    try {
      return write();
    } catch (const db::BusyError& error) {
      if (!is_told) note(fmt::format("waiting: {}", error.what()));
    }
    process::wait_for_signal(std::chrono::milliseconds(100));
    if (process::stop_requests() > 0)
      throw StoppedBefore("stopped before the work began; the same command begins it");
  }
}

}  // namespace eerie::manager
