#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "analysis/remnants/outcome.hpp"

namespace eerie::paper {

/// A series of Table 2 of Sugiura et al. (2019): all combinations of evenly spaced speeds and
/// angles.
struct PaperGrid {
  const char* name;
  double q, phi_d_deg;
  double v_from, v_to, v_step;              ///< cm/s
  double theta_from, theta_to, theta_step;  ///< deg

  std::string sweep() const { return std::string("sweeps/") + name + ".json"; }
};

/// All series of Table 2.
const std::vector<PaperGrid>& paper_grids();
/// The series of one mass ratio and friction angle.
std::vector<PaperGrid> paper_grids(double q, double phi_d_deg);

struct ImpactPoint {
  double v_imp_cm_per_s = 0, theta_imp_deg = 0;
};
/// The distinct points of some grids, sorted by angle and speed.
std::vector<ImpactPoint> points_of(const std::vector<PaperGrid>& grids);

/// A range of numbers, ends included.
struct Span {
  double low = 0, high = 0;
  bool holds(double value) const { return low - 1e-9 <= value && value <= high + 1e-9; }
};
struct Window {
  Span v, theta;
  bool holds(const ImpactPoint& p) const {
    return v.holds(p.v_imp_cm_per_s) && theta.holds(p.theta_imp_deg);
  }
};

enum class FactQuantity { b_over_a, period_h, mass_over_target, a_m, b_m };

// These are claims about one impact.

/// A number of the largest remnant or, with `smaller`, of the most massive EER among the other
/// remnants.
struct NumberIs {
  FactQuantity quantity;
  double value = 0;
  bool smaller = false;
};
/// The largest remnant holds at least 90 % of both bodies.
struct AlmostMerges {};
/// The largest remnant is still an EER at this time.
struct ShapeLasts {
  double until_s = 0;
};
/// A remnant other than the largest is an EER.
struct SmallerIsEer {};
/// b/a does not change with a stiffer equation of state.
struct StiffnessIsIdle {
  double stiffness = 10;
};

// These are claims about all impacts of grids.

/// The EERs lie around v sin(theta) = constant.
struct RidgeIsAt {
  double constant = 0;
};
/// There are EERs, and all of them are in the window.
struct EersOnlyIn {
  Window window;
};
struct NoEer {};
struct EersExactlyAt {
  std::vector<ImpactPoint> points;
};
/// Every largest remnant that is an EER holds at least 90 % of both bodies.
struct EersAreMerged {};
/// Smaller remnants are EERs at this many points, all in the window.
struct SmallerEersOnlyIn {
  std::size_t count = 0;
  Window window;
};
/// Near v sin(theta) = constant and in the window, most impacts have this class.
struct MostlyOfClass {
  remnants::OutcomeClass outcome;
  double constant = 0;
  Window window;
};
/// Merging, hit-and-run and catastrophic disruption all occur.
struct AllClassesOccur {};

using Claim = std::variant<NumberIs, AlmostMerges, ShapeLasts, SmallerIsEer, StiffnessIsIdle,
                           RidgeIsAt, EersOnlyIn, NoEer, EersExactlyAt, EersAreMerged,
                           SmallerEersOnlyIn, MostlyOfClass, AllClassesOccur>;

/// A claim of Sugiura et al. (2019) about impacts that a database of impacts can decide.
struct Fact {
  std::string name;       ///< short; letters, digits and dashes
  std::string statement;  ///< in our words
  std::string source;     ///< section, figure, table
  double q = 1, phi_d_deg = 40;
  std::optional<ImpactPoint> point = {};  ///< for claims about one impact
  std::vector<PaperGrid> grids = {};      ///< for claims about grids
  Claim claim;
};

const std::vector<Fact>& paper_facts();

}  // namespace eerie::paper
