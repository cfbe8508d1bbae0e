#include "campaign/maps/map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <set>

#include "analysis/paper/threshold.hpp"
#include "analysis/statistics/ensemble.hpp"
#include "campaign/maps/eer_fit.hpp"
#include "campaign/maps/map_csv.hpp"
#include "campaign/results/settings_choice.hpp"
#include "campaign/sweeps/job.hpp"
#include "campaign/text/given_folder.hpp"
#include "db/jobs/job_settings.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"

namespace eerie::maps {
namespace fs = std::filesystem;

namespace {

std::optional<double> mean(const std::vector<double>& numbers) {
  return statistics::mean_of(statistics::ensemble(numbers));
}

diagrams::PhaseCell cell(const db::MapPoint& p) {
  diagrams::PhaseCell c{p.v_imp_cm_per_s, p.theta_imp_deg};
  if (p.results == 0) {
    c.state = p.failed > 0 ? diagrams::CellState::failed : diagrams::CellState::pending;
    return c;
  }
  c.state = p.unsettled == 0 ? diagrams::CellState::done : diagrams::CellState::unsettled;
  c.outcome = p.outcome_class();
  c.class_share = p.share(p.classes.at(c.outcome));
  c.smaller_eer = p.smaller_is_eer > 0 && 2 * p.smaller_is_eer >= p.results;
  c.stale = p.stale > 0;
  c.b_over_a = mean(p.b_over_a), c.c_over_a = mean(p.c_over_a), c.period_h = mean(p.period_h);
  c.m_lr_over_m_total = mean(p.m_lr_over_m_total), c.n_eer = mean(p.n_eer);
  c.p_largest_eer = p.p_largest_eer();
  return c;
}

bool same_but_for_settings(const diagrams::PhaseDiagram& a, const diagrams::PhaseDiagram& b) {
  return a.q == b.q && a.phi_d_deg == b.phi_d_deg &&
         a.particles_per_target == b.particles_per_target;
}

std::set<std::int64_t> settings_of(const std::vector<diagrams::PhaseDiagram>& diagrams) {
  std::set<std::int64_t> ids;
  for (const diagrams::PhaseDiagram& d : diagrams) ids.insert(d.settings);
  return ids;
}

std::string no_job(const db::Connection& connection) {
  std::string known;
  for (const diagrams::PhaseDiagram& d : phase_diagrams(connection, {}))
    known +=
        fmt::format("\n  --q {} --phi-d {} --settings {}   {} particles{}{}", d.q, d.phi_d_deg,
                    d.settings, d.particles_per_target, d.fidelity.empty() ? "" : ", ", d.fidelity);
  return fmt::format("{}: holds no job with these parameters; {}{}", connection.path().string(),
                     known.empty() ? "it is empty" : "what it holds is", known);
}

bool up_to_date(const fs::path& picture, double newest_result_s) {
  std::error_code problem;
  const auto written = fs::last_write_time(picture, problem);
  if (problem) return false;
  const auto unix_time = std::chrono::file_clock::to_sys(written).time_since_epoch();
  return std::chrono::duration<double>(unix_time).count() >= newest_result_s;
}

}  // namespace

std::string map_label(const diagrams::PhaseDiagram& diagram,
                      const std::vector<diagrams::PhaseDiagram>& all) {
  std::string text =
      fmt::format("q{}-phi{}-n{}", diagram.q, diagram.phi_d_deg, diagram.particles_per_target);
  if (std::ranges::count_if(all, [&](const diagrams::PhaseDiagram& other) {
        return same_but_for_settings(diagram, other);
      }) > 1)
    text += fmt::format("-s{}", diagram.settings);
  return text;
}

std::vector<diagrams::PhaseDiagram> phase_diagrams(const std::vector<db::MapPoint>& points) {
  std::vector<diagrams::PhaseDiagram> diagrams;
  const db::MapPoint* before = nullptr;
  for (const db::MapPoint& p : points) {
    if (before == nullptr || !same_map(p, *before)) {
      diagrams::PhaseDiagram diagram;
      diagram.q = p.q, diagram.phi_d_deg = p.phi_d_deg;
      diagram.particles_per_target = p.particles_per_target;
      diagram.v_esc_cm_per_s = p.v_imp_cm_per_s / p.v_over_v_esc;
      diagram.threshold_cm_per_s = paper::published_threshold(p.q, p.phi_d_deg);
      diagram.settings = p.settings, diagram.fidelity = p.fidelity;
      diagrams.push_back(std::move(diagram));
    }
    diagrams.back().cells.push_back(cell(p));
    before = &p;
  }
  return diagrams;
}

std::vector<diagrams::PhaseDiagram> phase_diagrams(const db::Connection& connection,
                                                   const db::MapFilter& filter) {
  return phase_diagrams(db::map_points(connection, filter));
}

std::vector<fs::path> draw_sweep_maps(const db::Connection& connection, std::int64_t sweep,
                                      const std::string& sweep_name) {
  db::MapFilter filter;
  filter.sweep = sweep;
  const std::vector<diagrams::PhaseDiagram> diagrams = phase_diagrams(connection, filter);
  const double newest = db::newest_result(connection, sweep);
  if (newest == 0) return {};
  std::vector<fs::path> pictures;
  for (const diagrams::PhaseDiagram& diagram : diagrams) {
    std::string stem = connection.path().stem().string();
    if (stem != sweep_name) stem += "-" + sweep_name;
    stem += "-b-over-a";
    if (diagrams.size() > 1) stem += "-" + map_label(diagram, diagrams);
    const fs::path file = connection.path().parent_path() / stem;
    for (const char* extension : {".png", ".svg"}) {
      pictures.push_back(file.string() + extension);
      if (!up_to_date(pictures.back(), newest))
        diagrams::draw_phase_diagram(pictures.back(), diagram);
    }
    filter.q = diagram.q, filter.phi_d_deg = diagram.phi_d_deg, filter.settings = diagram.settings;
    const fs::path table = file.string() + ".csv";
    if (!up_to_date(table, newest))
      install_text(table, map_csv(db::map_points(connection, filter)));
  }
  return pictures;
}

void require_map_files(const std::vector<fs::path>& files, const std::string& option) {
  for (const fs::path& file : files) {
    if (const std::string kind = file.extension().string();
        kind != ".png" && kind != ".svg" && kind != ".pdf" && kind != ".csv")
      throw InputError(
          fmt::format("{} {}: must end in .png, .svg or .pdf, or in .csv for the numbers alone; "
                      "for example {} map.png",
                      option, file.string(), option));
    text::require_folder_of(file);
  }
}

void require_one_figure(const std::vector<db::NewJob>& jobs, const std::string& option) {
  constexpr const char* mend = "leave it out, all of them are drawn beside the database";
  if (const std::size_t all = db::count_settings(jobs); all > 1)
    throw InputError(fmt::format("{}: the sweep has {} settings, which make maps of their own; {}",
                                 option, all, mend));
  std::set<std::pair<double, double>> panels;
  for (const db::NewJob& job : jobs) panels.emplace(job.q, job.phi_d_deg);
  if (panels.size() > diagrams::most_panels)
    throw InputError(fmt::format(
        "{}: the sweep makes {} maps (of q and phi_d), {} are the most in one figure; {}", option,
        panels.size(), diagrams::most_panels, mend));
}

std::vector<fs::path> draw_named_maps(const db::Connection& connection, const NamedMaps& request) {
  const std::vector<db::MapPoint> points = db::map_points(connection, request.filter);
  diagrams::PhaseFigure figure{phase_diagrams(points), request.quantities};
  if (points.empty()) throw InputError(no_job(connection));
  std::vector<std::optional<paper::EerRegion>> regions;
  if (std::ranges::count(request.quantities, diagrams::MapQuantity::p_largest_eer) > 0) {
    regions = eer_regions(points);
    const bool drawn = std::ranges::any_of(
        request.files, [](const fs::path& file) { return file.extension() != ".csv"; });
    for (std::size_t k = 0; drawn && k < regions.size(); ++k)
      if (regions[k]) figure.diagrams[k].borders = borders_of(*regions[k], figure.diagrams[k]);
  }
  std::vector<fs::path> written;
  for (const fs::path& file : request.files) {
    if (file.extension() == ".csv") continue;
    results::require_one_settings(connection, settings_of(figure.diagrams));
    diagrams::draw_phase_figure(file, figure);
    written.push_back(file);
  }
  for (const fs::path& file : request.files) {
    const fs::path table = fs::path(file).replace_extension(".csv");
    if (std::ranges::count(written, table) > 0) continue;
    install_text(table, map_csv(points, regions));
    written.push_back(table);
  }
  return written;
}

}  // namespace eerie::maps
