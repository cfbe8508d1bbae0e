#include "analysis/paper/fact_trial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace eerie::paper {

namespace {

/// Is it about remnants other than the largest?
bool of_smaller(const Claim& claim) {
  if (const auto* number = std::get_if<NumberIs>(&claim)) return number->smaller;
  return std::holds_alternative<SmallerIsEer>(claim) ||
         std::holds_alternative<SmallerEersOnlyIn>(claim);
}

}  // namespace

Trial::Trial(const Fact& fact, const std::vector<ImpactRun>& runs, const RunSettings& settings,
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

FactCheck Trial::finding() {
  f_.settings = settings_;
  rest_on(cells_);
  std::visit(*this, fact_.claim);
  if (of_smaller(fact_.claim) && settings_.particles_per_target < check_smaller_min_particles)
    refuse_as_too_coarse();
  if (f_.runs == 0 && stiff_.empty() && only_missing()) f_.found.clear(), f_.difference.clear();
  if (f_.agreement == Agreement::agrees || f_.agreement == Agreement::disagrees) f_.to_run.clear();
  return f_;
}

void Trial::refuse_as_too_coarse() {
  f_.agreement = Agreement::not_enough;
  f_.found = fmt::format("too few particles for small remnants: needs {} per target",
                         check_smaller_min_particles);
  f_.difference.clear(), f_.value.reset(), f_.low.reset(), f_.high.reset();
  const RunSettings fine{check_smaller_min_particles, "survey", "survey"};
  f_.to_run = fact_.point ? run_point(fact_, *fact_.point, first_seeds, fine, database_)
                          : run_sweeps(fact_, fine, database_);
}

bool Trial::only_missing() const {
  return std::ranges::all_of(cells_, [](const CheckCell& cell) { return cell.runs.empty(); });
}

const CheckCell& Trial::only() const { return cells_.front(); }

void Trial::rest_on(const std::vector<CheckCell>& cells) {
  f_.impacts_wanted = cells.size();
  f_.runs = f_.impacts = f_.unsettled = f_.finer = 0;
  for (const CheckCell& cell : cells) {
    if (!cell.runs.empty() && cell.runs.front()->settings != settings_) ++f_.finer;
    f_.runs += cell.runs.size(), f_.impacts += cell.runs.empty() ? 0 : 1;
    f_.unsettled += cell.count([](const ImpactRun& run) { return !run.settled; });
  }
}

std::size_t Trial::count_cells(const CheckCell::Condition& condition) const {
  return static_cast<std::size_t>(
      std::ranges::count_if(cells_, [&](const CheckCell& cell) { return cell.mostly(condition); }));
}

void Trial::ask_for_seeds(const CheckCell& cell) {
  const RunSettings& settings = cell.runs.empty() ? settings_ : cell.runs.front()->settings;
  f_.to_run =
      run_point(fact_, cell.at, std::max(first_seeds, 2 * cell.runs.size()), settings, database_);
}

std::string Trial::one_seed_more() const {
  std::int64_t most = 0;
  for (const CheckCell& cell : cells_)
    for (const ImpactRun* run : cell.runs) most = std::max(most, run->seed);
  return run_sweeps(fact_, settings_, database_, fmt::format("--set numerics.seed={}", most + 1));
}

void Trial::most_runs(const std::vector<const ImpactRun*>& runs,
                      const CheckCell::Condition& condition, const char* verb) {
  const CheckCell cell{only().at, runs};
  f_.runs = runs.size();
  f_.split = cell.split(condition) ? 1 : 0;
  ask_for_seeds(only());
  if (runs.empty()) return;
  f_.found = fmt::format("{} of {} runs {}", cell.count(condition), runs.size(), verb);
  if (runs.size() < check_min_runs) return;
  f_.agreement = cell.mostly(condition) ? Agreement::agrees : Agreement::disagrees;
}

}  // namespace eerie::paper
