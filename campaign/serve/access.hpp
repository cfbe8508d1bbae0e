#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "campaign/serve/reply.hpp"

namespace eerie::serve {

/// The rules of access to a dashboard.
struct AccessRules {
  std::string token;       ///< required for actions; empty where there are no actions
  std::string listens_on;  ///< an address in addition to loopback; empty: none
};

/// Name and value of the headers that every answer carries, whatever was asked: they tell browsers
/// to run no script but the page's own and to show it to no other page.
std::vector<std::pair<std::string, std::string>> guard_headers();

/// The origin of a request, as its headers say.
struct Caller {
  std::vector<std::string> hosts;  ///< all Host headers; exactly one is correct
  std::string origin, fetch_site, content_type, token;
};

/// Makes a token: 128 random bits as hexadecimal digits. Throws EnvironmentError.
std::string new_token();

/// The host of a Host header: "localhost" for "LOCALHOST:8080", "[::1]" for "[::1]:80". Empty where
/// it is no host.
std::string host_name_of(const std::string& host_header);

/// Whether a Host header names this server by an address or name that no foreign page can have. A
/// page whose name was made to point here (DNS rebinding) sends its own name. Any port is correct,
/// since SSH may forward another one.
bool is_own_host(const AccessRules& rules, const std::string& host_header);

/// The refusal of a request to read; nothing where it is allowed.
std::optional<Reply> refused_to_read(const AccessRules& rules, const Caller& caller);

/// The refusal of an action; nothing where it is allowed. An action must come from this page, as
/// JSON, with the token.
std::optional<Reply> refused_to_change(const AccessRules& rules, const Caller& caller);

}  // namespace eerie::serve
