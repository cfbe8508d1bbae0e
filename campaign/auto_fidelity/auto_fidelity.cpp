#include "campaign/auto_fidelity/auto_fidelity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "campaign/results/finished_run.hpp"
#include "campaign/sweeps/fidelity.hpp"
#include "solver/base/error.hpp"

namespace eerie::auto_fidelity {

namespace {

/// An impact is not called mixed by fewer runs on the last rung; below it goes up at once.
constexpr std::size_t fewest_of_mixed = 4;
/// Of b/a, before anything is known: the spread of seeds, and what a rung may be off from the next.
constexpr double prior_deviation = 0.03, prior_scatter = 0.05;

bool agree(const std::vector<Sample>& samples) {
  return std::ranges::all_of(samples,
                             [&](const Sample& s) { return s.outcome == samples.front().outcome; });
}

/// Whether a finer rung says what a coarser one says.
bool bears_out(const Answer& finer, const Answer& coarser) {
  return finer.outcome == coarser.outcome &&
         (finer.p_elongated > 0.5) == (coarser.p_elongated > 0.5);
}

struct AutoRun {
  std::size_t cell = 0, rung = 0;
  Scene scene;
};

Scene with_seed(Scene scene, std::int64_t seed) {
  scene.numerics.seed = seed;
  return scene;
}

std::string point_of(const Scene& s) {
  return fmt::format("{},{},{},{}", s.impact.q, s.material.drucker_prager.phi_d_deg,
                     s.impact.v_imp_cm_per_s, s.impact.theta_imp_deg);
}

/// Its maps and tables name an impact by numbers.
void require_numbers(const sweeps::Sweep& sweep) {
  const auto require = [&](const std::string& path, const nlohmann::json& value) {
    if (!value.is_number())
      throw InputError(fmt::format(
          "{}: {} varies and is no number, which --fidelity auto does not compare; leave it out, "
          "or name one fidelity",
          sweep.where, path));
  };
  for (const sweeps::Axis& axis : sweep.axes) require(axis.path, axis.values.front());
  for (std::size_t k = 0; k < sweep.points.paths.size(); ++k)
    require(sweep.points.paths[k], sweep.points.rows.front()[k]);
}

}  // namespace

std::vector<Rung> ladder(const nlohmann::json& sweep, const std::vector<std::string>& overrides,
                         const std::string& where, const std::string& finest) {
  std::vector<Rung> rungs;
  std::string names;
  for (const sweeps::Fidelity& fidelity : sweeps::fidelities) {
    if (!fidelity.is_rung) continue;
    names += fmt::format("{}{}", names.empty() ? "" : ", ", fidelity.name);
    std::vector<std::string> all = sweeps::overrides_of_fidelity(fidelity.name);
    all.insert(all.end(), overrides.begin(), overrides.end());
    try {
      sweeps::Sweep with_settings = sweeps::parse_sweep(sweep, all, where);
      std::vector<Scene> scenes = sweeps::expand(with_settings);
      rungs.push_back({fidelity.name, std::move(with_settings), std::move(scenes)});
    } catch (const TooFewParticles&) {
      if (fidelity.name == finest) throw;
    }
    if (fidelity.name == finest) return rungs;
  }
  throw InputError(fmt::format("--finest {}: must be one of {}", finest, names));
}

int AutoCell::finest() const {
  for (std::size_t r = runs.size(); r-- > 0;)
    if (!runs[r].empty()) return static_cast<int>(r);
  return -1;
}

AutoFidelity::AutoFidelity(std::vector<Rung> rungs, AutoOptions options)
    : rungs_(std::move(rungs)), options_(options), transfers_(rungs_.size()) {
  if (const auto n = static_cast<double>(options.most_seeds);
      (n + 0.5) / (n + 1) < options.confidence)
    throw InputError(
        fmt::format("--confidence {:g}: {} runs of one class are no surer than {:.3f}; give "
                    "--most-seeds {:.0f} or "
                    "more, or ask for less",
                    options.confidence, options.most_seeds, (n + 0.5) / (n + 1),
                    std::ceil((options.confidence - 0.5) / (1 - options.confidence) - 1e-9)));
  const sweeps::Sweep& lowest = rungs_.front().sweep;
  std::vector<std::string> varied = lowest.points.paths;
  for (const sweeps::Axis& axis : lowest.axes) varied.push_back(axis.path);
  if (std::ranges::find(varied, "numerics.seed") != varied.end())
    throw InputError(fmt::format(
        "{}: grid: numerics.seed is chosen by --fidelity auto and is an axis too; leave it out",
        lowest.where));
  require_numbers(lowest);
  cells_.resize(sweeps::point_count(lowest));
  for (Rung& rung : rungs_) {
    for (std::size_t c = 0; c < cells_.size(); ++c)
      cells_[c].scenes.push_back(std::move(rung.scenes[c])), cells_[c].runs.emplace_back();
    rung.scenes.clear();
  }
  deviations_.assign(rungs_.size(), prior_deviation);
  find_neighbours(lowest.axes);
}

void AutoFidelity::find_neighbours(const std::vector<sweeps::Axis>& axes) {
  std::size_t stride = 1;  // of cells between two values of an axis; the last varies fastest
  for (std::size_t k = axes.size(); k-- > 0; stride *= axes[k].values.size()) {
    const std::size_t values = axes[k].values.size();
    if (axes[k].path != "impact.v_imp_cm_per_s" && axes[k].path != "impact.theta_imp_deg") continue;
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      const std::size_t place = c / stride % values;
      if (place > 0) cells_[c].neighbours.push_back(c - stride);
      if (place + 1 < values) cells_[c].neighbours.push_back(c + stride);
    }
  }
}

void AutoFidelity::look_around() {
  for (AutoCell& cell : cells_) {
    cell.around.clear();
    double known = 0;
    for (const std::size_t k : cell.neighbours) {
      const int rung = cells_[k].finest();
      if (rung < 0) continue;
      ++known;
      for (const auto& [name, share] : class_shares(cells_[k].runs[static_cast<std::size_t>(rung)]))
        cell.around[name] += share;
    }
    for (auto& [name, share] : cell.around) share /= known;
  }
}

Transfer AutoFidelity::transfer(std::size_t rung, const std::string& its_class) const {
  const auto known = transfers_[rung].find(its_class);
  return known == transfers_[rung].end() ? Transfer{0, prior_scatter} : known->second;
}

/// What a rung errs against the last one: the steps between them add up.
Transfer AutoFidelity::transfer_to_top(std::size_t rung, const std::string& its_class) const {
  Transfer sum;
  for (std::size_t r = rung; r + 1 < rungs_.size(); ++r) {
    const Transfer step = transfer(r, its_class);
    sum.shift += step.shift;
    sum.scatter = std::hypot(sum.scatter, step.scatter);
  }
  return sum;
}

std::vector<std::string> AutoFidelity::classes(std::size_t rung) const {
  std::vector<std::string> names;
  for (const auto& [name, transfer] : transfers_[rung]) names.push_back(name);
  return names;
}

std::int64_t AutoFidelity::most_seeds(std::size_t rung) const {
  return rung + 1 == rungs_.size() ? options_.most_seeds : sweeps::most_auto_seeds;
}

void AutoFidelity::update(const db::Connection& connection) {
  std::vector<AutoRun> runs;
  for (std::size_t c = 0; c < cells_.size(); ++c)
    for (std::size_t r = 0; r < rungs_.size(); ++r) {
      cells_[c].runs[r].clear();
      for (std::int64_t seed = 1; seed <= most_seeds(r); ++seed)
        runs.push_back({c, r, with_seed(cells_[c].scenes[r], seed)});
    }
  for (const results::RunWithResult<AutoRun>& r : results::finished_runs(runs, &connection))
    cells_[r.run.cell].runs[r.run.rung].push_back(
        {r.row.result.outcome_class, r.row.result.b_over_a, r.core_seconds});
  learn_transfers();
  look_around();
  for (AutoCell& cell : cells_) judge(cell);
}

void AutoFidelity::learn_transfers() {
  for (std::size_t r = 0; r < rungs_.size(); ++r) {
    std::vector<std::vector<Sample>> ensembles;
    std::map<std::string, std::vector<Both>> both;  // by the class on this rung
    for (const AutoCell& cell : cells_) {
      ensembles.push_back(cell.runs[r]);
      if (r + 1 < rungs_.size() && !cell.runs[r].empty() && !cell.runs[r + 1].empty())
        both[leading_class(cell.runs[r])].push_back({cell.runs[r], cell.runs[r + 1]});
    }
    deviations_[r] = typical_deviation(ensembles, prior_deviation);
    transfers_[r].clear();
    for (const auto& [name, impacts] : both)
      transfers_[r][name] = transfer_between(impacts, prior_scatter);
  }
}

/// What else is known of the classes of an impact: its neighbours, and the rung below, which
/// counts as one neighbour more.
ClassShares AutoFidelity::known_besides(const AutoCell& cell, std::size_t rung) const {
  ClassShares shares = cell.around;
  if (rung > 0)
    for (const auto& [name, share] : class_shares(cell.runs[rung - 1])) shares[name] += 0.5 * share;
  return shares;
}

void AutoFidelity::judge(AutoCell& cell) const {
  cell.rung = -1;
  for (std::size_t r = 0; r < rungs_.size(); ++r) {
    const std::vector<Sample>& runs = cell.runs[r];
    if (runs.empty()) continue;
    const Answer finer = answer_of(runs, deviations_[r], transfer_to_top(r, leading_class(runs)),
                                   known_besides(cell, r));
    // A finer run more must not make a sure answer less sure.
    const bool sure = cell.is_known() && !cell.verdict.in_doubt(options_.confidence);
    if (sure && agree(runs) && bears_out(finer, cell.verdict)) continue;
    cell.rung = static_cast<int>(r);
    cell.verdict = finer;
  }
}

bool AutoFidelity::is_mixed(const AutoCell& cell) const {
  if (cell.finest() < 0) return false;
  const auto r = static_cast<std::size_t>(cell.finest());
  const std::vector<Sample>& runs = cell.runs[r];
  if (r + 1 == rungs_.size() && runs.size() < fewest_of_mixed) return false;
  const auto most = static_cast<std::size_t>(most_seeds(r));
  return best_p_outcome(runs, most, known_besides(cell, r)) < options_.confidence ||
         best_p_side(runs, deviations_[r], most, transfer_to_top(r, leading_class(runs))) <
             options_.confidence;
}

std::vector<Wanted> AutoFidelity::next() const {
  std::vector<Wanted> wanted;
  for (const AutoCell& cell : cells_) {
    if (!in_doubt(cell)) continue;
    std::size_t rung = cell.finest() < 0 ? 0 : static_cast<std::size_t>(cell.finest());
    const bool used_up = std::ssize(cell.runs[rung]) >= most_seeds(rung) || is_mixed(cell);
    if (used_up && ++rung == rungs_.size()) continue;
    const std::int64_t first = std::ssize(cell.runs[rung]) + 1,
                       last = std::max(sweeps::first_auto_seeds, first);
    for (std::int64_t seed = first; seed <= std::min(last, most_seeds(rung)); ++seed)
      wanted.push_back({with_seed(cell.scenes[rung], seed), rung});
  }
  return wanted;
}

std::vector<double> AutoFidelity::core_seconds() const {
  std::vector<double> sums(rungs_.size());
  for (const AutoCell& cell : cells_)
    for (std::size_t r = 0; r < rungs_.size(); ++r)
      for (const Sample& s : cell.runs[r]) sums[r] += s.core_seconds.value_or(0);
  return sums;
}

double AutoFidelity::uniform_core_seconds() const {
  for (std::size_t r = rungs_.size(); r-- > 0;) {
    double sum = 0, runs = 0;
    for (const AutoCell& cell : cells_)
      for (const Sample& s : cell.runs[r])
        if (s.core_seconds) sum += *s.core_seconds, ++runs;
    if (runs > 0)
      return sum / runs * static_cast<double>(options_.most_seeds) *
             static_cast<double>(cells_.size());
  }
  return 0;
}

std::string auto_csv(const AutoFidelity& campaign) {
  std::string csv = "q,phi_d_deg,v_imp_cm_per_s,theta_imp_deg,fidelity,seeds,";
  for (const Rung& rung : campaign.rungs()) csv += fmt::format("runs_{},", rung.name);
  csv += "class,p_class,b_over_a,p_largest_eer,confidence,in_doubt\n";
  for (const AutoCell& c : campaign.cells()) {
    csv += fmt::format("{},{},{},", point_of(c.scenes.front()), campaign.fidelity(c),
                       c.is_known() ? c.seeds() : 0);
    for (const std::vector<Sample>& runs : c.runs) csv += fmt::format("{},", runs.size());
    if (!c.is_known())
      csv += ",,,,,1\n";
    else
      csv += fmt::format("{},{:.3f},{:.4f},{:.3f},{:.3f},{}\n", c.verdict.outcome,
                         c.verdict.p_outcome, c.verdict.b_over_a, c.verdict.p_elongated,
                         c.verdict.confidence(), campaign.in_doubt(c) ? 1 : 0);
  }
  return csv;
}

}  // namespace eerie::auto_fidelity
