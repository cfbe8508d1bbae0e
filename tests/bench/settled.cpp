// What the settled stop would have done to runs that went on: for each job directory with
// snapshots, when it would have ended the run, and what changed after that. Usage: eerie_settled
// JOBS_FOLDER OUT.csv [WINDOW_S [SHAPE [SPIN [FALL_BACK]]]]

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "analysis/ending/steadiness.hpp"
#include "analysis/remnants/analysis.hpp"
#include "campaign/job_folder/history.hpp"
#include "campaign/job_folder/job_directory.hpp"
#include "solver/base/constants.hpp"
#include "solver/base/file.hpp"

namespace eerie {
namespace {
using namespace remnants;
using namespace ending;
using namespace job_folder;
using namespace io;
namespace fs = std::filesystem;

/// What users want of a state.
struct Answer {
  double time = 0;
  std::string outcome;
  double m_lr = 0, b_over_a = 0, c_over_a = 0, period_h = 0;
  int n_eer = 0;
};

Answer answer(const Snapshot& snapshot, const JobDirectory& job) {
  std::vector<HistoryRow> past = read_history(job.history());
  std::erase_if(past, [&](const HistoryRow& r) { return r.time_s > snapshot.state.time; });
  const Analysis a = analyse(snapshot, separated_after_contact(past, snapshot.scene.impact.q));
  Answer x{snapshot.state.time, std::string(name(a.outcome)), a.m_lr_over_m_total, 0, 0, 0, 0};
  for (const Remnant& r : a.remnants) x.n_eer += r.eer;
  if (!a.remnants.empty()) {
    const Remnant& largest = a.remnants.front();
    x.b_over_a = largest.shape.b_over_a(), x.c_over_a = largest.shape.c_over_a();
    x.period_h = largest.spin_period.value_or(0) / 3600;
  }
  return x;
}

std::vector<fs::path> snapshots_of(const fs::path& directory) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(directory))
    if (entry.path().filename().string().starts_with("snapshot_")) files.push_back(entry.path());
  std::ranges::sort(files);
  files.push_back(directory / "final.hdf5");
  return files;
}

std::string row_of(const JobDirectory& job, const Scene::Settled& settled) {
  std::vector<RemnantLook> looks;
  std::optional<Answer> stop;
  Answer last;
  Scene scene;
  const double interval = settled.window_s / looks_per_window;
  long done = 0;
  for (const fs::path& file : snapshots_of(job.path)) {
    const Snapshot snapshot = read_snapshot(file);
    const double now = snapshot.state.time;
    scene = snapshot.scene;
    last = answer(snapshot, job);
    if (stop || std::floor(now / interval + 1e-9) <= static_cast<double>(done)) continue;
    done = static_cast<long>(std::floor(now / interval + 1e-9));
    const Remnants found = find_remnants(snapshot.state);
    const std::vector<RemnantLook> rows = look(now, found, settled);
    looks.insert(looks.end(), rows.begin(), rows.end());
    const double mass = snapshot.state.mass * static_cast<double>(snapshot.state.size());
    if (encounters(found, mass, horizon(scene.end, now), settled).empty() &&
        unsteadiness(looks, settled).empty())
      stop = last;
  }
  const Answer at = stop.value_or(last);
  return fmt::format(
      "{},{},{},{},{},{},{:.0f},{:.0f},{},{},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},"
      "{:.4f},{:.3f},{:.3f},{},{}\n",
      scene.impact.q, scene.material.drucker_prager.phi_d_deg, scene.impact.v_imp_cm_per_s,
      scene.impact.theta_imp_deg, scene.numerics.particles_per_target, scene.numerics.seed,
      stop ? at.time : -1, last.time, at.outcome, last.outcome, at.b_over_a, last.b_over_a,
      at.c_over_a, last.c_over_a, at.m_lr, last.m_lr, at.period_h, last.period_h, at.n_eer,
      last.n_eer);
}

int replay(int argc, char** argv) {
  const Scene defaults = parse_scene(
      nlohmann::json{{"target", {{"radius_m", 50}}},
                     {"impact", {{"q", 1}, {"v_imp_cm_per_s", 20}, {"theta_imp_deg", 15}}},
                     {"material", {{"drucker_prager", {{"phi_d_deg", 40}}}}}});
  Scene::Settled settled = defaults.end.settled;
  settled.window_s = argc > 3 ? std::stod(argv[3]) : 4000;
  if (argc > 4) settled.shape = std::stod(argv[4]);
  if (argc > 5) settled.spin = std::stod(argv[5]);
  if (argc > 6) settled.fall_back = std::stod(argv[6]);
  std::vector<std::string> rows;
  for (const auto& entry : fs::directory_iterator(argv[1]))
    if (const JobDirectory job{entry.path()}; fs::exists(job.result()))
      rows.push_back(row_of(job, settled));
  std::ranges::sort(rows);
  std::string csv =
      "q,phi_d_deg,v_imp_cm_per_s,theta_imp_deg,particles_per_target,seed,stop_s,end_s,class_stop,"
      "class_end,b_over_a_stop,b_over_a_end,c_over_a_stop,c_over_a_end,m_lr_over_m_total_stop,"
      "m_lr_over_m_total_end,period_stop_h,period_end_h,n_eer_stop,n_eer_end\n";
  for (const std::string& row : rows) csv += row;
  install_text(argv[2], csv);
  return 0;
}

}  // namespace
}  // namespace eerie

int main(int argc, char** argv) {
  if (argc < 3) {
    fmt::print(stderr,
               "usage: eerie_settled JOBS_FOLDER OUT.csv [WINDOW_S [SHAPE [SPIN [FALL_BACK]]]]\n");
    return 2;
  }
  return eerie::replay(argc, argv);
}
