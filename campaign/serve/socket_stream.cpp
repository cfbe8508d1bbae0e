#include "campaign/serve/socket_stream.hpp"

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

namespace eerie::serve {
using namespace std::chrono_literals;

namespace {
constexpr auto slice = 200ms;  // of waiting, between looks at whether the server stops
constexpr auto time_to_take = 20s;
}  // namespace

SocketStream::SocketStream(socket_t socket, std::string bytes, const std::atomic<bool>& stopping)
    : socket_(socket), stopping_(stopping), bytes_(std::move(bytes)) {}

void SocketStream::allow(Allowance allowance) {
  read_until_ = Clock::now() + allowance.time;
  bytes_left_ = allowance.bytes;
}

bool SocketStream::wait_for(short events, Clock::time_point until) const {
  while (!stopping_) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now());
    if (left < 0ms) return false;
    pollfd one{socket_, events, 0};
    const int ready =
        ::poll(&one, 1, static_cast<int>(std::min<long>(left.count(), slice.count())));
    if (ready > 0) return true;
    if (ready < 0 && errno != EINTR) return false;
    if (ready == 0 && left == 0ms) return false;
  }
  return false;
}

bool SocketStream::is_readable() const {
  return begin_ < bytes_.size() || wait_for(POLLIN, read_until_);
}

bool SocketStream::is_writable() const {
  char byte = 0;
  const ssize_t there = ::recv(socket_, &byte, 1, MSG_PEEK | MSG_DONTWAIT);
  if (there == 0) return false;  // the other side has gone
  return wait_for(POLLOUT, Clock::now() + time_to_take);
}

ssize_t SocketStream::read(char* data, std::size_t size) {
  if (begin_ == bytes_.size()) {
    if (bytes_left_ == 0 || !wait_for(POLLIN, read_until_)) return -1;
    begin_ = 0;
    bytes_.resize(std::min(std::size_t{4096}, bytes_left_));
    const ssize_t got = ::recv(socket_, bytes_.data(), bytes_.size(), 0);
    bytes_.resize(static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    if (got <= 0) return got;
    bytes_left_ -= bytes_.size();
  }
  const std::size_t taken = std::min(size, bytes_.size() - begin_);
  std::memcpy(data, bytes_.data() + begin_, taken);
  begin_ += taken;
  return static_cast<ssize_t>(taken);
}

ssize_t SocketStream::write(const char* data, std::size_t size) {
  const auto until = Clock::now() + time_to_take;
  for (std::size_t sent = 0; sent < size;) {
    if (!wait_for(POLLOUT, until)) return -1;
    const ssize_t some = ::send(socket_, data + sent, size - sent, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (some < 0 && errno != EAGAIN && errno != EINTR) return -1;
    if (some > 0) sent += static_cast<std::size_t>(some);
  }
  return static_cast<ssize_t>(size);
}

void SocketStream::get_remote_ip_and_port(std::string& ip, int& port) const {
  ip.clear(), port = 0;
}
void SocketStream::get_local_ip_and_port(std::string& ip, int& port) const { ip.clear(), port = 0; }

}  // namespace eerie::serve
