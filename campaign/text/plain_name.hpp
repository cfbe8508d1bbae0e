#pragma once

#include <string>

namespace eerie::text {

/// Names of sweeps, studies and cases become parts of file names. Throws InputError: `where` is
/// the field, `example` a name that will do.
void require_plain_name(const std::string& name, const std::string& where, const char* example);

}  // namespace eerie::text
