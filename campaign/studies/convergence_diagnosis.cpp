#include "campaign/studies/convergence_diagnosis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "campaign/job_folder/history.hpp"

namespace eerie::studies {

namespace {

struct Column {
  const char* label;
  bool logarithmic;
  std::optional<double> (*value)(const job_folder::HistoryRow&);
};
/// Where a ratio says nothing there is no point.
std::optional<double> ratio(double above, double below) {
  return below > 0 ? std::optional(above / below) : std::nullopt;
}
constexpr Column diagnosis_columns[] = {
    {"viscous / elastic pressure", true,
     [](const job_folder::HistoryRow& r) {
       return ratio(r.viscous_pressure_Pa, r.eos_pressure_Pa);
     }},
    {"mass without pressure", false,
     [](const job_folder::HistoryRow& r) { return std::optional(r.pressureless); }},
    {"density / summed density", false,
     [](const job_folder::HistoryRow& r) {
       return ratio(r.density_kg_per_m3, r.summed_density_kg_per_m3);
     }},
    {"viscous heat / all heat", false,
     [](const job_folder::HistoryRow& r) {
       return ratio(r.viscous_heat_J, r.viscous_heat_J + r.friction_heat_J);
     }},
    {"|ΔL| / L", true, [](const job_folder::HistoryRow& r) { return std::optional(r.dL_over_L); }},
};

const ConvergenceResult* finest(const std::vector<ConvergenceResult>& results,
                                const std::string& case_name, const std::string& scheme) {
  const ConvergenceResult* best = nullptr;
  for (const ConvergenceResult& r : results)
    if (r.run.case_name == case_name && r.run.scheme == scheme && r.run.seed == 1 &&
        (best == nullptr || r.run.particles_per_target > best->run.particles_per_target))
      best = &r;
  return best;
}

/// Of the two bodies about their common centre at contact, J.
double kinetic_energy_at_contact(const Scene& scene) {
  const double v = scene.impact.v_imp_cm_per_s / 100;
  return 0.5 * target_mass(scene) * scene.impact.q / (1 + scene.impact.q) * v * v;
}

/// Heat of viscosity, of friction, and the most energy of shear over `kinetic`.
std::string energies_of(const std::vector<job_folder::HistoryRow>& rows, double kinetic) {
  const job_folder::HistoryRow& end = rows.back();
  if (end.internal_energy_J == 0) return ",,";
  const double shear =
      std::ranges::max(rows, {}, &job_folder::HistoryRow::shear_energy_J).shear_energy_J;
  return fmt::format("{:.3g},{:.3g},{:.3g}", end.viscous_heat_J / kinetic,
                     end.friction_heat_J / kinetic, shear / kinetic);
}

}  // namespace

std::optional<figures::ConvergenceFigure> diagnosis_figure(
    const ConvergenceStudy& study, const ConvergenceStudy::Case& one,
    const std::vector<ConvergenceResult>& results, const job_folder::JobFolder& jobs) {
  figures::ConvergenceFigure figure{one.title, {}, {}, true};
  for (const Column& column : diagnosis_columns)
    figure.panels.push_back({column.label, {}, {}, column.logarithmic});
  bool any = false;
  for (const std::string& scheme : study.schemes) {
    figure.series.push_back(scheme);
    for (figures::ConvergencePanel& panel : figure.panels) panel.series.emplace_back();
    const ConvergenceResult* run = finest(results, one.name, scheme);
    if (run == nullptr) continue;
    figure.series.back() += fmt::format(", {}", run->run.particles_per_target);
    for (const job_folder::HistoryRow& row :
         job_folder::read_history(jobs.of(run->row.hash).history()))
      for (std::size_t p = 0; p < figure.panels.size(); ++p)
        if (const auto value = diagnosis_columns[p].value(row)) {
          figure.panels[p].series.back().push_back({row.time_s / 1000, *value, 0, *value, *value});
          any = true;
        }
  }
  if (!any) return {};
  std::erase_if(figure.panels, [](const figures::ConvergencePanel& panel) {
    return std::ranges::all_of(panel.series, [](const auto& series) { return series.empty(); });
  });
  return figure;
}

std::string diagnosis_csv(const ConvergenceStudy& study,
                          const std::vector<ConvergenceResult>& results,
                          const job_folder::JobFolder& jobs) {
  std::string csv =
      "scheme,case,particles_per_target,viscous_heat_over_kinetic,friction_heat_over_kinetic,"
      "shear_energy_max_over_kinetic,time_s,eos_pressure_Pa,viscous_pressure_Pa,pressureless,"
      "density_kg_per_m3,summed_density_kg_per_m3,density_error,dL_over_L_at_end\n";
  for (const ConvergenceStudy::Case& one : study.cases)
    for (const std::string& scheme : study.schemes) {
      const ConvergenceResult* run = finest(results, one.name, scheme);
      if (run == nullptr) continue;
      const std::vector<job_folder::HistoryRow> rows =
          job_folder::read_history(jobs.of(run->row.hash).history());
      if (rows.empty()) continue;
      csv += fmt::format("{},{},{},{}", scheme, one.name, run->run.particles_per_target,
                         energies_of(rows, kinetic_energy_at_contact(run->run.scene)));
      const job_folder::HistoryRow& r =
          *std::ranges::min_element(rows, {}, [](const job_folder::HistoryRow& row) {
            return std::abs(row.time_s - diagnosis_time_s);
          });
      csv +=
          fmt::format(",{:.6g},{:.4g},{:.4g},{:.4g},{:.5g},{:.5g},{:.3g},{:.3g}\n", r.time_s,
                      r.eos_pressure_Pa, r.viscous_pressure_Pa, r.pressureless, r.density_kg_per_m3,
                      r.summed_density_kg_per_m3, r.density_error, rows.back().dL_over_L);
    }
  return csv;
}

}  // namespace eerie::studies
