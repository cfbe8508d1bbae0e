#include "solver/scene/field_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace eerie {
using nlohmann::json;

std::string dotted(std::string pointer) {
  pointer.erase(0, 1);
  std::ranges::replace(pointer, '/', '.');
  return pointer;
}

std::string field_words(const json& scene, const std::vector<std::string>& fields,
                        std::size_t most) {
  std::string text;
  for (std::size_t k = 0; k < std::min(fields.size(), most); ++k) {
    const json value = scene.value(fields[k], json());
    text += fmt::format("{}{}={}", k == 0 ? "" : ", ", dotted(fields[k]),
                        value.is_null()           ? "off"
                        : value.is_number_float() ? fmt::format("{:g}", value.get<double>())
                        : value.is_string()       ? value.get<std::string>()
                                                  : value.dump());
  }
  if (fields.size() > most) text += fmt::format(" and {} more", fields.size() - most);
  return text;
}

}  // namespace eerie
