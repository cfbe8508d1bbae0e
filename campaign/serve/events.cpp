#include "campaign/serve/events.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <ctime>
#include <exception>
#include <nlohmann/json.hpp>

#include "campaign/job_folder/job_directory.hpp"
#include "campaign/serve/reply.hpp"
#include "campaign/serve/views/overview.hpp"
#include "db/jobs/jobs.hpp"
#include "db/store/connection.hpp"
#include "db/store/error.hpp"

namespace eerie::serve {
namespace fs = std::filesystem;
using nlohmann::json;
using namespace std::chrono_literals;

namespace {

constexpr std::array<const char*, 3> kind_names = {"database", "work", "progress"};
constexpr auto between_looks = 500ms, between_looks_in_trouble = 1000ms;
using Clock = std::chrono::steady_clock;

/// Whether it was a moment ago, of which the clock of the file system may know no parts.
bool is_recent(const timespec& then) {
  timespec now{};
  ::clock_gettime(CLOCK_REALTIME, &now);
  const auto seconds = std::chrono::seconds(now.tv_sec - then.tv_sec);
  return std::chrono::abs(seconds + std::chrono::nanoseconds(now.tv_nsec - then.tv_nsec)) < 20ms;
}

/// Of replies that took so long: until they may be made anew.
std::chrono::nanoseconds pause_after(std::int64_t spent_ns) {
  constexpr std::int64_t times = 50;
  return std::min<std::chrono::nanoseconds>(std::chrono::nanoseconds(times * spent_ns), 60s);
}

/// How far each running job is, by its hash.
json progress_of(const db::Connection& connection) {
  const job_folder::JobFolder folder = job_folder::job_folder(connection);
  json parts = json::object();
  for (const db::Job& job : db::jobs(connection, {.state = db::JobState::running}))
    if (const auto p = job_folder::read_progress(folder.of(job.hash)); p && p->expected_end_s > 0)
      parts[job.hash] = {{"part", std::min(1.0, p->time_s / p->expected_end_s)},
                         {"time_s", p->time_s},
                         {"step", p->step}};
  return parts;
}

}  // namespace

/// What was seen of the database's file and of its write-ahead log. It keeps neither open: through
/// a descriptor it would see a file that was replaced for ever, and keep the last writer from
/// tidying the log away.
class Events::Watch {
 public:
  struct Seen {
    bool changed = false, is_another = false;
  };
  Seen look(const fs::path& database);
  std::optional<db::FileIdentity> identity() const { return identity_; }
  /// The next look finds a change, whatever it finds.
  void forget() { *this = {}; }

  bool untold = false;          ///< a change
  std::string problem = {};     ///< the one told last; empty: all was well
  Clock::time_point told = {};  ///< when a change was

 private:
  std::optional<db::FileIdentity> identity_;
  std::array<std::int64_t, 6> stamps_{-1};  ///< size and time of writing of both
  bool waits_ = false, again_ = false;
};

Events::Watch::Seen Events::Watch::look(const fs::path& database) {
  const fs::path file = db::resolved(database);
  const auto identity = db::identity(file);
  std::array<std::int64_t, 6> stamps{};
  bool recent = false;
  for (const char* ending : {"", "-wal"}) {
    struct stat info {};
    // A log without content is made by whoever reads.
    if (::stat((file.string() + ending).c_str(), &info) != 0 || info.st_size == 0) continue;
    auto* at = stamps.data() + (*ending == '\0' ? 0 : 3);
    at[0] = info.st_size, at[1] = info.st_mtim.tv_sec, at[2] = info.st_mtim.tv_nsec;
    recent = recent || is_recent(info.st_mtim);
  }
  const bool is_another = identity != identity_;
  if (!is_another && !again_ && stamps == stamps_) return {};
  // A second write within the same tick of the clock shows in nothing: better look after it.
  if (recent && !std::exchange(waits_, true)) return {};
  identity_ = identity, stamps_ = stamps, again_ = recent, waits_ = false;
  return {.changed = true, .is_another = is_another};
}

Events::Events(fs::path database)
    : path_(std::move(database)), thread_([this] { look_again_and_again(); }) {}

Events::~Events() {
  end();
  thread_.join();
}

void Events::end() {
  {
    const std::lock_guard lock(mutex_);
    over_ = true;
  }
  changed_.notify_all();
}

std::shared_ptr<Events::Listener> Events::listen() {
  const std::lock_guard lock(mutex_);
  if (listeners_ >= most_listeners) return nullptr;
  ++listeners_;
  return std::make_shared<Listener>(*this);
}

Events::Listener::~Listener() {
  const std::lock_guard lock(events_.mutex_);
  --events_.listeners_;
}

std::string Events::news_since(Listener& listener) const {
  std::string text;
  for (std::size_t k = 0; k < news_.size(); ++k)
    if (news_[k].number > listener.seen_[k]) {
      text += fmt::format("event: {}\ndata: {}\n\n", kind_names[k], news_[k].text);
      listener.seen_[k] = news_[k].number;
    }
  return text;
}

std::optional<std::string> Events::Listener::next(std::chrono::milliseconds patience) {
  std::unique_lock lock(events_.mutex_);
  std::string text;
  events_.changed_.wait_for(lock, patience, [&] {
    text = events_.news_since(*this);
    return !text.empty() || events_.over_;
  });
  if (events_.over_) return std::nullopt;
  return text.empty() ? ": nothing new\n\n" : text;
}

void Events::tell(Kind kind, std::string text) {
  {
    const std::lock_guard lock(mutex_);
    News& news = news_[kind];
    if (news.text == text) return;
    news.text = std::move(text);
    ++news.number;
  }
  changed_.notify_all();
}

std::string Events::latest() const {
  const std::lock_guard lock(mutex_);
  std::string text = fmt::format("{{\"again_s\":{}", ask_again_s);
  for (std::size_t k = 0; k < news_.size(); ++k)
    text += fmt::format(",\"{}\":{}", kind_names[k], news_[k].number > 0 ? news_[k].text : "null");
  return text + "}";
}

void Events::require_shown() const {
  const std::lock_guard lock(mutex_);
  if (shown_ && db::identity(path_) != shown_)
    throw db::GoneError(fmt::format(
        "database {}: the file was removed or another put in its place a moment ago; see what is "
        "shown now, and ask again",
        path_.string()));
}

void Events::look(Watch& watch) {
  const Watch::Seen seen = watch.look(path_);
  if (seen.changed) db::Connection(path_, db::Access::read);  // or says why not
  watch.untold = watch.untold || seen.changed;
  const auto now = Clock::now();
  if (const bool at_once = seen.is_another || !watch.problem.empty();
      watch.untold && (at_once || now - watch.told >= pause_after(spent_ns_))) {
    watch.untold = false, watch.problem.clear(), watch.told = now, spent_ns_ = 0;
    {
      const std::lock_guard lock(mutex_);
      shown_ = watch.identity();
    }
    tell(of_database, json{{"generation", ++generation_}}.dump());
  }
  tell(of_work, work_json(path_).dump());
}

void Events::look_again_and_again() {
  Watch watch;
  auto pause = 0ms;
  for (;;) {
    bool somebody_listens = false;
    {
      std::unique_lock lock(mutex_);
      if (changed_.wait_for(lock, pause, [&] { return over_; })) return;
      somebody_listens = listeners_ > 0;
    }
    try {
      look(watch);
      if (somebody_listens)
        tell(of_progress, progress_of(db::Connection(path_, db::Access::read)).dump());
      pause = between_looks;
    } catch (const std::exception& error) {
      // Removed, of another program, to be migrated, or for a moment without room.
      const std::string problem = error.what();
      const bool is_new = problem != watch.problem;
      watch.forget();
      watch.problem = problem;
      if (is_new)
        tell(of_database, json{{"generation", ++generation_}, {"problem", problem}}.dump());
      pause = between_looks_in_trouble;
    }
  }
}

}  // namespace eerie::serve
