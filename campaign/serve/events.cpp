#include "campaign/serve/events.hpp"

#include <SQLiteCpp/Database.h>
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "campaign/job_folder/job_directory.hpp"
#include "campaign/serve/views/overview.hpp"
#include "db/jobs/jobs.hpp"
#include "db/store/connection.hpp"
#include "db/store/error.hpp"
#include "db/store/migrations.hpp"
#include "db/store/upgrade.hpp"

namespace eerie::serve {
using nlohmann::json;
using namespace std::chrono_literals;

namespace {

constexpr std::array<const char*, 3> kind_names = {"database", "work", "progress"};
constexpr auto between_looks = 500ms;

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

/// An open database and what was last seen of it.
class Events::Watch {
 public:
  explicit Watch(const std::filesystem::path& path)
      : path_(path), file_(path, db::Access::read_any), readable_(opened()) {}

  /// Whether somebody has written to the database since the last call.
  bool has_changed() {
    int now = 0;
    file_.read([&](SQLite::Database& sql) {
      // Reads a page, and with it the version: the pragma alone would tell the one known before.
      sql.execAndGet("SELECT count(*) FROM sqlite_master");
      now = sql.execAndGet("PRAGMA data_version").getInt();
    });
    if (std::exchange(version_, now) == now) return false;
    // Of an older schema a copy is read, which stays as it was.
    if (db::schema_of_file(path_) < db::latest_version()) readable_ = opened();
    return true;
  }
  const db::Connection& connection() const { return *readable_; }

 private:
  std::unique_ptr<db::Connection> opened() const {
    return std::make_unique<db::Connection>(path_, db::Access::read);
  }

  std::filesystem::path path_;
  db::Connection file_;
  std::unique_ptr<db::Connection> readable_;
  int version_ = -1;
};

Events::Events(std::filesystem::path database)
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

void Events::look_again_and_again() {
  std::unique_ptr<Watch> watch;
  auto told = std::chrono::steady_clock::now();
  bool untold = false;
  for (;;) {
    bool somebody_listens = false;
    {
      std::unique_lock lock(mutex_);
      if (changed_.wait_for(lock, watch ? between_looks : 0ms, [&] { return over_; })) return;
      somebody_listens = listeners_ > 0;
    }
    try {
      if (!watch) watch = std::make_unique<Watch>(path_);
      untold = watch->has_changed() || untold;
      if (const auto now = std::chrono::steady_clock::now();
          untold && now - told >= pause_after(spent_ns_)) {
        untold = false, told = now, spent_ns_ = 0;
        tell(of_database, json{{"generation", ++generation_}}.dump());
      }
      tell(of_work, work_json(path_).dump());
      if (somebody_listens) tell(of_progress, progress_of(watch->connection()).dump());
    } catch (const db::Error& error) {
      // Replaced, migrated or for a moment without room: it is opened anew.
      watch.reset();
      tell(of_database, json{{"generation", ++generation_}, {"problem", error.what()}}.dump());
      std::unique_lock lock(mutex_);
      if (changed_.wait_for(lock, 2s, [&] { return over_; })) return;
    }
  }
}

}  // namespace eerie::serve
