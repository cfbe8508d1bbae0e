#pragma once

#include <map>
#include <string>
#include <vector>

#include "solver/run/run.hpp"
#include "tests/io/snapshot_fixture.hpp"
#include "tests/support/scenes.hpp"

namespace eerie::test {

/// An impact that is over quickly: bodies start close, fast, and the run ends in the middle of
/// the collision, some hundred steps later.
inline Scene short_impact(const nlohmann::json& changes = nlohmann::json::object()) {
  nlohmann::json scene = {{"impact", {{"separation", 1.3}, {"v_imp_cm_per_s", 40}}},
                          {"numerics", {{"cfl", 0.4}}},
                          {"end", {{"time_s", 400}}},
                          {"output", {{"history_interval_s", 50}}}};
  scene.merge_patch(changes);
  return small_scene(scene);
}

/// run_impact in `folder`, with everything that it said and the times of its history.
struct Told {
  run::RunSummary summary;
  std::vector<std::string> notes;
  std::vector<double> history;
};
inline Told run_in(const TemporaryFolder& folder, const Scene& scene,
                   run::RunOptions options = {}) {
  Told told;
  options.directory = folder.path();
  options.on_note = [&](const std::string& text) { told.notes.push_back(text); };
  options.on_history = [&](const io::Snapshot& s, const step::Totals&) {
    told.history.push_back(s.state.time);
  };
  told.summary = run::run_impact(scene, options);
  return told;
}

}  // namespace eerie::test
