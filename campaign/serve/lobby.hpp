#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "campaign/serve/reply.hpp"

namespace eerie::serve {

/// A connection between two requests.
struct Visitor {
  int socket = -1;
  std::string bytes = {};  ///< what came and was not used yet
  int requests = 0;        ///< how many were answered
};

/// Connections that wait: for the head of a request, or for their end. One thread watches them all,
/// so that those who are slow or silent cost a descriptor each and hold up nobody. A bad head is
/// answered once, and its connection closed. Where too many wait, the one whose time is up first
/// leaves.
class Lobby {
 public:
  static constexpr std::size_t most_waiting = 384;
  static constexpr std::chrono::seconds for_head{10}, between_requests{6}, for_parting{2};

  /// `serve` is called on the thread of the lobby for a connection with a whole head. False: there
  /// is no room for it now, and it is refused with 503.
  explicit Lobby(std::function<bool(Visitor&)> serve);
  ~Lobby();
  Lobby(const Lobby&) = delete;
  Lobby& operator=(const Lobby&) = delete;

  /// A connection that may send a request.
  void wait_for_request(Visitor visitor);
  /// A connection that has its last reply. What it still sends is read, so that the reply arrives.
  void see_off(int socket);

  /// Closes all connections, now and from now on.
  void end();

 private:
  using Clock = std::chrono::steady_clock;
  struct Waiting;

  void come_in(Waiting waiting);
  void watch();
  bool admit();
  void consider(Waiting& one);
  void hear(Waiting& one);
  void lose_patience(Waiting& one);
  void refuse(Waiting& one, const Reply& reply);

  std::function<bool(Visitor&)> serve_;
  int bell_ = -1;  ///< an eventfd: somebody came, or it is over
  std::mutex mutex_;
  std::vector<Waiting> at_the_door_;
  bool over_ = false;
  std::vector<Waiting> waiting_;  ///< of the thread alone
  std::thread thread_;
};

}  // namespace eerie::serve
