#include "analysis/remnants/remnants.hpp"
#include "campaign/cli/options/command_list.hpp"
#include "campaign/cli/output/files.hpp"
#include "campaign/results/sizes.hpp"

namespace eerie::cli {
namespace {
namespace fs = std::filesystem;

struct SizesArguments {
  fs::path database;
  queries::Filter filter;
  std::vector<fs::path> files;
};

Answer answer_of(const std::vector<figures::SizeDistribution>& all) {
  Answer answer;
  for (const figures::SizeDistribution& d : all) {
    answer.data["distributions"].push_back({{"settings", d.name},
                                            {"particles_per_target", d.particles_per_target},
                                            {"impacts", d.impacts},
                                            {"limit_over_total", d.limit},
                                            {"mass_over_total", d.masses}});
    answer.say(
        "{} ({} particles per target): {} remnants of at least {} particles (m/M = {:.3g}) in {}\n",
        d.name, d.particles_per_target, d.masses.size(), remnants::remnant_min_particles, d.limit,
        count_of(d.impacts, "impact"));
  }
  answer.say("\nremnants per impact\n");
  answer.add(results::table_of_counts(all));
  return answer;
}

Answer sizes(const SizesArguments& a) {
  require_tables_or_figures(a.files);
  const db::Connection connection(a.database, db::Access::read);
  const std::vector<figures::SizeDistribution> all = results::size_distributions(
      connection, queries::filtered(connection, db::View::results, a.filter));
  if (all.empty())
    throw InputError(
        fmt::format("{}: no result matches; {}", a.database.string(), see_status(a.database)));
  write_tables_or_figures(a.files, results::table_of_steps(all),
                          [&](const fs::path& file) { figures::draw_sizes(file, all); });
  Answer answer = answer_of(all);
  answer.add_files(a.files);
  return answer;
}

}  // namespace

Action add_sizes(CLI::App& app) {
  auto a = std::make_shared<SizesArguments>();
  add_database(app, a->database);
  add_filters(app, a->filter);
  app.add_option("-o,--output", a->files,
                 "figure (.svg, .png, .pdf) or every step (.csv); may be repeated")
      ->allow_extra_args(false);
  add_formats(app);
  return [a](Output&) { return sizes(*a); };
}

}  // namespace eerie::cli
