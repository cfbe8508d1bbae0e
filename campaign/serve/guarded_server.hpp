#pragma once

#include <httplib.h>

#include <atomic>
#include <string>

namespace eerie::serve {

/// httplib's server on sockets that give up (socket_stream.hpp), with ports of its own.
class GuardedServer : public httplib::Server {
 public:
  GuardedServer();

  /// Binds to an address; port 0: any that is free. Returns the port. Throws EnvironmentError
  /// naming address, port and mend.
  int bind(const std::string& address, int port);

  /// Ends what waits and what is written; listen_after_bind() returns.
  void end();

 private:
  bool process_and_close_socket(socket_t socket) override;

  std::atomic<bool> stopping_ = false;
};

/// Bytes of a sweep that is submitted, at most.
inline constexpr std::size_t largest_body = 4 << 20;

}  // namespace eerie::serve
