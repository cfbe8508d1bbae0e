#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "solver/base/error.hpp"
#include "tests/proof/impact.hpp"
#include "tests/proof/record.hpp"
#include "tests/proof/resting_body.hpp"
#include "tests/proof/rotation.hpp"

namespace eerie::proof {
namespace {

constexpr double cfl_numbers[] = {0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.1, 1.2, 1.5};

TEST(TimeStep, HasAMarginBelowWhereBodiesCannotRest) {
  Record record("stability", 10, "Courant number",
                "dt = cfl h/(c_l + h |div v|) with the longitudinal wave c_l = 4.6 m/s, which "
                "holds the shear wave; by the bulk sound speed (3.1 m/s) the number is 0.68 times "
                "as large. A settled body of 500 particles is left alone for 3,000 s. Rest breaks "
                "long before blow-up: the integrator feeds the shortest waves faster than "
                "viscosity damps them, and jittering particles carry load by viscosity that "
                "friction does not feel.");
  Figure figure{
      "cfl",
      "Largest rms speed (10: the run failed)",
      "cfl",
      "rms speed / escape speed",
      {},
      "set logscale y; set format y '10^{%T}'; set arrow from 1.1, graph 0 to 1.1, graph 1 "
      "nohead dt 2"};
  for (const std::string integrator : {"staggered", "leapfrog-pece", "leapfrog"}) {
    Curve curve{integrator, {}, {}, "linespoints lw 2 pt 7 ps 0.4"};
    double largest_at_rest = 0;
    bool still = true;
    for (const double cfl : cfl_numbers) {
      const RestQuality q = rest_quality(
          impact_scene(500, {{"numerics", {{"cfl", cfl}, {"integrator", integrator}}}}), 3000);
      curve.x.push_back(cfl);
      curve.y.push_back(q.failed ? 10 : q.rms_speed);
      still = still && !q.failed && q.rms_speed < 1e-3;
      if (still) largest_at_rest = cfl;
    }
    figure.curves.push_back(curve);
    if (integrator == "staggered")
      record.within("largest cfl at rest, staggered", largest_at_rest, 1.1, 1.5,
                    "the default of 1.1 must be among them");
    else
      record.noted(fmt::format("largest cfl at rest, {}", integrator), largest_at_rest, "1.1",
                   "one evaluation a step, or two at one time, bear less");
  }
  const RestQuality q = rest_quality(impact_scene(500, {{"numerics", {{"cfl", 1.5}}}}), 3000);
  record.noted("rms speed / escape speed at 1.5, the largest of a scene", q.rms_speed, "below 1e-3",
               "without the shear wave in the criterion the default would be 1.61");
  record.figure(figure);
}

TEST(TimeStep, OfAnImpactMayBeTwiceTheDefaultBeforeTheAnswerMoves) {
  Record record("stability", 11, "Courant number in an impact",
                "The drift of angular momentum grows with the step, since the correction of the "
                "dual force is one step old.");
  Curve length{"length / that at cfl 0.2", {}, {}, "linespoints lw 2 pt 7 ps 0.4"},
      drift{"drift of L x 1000", {}, {}, "linespoints lw 2 pt 7 ps 0.4"};
  double reference = 0, at_default = 0;
  std::string failures;
  for (const double cfl : cfl_numbers) {
    const ImpactEnd end = followed(
        impact_scene(500, {{"numerics", {{"cfl", cfl}}}, {"impact", {{"separation", 1.3}}}}), 4000);
    if (end.failed) {
      failures += fmt::format("cfl {:g}: {}. ", cfl, end.failure);
      continue;
    }
    if (reference == 0) reference = end.largest().shape.a;
    const double relative = end.largest().shape.a / reference;
    length.x.push_back(cfl), length.y.push_back(relative);
    drift.x.push_back(cfl), drift.y.push_back(1000 * end.angular_momentum_drift);
    if (cfl == 1.1) at_default = relative;
  }
  record.within("length at the default over that at cfl 0.2", at_default, 0.95, 1.05,
                "below the scatter between seeds, 5 to 10 % at this resolution");
  record.say(failures.empty() ? "No run failed up to cfl 1.5." : "Runs that failed: " + failures);
  record.figure({"cfl-impact",
                 "Length and drift of L against cfl",
                 "cfl",
                 "",
                 {length, drift},
                 "set arrow from 1.1, graph 0 to 1.1, graph 1 nohead dt 2"});
}

TEST(TimeStep, BlowsUpWhereElasticSurfacesStiffenIt) {
  Record record("stability", 13, "Courant number of elastic material",
                "The freely turning elastic sphere over half a turn (error 1: the run failed or "
                "the body burst). Rubble does not blow up below the largest cfl of a scene (1.5), "
                "since its surface carries no stress. With the gradient corrected in rate and "
                "force the shortest waves of a surface are faster by the largest eigenvalue of L "
                "(2 on a face, 3.5 at a corner), which shortens the step. Else it would blow up "
                "between 0.25 and 0.5.");
  Figure figure{
      "cfl-elastic",
      "Error of the radius",
      "cfl",
      "|radius / start - 1|",
      {},
      "set logscale y; set format y '10^{%T}'; set arrow from 1.1, graph 0 to 1.1, graph 1 "
      "nohead dt 2"};
  for (const char* gradient : {"corrected", "corrected-rate"}) {
    Curve curve{gradient, {}, {}, "linespoints lw 2 pt 7 ps 0.4"};
    double largest_sound = 0;
    bool sound = true;
    for (const double cfl : cfl_numbers) {
      double error = 1;
      try {
        error =
            std::min(1.0, std::abs(rotated_sphere(gradient, 0.5, cfl).radius.back() - 1) + 1e-6);
      } catch (const NumericalError&) {
        // it burst: the error stays 1
      }
      curve.x.push_back(cfl), curve.y.push_back(error);
      sound = sound && error < 0.02;
      if (sound) largest_sound = cfl;
    }
    figure.curves.push_back(curve);
    record.within(std::string("largest sound cfl, ") + gradient, largest_sound, 1.1, 1.5,
                  "the default of 1.1 must be among them");
  }
  record.figure(figure);
}

TEST(GravityInterval, HasAMarginBelowWhereBodiesCannotRest) {
  Record record("stability", 12, "Gravity every k steps",
                "Gravity is evaluated every k steps of one dt and extrapolated linearly in "
                "between. A resting body of 500 particles over 6,000 s, and the impact. The "
                "dynamical time (665 s) is about 500 steps. By default k follows from "
                "`numerics.gravity_tolerance`: about 5 at the first approach, 25 at rest.");
  Curve rest{"rms speed / escape speed x 1000", {}, {}, "linespoints lw 2 pt 7 ps 0.4"},
      length{"length / that at k = 1", {}, {}, "linespoints lw 2 pt 7 ps 0.4"},
      drift{"drift of L x 1000", {}, {}, "linespoints lw 2 pt 7 ps 0.4"};
  double reference = 0;
  for (const int k : {1, 2, 5, 10, 20, 50, 100}) {
    const nlohmann::json change = {
        {"numerics", {{"gravity_interval", k}, {"gravity_tolerance", 0.1}}},
        {"impact", {{"separation", 1.3}}}};
    const RestQuality q = rest_quality(impact_scene(500, change), 6000);
    const ImpactEnd end = followed(impact_scene(500, change), 4000);
    ASSERT_FALSE(q.failed || end.failed) << k << q.failure << end.failure;
    if (reference == 0) reference = end.largest().shape.a;
    rest.x.push_back(k), rest.y.push_back(1000 * q.rms_speed);
    length.x.push_back(k), length.y.push_back(end.largest().shape.a / reference);
    drift.x.push_back(k), drift.y.push_back(1000 * end.angular_momentum_drift);
  }
  const Scene usual = impact_scene(500, {{"impact", {{"separation", 1.3}}}});
  const RestQuality q = rest_quality(usual, 6000);
  const ImpactEnd end = followed(usual, 4000);
  ASSERT_FALSE(q.failed || end.failed) << q.failure << end.failure;
  record.within("rms speed / escape speed at the default tolerance", q.rms_speed, 0, 1e-3,
                "bodies count as settled below 1e-3");
  record.within("length at the default tolerance over that at k = 1",
                end.largest().shape.a / reference, 0.95, 1.05, "below the scatter between seeds");
  record.within("drift of L at the default tolerance", end.angular_momentum_drift, 0, 2e-3,
                "below what moves a shape");
  record.figure({"gravity-interval",
                 "Rest and the reference impact against k",
                 "steps from one evaluation of gravity to the next",
                 "",
                 {rest, length, drift},
                 "set logscale x"});
}

}  // namespace
}  // namespace eerie::proof
