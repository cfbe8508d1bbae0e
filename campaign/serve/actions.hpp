#pragma once

#include <filesystem>
#include <string>

#include "campaign/serve/reply.hpp"

namespace eerie::serve {

/// Carries out an action as the commands do: it puts a request into the inbox of the database, and
/// never writes to the database itself. `body` is {"kind", "selection"} as in
/// campaign/manager/request.hpp, with "priority" or "sweep" (a sweep as JSON text) where the kind
/// takes them. The reply is the answer, or 202 where it is still to come because the manager is
/// busy or nobody works on the database. Throws InputError for a request that no manager would
/// take, and db::Error where the database cannot be read.
Reply act(const std::filesystem::path& database, const std::string& body);

}  // namespace eerie::serve
