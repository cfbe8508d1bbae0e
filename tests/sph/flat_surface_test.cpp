#include "solver/sph/flat_surface.hpp"

#include <gtest/gtest.h>

#include "solver/base/vec3.hpp"
#include "solver/sph/kernel.hpp"
#include "tests/support/variant_types.hpp"

namespace eerie::sph {
namespace {

template <class Kernel>
class FlatSurfaceOf : public testing::Test {};
TYPED_TEST_SUITE(FlatSurfaceOf, test::AlternativesOf<KernelChoice>, test::NameByToken);

TYPED_TEST(FlatSurfaceOf, HasTheSumsOfALatticeThatFillsHalfOfSpace) {
  // Layers sum the moment, int z P dz, like midpoints: to d^2/24 P(0), P(0) of about one. Near the
  // plane the moment is at its largest, so that it tells little of the depth: density is known to
  // that over z.
  const double d = 0.4;
  const int reach = 5;
  for (int depth = 0; depth < 5; ++depth) {  // layers of the lattice above the particle
    double density = 0, moment = 0;
    for (int a = -reach; a <= reach; ++a)
      for (int b = -reach; b <= reach; ++b)
        for (int c = -reach; c <= depth; ++c) {
          const double r = d * norm(Vec3{double(a), double(b), double(c)});
          if (r >= 2) continue;
          const double w = TypeParam::normalisation * TypeParam::w(r) * d * d * d;
          density += w, moment -= w * d * c;
        }
    EXPECT_NEAR(flat_density<TypeParam>(moment), density, d / 12 / (2 * depth + 1) + 0.005)
        << depth;
  }
}

TYPED_TEST(FlatSurfaceOf, IsHalfOnThePlaneAndBeyondAndAllDeepInside) {
  EXPECT_NEAR(flat_density<TypeParam>(10), 0.5, 1e-12);
  EXPECT_NEAR(flat_density<TypeParam>(0), 1, 1e-3);  // by midpoints
}

}  // namespace
}  // namespace eerie::sph
