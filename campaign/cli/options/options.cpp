#include "campaign/cli/options/options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "campaign/sweeps/fidelity.hpp"
#include "campaign/sweeps/scene_field.hpp"
#include "solver/base/error.hpp"

namespace eerie::cli {
namespace {

/// The finite number at the beginning of a text, and how many characters it takes; 0 without one.
std::pair<double, std::size_t> leading_number(const std::string& text) {
  double value = 0;
  const char* begin = text.data() + (text.starts_with('+') && !text.starts_with("+-") ? 1 : 0);
  const auto [end, error] = std::from_chars(begin, text.data() + text.size(), value);
  if (error != std::errc() || !std::isfinite(value)) return {0, 0};
  return {sweeps::rounded(value), static_cast<std::size_t>(end - text.data())};
}

double parse_number(const std::string& text, const std::string& whole, const std::string& option) {
  const auto [value, used] = leading_number(text);
  if (used == 0 || used != text.size())
    throw InputError(
        fmt::format("{} {}: must be LO:HI or one number, all finite; for example {} 18:22", option,
                    whole, option));
  return value;
}

/// A job is named by its hash or the first digits of it.
void require_hash(const std::string& word) {
  constexpr std::size_t fewest = 4, most = 64;
  const bool hexadecimal = std::ranges::all_of(
      word, [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); });
  if (!hexadecimal || word.size() < fewest || word.size() > most)
    throw InputError(
        fmt::format("JOB = {}: must be the first {} or more digits of a job's hash (0-9, a-f), as "
                    "`eerie query` "
                    "and `eerie expand --list` show them; for example 3f9a20c1",
                    word, fewest));
}

/// Makes `text` a number as points of jobs are stored; what is wrong where it is none.
std::string make_finite_number(std::string& text) {
  const auto [value, used] = leading_number(text);
  if (used == 0 || used != text.size())
    return fmt::format("{}: must be a finite number; for example 0.5", text);
  text = fmt::format("{}", value);
  return "";
}

}  // namespace

void require_finite_numbers(CLI::App& app) {
  for (CLI::App* command : app.get_subcommands({})) require_finite_numbers(*command);
  for (CLI::Option* option : app.get_options())
    if (option->get_type_name().starts_with("FLOAT"))
      option->transform(CLI::Validator(make_finite_number, ""));
}

void add_database(CLI::App& app, std::filesystem::path& database) {
  database = "eerie.sqlite";
  app.add_option("--db", database, "database file")->capture_default_str();
}

void add_changes(CLI::App& app, SceneChanges& changes) {
  app.add_option("--set", changes.overrides,
                 "override a field of the scene, PATH=VALUE; may be repeated")
      ->allow_extra_args(false);
  app.add_option(
      "--fidelity", changes.fidelity,
      "settings by name: sketch, survey or paper (run: auto, too); --set goes before them");
}

std::vector<std::string> SceneChanges::all() const {
  std::vector<std::string> list;
  if (!fidelity.empty()) list = sweeps::overrides_of_fidelity(fidelity);
  list.insert(list.end(), overrides.begin(), overrides.end());
  return list;
}

void add_share(CLI::App& app, int& workers, int& threads_per_job) {
  app.add_option("--workers", workers,
                 "jobs at a time (default: measured, as many as work fastest)")
      ->check(CLI::Range(1, most_threads));
  app.add_option("--threads-per-job", threads_per_job,
                 "threads of each job (default: measured, or 1 where --workers is given)")
      ->check(CLI::Range(1, most_threads));
}

void add_json(CLI::App& app, bool& json) { app.add_flag("--json", json, "print JSON"); }

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

void add_selection(CLI::App& app, SelectionArguments& a) {
  app.add_option("JOB", a.jobs, "jobs, by the first digits of their hashes");
  app.add_option("--sweep", a.sweep, "the jobs of the sweep of this name");
  add_point(app, a);
  app.add_flag("--all", a.all, "every job of the database");
}

db::Selection selection_of(const SelectionArguments& a, const std::string& command) {
  for (const std::string& word : a.jobs) require_hash(word);
  db::Selection s{a.sweep, a.jobs, a.q, a.phi_d_deg, {}, {}};
  if (!a.v.empty()) s.v_imp_cm_per_s = parse_range(a.v, "--v");
  if (!a.theta.empty()) s.theta_imp_deg = parse_range(a.theta, "--theta");
  if (s.is_everything() && !a.all)
    throw InputError(fmt::format(
        "`eerie {}` needs to know which jobs: name them, or give --sweep, --q, --phi-d, --v or "
        "--theta; --all means every job",
        command));
  return s;
}

double parse_duration(const std::string& text, const std::string& option) {
  struct Unit {
    const char* name;
    double seconds;
  };
  constexpr Unit units[] = {{"s", 1}, {"min", 60}, {"h", 3600}, {"d", 86400}};
  const auto [value, used] = leading_number(text);
  if (used > 0 && value > 0 && value < 1e9)
    for (const Unit& unit : units)
      if (text.substr(used) == unit.name) return value * unit.seconds;
  throw InputError(
      fmt::format("{} {}: must be a positive time with its unit, s, min, h or d; for example {} 2h",
                  option, text, option));
}

db::Range parse_range(const std::string& text, const std::string& option) {
  const std::size_t colon = text.find(':');
  const double lo = parse_number(text.substr(0, colon), text, option);
  const double hi =
      colon == std::string::npos ? lo : parse_number(text.substr(colon + 1), text, option);
  if (hi < lo)
    throw InputError(fmt::format("{} {}: LO is greater than HI; swap them", option, text));
  return {lo, hi};
}

}  // namespace eerie::cli
