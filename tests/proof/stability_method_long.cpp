#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/proof/impact.hpp"
#include "tests/proof/lab.hpp"
#include "tests/proof/record.hpp"

namespace eerie::proof {
namespace {

using nlohmann::json;
constexpr drawing::Literal dots = "linespoints lw 2 pt 7 ps 0.4";

/// The reference impact at 500 per target, started close, to 4,000 s.
ImpactEnd short_impact(json changes) {
  changes["impact"]["separation"] = 1.3;
  return followed(impact_scene(500, changes), 4000);
}

TEST(OpeningAngle, ChangesLengthsAndNotTheAngularMomentum) {
  Record record("stability", 20, "Opening angle of the tree",
                "Monopole and quadrupole of nodes smaller than theta times their distance. The net "
                "force and torque of the tree are taken off, so the angular momentum does not know "
                "theta: what it drifts by is of gravity's extrapolation in time. Lengths tell.");
  Curve drift{"drift of L", {}, {}, dots},
      length{"|length / that of the direct sum - 1|", {}, {}, dots};
  double direct = 0, at_default = 0;
  for (const double theta : {0.0, 0.2, 0.35, 0.5, 0.7, 0.9, 1.2}) {
    const ImpactEnd end = short_impact({{"numerics", {{"opening_angle", theta}}}});
    ASSERT_FALSE(end.failed);
    if (theta == 0) direct = end.largest().shape.a;
    if (theta == 0.35) at_default = end.angular_momentum_drift;
    if (theta == 0) continue;
    drift.x.push_back(theta), drift.y.push_back(end.angular_momentum_drift);
    length.x.push_back(theta);
    length.y.push_back(std::abs(end.largest().shape.a / direct - 1) + 1e-6);
  }
  record.within("drift of L at the default, 0.35", at_default, 0, 1e-3,
                "what a whole impact may lose");
  record.within("drift of L at 1.2 over that at 0.35", drift.y.back() / at_default, 0.9, 1.1,
                "no net torque, whatever theta");
  record.figure({"opening-angle",
                 "Length and drift of L",
                 "theta",
                 "",
                 {drift, length},
                 "set logscale y; set format y '10^{%T}'; set arrow from 0.35, graph 0 to 0.35, "
                 "graph 1 nohead dt 2"});
}

/// A box of fluid under pressure, stirred by a third of a spacing, comes to rest: mean distance of
/// nearest neighbours and the fraction of particles with one nearer than half a spacing.
struct Spacing {
  double nearest = 0, paired = 0;
};
Spacing after_stirring(const char* kernel, double h_over_spacing) {
  constexpr double side = 8;
  json walls = json::array();
  for (const char* low : {"x_low", "y_low", "z_low"}) walls.push_back(wall(low, 0));
  for (const char* high : {"x_high", "y_high", "z_high"}) walls.push_back(wall(high, side));
  const Scene scene = lab_scene({{"environment", {{"walls", walls}}},
                                 {"material",
                                  {{"rho0_kg_per_m3", 1000},
                                   {"eos", "linear"},
                                   {"linear", {{"bulk_modulus_Pa", 1000}}},
                                   {"rheology", "fluid"}}},
                                 {"numerics", {{"kernel", kernel}}}});
  step::Solver solver(
      scene, lattice_block({0, 0, 0}, {side, side, side}, 1, 1050, {}, h_over_spacing, 0.3));
  while (solver.state().time < 100) solver.cycle(100);  // twelve crossings of the box
  Spacing s;
  const std::vector<Vec3>& x = solver.state().x;
  const auto n = static_cast<double>(x.size());
  for (const Vec3& a : x) {
    double nearest2 = side * side;
    for (const Vec3& b : x)
      if (&a != &b) nearest2 = std::min(nearest2, norm2(a - b));
    s.nearest += std::sqrt(nearest2) / n;
    s.paired += (nearest2 < 0.25) / n;
  }
  return s;
}

TEST(Neighbours, PairUnderTheCubicSplineBeyondItsRange) {
  Record record("stability", 21, "Kernel and number of neighbours",
                "A box of 512 particles of fluid under pressure, stirred by a third of a spacing, "
                "comes to rest. The cubic spline pushes less below distances of 2h/3, so with too "
                "many neighbours particles pair (Dehnen & Aly 2012); under Wendland kernels they "
                "do not.");
  Figure figure{"pairing",
                "Mean distance of nearest neighbours (dashed: default)",
                "h / spacing",
                "nearest / spacing",
                {},
                "set yrange [0.5:1.05]; set arrow from 1.2, graph 0 to 1.2, "
                "graph 1 nohead dt 2"};
  for (const char* kernel : {"cubic-spline", "wendland-c2"}) {
    Curve curve{kernel, {}, {}, dots};
    for (const double h : {1.0, 1.2, 1.4, 1.6, 1.8, 2.0}) {
      const Spacing s = after_stirring(kernel, h);
      curve.x.push_back(h), curve.y.push_back(s.nearest);
      const std::string what = fmt::format("paired fraction, {}, h = {:g} spacings", kernel, h);
      if (h == 1.2) record.within(what, s.paired, 0, 0.005, "58 neighbours: inside the range");
      if (h == 1.6)
        record.noted(what, s.paired, "0",
                     "137 neighbours, beyond the 55 to 67 of the cubic spline");
    }
    figure.curves.push_back(curve);
  }
  record.figure(figure);
}

TEST(Viscosity, TradesPenetrationAgainstDamping) {
  Record record("stability", 22, "Artificial viscosity",
                "The impact, and a fast head-on one (1 m/s, a third of the sound speed, to 400 "
                "s). Too little viscosity lets particles of one body fly into the other; too much "
                "takes the load of friction and keeps the pair short. The dual force leaves it no "
                "torque: spin is safe at any alpha. Here alpha is that of the particles' own h; "
                "the default, the viscosity of 50,000 particles, is 0.18 (the line).");
  Curve length{"length / 400 m", {}, {}, dots}, share{"viscous share of heat", {}, {}, dots},
      mixed{"mixed particles", {}, {}, dots}, drift{"drift of L x 1000", {}, {}, dots};
  double mixed_at_default = 0, mixed_at_one = 0;
  for (const double alpha : {0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 1.0, 1.5, 2.0}) {
    const json viscosity = {{"viscosity_particles", 0},
                            {"viscosity_alpha", alpha},
                            {"viscosity_beta", 2 * alpha},
                            {"cfl", 0.3}};
    const ImpactEnd end =
        short_impact({{"numerics", viscosity}, {"material", {{"energy", "integrated"}}}});
    if (!end.failed) {
      length.x.push_back(alpha), length.y.push_back(end.largest().shape.a / 400);
      share.x.push_back(alpha);
      share.y.push_back(end.last.viscous_heat / (end.last.viscous_heat + end.last.friction_heat));
      drift.x.push_back(alpha), drift.y.push_back(1000 * end.angular_momentum_drift);
    }
    double intruders = 0;
    const Scene fast = impact_scene(
        500, {{"numerics", viscosity},
              {"impact", {{"separation", 1.3}, {"v_imp_cm_per_s", 100}, {"theta_imp_deg", 0}}}});
    const ImpactEnd collision = followed(fast, 400, 1, [&](const step::Solver& solver) {
      const particles::State& s = solver.state();
      for (std::size_t i = 0; i < s.size(); ++i) {
        std::size_t nearest = i == 0 ? 1 : 0;
        for (std::size_t j = 0; j < s.size(); ++j)
          if (j != i && norm2(s.x[j] - s.x[i]) < norm2(s.x[nearest] - s.x[i])) nearest = j;
        intruders += s.body[i] != s.body[nearest];
      }
      intruders /= static_cast<double>(s.size());
    });
    if (!collision.failed) mixed.x.push_back(alpha), mixed.y.push_back(intruders);
    if (alpha == 0.2) mixed_at_default = intruders;
    if (alpha == 1) mixed_at_one = intruders;
  }
  record.within("particles nearest to one of the other body, alpha 1, 1 m/s head-on", mixed_at_one,
                0, 0.25, "those of the contact face, N^(-1/3) of all twice over");
  record.noted("the same, alpha 0.2", mixed_at_default, "0 to 0.25",
               "such a fast impact wants more viscosity than the default's; guards warn from a "
               "fifth of the sound speed on");
  record.figure({"viscosity",
                 "Impacts against alpha (beta = 2 alpha)",
                 "alpha",
                 "",
                 {length, share, mixed, drift},
                 "set logscale x; set yrange [0:1.5]; set arrow from 0.18, graph 0 to 0.18, graph "
                 "1 nohead dt 2"});
}

TEST(ListSkin, CostsTimeAndChangesNothing) {
  Record record("stability", 23, "Skin of the neighbour lists",
                "Lists hold pairs up to 2h (1 + skin) and are rebuilt before an unlisted pair can "
                "meet, so no skin makes a wrong sum; only last digits differ. One run each on a "
                "noisy machine.");
  std::vector<std::vector<std::string>> rows;
  double reference = 0, seconds = 0, largest = 0;
  for (const double skin : {0.1, 0.0, 0.02, 0.05, 0.2, 0.4}) {
    const ImpactEnd end = short_impact({{"numerics", {{"list_skin", skin}}}});
    ASSERT_FALSE(end.failed);
    if (reference == 0) reference = end.largest().shape.a, seconds = end.cpu_seconds;
    largest = std::max(largest, std::abs(end.largest().shape.a / reference - 1));
    rows.push_back({fmt::format("{:g}", skin), fmt::format("{:.3f}", end.list_builds / end.steps),
                    fmt::format("{:.2f}", end.cpu_seconds / seconds),
                    fmt::format("{:.1f}", end.largest().shape.a)});
  }
  record.table({"skin", "builds per step", "time over default", "length, m"}, rows);
  record.within("largest change of length", largest, 0, 0.05,
                "rounding grows in a chaotic body, up to the scatter between seeds");
}

TEST(Precision, OfPairSumsDoesNotShow) {
  Record record("stability", 24, "Single against double precision in pair sums",
                "The state is double; rows of pair sums are kept relative to their bucket. Four "
                "seeds.");
  std::vector<std::vector<std::string>> rows;
  double largest = 0, low = 1e9, high = 0, drift = 0;
  for (const int seed : {1, 2, 3, 4}) {
    double lengths[2];
    int k = 0;
    for (const char* precision : {"float", "double"}) {
      const ImpactEnd end =
          short_impact({{"numerics", {{"precision", precision}, {"seed", seed}}}});
      ASSERT_FALSE(end.failed);
      lengths[k++] = end.largest().shape.a;
      drift = std::max(drift, end.angular_momentum_drift);
    }
    rows.push_back({std::to_string(seed), fmt::format("{:.1f}", lengths[0]),
                    fmt::format("{:.1f}", lengths[1])});
    largest = std::max(largest, std::abs(lengths[0] - lengths[1]));
    low = std::min(low, lengths[1]), high = std::max(high, lengths[1]);
  }
  record.table({"seed", "length float, m", "length double, m"}, rows);
  record.within("largest difference over the spread of seeds", largest / (high - low), 0, 0.5,
                "float must stay well inside what the seed does");
  record.within("largest drift of L", drift, 0, 1e-3, "what a whole impact may lose");
}

TEST(CorrectionMatrix, IsMissedMostWhereItIsLeftOut) {
  Record record("stability", 25, "The correction matrix",
                "L = C^-1 where det C > 0.01, else the identity: single particles, pairs, chains "
                "and loose sheets have no gradient to correct. A full neighbourhood with a "
                "singular C (trace C above 1.8; impacts reach 1.2) stops the run.");
  Curve alone{"uncorrected fraction", {}, {}, "lines lw 2"};
  for (const char* gradient : {"corrected", "corrected-rate", "plain"}) {
    const Scene scene = impact_scene(
        500, {{"numerics", {{"gradient", gradient}}}, {"impact", {{"separation", 1.3}}}});
    const ImpactEnd end = followed(scene, 4000, 100, [&](const step::Solver& solver) {
      if (gradient != std::string("corrected")) return;
      alone.x.push_back(solver.state().time);
      alone.y.push_back(static_cast<double>(solver.uncorrected()) /
                        static_cast<double>(solver.state().size()));
    });
    ASSERT_FALSE(end.failed);
    const std::string what = std::string("drift of L, ") + gradient;
    if (gradient == std::string("corrected"))
      record.within(what, end.angular_momentum_drift, 0, 1e-3, "what a whole impact may lose");
    else
      record.noted(what, end.angular_momentum_drift, "below 1e-3",
                   "the reason for the correction in rate and force");
    record.noted(std::string("length, ") + gradient + ", m", end.largest().shape.a, "", "");
  }
  record.figure({"uncorrected",
                 "Particles without a correction matrix",
                 "time (s)",
                 "fraction",
                 {alone},
                 "set yrange [0:0.5]"});
}

}  // namespace
}  // namespace eerie::proof
