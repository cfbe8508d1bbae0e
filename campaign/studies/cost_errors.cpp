#include "campaign/studies/cost_errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>

#include "campaign/results/run_statistics.hpp"
#include "campaign/sweeps/fidelity.hpp"
#include "campaign/text/csv.hpp"

namespace eerie::studies {

namespace {

using Runs = results::RunGroup<CostRun>;
using Quantity = std::function<std::optional<double>(const CostResult&)>;

/// Everything that deviations are made of: results by setting and case.
class Comparison {
 public:
  Comparison(const CostStudy& study, const std::vector<CostResult>& results)
      : cases_(study.cases.size()), reference_(study.settings.size() - 1) {
    for (std::size_t s = 0; s <= reference_; ++s)
      for (std::size_t c = 0; c < cases_; ++c) runs_.push_back(runs_with(results, s, c));
  }

  const Runs& runs(std::size_t setting, std::size_t one) const {
    return runs_[setting * cases_ + one];
  }
  /// The cases that a setting has results of.
  std::vector<std::size_t> cases(std::size_t setting) const {
    std::vector<std::size_t> there;
    for (std::size_t c = 0; c < cases_; ++c)
      if (!runs(setting, c).empty()) there.push_back(c);
    return there;
  }
  bool is_whole(std::size_t setting) const { return cases(setting).size() == cases_; }

  /// `relative`: differences in parts of the reference's mean.
  Deviation deviation(std::size_t setting, const Quantity& quantity, bool relative = false) const {
    double squares = 0, noise = 0;
    int cases = 0;
    for (std::size_t c = 0; c < cases_; ++c) {
      const statistics::Ensemble here = results::ensemble_of(runs(setting, c), quantity);
      const statistics::Ensemble there = results::ensemble_of(runs(reference_, c), quantity);
      if (here.runs == 0 || there.runs == 0) continue;
      const double unit = relative ? there.mean : 1;
      const double spread = pooled_deviation(c, quantity) / unit;
      const double difference = (here.mean - there.mean) / unit;
      squares += difference * difference;
      if (setting != reference_)
        noise += spread * spread *
                 (1 / static_cast<double>(here.runs) + 1 / static_cast<double>(there.runs));
      ++cases;
    }
    if (cases == 0) return {};
    return {std::sqrt(squares / cases), std::sqrt(noise / cases)};
  }

  double mean_over_cases(std::size_t setting, const std::function<double(const Runs&)>& f) const {
    double sum = 0;
    for (const std::size_t c : cases(setting)) sum += f(runs(setting, c));
    return sum / static_cast<double>(cases(setting).size());
  }

  double class_agreement(std::size_t setting) const {
    double sum = 0;
    for (const std::size_t c : cases(setting)) {
      const std::string expected = most_frequent_class(runs(reference_, c));
      const auto alike = std::ranges::count_if(runs(setting, c), [&](const CostResult* r) {
        return r->row.result.outcome_class == expected;
      });
      sum += static_cast<double>(alike) / static_cast<double>(runs(setting, c).size());
    }
    return sum / static_cast<double>(cases(setting).size());
  }

  double p_any_eer_error(std::size_t setting) const {
    double sum = 0;
    for (const std::size_t c : cases(setting))
      sum += std::abs(p_any_eer(setting, c) - p_any_eer(reference_, c));
    return sum / static_cast<double>(cases(setting).size());
  }

 private:
  double p_any_eer(std::size_t setting, std::size_t c) const {
    return results::p_eer(runs(setting, c), results::EerAmong::any);
  }

  static std::string most_frequent_class(const Runs& runs) {
    std::map<std::string, int> counts;
    for (const CostResult* r : runs) ++counts[r->row.result.outcome_class];
    return std::ranges::max_element(counts, {}, [](const auto& entry) { return entry.second; })
        ->first;
  }

  /// Of single runs about the mean of their setting.
  double pooled_deviation(std::size_t one, const Quantity& quantity) const {
    double squares = 0, freedom = 0;
    for (std::size_t s = 0; s <= reference_; ++s) {
      const statistics::Ensemble e = results::ensemble_of(runs(s, one), quantity);
      if (e.runs < 2) continue;
      squares += e.deviation * e.deviation * static_cast<double>(e.runs - 1);
      freedom += static_cast<double>(e.runs - 1);
    }
    return freedom > 0 ? std::sqrt(squares / freedom) : 0;
  }

  std::size_t cases_, reference_;
  std::vector<Runs> runs_;
};

double truth(const CostPoint& point) {
  return std::max(point.b_over_a.error, point.b_over_a.noise);
}

void mark_frontier(std::vector<CostPoint>& points) {
  for (CostPoint& point : points) {
    if (!point.whole) continue;
    double cheapest = point.core_seconds;
    for (const CostPoint& other : points)
      if (other.whole && truth(other) <= truth(point))
        cheapest = std::min(cheapest, other.core_seconds);
    point.cost_over_frontier = point.core_seconds / cheapest;
    point.frontier = point.cost_over_frontier <= 1;
  }
}

}  // namespace

results::RunGroup<CostRun> runs_with(const std::vector<CostResult>& results, std::size_t setting,
                                     std::size_t case_index) {
  results::RunGroup<CostRun> runs;
  for (const CostResult& r : results)
    if (r.run.setting == setting && r.run.case_index == case_index) runs.push_back(&r);
  return runs;
}

std::vector<CostPoint> cost_points(const CostStudy& study, const std::vector<CostResult>& results) {
  const Comparison all(study, results);
  const std::size_t reference = study.settings.size() - 1;
  std::vector<CostPoint> points;
  if (!all.is_whole(reference)) return points;
  for (std::size_t s = 0; s < study.settings.size(); ++s) {
    if (all.cases(s).empty()) continue;
    CostPoint p;
    p.setting = s;
    p.whole = all.is_whole(s);
    for (const std::size_t c : all.cases(s)) {
      p.runs += all.runs(s, c).size();
      p.cases += (p.cases.empty() ? "" : ", ") + study.cases[c].name;
    }
    p.core_seconds = all.mean_over_cases(s, [](const Runs& runs) {
      return results::ensemble_of(runs, results::core_seconds_of).mean;
    });
    p.particle_steps = all.mean_over_cases(s, [](const Runs& runs) {
      return results::ensemble_of(
                 runs,
                 [](const CostResult& r) { return std::optional(r.row.result.particle_steps); })
          .mean;
    });
    p.b_over_a = all.deviation(s, results::of_largest(&db::Remnant::b_over_a));
    p.c_over_a = all.deviation(s, results::of_largest(&db::Remnant::c_over_a));
    p.m_1 = all.deviation(s, results::largest_mass);
    p.period = all.deviation(s, results::of_largest(&db::Remnant::spin_period_h), true);
    p.class_agreement = all.class_agreement(s);
    p.p_any_eer_error = all.p_any_eer_error(s);
    points.push_back(p);
  }
  mark_frontier(points);
  return points;
}

std::string cost_csv(const CostStudy& study, const std::vector<CostPoint>& points) {
  std::string csv =
      "knob,setting,cases,runs,core_s,particle_steps,b_over_a_error,b_over_a_noise,c_over_a_error,"
      "c_over_a_noise,m_1_over_m_total_error,m_1_over_m_total_noise,period_relative_error,"
      "period_relative_noise,class_agreement,p_any_eer_error,frontier,cost_over_frontier,set\n";
  for (const CostPoint& p : points) {
    const CostStudy::Setting& s = study.settings[p.setting];
    csv += fmt::format("{},{},{},{},{:.4g},{:.4g}", text::csv_quoted(s.knob),
                       text::csv_quoted(s.label), text::csv_quoted(p.cases), p.runs, p.core_seconds,
                       p.particle_steps);
    for (const Deviation& d : {p.b_over_a, p.c_over_a, p.m_1, p.period})
      csv += fmt::format(",{:.3g},{:.3g}", d.error, d.noise);
    csv += fmt::format(
        ",{:.3g},{:.3g},{},{},{}\n", p.class_agreement, p.p_any_eer_error, p.frontier ? 1 : 0,
        p.whole ? fmt::format("{:.3g}", p.cost_over_frontier) : "", text::csv_quoted(s.set.dump()));
  }
  return csv;
}

std::string cost_runs_csv(const CostStudy& study, const std::vector<CostResult>& results) {
  std::string csv = "knob,setting,case,seed,class,settled,ended_at_s,end_reason" +
                    results::remnant_header("") + results::run_end_header;
  for (const CostResult& r : results) {
    const CostStudy::Setting& s = study.settings[r.run.setting];
    const db::Result& x = r.row.result;
    csv +=
        fmt::format("{},{},{},{},{},{},{},{}", text::csv_quoted(s.knob), text::csv_quoted(s.label),
                    study.cases[r.run.case_index].name, r.run.seed, x.outcome_class,
                    x.settled ? 1 : 0, text::csv_number(x.ended_at_s), x.end_reason);
    csv += results::remnant_fields(r.remnants) + results::run_end_fields(r.row, r.core_seconds);
  }
  return csv;
}

namespace {

/// The fidelity that a setting is, if any; a knob that turns something else leaves it nameless.
std::string fidelity_of_setting(const CostStudy& study, const std::vector<CostRun>& runs,
                                std::size_t setting) {
  const auto is_part = [](const std::string& path) {
    return path.starts_with("numerics.") || path.starts_with("end.");
  };
  for (const auto& [path, value] : study.settings[setting].set.items())
    if (!is_part(path)) return "";
  const auto run = std::ranges::find(runs, setting, &CostRun::setting);
  return std::string(sweeps::fidelity_of(to_json(run->scene)));
}

std::string reference_words(const CostStudy& study) {
  const auto found = std::ranges::find(study.settings, reference_knob, &CostStudy::Setting::knob);
  return found == study.settings.end() ? "none" : found->label;
}

}  // namespace

figures::AccuracyFigure cost_figure(const CostStudy& study, const std::vector<CostPoint>& points) {
  figures::AccuracyFigure figure{
      {"b/a", "c/a", "mass of the largest / all", "period, relative"},
      {},
      fmt::format("{}: error against cost, {} impacts; reference: {}", study.name,
                  study.cases.size(), reference_words(study))};
  const std::vector<CostRun> runs = runs_of(study);
  for (const CostPoint& p : points) {
    const CostStudy::Setting& s = study.settings[p.setting];
    if (s.knob == reference_knob) continue;
    if (figure.series.empty() || figure.series.back().name != s.knob)
      figure.series.push_back({s.knob, s.knob == default_knob, {}});
    figures::AccuracyPoint point{
        s.label, p.core_seconds, {}, p.whole, fidelity_of_setting(study, runs, p.setting)};
    for (const Deviation& d : {p.b_over_a, p.c_over_a, p.m_1, p.period})
      point.errors.push_back({d.error, d.noise});
    figure.series.back().points.push_back(std::move(point));
  }
  return figure;
}

}  // namespace eerie::studies
