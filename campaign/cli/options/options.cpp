#include "campaign/cli/options/options.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "campaign/queries/numbers.hpp"
#include "campaign/sweeps/fidelity.hpp"
#include "solver/base/error.hpp"

namespace eerie::cli {
namespace {

/// The parser would take "010" for 8 and "0x10" for 16.
std::string whole_number(const std::string& text, const std::string& name) {
  const std::size_t sign = text.starts_with('-') || text.starts_with('+') ? 1 : 0;
  if (text.size() == sign || text.find_first_not_of("0123456789", sign) != std::string::npos)
    throw InputError(fmt::format("{} = {}: must be a whole number; for example 3", name, text));
  const std::size_t first = std::min(text.find_first_not_of('0', sign), text.size() - 1);
  return (text.starts_with('-') ? "-" : "") + text.substr(first);
}

std::string finite_number(const std::string& text, const std::string& name) {
  if (const std::optional<double> value = queries::finite_number(text))
    return fmt::format("{}", *value);
  throw InputError(fmt::format("{} = {}: must be a finite number; for example 0.5", name, text));
}

/// How the text of an option is read before the parser does; nothing for words.
using Reader = std::string (*)(const std::string& text, const std::string& name);
Reader reader_of(const std::string& type) {
  if (type.starts_with("INT") || type.starts_with("UINT")) return whole_number;
  return type.starts_with("FLOAT") ? finite_number : nullptr;
}

}  // namespace

void require_plain_numbers(CLI::App& app) {
  for (CLI::App* command : app.get_subcommands({})) require_plain_numbers(*command);
  for (CLI::Option* option : app.get_options())
    if (const Reader read = reader_of(option->get_type_name()))
      option->transform(CLI::Validator(
          [read, name = option->get_name()](std::string& text) -> std::string {
            text = read(text, name);
            return "";
          },
          ""));
}

void add_database(CLI::App& app, std::filesystem::path& database) {
  database = "eerie.sqlite";
  app.add_option("--db", database, "database file")->capture_default_str();
}

void add_remnant_of_snapshot(CLI::App& app, std::string& job, std::filesystem::path& database,
                             int& rank) {
  app.add_option("JOB", job,
                 "the first digits of the job's hash, a folder with snapshots (of both the last "
                 "one is taken), or a snapshot (.hdf5)")
      ->required();
  add_database(app, database);
  app.add_option("--remnant", rank, "by its rank in mass")
      ->check(CLI::Range(1, 1'000'000))
      ->capture_default_str();
}

void add_changes(CLI::App& app, SceneChanges& changes) {
  app.add_option("--set", changes.overrides,
                 "override a field of the scene, PATH=VALUE; may be repeated")
      ->allow_extra_args(false);
  app.add_option("--fidelity", changes.fidelity,
                 "settings by name: sketch, survey, standard, fine or paper (run, expand: auto, "
                 "too), before those of "
                 "the file; --set goes before them (default: standard, behind those of the file)");
}

void add_share(CLI::App& app, int& workers, int& threads_per_job) {
  app.add_option("--workers", workers,
                 "jobs at a time (default: measured, as many as work fastest)")
      ->check(CLI::Range(1, most_threads));
  app.add_option("--threads-per-job", threads_per_job,
                 "threads of each job (default: measured, or 1 where --workers is given)")
      ->check(CLI::Range(1, most_threads));
}

void add_formats(CLI::App& app) {
  CLI::Option* json = app.add_flag("--json")->description("print JSON");
  app.add_flag("--quiet")->description("print nothing but complaints")->excludes(json);
}

Format format_of(const CLI::App& app) {
  for (const CLI::App* inner : app.get_subcommands()) return format_of(*inner);
  const auto given = [&](const char* name) {
    const CLI::Option* option = app.get_option_no_throw(name);
    return option != nullptr && option->count() > 0;
  };
  return given("--json") ? Format::json : given("--quiet") ? Format::nothing : Format::people;
}

void add_settings_filter(CLI::App& app, db::MapFilter& filter) {
  std::vector<std::string> names;
  for (const sweeps::Fidelity& fidelity : sweeps::fidelities) names.emplace_back(fidelity.name);
  app.add_option("--fidelity", filter.fidelity, "only impacts of this fidelity")
      ->check(CLI::IsMember(names));
  app.add_option("--settings", filter.settings,
                 "only impacts of these settings, by the database's number for them");
}

void add_map_filter(CLI::App& app, db::MapFilter& filter) {
  app.add_option("--q", filter.q, "mass ratio");
  app.add_option("--phi-d", filter.phi_d_deg, "friction angle, deg");
  app.add_option("--particles", filter.particles_per_target, "particles per target");
  add_settings_filter(app, filter);
}

void add_selection(CLI::App& app, queries::JobChoice& a) {
  app.add_option("JOB", a.jobs, "jobs, by the first digits of their hashes");
  app.add_option("--sweep", a.sweep,
                 "the jobs of the sweep of this name; NAME@2: of the second one");
  add_point(app, a);
  app.add_flag("--all", a.all, "every job of the database");
}

void add_filters(CLI::App& app, queries::Filter& a) {
  add_point(app, a);
  app.add_option("--class", a.outcome_class, "outcome class");
  app.add_option("--fidelity", a.fidelity, "only runs with the settings of this name");
  app.add_option("--sweep", a.sweep,
                 "only jobs of the sweep of this name; NAME@2: of the second one");
  app.add_flag("--eer", a.eer, "only where there is an extremely elongated remnant");
  app.add_option("--where", a.where,
                 "any column: COLUMN=VALUE, =LO:HI, =LO:, =:HI, =WORD,WORD (* for any letters), "
                 "=none; != for the contrary; may be repeated")
      ->allow_extra_args(false);
}

}  // namespace eerie::cli
