#pragma once

#include <optional>
#include <string>
#include <vector>

#include "campaign/serve/reply.hpp"

namespace eerie::serve {

/// Who may ask what of a dashboard.
struct AccessRules {
  std::string token;       ///< that an action must show; empty: there are no actions
  std::string listens_on;  ///< beside the loopback addresses; empty: on nothing else
};

/// What a request says of where it comes from.
struct Caller {
  std::vector<std::string> hosts;  ///< every Host header: one is right
  std::string origin, fetch_site, content_type, token;
};

/// 128 random bits as hexadecimal digits. Throws EnvironmentError.
std::string new_token();

/// "LOCALHOST:8080" -> "localhost", "[::1]:80" -> "[::1]"; empty where it is no host.
std::string host_name_of(const std::string& host_header);

/// Whether a Host header names this server by an address or name that no foreign page can have: a
/// page whose name was made to point here (DNS rebinding) sends its own name. Any port is right,
/// since SSH may forward another one.
bool is_own_host(const AccessRules& rules, const std::string& host_header);

/// The refusal of a request that reads; nothing where it may.
std::optional<Reply> refused_to_read(const AccessRules& rules, const Caller& caller);

/// The refusal of an action; nothing where it may be carried out: from this very page, as JSON,
/// with the token.
std::optional<Reply> refused_to_change(const AccessRules& rules, const Caller& caller);

}  // namespace eerie::serve
