#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "db/store/place.hpp"

namespace eerie::serve {

/// Sends the changes of a campaign to all listeners. One thread looks for them, whatever the number
/// of listeners: twice a second at the file under the name of the database, which may have been
/// written, replaced or removed, at the status of the manager, and at the progress of running jobs
/// while somebody listens.
class Events {
 public:
  explicit Events(std::filesystem::path database);
  ~Events();
  Events(const Events&) = delete;
  Events& operator=(const Events&) = delete;

  /// The generation, which rises with every change of the database that was seen, and less often
  /// where replies are expensive.
  std::uint64_t generation() const { return generation_; }

  /// Adds processor time that replies of this generation took. The next generation comes so late
  /// that all replies together take two per cent of a core, however often they are requested.
  void note_cost(std::chrono::nanoseconds spent) { spent_ns_ += spent.count(); }

  /// A listener. There are at most `most_listeners` at a time.
  class Listener {
   public:
    explicit Listener(Events& events) : events_(events) {}
    ~Listener();
    Listener(const Listener&) = delete;
    Listener& operator=(const Listener&) = delete;

    /// The news since the last call, as server-sent events; a comment where there are none for this
    /// long. Nothing once the events have ended.
    std::optional<std::string> next(std::chrono::milliseconds patience);

   private:
    friend class Events;
    Events& events_;
    std::array<std::uint64_t, 3> seen_{};  ///< the number of the latest news of each kind
  };
  static constexpr int most_listeners = 64;
  /// A new listener; null where there are too many.
  std::shared_ptr<Listener> listen();

  /// The latest news for those who ask instead of listening: {"again_s", "database", "work",
  /// "progress"}, null where there is none yet. `again_s`: when to ask again.
  std::string latest() const;

  /// Throws GoneError where the file under the name of the database is not the one that the news
  /// are of: what somebody wants of it was not meant for the new one.
  void require_shown() const;

  /// Ends the events and wakes all listeners.
  void end();

 private:
  enum Kind { of_database, of_work, of_progress };
  struct News {
    std::uint64_t number = 0;
    std::string text;  ///< JSON on one line
  };
  class Watch;

  void look_again_and_again();
  void look(Watch& watch);
  void tell_of_problem(const std::string& problem);
  void tell(Kind kind, std::string text);
  std::string news_since(Listener& listener) const;

  std::filesystem::path path_;
  std::atomic<std::uint64_t> generation_ = 1;
  std::atomic<std::int64_t> spent_ns_ = 0;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::array<News, 3> news_;
  std::optional<db::FileIdentity> shown_;
  int listeners_ = 0;
  bool over_ = false;
  std::thread thread_;
};

}  // namespace eerie::serve
