#include "campaign/catalogue/catalogue.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <set>

#include "campaign/catalogue/catalogue_export.hpp"
#include "campaign/catalogue/catalogue_sweep.hpp"
#include "campaign/catalogue/comparison.hpp"
#include "campaign/catalogue/quantities.hpp"
#include "campaign/sweeps/sweep.hpp"
#include "campaign/text/csv_table.hpp"
#include "solver/base/bodies/sphere.hpp"
#include "solver/base/constants.hpp"
#include "solver/base/error.hpp"
#include "tests/support/impact_database.hpp"

namespace eerie::catalogue {
namespace {
using testing::ElementsAre;
using testing::HasSubstr;

Catalogue read(const std::string& text, const CatalogueOptions& options = {}) {
  return parse_catalogue(text, "c.csv", options);
}
CatalogueRow first(const std::string& text, const CatalogueOptions& options = {}) {
  return read(text, options).rows.at(0);
}

TEST(CsvTable, ReadsQuotesCommentsOtherSeparatorsAndEndsOfLines) {
  const text::CsvTable table = text::parse_csv(
      "\xef\xbb\xbf# made by hand\r\na ;b, c;\"d;d\"\r\n\r\n1;\"two \"\"2\"\"\nlines\";\n5;6;7",
      "t");
  EXPECT_THAT(table.header, ElementsAre("a", "b, c", "d;d"));
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_EQ(table.rows[0].line, 4u);
  EXPECT_THAT(table.rows[0].fields, ElementsAre("1", "two \"2\"\nlines", ""));
  EXPECT_EQ(table.rows[1].line, 6u);
  EXPECT_THAT(table.rows[1].fields, ElementsAre("5", "6", "7"));
}

TEST(Quantities, AreKnownByTheirNamesInPublications) {
  const auto known = [](const char* header) { return column_of(header, "c.csv"); };
  const std::pair<const char*, CatalogueQuantity> cases[] = {
      {"V_i/V_esc", CatalogueQuantity::v_imp_over_v_esc},
      {"v_coll / v_esc", CatalogueQuantity::v_imp_over_v_esc},
      {"v_imp [km/s]", CatalogueQuantity::v_imp},
      {"v_coll (km s^-1)", CatalogueQuantity::v_imp},
      {"theta_coll (deg)", CatalogueQuantity::theta_imp},
      {"theta (\u00b0)", CatalogueQuantity::theta_imp},
      {"impact_angle_rad", CatalogueQuantity::theta_imp},
      {"$M_{targ}$ [kg]", CatalogueQuantity::m_target},
      {"M_tar (M_Earth)", CatalogueQuantity::m_target},
      {"m_projectile_g", CatalogueQuantity::m_projectile},
      {"gamma", CatalogueQuantity::q},
      {"M_LR [kg]", CatalogueQuantity::m_lr},
      {"M_LR/M_tot", CatalogueQuantity::m_lr_over_m_total},
      {"b", CatalogueQuantity::b},
      {"b_over_a", CatalogueQuantity::b_over_a},
      {"density (g/cm^3)", CatalogueQuantity::rho},
      {"density [kg m^-3]", CatalogueQuantity::rho},
  };
  for (const auto& [header, quantity] : cases) {
    ASSERT_TRUE(known(header)) << header;
    EXPECT_EQ(known(header)->quantity, quantity) << header;
  }
  for (const char* header : {"", "comment", "m_", "v_imp_mph", "kg", "lr", "semi-major axis (au)"})
    EXPECT_FALSE(known(header)) << header;
  for (const char* header : {"v_imp", "M_targ", "theta", "Density"})
    EXPECT_THROW(known(header), InputError) << header << " has no unit";
}

TEST(Quantities, MoveTheDecimalPointWithoutLosingABit) {
  const Unit m_per_s = column_of("v_imp_m_per_s", "c")->unit;
  for (const double v : {18.0, 0.07, 5.1, 17.1234567891, 1.0 / 3, 123456.7, 1e-7, 9.999e20})
    EXPECT_EQ(value_of(moved(v, -2), m_per_s, 2), v) << moved(v, -2);
  EXPECT_EQ(moved(17.3, -2), "0.173");
  EXPECT_EQ(moved(20, -2), "0.2");
  EXPECT_EQ(moved(-1250, -2), "-12.5");
  EXPECT_EQ(value_of("1.5e1", column_of("v_imp_km_per_s", "c")->unit), 15000);
  for (const char* text : {"", "nan", "inf", "0x10", "1,5", "12 m", "1e", "--1"})
    EXPECT_EQ(value_of(text, m_per_s), std::nullopt) << text;
}

TEST(Catalogue, TakesBodiesFromMassesOrFromWhateverSaysTheSame) {
  const double m = 2700 * sphere_volume(50);
  const auto line = [](const std::string& header, const std::string& values) {
    return first("v_imp_m_per_s,theta_imp_deg," + header + "\n0.2,15," + values + "\n").impact;
  };
  const CatalogueImpact impacts[] = {
      line("m_target_kg,m_projectile_kg", fmt::format("{},{}", m, m / 4)),
      line("m_target_kg,q", fmt::format("{},0.25", m)),
      line("M_tot (kg),gamma", fmt::format("{},0.25", 1.25 * m)),
      line("m_target_g,q,r_target_m", fmt::format("{},0.25,50", 1000 * m)),
      line("r_target_km,rho_g_per_cm3,q", "0.05,2.7,0.25"),
  };
  for (const CatalogueImpact& impact : impacts) {
    EXPECT_EQ(impact.radius_m, 50);
    EXPECT_EQ(impact.rho0_kg_per_m3, 2700);
    EXPECT_EQ(impact.q, 0.25);
    EXPECT_EQ(impact.v_imp_cm_per_s, 20);
    EXPECT_EQ(impact.theta_imp_deg, 15);
  }
  const CatalogueImpact icy =
      first("v_imp_m_per_s,theta_imp_deg,m_target_kg,q\n0.2,15," + fmt::format("{}", m) + ",1\n",
            {.density_kg_per_m3 = 1000, .radius_m = {}})
          .impact;
  EXPECT_NEAR(icy.radius_m, 50 * std::cbrt(2.7), 1e-9);
}

TEST(Catalogue, KeepsTheRatioToTheEscapeSpeedOnATargetOfAnotherRadius) {
  // A giant impact: 10 km/s are far beyond what eerie runs.
  const std::string earth =
      "v_imp_km_per_s,theta_imp_deg,m_target_kg,q,r_target_m\n10,45,5.97e24,0.1,6.371e6\n";
  EXPECT_THROW(first(earth), InputError);
  const CatalogueImpact impact = first(earth, {.density_kg_per_m3 = {}, .radius_m = 50}).impact;
  EXPECT_EQ(impact.radius_m, 50);
  const double theirs = 1e4 / mutual_escape_speed({6.371e6, 5.97e24 / sphere_volume(6.371e6)}, 0.1);
  EXPECT_NEAR(impact.v_imp_cm_per_s / 100 / mutual_escape_speed({50, 2700}, 0.1), theirs, 1e-9);
  const CatalogueImpact without_sizes =
      first("v_imp_over_v_esc,b,q\n1.5,0.5,1\n", {.density_kg_per_m3 = {}, .radius_m = 50}).impact;
  EXPECT_NEAR(without_sizes.v_imp_cm_per_s / 100 / mutual_escape_speed({50, 2700}, 1), 1.5, 1e-9);
  EXPECT_NEAR(without_sizes.theta_imp_deg, 30, 1e-9);
}

TEST(Catalogue, HasTheEscapeSpeedOfAScene) {
  const Scene scene = parse_scene(test::survey_scene(0.25, 40, 20, 15, 1));
  EXPECT_NEAR(mutual_escape_speed({50, 2700}, 0.25), sweeps::mutual_escape_speed(scene), 1e-12);
}

TEST(Catalogue, ReadsOutcomesAsPartsOfAllMass) {
  const std::string head = "v_imp_m_per_s,theta_imp_deg,m_target_kg,q,";
  EXPECT_NEAR(*first(head + "m_lr_kg\n0.2,15,1e9,0.5,1.2e9\n").outcome.m_lr_over_m_total, 0.8,
              1e-12);
  // Perfect accretion, hit-and-run that leaves the target as it was.
  EXPECT_NEAR(*first(head + "xi\n0.2,15,1e9,0.5,1\n").outcome.m_lr_over_m_total, 1, 1e-12);
  EXPECT_NEAR(*first(head + "xi\n0.2,15,1e9,0.5,0\n").outcome.m_lr_over_m_total, 1 / 1.5, 1e-12);
  EXPECT_EQ(first(head + "outcome\n0.2,15,1e9,0.5,hit-and-run\n").outcome.outcome_class,
            "hit-and-run");
}

struct BadCatalogue {
  const char* text;
  const char* expected;
};

TEST(Catalogue, RefusesWhatItCannotUseNamingLineColumnValueAndMend) {
  const BadCatalogue cases[] = {
      {"", "has no header"},
      {"v_imp_m_per_s,theta_imp_deg,m_target_kg,q\n", "has a header and no impact"},
      {"theta_imp_deg,m_target_kg,q\n15,1e9,1\n", "no column says v_imp_m_per_s or"},
      {"v_imp,theta_imp_deg,m_target_kg,q\n1,15,1e9,1\n", "column v_imp has no unit"},
      {"v_imp_m_per_s,V_i (km/s),theta_imp_deg,m_target_kg,q\n1,1,15,1e9,1\n", "both say"},
      {"v_imp_m_per_s,theta_imp_deg,m_target_kg,q\n0.2,15,1e9\n", "line 2: has 3 fields"},
      {"v_imp_m_per_s,theta_imp_deg,m_target_kg,q\n0.2,15,1e9,1\n0.2,95,1e9,1\n",
       "line 3, theta_imp_deg = 95: must be at least 0 and at most 89"},
      {"v_imp_m_per_s,theta_imp_deg,m_target_kg,q\nfast,15,1e9,1\n",
       "line 2, v_imp_m_per_s = fast: must be a number"},
      {"v_imp_m_per_s,theta_imp_deg,m_target_kg,q\n0,15,1e9,1\n", "must be greater than 0"},
      {"v_imp_m_per_s,theta_imp_deg,m_target_kg,q\n-3,15,1e9,1\n", "must be at least 0"},
      {"v_imp_m_per_s,theta_imp_deg,m_target_kg,q\n500,15,1e9,1\n", "--radius 50"},
      {"v_imp_m_per_s,theta_imp_deg,m_target_kg,q\n0.2,15,1e9,2\n", "q = 2: must be at most 1"},
      {"v_imp_m_per_s,theta_imp_deg,m_target_kg,m_projectile_kg\n0.2,15,1e9,2e9\n",
       "call the larger body the target"},
      {"v_imp_m_per_s,theta_imp_deg,m_target_kg,m_projectile_kg,q\n0.2,15,1e9,1e8,0.5\n",
       "the masses have the ratio 0.1"},
      {"v_imp_m_per_s,theta_imp_deg,m_target_kg,q,r_target_m,rho_kg_per_m3\n0.2,15,1e9,1,50,2700\n",
       "mend one of the three"},
      {"v_imp_m_per_s,theta_imp_deg,m_target_kg,q,m_lr_kg\n0.2,15,1e9,1,3e9\n",
       "at most the mass of both bodies"},
      {"v_imp_m_per_s,theta_imp_deg,m_target_kg,q\n0.2,15,,1\n", "the size of the target"},
      {"v_imp_m_per_s,theta_imp_deg,m_target_kg,q\n0.2,,1e9,1\n", "the impact angle is missing"},
      {"v_imp_m_per_s,theta_imp_deg,m_target_kg,q\n\"0.2,15,1e9,1\n", "is never closed"},
  };
  for (const BadCatalogue& bad : cases) {
    try {
      read(bad.text);
      ADD_FAILURE() << bad.text << "was taken";
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(bad.expected)) << bad.text;
      EXPECT_THAT(error.what(), testing::StartsWith("c.csv")) << bad.text;
    }
  }
}

TEST(CatalogueSweep, PutsWhatAllShareIntoTheSceneAndEachImpactOnce) {
  const Catalogue catalogue =
      read("v_imp_m_per_s,theta_imp_deg,m_target_kg,q\n0.2,15,1e9,1\n0.3,15,1e9,1\n0.2,15,1e9,1\n");
  nlohmann::json document = sweep_of(catalogue, {"numerics.particles_per_target=500"}, "c.csv");
  EXPECT_EQ(document["points"].size(), 2u);
  EXPECT_EQ(document["scene"]["impact"]["q"], 1);
  const std::vector<Scene> scenes = sweeps::expand(sweeps::parse_sweep(document, {}, "s.json"));
  ASSERT_EQ(scenes.size(), 2u);
  EXPECT_EQ(scenes[1].impact.v_imp_cm_per_s, 30);
  EXPECT_EQ(scenes[1].numerics.particles_per_target, 500);
}

TEST(CatalogueSweep, NamesTheLineThatMakesNoScene) {
  const Catalogue catalogue =
      read("v_imp_m_per_s,theta_imp_deg,m_target_kg,q\n0.2,15,1e9,1\n0.2,15,1e9,0.001\n");
  EXPECT_THAT([&] { sweep_of(catalogue, {}, "c.csv"); },
              testing::ThrowsMessage<InputError>(HasSubstr("c.csv, line 3")));
}

/// Jobs of odd values, with as many digits as numbers have, as if they had been run.
class CatalogueOfResults : public testing::Test {
 protected:
  CatalogueOfResults() {
    for (int seed = 1; seed <= 2; ++seed) {
      add(test::survey_scene(1, 40, 17.1234567891, 15, seed), 0.25);
      add(test::survey_scene(0.333333333333, 50, 10.07, 12.5, seed), 0.6);
    }
    nlohmann::json other = test::survey_scene(0.5, 30, 20, 89, 7);
    other["target"]["radius_m"] = 123.4;
    other["material"]["rho0_kg_per_m3"] = 1900.5;
    add(other, 0.5);
  }
  void add(const nlohmann::json& scene, double b_over_a) {
    test::add_impact(connection, scene, b_over_a);
    hashes.insert(scene_hash(parse_scene(scene)));
  }

  test::TemporaryFolder folder;
  db::Connection connection{folder / "a.sqlite", db::Access::write};
  std::set<std::string> hashes;
};

TEST_F(CatalogueOfResults, ComesBackAsTheSameScenesToTheLastBit) {
  const Catalogue catalogue = read(catalogue_csv(connection, {}));
  EXPECT_EQ(common_fidelity(catalogue, "c.csv"), "survey");
  const nlohmann::json document =
      sweep_of(catalogue, sweeps::overrides_of_fidelity("survey"), "c.csv");
  std::set<std::string> found;
  for (const Scene& scene : sweeps::expand(sweeps::parse_sweep(document, {}, "s.json")))
    found.insert(scene_hash(scene));
  EXPECT_EQ(found, hashes);
}

TEST_F(CatalogueOfResults, IsComparedWithTheRunsAtItsPoints) {
  const Catalogue catalogue = read(catalogue_csv(connection, {}));
  const std::vector<Comparison> all = compare(connection, catalogue);
  ASSERT_EQ(all.size(), 5u);
  for (const Comparison& c : all) {
    EXPECT_EQ(c.runs, c.row->impact.q == 0.5 ? 1u : 2u);
    EXPECT_EQ(c.outcome_class, "perfect-merging");
    EXPECT_NEAR(c.m_lr_difference().value(), 0, 1e-8);
    EXPECT_NEAR(c.b_over_a_difference().value(), 0, 1e-8);
    EXPECT_EQ(c.b_over_a_scatter.has_value(), c.runs > 1);
  }
  // Other bodies at the same speed and angle are not the same impact.
  Catalogue heavier = catalogue;
  for (CatalogueRow& row : heavier.rows) row.impact.rho0_kg_per_m3 *= 1.01;
  for (const Comparison& c : compare(connection, heavier)) {
    EXPECT_EQ(c.runs, 0u);
    EXPECT_EQ(c.m_lr_difference(), std::nullopt);
    EXPECT_EQ(c.b_over_a_difference(), std::nullopt);
  }
}

TEST_F(CatalogueOfResults, OfOtherShapesDiffersByTheirRootMeanSquare) {
  Catalogue catalogue = read(catalogue_csv(connection, {}));
  catalogue.rows.resize(2);
  catalogue.rows[0].outcome.b_over_a = catalogue.rows[0].outcome.b_over_a.value() - 0.3;
  catalogue.rows[1].outcome.b_over_a = catalogue.rows[1].outcome.b_over_a.value() + 0.4;
  const Agreement whole = agreement_of(compare(connection, catalogue));
  EXPECT_EQ(whole.shapes, 2u);
  EXPECT_NEAR(whole.b_over_a_rms, std::sqrt((0.09 + 0.16) / 2), 1e-8);
  for (CatalogueRow& row : catalogue.rows) row.outcome.b_over_a.reset();
  EXPECT_EQ(agreement_of(compare(connection, catalogue)).shapes, 0u);
}

TEST_F(CatalogueOfResults, HasTheColumnsThatCataloguesShareFirst) {
  EXPECT_THAT(catalogue_csv(connection, {}),
              testing::StartsWith("run_id,v_imp_m_per_s,v_imp_over_v_esc,theta_imp_deg,"
                                  "m_target_kg,m_projectile_kg,m_lr_kg,m_slr_kg,"));
}

}  // namespace
}  // namespace eerie::catalogue
