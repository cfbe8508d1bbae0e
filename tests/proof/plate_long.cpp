#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/proof/plate.hpp"
#include "tests/proof/record.hpp"

namespace eerie::proof {
namespace {

TEST(ElasticPlateLong, SwingsWithThePeriodOfTheoryFreeAndClamped) {
  Record record(
      "validation", 60, "Oscillating plate",
      fmt::format(
          "A plate 0.2 m long and 0.02 m thick (E 2 MPa, rho 1000 kg/m^3, nu 0.3975) in its "
          "gravest bending oscillation, in plane strain. It is free (half of it, at a slip "
          "wall) or clamped by a rough wall. Thin-plate theory gives {:.4f} and {:.3f} s; "
          "shear and rotary inertia add {:.1f} and {:.1f} %.",
          thin_plate_period(Support::free), thin_plate_period(Support::clamped),
          100 * thickness_correction(Support::free), 100 * thickness_correction(Support::clamped)));
  Figure figure{"plate",
                "Period over that of theory (with shear and rotary inertia)",
                "particles over the thickness",
                "period / theory",
                {},
                "set xrange [3:13]"};
  const auto series = [&](Support support, double artificial_stress, const char* name,
                          const std::vector<int>& layers) {
    Curve curve{name, {}, {}, "linespoints pt 7 ps 0.5"};
    double drift = 0;
    for (const int n : layers) {
      const Oscillation o = plate_oscillation(support, n, artificial_stress);
      curve.x.push_back(n);
      curve.y.push_back(o.period / thin_plate_period(support) /
                        (1 + thickness_correction(support)));
      drift = std::max(drift, o.z_drift);
    }
    record.within(fmt::format("{}: motion out of the plane, spacings", name), drift, 0, 1e-3,
                  "plane strain is kept by symmetry; noise must not grow");
    figure.curves.push_back(curve);
    return curve;
  };
  const Curve free = series(Support::free, 0, "free", {4, 6, 8, 12});
  const Curve stressed = series(Support::free, 0.3, "free, artificial stress 0.3", {6, 8, 12});
  const Curve clamped = series(Support::clamped, 0, "clamped", {4, 6, 8});
  const Curve both = series(Support::clamped, 0.3, "clamped, artificial stress 0.3", {6, 8});
  for (const Curve* c : {&free, &clamped})
    for (std::size_t k = 1; k < c->x.size(); ++k) {
      const double h = 1.2 / c->x[k];
      record.within(fmt::format("{}, {:g} layers: period over theory", c->title, c->x[k]), c->y[k],
                    1 - 3 * h * h, 1 + 3 * h * h,
                    "smoothing takes a share of order (h/H)^2 of the stiffness: three times that");
    }
  record.within("free, from 8 and 12 layers to infinitely many: period over theory",
                (144 * free.y[3] - 64 * free.y[2]) / 80, 0.99, 1.01,
                "with an error of order (h/H)^2 alone nothing is left");
  record.within(
      "free: longer with artificial stress, 12 layers", stressed.y[2] / free.y[3], 1, 1.075,
      "it takes at most 0.3 of the tension, which is half of the bending stress: 0.3/4 of "
      "the period");
  record.within("clamped, artificial stress, 8 layers: period, s",
                both.y[1] * thin_plate_period(Support::clamped) *
                    (1 + thickness_correction(Support::clamped)),
                0.254, 0.284,
                "published SPH plates have 0.27 to 0.28 s (Gray, Monaghan & Swift "
                "2001 and others), thin-plate theory 0.254 s");
  record.noted("free, 4 layers: period over theory", free.y[0], "1",
               "four particles over the thickness are too few to bend");
  record.figure(figure);
}

}  // namespace
}  // namespace eerie::proof
