#include <gtest/gtest.h>
#include <malloc.h>

#include "solver/initial/bodies.hpp"
#include "solver/step/solver.hpp"

namespace eerie::step {
namespace {

/// Bytes that the program holds on its heap.
double held() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

TEST(Solver, NeedsAtMost600BytesPerParticleOfAHundredThousand) {
  const Scene scene =
      parse_scene({{"numerics", {{"particles_per_target", 50000}, {"packing", "lattice"}}}});
  const double before = held();
  Solver solver(scene, initial::make_unsettled_impact(scene));
  solver.cycle(1e9);
  const double per_particle = (held() - before) / static_cast<double>(solver.state().size());
  RecordProperty("bytes_per_particle", std::to_string(per_particle));
  if (per_particle <= 0) GTEST_SKIP() << "this allocator does not count";
  EXPECT_LE(per_particle, 600);
  EXPECT_GE(per_particle, 300);  // state and rates alone: it does count
}

}  // namespace
}  // namespace eerie::step
