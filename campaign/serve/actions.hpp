#pragma once

#include <filesystem>
#include <string>

#include "campaign/serve/reply.hpp"

namespace eerie::serve {

/// Carries an action out as the commands do: as a request in the inbox of whoever works on the
/// database, which is never written to from here. `body`: {"kind", "selection"} as in
/// campaign/request.hpp, with "priority" or "sweep" (a sweep as JSON text) where the kind takes
/// them. The reply is the answer; 202 where it is still to come, because the manager is busy or
/// nobody works on the database. Throws InputError for what no manager would take.
Reply act(const std::filesystem::path& database, const std::string& body);

}  // namespace eerie::serve
