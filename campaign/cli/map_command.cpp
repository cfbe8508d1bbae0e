#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "campaign/cli/commands.hpp"
#include "campaign/map.hpp"
#include "solver/base/error.hpp"

namespace eerie::cli {

int map(const MapArguments& a) {
  const db::Connection connection(a.database, db::Access::read);
  draw_named_maps(connection, a.filter, a.files);
  nlohmann::json pictures = nlohmann::json::array();
  for (const auto& file : a.files) {
    pictures.push_back(file.string());
    if (!a.json) fmt::print("{}\n", file.string());
  }
  if (a.json) fmt::print("{}\n", nlohmann::json{{"pictures", pictures}}.dump(1));
  return static_cast<int>(ExitCode::done);
}

}  // namespace eerie::cli
