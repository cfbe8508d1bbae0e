#include "solver/initial/packing.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/base/error.hpp"
#include "solver/base/tensor.hpp"

namespace eerie::initial {
namespace {

constexpr double radius = 50;

std::vector<Vec3> packed(const char* packing, std::size_t n, std::uint64_t seed = 1) {
  Random random(seed, 0);
  return packed_sphere(packing, n, radius, random);
}
double spacing(std::size_t n) { return radius * std::cbrt(4 * pi / (3 * static_cast<double>(n))); }

double nearest_distance(const std::vector<Vec3>& x) {
  double nearest2 = 1e300;
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) nearest2 = std::min(nearest2, norm2(x[i] - x[j]));
  return std::sqrt(nearest2);
}

class Packing : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Every, Packing, testing::Values("glass", "lattice"),
                         [](const testing::TestParamInfo<const char*>& each) {
                           return std::string(each.param);
                         });

TEST_P(Packing, HasExactlyTheNumberAskedAboutTheOrigin) {
  for (const std::size_t n : {1u, 2u, 100u, 333u, 1000u}) {
    const std::vector<Vec3> x = packed(GetParam(), n);
    ASSERT_EQ(x.size(), n);
    Vec3 mean;
    for (const Vec3& p : x) mean += p / static_cast<double>(n);
    EXPECT_LT(norm(mean), 1e-12 * radius);  // rounding
  }
}

TEST_P(Packing, FillsTheSphereEvenly) {
  const std::size_t n = 3000;
  const std::vector<Vec3> x = packed(GetParam(), n);
  for (const double part : {0.5, 0.7, 0.85}) {
    double inside = 0;
    for (const Vec3& p : x) inside += norm(p) < part * radius;
    // Points of an even packing are counted to about the square root of those at the border,
    // n^(2/3): a few per cent. A random cloud would do no better, clumping in shells much worse.
    EXPECT_NEAR(inside / (static_cast<double>(n) * cubed(part)), 1, 0.06) << part;
  }
  double outermost = 0;
  for (const Vec3& p : x) outermost = std::max(outermost, norm(p));
  // Centres of the last cells lie about half a spacing below the surface, some of them on it.
  EXPECT_NEAR(outermost, radius, 0.5 * spacing(n));
}

TEST_P(Packing, FillsAnEllipsoidEvenlyAndNoFurther) {
  const std::size_t n = 3000;
  const BodyShape shape({0.5, 0.3, 25}, {0, 60, 40});
  Random random(1, 0);
  const std::vector<Vec3> x = packed_body(shape, GetParam(), n, radius, random);
  ASSERT_EQ(x.size(), n);
  for (const double part : {0.5, 0.7, 0.85}) {
    double inside = 0;
    for (const Vec3& p : x) inside += norm(shape.on_sphere(p)) < part * radius;
    EXPECT_NEAR(inside / (static_cast<double>(n) * cubed(part)), 1, 0.07) << part;
  }
  EXPECT_GT(nearest_distance(x),
            GetParam() == std::string("lattice") ? 1.1 * spacing(n) : 0.6 * spacing(n));
  for (int k = 0; k < 3; ++k) {
    double furthest = 0;
    for (const Vec3& p : x)
      furthest =
          std::max(furthest, std::abs(dot(p, shape.directions()[static_cast<std::size_t>(k)])));
    EXPECT_NEAR(furthest, shape.semi_axes()[k] * radius, spacing(n)) << k;
  }
}

TEST_P(Packing, SidesAreEquallyFull) {
  const std::size_t n = 3000;
  SymTensor moment;
  for (const Vec3& p : packed(GetParam(), n))
    moment += SymTensor{p.x * p.x, p.y * p.y, p.z * p.z, p.x * p.y, p.x * p.z, p.y * p.z};
  const double third = trace(moment) / 3;
  // <x^2> of a homogeneous sphere is R^2/5; graininess at the surface, about 1 %.
  EXPECT_NEAR(third / static_cast<double>(n) / (radius * radius / 5), 1, 0.02);
  for (const double axis : {moment.xx, moment.yy, moment.zz}) EXPECT_NEAR(axis / third, 1, 0.02);
  for (const double off : {moment.xy, moment.xz, moment.yz}) EXPECT_NEAR(off / third, 0, 0.02);
}

TEST_P(Packing, NoTwoPointsAreClose) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    // Face-centred cubic: 1.12 spacings; a random cloud of 1,000 has pairs at 0.1.
    EXPECT_GT(nearest_distance(packed(GetParam(), 1000, seed)), 0.6 * spacing(1000));
  }
}

TEST_P(Packing, SameSeedGivesTheSameBitsAndOthersOtherPoints) {
  EXPECT_EQ(packed(GetParam(), 300, 7), packed(GetParam(), 300, 7));
  EXPECT_NE(packed(GetParam(), 300, 7), packed(GetParam(), 300, 8));
}

TEST_P(Packing, LargeSpheresTileWithoutSeams) {
  // 12,000 points are wider than the periodic cube of the glass.
  const std::size_t n = 12000;
  const std::vector<Vec3> x = packed(GetParam(), n);
  EXPECT_GT(nearest_distance(x), 0.6 * spacing(n));
  double inside = 0;
  for (const Vec3& p : x) inside += norm(p) < 0.7 * radius;
  EXPECT_NEAR(inside / (static_cast<double>(n) * cubed(0.7)), 1, 0.03);  // border counting
}

/// Steinhardt's global bond order Q_6: 0 where bonds point anywhere, 0.575 in one fcc crystal.
/// By the addition theorem Q_6^2 is the mean of P_6(cos) over all pairs of bonds.
double bond_order(const std::vector<Vec3>& x, double bond_length) {
  std::vector<Vec3> bonds;
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Vec3 d = x[i] - x[j];
      if (norm(d) < bond_length) bonds.push_back(d / norm(d));
    }
  double sum = 0;
  for (const Vec3& a : bonds)
    for (const Vec3& b : bonds) {
      const double c2 = dot(a, b) * dot(a, b);
      sum += (((231 * c2 - 315) * c2 + 105) * c2 - 5) / 16;
    }
  return std::sqrt(sum) / static_cast<double>(bonds.size());
}

TEST(Glass, PrefersNoDirectionWhereALatticeDoes) {
  const std::size_t n = 600;
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    // About 3,500 bonds at random directions have Q_6 = 1/sqrt(3500) = 0.02.
    EXPECT_LT(bond_order(packed("glass", n, seed), 1.35 * spacing(n)), 0.1);
    EXPECT_GT(bond_order(packed("lattice", n, seed), 1.35 * spacing(n)), 0.5);
  }
}

TEST(Glass, StopsAtOnceWhenItIsToldTo) {
  Random random(1, 0);
  int asked = 0;
  EXPECT_THROW(packed_sphere("glass", 600, 1, random, [&] { return ++asked == 3; }),
               PackingStopped);
  EXPECT_EQ(asked, 3);
}

TEST(Glass, IsTheSameWhetherAStopIsAskedForOrNot) {
  Random one(1, 0), other(1, 0);
  const std::vector<Vec3> x = packed_sphere("glass", 600, 1, one);
  const std::vector<Vec3> y = packed_sphere("glass", 600, 1, other, [] { return false; });
  for (std::size_t i = 0; i < x.size(); ++i)
    for (int k = 0; k < 3; ++k) EXPECT_EQ(x[i][k], y[i][k]);
}

TEST(Packing, UnknownNameIsRefused) {
  Random random(1, 0);
  EXPECT_THROW(packed_sphere("crate", 10, 1, random), InputError);
}

}  // namespace
}  // namespace eerie::initial
