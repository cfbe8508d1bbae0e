#pragma once

#include <httplib.h>

#include <atomic>
#include <string>
#include <thread>

#include "campaign/serve/lobby.hpp"

namespace eerie::serve {

/// The server of httplib, which sees a request only once its head is whole and well-formed
/// (lobby.hpp), on sockets with limits (socket_stream.hpp). It binds its own ports.
class GuardedServer : public httplib::Server {
 public:
  GuardedServer();
  ~GuardedServer() override;

  /// Binds to an address. Port 0 means any free port. Returns the port. Throws EnvironmentError,
  /// which names address, port and mend.
  int bind(const std::string& address, int port);

  /// Answers in threads of its own from now on, until end(). Call it after bind().
  void begin();
  /// Ends all connections, and listening.
  void end();

 private:
  bool process_and_close_socket(socket_t socket) override;
  bool serve(Visitor& visitor);
  void answer(Visitor visitor);

  std::atomic<bool> stopping_ = false, over_ = false;
  std::atomic<int> at_work_ = 0;  ///< requests that are answered, or wait for a thread
  Lobby lobby_;
  httplib::ThreadPool workers_;
  std::thread listening_;
};

/// The most bytes of a submitted sweep.
inline constexpr std::size_t largest_body = 4 << 20;

}  // namespace eerie::serve
