#pragma once

#include <string>

namespace eerie::text {

/// Throws InputError for a name of a sweep, study or case that cannot be a part of a file name. The
/// message names the field `where` and the valid name `example`.
void require_plain_name(const std::string& name, const std::string& where, const char* example);

}  // namespace eerie::text
