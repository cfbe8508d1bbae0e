#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "campaign/sweeps/job.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::studies {

/// A convergence study, as read from its file (convergence_study.schema.json). It runs some impacts
/// at several particle numbers, each with several seeds, by one or more schemes.
struct ConvergenceStudy {
  struct Published {
    std::optional<double> b_over_a, m_1_over_m_total, period_h;
    std::optional<bool> eer;  ///< whether one of the three largest remnants has b/a < 0.3
  };
  struct Case {
    std::string name, title;
    nlohmann::json scene;  ///< with the fields of the study's scene
    Published published;
  };
  struct Rung {
    std::int64_t particles_per_target, seeds;
    std::vector<std::string> cases;  ///< names; empty: all cases of the study
  };
  std::string name;
  std::vector<std::string> schemes;
  /// Fields that the runs of a scheme have besides, over all others.
  std::map<std::string, nlohmann::json> by_scheme;
  std::vector<Case> cases;
  std::vector<Rung> ladder;
  /// The time of the published measurement, s after the start; nothing: the end of a run.
  std::optional<double> published_at_s;
  nlohmann::json document;  ///< the document as given, for the database
  std::string where;        ///< file name, for messages
};

/// Reads a study. Throws InputError, which names path, value, allowed range and mend.
ConvergenceStudy parse_convergence_study(const nlohmann::json& document, const std::string& where);
ConvergenceStudy load_convergence_study(const std::filesystem::path& path);

/// One run of a study.
struct ConvergenceRun {
  std::string scheme, case_name;
  std::int64_t particles_per_target = 0, seed = 0;
  Scene scene;
};

/// All runs, each once though rungs may share particle numbers, ordered by the cost of a particle
/// number, N^(4/3), times the seed. So an expensive run comes once more seeds of cheap runs have
/// cost as much.
std::vector<ConvergenceRun> runs_of(const ConvergenceStudy& study);

}  // namespace eerie::studies
