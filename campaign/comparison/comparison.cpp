#include "campaign/comparison/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "analysis/statistics/student.hpp"
#include "db/jobs/job_settings.hpp"
#include "db/views/query.hpp"
#include "solver/base/error.hpp"
#include "solver/base/text/shell_word.hpp"

namespace eerie::comparison {
namespace {

std::optional<std::int64_t> number_in(const std::string& text) {
  std::int64_t number = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
  return problem == std::errc() && end == text.data() + text.size() ? std::optional(number)
                                                                    : std::nullopt;
}

std::string label_of(const db::ResultRow& row) {
  return row.fidelity.empty() ? fmt::format("settings {}", row.settings) : row.fidelity;
}

/// q, friction angle, speed, angle; and the settings' scene where like is compared with like.
using Place = std::tuple<double, double, double, double, std::string>;
using Runs = std::vector<db::ResultRow>;
using Places = std::map<Place, Runs>;

Runs results_of(const ComparedSide& side) {
  db::ResultFilter filter;
  if (const auto number = number_in(side.settings))
    filter.settings = number;
  else if (!side.settings.empty())
    filter.fidelity = side.settings;
  Runs runs = db::results(*side.database, filter);
  std::erase_if(runs, [](const db::ResultRow& row) { return row.stale; });
  if (!runs.empty()) return runs;
  throw InputError(fmt::format(
      "{}: has no result{}; `eerie status --db {}` shows what it holds",
      side.database->path().string(),
      side.settings.empty() ? "" : fmt::format(" of the settings \"{}\"", side.settings),
      shell_word(side.database->path().string())));
}

Places places_of(const ComparedSide& side, bool by_settings) {
  std::map<std::int64_t, std::string> scenes;
  if (by_settings)
    for (db::JobSettings& settings : db::job_settings(*side.database))
      scenes[settings.id] = std::move(settings.scene);
  Places places;
  for (db::ResultRow& row : results_of(side))
    places[{row.q, row.phi_d_deg, row.v_imp_cm_per_s, row.theta_imp_deg, scenes[row.settings]}]
        .push_back(std::move(row));
  return places;
}

std::pair<std::string, std::size_t> main_class(const Runs& runs) {
  std::map<std::string, std::size_t> counts;
  for (const db::ResultRow& row : runs) ++counts[row.result.outcome_class];
  const auto most = std::ranges::max_element(counts, {}, [](const auto& c) { return c.second; });
  return *most;
}

template <class Number>
SeedsCompared quantity(const Runs& a, const Runs& b, Number&& number) {
  const auto over = [&](const Runs& runs) {
    std::vector<double> values;
    for (const db::ResultRow& row : runs)
      if (const std::optional<double> value = number(row.result)) values.push_back(*value);
    return statistics::ensemble(values);
  };
  return {over(a), over(b)};
}

bool same_numbers(const db::Result& a, const db::Result& b) {
  return a.outcome_class == b.outcome_class && a.m_lr_over_m_total == b.m_lr_over_m_total &&
         a.b_over_a == b.b_over_a && a.period_h == b.period_h && a.steps == b.steps;
}

void count_same_jobs(const Runs& a, const Runs& b, ImpactCompared& impact) {
  for (const db::ResultRow& row : a) {
    const auto other = std::ranges::find(b, row.hash, &db::ResultRow::hash);
    if (other == b.end()) continue;
    ++impact.same_jobs;
    if (same_numbers(row.result, other->result)) ++impact.same_results;
  }
}

std::string labels_of(const Runs& runs) {
  std::set<std::string> labels;
  for (const db::ResultRow& row : runs) labels.insert(label_of(row));
  return fmt::format("{}", fmt::join(labels, ", "));
}

ImpactCompared compared(const Runs& a, const Runs& b) {
  ImpactCompared impact;
  const db::ResultRow& first = a.front();
  impact.q = first.q, impact.phi_d_deg = first.phi_d_deg;
  impact.v_imp_cm_per_s = first.v_imp_cm_per_s, impact.theta_imp_deg = first.theta_imp_deg;
  impact.settings_a = labels_of(a), impact.settings_b = labels_of(b);
  impact.runs_a = a.size(), impact.runs_b = b.size();
  std::tie(impact.class_a, impact.of_class_a) = main_class(a);
  std::tie(impact.class_b, impact.of_class_b) = main_class(b);
  impact.b_over_a = quantity(a, b, [](const db::Result& r) { return r.b_over_a; });
  impact.m_lr =
      quantity(a, b, [](const db::Result& r) { return std::optional(r.m_lr_over_m_total); });
  impact.period_h = quantity(a, b, [](const db::Result& r) { return r.period_h; });
  count_same_jobs(a, b, impact);
  return impact;
}

[[noreturn]] void refuse(const ComparedSide& a, const ComparedSide& b) {
  const auto all = [](const ComparedSide& side) { return labels_of(results_of(side)); };
  throw InputError(fmt::format(
      "{} (with {}) and {} (with {}) have no impact of the same settings; choose with --of and "
      "--with: a fidelity, or the number of settings",
      a.database->path().string(), all(a), b.database->path().string(), all(b)));
}

}  // namespace

std::optional<double> SeedsCompared::difference() const {
  if (a.runs == 0 || b.runs == 0) return std::nullopt;
  return b.mean - a.mean;
}

std::optional<double> SeedsCompared::chance() const {
  if (a.runs == 0 || b.runs == 0 || (a.runs == 1 && b.runs == 1)) return std::nullopt;
  // The variance of each mean. A single run has that of one run of the other side.
  const double one_a = a.runs > 1 ? a.deviation : b.deviation;
  const double one_b = b.runs > 1 ? b.deviation : a.deviation;
  const auto n_a = static_cast<double>(a.runs), n_b = static_cast<double>(b.runs);
  const double var_a = one_a * one_a / n_a, var_b = one_b * one_b / n_b, var = var_a + var_b;
  const double apart = std::abs(b.mean - a.mean);
  if (var == 0) return apart == 0 ? 1.0 : 0.0;
  // Welch (1947), with the degrees of freedom of Satterthwaite (1946).
  double freedom = (a.runs > 1 ? n_a : n_b) - 1;
  if (a.runs > 1 && b.runs > 1)
    freedom = var * var / (var_a * var_a / (n_a - 1) + var_b * var_b / (n_b - 1));
  return 2 * (1 - statistics::student_cdf(apart / std::sqrt(var), freedom));
}

bool SeedsCompared::is_beyond_scatter() const {
  const std::optional<double> p = chance();
  return p && *p < significant;
}

bool ImpactCompared::is_beyond_scatter() const {
  return b_over_a.is_beyond_scatter() || m_lr.is_beyond_scatter() || period_h.is_beyond_scatter();
}

Compared compare(const ComparedSide& a, const ComparedSide& b) {
  const bool like_with_like = a.settings.empty() && b.settings.empty();
  const Places ours = places_of(a, like_with_like), theirs = places_of(b, like_with_like);
  Compared all;
  for (const auto& [place, runs] : ours) {
    const auto other = theirs.find(place);
    if (other == theirs.end())
      ++all.only_a;
    else
      all.impacts.push_back(compared(runs, other->second));
  }
  all.only_b = theirs.size() - all.impacts.size();
  if (all.impacts.empty() && like_with_like) refuse(a, b);
  return all;
}

}  // namespace eerie::comparison
