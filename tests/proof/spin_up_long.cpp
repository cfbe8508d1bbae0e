#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "solver/base/constants.hpp"
#include "tests/proof/ellipsoid.hpp"
#include "tests/proof/record.hpp"
#include "tests/proof/spin_up.hpp"

namespace eerie::proof {
namespace {

/// Where matter at the equator has no weight left.
constexpr double W_weightless = 2.0 / 3;

double limit_of(double phi_d_deg) {
  return std::min(W_weightless, stability_limit(1, 1, 1, std::tan(radians(phi_d_deg))).fastest);
}

SpinUpOfSphere spun_up_at(double phi_d_deg) {
  const Scene scene = parse_scene({{"material", {{"drucker_prager", {{"phi_d_deg", phi_d_deg}}}}},
                                   {"numerics", {{"particles_per_target", 8000}}}});
  return spin_up_of_sphere(scene, 0.8 * limit_of(phi_d_deg), 1e5, 0.95, 10000);
}

TEST(SpinUpOfSpheres, DeformsThemInTheThreeWaysThatArePublished) {
  Record record(
      "validation", 44, "Spheres that are spun up",
      "Spheres of 8,000 particles are spun up until flattened by a twentieth, then left alone for "
      "1e4 s. Averaged stresses give the limit W = omega^2/(2 pi G rho); beyond a friction angle "
      "of 60 deg matter at the equator has lost its weight (W = 2/3) before the interior yields. "
      "Sugiura et al. (2021, Icarus 365, 114505) found three ways: slow flattening of the whole "
      "body below 40 deg, fast flattening of the whole body at 50 to 60 deg, landslides on the "
      "surface at 70 deg and more.");
  const std::string by_theory =
      "the limit of the averaged stresses, or of weight; edges of a particle are 0.05 R";
  for (const double phi : {30.0, 40.0, 50.0, 60.0, 70.0, 80.0}) {
    const SpinUpOfSphere is = spun_up_at(phi);
    const auto what = [&](const char* text) { return fmt::format("{}, {:g} deg", text, phi); };
    record.within(what("greatest W over the limit"), is.W_greatest / limit_of(phi), 0.9, 1.1,
                  by_theory);
    // A body that flattens by itself goes on by more than it had been flattened.
    const double goes_on = is.c_over_a - is.c_over_a_alone;
    if (phi <= 40)
      record.within(what("c/a that it loses alone"), goes_on, 0, 0.05, "slow: published");
    else
      record.within(what("c/a that it loses alone"), goes_on, 0.05, 0.5, "fast: published");
    const std::string interior = what("displacement inside over that of an even strain");
    const std::string halfway =
        "published; halfway between the whole body (1) and its surface alone (0)";
    if (phi <= 60)
      record.within(interior, is.interior, 0.5, 1.2, halfway);
    else if (phi == 70)
      record.noted(interior, is.interior, "at most 0.5, as published",
                   "layers that slide there are two particles thick");
    else
      record.within(interior, is.interior, 0, 0.5, halfway);
  }
}

}  // namespace
}  // namespace eerie::proof
