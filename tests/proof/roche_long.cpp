#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/proof/record.hpp"
#include "tests/proof/roche.hpp"

namespace eerie::proof {
namespace {

TEST(RocheEllipsoidLong, IsWhatALiquidBodyTakesOnInATide) {
  Record record("validation", 42, "Liquid in the tide of a primary",
                "A liquid body of 4,000 particles keeps one side to a heavy primary far away "
                "(`environment.primary`). Theory: Roche's ellipsoids, which end where G M/d^3 is "
                "0.0901 pi G rho (Chandrasekhar 1969).");
  Figure figure{
      "roche", "Axes of a liquid body in a tide",       "G M / (π G ρ d³)", "ratio of axes",
      {},      "set xrange [0:0.1]\nset yrange [0.4:1]"};
  Curve b{"b/a, theory", {}, {}}, c{"c/a, theory", {}, {}};
  for (int k = 0; k <= 90; ++k) {
    const double tide = k / 1000.0;
    const RocheEllipsoid e = roche_ellipsoid(tide);
    b.x.push_back(tide), b.y.push_back(e.b_over_a);
    c.x.push_back(tide), c.y.push_back(e.c_over_a);
  }
  Curve b_is{"b/a, measured", {}, {}, "points pt 7", 1},
      c_is{"c/a, measured", {}, {}, "points pt 5", 2};
  for (const double tide : {0.02, 0.04, 0.06}) {
    const RocheEllipsoid theory = roche_ellipsoid(tide);
    const LiquidInTide is = liquid_in_tide(tide, 4000, 12000, 4000);
    record.within(fmt::format("b/a at {:g}, over theory", tide), is.b_over_a / theory.b_over_a,
                  0.97, 1.03, "h is 0.1 of the radius, and smears gravity over it");
    record.within(fmt::format("c/a at {:g}, over theory", tide), is.c_over_a / theory.c_over_a,
                  0.97, 1.03, "as above");
    record.within(fmt::format("longest axis off the line to the primary at {:g}, deg", tide),
                  is.off_deg, 0, 2, "nothing turns it away; it may swing a little");
    b_is.x.push_back(tide), b_is.y.push_back(is.b_over_a);
    c_is.x.push_back(tide), c_is.y.push_back(is.c_over_a);
  }
  const LiquidInTide torn = liquid_in_tide(0.12, 4000, 12000, 4000);
  record.within("half of the longest axis at 0.12, over the radius", torn.a_over_radius, 2, 100,
                "no figure of equilibrium exists; the last has 1.6");
  figure.curves = {b, c, b_is, c_is};
  record.figure(figure);
}

}  // namespace
}  // namespace eerie::proof
