#include "campaign/serve/access.hpp"

#include <fmt/format.h>
#include <sys/random.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "solver/base/error.hpp"

namespace eerie::serve {
namespace {

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool is_address(const std::string& name) {
  const bool digits = !name.empty() && name.find_first_not_of("0123456789.") == std::string::npos;
  return digits || name.starts_with('[');
}

std::string this_machine() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? lower(name.data()) : "";
}

/// Takes as long for a wrong guess, whichever letter of it is wrong.
bool same_token(const std::string& a, const std::string& b) {
  if (a.empty() || a.size() != b.size()) return false;
  unsigned char differences = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    differences = static_cast<unsigned char>(differences | (a[i] ^ b[i]));
  return differences == 0;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> guard_headers() {
  return {{"Content-Security-Policy",
           "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data:; "
           "connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"},
          {"X-Content-Type-Options", "nosniff"},
          {"Referrer-Policy", "no-referrer"},
          {"Cross-Origin-Resource-Policy", "same-origin"},
          {"Cross-Origin-Opener-Policy", "same-origin"}};
}

std::string new_token() {
  std::array<unsigned char, 16> bytes{};
  if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw EnvironmentError("the system gives no random numbers; a token needs them");
  std::string text;
  for (const unsigned char byte : bytes) text += fmt::format("{:02x}", byte);
  return text;
}

std::string host_name_of(const std::string& header) {
  const bool bracketed = header.starts_with('[');
  const std::size_t end = bracketed ? header.find(']') : header.find(':');
  if (bracketed && end == std::string::npos) return "";
  const std::string name = header.substr(0, bracketed ? end + 1 : end);
  std::string port = end == std::string::npos ? "" : header.substr(name.size());
  if (!port.empty() && (port.front() != ':' || port.size() > 6 ||
                        port.find_first_not_of("0123456789", 1) != std::string::npos))
    return "";
  return lower(name);
}

bool is_own_host(const AccessRules& rules, const std::string& header) {
  const std::string name = host_name_of(header);
  if (name == "127.0.0.1" || name == "localhost" || name == "[::1]") return true;
  if (rules.listens_on.empty() || name.empty()) return false;
  if (name == lower(rules.listens_on) || name == "[" + lower(rules.listens_on) + "]") return true;
  const bool everywhere = rules.listens_on == "0.0.0.0" || rules.listens_on == "::";
  return everywhere && (is_address(name) || name == this_machine());
}

std::optional<Reply> refused_to_read(const AccessRules& rules, const Caller& caller) {
  if (caller.hosts.size() != 1 || !is_own_host(rules, caller.hosts.front()))
    return refusal(421, "this server answers to its own address alone");
  if (caller.fetch_site == "cross-site" || caller.fetch_site == "same-site")
    return refusal(403, "another page asks");
  return std::nullopt;
}

std::optional<Reply> refused_to_change(const AccessRules& rules, const Caller& caller) {
  if (auto refused = refused_to_read(rules, caller)) return refused;
  if (caller.origin != "http://" + caller.hosts.front())
    return refusal(403, "actions are for this page alone");
  if (lower(caller.content_type) != "application/json")
    return refusal(415, "an action is application/json");
  if (rules.token.empty())
    return refusal(403, "this server was started with --read-only: it shows, and changes nothing");
  if (!same_token(rules.token, caller.token))
    return refusal(403,
                   "the token is missing or wrong: open the address that `eerie serve` printed");
  return std::nullopt;
}

}  // namespace eerie::serve
