#pragma once

#include <nlohmann/json_fwd.hpp>

#include "campaign/manager/request.hpp"
#include "db/store/connection.hpp"

namespace eerie::manager {

/// Lets the finished jobs of a request go on to its later end, each as a job of its own with the
/// scene that has this end; the jobs join the sweeps of those they go on with. Their directories
/// are made first: where this process is killed, the repeated request finds them. Returns
/// {"jobs", "extended": [{"job", "as", "from_s"}], "refused": [{"job", "reason"}]}. Throws
/// InputError with the first reason where no job can go on.
nlohmann::json extend(db::Connection& connection, const Request& request);

}  // namespace eerie::manager
