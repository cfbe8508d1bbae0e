#pragma once

#include <string>
#include <vector>

#include "db/views/query.hpp"

namespace eerie::facts {

/// One sentence per mass ratio and friction angle: how many impacts make an extremely elongated
/// remnant, at which v sin(theta), and where the paper has them.
std::vector<std::string> finding(const std::vector<db::ResultRow>& rows);

}  // namespace eerie::facts
