#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "campaign/studies/convergence_results.hpp"

namespace eerie::studies {

/// How far means may be off to count as right: b/a, and mass of the largest remnant over all mass.
inline constexpr double b_over_a_within = 0.03, m_1_within = 0.05;

/// A quantity in the limit of small spacings, from a line in N^(-1/3).
struct Limit {
  double value, error;  ///< error: standard error of the line's intercept
};
/// Limits of b/a whose error is larger say nothing.
inline constexpr double known_limit = 0.1;

/// From which particle number on a scheme is right about one impact.
struct ParticlesNeeded {
  std::string case_name, scheme;
  std::int64_t finest = 0;  ///< the largest particle number that was run
  /// The least number from which on every mean is within the bounds above of that of the finest;
  /// nothing where there is no coarser one to compare.
  std::optional<std::int64_t> own;
  /// The same for what was published, the finest included, where more than half of the runs, or
  /// less, must have an EER as well; when that was measured, where the study says it. Nothing
  /// where the finest is not right.
  std::optional<std::int64_t> published;
  bool has_published = false;
  /// Largest standard error of the means of b/a that were compared, from the scatter of seeds at
  /// all particle numbers; nothing where no number has two runs. Where it is not well below
  /// `b_over_a_within`, being near or not is chance.
  std::optional<double> known_to;
  std::optional<Limit> b_over_a;  ///< from three particle numbers or more
};

/// Of every case and scheme with results, in the order of the study.
std::vector<ParticlesNeeded> particles_needed(const ConvergenceStudy& study,
                                              const std::vector<ConvergenceCell>& cells);
std::string particles_needed_csv(const std::vector<ParticlesNeeded>& needed);

}  // namespace eerie::studies
