#include "campaign/serve/request_head.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace eerie::serve {
namespace {

constexpr std::array<std::string_view, 9> methods = {
    "GET", "HEAD", "POST", "PUT", "DELETE", "OPTIONS", "PATCH", "TRACE", "CONNECT"};

bool is_control(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return (byte < 0x20 && c != '\t') || byte == 0x7f;
}

/// METHOD /address HTTP/1.1
bool is_request_line(std::string_view text) {
  const std::size_t first = text.find(' '), last = text.rfind(' ');
  if (first == std::string_view::npos || first == last) return false;
  const std::string_view address = text.substr(first + 1, last - first - 1),
                         version = text.substr(last + 1);
  return std::ranges::find(methods, text.substr(0, first)) != methods.end() &&
         address.starts_with('/') && address.find_first_of(" \t") == std::string_view::npos &&
         (version == "HTTP/1.1" || version == "HTTP/1.0");
}

/// name: value
bool is_field(std::string_view text) {
  const std::string_view name = text.substr(0, text.find(':'));
  return !name.empty() && name.size() < text.size() && std::ranges::all_of(name, [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string_view("!#$%&'*+-.^_`|~").find(c) != std::string_view::npos;
  });
}

}  // namespace

RequestHead::State RequestHead::refused(int status, const char* why) {
  refusal_ = serve::refusal(status, why);
  return State::refused;
}

RequestHead::State RequestHead::line(std::string_view text) {
  if (std::ranges::any_of(text, is_control))
    return refused(400, "the request has a control character in its head");
  if (line_ == 0)
    return is_request_line(text)
               ? State::incomplete
               : refused(400, "the first line of the request is not METHOD /address VERSION");
  if (text.empty()) return State::complete;
  return is_field(text) ? State::incomplete
                        : refused(400, "a line of the request's head is not NAME: VALUE");
}

RequestHead::State RequestHead::look(std::string_view bytes) {
  while (seen_ < bytes.size()) {
    const std::size_t end = bytes.find('\n', seen_);
    seen_ = end == std::string_view::npos ? bytes.size() : end + 1;
    if (seen_ - line_ > longest_line)
      return line_ == 0 ? refused(414, "the address is too long")
                        : refused(431, "a field of the request's head is too long");
    if (seen_ > most_bytes) return refused(431, "the head of the request is too large");
    if (end == std::string_view::npos) break;
    if (end == line_ || bytes[end - 1] != '\r')
      return refused(400, "a line of the request's head does not end in CR LF");
    const State state = line(bytes.substr(line_, end - 1 - line_));
    line_ = seen_;
    if (state != State::incomplete) return state;
  }
  return State::incomplete;
}

}  // namespace eerie::serve
