#include "campaign/studies/convergence_page.hpp"

#include <gmock/gmock.h>

namespace eerie::studies {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

ConvergenceStudy two_cases() {
  const auto impact = [](double v) {
    return json{{"impact", {{"v_imp_cm_per_s", v}, {"theta_imp_deg", 15}}}};
  };
  return parse_convergence_study({{"name", "small"},
                                  {"schemes", {"dual", "closing-voids"}},
                                  {"cases",
                                   {{{"name", "A"},
                                     {"title", "A: v_imp = 20 cm/s,\n# <b>{x}"},
                                     {"scene", impact(20)},
                                     {"published", {{"b_over_a", 0.24}, {"period_h", 9.36}}}},
                                    {{"name", "B"}, {"scene", impact(22)}}}},
                                  {"ladder",
                                   {{{"particles_per_target", 1000}, {"seeds", 2}},
                                    {{"particles_per_target", 20000}, {"seeds", 1}}}}},
                                 "study.json");
}

ConvergenceCell cell(const std::string& scheme, std::int64_t particles,
                     std::vector<double> b_over_a) {
  ConvergenceCell c;
  c.scheme = scheme, c.case_name = "A", c.particles_per_target = particles;
  c.b_over_a = statistics::ensemble(b_over_a),
  c.m_1 = statistics::ensemble(std::vector<double>(b_over_a.size(), 0.95));
  c.period_h = statistics::ensemble(std::vector<double>(b_over_a.size(), 10));
  c.core_seconds = statistics::ensemble({7}), c.classes = "hit-and-run 2";
  return c;
}

std::string page_of(const std::vector<ConvergenceCell>& cells) {
  return convergence_page(two_cases(), cells, particles_needed(two_cases(), cells));
}

TEST(ConvergencePage, ShowsCasesThatHaveResultsWithFigureEnsemblesAndPublishedNumbers) {
  const std::string page =
      page_of({cell("dual", 1000, {0.30, 0.34}), cell("closing-voids", 1000, {0.22})});
  EXPECT_THAT(
      page,
      HasSubstr("## A: v_imp = 20 cm/s,\\\\n# \\<b>{x}\n\n![A](A.svg)\n\nPublished: b/a 0.24, "
                "period 9.36 h."));
  EXPECT_THAT(page, HasSubstr("| 1,000 | `dual` | 2 | 0.32 ± 0.03 | 0.95 ± 0.00 | 10.0 ± 0.0 | "
                              "0.00 | 0.00 | hit-and-run 2 | 7 |"));
  EXPECT_THAT(page, HasSubstr("| 1,000 | `closing-voids` | 1 | 0.22 | 0.95 | 10.0 |"));
  EXPECT_THAT(page, Not(HasSubstr("![B]")));
}

TEST(ConvergencePage, HasColumnsForTheTimeOfWhatWasPublished) {
  ConvergenceStudy study = two_cases();
  study.published_at_s = 1e5;
  ConvergenceCell c = cell("dual", 1000, {0.6, 0.6});
  c.at_published = {statistics::ensemble({0.30, 0.34}), statistics::ensemble({0.5, 0.5}), {}, 0.5};
  const std::string page = convergence_page(study, {c, cell("dual", 20000, {0.6})}, {});
  EXPECT_THAT(
      page,
      HasSubstr("| core-s | b/a at 100000 s | M_1/M at 100000 s | P(EER of 3) at 100000 s |\n"));
  EXPECT_THAT(page, HasSubstr("| 7 | 0.32 ± 0.03 | 0.50 ± 0.00 | 0.50 |\n"));
  EXPECT_THAT(page, HasSubstr("| 7 | - | - | - |\n"));
}

TEST(ConvergencePage, SaysFromWhichParticleNumberOnASchemeIsRight) {
  const std::string page =
      page_of({cell("dual", 1000, {0.30}), cell("dual", 20000, {0.25}),
               cell("closing-voids", 1000, {0.25}), cell("closing-voids", 20000, {0.23})});
  EXPECT_THAT(page, HasSubstr("- `dual`: near its own 20,000 with no fewer; as published: from "
                              "20,000 on.\n"));
  EXPECT_THAT(page, HasSubstr("- `closing-voids`: near its own 20,000 from 1,000 on; as published: "
                              "from 1,000 on.\n"));
  // Rows of one particle number stand together.
  EXPECT_LT(page.find("| 1,000 | `closing-voids`"), page.find("| 20,000 | `dual`"));
}

TEST(ConvergencePage, SaysWhereSeedsScatterMoreThanWhatIsAskedFor) {
  const char* chance = "By chance, perhaps: the means of b/a are known to 0.08";
  EXPECT_THAT(page_of({cell("dual", 1000, {0.4, 0.6}), cell("dual", 20000, {0.45, 0.55})}),
              HasSubstr(chance));
  EXPECT_THAT(page_of({cell("dual", 1000, {0.50, 0.51}), cell("dual", 20000, {0.50, 0.51})}),
              Not(HasSubstr("By chance")));
}

}  // namespace
}  // namespace eerie::studies
