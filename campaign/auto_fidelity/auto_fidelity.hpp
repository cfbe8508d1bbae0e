#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "campaign/auto_fidelity/certainty.hpp"
#include "campaign/sweeps/fidelity.hpp"
#include "campaign/sweeps/sweep.hpp"
#include "db/store/connection.hpp"

namespace eerie::auto_fidelity {

/// The confidence that an automatic choice of fidelity must reach, and its most seeds per impact.
struct AutoOptions {
  double confidence = 0.9;
  std::int64_t most_seeds = sweeps::most_last_auto_seeds;  ///< of one impact on the last rung
};

/// A fidelity of the ladder, with the sweep that has its settings and its scenes.
struct Rung {
  std::string name;
  sweeps::Sweep sweep;
  std::vector<Scene> scenes;
};

/// The rungs from "sketch", or the first whose impactors have particles enough, to `finest`. Each
/// holds the sweep of a file with the settings of the rung and `overrides`. Throws InputError where
/// no rung is called `finest`.
std::vector<Rung> ladder(const nlohmann::json& sweep, const std::vector<std::string>& overrides,
                         const std::string& where, const std::string& finest = "fine");

/// One impact of a sweep with all its runs, rung by rung.
struct AutoCell {
  std::vector<Scene> scenes;
  std::vector<std::vector<Sample>> runs;
  Answer verdict;  ///< nothing is known before the first run
  /// The rung behind the verdict: the finest with runs, or a coarser one that is sure and that no
  /// finer one contradicts. -1 before the first run.
  int rung = -1;
  std::vector<std::size_t> neighbours = {};  ///< cells one step of speed or angle away
  ClassShares around = {};                   ///< shares of the classes of their runs

  bool is_known() const { return rung >= 0; }
  std::size_t seeds() const { return runs[static_cast<std::size_t>(rung)].size(); }
  /// The finest rung that has runs; -1 where none has.
  int finest() const;
};

/// A run that an automatic choice requests.
struct Wanted {
  Scene scene;
  std::size_t rung = 0;
};

/// Runs impacts coarsely first, and finely only where they are in doubt. Every impact begins with
/// two seeds on the lowest rung. An impact in doubt gets up to four seeds while they could make it
/// sure; otherwise it climbs one rung. On the last rung it gets seeds until the ensemble is as sure
/// as asked, has most_seeds runs, or would not become sure with most_seeds. The answer then is that
/// both are possible.
class AutoFidelity {
 public:
  /// Throws InputError as expand() does, and where seeds are an axis. `rungs` must not be empty.
  AutoFidelity(std::vector<Rung> rungs, AutoOptions options);

  /// Reads the results of these impacts from the database.
  void update(const db::Connection& connection);

  /// The next runs, given the known results. There are none when no impact is in doubt any more or
  /// all seeds are used. Failed runs are not requested again.
  std::vector<Wanted> next() const;

  const std::vector<AutoCell>& cells() const { return cells_; }
  const std::vector<Rung>& rungs() const { return rungs_; }
  /// The name of the rung behind the verdict of a cell; empty before the first run.
  std::string fidelity(const AutoCell& cell) const {
    return cell.is_known() ? rungs_[static_cast<std::size_t>(cell.rung)].name : "";
  }
  bool in_doubt(const AutoCell& cell) const {
    return !cell.is_known() || cell.verdict.in_doubt(options_.confidence);
  }
  /// Whether further seeds on its finest rung can no longer make the impact sure of a class, or are
  /// unlikely to make it sure of b/a < 0.3 or not.
  bool is_mixed(const AutoCell& cell) const;
  /// The known core-seconds of all runs, rung by rung.
  std::vector<double> core_seconds() const;
  /// The core-seconds of most_seeds runs of every impact on the finest rung with runs, by their
  /// mean; 0 without any.
  double uniform_core_seconds() const;
  /// The relation of the next rung to `rung` for a class, from the impacts that have both.
  Transfer transfer(std::size_t rung, const std::string& its_class) const;
  /// The classes for which transfer() has data.
  std::vector<std::string> classes(std::size_t rung) const;

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
  std::vector<std::map<std::string, Transfer>> transfers_;  ///< from each rung to the next
  std::vector<double> deviations_;  ///< typical deviation of b/a on each rung
};

/// A CSV table with one line per impact: its results, their confidence, and the runs behind them.
std::string auto_csv(const AutoFidelity& campaign);

}  // namespace eerie::auto_fidelity
