#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include <map>

#include "db/bind.hpp"
#include "db/query.hpp"

namespace eerie::db {
namespace {

constexpr const char* select_jobs = R"sql(
SELECT j.q, j.phi_d_deg, j.v_imp_cm_per_s, j.theta_imp_deg, j.v_over_v_esc, j.particles_per_target,
       j.state, r.b_over_a, r.class, r.n_eer, r.settled
FROM jobs j LEFT JOIN job_results r ON r.job_id = j.id
WHERE (:sweep IS NULL OR j.id IN (SELECT job_id FROM sweep_jobs WHERE sweep_id = :sweep))
  AND (:q IS NULL OR j.q = :q) AND (:phi_d IS NULL OR j.phi_d_deg = :phi_d)
  AND (:particles IS NULL OR j.particles_per_target = :particles)
ORDER BY j.q, j.phi_d_deg, j.particles_per_target, j.v_imp_cm_per_s, j.theta_imp_deg, j.id
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
  p.q = row.getColumn(0).getDouble();
  p.phi_d_deg = row.getColumn(1).getDouble();
  p.v_imp_cm_per_s = row.getColumn(2).getDouble();
  p.theta_imp_deg = row.getColumn(3).getDouble();
  p.v_over_v_esc = row.getColumn(4).getDouble();
  p.particles_per_target = row.getColumn(5).getInt64();
  return p;
}

bool same_place(const MapPoint& a, const MapPoint& b) {
  return a.q == b.q && a.phi_d_deg == b.phi_d_deg && a.v_imp_cm_per_s == b.v_imp_cm_per_s &&
         a.theta_imp_deg == b.theta_imp_deg && a.particles_per_target == b.particles_per_target;
}

/// Sums over the jobs of one place, as they come.
struct Tally {
  double b_over_a = 0;
  std::int64_t shapes = 0, eers = 0;
  std::map<std::string, std::int64_t> classes;

  void add(MapPoint& point, const SQLite::Statement& row) {
    ++point.jobs;
    const std::string state = row.getColumn(6).getString();
    if (state == job_state_names[static_cast<std::size_t>(JobState::done)]) ++point.done;
    if (state == job_state_names[static_cast<std::size_t>(JobState::failed)]) ++point.failed;
    if (row.getColumn(8).isNull()) return;
    ++classes[row.getColumn(8).getString()];
    if (row.getColumn(9).getInt() > 0) ++eers;
    if (row.getColumn(10).getInt() == 0) point.settled = false;
    if (!row.getColumn(7).isNull()) b_over_a += row.getColumn(7).getDouble(), ++shapes;
  }

  void finish(MapPoint& point) const {
    if (shapes > 0) point.b_over_a = b_over_a / static_cast<double>(shapes);
    point.eer = eers > 0 && 2 * eers >= point.done;
    std::int64_t most = 0;
    for (const auto& [name, count] : classes)
      if (count > most) most = count, point.outcome_class = name;
  }
};

}  // namespace

std::vector<MapPoint> map_points(const Connection& connection, const MapFilter& filter) {
  std::vector<MapPoint> points;
  connection.read([&](SQLite::Database& sql) {
    SQLite::Statement select(sql, select_jobs);
    bind_named(select, ":sweep", filter.sweep);
    bind_named(select, ":q", filter.q);
    bind_named(select, ":phi_d", filter.phi_d_deg);
    bind_named(select, ":particles", filter.particles_per_target);
    Tally tally;
    while (select.executeStep()) {
      const MapPoint here = place(select);
      if (points.empty() || !same_place(points.back(), here)) {
        if (!points.empty()) tally.finish(points.back());
        points.push_back(here);
        tally = {};
      }
      tally.add(points.back(), select);
    }
    if (!points.empty()) tally.finish(points.back());
  });
  return points;
}

}  // namespace eerie::db
