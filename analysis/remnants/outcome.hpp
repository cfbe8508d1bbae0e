#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace eerie::remnants {

/// The outcome of an impact, in the classes of Leinhardt & Stewart (2012, ApJ 745, 79).
/// docs/explanation/remnants.md gives the reasons.
enum class OutcomeClass {
  perfect_merging,
  graze_and_merge,
  partial_accretion,
  hit_and_run,
  erosion,
  catastrophic_disruption
};

struct OutcomeName {
  OutcomeClass outcome;
  std::string_view name;        ///< its name in results and queries
  std::string_view short_name;  ///< one or two letters, for maps
};
inline constexpr std::array<OutcomeName, 6> outcome_names = {{
    {OutcomeClass::perfect_merging, "perfect-merging", "M"},
    {OutcomeClass::graze_and_merge, "graze-and-merge", "G"},
    {OutcomeClass::partial_accretion, "partial-accretion", "A"},
    {OutcomeClass::hit_and_run, "hit-and-run", "H"},
    {OutcomeClass::erosion, "erosion", "E"},
    {OutcomeClass::catastrophic_disruption, "catastrophic-disruption", "D"},
}};

std::string_view name(OutcomeClass outcome);
/// The class of this name; nothing where `name` is none of outcome_names.
std::optional<OutcomeClass> outcome_named(std::string_view name);

/// The masses that decide the class, kg. m_lr and m_slr are those of the largest and second largest
/// *bound group*, that is, a remnant with everything that is bound to it.
struct OutcomeMasses {
  double target = 0, impactor = 0;
  double m_lr = 0, m_slr = 0;
};

/// The thresholds of the classes, as fractions.
inline constexpr double perfect_merging_m_lr_over_m_total = 0.9;
inline constexpr double hit_and_run_m_slr_over_m_impactor = 0.5;
inline constexpr double hit_and_run_both_over_m_total = 0.8;
inline constexpr double catastrophic_m_lr_over_m_total = 0.5;

/// Returns the first class that applies: perfect merging (m_lr >= 0.9 M), hit-and-run (m_slr >= 0.5
/// M_i and m_lr + m_slr >= 0.8 M), catastrophic disruption (m_lr < 0.5 M), partial accretion (m_lr
/// > M_t), erosion. A merger or accretion is graze-and-merge where the two bodies came apart
/// between first contact and the end; only a history shows this.
OutcomeClass classify(const OutcomeMasses& masses, bool separated_after_contact = false);

}  // namespace eerie::remnants
