#include "campaign/serve/lobby.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <utility>

#include "campaign/serve/access.hpp"
#include "campaign/serve/request_head.hpp"
#include "solver/base/error.hpp"

namespace eerie::serve {
using namespace std::chrono_literals;

namespace {

constexpr std::size_t most_dropped = 1 << 20;  // of one that leaves

const char* words_of(int status) {
  switch (status) {
    case 400:
      return "Bad Request";
    case 408:
      return "Request Timeout";
    case 414:
      return "URI Too Long";
    case 431:
      return "Request Header Fields Too Large";
    default:
      return "Service Unavailable";
  }
}

std::string text_of(const Reply& reply) {
  std::string text = fmt::format("HTTP/1.1 {} {}\r\n", reply.status, words_of(reply.status));
  for (const auto& [name, value] : guard_headers()) text += fmt::format("{}: {}\r\n", name, value);
  if (reply.retry_s > 0) text += fmt::format("Retry-After: {}\r\n", reply.retry_s);
  return text + fmt::format(
                    "Cache-Control: no-store\r\nContent-Type: {}\r\nContent-Length: {}\r\n"
                    "Connection: close\r\n\r\n{}",
                    reply.type, reply.body.size(), reply.body);
}

void close(int& socket) {
  if (socket < 0) return;
  ::shutdown(socket, SHUT_RDWR);
  ::close(std::exchange(socket, -1));
}

}  // namespace

struct Lobby::Waiting {
  Visitor visitor;
  Clock::time_point until;
  bool leaves = false;
  std::size_t dropped = 0;
  RequestHead head = {};
};

Lobby::Lobby(std::function<bool(Visitor&)> serve)
    : serve_(std::move(serve)), bell_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
  if (bell_ < 0) throw EnvironmentError("the system grants no more open files");
  thread_ = std::thread([this] { watch(); });
}

Lobby::~Lobby() {
  end();
  ::close(bell_);
}

void Lobby::end() {
  {
    const std::lock_guard lock(mutex_);
    over_ = true;
  }
  ::eventfd_write(bell_, 1);
  if (thread_.joinable()) thread_.join();
}

void Lobby::come_in(Waiting waiting) {
  {
    const std::lock_guard lock(mutex_);
    if (over_) return close(waiting.visitor.socket);
    at_the_door_.push_back(std::move(waiting));
  }
  ::eventfd_write(bell_, 1);
}

void Lobby::wait_for_request(Visitor visitor) {
  const auto patience = visitor.bytes.empty() ? between_requests : for_head;
  come_in({.visitor = std::move(visitor), .until = Clock::now() + patience});
}

void Lobby::see_off(int socket) {
  ::shutdown(socket, SHUT_WR);
  come_in({.visitor = {.socket = socket}, .until = Clock::now() + for_parting, .leaves = true});
}

/// False: it is over.
bool Lobby::admit() {
  std::vector<Waiting> newcomers;
  {
    const std::lock_guard lock(mutex_);
    newcomers.swap(at_the_door_);
    if (over_) {
      for (auto* group : {&newcomers, &waiting_})
        for (Waiting& one : *group) close(one.visitor.socket);
      return false;
    }
  }
  for (Waiting& one : newcomers) {
    if (waiting_.size() >= most_waiting) {
      const auto first = std::ranges::min_element(waiting_, {}, &Waiting::until);
      close(first->visitor.socket);
      waiting_.erase(first);
    }
    waiting_.push_back(std::move(one));
    consider(waiting_.back());
  }
  return true;
}

void Lobby::watch() {
  std::vector<pollfd> polled;
  while (admit()) {
    std::erase_if(waiting_, [](const Waiting& one) { return one.visitor.socket < 0; });
    polled = {{bell_, POLLIN, 0}};
    auto next = Clock::now() + 1h;
    for (const Waiting& one : waiting_) {
      polled.push_back({one.visitor.socket, POLLIN, 0});
      next = std::min(next, one.until);
    }
    const auto patience = std::chrono::ceil<std::chrono::milliseconds>(next - Clock::now());
    if (::poll(polled.data(), polled.size(), static_cast<int>(std::max(patience, 0ms).count())) < 0)
      continue;
    std::uint64_t rings = 0;
    ::eventfd_read(bell_, &rings);
    const auto now = Clock::now();
    for (std::size_t k = 0; k < waiting_.size(); ++k) {
      if (polled[k + 1].revents != 0)
        hear(waiting_[k]);
      else if (now >= waiting_[k].until)
        lose_patience(waiting_[k]);
    }
  }
}

void Lobby::hear(Waiting& one) {
  std::array<char, 1 << 14> buffer;
  std::string& bytes = one.visitor.bytes;
  const ssize_t got = ::recv(one.visitor.socket, buffer.data(), buffer.size(), MSG_DONTWAIT);
  if (got < 0 && (errno == EAGAIN || errno == EINTR)) return;
  if (got == 0 && !one.leaves && !bytes.empty())
    return refuse(one, refusal(400, "the request ended before its head did"));
  if (got <= 0) return close(one.visitor.socket);
  if (one.leaves) {
    one.dropped += static_cast<std::size_t>(got);
    if (one.dropped > most_dropped || Clock::now() >= one.until) close(one.visitor.socket);
    return;
  }
  if (bytes.empty()) one.until = Clock::now() + for_head;
  bytes.append(buffer.data(), static_cast<std::size_t>(got));
  consider(one);
  if (!one.leaves && one.visitor.socket >= 0 && Clock::now() >= one.until) lose_patience(one);
}

void Lobby::consider(Waiting& one) {
  if (one.leaves || one.visitor.bytes.empty()) return;
  switch (one.head.look(one.visitor.bytes)) {
    case RequestHead::State::incomplete:
      return;
    case RequestHead::State::refused:
      return refuse(one, one.head.refusal());
    case RequestHead::State::complete:
      if (serve_(one.visitor))
        one.visitor.socket = -1;
      else
        refuse(one, busy("too many requests wait already; ask again"));
  }
}

void Lobby::lose_patience(Waiting& one) {
  if (one.leaves || one.visitor.bytes.empty()) return close(one.visitor.socket);
  refuse(one, refusal(408, "the head of the request took too long"));
}

void Lobby::refuse(Waiting& one, const Reply& reply) {
  const std::string text = text_of(reply);
  const int socket = one.visitor.socket;
  // It fits into the empty buffer of the connection: nobody is waited for.
  if (::send(socket, text.data(), text.size(), MSG_NOSIGNAL | MSG_DONTWAIT) < 0)
    return close(one.visitor.socket);
  ::shutdown(socket, SHUT_WR);
  one.leaves = true;
  one.until = Clock::now() + for_parting;
}

}  // namespace eerie::serve
