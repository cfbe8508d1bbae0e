#include "campaign/serve/guarded_server.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "campaign/serve/socket_stream.hpp"
#include "solver/base/error.hpp"

namespace eerie::serve {
using namespace std::chrono_literals;

namespace {
// Each open event stream holds a thread (events.hpp); the others answer.
constexpr std::size_t threads = 96;
constexpr SocketStream::Allowance for_head{10s, 1 << 15}, for_body{30s, largest_body};
constexpr auto between_requests = 2s;
constexpr int requests_per_connection = 100;
}  // namespace

GuardedServer::GuardedServer() {
  new_task_queue = [] { return new httplib::ThreadPool(threads); };
  set_payload_max_length(largest_body);
  set_tcp_nodelay(true);
  set_socket_options([](socket_t socket) {
    // Not SO_REUSEPORT, as is httplib's way: two servers would share a port and know nothing of it.
    const int yes = 1;
    ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    ::fcntl(socket, F_SETFD, FD_CLOEXEC);  // workers of a daemon do not keep the port
  });
}

int GuardedServer::bind(const std::string& address, int port) {
  errno = 0;
  const int bound = port == 0 ? bind_to_any_port(address) : bind_to_port(address, port) ? port : -1;
  if (bound > 0) return bound;
  const std::string reason = errno != 0 ? std::strerror(errno) : "it is no address of this machine";
  throw EnvironmentError(
      fmt::format("cannot listen on {} port {}: {}; give another --port (0: any that is free)",
                  address, port, reason));
}

void GuardedServer::end() {
  stopping_ = true;
  stop();
}

bool GuardedServer::process_and_close_socket(socket_t socket) {
  ::fcntl(socket, F_SETFD, FD_CLOEXEC);
  SocketStream stream(socket, stopping_);
  bool closed = false;
  for (int k = 0; k < requests_per_connection && !closed && stream.is_asked(between_requests);
       ++k) {
    stream.allow(for_head);
    bool last = k + 1 == requests_per_connection;
    const bool answered = process_request(stream, last, closed, [&](httplib::Request& request) {
      stream.allow(for_body);
      // Packed by httplib, at brotli's slowest level, three.js takes seconds to come.
      request.headers.erase("Accept-Encoding");
      // A body that nobody read would be taken for the next request.
      if (request.method != "GET" || request.has_header("Content-Length") ||
          request.has_header("Transfer-Encoding"))
        last = true;
    });
    if (!answered || last) break;
  }
  stream.part();
  ::shutdown(socket, SHUT_RDWR);
  ::close(socket);
  return true;
}

}  // namespace eerie::serve
