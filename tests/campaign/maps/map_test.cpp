#include "campaign/maps/map.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "campaign/maps/map_csv.hpp"
#include "db/store/settings.hpp"
#include "solver/base/constants.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "tests/support/impact_database.hpp"

namespace eerie::maps {
namespace {
namespace fs = std::filesystem;
using nlohmann::json;
using test::survey_scene;
using testing::ElementsAre;
using testing::HasSubstr;

class Maps : public testing::Test {
 protected:
  void add(const json& scene, double b_over_a) { test::add_impact(connection, scene, b_over_a); }
  std::vector<std::string> labels() {
    const std::vector<diagrams::PhaseDiagram> all = phase_diagrams(connection, {});
    std::vector<std::string> found;
    for (const diagrams::PhaseDiagram& one : all) found.push_back(map_label(one, all));
    return found;
  }
  /// The fields of a line of the table by column; line 0 is the first point.
  std::map<std::string, std::string> table(std::size_t line) {
    std::istringstream text(map_csv(db::map_points(connection, {})));
    const auto fields = [&] {
      std::string row, field;
      std::getline(text, row);
      std::vector<std::string> all;
      std::istringstream in(row + ",");
      while (std::getline(in, field, ',')) all.push_back(field);
      return all;
    };
    const std::vector<std::string> header = fields();
    for (std::size_t k = 0; k < line; ++k) fields();
    const std::vector<std::string> values = fields();
    EXPECT_EQ(values.size(), header.size());
    std::map<std::string, std::string> row;
    for (std::size_t k = 0; k < std::min(header.size(), values.size()); ++k)
      row[header[k]] = values[k];
    return row;
  }
  std::string refusal(const NamedMaps& request) {
    try {
      draw_named_maps(connection, request);
    } catch (const InputError& error) {
      return error.what();
    }
    return "it was drawn";
  }

  test::TemporaryFolder folder;
  db::Connection connection{folder / "a.sqlite", db::Access::write};
};

TEST_F(Maps, AreOnePerMassRatioFrictionAngleAndSettings) {
  add(survey_scene(1, 40, 20, 15, 1), 0.25);
  add(survey_scene(1, 40, 22, 15, 1), 0.35);
  add(survey_scene(1, 50, 20, 15, 1), 0.45);
  EXPECT_THAT(labels(), ElementsAre("q1-phi40-n1000", "q1-phi50-n1000"));
  json other = survey_scene(1, 40, 20, 15, 1);
  other["numerics"]["cfl"] = 0.5;
  add(other, 0.9);
  EXPECT_THAT(labels(), ElementsAre("q1-phi40-n1000-s1", "q1-phi40-n1000-s2", "q1-phi50-n1000"));
  EXPECT_EQ(phase_diagrams(connection, {})[0].cells.size(), 2u);
  EXPECT_EQ(phase_diagrams(connection, {})[0].fidelity, "survey");
}

TEST_F(Maps, MarkImpactsOfAnotherSolverVersion) {
  add(survey_scene(1, 40, 20, 15, 1), 0.25);
  EXPECT_FALSE(phase_diagrams(connection, {})[0].cells[0].stale);
  db::set(connection, "solver_version", "9.9.9");
  EXPECT_TRUE(phase_diagrams(connection, {})[0].cells[0].stale);
  EXPECT_EQ(table(0)["stale"], "1");
}

TEST_F(Maps, HaveTheirNumbersInATable) {
  for (const auto& [seed, shape] : {std::pair(1, 0.2), std::pair(2, 0.3), std::pair(3, 0.4)})
    add(survey_scene(1, 40, 20, 15, seed), shape);
  db::add_sweep(connection, "s", "{}",
                std::vector{sweeps::new_job(parse_scene(survey_scene(1, 40, 30, 15, 1)))});
  auto row = table(0);
  EXPECT_EQ(row["v_imp_cm_per_s"], "20");
  EXPECT_EQ(row["v_sin_theta_cm_per_s"], "5.17638");
  EXPECT_NEAR(std::stod(row["v_over_v_esc"]), 3.26, 0.01);
  EXPECT_EQ(row["fidelity"], "survey");
  EXPECT_EQ(row["settings"], "1");
  EXPECT_EQ(row["jobs"] + row["done"] + row["seeds"] + row["failed"] + row["stale"], "33300");
  EXPECT_EQ(row["b_over_a"], "0.3");
  EXPECT_EQ(row["b_over_a_std"], "0.1");
  EXPECT_EQ(row["p_eer"], "0.333333");
  EXPECT_EQ(row["n_eer"], "0.333333");
  EXPECT_EQ(row["class"], "perfect-merging");
  EXPECT_EQ(row["perfect_merging_share"], "1");
  EXPECT_EQ(row["hit_and_run_share"], "0");
  row = table(1);
  EXPECT_EQ(row["jobs"], "1");
  EXPECT_EQ(row["b_over_a"] + row["p_eer"] + row["class"] + row["hit_and_run_share"], "");
}

TEST_F(Maps, OfTheProbabilityHaveItsFitInTheirTable) {
  std::vector<std::pair<json, double>> impacts;
  for (const double v : {16.0, 18.0, 20.0, 22.0, 24.0})
    for (const double theta : {10.0, 12.5, 15.0, 17.5}) {
      const double s = v * std::sin(radians(theta));
      impacts.emplace_back(survey_scene(1, 40, v, theta, 1), s > 4.4 && s < 5.4 ? 0.25 : 0.6);
    }
  test::add_impacts(connection, impacts);
  add(survey_scene(1, 50, 20, 15, 1), 0.25);  // a map of one impact has no fit
  const fs::path file = folder / "p.csv";
  draw_named_maps(connection, {{}, {diagrams::MapQuantity::p_largest_eer}, {file}});
  std::istringstream text(read_file(file));
  std::string header, line;
  std::getline(text, header);
  EXPECT_TRUE(header.ends_with(",p_eer_fit,p_eer_fit_low,p_eer_fit_high")) << header;
  int fitted = 0, empty = 0;
  while (std::getline(text, line)) {
    EXPECT_EQ(std::ranges::count(line, ','), std::ranges::count(header, ',')) << line;
    if (line.ends_with(",,,")) {
      ++empty;
      EXPECT_TRUE(line.starts_with("1,50,")) << line;
      continue;
    }
    std::istringstream last(line.substr(line.rfind(',', line.rfind(',', line.rfind(',') - 1) - 1)));
    char comma;
    double p, low, high;
    last >> comma >> p >> comma >> low >> comma >> high;
    EXPECT_TRUE(0 <= low && low <= high && high <= 1 && p >= 0 && p <= 1) << line;
    if (line.starts_with("1,40,20,15,")) {
      EXPECT_GT(p, 0.5) << line;
    }
    if (line.starts_with("1,40,16,10,")) {
      EXPECT_LT(p, 0.2) << line;
    }
    ++fitted;
  }
  EXPECT_EQ(fitted, 20);
  EXPECT_EQ(empty, 1);
}

TEST_F(Maps, OfSeveralSettingsAreNotDrawnButTabulated) {
  add(survey_scene(1, 40, 20, 15, 1), 0.25);
  json other = survey_scene(1, 40, 20, 15, 1);
  other["numerics"]["particles_per_target"] = 2000;
  add(other, 0.9);
  NamedMaps request{.files = {folder / "map.png"}};
  EXPECT_THAT(refusal(request),
              HasSubstr("--fidelity survey   numerics.particles_per_target=1000"));
  request.files = {folder / "map.csv"};
  EXPECT_THAT(draw_named_maps(connection, request), ElementsAre(folder / "map.csv"));
  EXPECT_THAT(read_file(folder / "map.csv"), HasSubstr(",2,,2000,"));
  EXPECT_FALSE(fs::exists(folder / "map.png"));
}

TEST_F(Maps, SayWhatTheDatabaseHoldsWhereTheFilterLeavesNothing) {
  NamedMaps request{.files = {folder / "map.png"}};
  EXPECT_THAT(refusal(request), HasSubstr("it is empty"));
  add(survey_scene(0.5, 40, 20, 15, 1), 0.25);
  request.filter.q = 1;
  EXPECT_THAT(refusal(request),
              HasSubstr("--q 0.5 --phi-d 40 --settings 1   1000 particles, survey"));
}

TEST_F(Maps, AreFilesOfKnownKindsOnly) {
  EXPECT_NO_THROW(require_map_files({"a.png", "a.svg", "a.pdf", "a.csv"}, "-o"));
  EXPECT_THROW(require_map_files({"a.png", "a.gif"}, "-o"), InputError);
}

}  // namespace
}  // namespace eerie::maps
