#include "campaign/serve/guarded_server.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "campaign/serve/access.hpp"
#include "campaign/serve/events.hpp"
#include "campaign/serve/socket_stream.hpp"
#include "solver/base/error.hpp"

namespace eerie::serve {
using namespace std::chrono_literals;

namespace {

// Each open event stream holds a thread; these are left for all others.
constexpr std::size_t threads_besides = 32;
constexpr int most_at_work = 256;
constexpr SocketStream::Allowance for_body{30s, largest_body};
constexpr int requests_per_connection = 100;
constexpr int backlog = 512;

/// Runs what it gets at once: accepting a connection only puts it into the lobby.
class AtOnce : public httplib::TaskQueue {
 public:
  void enqueue(std::function<void()> task) override { task(); }
  void shutdown() override {}
};

}  // namespace

GuardedServer::GuardedServer()
    : lobby_([this](Visitor& visitor) { return serve(visitor); }),
      workers_(Events::most_listeners + threads_besides) {
  new_task_queue = [] { return new AtOnce; };
  httplib::Headers headers;
  for (const auto& [name, value] : guard_headers()) headers.emplace(name, value);
  set_default_headers(std::move(headers));
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
  if (bound > 0) {
    ::listen(svr_sock_, backlog);  // httplib lets five wait; a sixth would try again after a second
    return bound;
  }
  const std::string reason = errno != 0 ? std::strerror(errno) : "it is no address of this machine";
  throw EnvironmentError(
      fmt::format("cannot listen on {} port {}: {}; give another --port (0: any that is free)",
                  address, port, reason));
}

GuardedServer::~GuardedServer() { end(); }

void GuardedServer::begin() {
  listening_ = std::thread([this] {
    listen_after_bind();
    over_ = true;
  });
  // stop() does nothing to a server that does not listen yet, and that would then listen for ever.
  while (!is_running() && !over_) std::this_thread::sleep_for(1ms);
}

void GuardedServer::end() {
  if (stopping_.exchange(true)) return;
  stop();
  lobby_.end();
  workers_.shutdown();
  if (listening_.joinable()) listening_.join();
}

bool GuardedServer::process_and_close_socket(socket_t socket) {
  ::fcntl(socket, F_SETFD, FD_CLOEXEC);
  lobby_.wait_for_request({.socket = socket});
  return true;
}

bool GuardedServer::serve(Visitor& visitor) {
  if (at_work_ >= most_at_work) return false;
  ++at_work_;
  workers_.enqueue([this, visitor = std::move(visitor)]() mutable {
    answer(std::move(visitor));
    --at_work_;
  });
  return true;
}

void GuardedServer::answer(Visitor visitor) {
  SocketStream stream(visitor.socket, std::move(visitor.bytes), stopping_);
  bool last = ++visitor.requests == requests_per_connection, closed = false, understood = false;
  const bool answered = process_request(stream, last, closed, [&](httplib::Request& request) {
    understood = true;
    stream.allow(for_body);
    // Packed by httplib, at brotli's slowest level, three.js takes seconds to come.
    request.headers.erase("Accept-Encoding");
    // A body that nobody read would be taken for the next request.
    if (request.method != "GET" || request.has_header("Content-Length") ||
        request.has_header("Transfer-Encoding"))
      last = true;
  });
  if (!answered || !understood || closed || last) return lobby_.see_off(visitor.socket);
  visitor.bytes = stream.rest();
  lobby_.wait_for_request(std::move(visitor));
}

}  // namespace eerie::serve
