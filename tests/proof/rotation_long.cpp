#include <gtest/gtest.h>

#include "tests/proof/record.hpp"
#include "tests/proof/rotation.hpp"

namespace eerie::proof {
namespace {

TEST(RotatingRigidBody, TurnsAHundredTimes) {
  Record record("validation", 31, "A rotating rigid body, 100 turns",
                "An elastic sphere on a lattice of 0.2 R turns freely, omega = (2 pi/100) c/R "
                "(the test of Sugiura's thesis). Rigid rotation must make no stress. The gradient "
                "is corrected in stress rate and force, in the rate only (as in the paper), or "
                "nowhere.");
  Figure figure{"rotation", "Angular momentum",     "turns", "L / L at the start",
                {},         "set yrange [-0.2:1.2]"};
  for (const char* gradient : {"corrected", "corrected-rate", "plain"}) {
    const Rotated r = rotated_sphere(gradient, 100);
    figure.curves.push_back({gradient, r.turns, r.angular_momentum});
    const std::string what = std::string("L, end over start, ") + gradient;
    if (std::string(gradient) == "corrected") {
      record.within(what, r.angular_momentum.back(), 0.97, 1.03,
                    "the correction in the force is one step old: 2e-4 a turn");
      record.within("spin rate, end over start", r.spin.back(), 0.97, 1.03,
                    "the body keeps its shape");
      record.within("radius, end over start", r.radius.back(), 0.99, 1.01,
                    "centrifugal stretch: rho omega^2 R^2/K = 0.004");
    } else {
      record.noted(what, r.angular_momentum.back(), "1",
                   "why the correction is there, and in the force too");
    }
  }
  record.figure(figure);
}

}  // namespace
}  // namespace eerie::proof
