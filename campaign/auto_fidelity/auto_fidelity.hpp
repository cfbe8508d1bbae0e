#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "campaign/auto_fidelity/certainty.hpp"
#include "campaign/sweeps/sweep.hpp"
#include "db/store/connection.hpp"

namespace eerie::auto_fidelity {

/// The confidence that an automatic choice of fidelity must reach, and its most seeds per impact.
struct AutoOptions {
  double confidence = 0.9;
  std::int64_t most_seeds = 8;
};

/// One impact of a sweep with all its runs.
struct AutoCell {
  Scene sketch_scene, survey_scene;
  std::vector<Sample> sketch, survey;
  Answer verdict;  ///< by the finest fidelity with runs; nothing is known before the first run
  /// The fidelity behind the verdict: surveys, or sketches that are sure and that no survey
  /// contradicts.
  std::string fidelity;                      ///< empty before the first run
  std::vector<std::size_t> neighbours = {};  ///< cells one step of speed or angle away
  ClassShares around = {};                   ///< shares of the classes of their runs
  std::size_t seeds() const { return fidelity == "survey" ? survey.size() : sketch.size(); }
};

/// A run that an automatic choice requests.
struct Wanted {
  Scene scene;
  bool survey = false;
};

/// Runs impacts coarsely first, and finely only where they are in doubt. Every impact is sketched
/// with two seeds, and with up to two more where these agree and only their number is too small.
/// Impacts that stay in doubt are surveyed with two seeds, and then with one at a time. This ends
/// when the ensemble is as sure as asked, has most_seeds runs, or would not become sure with
/// most_seeds; the answer then is that both are possible.
class AutoFidelity {
 public:
  /// Takes the same sweep with the settings of each fidelity. Throws InputError as expand() does,
  /// and where seeds are an axis.
  AutoFidelity(const sweeps::Sweep& sketch, const sweeps::Sweep& survey, AutoOptions options);

  /// Reads the results of these impacts from the database.
  void update(const db::Connection& connection);

  /// The next runs, given the known results. There are none when no impact is in doubt any more or
  /// all seeds are used. Failed runs are not requested again.
  std::vector<Wanted> next() const;

  const std::vector<AutoCell>& cells() const { return cells_; }
  bool in_doubt(const AutoCell& cell) const {
    return cell.fidelity.empty() || cell.verdict.in_doubt(options_.confidence);
  }
  /// Whether further surveys, up to most_seeds, can no longer make the impact sure of a class, or
  /// are unlikely to make it sure of b/a < 0.3 or not. The answer then is that both are possible.
  bool is_mixed(const AutoCell& cell) const;
  /// The known core-seconds of all runs behind the verdicts, by fidelity.
  std::map<std::string, double> core_seconds() const;
  /// The core-seconds of most_seeds surveys of every impact, by the mean of the known surveys; 0
  /// without any.
  double uniform_core_seconds() const;
  /// The relation of surveys to sketches of a class, from the impacts that have both.
  Transfer transfer(const std::string& sketched_class) const;
  std::vector<std::string> classes() const;  ///< the classes for which transfer() has data

 private:
  void find_neighbours(const std::vector<sweeps::Axis>& axes);
  void look_around();
  void judge_all();

  AutoOptions options_;
  std::vector<AutoCell> cells_;
  std::map<std::string, Transfer> transfers_;
  double survey_deviation_ = 0;  ///< typical deviation of b/a
};

/// A CSV table with one line per impact: its results, their confidence, and the runs behind them.
std::string auto_csv(const AutoFidelity& campaign);

}  // namespace eerie::auto_fidelity
