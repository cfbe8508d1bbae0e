#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace eerie::auto_fidelity {

/// What one run says about its impact.
struct Sample {
  std::string outcome;                  ///< class
  std::optional<double> b_over_a = {};  ///< of the largest remnant; nothing where there is none
  std::optional<double> core_seconds = {};
};

/// How b/a by one fidelity stands to that by a finer one: a shift and a scatter about it.
struct Transfer {
  double shift = 0, scatter = 0;
};

/// What an ensemble says about an impact.
struct Answer {
  std::string outcome;     ///< class of most runs
  double p_outcome = 0;    ///< that another run has it
  double b_over_a = 1;     ///< mean of the largest remnants
  double p_elongated = 0;  ///< that another, finer run has b/a < 0.3
  /// That the answers "which class" and "b/a < 0.3 or not" hold for another run; the smaller one.
  double confidence() const;
  bool in_doubt(double wanted) const { return confidence() < wanted; }
};

/// Prior knowledge counts as much as this many runs.
inline constexpr double prior_runs = 4;
/// Neighbours all of the same class count as so many runs of that class.
inline constexpr double neighbour_runs = 2;

/// The part of the runs at the neighbours of an impact that have each class.
using ClassShares = std::map<std::string, double>;

/// The class: k of n runs have it, (k + s + 1/2)/(n + s + 1), Jeffreys' rule with the support s of
/// the neighbours, neighbour_runs times the part of their runs that have this class: an impact
/// between others of its class is hardly ever of two kinds. Neighbours of another class say
/// nothing: some border lies there. b/a < 0.3: Student's predictive distribution of one more run,
/// its spread that of the ensemble and, as prior, that of others
/// (`deviation`, standard deviation of b/a), widened by the transfer. An impact without a remnant
/// is not elongated. `samples` must not be empty.
Answer answer_of(std::span<const Sample> samples, double deviation, const Transfer& transfer,
                 const ClassShares& neighbours = {});

/// p_outcome of `most` runs, were all that are still to come of the class that leads.
double best_p_outcome(std::span<const Sample> samples, std::size_t most,
                      const ClassShares& neighbours = {});

/// How sure the answer to b/a < 0.3 of a finer run could become with `most` runs of this spread,
/// were the mean of those that are there off by its standard error, away from 0.3.
double best_p_side(std::span<const Sample> samples, double deviation, std::size_t most,
                   const Transfer& transfer = {});

/// The class of most runs; the first by name of equals. `samples` must not be empty.
std::string leading_class(std::span<const Sample> samples);
ClassShares class_shares(std::span<const Sample> samples);

/// Standard deviation of b/a about the mean of its ensemble: the median over ensembles that agree
/// on their class, by their degrees of freedom, with prior_runs' worth of `prior`. The median,
/// since spreads differ tenfold from impact to impact, and a mean square would be that of the
/// widest.
double typical_deviation(std::span<const std::vector<Sample>> ensembles, double prior);

/// From impacts that both fidelities have runs of, with prior_runs runs' worth of no shift and the
/// scatter of `prior`.
struct Both {
  std::vector<Sample> coarse, fine;
};
Transfer transfer_between(std::span<const Both> impacts, double prior);

}  // namespace eerie::auto_fidelity
