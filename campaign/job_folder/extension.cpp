#include "campaign/job_folder/extension.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "campaign/job_folder/result_file.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "solver/io/snapshot.hpp"
#include "solver/run/checkpoints.hpp"

namespace eerie::job_folder {
namespace fs = std::filesystem;

namespace {

std::string end_reason(run::EndReason reason) {
  return std::string(run::end_reason_names.at(static_cast<std::size_t>(reason)));
}

/// The state from which the run can go on. Throws InputError with the reason where there is none.
io::Snapshot state_before_end(const JobDirectory& finished, const Scene& scene,
                              const db::Result& result) {
  std::string obstacle;
  auto state = run::usable_checkpoint(finished.path / run::before_end_file, scene,
                                      [&](const std::string& note) { obstacle = note; });
  if (state) return *std::move(state);
  if (!obstacle.empty()) throw InputError(obstacle);
  if (result.end_reason == end_reason(run::EndReason::settled))
    throw InputError(
        fmt::format("it had settled at {:.0f} s, and with a later end it would end there all the "
                    "same; raise end.settled.window_s to look on for longer",
                    result.ended_at_s.value_or(0)));
  throw InputError(
      fmt::format("{} is not there: it was run by a program that did not keep it; run it anew with "
                  "--set end.time_s=...",
                  (finished.path / run::before_end_file).string()));
}

/// The header and the rows of a CSV file up to `time_s`.
std::string rows_until(const fs::path& file, double time_s) {
  std::istringstream lines(read_file(file));
  std::string kept;
  for (std::string line; std::getline(lines, line);)
    if (kept.empty() || std::strtod(line.c_str(), nullptr) <= time_s) kept += line + "\n";
  return kept;
}

void take_snapshots(const JobDirectory& finished, const JobDirectory& longer, const Scene& later,
                    double time_s) {
  const double interval = later.output.snapshot_interval_s;
  for (long number = 0; number == 0 || (interval > 0 && static_cast<double>(number) * interval <=
                                                            time_s * (1 + 1e-12));
       ++number) {
    const fs::path file = run::snapshot_path(finished.path, number);
    if (!fs::exists(file)) continue;  // a flight may pass over none, a user may remove some
    io::Snapshot snapshot = io::read_snapshot(file);
    snapshot.scene = later;
    io::write_snapshot(run::snapshot_path(longer.path, number), snapshot);
  }
}

/// Whether a run of the scene has got somewhere in its directory.
bool has_begun(const JobDirectory& longer) {
  return std::ranges::any_of(
      std::initializer_list<fs::path>{longer.result(), longer.final_snapshot(), longer.checkpoint(),
                                      longer.previous_checkpoint()},
      [](const fs::path& file) { return fs::exists(file); });
}

}  // namespace

Scene extended_scene(const JobDirectory& finished, const Scene& scene, double until_s) {
  const auto stored = read_result(finished, scene_hash(scene));
  if (!stored)
    throw InputError(fmt::format("{} is missing or damaged; `eerie doctor` says what to do",
                                 finished.result().string()));
  const db::Result& result = stored->result;
  state_before_end(finished, scene, result);
  const bool had_settled = result.end_reason == end_reason(run::EndReason::settled);
  const bool had_to_end = result.end_reason == end_reason(run::EndReason::latest_time);
  const double latest_s = std::max(scene.end.time_s, scene.end.latest_s);
  const double end_s = had_settled ? latest_s : result.ended_at_s.value_or(scene.end.time_s);
  if (until_s <= end_s)
    throw InputError(
        fmt::format("--until = {:g}: its end is at {:.6g} s; give a later time", until_s, end_s));
  const bool waits = had_to_end || (had_settled && scene.end.latest_s > scene.end.time_s);
  nlohmann::json document = to_json(scene);
  document["end"][waits ? "latest_s" : "time_s"] = until_s;
  return parse_scene(document, "--until: scene");
}

bool may_be_extended(const JobDirectory& finished) {
  std::error_code ignored;
  return fs::exists(finished.path / run::before_end_file, ignored);
}

double make_extension(const JobDirectory& finished, const JobDirectory& longer,
                      const Scene& later) {
  io::Snapshot state = io::read_snapshot(finished.path / run::before_end_file);
  if (has_begun(longer)) return state.state.time;
  require_usable(longer);
  state.scene = later;
  take_snapshots(finished, longer, later, state.state.time);
  for (const auto& [from, to] : {std::pair(finished.history(), longer.history()),
                                 std::pair(finished.remnants(), longer.remnants())})
    if (fs::exists(from)) install_text(to, rows_until(from, state.state.time));
  // Last of all: where this is killed before, the directory has no run that has begun.
  io::write_snapshot(longer.checkpoint(), state);
  return state.state.time;
}

}  // namespace eerie::job_folder
