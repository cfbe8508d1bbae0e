#include "analysis/paper/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "analysis/paper/check_runs.hpp"
#include "analysis/remnants/remnants.hpp"
#include "analysis/statistics/student.hpp"
#include "solver/base/constants.hpp"

namespace eerie::paper {

namespace {

/// First seeds to ask for where there are none.
constexpr std::size_t first_seeds = 6;
/// Chance of a run so far out, on one side, below which it is no such run.
constexpr double improbable = 0.025;

/// Mean and standard deviation of single runs.
struct Sample {
  std::size_t n = 0;
  double mean = 0, deviation = 0, low = 0, high = 0;
};

Sample sample(const std::vector<double>& values) {
  Sample s;
  if (values.empty()) return s;
  s.n = values.size();
  const auto n = static_cast<double>(s.n);
  for (const double value : values) s.mean += value / n;
  double squares = 0;
  for (const double value : values) squares += (value - s.mean) * (value - s.mean);
  s.deviation = s.n > 1 ? std::sqrt(squares / (n - 1)) : 0;
  const auto [low, high] = std::ranges::minmax(values);
  s.low = low, s.high = high;
  return s;
}

/// Is `excess` beyond the tolerance more than a scatter of `scale` explains?
bool beyond_chance(double excess, double scale, double freedom) {
  if (excess <= 0) return false;
  return scale == 0 || 1 - statistics::student_cdf(excess / scale, freedom) < improbable;
}

std::string decimals(double value) {
  return std::abs(value) < 2 ? fmt::format("{:.3f}", value) : fmt::format("{:.4g}", value);
}

std::string text(const Sample& s) {
  return fmt::format("{} +- {} ({} to {})", decimals(s.mean), decimals(s.deviation),
                     decimals(s.low), decimals(s.high));
}

std::string difference_text(double found, double paper) {
  const double d = found - paper;
  return fmt::format("{}{} ({:+.0f} %)", d < 0 ? "-" : "+", decimals(std::abs(d)), 100 * d / paper);
}

std::string place(const CheckCell& cell, std::size_t those) {
  return fmt::format("v = {:g} cm/s, theta = {:g} deg ({} of {})", cell.at.v_imp_cm_per_s,
                     cell.at.theta_imp_deg, those, cell.runs.size());
}

std::optional<double> quantity(const ImpactRun& run, const Fact& fact, const NumberIs& claim) {
  if (claim.quantity == FactQuantity::period_h) return run.period_h;
  const auto wanted = std::ranges::find_if(run.remnants, [&](const RunRemnant& r) {
    return claim.smaller ? r.rank > 1 && r.eer : r.rank == 1;
  });
  if (wanted == run.remnants.end()) return std::nullopt;
  switch (claim.quantity) {
    case FactQuantity::b_over_a:
      return wanted->b_over_a;
    case FactQuantity::mass_over_target:
      return wanted->mass_over_total * (1 + fact.q);
    case FactQuantity::a_m:
      return wanted->a_m;
    case FactQuantity::b_m:
      return wanted->b_m;
    case FactQuantity::period_h:
      break;
  }
  return run.period_h;
}

/// Is it about remnants other than the largest?
bool of_smaller(const Claim& claim) {
  if (const auto* number = std::get_if<NumberIs>(&claim)) return number->smaller;
  return std::holds_alternative<SmallerIsEer>(claim) ||
         std::holds_alternative<SmallerEersOnlyIn>(claim);
}

/// Tests one fact against runs of one kind of settings.
class Trial {
 public:
  Trial(const Fact& fact, const std::vector<ImpactRun>& runs, const RunSettings& settings,
        const std::string& database)
      : fact_(fact), runs_(runs), settings_(settings), database_(database) {
    const auto points = fact.point ? std::vector{*fact.point} : points_of(fact.grids);
    cells_ = check_cells(points, fact, runs_);
    for (CheckCell& cell : cells_) {
      for (const ImpactRun* run : cell.runs)
        if (run->stiffness != 1) stiff_.push_back(run);
      std::erase_if(cell.runs, [](const ImpactRun* run) { return run->stiffness != 1; });
    }
  }

  FactCheck finding() {
    f_.settings = settings_;
    rest_on(cells_);
    std::visit(*this, fact_.claim);
    if (of_smaller(fact_.claim) && settings_.particles_per_target < check_smaller_min_particles)
      refuse_as_too_coarse();
    if (f_.runs == 0 && stiff_.empty() && only_missing()) f_.found.clear(), f_.difference.clear();
    if (f_.agreement == Agreement::agrees || f_.agreement == Agreement::disagrees)
      f_.to_run.clear();
    return f_;
  }

  void operator()(const NumberIs& claim) {
    std::vector<double> values;
    for (const ImpactRun* run : only().runs)
      if (const auto value = quantity(*run, fact_, claim)) values.push_back(*value);
    const Sample s = sample(values);
    f_.paper = claim.value;
    f_.runs = s.n;
    if (s.n > 0) f_.value = s.mean, f_.low = s.low, f_.high = s.high, f_.found = text(s);
    ask_for_seeds(only());
    if (claim.smaller && s.n < only().runs.size())
      f_.found += fmt::format("{}{} of {} runs have such a remnant", s.n > 0 ? "; " : "", s.n,
                              only().runs.size());
    if (s.n < check_min_runs) return;
    const auto n = static_cast<double>(s.n);
    const double tolerance = check_tolerance * claim.value;
    const double away = std::abs(s.mean - claim.value);
    if (away > tolerance) f_.difference = difference_text(s.mean, claim.value);
    if (beyond_chance(away - tolerance, s.deviation * std::sqrt(1 + 1 / n), n - 1))
      f_.agreement = Agreement::disagrees;
    else if (away <= tolerance && s.deviation / std::sqrt(n) <= tolerance)
      f_.agreement = Agreement::agrees;
    else
      f_.agreement = Agreement::undecided;
  }

  void operator()(const AlmostMerges&) { most_runs(only().runs, almost_merged, "merge"); }

  void operator()(const ShapeLasts& claim) {
    std::vector<const ImpactRun*> late = only().runs;
    std::erase_if(late, [&](const ImpactRun* run) { return run->ended_at_s < claim.until_s; });
    most_runs(late, largest_is_eer, "are elongated then");
    if (late.size() < only().runs.size())
      f_.found += fmt::format("{}{} of {} runs last so long", late.empty() ? "" : "; ", late.size(),
                              only().runs.size());
    f_.to_run = run_point(fact_, only().at, first_seeds, settings_, database_,
                          fmt::format("--set end.time_s={:.0f} --set end.settled.window_s=0 --set "
                                      "numerics.late_sound_speed=1",
                                      claim.until_s));
  }

  void operator()(const SmallerIsEer&) {
    most_runs(only().runs, smaller_is_eer, "have a smaller EER");
  }

  void operator()(const StiffnessIsIdle& claim) {
    std::vector<double> soft, stiff;
    for (const ImpactRun* run : only().runs) soft.push_back(run->b_over_a());
    for (const ImpactRun* run : stiff_)
      if (std::abs(run->stiffness / claim.stiffness - 1) < 1e-6) stiff.push_back(run->b_over_a());
    const Sample one = sample(soft), other = sample(stiff);
    f_.runs = one.n + other.n;
    if (one.n == 0 || other.n == 0) f_.found = "no run with the stiffer equation of state";
    f_.to_run = run_point(fact_, only().at, first_seeds, settings_, database_,
                          fmt::format("--set material.tillotson.A_Pa={0:g} "
                                      "--set material.tillotson.B_Pa={0:g}",
                                      2.67e4 * claim.stiffness));
    if (one.n == 0) f_.to_run += "; and the same without --set";
    if (one.n == 0 || other.n == 0) return;
    f_.found = fmt::format("b/a {}, stiffer {}", text(one), text(other));
    f_.paper = one.mean, f_.value = other.mean, f_.low = other.low, f_.high = other.high;
    if (one.n < check_min_runs || other.n < check_min_runs) return;
    const double tolerance = check_tolerance * one.mean, away = std::abs(other.mean - one.mean);
    const double error =
        std::sqrt(one.deviation * one.deviation / static_cast<double>(one.n) +
                  other.deviation * other.deviation / static_cast<double>(other.n));
    if (away > tolerance) f_.difference = difference_text(other.mean, one.mean);
    if (beyond_chance(away - tolerance, error, static_cast<double>(one.n + other.n - 2)))
      f_.agreement = Agreement::disagrees;
    else
      f_.agreement =
          away <= tolerance && error <= tolerance ? Agreement::agrees : Agreement::undecided;
  }

  void operator()(const RidgeIsAt& claim) {
    std::vector<ImpactRun> here;
    for (const CheckCell& cell : cells_)
      for (const ImpactRun* run : cell.runs) here.push_back(*run);
    f_.paper = claim.constant;
    const std::vector<RidgeCell> cells = ridge_cells(here);
    f_.split = static_cast<std::size_t>(std::ranges::count_if(
        cells, [](const RidgeCell& c) { return c.p_eer() > 0 && c.p_eer() < 1; }));
    f_.to_run = run_sweeps(fact_, settings_, database_);
    const auto fit = fit_threshold(cells);
    if (const auto* few = std::get_if<TooFewForThreshold>(&fit)) {
      f_.found = "no ridge to fit";
      f_.difference = few->reason;
      if (f_.impacts == f_.impacts_wanted) f_.agreement = Agreement::disagrees;
      return;
    }
    const Threshold& t = std::get<Threshold>(fit);
    f_.value = t.constant, f_.low = t.low, f_.high = t.high;
    f_.found = fmt::format("{:.2f} cm/s (95 %: {:.2f} to {:.2f})", t.constant, t.low, t.high);
    if (!t.scatter_s) {
      f_.found += "; fewer than two angles have both sides of the ridge sampled";
      return;
    }
    f_.to_run = one_seed_more();
    const double tolerance = check_tolerance * claim.constant;
    const double away = std::abs(t.constant - claim.constant);
    if (away > tolerance) f_.difference = difference_text(t.constant, claim.constant);
    const bool apart = t.low > claim.constant + tolerance || t.high < claim.constant - tolerance;
    const bool known = (t.high - t.low) / 2 <= tolerance;
    if (apart)
      f_.agreement = Agreement::disagrees;
    else
      f_.agreement = away <= tolerance && known ? Agreement::agrees : Agreement::undecided;
  }

  void operator()(const EersOnlyIn& claim) {
    const std::size_t eers = count_cells(largest_is_eer);
    f_.found = fmt::format("EERs at {} of {} impacts", eers, f_.impacts);
    by_contradictions(
        [&](const CheckCell& cell) {
          return !claim.window.holds(cell.at) && cell.mostly(largest_is_eer);
        },
        largest_is_eer);
    if (f_.agreement == Agreement::agrees && eers == 0)
      f_.agreement = Agreement::disagrees, f_.difference = "there is none at all";
  }

  void operator()(const NoEer&) {
    f_.found = fmt::format("EERs at {} of {} impacts", count_cells(largest_is_eer), f_.impacts);
    by_contradictions([](const CheckCell& cell) { return cell.mostly(largest_is_eer); },
                      largest_is_eer);
  }

  void operator()(const EersExactlyAt& claim) {
    f_.found = fmt::format("EERs at {} of {} impacts", count_cells(largest_is_eer), f_.impacts);
    by_contradictions(
        [&](const CheckCell& cell) {
          const bool listed = std::ranges::any_of(claim.points, [&](const ImpactPoint& p) {
            return std::abs(p.v_imp_cm_per_s - cell.at.v_imp_cm_per_s) <= same_v_cm_per_s &&
                   std::abs(p.theta_imp_deg - cell.at.theta_imp_deg) <= same_theta_deg;
          });
          return !cell.runs.empty() && listed != cell.mostly(largest_is_eer);
        },
        largest_is_eer);
  }

  void operator()(const EersAreMerged&) {
    const auto merged = [](const ImpactRun& run) {
      return largest_is_eer(run) && almost_merged(run);
    };
    const std::size_t eers = count_cells(largest_is_eer);
    f_.found = fmt::format("{} of {} EERs are mergers", count_cells(merged), eers);
    by_contradictions(
        [&](const CheckCell& cell) {
          return cell.mostly(largest_is_eer) && 2 * cell.count(merged) < cell.count(largest_is_eer);
        },
        [&](const ImpactRun& run) { return largest_is_eer(run) && !almost_merged(run); });
    if (f_.agreement == Agreement::agrees && eers == 0)
      f_.agreement = Agreement::disagrees, f_.difference = "there is no EER at all";
  }

  void operator()(const SmallerEersOnlyIn& claim) {
    std::size_t inside = 0, runs_inside = check_min_runs;
    for (const CheckCell& cell : cells_) {
      if (!claim.window.holds(cell.at)) continue;
      inside += cell.mostly(smaller_is_eer) ? 1 : 0;
      runs_inside = std::min(runs_inside, cell.runs.size());
    }
    f_.found = fmt::format("smaller EERs at {} of {} impacts, {} of them where the paper has {}",
                           count_cells(smaller_is_eer), f_.impacts, inside, claim.count);
    by_contradictions(
        [&](const CheckCell& cell) {
          return !claim.window.holds(cell.at) && cell.mostly(smaller_is_eer);
        },
        smaller_is_eer);
    if (f_.agreement != Agreement::agrees || inside == claim.count) return;
    f_.difference = fmt::format("{} instead of {}", inside, claim.count);
    f_.agreement = runs_inside < check_min_runs ? Agreement::undecided : Agreement::disagrees;
    f_.to_run = one_seed_more();
  }

  void operator()(const MostlyOfClass& claim) {
    const double tolerance = check_tolerance * claim.constant;
    std::erase_if(cells_, [&](const CheckCell& cell) {
      const double s = cell.at.v_imp_cm_per_s * std::sin(radians(cell.at.theta_imp_deg));
      return std::abs(s - claim.constant) > tolerance || !claim.window.holds(cell.at);
    });
    rest_on(cells_);
    const auto of_class = [&](const ImpactRun& run) {
      return run.outcome == remnants::name(claim.outcome);
    };
    const std::size_t those = count_cells(of_class);
    f_.found =
        fmt::format("{} of {} impacts are {}", those, f_.impacts, remnants::name(claim.outcome));
    by_contradictions([](const CheckCell&) { return false; }, of_class);
    if (f_.agreement != Agreement::agrees || 2 * those > f_.impacts) return;
    f_.agreement = Agreement::disagrees;
    f_.difference = "the others:";
    for (const CheckCell& cell : cells_)
      if (!cell.mostly(of_class))
        f_.difference += fmt::format(" {} at {:g} cm/s, {:g} deg;", cell.runs.front()->outcome,
                                     cell.at.v_imp_cm_per_s, cell.at.theta_imp_deg);
    f_.difference.pop_back();
  }

  void operator()(const AllClassesOccur&) {
    const auto of = [&](std::initializer_list<remnants::OutcomeClass> classes) {
      return count_cells([&](const ImpactRun& run) {
        return std::ranges::any_of(
            classes, [&](remnants::OutcomeClass c) { return remnants::name(c) == run.outcome; });
      });
    };
    using enum remnants::OutcomeClass;
    const std::size_t merging = of({perfect_merging, graze_and_merge, partial_accretion});
    const std::size_t hit = of({hit_and_run}), destroyed = of({catastrophic_disruption});
    f_.found = fmt::format("{} merge or accrete, {} hit and run, {} are disrupted, of {}", merging,
                           hit, destroyed, f_.impacts);
    f_.split = 0;
    by_contradictions([](const CheckCell&) { return false; }, largest_is_eer);
    const bool all = merging > 0 && hit > 0 && destroyed > 0;
    if (all)
      f_.agreement = Agreement::agrees;
    else if (f_.agreement == Agreement::agrees)
      f_.agreement = Agreement::disagrees, f_.difference = "not all of them occur";
  }

 private:
  void refuse_as_too_coarse() {
    f_.agreement = Agreement::not_enough;
    f_.found = fmt::format("too few particles for small remnants: needs {} per target",
                           check_smaller_min_particles);
    f_.difference.clear(), f_.value.reset(), f_.low.reset(), f_.high.reset();
    const RunSettings fine{check_smaller_min_particles, "survey", "survey"};
    f_.to_run = fact_.point ? run_point(fact_, *fact_.point, first_seeds, fine, database_)
                            : run_sweeps(fact_, fine, database_);
  }

  bool only_missing() const {
    return std::ranges::all_of(cells_, [](const CheckCell& cell) { return cell.runs.empty(); });
  }

  const CheckCell& only() const { return cells_.front(); }

  void rest_on(const std::vector<CheckCell>& cells) {
    f_.impacts_wanted = cells.size();
    f_.runs = f_.impacts = f_.unsettled = 0;
    for (const CheckCell& cell : cells) {
      f_.runs += cell.runs.size(), f_.impacts += cell.runs.empty() ? 0 : 1;
      f_.unsettled += cell.count([](const ImpactRun& run) { return !run.settled; });
    }
  }

  std::size_t count_cells(const CheckCell::Condition& condition) const {
    return static_cast<std::size_t>(std::ranges::count_if(
        cells_, [&](const CheckCell& cell) { return cell.mostly(condition); }));
  }

  void ask_for_seeds(const CheckCell& cell) {
    f_.to_run = run_point(fact_, cell.at, std::max(first_seeds, 2 * cell.runs.size()), settings_,
                          database_);
  }

  /// The fact's sweeps with a seed that no run has yet.
  std::string one_seed_more() const {
    std::int64_t most = 0;
    for (const CheckCell& cell : cells_)
      for (const ImpactRun* run : cell.runs) most = std::max(most, run->seed);
    return run_sweeps(fact_, settings_, database_, fmt::format("--set numerics.seed={}", most + 1));
  }

  /// A statement on one impact: what at least half of its runs are.
  void most_runs(const std::vector<const ImpactRun*>& runs, const CheckCell::Condition& condition,
                 const char* verb) {
    const CheckCell cell{only().at, runs};
    f_.runs = runs.size();
    f_.split = cell.split(condition) ? 1 : 0;
    ask_for_seeds(only());
    if (runs.empty()) return;
    f_.found = fmt::format("{} of {} runs {}", cell.count(condition), runs.size(), verb);
    if (runs.size() < check_min_runs) return;
    f_.agreement = cell.mostly(condition) ? Agreement::agrees : Agreement::disagrees;
  }

  /// A statement on a grid: the points that contradict it, and those still to be run. `matter` is
  /// what their seeds may disagree on.
  void by_contradictions(const std::function<bool(const CheckCell&)>& contradicts,
                         const CheckCell::Condition& matter) {
    f_.split = static_cast<std::size_t>(
        std::ranges::count_if(cells_, [&](const CheckCell& cell) { return cell.split(matter); }));
    const CheckCell* unsure = nullptr;
    bool sure = false;
    for (const CheckCell& cell : cells_) {
      if (!contradicts(cell)) continue;
      f_.difference += (f_.difference.empty() ? "" : "; ") + place(cell, cell.count(matter));
      if (cell.runs.size() < check_min_runs)
        unsure = &cell;
      else
        sure = true;
    }
    if (sure) {
      f_.agreement = Agreement::disagrees;
    } else if (unsure != nullptr) {
      f_.agreement = Agreement::undecided;
      ask_for_seeds(*unsure);
    } else {
      f_.agreement = f_.impacts == f_.impacts_wanted ? Agreement::agrees : Agreement::not_enough;
      f_.to_run = run_sweeps(fact_, settings_, database_);
    }
  }

  const Fact& fact_;
  const std::vector<ImpactRun>& runs_;
  RunSettings settings_;
  const std::string& database_;
  std::vector<CheckCell> cells_;
  std::vector<const ImpactRun*> stiff_;
  FactCheck f_;
};

}  // namespace

std::string_view name(Agreement agreement) {
  return agreement_names.at(static_cast<std::size_t>(agreement));
}

FactCheck check(const Fact& fact, const std::vector<ImpactRun>& runs, const std::string& database) {
  std::set<RunSettings> kinds;  // the most particles last
  for (const ImpactRun& run : runs)
    if (std::abs(run.q - fact.q) <= same_q &&
        std::abs(run.phi_d_deg - fact.phi_d_deg) <= same_phi_d_deg)
      kinds.insert(run.settings);
  std::optional<FactCheck> best;
  for (auto kind = kinds.rbegin(); kind != kinds.rend(); ++kind) {
    std::vector<ImpactRun> same;
    std::ranges::copy_if(runs, std::back_inserter(same),
                         [&](const ImpactRun& run) { return run.settings == *kind; });
    FactCheck found = Trial(fact, same, *kind, database).finding();
    if (found.agreement != Agreement::not_enough) return found;
    if (!best || found.impacts > best->impacts) best = found;
  }
  return best ? *best : Trial(fact, runs, {}, database).finding();
}

}  // namespace eerie::paper
