#include "campaign/results/run_statistics.hpp"

#include <fmt/format.h>

#include <map>
#include <span>

#include "analysis/remnants/remnants.hpp"
#include "campaign/text/csv.hpp"

namespace eerie::results {

namespace {

/// So many of the largest have columns of their own.
constexpr std::size_t shown_remnants = 3;

}  // namespace

std::string count_classes(const std::vector<std::string>& classes) {
  std::map<std::string, int> counts;
  for (const std::string& name : classes) ++counts[name];
  std::string text;
  for (const auto& [name, count] : counts)
    text += fmt::format("{}{} {}", text.empty() ? "" : "; ", name, count);
  return text;
}

bool has_eer(const db::Result& result, const std::vector<db::Remnant>& remnants, EerAmong among) {
  const auto is_eer = [](const db::Remnant& m) {
    return m.b_over_a && *m.b_over_a < remnants::eer_max_b_over_a;
  };
  switch (among) {
    case EerAmong::largest:
      return !remnants.empty() && is_eer(remnants.front());
    case EerAmong::three_largest:
      return std::ranges::any_of(
          std::span(remnants).first(std::min<std::size_t>(remnants.size(), 3)),
          [&](const db::Remnant& m) { return m.mass_over_total >= eer_least_mass && is_eer(m); });
    case EerAmong::any:
      break;
  }
  return result.n_eer > 0;  // the list may lack the smaller ones
}

std::string remnant_header(const char* when) {
  std::string names;
  for (std::size_t k = 1; k <= shown_remnants; ++k)
    names += fmt::format(",m_{0}_over_m_total{1},b_over_a_{0}{1},c_over_a_{0}{1},period_{0}_h{1}",
                         k, when);
  return names;
}

std::string remnant_fields(const std::vector<db::Remnant>& remnants) {
  std::string fields;
  for (std::size_t k = 0; k < shown_remnants; ++k)
    if (k < remnants.size()) {
      const db::Remnant& m = remnants[k];
      fields += fmt::format(",{:.6g},{},{},{}", m.mass_over_total, text::csv_number(m.b_over_a),
                            text::csv_number(m.c_over_a), text::csv_number(m.spin_period_h));
    } else {
      fields += ",,,,";
    }
  return fields;
}

std::string run_end_fields(const db::ResultRow& row, std::optional<double> core_seconds) {
  const db::Result& x = row.result;
  return fmt::format(",{},{},{:.6g},{},{},{}\n", x.n_eer, text::csv_number(x.dL_over_L),
                     x.particle_steps, core_seconds ? fmt::format("{:.4g}", *core_seconds) : "",
                     x.solver_version, row.hash);
}

}  // namespace eerie::results
