#include "analysis/paper/facts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace eerie::paper {

namespace {

constexpr double any = std::numeric_limits<double>::infinity();
constexpr double coulomb_40 = 40, coulomb_50 = 50;  // phi_d, deg
constexpr ImpactPoint reference{20, 15}, third_remnant{24, 15}, unequal{25, 20};

PaperGrid grid(const char* name) {
  return *std::ranges::find(paper_grids(), std::string_view(name),
                            [](const PaperGrid& g) { return std::string_view(g.name); });
}

Fact of_point(const char* name, const char* statement, const char* source, double q, double phi_d,
              ImpactPoint point, Claim claim) {
  return {name, statement, source, q, phi_d, point, {}, std::move(claim)};
}

Fact of_grids(const char* name, const char* statement, const char* source,
              std::vector<PaperGrid> grids, Claim claim) {
  const PaperGrid& first = grids.front();
  const double q = first.q, phi_d = first.phi_d_deg;
  return {name, statement, source, q, phi_d, std::nullopt, std::move(grids), std::move(claim)};
}

std::vector<Fact> make_facts() {
  const std::vector<PaperGrid> phi40 = paper_grids(1, coulomb_40),
                               phi50 = paper_grids(1, coulomb_50);
  const std::vector<PaperGrid> coarse = {grid("table2-fig2a")}, fine = {grid("table2-fig2b")};
  std::vector<Fact> facts;

  // The reference impact.
  facts.push_back(of_point("reference-b-over-a", "the largest remnant has b/a = 0.24",
                           "Sect. 3.1, Fig. 1", 1, coulomb_40, reference,
                           NumberIs{FactQuantity::b_over_a, 0.24}));
  facts.push_back(of_point("reference-period", "it spins once in 9.36 h", "Sect. 3.1", 1,
                           coulomb_40, reference, NumberIs{FactQuantity::period_h, 9.36}));
  facts.push_back(of_point("reference-merges", "it holds almost all of both bodies", "Sect. 3.1", 1,
                           coulomb_40, reference, AlmostMerges{}));
  facts.push_back(of_point("reference-lasts", "it is still elongated at 1e5 s, three turns on",
                           "Sect. 3.1, Fig. 1", 1, coulomb_40, reference, ShapeLasts{1e5}));
  facts.push_back(of_point("reference-stiffness",
                           "A and B of the equation of state ten times larger give the same shape",
                           "Appendix A", 1, coulomb_40, reference, StiffnessIsIdle{10}));

  // Equal bodies, 40 deg.
  facts.push_back(of_grids("phi40-ridge", "EERs lie about v sin(theta) = 5.1 cm/s",
                           "Sect. 3.1, Fig. 2b", fine, RidgeIsAt{5.1}));
  facts.push_back(of_grids("phi40-bounds", "EERs need theta <= 20 deg and v <= 25 cm/s",
                           "Sect. 3.1 (24 cm/s in Sect. 5)", phi40,
                           EersOnlyIn{{{0, 25}, {0, 20}}}));
  facts.push_back(of_grids(
      "phi40-coarse", "the coarse grid shows EERs only at theta = 15 deg and v = 15 to 21 cm/s",
      "Sect. 3.1, Fig. 2a", coarse, EersOnlyIn{{{15, 21}, {15, 15}}}));
  facts.push_back(of_grids("phi40-merged", "every EER that is the largest remnant is a merger",
                           "Sect. 3.1", phi40, EersAreMerged{}));
  facts.push_back(of_grids(
      "phi40-fast", "along the ridge, impacts of 25 cm/s and more are mainly catastrophic",
      "Sect. 3.1", phi40,
      MostlyOfClass{remnants::OutcomeClass::catastrophic_disruption, 5.1, {{25, any}, {0, 90}}}));
  facts.push_back(of_grids(
      "phi40-oblique", "along the ridge, impacts at 20 deg and more are mainly hit-and-run",
      "Sect. 3.1", phi40,
      MostlyOfClass{remnants::OutcomeClass::hit_and_run, 5.1, {{0, any}, {20, 90}}}));
  facts.push_back(of_point("phi40-third", "at 24 cm/s and 15 deg a smaller remnant is an EER",
                           "Sect. 3.1, Fig. 3", 1, coulomb_40, third_remnant, SmallerIsEer{}));
  facts.push_back(of_point("phi40-third-mass", "that remnant holds 0.24 of the target's mass",
                           "Sect. 3.1", 1, coulomb_40, third_remnant,
                           NumberIs{FactQuantity::mass_over_target, 0.24, true}));
  facts.push_back(of_point("phi40-third-b-over-a", "that remnant has b/a = 0.27", "Sect. 3.1", 1,
                           coulomb_40, third_remnant,
                           NumberIs{FactQuantity::b_over_a, 0.27, true}));
  facts.push_back(of_grids("phi40-third-alone", "no other impact makes a smaller EER", "Sect. 3.1",
                           phi40, SmallerEersOnlyIn{1, {{24, 24}, {15, 15}}}));

  // Other friction angles.
  facts.push_back(of_grids("phi50-ridge", "EERs lie about v sin(theta) = 7.4 cm/s",
                           "Sect. 3.2, Fig. 4", phi50, RidgeIsAt{7.4}));
  facts.push_back(of_grids("phi50-bounds", "EERs need theta <= 30 deg and v <= 35 cm/s",
                           "Sect. 3.2, Fig. 4", phi50, EersOnlyIn{{{0, 35}, {0, 30}}}));
  facts.push_back(
      of_grids("phi50-smaller",
               "smaller remnants are EERs at four points about theta = 25 deg, v = 20 to 30 cm/s",
               "Sect. 3.2", phi50, SmallerEersOnlyIn{4, {{20, 30}, {25, 25}}}));
  facts.push_back(of_grids("phi30-none", "friction angle 30 deg: no EER", "Sect. 3.2",
                           paper_grids(1, 30), NoEer{}));

  // Unequal bodies, 50 deg.
  facts.push_back(of_point("q05-b-over-a", "the largest remnant has b/a = 0.27",
                           "Sect. 3.3, Fig. 5", 0.5, coulomb_50, unequal,
                           NumberIs{FactQuantity::b_over_a, 0.27}));
  facts.push_back(of_point("q05-mass", "it holds 1.1 target masses", "Sect. 3.3", 0.5, coulomb_50,
                           unequal, NumberIs{FactQuantity::mass_over_target, 1.1}));
  facts.push_back(of_point("q05-a", "it is 263 m long", "Sect. 3.3", 0.5, coulomb_50, unequal,
                           NumberIs{FactQuantity::a_m, 263}));
  facts.push_back(of_point("q05-b", "and 72 m wide", "Sect. 3.3", 0.5, coulomb_50, unequal,
                           NumberIs{FactQuantity::b_m, 72}));
  facts.push_back(of_grids("q05-three", "EERs at 20 deg and 23, 25, 27 cm/s, and nowhere else",
                           "Sects. 3.3 and 5, Fig. 6", paper_grids(0.5, coulomb_50),
                           EersExactlyAt{{{23, 20}, {25, 20}, {27, 20}}}));
  facts.push_back(of_grids("q025-none", "impactor of a quarter of the mass: no EER", "Sect. 3.3",
                           paper_grids(0.25, coulomb_50), NoEer{}));
  facts.push_back(of_grids("q025-classes",
                           "and yet merging, hit-and-run and catastrophic disruption all occur",
                           "Sect. 3.3", paper_grids(0.25, coulomb_50), AllClassesOccur{}));
  return facts;
}

}  // namespace

const std::vector<PaperGrid>& paper_grids() {
  static const std::vector<PaperGrid> grids = {
      {"table2-fig2a", 1, 40, 12, 36, 3, 5, 30, 5},
      {"table2-fig2b", 1, 40, 15, 30, 1, 7.5, 20, 2.5},
      {"table2-fig4", 1, 50, 12.5, 40, 2.5, 5, 40, 5},
      {"table2-phi30", 1, 30, 12.5, 35, 2.5, 5, 20, 5},
      {"table2-fig6", 0.5, 50, 15, 35, 2, 10, 35, 5},
      {"table2-q025", 0.25, 50, 15, 55, 4, 10, 35, 5},
  };
  return grids;
}

std::vector<PaperGrid> paper_grids(double q, double phi_d_deg) {
  std::vector<PaperGrid> found;
  for (const PaperGrid& g : paper_grids())
    if (g.q == q && g.phi_d_deg == phi_d_deg) found.push_back(g);
  return found;
}

std::vector<ImpactPoint> points_of(const std::vector<PaperGrid>& grids) {
  std::vector<ImpactPoint> points;
  const auto steps = [](double from, double to, double step) {
    return static_cast<int>(std::lround((to - from) / step));
  };
  for (const PaperGrid& g : grids)
    for (int i = 0; i <= steps(g.theta_from, g.theta_to, g.theta_step); ++i)
      for (int k = 0; k <= steps(g.v_from, g.v_to, g.v_step); ++k)
        points.push_back({g.v_from + k * g.v_step, g.theta_from + i * g.theta_step});
  const auto place = [](const ImpactPoint& p) {
    return std::pair(p.theta_imp_deg, p.v_imp_cm_per_s);
  };
  std::ranges::sort(points, {}, place);
  const auto same_place = [&](const ImpactPoint& a, const ImpactPoint& b) {
    return place(a) == place(b);
  };
  points.erase(std::unique(points.begin(), points.end(), same_place), points.end());
  return points;
}

const std::vector<Fact>& paper_facts() {
  static const std::vector<Fact> facts = make_facts();
  return facts;
}

}  // namespace eerie::paper
