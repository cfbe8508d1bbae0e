#include "campaign/auto_fidelity/auto_fidelity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "campaign/results/finished_run.hpp"
#include "solver/base/error.hpp"

namespace eerie::auto_fidelity {

namespace {

constexpr const char* coarse = "sketch";
constexpr const char* fine = "survey";
/// So many runs of each impact at first, and so many sketches at most.
constexpr std::int64_t first_seeds = 2, most_sketches = 4;
/// An impact is not called mixed by fewer surveys.
constexpr std::size_t fewest_of_mixed = 4;
/// Of b/a, before anything is known: the spread of seeds, and what a sketch may be off.
constexpr double prior_deviation = 0.03, prior_scatter = 0.05;

bool agree(const std::vector<Sample>& samples) {
  return std::ranges::all_of(samples,
                             [&](const Sample& s) { return s.outcome == samples.front().outcome; });
}

/// Whether surveys say what sketches say.
bool bears_out(const Answer& finer, const Answer& sketched) {
  return finer.outcome == sketched.outcome &&
         (finer.p_elongated > 0.5) == (sketched.p_elongated > 0.5);
}

/// What else is known of the classes of a surveyed impact: its neighbours and its own sketches,
/// which count as one neighbour more.
ClassShares with_sketches(const AutoCell& cell) {
  ClassShares shares = cell.around;
  for (const auto& [name, share] : class_shares(cell.sketch)) shares[name] += 0.5 * share;
  return shares;
}

struct AutoRun {
  std::size_t cell = 0;
  bool survey = false;
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

}  // namespace

AutoFidelity::AutoFidelity(const sweeps::Sweep& sketch, const sweeps::Sweep& survey,
                           AutoOptions options)
    : options_(options) {
  if (const auto n = static_cast<double>(options.most_seeds);
      (n + 0.5) / (n + 1) < options.confidence)
    throw InputError(
        fmt::format("--confidence {:g}: {} runs of one class are no surer than {:.3f}; give "
                    "--most-seeds {:.0f} or "
                    "more, or ask for less",
                    options.confidence, options.most_seeds, (n + 0.5) / (n + 1),
                    std::ceil((options.confidence - 0.5) / (1 - options.confidence) - 1e-9)));
  std::vector<std::string> varied = sketch.points.paths;
  for (const sweeps::Axis& axis : sketch.axes) varied.push_back(axis.path);
  if (std::ranges::find(varied, "numerics.seed") != varied.end())
    throw InputError(fmt::format(
        "{}: grid: numerics.seed is chosen by --fidelity auto and is an axis too; leave it out",
        sketch.where));
  const std::vector<Scene> sketches = sweeps::expand(sketch), surveys = sweeps::expand(survey);
  for (std::size_t k = 0; k < sketches.size(); ++k)
    cells_.push_back({sketches[k], surveys[k], {}, {}, {}, ""});
  find_neighbours(sketch.axes);
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
      const AutoCell& other = cells_[k];
      const std::vector<Sample>& runs = other.survey.empty() ? other.sketch : other.survey;
      if (runs.empty()) continue;
      ++known;
      for (const auto& [name, share] : class_shares(runs)) cell.around[name] += share;
    }
    for (auto& [name, share] : cell.around) share /= known;
  }
}

Transfer AutoFidelity::transfer(const std::string& sketched_class) const {
  const auto known = transfers_.find(sketched_class);
  return known == transfers_.end() ? Transfer{0, prior_scatter} : known->second;
}

std::vector<std::string> AutoFidelity::classes() const {
  std::vector<std::string> names;
  for (const auto& [name, transfer] : transfers_) names.push_back(name);
  return names;
}

void AutoFidelity::update(const db::Connection& connection) {
  std::vector<AutoRun> runs;
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    cells_[c].sketch.clear(), cells_[c].survey.clear();
    for (std::int64_t seed = 1; seed <= most_sketches; ++seed)
      runs.push_back({c, false, with_seed(cells_[c].sketch_scene, seed)});
    for (std::int64_t seed = 1; seed <= options_.most_seeds; ++seed)
      runs.push_back({c, true, with_seed(cells_[c].survey_scene, seed)});
  }
  for (const results::RunWithResult<AutoRun>& r : results::finished_runs(runs, &connection)) {
    AutoCell& cell = cells_[r.run.cell];
    (r.run.survey ? cell.survey : cell.sketch)
        .push_back({r.row.result.outcome_class, r.row.result.b_over_a, r.core_seconds});
  }
  judge_all();
}

void AutoFidelity::judge_all() {
  std::vector<std::vector<Sample>> sketches, surveys;
  std::map<std::string, std::vector<Both>> both;  // by the class of the sketches
  for (const AutoCell& cell : cells_) {
    sketches.push_back(cell.sketch), surveys.push_back(cell.survey);
    if (!cell.sketch.empty() && !cell.survey.empty())
      both[leading_class(cell.sketch)].push_back({cell.sketch, cell.survey});
  }
  transfers_.clear();
  for (const auto& [name, impacts] : both)
    transfers_[name] = transfer_between(impacts, prior_scatter);
  look_around();
  const double coarse_deviation = typical_deviation(sketches, prior_deviation);
  survey_deviation_ = typical_deviation(surveys, prior_deviation);
  for (AutoCell& cell : cells_) {
    if (!cell.sketch.empty()) {
      cell.fidelity = coarse;
      cell.verdict = answer_of(cell.sketch, coarse_deviation, transfer(leading_class(cell.sketch)),
                               cell.around);
    }
    if (cell.survey.empty()) continue;
    const Answer finer = answer_of(cell.survey, survey_deviation_, {}, with_sketches(cell));
    // A survey more must not make a sure answer less sure.
    const bool sure = !cell.sketch.empty() && !cell.verdict.in_doubt(options_.confidence);
    if (sure && agree(cell.survey) && bears_out(finer, cell.verdict)) continue;
    cell.fidelity = fine;
    cell.verdict = finer;
  }
}

bool AutoFidelity::is_mixed(const AutoCell& cell) const {
  if (cell.survey.size() < fewest_of_mixed) return false;
  const auto most = static_cast<std::size_t>(options_.most_seeds);
  return best_p_outcome(cell.survey, most, with_sketches(cell)) < options_.confidence ||
         best_p_side(cell.survey, survey_deviation_, most) < options_.confidence;
}

std::vector<Wanted> AutoFidelity::next() const {
  std::vector<Wanted> wanted;
  const auto ask = [&](const Scene& scene, bool survey, std::size_t done, std::int64_t most) {
    const auto first = static_cast<std::int64_t>(done) + 1;
    const std::int64_t last = std::max(first_seeds, first);
    for (std::int64_t seed = first; seed <= std::min(last, most); ++seed)
      wanted.push_back({with_seed(scene, seed), survey});
  };
  for (const AutoCell& cell : cells_) {
    if (!in_doubt(cell) || is_mixed(cell)) continue;
    // More sketches help where all that is lacking is their number.
    const double p = cell.verdict.p_elongated;
    const bool only_few =
        cell.survey.empty() && agree(cell.sketch) && std::max(p, 1 - p) >= options_.confidence;
    if (cell.sketch.empty() || (only_few && std::ssize(cell.sketch) < most_sketches))
      ask(cell.sketch_scene, false, cell.sketch.size(), most_sketches);
    else
      ask(cell.survey_scene, true, cell.survey.size(), options_.most_seeds);
  }
  return wanted;
}

std::map<std::string, double> AutoFidelity::core_seconds() const {
  std::map<std::string, double> sums;
  for (const AutoCell& cell : cells_) {
    for (const Sample& s : cell.sketch) sums[coarse] += s.core_seconds.value_or(0);
    for (const Sample& s : cell.survey) sums[fine] += s.core_seconds.value_or(0);
  }
  return sums;
}

double AutoFidelity::uniform_core_seconds() const {
  double sum = 0;
  std::size_t runs = 0;
  for (const AutoCell& cell : cells_)
    for (const Sample& s : cell.survey)
      if (s.core_seconds) sum += *s.core_seconds, ++runs;
  if (runs == 0) return 0;
  return sum / static_cast<double>(runs) * static_cast<double>(options_.most_seeds) *
         static_cast<double>(cells_.size());
}

std::string auto_csv(const AutoFidelity& campaign) {
  std::string csv =
      "q,phi_d_deg,v_imp_cm_per_s,theta_imp_deg,fidelity,seeds,sketches,class,p_class,b_over_a,"
      "p_largest_eer,confidence,in_doubt\n";
  for (const AutoCell& c : campaign.cells()) {
    csv += point_of(c.survey_scene);
    if (c.fidelity.empty())
      csv += ",,0,0,,,,,,1\n";
    else
      csv +=
          fmt::format(",{},{},{},{},{:.3f},{:.4f},{:.3f},{:.3f},{}\n", c.fidelity, c.seeds(),
                      c.sketch.size(), c.verdict.outcome, c.verdict.p_outcome, c.verdict.b_over_a,
                      c.verdict.p_elongated, c.verdict.confidence(), campaign.in_doubt(c) ? 1 : 0);
  }
  return csv;
}

}  // namespace eerie::auto_fidelity
