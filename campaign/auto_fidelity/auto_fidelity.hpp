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
  std::int64_t most_seeds = 8;  ///< of one impact on the last rung
};

/// A fidelity of the ladder, and the sweep with its settings.
struct Rung {
  std::string name;
  sweeps::Sweep sweep;
};

/// The rungs from "sketch" to `finest`, each the sweep of a file with its settings and
/// `overrides`. Throws InputError for a name that is no rung.
std::vector<Rung> ladder(const nlohmann::json& sweep, const std::vector<std::string>& overrides,
                         const std::string& where, const std::string& finest = "fine");

/// One impact of a sweep with all that was run of it, rung by rung.
struct AutoCell {
  std::vector<Scene> scenes;
  std::vector<std::vector<Sample>> runs;
  Answer verdict;  ///< nothing is known before the first run
  /// The rung that the verdict rests on: the finest that has runs, or a coarser one that is sure
  /// and that no finer one gainsays. -1 before the first run.
  int rung = -1;
  std::vector<std::size_t> neighbours = {};  ///< cells one step of speed or angle away
  ClassShares around = {};                   ///< the classes of their runs

  bool is_known() const { return rung >= 0; }
  std::size_t seeds() const { return runs[static_cast<std::size_t>(rung)].size(); }
  /// The finest rung that has runs; -1 where none has.
  int finest() const;
};

/// A run that an automatic choice asks for.
struct Wanted {
  Scene scene;
  std::size_t rung = 0;
};

/// Coarse first, finer only where in doubt: every impact begins with two seeds on the lowest rung.
/// What is in doubt gets more seeds while they could make it sure, up to four, and else goes one
/// rung up. On the last one it gets seeds until it is as sure as asked, has most_seeds runs, or
/// would not become sure with these: that it may be either is the answer then.
class AutoFidelity {
 public:
  /// Throws InputError as expand() does, and where seeds are an axis. `rungs` must not be empty.
  AutoFidelity(std::vector<Rung> rungs, AutoOptions options);

  /// Reads what the database has of the impacts.
  void update(const db::Connection& connection);

  /// Runs that are wanted next, given what is known; none when no answer is in doubt any more
  /// or the seeds are used up. Failed runs are not asked for again.
  std::vector<Wanted> next() const;

  const std::vector<AutoCell>& cells() const { return cells_; }
  const std::vector<Rung>& rungs() const { return rungs_; }
  /// The name of the rung that a cell's verdict rests on; empty before the first run.
  std::string fidelity(const AutoCell& cell) const {
    return cell.is_known() ? rungs_[static_cast<std::size_t>(cell.rung)].name : "";
  }
  bool in_doubt(const AutoCell& cell) const {
    return !cell.is_known() || cell.verdict.in_doubt(options_.confidence);
  }
  /// Whether no further seeds on its finest rung could make it sure of a class, or are likely to
  /// make it sure of b/a < 0.3 or not. On the last rung that it may be either is the answer.
  bool is_mixed(const AutoCell& cell) const;
  /// Core-seconds of all runs that the verdicts made use of, rung by rung, as far as they are
  /// known.
  std::vector<double> core_seconds() const;
  /// The same for most_seeds runs of every impact on the finest rung that has any, from the mean
  /// of those; 0 without any.
  double uniform_core_seconds() const;
  /// How the next rung stands to `rung` for impacts of a class there, from those that have both.
  Transfer transfer(std::size_t rung, const std::string& its_class) const;
  std::vector<std::string> classes(std::size_t rung) const;  ///< that transfer() has learnt of

 private:
  void find_neighbours(const std::vector<sweeps::Axis>& axes);
  void look_around();
  void learn_transfers();
  void judge(AutoCell& cell) const;
  Transfer transfer_to_top(std::size_t rung, const std::string& its_class) const;
  std::int64_t most_seeds(std::size_t rung) const;
  ClassShares known_besides(const AutoCell& cell, std::size_t rung) const;

  std::vector<Rung> rungs_;
  AutoOptions options_;
  std::vector<AutoCell> cells_;
  std::vector<std::map<std::string, Transfer>> transfers_;  ///< rung by rung, to the next
  std::vector<double> deviations_;                          ///< typical, of b/a, rung by rung
};

/// One line per impact: what is known of it, how sure, and on what it rests.
std::string auto_csv(const AutoFidelity& campaign);

}  // namespace eerie::auto_fidelity
