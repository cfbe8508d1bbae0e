#include "campaign/auto_fidelity/certainty.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/remnants/remnants.hpp"
#include "analysis/statistics/ensemble.hpp"
#include "analysis/statistics/student.hpp"

namespace eerie::auto_fidelity {

namespace {

statistics::Ensemble shapes(std::span<const Sample> samples) {
  std::vector<double> values;
  for (const Sample& sample : samples)
    if (sample.b_over_a) values.push_back(*sample.b_over_a);
  return statistics::ensemble(values);
}

/// The most frequent class and how many have it.
std::pair<std::string, double> leading(std::span<const Sample> samples) {
  std::map<std::string, double> counts;
  for (const Sample& sample : samples) ++counts[sample.outcome];
  return *std::ranges::max_element(counts, {}, [](const auto& entry) { return entry.second; });
}

/// Of one run, from the ensemble and prior_runs runs' worth of `deviation`.
double pooled_variance(const statistics::Ensemble& e, double deviation) {
  const double freedom = static_cast<double>(e.runs) - 1;
  return (prior_runs * deviation * deviation + freedom * e.deviation * e.deviation) /
         (prior_runs + freedom);
}

double support(const ClassShares& neighbours, const std::string& outcome) {
  const auto share = neighbours.find(outcome);
  return share == neighbours.end() ? 0 : neighbour_runs * share->second;
}

}  // namespace

double Answer::confidence() const {
  return std::min(p_outcome, std::max(p_elongated, 1 - p_elongated));
}

Answer answer_of(std::span<const Sample> samples, double deviation, const Transfer& transfer,
                 const ClassShares& neighbours) {
  const auto [outcome, count] = leading(samples);
  const auto all = static_cast<double>(samples.size());
  const double s = support(neighbours, outcome);
  Answer verdict{outcome, (count + s + 0.5) / (all + s + 1)};
  const statistics::Ensemble e = shapes(samples);
  if (e.runs == 0) return verdict;
  const auto n = static_cast<double>(e.runs);
  const double freedom = prior_runs + n - 1, variance = pooled_variance(e, deviation);
  const double scale = std::sqrt(variance * (1 + 1 / n) + transfer.scatter * transfer.scatter);
  verdict.b_over_a = e.mean;
  verdict.p_elongated =
      n / all *
      statistics::student_cdf((remnants::eer_max_b_over_a - e.mean - transfer.shift) / scale,
                              freedom);
  return verdict;
}

double best_p_outcome(std::span<const Sample> samples, std::size_t most,
                      const ClassShares& neighbours) {
  const auto [outcome, count] = leading(samples);
  const double others = static_cast<double>(samples.size()) - count;
  const double s = support(neighbours, outcome);
  return (static_cast<double>(most) - others + s + 0.5) / (static_cast<double>(most) + s + 1);
}

double best_p_side(std::span<const Sample> samples, double deviation, std::size_t most,
                   const Transfer& transfer) {
  const statistics::Ensemble e = shapes(samples);
  if (e.runs == 0) return 1;
  const double variance = pooled_variance(e, deviation);
  const double error = std::sqrt(variance / static_cast<double>(e.runs));
  const auto n = static_cast<double>(most);
  return statistics::student_cdf(
      (std::abs(e.mean + transfer.shift - remnants::eer_max_b_over_a) + error) /
          std::sqrt(variance * (1 + 1 / n) + transfer.scatter * transfer.scatter),
      prior_runs + n - 1);
}

std::string leading_class(std::span<const Sample> samples) { return leading(samples).first; }

ClassShares class_shares(std::span<const Sample> samples) {
  ClassShares shares;
  for (const Sample& sample : samples)
    shares[sample.outcome] += 1 / static_cast<double>(samples.size());
  return shares;
}

double typical_deviation(std::span<const std::vector<Sample>> ensembles, double prior) {
  std::vector<std::pair<double, double>> deviations = {{prior, prior_runs}};  // and their weights
  double weight = prior_runs;
  for (const std::vector<Sample>& samples : ensembles) {
    const statistics::Ensemble e = shapes(samples);
    if (e.runs < 2 || leading(samples).second < static_cast<double>(samples.size())) continue;
    const auto freedom = static_cast<double>(e.runs - 1);
    // The median of chi squared after Wilson & Hilferty (1931).
    const double median = std::pow(1 - 2 / (9 * freedom), 1.5);
    deviations.emplace_back(e.deviation / median, freedom);
    weight += freedom;
  }
  std::ranges::sort(deviations);
  double below = 0;
  for (const auto& [deviation, freedom] : deviations)
    if ((below += freedom) >= weight / 2) return deviation;
  return prior;
}

Transfer transfer_between(std::span<const Both> impacts, double prior) {
  std::vector<double> differences;
  for (const Both& one : impacts) {
    const statistics::Ensemble coarse = shapes(one.coarse), fine = shapes(one.fine);
    if (coarse.runs > 0 && fine.runs > 0) differences.push_back(fine.mean - coarse.mean);
  }
  const statistics::Ensemble e = statistics::ensemble(differences);
  const auto n = static_cast<double>(e.runs);
  const double shift = n * e.mean / (n + prior_runs);
  double squares = prior_runs * prior * prior;
  for (const double d : differences) squares += (d - shift) * (d - shift);
  return {shift, std::sqrt(squares / (n + prior_runs))};
}

}  // namespace eerie::auto_fidelity
