#include "analysis/disk/drag.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "solver/base/constants.hpp"
#include "solver/base/error.hpp"

namespace eerie::disk {
namespace {
using testing::HasSubstr;
using testing::ThrowsMessage;

Nebula at_au(double r) { return hayashi_nebula(r * astronomical_unit); }

double dimensionless(const Nebula& n, const Drag& drag) { return n.omega_k * drag.stopping_time; }

/// d ln t_s / d ln s by Weidenschilling's drag.
double slope_over_size(double r_au, double radius) {
  const Nebula n = at_au(r_au);
  constexpr double step = 1.0001;
  return std::log(weidenschilling_drag(n, {radius * step, 2700}).stopping_time /
                  weidenschilling_drag(n, {radius / step, 2700}).stopping_time) /
         (2 * std::log(step));
}

TEST(DragCoefficient, GivesStokesForceInSlowFlow) {
  constexpr double s = 3, v = 0.2, rho = 1.5, viscosity = 700;  // Re = 2 s v / nu, small
  const double force = drag_coefficient(2 * s * v / viscosity) * pi * s * s * rho * v * v / 2;
  EXPECT_NEAR(force, 6 * pi * rho * viscosity * s * v, 1e-9 * force);
}

TEST(DragCoefficient, NeverJumpsNorRises) {
  double last = drag_coefficient(1e-3);
  for (double reynolds = 1e-3; reynolds < 1e5; reynolds *= 1.001) {
    const double c = drag_coefficient(reynolds);
    EXPECT_LE(c, last);
    EXPECT_GT(c, 0.9985 * last) << reynolds;  // the steepest piece falls as 1/Re
    last = c;
  }
  EXPECT_EQ(last, 0.44);
}

TEST(DragCoefficient, BelongsToTheRegimeThatIsNamed) {
  EXPECT_EQ(fluid_regime(0.5), DragRegime::stokes);
  EXPECT_EQ(fluid_regime(2), DragRegime::intermediate);
  EXPECT_EQ(fluid_regime(780), DragRegime::intermediate);
  EXPECT_EQ(fluid_regime(800), DragRegime::newton);
  EXPECT_DOUBLE_EQ(drag_coefficient(0.5), 48);
  EXPECT_NEAR(drag_coefficient(32), 3, 1e-12);  // 24 / 2^3
}

TEST(WeidenschillingDrag, ScalesWithSizeAsEachLawDoes) {
  const struct {
    double r_au, radius, slope;
    DragRegime regime;
  } cases[] = {{30, 100, 1, DragRegime::epstein},
               {5, 5, 2, DragRegime::stokes},
               {5, 100, 1.6, DragRegime::intermediate},
               {0.5, 100, 1, DragRegime::newton}};
  for (const auto& c : cases) {
    const Drag drag = weidenschilling_drag(at_au(c.r_au), {c.radius, 2700});
    EXPECT_EQ(drag.regime, c.regime) << name(c.regime);
    EXPECT_NEAR(slope_over_size(c.r_au, c.radius), c.slope, 1e-6) << name(c.regime);
    const Drag light = weidenschilling_drag(at_au(c.r_au), {c.radius, 900});
    EXPECT_NEAR(drag.stopping_time / light.stopping_time, 3, 1e-9);
  }
}

TEST(WeidenschillingDrag, IsPiRhoSOverTwoSigmaInEpsteinsRegime) {
  const Nebula n = at_au(30);
  const double expected = pi / 2 * 2700 * 100 / n.gas_surface_density;
  EXPECT_NEAR(dimensionless(n, weidenschilling_drag(n, {100, 2700})), expected, 1e-9 * expected);
}

TEST(WeidenschillingDrag, LeavesEpsteinsRegimeAtNineFourthsOfTheMeanFreePath) {
  const Nebula n = at_au(10);
  const double edge = 9.0 / 4 * n.mean_free_path;
  const Drag below = weidenschilling_drag(n, {edge * (1 - 1e-9), 2700});
  const Drag above = weidenschilling_drag(n, {edge * (1 + 1e-9), 2700});
  EXPECT_EQ(below.regime, DragRegime::epstein);
  EXPECT_EQ(above.regime, DragRegime::stokes);
  EXPECT_NEAR(above.stopping_time / below.stopping_time, 1, 1e-7);
}

TEST(WeidenschillingDrag, IsContinuousFromPebblesToPlanetesimalsAndOverTheDisk) {
  constexpr double step = 1.001;
  const double steepest = std::pow(step, 2.01);  // Stokes: s^2
  for (const double r : {0.3, 1.0, 5.0, 20.0, 100.0}) {
    const Nebula n = at_au(r);
    double last = weidenschilling_drag(n, {0.01, 2700}).stopping_time;
    for (double s = 0.01 * step; s < 1e5; s *= step) {
      const double t = weidenschilling_drag(n, {s, 2700}).stopping_time;
      EXPECT_GT(t, last) << r << " AU, " << s << " m";
      EXPECT_LT(t, steepest * last) << r << " AU, " << s << " m";
      last = t;
    }
  }
  double last = weidenschilling_drag(at_au(0.1), {}).stopping_time;
  for (double r = 0.1 * step; r < 500; r *= step) {
    const double t = weidenschilling_drag(at_au(r), {}).stopping_time;
    EXPECT_LT(std::abs(std::log(t / last)), std::log(std::pow(step, 3.1))) << r;  // r^3 at most
    last = t;
  }
}

TEST(PublishedDrag, IsEquation6AsPrinted) {
  // Sec. 4.1, Eq. (6): 2.2e1 r^(3/2), 3.6e3 r^(-1/4), 1.8e3 r^(5/4), for r in AU.
  const struct {
    double r_au, t_s_omega;
    DragRegime regime;
  } cases[] = {{25, 2.2e1 * 125, DragRegime::epstein},
               {16, 3.6e3 / 2, DragRegime::stokes},
               {1, 1.8e3, DragRegime::newton},
               {0.0625, 1.8e3 / 32, DragRegime::newton}};
  for (const auto& c : cases) {
    const Drag drag = published_drag(at_au(c.r_au));
    EXPECT_NEAR(dimensionless(at_au(c.r_au), drag), c.t_s_omega, 1e-9 * c.t_s_omega);
    EXPECT_EQ(drag.regime, c.regime);
  }
}

TEST(PublishedDrag, StepsByLittleWhereItsPiecesMeet) {
  const auto step_at = [](double r) {
    return published_drag(at_au(r * (1 + 1e-9))).stopping_time /
           published_drag(at_au(r * (1 - 1e-9))).stopping_time;
  };
  EXPECT_NEAR(step_at(1.6), 0.988, 0.001);
  EXPECT_NEAR(step_at(19), 1.057, 0.001);
}

TEST(PublishedDrag, HasTheSlopesOfWeidenschillingsLawsButNotOfStokes) {
  // Between its edges the paper's "Stokes law" goes as r^(-1/4). That is the slope of
  // C_D = 24 Re^-0.6; Stokes' own, C_D = 24/Re, has r^(-5/4).
  const auto slope = [](double r, double s, DragRegime regime) {
    const Nebula inner = at_au(r), outer = at_au(1.01 * r);
    const Drag a = weidenschilling_drag(inner, {s, 2700}),
               b = weidenschilling_drag(outer, {s, 2700});
    EXPECT_EQ(a.regime, regime);
    EXPECT_EQ(b.regime, regime);
    return std::log(dimensionless(outer, b) / dimensionless(inner, a)) / std::log(1.01);
  };
  EXPECT_NEAR(slope(30, 100, DragRegime::epstein), 1.5, 1e-9);
  EXPECT_NEAR(slope(5, 100, DragRegime::intermediate), -0.25, 1e-9);
  EXPECT_NEAR(slope(5, 5, DragRegime::stokes), -1.25, 1e-9);
  EXPECT_NEAR(slope(0.5, 100, DragRegime::newton), 1.25, 1e-9);
}

TEST(PublishedDrag, IsRefusedForBodiesThatItIsNotAbout) {
  EXPECT_EQ(drag_of(DragLaw::published, at_au(1), {100, 2700}).regime, DragRegime::newton);
  const auto ask = [] { drag_of(DragLaw::published, at_au(1), {50, 2700}); };
  EXPECT_THAT(ask, ThrowsMessage<InputError>(HasSubstr("not 50 m")));
  EXPECT_NO_THROW(drag_of(DragLaw::weidenschilling, at_au(1), {50, 2700}));
}

TEST(DragLaw, IsReadByTheNameThatItIsWrittenWith) {
  for (const DragLaw law : {DragLaw::published, DragLaw::weidenschilling})
    EXPECT_EQ(drag_law(name(law)), law);
  EXPECT_THROW(drag_law("stokes"), InputError);
}

}  // namespace
}  // namespace eerie::disk
