#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace eerie::auto_fidelity {

/// The result of one run of an impact.
struct Sample {
  std::string outcome;                  ///< class
  std::optional<double> b_over_a = {};  ///< of the largest remnant; nothing where there is none
  std::optional<double> core_seconds = {};
};

/// The relation of b/a by one fidelity to b/a by a finer one: a shift, and a scatter about it.
struct Transfer {
  double shift = 0, scatter = 0;
};

/// The answer of an ensemble about an impact.
struct Answer {
  std::string outcome;     ///< class of most runs
  double p_outcome = 0;    ///< probability that another run has this class
  double b_over_a = 1;     ///< mean of the largest remnants
  double p_elongated = 0;  ///< probability that another, finer run has b/a < 0.3
  /// The smaller of two probabilities: that another run has this class, and that the answer to b/a
  /// < 0.3 holds for it.
  double confidence() const;
  bool in_doubt(double wanted) const { return confidence() < wanted; }
};

/// Prior knowledge has the weight of this many runs.
inline constexpr double prior_runs = 4;
/// Neighbours that all have one class count as this many runs of that class.
inline constexpr double neighbour_runs = 2;

/// The fraction of the runs at the neighbours of an impact that have each class.
using ClassShares = std::map<std::string, double>;

/// Computes the answer. Where k of n runs have the class, its probability is (k + s + 1/2)/(n + s +
/// 1). This is Jeffreys' rule with the support s of the neighbours, which is neighbour_runs times
/// the fraction of their runs in this class: an impact between others of its class rarely has two
/// classes. Neighbours of another class have no effect, since a border lies there. The probability
/// of b/a < 0.3 is Student's predictive distribution for one more run. Its spread is that of the
/// ensemble, with `deviation` (standard deviation of b/a) as prior, widened by the transfer. An
/// impact without a remnant is not elongated. `samples` must not be empty.
Answer answer_of(std::span<const Sample> samples, double deviation, const Transfer& transfer,
                 const ClassShares& neighbours = {});

/// p_outcome of `most` runs if all further runs have the leading class.
double best_p_outcome(std::span<const Sample> samples, std::size_t most,
                      const ClassShares& neighbours = {});

/// The confidence in the answer to b/a < 0.3 of a finer run that `most` runs of this spread could
/// reach, if the true mean is one standard error further from 0.3 than the present one.
double best_p_side(std::span<const Sample> samples, double deviation, std::size_t most,
                   const Transfer& transfer = {});

/// The class of most runs, the first by name among equals. `samples` must not be empty.
std::string leading_class(std::span<const Sample> samples);
ClassShares class_shares(std::span<const Sample> samples);

/// The typical standard deviation of b/a about the mean of its ensemble. It is the median over
/// ensembles that agree on their class, weighted by degrees of freedom, with `prior` weighted by
/// prior_runs. A mean square would be dominated by the widest ensemble, since spreads differ
/// tenfold from impact to impact.
double typical_deviation(std::span<const std::vector<Sample>> ensembles, double prior);

/// The runs of one impact by both fidelities.
struct Both {
  std::vector<Sample> coarse, fine;
};
/// The transfer from impacts with runs of both fidelities. No shift and the scatter `prior` have
/// the weight of prior_runs.
Transfer transfer_between(std::span<const Both> impacts, double prior);

}  // namespace eerie::auto_fidelity
