#include "analysis/paper/facts.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "solver/base/file.hpp"
#include "tests/support/paths.hpp"

namespace eerie::paper {
namespace {
using nlohmann::json;

TEST(Facts, HaveGridsThatAreThoseOfTheSweepFiles) {
  const auto axis = [](const json& spec) {
    return std::vector<double>{spec.at("from"), spec.at("to"), spec.at("step")};
  };
  for (const PaperGrid& g : paper_grids()) {
    const json grid = json::parse(read_file(test::source_folder() / g.sweep())).at("grid");
    EXPECT_EQ(grid.at("q"), json::array({g.q})) << g.name;
    EXPECT_EQ(grid.at("phi_d_deg"), json::array({g.phi_d_deg})) << g.name;
    EXPECT_EQ(axis(grid.at("v_imp_cm_per_s")), (std::vector{g.v_from, g.v_to, g.v_step}));
    EXPECT_EQ(axis(grid.at("theta_imp_deg")),
              (std::vector{g.theta_from, g.theta_to, g.theta_step}));
  }
}

TEST(Facts, CountTheImpactsOfTable2) {
  std::size_t all = 0;
  for (const PaperGrid& g : paper_grids()) all += points_of({g}).size();
  EXPECT_EQ(all, 418u);
  // 18 points of the coarse grid are points of the fine one, too.
  EXPECT_EQ(points_of(paper_grids(1, 40)).size(), 54u + 96u - 18u);
}

TEST(Facts, AreOfImpactsThatThePaperMade) {
  std::set<std::string> names;
  for (const Fact& fact : paper_facts()) {
    EXPECT_TRUE(names.insert(fact.name).second) << fact.name;
    EXPECT_NE(fact.point.has_value(), !fact.grids.empty()) << fact.name;
    EXPECT_FALSE(fact.source.empty()) << fact.name;
    for (const PaperGrid& g : fact.grids) {
      EXPECT_EQ(g.q, fact.q) << fact.name;
      EXPECT_EQ(g.phi_d_deg, fact.phi_d_deg) << fact.name;
    }
    if (!fact.point) continue;
    const auto here = [&](const ImpactPoint& p) {
      return p.v_imp_cm_per_s == fact.point->v_imp_cm_per_s &&
             p.theta_imp_deg == fact.point->theta_imp_deg;
    };
    EXPECT_TRUE(std::ranges::any_of(points_of(paper_grids(fact.q, fact.phi_d_deg)), here))
        << fact.name;
  }
}

}  // namespace
}  // namespace eerie::paper
