#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/paper/fact_trial.hpp"
#include "analysis/statistics/ensemble.hpp"
#include "analysis/statistics/student.hpp"
#include "solver/base/constants.hpp"

namespace eerie::paper {

namespace {

/// Chance of a run so far out, on one side, below which it is no such run.
constexpr double improbable = 0.025;

/// Is `excess` beyond the tolerance more than a scatter of `scale` explains?
bool beyond_chance(double excess, double scale, double freedom) {
  if (excess <= 0) return false;
  return scale == 0 || 1 - statistics::student_cdf(excess / scale, freedom) < improbable;
}

std::string decimals(double value) {
  return std::abs(value) < 2 ? fmt::format("{:.3f}", value) : fmt::format("{:.4g}", value);
}

std::string text(const statistics::Ensemble& s) {
  return fmt::format("{} +- {} ({} to {})", decimals(s.mean), decimals(s.deviation),
                     decimals(s.low), decimals(s.high));
}

std::string difference_text(double found, double paper) {
  const double d = found - paper;
  return fmt::format("{}{} ({:+.0f} %)", d < 0 ? "-" : "+", decimals(std::abs(d)), 100 * d / paper);
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

}  // namespace

// Statements on one impact, and the one on where the ridge is.

void Trial::operator()(const NumberIs& claim) {
  std::vector<double> values;
  for (const ImpactRun* run : only().runs)
    if (const auto value = quantity(*run, fact_, claim)) values.push_back(*value);
  const statistics::Ensemble s = statistics::ensemble(values);
  f_.paper = claim.value;
  f_.runs = s.runs;
  if (s.runs > 0) f_.value = s.mean, f_.low = s.low, f_.high = s.high, f_.found = text(s);
  ask_for_seeds(only());
  if (claim.smaller && s.runs < only().runs.size())
    f_.found += fmt::format("{}{} of {} runs have such a remnant", s.runs > 0 ? "; " : "", s.runs,
                            only().runs.size());
  if (s.runs < check_min_runs) {
    if (!claim.smaller || only().runs.size() < check_min_runs) return;
    f_.agreement = Agreement::undecided;
    f_.difference = s.runs == 0 ? "no run forms it" : "chance between seeds forms it or not";
    return;
  }
  const auto n = static_cast<double>(s.runs);
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

void Trial::operator()(const AlmostMerges&) { most_runs(only().runs, almost_merged, "merge"); }

void Trial::operator()(const ShapeLasts& claim) {
  constexpr double rounding = 1e-9;  // of a time that is a sum of steps
  std::vector<const ImpactRun*> late = only().runs;
  std::erase_if(
      late, [&](const ImpactRun* run) { return run->ended_at_s < claim.until_s * (1 - rounding); });
  most_runs(late, largest_is_eer, "are elongated then");
  if (late.size() < only().runs.size())
    f_.found += fmt::format("{}{} of {} runs last so long", late.empty() ? "" : "; ", late.size(),
                            only().runs.size());
  f_.to_run = run_point(fact_, only().at, first_seeds, settings_, database_,
                        fmt::format("--set end.time_s={:.0f} --set end.settled.window_s=0 --set "
                                    "numerics.late_sound_speed=1 --set numerics.rigid_flight=false",
                                    claim.until_s));
}

void Trial::operator()(const SmallerIsEer&) {
  most_runs(only().runs, smaller_is_eer, "have a smaller EER");
}

void Trial::operator()(const StiffnessIsIdle& claim) {
  std::vector<double> soft, stiff;
  for (const ImpactRun* run : only().runs) soft.push_back(run->b_over_a());
  for (const ImpactRun* run : stiff_)
    if (std::abs(run->stiffness / claim.stiffness - 1) < 1e-6) stiff.push_back(run->b_over_a());
  const statistics::Ensemble one = statistics::ensemble(soft), other = statistics::ensemble(stiff);
  f_.runs = one.runs + other.runs;
  if (one.runs == 0 || other.runs == 0) f_.found = "no run with the stiffer equation of state";
  f_.to_run = run_point(fact_, only().at, first_seeds, settings_, database_,
                        fmt::format("--set material.tillotson.A_Pa={0:g} "
                                    "--set material.tillotson.B_Pa={0:g}",
                                    2.67e4 * claim.stiffness));
  if (one.runs == 0) f_.to_run += "; and the same without --set";
  if (one.runs == 0 || other.runs == 0) return;
  f_.found = fmt::format("b/a {}, stiffer {}", text(one), text(other));
  f_.paper = one.mean, f_.value = other.mean, f_.low = other.low, f_.high = other.high;
  if (one.runs < check_min_runs || other.runs < check_min_runs) return;
  const double tolerance = check_tolerance * one.mean, away = std::abs(other.mean - one.mean);
  const double error =
      std::sqrt(one.deviation * one.deviation / static_cast<double>(one.runs) +
                other.deviation * other.deviation / static_cast<double>(other.runs));
  if (away > tolerance) f_.difference = difference_text(other.mean, one.mean);
  if (beyond_chance(away - tolerance, error, static_cast<double>(one.runs + other.runs - 2)))
    f_.agreement = Agreement::disagrees;
  else
    f_.agreement =
        away <= tolerance && error <= tolerance ? Agreement::agrees : Agreement::undecided;
}

void Trial::operator()(const RidgeIsAt& claim) {
  std::vector<ImpactRun> here;
  for (const CheckCell& cell : cells_)
    for (const ImpactRun* run : cell.runs) here.push_back(*run);
  f_.paper = claim.constant;
  const std::vector<RidgeCell> cells = ridge_cells(here);
  f_.split = static_cast<std::size_t>(std::ranges::count_if(
      cells, [](const RidgeCell& c) { return c.p_largest_eer() > 0 && c.p_largest_eer() < 1; }));
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

}  // namespace eerie::paper
