#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "campaign/cli/output/output.hpp"
#include "campaign/queries/filter.hpp"
#include "campaign/queries/find_job.hpp"
#include "db/views/map_points.hpp"

namespace eerie::cli {

/// What a command does once its options are read. What it says while it is at work goes to the
/// output at once.
using Action = std::function<Answer(Output&)>;

inline constexpr int most_threads = 4096;

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
/// --json and --quiet.
void add_formats(CLI::App& app);
/// What these say, or those of the command within a command.
Format format_of(const CLI::App& app);

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

void add_selection(CLI::App& app, queries::JobChoice& choice);

/// Conditions of `query` and of what else chooses among impacts.
void add_filters(CLI::App& app, queries::Filter& filter);

}  // namespace eerie::cli
