#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "campaign/cli/commands.hpp"
#include "campaign/cli/output/text_table.hpp"
#include "campaign/manager/throughput.hpp"
#include "campaign/sweeps/job.hpp"
#include "campaign/sweeps/plan.hpp"
#include "db/jobs/jobs.hpp"
#include "solver/base/error.hpp"

namespace eerie::cli {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

struct Estimate {
  std::size_t unknown = 0;
  double core_hours = 0;
  double speed = 0;
  bool measured = false;
};

Estimate estimate(const fs::path& database, const std::vector<db::NewJob>& jobs) {
  Estimate e;
  e.unknown = jobs.size();
  db::Speed speed = manager::assumed_speed;
  std::error_code ignored;
  if (fs::exists(database, ignored)) {
    const db::Connection connection(database, db::Access::read);
    e.unknown = db::count_unknown(connection, jobs);
    const db::Speed found = db::speed(connection);
    e.measured = found.is_measured();
    if (e.measured) speed = found;
  }
  double particle_steps = 0;
  for (const db::NewJob& job : jobs) particle_steps += job.expected_particle_steps;
  e.speed = speed.particle_steps_per_core_second();
  e.core_hours = speed.core_seconds_of(particle_steps) / 3600;
  return e;
}

json job_json(const db::NewJob& job) {
  return {{"hash", job.hash},
          {"q", job.q},
          {"phi_d_deg", job.phi_d_deg},
          {"v_imp_cm_per_s", job.v_imp_cm_per_s},
          {"theta_imp_deg", job.theta_imp_deg},
          {"particles_per_target", job.particles_per_target},
          {"seed", job.seed},
          {"expected_particle_steps", job.expected_particle_steps}};
}

std::string job_table(const std::vector<db::NewJob>& jobs) {
  std::vector<std::vector<std::string>> rows = {
      {"job", "q", "phi_d deg", "v cm/s", "theta deg", "particles", "seed", "particle-steps"}};
  for (const db::NewJob& j : jobs)
    rows.push_back({j.hash.substr(0, 16), fmt::format("{}", j.q), fmt::format("{}", j.phi_d_deg),
                    fmt::format("{}", j.v_imp_cm_per_s), fmt::format("{}", j.theta_imp_deg),
                    fmt::format("{}", j.particles_per_target), fmt::format("{}", j.seed),
                    fmt::format("{:.3g}", j.expected_particle_steps)});
  return text_table(rows);
}

}  // namespace

int expand(const ExpandArguments& a) {
  const sweeps::Plan plan = sweeps::load_plan(a.sweep, a.changes.all());
  const std::vector<db::NewJob>& jobs = plan.jobs;
  const std::vector<std::string> warned = sweeps::cautions(plan.scenes);
  const Estimate e = estimate(a.database, jobs);
  if (a.json) {
    json report = {{"sweep", plan.sweep.name},
                   {"database", a.database.string()},
                   {"jobs", jobs.size()},
                   {"new", e.unknown},
                   {"core_hours", e.core_hours},
                   {"particle_steps_per_core_second", e.speed},
                   {"speed_is_measured", e.measured},
                   {"warnings", warned}};
    if (a.list)
      for (const db::NewJob& job : jobs) report["list"].push_back(job_json(job));
    fmt::print("{}\n", report.dump(1));
    return static_cast<int>(ExitCode::done);
  }
  if (a.list) fmt::print("{}\n", job_table(jobs));
  fmt::print("{}: {} jobs, {} of them new to {}\n", plan.sweep.name, jobs.size(), e.unknown,
             a.database.string());
  fmt::print(
      "about {:.3g} core-hours for all of them, at {} particle-steps per second and core ({})\n",
      e.core_hours, magnitude(e.speed),
      e.measured ? "as measured in this database" : "assumed: nothing is measured yet");
  print_warnings(warned);
  return static_cast<int>(ExitCode::done);
}

}  // namespace eerie::cli
