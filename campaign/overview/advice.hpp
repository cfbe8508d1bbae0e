#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "campaign/overview/estimate.hpp"
#include "campaign/text/table.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::overview {

/// What the impacts of a sweep would take, and how far a single run would err, at one fidelity.
struct Choice {
  std::string fidelity;
  std::int64_t particles_per_target = 0;
  int seeds = 1;              ///< as many as its question asks for
  double core_hours = 0;      ///< for that many seeds of every impact
  double b_over_a_error = 0;  ///< root mean square, of a single run; 0: not known
  double class_agrees = 0;    ///< part of single runs with the class of finer ones; 0: not known
};

/// Which settings for the impacts of a sweep?
struct Advice {
  std::size_t impacts = 0;      ///< that differ in more than seed, numerics and end
  std::vector<Choice> choices;  ///< cheapest first; without those of too few particles
  /// Of --fidelity auto: two runs of each impact on its first rung, and all that it may ask for.
  double auto_least_core_hours = 0, auto_most_core_hours = 0;
};
/// `scenes` are those of a sweep, `speed` that of the machine.
Advice advice(const std::vector<Scene>& scenes, double particle_steps_per_core_second);

text::Table table_of(const Advice& advice);

/// The finest choice that `cores` finish in `hours`; nothing where none does.
std::optional<Choice> finest_within(const Advice& advice, double hours, std::size_t cores);

}  // namespace eerie::overview
