#pragma once

#include <httplib.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>

namespace eerie::serve {

/// A connection with limits: a request must arrive within a time and a number of bytes, and a reply
/// must be taken within a time, however slowly the other side sends or reads.
class SocketStream : public httplib::Stream {
 public:
  /// Does not own the socket. `stopping` ends all waiting.
  SocketStream(socket_t socket, const std::atomic<bool>& stopping);

  struct Allowance {
    std::chrono::milliseconds time;
    std::size_t bytes;
  };
  /// Sets the limits of the next request.
  void allow(Allowance allowance);

  /// Whether the next request, or the end of the connection, came within the time.
  bool is_asked(std::chrono::milliseconds patience) const;
  /// Ends the connection. It first reads what the other side has sent, so that the last reply still
  /// arrives.
  void part();

  bool is_readable() const override;
  bool is_writable() const override;
  ssize_t read(char* data, std::size_t size) override;
  /// Writes the whole text, or fails.
  ssize_t write(const char* data, std::size_t size) override;
  void get_remote_ip_and_port(std::string& ip, int& port) const override;
  void get_local_ip_and_port(std::string& ip, int& port) const override;
  socket_t socket() const override { return socket_; }

 private:
  using Clock = std::chrono::steady_clock;
  bool wait_for(short events, Clock::time_point until) const;

  socket_t socket_;
  const std::atomic<bool>& stopping_;
  Clock::time_point read_until_ = Clock::time_point::max();
  std::size_t bytes_left_ = 0;
  std::array<char, 4096> buffer_{};
  std::size_t begin_ = 0, end_ = 0;  ///< the range of bytes that are read and not yet taken
};

}  // namespace eerie::serve
