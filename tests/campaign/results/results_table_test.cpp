#include "campaign/results/results_table.hpp"

#include <gmock/gmock.h>

namespace eerie::results {
namespace {
using testing::HasSubstr;

db::ResultRow row(double v, double b_over_a) {
  db::ResultRow r;
  r.q = 1;
  r.phi_d_deg = 40;
  r.v_imp_cm_per_s = v;
  r.theta_imp_deg = 15;
  r.particles_per_target = 1000;
  r.result.outcome_class = "perfect-merging";
  r.result.b_over_a = b_over_a;
  r.result.settled = true;
  r.result.eer = b_over_a < 0.3;
  r.result.n_eer = r.result.eer ? 1 : 0;
  return r;
}

std::string for_people(const std::vector<db::ResultRow>& rows) {
  return text::aligned(results_table(rows), 0) + "\n" + legend_of(rows);
}

TEST(ResultsTable, ShowsOnlyParametersThatDiffer) {
  const std::string same = for_people({row(15, 0.5), row(20, 0.6)});
  EXPECT_THAT(same, testing::StartsWith("q 1, phi_d 40 deg, particles per target 1000"));
  db::ResultRow other = row(20, 0.6);
  other.phi_d_deg = 50;
  EXPECT_THAT(for_people({row(15, 0.5), other}), HasSubstr("phi_d  v cm/s"));
}

TEST(ResultsTable, ExplainsEveryMarkThatItUsesAndNoOther) {
  EXPECT_THAT(for_people({row(15, 0.5)}), testing::Not(HasSubstr("extremely elongated")));
  db::ResultRow unsettled = row(20, 0.2);
  unsettled.result.settled = false;
  const std::string table = for_people({unsettled});
  EXPECT_THAT(table, HasSubstr("*  the largest remnant is extremely elongated"));
  EXPECT_THAT(table, HasSubstr("~  not settled"));
}

}  // namespace
}  // namespace eerie::results
