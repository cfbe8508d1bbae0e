#pragma once

#include <httplib.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <string>

namespace eerie::serve {

/// A connection whose request has come up to the end of its head (lobby.hpp). It has limits: a body
/// must arrive within a time and a number of bytes, and a reply must be taken within a time,
/// however slowly the other side sends or reads.
class SocketStream : public httplib::Stream {
 public:
  /// `bytes` came already. Does not own the socket. `stopping` ends all waiting.
  SocketStream(socket_t socket, std::string bytes, const std::atomic<bool>& stopping);

  struct Allowance {
    std::chrono::milliseconds time;
    std::size_t bytes;
  };
  /// Sets the limits of what is still to come.
  void allow(Allowance allowance);

  /// What came and was not read.
  std::string rest() const { return bytes_.substr(begin_); }

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
  Clock::time_point read_until_ = Clock::now();
  std::size_t bytes_left_ = 0;
  std::string bytes_;
  std::size_t begin_ = 0;  ///< of the bytes that are not yet taken
};

}  // namespace eerie::serve
