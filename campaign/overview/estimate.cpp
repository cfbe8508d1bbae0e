#include "campaign/overview/estimate.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "campaign/manager/throughput.hpp"
#include "campaign/sweeps/fidelity.hpp"

namespace eerie::overview {
namespace fs = std::filesystem;
using text::both, text::data, text::shown;

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

std::string cost_sentence(const fs::path& database, const std::vector<db::NewJob>& jobs) {
  const std::string& fidelity = jobs.front().fidelity;
  const bool one =
      std::ranges::all_of(jobs, [&](const db::NewJob& job) { return job.fidelity == fidelity; });
  const std::string cheaper = one ? sweeps::cheaper_rung(fidelity) : "";
  return fmt::format("{}: about {:.2g} core-hours in all{}",
                     !one               ? "several fidelities"
                     : fidelity.empty() ? "settings without a name"
                                        : "fidelity " + fidelity,
                     estimate(database, jobs).core_hours,
                     cheaper.empty() ? "" : fmt::format(" ({})", cheaper));
}

text::Table table_of_jobs(const std::vector<db::NewJob>& jobs) {
  using db::NewJob;
  return text::table_of<NewJob>(
      {{shown("job"), [](const NewJob& j) { return j.hash.substr(0, 16); }},
       {data("hash"), [](const NewJob& j) { return j.hash; }},
       {both("q", "q"), [](const NewJob& j) { return j.q; }},
       {both("phi_d_deg", "phi_d deg"), [](const NewJob& j) { return j.phi_d_deg; }},
       {both("v_imp_cm_per_s", "v cm/s"), [](const NewJob& j) { return j.v_imp_cm_per_s; }},
       {both("theta_imp_deg", "theta deg"), [](const NewJob& j) { return j.theta_imp_deg; }},
       {both("particles_per_target", "particles"),
        [](const NewJob& j) { return j.particles_per_target; }},
       {both("seed", "seed"), [](const NewJob& j) { return j.seed; }},
       {both("expected_particle_steps", "particle-steps", "{:.3g}"),
        [](const NewJob& j) { return j.expected_particle_steps; }}},
      jobs);
}

}  // namespace eerie::overview
