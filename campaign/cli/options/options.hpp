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
#include "campaign/sweeps/scene_changes.hpp"
#include "db/views/map_points.hpp"

namespace eerie::cli {

/// Runs a command whose options are read. What the command says while it works goes to the output
/// at once.
using Action = std::function<Answer(Output&)>;

inline constexpr int most_threads = 4096;

/// Makes every numeric option refuse NaN, infinity and trailing text, and round to
/// sweeps::significant_digits. Whole numbers are decimal digits. Call it after all commands have
/// their options.
void require_plain_numbers(CLI::App& app);

// These options are shared by several commands.

void add_database(CLI::App& app, std::filesystem::path& database);
/// JOB, --db and --remnant: which remnant of which snapshot.
void add_remnant_of_snapshot(CLI::App& app, std::string& job, std::filesystem::path& database,
                             int& rank);
using sweeps::SceneChanges;
void add_changes(CLI::App& app, SceneChanges& changes);
void add_share(CLI::App& app, int& workers, int& threads_per_job);
/// Adds --json and --quiet.
void add_formats(CLI::App& app);
/// The format that these options choose, or those of a command within this one.
Format format_of(const CLI::App& app);

/// Adds the conditions on the point of a job, for any arguments that have them.
template <class Arguments>
void add_point(CLI::App& app, Arguments& a) {
  app.add_option("--q", a.q, "mass ratio");
  app.add_option("--phi-d", a.phi_d_deg, "friction angle, deg");
  app.add_option("--v", a.v, "impact speed LO:HI or one value, cm/s");
  app.add_option("--theta", a.theta, "impact angle LO:HI or one value, deg");
}

/// Adds --fidelity and --settings.
void add_settings_filter(CLI::App& app, db::MapFilter& filter);
/// Adds --q, --phi-d, --particles, --fidelity and --settings.
void add_map_filter(CLI::App& app, db::MapFilter& filter);

void add_selection(CLI::App& app, queries::JobChoice& choice);

/// Adds the conditions of `query`, which other commands share that choose among impacts.
void add_filters(CLI::App& app, queries::Filter& filter);

}  // namespace eerie::cli
