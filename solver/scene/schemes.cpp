#include "solver/scene/schemes.hpp"

#include <algorithm>

namespace eerie {
using nlohmann::json;

json with_scheme(json document) {
  const json given = document.value("numerics", json::object());
  const auto scheme = std::ranges::find(schemes, given.value("scheme", std::string("dual")),
                                        [](const Scheme& s) { return std::string(s.token); });
  json numerics = json::parse(scheme->numerics);
  numerics.update(given);
  document["numerics"] = std::move(numerics);
  return document;
}

}  // namespace eerie
