#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/paper/fact_trial.hpp"
#include "analysis/remnants/remnants.hpp"
#include "solver/base/constants.hpp"

namespace eerie::paper {

namespace {

std::string place(const CheckCell& cell, std::size_t those) {
  return fmt::format("v = {:g} cm/s, theta = {:g} deg ({} of {})", cell.at.v_imp_cm_per_s,
                     cell.at.theta_imp_deg, those, cell.runs.size());
}

}  // namespace

// Statements on the impacts of a grid.

void Trial::operator()(const EersOnlyIn& claim) {
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

void Trial::operator()(const NoEer&) {
  f_.found = fmt::format("EERs at {} of {} impacts", count_cells(largest_is_eer), f_.impacts);
  by_contradictions([](const CheckCell& cell) { return cell.mostly(largest_is_eer); },
                    largest_is_eer);
}

void Trial::operator()(const EersExactlyAt& claim) {
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

void Trial::operator()(const EersAreMerged&) {
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

void Trial::operator()(const SmallerEersOnlyIn& claim) {
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

void Trial::operator()(const MostlyOfClass& claim) {
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

void Trial::operator()(const AllClassesOccur&) {
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

void Trial::by_contradictions(const std::function<bool(const CheckCell&)>& contradicts,
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

}  // namespace eerie::paper
