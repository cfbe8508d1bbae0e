// g++ 12 takes the undefined operands of its own AVX-512 headers for faults (GCC bug 105593).
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"

#include "solver/sph/pair_sums.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "solver/sph/stress.hpp"
#include "tests/support/particles.hpp"
#include "tests/support/variant_types.hpp"

namespace eerie::sph {
namespace {

/// What the sums are taken over: a disordered ball with every quantity of its own at each
/// particle, none of them smooth, so that a wrong index or sign shows.
struct Particles {
  std::vector<Vec3> x, v;
  std::vector<double> V, c;
  std::vector<Mat3> T;
  std::vector<SymTensor> R;   // artificial stress
  std::vector<double> h_of;   // smoothing lengths
  std::vector<SymTensorf> e;  // shear of the neighbourhood
  std::size_t size() const { return x.size(); }
};

constexpr double spacing = 8, h = 1.2 * spacing, mass = 2700 * spacing * spacing * spacing;

Particles random_particles(std::size_t n) {
  Random random(21, n);
  Particles p;
  p.x = test::glass_ball(n);
  for (Vec3& x : p.x) {
    x *= spacing;
    x += {300, -200, 100};  // away from the origin, as bodies on their orbit are
    p.v.push_back(Vec3{0.1, 0, -0.2} + 0.05 * random.direction());
    p.V.push_back(cubed(spacing) * random.uniform(0.9, 1.1));
    p.c.push_back(random.uniform(3, 4));
    p.T.push_back(test::random_matrix(random));
    p.R.push_back(test::random_tensor(random));
    p.h_of.push_back(h * random.uniform(0.8, 1));
    p.e.push_back(to_single(5e-3 * test::random_deviator(random)));
  }
  return p;
}

constexpr Viscosity viscosity{1, 2};

/// All neighbours of all particles, one pair after another, in double, as the equations stand.
template <class Kernel>
std::vector<NeighbourSums> all_pairs(const Particles& p, const Viscosity& visc,
                                     const ExtraTerms& extra = {}) {
  const auto slope_of = [](double r, double length) {
    const double q = r / length;
    return q >= 2 ? 0 : Kernel::dw_over_q(q, 1 / q) * Kernel::normalisation / std::pow(length, 5);
  };
  std::vector<NeighbourSums> sums(p.size());
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < p.size(); ++j) {
      const Vec3 dx = p.x[i] - p.x[j], dv = p.v[i] - p.v[j];
      const double r = norm(dx), q = r / h;
      if (i == j || q >= 2) continue;
      const double slope =
          extra.unlike_h ? (slope_of(r, p.h_of[i]) + slope_of(r, p.h_of[j])) / 2 : slope_of(r, h);
      const double h_ij = extra.unlike_h ? 2 * p.h_of[i] * p.h_of[j] / (p.h_of[i] + p.h_of[j]) : h;
      const Vec3 gradient = slope * dx;
      NeighbourSums& s = sums[i];
      s.C += -p.V[j] * SymTensor{gradient.x * dx.x, gradient.y * dx.y, gradient.z * dx.z,
                                 gradient.x * dx.y, gradient.x * dx.z, gradient.y * dx.z};
      double pair_pressure = 0, closing = -dot(dv, dx);
      if (extra.shear_free) {
        const SymTensor e = 0.5 * (to_double(p.e[i]) + to_double(p.e[j]));
        closing = std::min(closing, closing + dot(dx, to_matrix(e) * dx));
      }
      if (closing > 0) {
        const double mu = -h_ij * closing / (norm2(dx) + Viscosity::epsilon * h * h);
        const double rho = 2 * mass / (p.V[i] + p.V[j]);
        pair_pressure = rho * (-visc.alpha * (p.c[i] + p.c[j]) / 2 * mu + visc.beta * mu * mu);
      }
      s.viscous_pressure -= p.V[j] * pair_pressure * dot(dx, gradient) / 6;
      Mat3 R;
      if (extra.artificial_stress) {
        const double f = Kernel::w(q) / Kernel::w(extra.spacing / h);
        R = to_matrix((p.R[i] + p.R[j]) * (f * f * f * f));
      }
      for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b) {
          s.G[a][b] -= p.V[j] * dv[a] * gradient[b];
          const double pair_flux = R[a][b] - (a == b ? pair_pressure : 0);
          s.force[a] += p.V[j] * (p.T[i][a][b] + p.T[j][a][b] + pair_flux) * gradient[b];
          s.heat -= p.V[j] * dv[a] * pair_flux * gradient[b] / 2;
        }
    }
  return sums;
}

/// The sums of the code under test.
template <class Sums, Part part = Part::all>
std::vector<NeighbourSums> swept(const Particles& p, const Viscosity& visc, double skin = 0.1,
                                 const ExtraTerms& extra = {}) {
  tree::NeighbourList lists(2 * h, 2 * h * skin, {}, row_units<typename Sums::Number>);
  lists.build(test::fitted_tree(p.x), p.x);
  Sums sums(h, mass, visc, extra);
  sums.rows.resize(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (i % tree::bucket_size == 0) sums.rows.set_origin(i / tree::bucket_size, p.x[i], p.v[i]);
    sums.rows.set(i, p.x[i], p.v[i], p.V[i], p.c[i], rows_of(p.T[i]));
    if constexpr (part == Part::viscous) {
      sums.rows.set(i, p.x[i], -2 * p.v[i], p.V[i], p.c[i], {});
      sums.rows.set_velocity(i, p.v[i]);
    }
    if constexpr (Sums::sheared) sums.rows.set_shear(i, p.e[i]);
    if constexpr (Sums::extended) sums.rows.set_extra(i, p.R[i], p.h_of[i]);
  }
  std::vector<NeighbourSums> found(p.size());
  sums.template sweep<part>(lists, p.size(), [&](std::size_t i, std::size_t count, const auto& s) {
    for (std::size_t l = 0; l < count; ++l) found[i + l] = lane(s, l);
  });
  return found;
}

/// Largest difference over the largest value of each of the three sums.
struct Differences {
  double C = 0, G = 0, force = 0, heat = 0, viscous_pressure = 0;
};
Differences differences(const std::vector<NeighbourSums>& a, const std::vector<NeighbourSums>& b) {
  Differences d, scale;
  for (std::size_t i = 0; i < a.size(); ++i) {
    d.C = std::max(d.C, std::sqrt(contract(a[i].C + (-1.0) * b[i].C)));
    scale.C = std::max(scale.C, std::sqrt(contract(b[i].C)));
    d.G = std::max(d.G, test::largest_entry(test::difference(a[i].G, b[i].G)));
    scale.G = std::max(scale.G, test::largest_entry(b[i].G));
    d.force = std::max(d.force, norm(a[i].force - b[i].force));
    scale.force = std::max(scale.force, norm(b[i].force));
    d.heat = std::max(d.heat, std::abs(a[i].heat - b[i].heat));
    scale.heat = std::max(scale.heat, std::abs(b[i].heat));
    d.viscous_pressure =
        std::max(d.viscous_pressure, std::abs(a[i].viscous_pressure - b[i].viscous_pressure));
    scale.viscous_pressure = std::max(scale.viscous_pressure, std::abs(b[i].viscous_pressure));
  }
  return {d.C / scale.C, d.G / scale.G, d.force / scale.force, d.heat / scale.heat,
          d.viscous_pressure / scale.viscous_pressure};
}

template <class RealAndKernel>
class PairSumsTwin : public testing::Test {};
template <class Real_, class Kernel_>
struct Combo {
  using Real = Real_;
  using Kernel = Kernel_;
};
/// Each floating-point type with each kernel of the variant.
template <class Variant>
struct CombosOf;
template <class... Kernel>
struct CombosOf<std::variant<Kernel...>> {
  using type = testing::Types<Combo<float, Kernel>..., Combo<double, Kernel>...>;
};
struct NameCombo {
  template <class T>
  static std::string GetName(int) {
    const std::string real = std::is_same_v<typename T::Real, float> ? "float_" : "double_";
    return real + test::NameByToken::GetName<typename T::Kernel>(0);
  }
};
TYPED_TEST_SUITE(PairSumsTwin, CombosOf<KernelChoice>::type, NameCombo);

/// Sums of about sixty terms: rounding of the type; the softening of 1/r, 1e-12 h^2 in r^2, is
/// 1e-11 in double.
template <class T>
constexpr double tolerance = std::is_same_v<typename T::Real, float> ? 1e-5 : 1e-10;

TYPED_TEST(PairSumsTwin, EqualsTheSumOverAllPairs) {
  using Sums = PairSums<typename TypeParam::Real, typename TypeParam::Kernel>;
  for (const std::size_t n : {1u, 2u, 65u, 600u}) {
    const Particles p = random_particles(n);
    const auto exact = all_pairs<typename TypeParam::Kernel>(p, viscosity);
    for (const double skin : {0.0, 0.3}) {
      const auto found = swept<Sums>(p, viscosity, skin);
      if (n == 1) {
        EXPECT_EQ(found[0].force, Vec3{});
        continue;
      }
      const Differences d = differences(found, exact);
      EXPECT_LT(d.C, tolerance<TypeParam>) << n << " particles, skin " << skin;
      EXPECT_LT(d.G, tolerance<TypeParam>) << n << " particles, skin " << skin;
      EXPECT_LT(d.force, tolerance<TypeParam>) << n << " particles, skin " << skin;
    }
  }
}

TYPED_TEST(PairSumsTwin, ExtraTermsEqualTheSumOverAllPairs) {
  using Kernel = typename TypeParam::Kernel;
  using Sums = PairSums<typename TypeParam::Real, Kernel, Terms::all>;
  const Particles p = random_particles(600);
  for (int flags = 0; flags < 8; ++flags) {
    const ExtraTerms extra{(flags & 1) != 0, (flags & 2) != 0, spacing, (flags & 4) != 0};
    const auto exact = all_pairs<Kernel>(p, viscosity, extra);
    const Differences d = differences(swept<Sums>(p, viscosity, 0.1, extra), exact);
    // Fourth powers of the kernel make single terms larger than the sum: ten times the others.
    EXPECT_LT(std::max({d.C, d.G, d.force, d.heat, d.viscous_pressure}), 10 * tolerance<TypeParam>)
        << flags;
    // Each term counts: leaving it out shows.
    const Differences without = differences(all_pairs<Kernel>(p, viscosity), exact);
    EXPECT_EQ(without.force > 1e-3, flags != 0) << flags;
  }
}

TYPED_TEST(PairSumsTwin, PartsHaveTheBitsOfTheWhole) {
  using Sums = PairSums<typename TypeParam::Real, typename TypeParam::Kernel, Terms::shear_free>;
  const Particles p = random_particles(600);
  const auto whole = swept<Sums>(p, viscosity);
  const auto gradient = swept<Sums, Part::gradient>(p, viscosity);
  const auto force = swept<Sums, Part::force>(p, viscosity);
  for (std::size_t i = 0; i < p.size(); ++i) {
    EXPECT_EQ(contract(gradient[i].C + (-1.0) * whole[i].C), 0);
    EXPECT_EQ(test::largest_entry(test::difference(gradient[i].G, whole[i].G)), 0);
    EXPECT_EQ(force[i].force, whole[i].force);
  }
}

/// The forces that the sums of a part name as those of viscosity.
template <class Sums, Part part>
std::vector<NeighbourSums> brakes(const Particles& p) {
  std::vector<NeighbourSums> found = swept<Sums, part>(p, viscosity);
  for (NeighbourSums& s : found) s.force = {s.brake[0], s.brake[1], s.brake[2]};
  return found;
}

TYPED_TEST(PairSumsTwin, TheForceOfViscosityAloneEqualsTheSumOverAllPairs) {
  using Kernel = typename TypeParam::Kernel;
  using Basic = PairSums<typename TypeParam::Real, Kernel>;
  using ShearFree = PairSums<typename TypeParam::Real, Kernel, Terms::shear_free>;
  const Particles p = random_particles(600);
  Particles without_stress = p;
  std::ranges::fill(without_stress.T, Mat3{});
  const auto exact = all_pairs<Kernel>(without_stress, viscosity);
  EXPECT_LT(differences(brakes<Basic, Part::viscous>(p), exact).force, tolerance<TypeParam>);
  EXPECT_LT(differences(brakes<Basic, Part::force>(p), exact).force, tolerance<TypeParam>);
  const auto sheared = all_pairs<Kernel>(without_stress, viscosity, {false, false, 0, true});
  EXPECT_LT(differences(brakes<ShearFree, Part::viscous>(p), sheared).force, tolerance<TypeParam>);
}

TYPED_TEST(PairSumsTwin, ShearFreeViscosityEqualsTheSumOverAllPairs) {
  using Kernel = typename TypeParam::Kernel;
  using Sums = PairSums<typename TypeParam::Real, Kernel, Terms::shear_free>;
  const Particles p = random_particles(600);
  const auto exact = all_pairs<Kernel>(p, viscosity, {false, false, 0, true});
  const Differences d = differences(swept<Sums>(p, viscosity), exact);
  EXPECT_LT(std::max({d.C, d.G, d.force}), tolerance<TypeParam>);
}

/// Pressure and tangential stress that viscosity makes in a uniform shear.
template <class Sums>
double pressure_in_shear(double rate, double compression) {
  Particles p = random_particles(600);
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.v[i] = {rate * p.x[i].y - compression * p.x[i].x, -compression * p.x[i].y,
              -compression * p.x[i].z};
    p.T[i] = {};
    p.e[i] = to_single(SymTensor{0, 0, 0, rate / 2, 0, 0});
  }
  const auto sums = swept<Sums>(p, viscosity, 0.1, {false, false, 0, Sums::sheared});
  double largest = 0;
  for (const NeighbourSums& s : sums) largest = std::max(largest, norm(s.force));
  return largest;
}

/// Shear rates are kept in single precision.
TYPED_TEST(PairSumsTwin, ShearFreeViscosityLeavesUniformShearAloneAndStillBrakesContraction) {
  using Monaghan = PairSums<typename TypeParam::Real, typename TypeParam::Kernel>;
  using ShearFree =
      PairSums<typename TypeParam::Real, typename TypeParam::Kernel, Terms::shear_free>;
  const double of_monaghan = pressure_in_shear<Monaghan>(0.01, 0);
  EXPECT_GT(of_monaghan, 0);
  EXPECT_LT(pressure_in_shear<ShearFree>(0.01, 0), 1e-4 * of_monaghan);
  const double contraction = pressure_in_shear<Monaghan>(0, 0.01);
  EXPECT_NEAR(pressure_in_shear<ShearFree>(0, 0.01) / contraction, 1, 1e-4);
}

TYPED_TEST(PairSumsTwin, HeatIsTheEnergyThatViscosityTakes) {
  using Sums = PairSums<typename TypeParam::Real, typename TypeParam::Kernel, Terms::all>;
  Particles p = random_particles(600);
  for (auto& T : p.T) T = {};
  double power = 0, heat = 0;
  const auto sums = swept<Sums>(p, viscosity, 0.1, {false, true, spacing});
  for (std::size_t i = 0; i < p.size(); ++i) {
    power += p.V[i] * dot(p.v[i], sums[i].force);
    heat += p.V[i] * sums[i].heat;
  }
  // v . force cancels pairwise down to the heat: rounding grows by |v|/|v_ij|, about ten.
  EXPECT_NEAR((power + heat) / heat, 0, 100 * tolerance<TypeParam>);
}

TYPED_TEST(PairSumsTwin, TotalForceIsZero) {
  using Sums = PairSums<typename TypeParam::Real, typename TypeParam::Kernel>;
  const Particles p = random_particles(600);
  const auto sums = swept<Sums>(p, viscosity);
  Vec3 total;
  double magnitude = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    total += p.V[i] * sums[i].force;
    magnitude += p.V[i] * norm(sums[i].force);
  }
  // Each pair is computed twice, with opposite sign: only rounding is left.
  EXPECT_LT(norm(total), tolerance<TypeParam> * magnitude);
}

/// Total torque of the force T = -p 1 + S L over the sum of single torques about the centre.
template <class Sums, class Correction>
double relative_torque(Correction&& correction) {
  Particles p = random_particles(600);
  Random random(4, 0);
  const auto first = swept<Sums>(p, viscosity);
  const SymTensor S = test::random_deviator(random);
  Vec3 centre;
  for (const Vec3& x : p.x) centre += x / static_cast<double>(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.v[i] = {};  // viscosity pulls along the line of a pair and has no torque anyway
    // On one side alone: over a whole sphere the torques of a uniform stress nearly cancel.
    p.T[i] = to_matrix(p.x[i].x > centre.x ? S : SymTensor{}) * to_matrix(correction(first[i].C));
    for (int k = 0; k < 3; ++k) p.T[i][k][k] -= 1.5;
  }
  Vec3 torque;
  double magnitude = 0;
  const auto sums = swept<Sums>(p, viscosity);
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec3 single = p.V[i] * cross(p.x[i] - centre, sums[i].force);
    torque += single;
    magnitude += norm(single);
  }
  return norm(torque) / magnitude;
}

TYPED_TEST(PairSumsTwin, DualForceHasNoTotalTorque) {
  using Sums = PairSums<typename TypeParam::Real, typename TypeParam::Kernel>;
  EXPECT_LT(relative_torque<Sums>(correction_matrix<double>), 3 * tolerance<TypeParam>);
  // Without the correction the same sum has a torque: the dual is what takes it away.
  EXPECT_GT(relative_torque<Sums>([](const SymTensor&) { return SymTensor{1, 1, 1, 0, 0, 0}; }),
            1e-4);
}

TYPED_TEST(PairSumsTwin, FloatFollowsDouble) {
  using Kernel = typename TypeParam::Kernel;
  const Particles p = random_particles(600);
  const Differences d = differences(swept<PairSums<float, Kernel>>(p, viscosity),
                                    swept<PairSums<double, Kernel>>(p, viscosity));
  EXPECT_LT(std::max({d.C, d.G, d.force}), 1e-5);  // sixty terms of 24 bits
  EXPECT_GT(std::max({d.C, d.G, d.force}), 0);     // and it is single precision
}

TEST(PairSums, SumsTurnWithTheBody) {
  // A rotated copy has rotated sums: no axis is preferred and none mistaken for another.
  using Sums = PairSums<double, CubicSpline>;
  Particles p = random_particles(300);
  const auto before = swept<Sums>(p, viscosity);
  const Mat3 R = test::rotation(Vec3{1, 2, -2} / 3, 0.7);
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.x[i] = R * p.x[i];
    p.v[i] = R * p.v[i];
    p.T[i] = R * p.T[i] * transpose(R);
  }
  const auto after = swept<Sums>(p, viscosity);
  double largest = 0, difference = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    largest = std::max(largest, norm(before[i].force));
    difference = std::max(difference, norm(after[i].force - R * before[i].force));
  }
  EXPECT_LT(difference, 1e-10 * largest);  // rounding, as above
}

TEST(PairSums, ViscosityResistsApproachAlone) {
  Particles p = random_particles(600);
  for (auto& T : p.T) T = {};
  const auto power = [&](double rate) {
    for (std::size_t i = 0; i < p.size(); ++i) p.v[i] = rate * (p.x[i] - p.x[0]);
    const auto sums = swept<PairSums<double, CubicSpline>>(p, viscosity);
    double total = 0;
    for (std::size_t i = 0; i < p.size(); ++i) total += p.V[i] * dot(p.v[i], sums[i].force);
    return total;
  };
  EXPECT_LT(power(-1e-3), 0);  // contraction is braked
  EXPECT_EQ(power(1e-3), 0);   // expansion is free
}

TEST(PairSums, ScatteredEjectaKeepTheAccuracyOfTheirBucket) {
  // Clumps 1e4 m apart share a bucket; positions relative to its first particle keep 24 bits of
  // 1e4 m, a millimetre, and sums of the clumps a part in a thousand.
  Particles p = random_particles(60);
  for (std::size_t i = 0; i < p.size(); ++i)
    p.x[i] += std::array<Vec3, 3>{{{0, 0, 0}, {5e3, 3e3, 0}, {-2e3, 9e3, 1e3}}}[i % 3];
  const auto exact = all_pairs<CubicSpline>(p, viscosity);
  const auto found = swept<PairSums<float, CubicSpline>>(p, viscosity);
  const Differences d = differences(found, exact);
  EXPECT_LT(std::max({d.C, d.G, d.force}), 1e-3);
}

}  // namespace
}  // namespace eerie::sph
