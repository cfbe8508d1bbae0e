#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "db/jobs/selection.hpp"
#include "db/views/map_points.hpp"

namespace eerie::cli {

/// What a command does once its options are read; the arguments live as long as it.
using Action = std::function<int()>;

inline constexpr int most_threads = 4096;
inline constexpr int stopped_by_signal = 130;  // 128 + SIGINT, as shells expect

/// Makes every option of the commands that takes a number refuse NaN, infinity and what follows a
/// number, and round to sweeps::significant_digits. Goes after the commands have their options.
void require_finite_numbers(CLI::App& app);

// Options that several commands share.

void add_database(CLI::App& app, std::filesystem::path& database);
/// --set and --fidelity.
struct SceneChanges {
  std::vector<std::string> overrides;
  std::string fidelity;  ///< empty: what the file says
  /// The overrides, after those of the fidelity. Throws InputError for a fidelity that is none.
  std::vector<std::string> all() const;
};
void add_changes(CLI::App& app, SceneChanges& changes);
void add_share(CLI::App& app, int& workers, int& threads_per_job);
void add_json(CLI::App& app, bool& json);

/// Conditions on a job's point, of any arguments that have them.
template <class Arguments>
void add_point(CLI::App& app, Arguments& a) {
  app.add_option("--q", a.q, "mass ratio");
  app.add_option("--phi-d", a.phi_d_deg, "friction angle, deg");
  app.add_option("--v", a.v, "impact speed LO:HI or one value, cm/s");
  app.add_option("--theta", a.theta, "impact angle LO:HI or one value, deg");
}

/// --fidelity and --settings.
void add_settings_filter(CLI::App& app, db::MapFilter& filter);
/// --q, --phi-d, --particles and these.
void add_map_filter(CLI::App& app, db::MapFilter& filter);

/// Jobs as words, --sweep and the conditions of `query`.
struct SelectionArguments {
  std::vector<std::string> jobs;
  std::optional<std::string> sweep;
  std::optional<double> q, phi_d_deg;
  std::string v, theta;  ///< "LO:HI" or one number; empty: all
  bool all = false;
};
void add_selection(CLI::App& app, SelectionArguments& arguments);
/// Throws InputError for a word that is no job, and where nothing is selected without --all.
db::Selection selection_of(const SelectionArguments& arguments, const std::string& command);

/// "90s", "45min", "2h", "1.5d" in seconds. Throws InputError naming `option`, without a unit too.
double parse_duration(const std::string& text, const std::string& option);

/// "18:22" -> {18, 22}; "20" -> {20, 20}. Throws InputError naming `option`.
db::Range parse_range(const std::string& text, const std::string& option);

}  // namespace eerie::cli
