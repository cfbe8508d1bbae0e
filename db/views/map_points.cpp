#include "db/views/map_points.hpp"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "db/jobs/rows.hpp"
#include "db/store/bind.hpp"

namespace eerie::db {
namespace {

/// The columns of select_jobs in their order: by name each would be looked up for every job.
namespace at {
enum Column {
  q,
  phi_d_deg,
  v_imp_cm_per_s,
  theta_imp_deg,
  v_over_v_esc,
  particles_per_target,
  settings,
  fidelity,
  state,
  running,
  outcome,
  b_over_a,
  c_over_a,
  period_h,
  m_lr_over_m_total,
  n_eer,
  eer,
  settled,
  stale,
};
}  // namespace at

constexpr const char* select_jobs = R"sql(
SELECT j.q, j.phi_d_deg, j.v_imp_cm_per_s, j.theta_imp_deg, j.v_over_v_esc, j.particles_per_target,
       j.settings, j.fidelity, j.state, iif(j.state = 'running', j.hash, NULL) AS running,
       r.class, r.b_over_a, r.c_over_a, r.period_h, r.m_lr_over_m_total, r.n_eer, r.eer, r.settled, r.solver_version <> now.value AS stale
FROM jobs j LEFT JOIN job_results r ON r.job_id = j.id
     LEFT JOIN settings now ON now.key = 'solver_version'
WHERE (:sweep IS NULL OR j.id IN (SELECT job_id FROM sweep_jobs WHERE sweep_id = :sweep))
  AND (:q IS NULL OR j.q = :q) AND (:phi_d IS NULL OR j.phi_d_deg = :phi_d)
  AND (:particles IS NULL OR j.particles_per_target = :particles)
  AND (:fidelity IS NULL OR j.fidelity = :fidelity)
  AND (:settings IS NULL OR j.settings = :settings)
ORDER BY j.id
)sql";

template <class T>
void bind_named(SQLite::Statement& select, const char* name, const std::optional<T>& value) {
  if (value)
    select.bind(name, *value);
  else
    select.bind(name);
}

MapPoint place(const SQLite::Statement& row) {
  MapPoint p;
  p.q = row.getColumn(at::q).getDouble();
  p.phi_d_deg = row.getColumn(at::phi_d_deg).getDouble();
  p.v_imp_cm_per_s = row.getColumn(at::v_imp_cm_per_s).getDouble();
  p.theta_imp_deg = row.getColumn(at::theta_imp_deg).getDouble();
  p.v_over_v_esc = row.getColumn(at::v_over_v_esc).getDouble();
  p.particles_per_target = row.getColumn(at::particles_per_target).getInt64();
  p.settings = row.getColumn(at::settings).getInt64();
  return p;
}

/// Points are gathered under it: a sort of all jobs would take longer than all else.
auto key(const MapPoint& p) {
  return std::tuple(p.q, p.phi_d_deg, p.particles_per_target, p.settings, p.v_imp_cm_per_s,
                    p.theta_imp_deg);
}

void note(std::vector<double>& numbers, const SQLite::Column& column) {
  if (!column.isNull()) numbers.push_back(column.getDouble());
}

/// A job of the place.
void add(MapPoint& p, const SQLite::Statement& row) {
  ++p.jobs;
  if (const SQLite::Column name = row.getColumn(at::fidelity); !name.isNull())
    p.fidelity = name.getString();
  const std::string state = row.getColumn(at::state).getString();
  p.done += state == name(job_state_names, JobState::done);
  p.failed += state == name(job_state_names, JobState::failed);
  p.cancelled += state == name(job_state_names, JobState::cancelled);
  if (const SQLite::Column hash = row.getColumn(at::running); !hash.isNull())
    p.running.push_back(hash.getString());
  if (row.getColumn(at::outcome).isNull()) return;
  ++p.results;
  ++p.classes[row.getColumn(at::outcome).getString()];
  const int n_eer = row.getColumn(at::n_eer).getInt(), eer = row.getColumn(at::eer).getInt() != 0;
  p.largest_is_eer += eer;
  p.smaller_is_eer += n_eer > eer;
  p.unsettled += row.getColumn(at::settled).getInt() == 0;
  p.stale += row.getColumn(at::stale).getInt() != 0;
  note(p.b_over_a, row.getColumn(at::b_over_a));
  note(p.c_over_a, row.getColumn(at::c_over_a));
  note(p.period_h, row.getColumn(at::period_h));
  note(p.m_lr_over_m_total, row.getColumn(at::m_lr_over_m_total));
  note(p.n_eer, row.getColumn(at::n_eer));
}

}  // namespace

std::string MapPoint::outcome_class() const {
  const auto most =
      std::ranges::max_element(classes, {}, &std::pair<const std::string, std::int64_t>::second);
  return most == classes.end() ? "" : most->first;
}

std::vector<MapPoint> map_points(const Connection& connection, const MapFilter& filter) {
  std::map<decltype(key({})), MapPoint> gathered;
  connection.read([&](SQLite::Database& sql) {
    SQLite::Statement select(sql, select_jobs);
    bind_named(select, ":sweep", filter.sweep);
    bind_named(select, ":q", filter.q);
    bind_named(select, ":phi_d", filter.phi_d_deg);
    bind_named(select, ":particles", filter.particles_per_target);
    bind_named(select, ":fidelity", filter.fidelity);
    bind_named(select, ":settings", filter.settings);
    while (select.executeStep()) {
      const MapPoint here = place(select);
      add(gathered.try_emplace(key(here), here).first->second, select);
    }
  });
  std::vector<MapPoint> points;
  for (auto& [at, point] : gathered) points.push_back(std::move(point));
  return points;
}

std::vector<MapName> map_names(const Connection& connection) {
  std::map<std::tuple<double, double, std::int64_t, std::int64_t>, MapName> gathered;
  connection.read([&](SQLite::Database& sql) {
    SQLite::Statement select(sql, R"(
        SELECT q, phi_d_deg, particles_per_target, settings, state = 'done', fidelity FROM jobs)");
    while (select.executeStep()) {
      const double q = select.getColumn(0).getDouble(), phi_d = select.getColumn(1).getDouble();
      const std::int64_t particles = select.getColumn(2).getInt64(),
                         settings = select.getColumn(3).getInt64();
      const auto [at, is_new] = gathered.try_emplace({q, phi_d, particles, settings});
      MapName& map = at->second;
      if (is_new)
        map = {.q = q, .phi_d_deg = phi_d, .particles_per_target = particles, .settings = settings};
      map.fidelity =
          std::max(map.fidelity, select.getColumn(5).getString());  // older jobs have none
      ++map.jobs;
      map.done += select.getColumn(4).getInt();
    }
  });
  std::vector<MapName> names;
  for (auto& [at, name] : gathered) names.push_back(std::move(name));
  return names;
}

}  // namespace eerie::db
