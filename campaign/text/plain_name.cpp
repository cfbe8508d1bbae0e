#include "campaign/text/plain_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>

#include "solver/base/error.hpp"

namespace eerie::text {
using nlohmann::json;

void require_plain_name(const std::string& name, const std::string& where, const char* example) {
  const bool plain = !name.empty() && name.size() <= 64 && name.front() != '.' &&
                     name.front() != '-' &&
                     std::all_of(name.begin(), name.end(), [](unsigned char c) {
                       return std::isalnum(c) != 0 || c == '-' || c == '_' || c == '.';
                     });
  if (!plain)
    throw InputError(fmt::format(
        "{} = {}: must be 1 to 64 letters, digits, '-', '_' or '.', starting with a "
        "letter or digit; for example \"{}\"",
        where, json(name).dump(-1, ' ', false, json::error_handler_t::replace), example));
}

}  // namespace eerie::text
