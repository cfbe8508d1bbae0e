#pragma once

#include <string>
#include <string_view>

namespace eerie::text {

/// Whether `word`, in small letters and without what joins its parts, is another name of `name`: of
/// a command, an option, a field or a column. People say velocity, and the program v_imp_cm_per_s.
bool is_synonym(std::string_view word, std::string_view name);

}  // namespace eerie::text
