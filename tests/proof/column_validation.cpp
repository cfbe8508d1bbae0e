#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/proof/column.hpp"

namespace eerie::proof {
namespace {

TEST(GranularColumn, RunsOutAsFarAsLaboratoryColumns) {
  const RunOut low = run_out(1, 12), high = run_out(2, 10);
  RecordProperty("low", std::to_string(low.tip));
  RecordProperty("high", std::to_string(high.tip));
  for (const RunOut& r : {low, high}) {
    // Between the laws of two laboratories, and a particle or two of the front on either side.
    EXPECT_GT(r.tip, 0.75 * lube(r.aspect)) << r.aspect;
    EXPECT_LT(r.tip, 1.2 * lajeunesse(r.aspect)) << r.aspect;
    EXPECT_LT(r.kinetic_energy, 5e-3) << r.aspect;
  }
}

}  // namespace
}  // namespace eerie::proof
