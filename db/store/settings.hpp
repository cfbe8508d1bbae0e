#pragma once

#include <optional>
#include <string>

#include "db/store/connection.hpp"

namespace eerie::db {

// The settings that a database stores about itself.

std::optional<std::string> setting(const Connection& connection, const std::string& key);
void set(Connection& connection, const std::string& key, const std::string& value);

}  // namespace eerie::db
