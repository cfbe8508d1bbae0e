#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "campaign/auto_fidelity/certainty.hpp"
#include "campaign/sweeps/sweep.hpp"
#include "db/store/connection.hpp"

namespace eerie::auto_fidelity {

/// How sure an automatic choice of fidelity must be, and what it may cost.
struct AutoOptions {
  double confidence = 0.9;
  std::int64_t most_seeds = 8;
};

/// One impact of a sweep with all that was run of it.
struct AutoCell {
  Scene sketch_scene, survey_scene;
  std::vector<Sample> sketch, survey;
  Answer verdict;  ///< of the finest that has runs; nothing is known before the first
  /// What the verdict rests on: surveys, or sketches that are sure and that no survey gainsays.
  std::string fidelity;                      ///< empty before the first run
  std::vector<std::size_t> neighbours = {};  ///< cells one step of speed or angle away
  ClassShares around = {};                   ///< the classes of their runs
  std::size_t seeds() const { return fidelity == "survey" ? survey.size() : sketch.size(); }
};

/// A run that an automatic choice asks for.
struct Wanted {
  Scene scene;
  bool survey = false;
};

/// Coarse first, finer only where in doubt: every impact is sketched with two seeds; where they
/// agree and only their number is lacking, with up to two more; what they leave in doubt is
/// surveyed with two seeds, then one at a time, until the ensemble is as sure as asked, has
/// most_seeds runs, or would not become sure with these: that it may be either is the answer then.
class AutoFidelity {
 public:
  /// The same sweep with the settings of either fidelity. Throws InputError as expand() does, and
  /// where seeds are an axis.
  AutoFidelity(const sweeps::Sweep& sketch, const sweeps::Sweep& survey, AutoOptions options);

  /// Reads what the database has of the impacts.
  void update(const db::Connection& connection);

  /// Runs that are wanted next, given what is known; none when no answer is in doubt any more
  /// or the seeds are used up. Failed runs are not asked for again.
  std::vector<Wanted> next() const;

  const std::vector<AutoCell>& cells() const { return cells_; }
  bool in_doubt(const AutoCell& cell) const {
    return cell.fidelity.empty() || cell.verdict.in_doubt(options_.confidence);
  }
  /// Whether no further surveys up to most_seeds could make it sure of a class, or are likely to
  /// make it sure of b/a < 0.3 or not: that it may be either is the answer.
  bool is_mixed(const AutoCell& cell) const;
  /// Core-seconds of all runs that the verdicts made use of, by fidelity, as far as they are known.
  std::map<std::string, double> core_seconds() const;
  /// The same for most_seeds surveys of every impact, from the mean of those that ran; 0 without
  /// any.
  double uniform_core_seconds() const;
  /// How surveys stand to sketches of a class, from the impacts that have both.
  Transfer transfer(const std::string& sketched_class) const;
  std::vector<std::string> classes() const;  ///< that transfer() has learnt something of

 private:
  void find_neighbours(const std::vector<sweeps::Axis>& axes);
  void look_around();
  void judge_all();

  AutoOptions options_;
  std::vector<AutoCell> cells_;
  std::map<std::string, Transfer> transfers_;
  double survey_deviation_ = 0;  ///< typical, of b/a
};

/// One line per impact: what is known of it, how sure, and on what it rests.
std::string auto_csv(const AutoFidelity& campaign);

}  // namespace eerie::auto_fidelity
