#include "solver/sph/stress.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/particles/state.hpp"
#include "solver/sph/kernel.hpp"
#include "tests/support/particles.hpp"

namespace eerie::sph {
namespace {

using test::difference;
using test::largest_entry;

constexpr double h = 1.2;

/// Moment matrix C and uncorrected velocity gradient G of each particle of unit volume.
struct Gradients {
  std::vector<SymTensor> C;
  std::vector<Mat3> G;
};
template <class Kernel = CubicSpline>
Gradients gradients(const std::vector<Vec3>& x, const std::vector<Vec3>& v) {
  Gradients out{std::vector<SymTensor>(x.size()), std::vector<Mat3>(x.size())};
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = 0; j < x.size(); ++j) {
      const Vec3 dx = x[i] - x[j], dv = v[i] - v[j];
      const double q = norm(dx) / h;
      if (i == j || q >= 2) continue;
      const Vec3 w = Kernel::dw_over_q(q, 1 / q) * Kernel::normalisation / std::pow(h, 5) * dx;
      out.C[i] +=
          SymTensor{-w.x * dx.x, -w.y * dx.y, -w.z * dx.z, -w.x * dx.y, -w.x * dx.z, -w.y * dx.z};
      for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b) out.G[i][a][b] -= dv[a] * w[b];
    }
  return out;
}

std::vector<Vec3> linear_field(const std::vector<Vec3>& x, const Mat3& A) {
  std::vector<Vec3> v;
  for (const Vec3& p : x) v.push_back(Vec3{0.3, -0.1, 0.2} + A * p);
  return v;
}

Mat3 spin_of(const Vec3& omega) {
  return {{{0, -omega.z, omega.y}, {omega.z, 0, -omega.x}, {-omega.y, omega.x, 0}}};
}

SymTensor rotated(const SymTensor& S, const Mat3& R) {
  const Mat3 m = R * to_matrix(S) * transpose(R);
  return {m[0][0], m[1][1], m[2][2], m[0][1], m[0][2], m[1][2]};
}

double size_of(const SymTensor& s) { return std::sqrt(contract(s)); }

TEST(CorrectedGradient, IsExactForLinearFieldsUpToTheSurface) {
  Random random(1, 0);
  const std::vector<Vec3> x = test::glass_ball(500);
  const Mat3 A = test::random_matrix(random);
  const Gradients g = gradients(x, linear_field(x, A));
  double corrected = 0, plain_inside = 0, plain_surface = 0;
  const double radius = std::cbrt(3. * 500 / (4 * pi));
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Mat3 L = to_matrix(correction_matrix(g.C[i]));
    corrected = std::max(corrected, largest_entry(difference(g.G[i] * L, A)));
    double& plain = norm(x[i]) < radius - 2 * h ? plain_inside : plain_surface;
    plain = std::max(plain, largest_entry(difference(g.G[i], A)));
  }
  EXPECT_LT(corrected, 1e-12);    // rounding, with condition numbers below a hundred
  EXPECT_GT(plain_surface, 0.3);  // half the neighbours are missing there
  EXPECT_GT(plain_inside, 1e-3);  // and disorder alone spoils the interior
  EXPECT_LT(plain_inside, 0.3);
}

/// Largest rate of deviatoric stress that rigid rotation makes in an unstressed ball, over 2 G
/// omega.
template <class Correction>
double stress_from_rotation(Correction&& correction) {
  const std::vector<Vec3> x = test::glass_ball(500);
  const Vec3 omega{0.3, -0.4, 1.2};
  const Gradients g = gradients(x, linear_field(x, spin_of(omega)));
  double largest = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    largest =
        std::max(largest, size_of(stress_rate({}, g.G[i] * to_matrix(correction(g.C[i])), 1)));
  return largest / (2 * norm(omega));
}

TEST(CorrectedGradient, RigidRotationMakesNoStress) {
  EXPECT_LT(stress_from_rotation(correction_matrix<double>), 1e-12);  // rounding, as above
}

TEST(CorrectedGradient, WithoutItRigidRotationMakesStress) {
  EXPECT_GT(stress_from_rotation([](const SymTensor&) { return SymTensor{1, 1, 1, 0, 0, 0}; }),
            0.1);
}

TEST(CorrectionMatrix, InvertsTheMomentsWhereThereAreEnough) {
  const SymTensor C{0.9, 1.1, 0.8, 0.1, -0.05, 0.2};
  EXPECT_LT(
      largest_entry(difference(to_matrix(correction_matrix(C)) * to_matrix(C), Mat3::identity())),
      1e-14);
}

TEST(CorrectionMatrix, FallsBackToTheIdentityForAPlaneALineOrNobody) {
  const SymTensor one{1, 1, 1, 0, 0, 0};
  std::vector<Vec3> plane, line, tilted;
  const Mat3 R = test::rotation(Vec3{2, 1, 2} / 3, 0.8);
  for (int a = -3; a <= 3; ++a) {
    line.push_back({1.0 * a, 0, 0});
    for (int b = -3; b <= 3; ++b) plane.push_back({1.0 * a, 1.0 * b, 0});
  }
  for (const Vec3& p : plane) tilted.push_back(R * p);
  for (const auto& x :
       {plane, line, tilted, std::vector<Vec3>{{0, 0, 0}}, std::vector<Vec3>{{0, 0, 0}, {1, 1, 0}}})
    for (const SymTensor& C : gradients(x, x).C) EXPECT_EQ(correction_matrix(C), one) << x.size();
}

TEST(CorrectionMatrix, ShowsWhereMatterIsFrayed) {
  EXPECT_TRUE(is_frayed(to_single(correction_matrix(SymTensor{}))));  // no neighbours
  EXPECT_TRUE(is_frayed(to_single(correction_matrix(SymTensor{1, 1, 1e-3, 0, 0, 0}))));  // a sheet
  EXPECT_TRUE(is_frayed(SymTensorf{1, 1, 8, 0, 0, 0}));
  EXPECT_FALSE(is_frayed(SymTensorf{1.001F, 0.999F, 1, 0, 0, 0}));  // inside a body
  EXPECT_FALSE(is_frayed(SymTensorf{1, 1, 2, 0, 0, 0}));            // on a flat surface
}

TEST(CorrectionMatrix, StaysBoundedThroughoutAThinSheet) {
  // From a plane to a thick slab: L never grows beyond what the smallest determinant allows.
  for (double thickness = 0; thickness < 1.5; thickness += 0.05) {
    std::vector<Vec3> x;
    for (int a = -3; a <= 3; ++a)
      for (int b = -3; b <= 3; ++b)
        for (const double z : {-thickness / 2, thickness / 2})
          if (thickness > 0 || z == 0) x.push_back({1.0 * a, 1.0 * b, z});
    for (const SymTensor& C : gradients(x, x).C)
      // |L| <= |C|^2 / det with eigenvalues of C of order 1.
      EXPECT_LT(size_of(correction_matrix(C)), 4 / smallest_correctable_determinant);
  }
}

TEST(StressRate, IsHookesLawForPureStrain) {
  constexpr double G = 7;
  const Mat3 g{{{0.3, 0.2, -0.1}, {0.2, -0.4, 0.5}, {-0.1, 0.5, 0.6}}};  // symmetric: no spin
  const SymTensor rate = stress_rate({1, 2, -3, 4, 5, 6}, g, G);
  const double third = (0.3 - 0.4 + 0.6) / 3;
  EXPECT_DOUBLE_EQ(rate.xx, 2 * G * (0.3 - third));
  EXPECT_DOUBLE_EQ(rate.yy, 2 * G * (-0.4 - third));
  EXPECT_DOUBLE_EQ(rate.zz, 2 * G * (0.6 - third));
  EXPECT_DOUBLE_EQ(rate.xy, 2 * G * 0.2);
  EXPECT_DOUBLE_EQ(rate.xz, 2 * G * -0.1);
  EXPECT_DOUBLE_EQ(rate.yz, 2 * G * 0.5);
}

TEST(StressRate, StaysADeviatorForAnyVelocityGradient) {
  Random random(2, 0);
  for (int n = 0; n < 100; ++n) {
    const SymTensor S = test::random_deviator(random);
    EXPECT_NEAR(trace(stress_rate(S, test::random_matrix(random), 3)), 0, 1e-13);  // rounding
  }
}

/// S after turning with the body by `angle` about `axis`, by the classical Runge-Kutta rule.
SymTensor turned_by_rate(SymTensor S, const Vec3& axis, double angle) {
  constexpr int steps = 200;
  const Mat3 g = spin_of(axis);
  const double dt = angle / steps;
  for (int n = 0; n < steps; ++n) {
    const SymTensor k1 = stress_rate(S, g, 1e6), k2 = stress_rate(S + 0.5 * dt * k1, g, 1e6),
                    k3 = stress_rate(S + 0.5 * dt * k2, g, 1e6),
                    k4 = stress_rate(S + dt * k3, g, 1e6);
    S += dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return S;
}

TEST(StressRate, StressTurnsWithARigidBody) {
  Random random(3, 0);
  for (int n = 0; n < 20; ++n) {
    const SymTensor S = test::random_deviator(random);
    const Vec3 axis = random.direction();
    const double angle = random.uniform(0.5, pi);
    const SymTensor exact = rotated(S, test::rotation(axis, angle));
    // Runge-Kutta of fourth order, 200 steps in which S turns by 2 * 0.016 rad at most:
    // 200 * 0.031^5 / 120 = 5e-8. The modulus of 1e6 shows that no strain is seen in rotation.
    EXPECT_LT(size_of(turned_by_rate(S, axis, angle) + (-1.0) * exact), 1e-7 * size_of(S));
    EXPECT_GT(size_of(turned_by_rate(S, axis, -angle) + (-1.0) * exact), 1e-2 * size_of(S));
  }
}

TEST(StressRate, DoesNotDependOnTheFrame) {
  Random random(5, 0);
  for (int n = 0; n < 50; ++n) {
    const SymTensor S = test::random_deviator(random);
    const Mat3 g = test::random_matrix(random), R = test::rotation(random.direction(), 1.1);
    const SymTensor turned = stress_rate(rotated(S, R), R * g * transpose(R), 2);
    EXPECT_LT(size_of(turned + (-1.0) * rotated(stress_rate(S, g, 2), R)), 1e-13);  // rounding
  }
}

TEST(Correction, OfDensityAndPressureIsThatOfAFlatSurfaceAndLeavesEdgesAlone) {
  const SymTensor face{2, 2, 2, 0, 0, 0}, edge{4, 4, 4, 0, 0, 0}, none{1, 1, 1, 0, 0, 0};
  EXPECT_EQ(moderate(face), face);
  EXPECT_EQ(moderate(edge), none);
}

TEST(Density, StaysPositiveHoweverFastItFallsAndIsSmooth) {
  EXPECT_EQ(particles::changed_density(2700, -10), 2690);
  EXPECT_EQ(particles::changed_density(2700, 10), 2710);
  EXPECT_NEAR(particles::changed_density(1000, -500), 500, 1e-9);
  EXPECT_NEAR(particles::changed_density(1000, -501) - particles::changed_density(1000, -499), -2,
              0.02);
  EXPECT_GT(particles::changed_density(1000, -1e9), 0);
}

}  // namespace
}  // namespace eerie::sph
