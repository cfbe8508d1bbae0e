#pragma once

#include <httplib.h>

#include <atomic>
#include <string>

namespace eerie::serve {

/// The server of httplib on sockets with limits (socket_stream.hpp), which binds its own ports.
class GuardedServer : public httplib::Server {
 public:
  GuardedServer();

  /// Binds to an address. Port 0 means any free port. Returns the port. Throws EnvironmentError,
  /// which names address, port and mend.
  int bind(const std::string& address, int port);

  /// Ends all connections, so that listen_after_bind() returns.
  void end();

 private:
  bool process_and_close_socket(socket_t socket) override;

  std::atomic<bool> stopping_ = false;
};

/// The most bytes of a submitted sweep.
inline constexpr std::size_t largest_body = 4 << 20;

}  // namespace eerie::serve
