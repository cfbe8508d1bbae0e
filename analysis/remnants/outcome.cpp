#include "analysis/remnants/outcome.hpp"

#include <algorithm>

namespace eerie::remnants {

std::string_view name(OutcomeClass outcome) {
  return std::ranges::find(outcome_names, outcome, &OutcomeName::outcome)->name;
}

std::optional<OutcomeClass> outcome_named(std::string_view name) {
  const auto* row = std::ranges::find(outcome_names, name, &OutcomeName::name);
  if (row == outcome_names.end()) return std::nullopt;
  return row->outcome;
}

OutcomeClass classify(const OutcomeMasses& m, bool separated_after_contact) {
  const double total = m.target + m.impactor;
  if (m.m_lr >= perfect_merging_m_lr_over_m_total * total)
    return separated_after_contact ? OutcomeClass::graze_and_merge : OutcomeClass::perfect_merging;
  if (m.m_slr >= hit_and_run_m_slr_over_m_impactor * m.impactor &&
      m.m_lr + m.m_slr >= hit_and_run_both_over_m_total * total)
    return OutcomeClass::hit_and_run;
  if (m.m_lr < catastrophic_m_lr_over_m_total * total) return OutcomeClass::catastrophic_disruption;
  if (m.m_lr > m.target)
    return separated_after_contact ? OutcomeClass::graze_and_merge
                                   : OutcomeClass::partial_accretion;
  return OutcomeClass::erosion;
}

}  // namespace eerie::remnants
