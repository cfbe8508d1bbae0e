#include <fmt/ranges.h>

#include <algorithm>

#include "campaign/catalogue/catalogue_export.hpp"
#include "campaign/catalogue/catalogue_sweep.hpp"
#include "campaign/catalogue/comparison.hpp"
#include "campaign/cli/options/command_list.hpp"
#include "campaign/cli/output/files.hpp"
#include "campaign/sweeps/job.hpp"
#include "campaign/text/given_file.hpp"
#include "solver/base/text/shell_word.hpp"

namespace eerie::cli {
namespace {
namespace fs = std::filesystem;
using catalogue::Comparison;

/// Of all three commands; each uses its own.
struct CatalogueArguments {
  fs::path database, catalogue, output;
  queries::Filter filter;
  catalogue::CatalogueOptions options;
  SceneChanges changes;
};

catalogue::Catalogue load(const CatalogueArguments& a) {
  constexpr std::size_t most_bytes = 256 << 20;
  catalogue::Catalogue catalogue = catalogue::parse_catalogue(
      text::read_given(a.catalogue, most_bytes), text::given_name(a.catalogue), a.options);
  if (!catalogue.ignored.empty())
    complain(fmt::format("not used: {}", fmt::join(catalogue.ignored, ", ")));
  return catalogue;
}

Answer export_catalogue(const CatalogueArguments& a, Output& out) {
  const db::Connection connection(a.database, db::Access::read);
  const std::string text = catalogue::catalogue_csv(
      connection, queries::filtered(connection, db::View::results, a.filter));
  const auto impacts = std::ranges::count(text, '\n') - 1;
  Answer answer;
  if (a.output.empty()) {
    out.write(text);
  } else {
    install(a.output, text);
    answer.say("{}: {} impacts\n", a.output, impacts);
  }
  if (impacts == 0)
    answer.complain("no result in {} matches; {}", a.database, see_status(a.database));
  return answer;
}

Answer import_catalogue(const CatalogueArguments& a) {
  const std::string name = text::given_name(a.catalogue);
  const bool is_named = text::is_named_file(a.catalogue);
  if (a.output.empty() && !is_named)
    throw InputError(fmt::format("{}: a sweep cannot be named after it; give -o SWEEP.json", name));
  const catalogue::Catalogue catalogue = load(a);
  SceneChanges changes = a.changes;
  if (changes.fidelity.empty()) changes.fidelity = catalogue::common_fidelity(catalogue, name);
  nlohmann::json document = catalogue::sweep_of(catalogue, changes.all(), name);
  const fs::path file = a.output.empty() ? a.catalogue.stem().concat(".json") : a.output;
  document["name"] = catalogue::sweep_name_of(file.stem());
  document["description"] = "impacts of " + (is_named ? a.catalogue.filename().string() : name);
  const sweeps::Sweep sweep = sweeps::parse_sweep(document, {}, file.string());
  const std::vector<Scene> scenes = sweeps::expand(sweep);
  install(file, document.dump(1) + "\n");
  Answer answer;
  answer.data = {{"sweep", file.string()},
                 {"lines", catalogue.rows.size()},
                 {"impacts", scenes.size()},
                 {"ignored", catalogue.ignored}};
  for (const std::string& warning : sweeps::cautions(scenes)) answer.warn(warning);
  answer.say("{}: {} impacts of {} lines; `eerie run {}` runs them\n", file, scenes.size(),
             catalogue.rows.size(), shell_word(file.string()));
  return answer;
}

void add_summary(Answer& answer, const std::vector<Comparison>& all, const CatalogueArguments& a) {
  const catalogue::Agreement whole = catalogue::agreement_of(all);
  answer.say("\n");
  if (whole.masses > 0)
    answer.say("M_lr/M differs by {:.3f} (root mean square of {})\n", whole.m_lr_rms, whole.masses);
  if (whole.shapes > 0)
    answer.say("b/a differs by {:.3f} (root mean square of {})\n", whole.b_over_a_rms,
               whole.shapes);
  if (whole.classes > 0)
    answer.say("the class is the same in {} of {}\n", whole.same_class, whole.classes);
  if (whole.lacking > 0)
    answer.say("{} impacts have no result; `eerie catalogue import {}` makes a sweep\n",
               whole.lacking, shell_word(a.catalogue.string()));
}

Answer compare_catalogue(const CatalogueArguments& a) {
  if (!a.output.empty() && a.output.extension() != ".csv")
    throw InputError(fmt::format("-o {}: must be a .csv file", a.output.string()));
  const catalogue::Catalogue catalogue = load(a);
  const db::Connection connection(a.database, db::Access::read);
  const std::vector<Comparison> all = catalogue::compare(connection, catalogue);
  Answer answer;
  Table table = catalogue::table_of_comparisons(all);
  if (!a.output.empty()) install(a.output, text::csv(table));
  answer.data = records(table);
  answer.add(std::move(table));
  add_summary(answer, all, a);
  if (!a.output.empty()) answer.add_files({a.output});
  return answer;
}

void add_reading(CLI::App& app, CatalogueArguments& a) {
  app.add_option("FILE", a.catalogue, "catalogue of collisions, CSV")->required();
  app.add_option("--density", a.options.density_kg_per_m3,
                 "kg/m^3, where the file does not say it (default: 2700)")
      ->check(CLI::Range(100.0, 20000.0));
  app.add_option("--radius", a.options.radius_m,
                 "radius of every target, m, in place of the file's: v/v_esc, mass ratio and "
                 "angle stay")
      ->check(CLI::Range(1e-3, 1e6));
}

}  // namespace

Action add_catalogue(CLI::App& app) {
  auto a = std::make_shared<CatalogueArguments>();
  app.require_subcommand(1);
  CLI::App* out = app.add_subcommand("export", "Write results as a catalogue of collisions");
  add_database(*out, a->database);
  add_filters(*out, a->filter);
  out->add_option("-o,--output", a->output, "write into this file (.csv)");
  CLI::App* in = app.add_subcommand("import", "Make a sweep file of a catalogue's impacts");
  add_reading(*in, *a);
  add_changes(*in, a->changes);
  in->add_option("-o,--output", a->output, "sweep file (default: named like the catalogue, .json)");
  add_formats(*in);
  CLI::App* beside = app.add_subcommand("compare", "Print a catalogue's outcomes beside ours");
  add_reading(*beside, *a);
  add_database(*beside, a->database);
  beside->add_option("-o,--output", a->output, "write the comparison into this file too (.csv)");
  add_formats(*beside);
  return [a, out, in](Output& output) {
    return out->parsed()  ? export_catalogue(*a, output)
           : in->parsed() ? import_catalogue(*a)
                          : compare_catalogue(*a);
  };
}

}  // namespace eerie::cli
