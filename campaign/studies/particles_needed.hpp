#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "campaign/studies/convergence_results.hpp"

namespace eerie::studies {

/// The largest error of a mean that counts as right: of b/a, and of the mass of the largest remnant
/// in units of all mass.
inline constexpr double b_over_a_within = 0.03, m_1_within = 0.05;

/// A quantity in the limit of small spacings, by a straight line in N^(-1/3).
struct Limit {
  double value, error;  ///< `error` is the standard error of the line's intercept
};
/// A limit of b/a with a larger error says nothing.
inline constexpr double known_limit = 0.1;

/// The particle number from which on a scheme is right about one impact.
struct ParticlesNeeded {
  std::string case_name, scheme;
  std::int64_t finest = 0;  ///< the largest particle number with runs
  /// The least particle number from which on every mean is within the bounds above of that of the
  /// finest. Nothing where there is no coarser number.
  std::optional<std::int64_t> own;
  /// The least particle number from which on every mean, the finest included, is within the bounds
  /// of the published numbers. More than half of the runs must have an EER where the published
  /// impact has one, and less than half otherwise. Runs are read at the time of the measurement
  /// where the study gives it. Nothing where the finest number is not right.
  std::optional<std::int64_t> published;
  bool has_published = false;
  /// The largest standard error of the compared means of b/a, by the scatter of seeds at all
  /// particle numbers. Nothing where no number has two runs. Unless it is well below
  /// `b_over_a_within`, agreement is chance.
  std::optional<double> known_to;
  std::optional<Limit> b_over_a;  ///< needs three particle numbers or more
};

/// The numbers for every case and scheme with results, in the order of the study.
std::vector<ParticlesNeeded> particles_needed(const ConvergenceStudy& study,
                                              const std::vector<ConvergenceCell>& cells);
std::string particles_needed_csv(const std::vector<ParticlesNeeded>& needed);

}  // namespace eerie::studies
