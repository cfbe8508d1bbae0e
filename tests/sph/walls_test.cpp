// g++ 12 takes the undefined operands of its own AVX-512 headers for faults (GCC bug 105593).
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/sph/kernel.hpp"
#include "solver/sph/pair_sums.hpp"
#include "solver/tree/images.hpp"
#include "tests/support/particles.hpp"

namespace eerie::sph {
namespace {

constexpr double h = 1.2;

struct Particle {
  Vec3 x, v;
  Mat3 T;
};

/// Disordered particles in the box [0, 6]^3 with random velocities and stresses, memory order.
std::vector<Particle> boxful() {
  Random random(5, 5);
  std::vector<Vec3> x;
  for (int n = 0; n < 216; ++n)
    x.push_back({random.uniform(0, 6), random.uniform(0, 6), random.uniform(0, 6)});
  std::vector<Particle> particles;
  for (const Vec3& at : test::in_kd_order(x))
    particles.push_back({at, 0.1 * random.direction(), test::random_matrix(random)});
  return particles;
}

/// All particles and all their images, as the walls are described: position reflected, velocity
/// reflected (slip) or reversed (rough), stress reflected (slip) or passed on (rough).
std::vector<Particle> with_copies(std::vector<Particle> all,
                                  const std::vector<tree::Mirror>& mirrors) {
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t before = all.size();
    for (const tree::Mirror& mirror : mirrors)
      for (std::size_t i = 0; mirror.axis == axis && i < before; ++i) {
        Particle copy = all[i];
        copy.x[axis] = 2 * mirror.at - copy.x[axis];
        for (int a = 0; a < 3; ++a) {
          if (mirror.rough || a == axis) copy.v[a] *= -1;
          for (int b = 0; b < 3; ++b)
            if (!mirror.rough && (a == axis) != (b == axis)) copy.T[a][b] *= -1;
        }
        all.push_back(copy);
      }
  }
  return all;
}

NeighbourSums brute_force(const std::vector<Particle>& all, std::size_t i) {
  NeighbourSums s;
  for (std::size_t j = 0; j < all.size(); ++j) {
    const Vec3 dx = all[i].x - all[j].x, dv = all[i].v - all[j].v;
    const double r = norm(dx), q = r / h;
    if (j == i || q >= 2) continue;
    const Vec3 gradient =
        CubicSpline::dw_over_q(q, 1 / q) * CubicSpline::normalisation / std::pow(h, 5) * dx;
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) {
        s.G[a][b] -= dv[a] * gradient[b];
        s.force[a] += (all[i].T[a][b] + all[j].T[a][b]) * gradient[b];
      }
  }
  return s;
}

void expect_sums_over_images(const std::vector<tree::Mirror>& mirrors) {
  const std::vector<Particle> particles = boxful(), all = with_copies(particles, mirrors);
  std::vector<Vec3> x;
  for (const Particle& p : particles) x.push_back(p.x);
  tree::NeighbourList lists(2 * h, 0.2 * h, tree::images_of(mirrors), row_units<double>);
  lists.build(test::fitted_tree(x), x);
  PairSums<double, CubicSpline> sums(h, 1, {0, 0});
  sums.rows.resize(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (i % tree::bucket_size == 0)
      sums.rows.set_origin(i / tree::bucket_size, x[i], particles[i].v);
    sums.rows.set(i, x[i], particles[i].v, 1, 1, rows_of(particles[i].T));
  }
  double scale = 0, G = 0, force = 0;
  sums.sweep(lists, x.size(), [&](std::size_t i, std::size_t count, const PackedSums& packed) {
#pragma omp critical
    for (std::size_t l = 0; l < count; ++l) {
      const NeighbourSums exact = brute_force(all, i + l), found = lane(packed, l);
      scale = std::max({scale, norm(exact.force), test::largest_entry(exact.G)});
      force = std::max(force, norm(found.force - exact.force));
      G = std::max(G, test::largest_entry(test::difference(found.G, exact.G)));
    }
  });
  EXPECT_LT(force, 1e-9 * scale);  // softening of 1/r, 1e-12 h^2 in r^2
  EXPECT_LT(G, 1e-9 * scale);
}

TEST(Walls, OneMakesASumOverOneImageOfEach) {
  expect_sums_over_images({{2, true, 0, false}});
  expect_sums_over_images({{2, true, 0, true}});
}

TEST(Walls, OfSeveralAxesMakeTheImagesOfEdgesAndCornersToo) {
  const std::vector<tree::Mirror> box = {{0, true, 0, false}, {0, false, 6, false},
                                         {1, true, 0, true},  {1, false, 6, false},
                                         {2, true, 0, false}, {2, false, 6, true}};
  EXPECT_EQ(tree::images_of(box).size(), 26u);
  expect_sums_over_images(box);
}

TEST(Walls, AListIsUsedUpWhenAParticleHasMovedHalfTheSkin) {
  const std::vector<Particle> particles = boxful();
  std::vector<Vec3> x;
  for (const Particle& p : particles) x.push_back(p.x);
  tree::NeighbourList lists(2 * h, 0.2, tree::images_of({{2, true, 0, false}}));
  lists.build(test::fitted_tree(x), x);
  // Flying along a wall together is no rigid motion of the images: nothing is taken out.
  for (Vec3& at : x) at.z += 0.09;
  EXPECT_FALSE(lists.used_up(x));
  for (Vec3& at : x) at.z += 0.02;
  EXPECT_TRUE(lists.used_up(x));
}

}  // namespace
}  // namespace eerie::sph
