#include "campaign/cli/options/command_list.hpp"
#include "campaign/cli/output/files.hpp"
#include "campaign/surroundings/collision_odds.hpp"

namespace eerie::cli {
namespace {
namespace fs = std::filesystem;

struct OddsArguments {
  fs::path database;
  db::MapFilter filter;
  std::vector<double> dispersions_cm_per_s = surroundings::usual_dispersions_cm_per_s();
  std::vector<fs::path> files;
};

Answer odds(const OddsArguments& a) {
  require_tables_or_figures(a.files);
  const db::Connection connection(a.database, db::Access::read);
  const std::vector<surroundings::CollisionOdds> found =
      surroundings::collision_odds(db::map_points(connection, a.filter), a.dispersions_cm_per_s);
  if (found.empty())
    throw InputError(
        fmt::format("{}: no result matches; {}", a.database.string(), see_status(a.database)));
  Answer answer;
  Table table = surroundings::table_of_odds(found);
  write_tables_or_figures(a.files, table,
                          [&](const fs::path& file) { surroundings::draw_odds(file, found); });
  answer.data = records(table);
  answer.add(std::move(table));
  answer.say(
      "\nImpact angles are isotropic, relative velocities Maxwellian and focused by gravity. "
      "Collisions outside the map count as without EER.\n");
  answer.add_files(a.files);
  return answer;
}

}  // namespace

Action add_odds(CLI::App& app) {
  auto a = std::make_shared<OddsArguments>();
  add_database(app, a->database);
  add_map_filter(app, a->filter);
  app.add_option("--dispersion", a->dispersions_cm_per_s,
                 "of one component of the relative velocity far away, cm/s; may be repeated "
                 "(default: 1 to 100)")
      ->allow_extra_args(false)
      ->check(CLI::Range(0.1, 1e5));
  app.add_option("-o,--output", a->files,
                 "figure (.svg, .png, .pdf) or table (.csv); may be repeated")
      ->allow_extra_args(false);
  add_formats(app);
  return [a](Output&) { return odds(*a); };
}

}  // namespace eerie::cli
