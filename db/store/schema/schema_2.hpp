#pragma once

namespace eerie::db {

/// Version 2 serves managers that work for weeks. It stores the user's wish for a job beside its
/// state. It keeps the requests that were carried out, so that none is carried out twice.
inline constexpr const char* schema_2 = R"sql(
CREATE TABLE settings (
  key   TEXT PRIMARY KEY,   -- 'jobs_folder', 'solver_version'
  value TEXT NOT NULL
) STRICT;

CREATE TABLE requests (
  id      TEXT PRIMARY KEY,
  kind    TEXT NOT NULL,
  applied TEXT NOT NULL DEFAULT (strftime('%Y-%m-%dT%H:%M:%fZ', 'now')),
  answer  TEXT NOT NULL     -- JSON
) STRICT;

ALTER TABLE jobs ADD COLUMN wanted TEXT NOT NULL DEFAULT 'run'
  CHECK (wanted IN ('run', 'pause', 'cancel'));
ALTER TABLE jobs ADD COLUMN wall_limit_s REAL;               -- NULL: none
ALTER TABLE jobs ADD COLUMN wall_s REAL NOT NULL DEFAULT 0;  -- since it was last set to pending by hand
ALTER TABLE attempts ADD COLUMN worker TEXT;                 -- what the scheduler calls it

DROP INDEX jobs_by_turn;
CREATE INDEX jobs_by_turn ON jobs (state, wanted, priority DESC, expected_particle_steps DESC);

DROP VIEW results;
CREATE VIEW results AS
SELECT j.id AS job, j.hash AS hash, j.q, j.phi_d_deg, j.v_imp_cm_per_s, j.theta_imp_deg,
       j.v_over_v_esc, j.particles_per_target, j.seed, j.end_time_s,
       r.class, r.m_lr_over_m_total, r.m_slr_over_m_total, r.b_over_a, r.c_over_a, r.period_h,
       r.eer, r.n_eer, r.n_remnants, r.settled, r.unsettled_reason, r.dL_over_L,
       r.steps, r.particle_steps, r.wall_s, r.threads, r.solver_version, r.host, r.finished,
       coalesce(r.solver_version <> now.value, 0) AS stale,
       CASE WHEN r.solver_version <> now.value
            THEN 'made by solver ' || r.solver_version || ', this one is ' || now.value
       END AS stale_reason
FROM job_results r JOIN jobs j ON j.id = r.job_id
     LEFT JOIN settings now ON now.key = 'solver_version';

DROP VIEW maps;
CREATE VIEW maps AS
SELECT j.q, j.phi_d_deg, j.v_imp_cm_per_s, j.theta_imp_deg, j.v_over_v_esc,
       j.particles_per_target, j.end_time_s,
       count(*) AS jobs, sum(j.state = 'done') AS done, sum(j.state = 'failed') AS failed,
       avg(r.b_over_a) AS b_over_a, min(r.b_over_a) AS b_over_a_min, max(r.b_over_a) AS b_over_a_max,
       avg(r.c_over_a) AS c_over_a, avg(r.m_lr_over_m_total) AS m_lr_over_m_total,
       avg(r.period_h) AS period_h, avg(r.n_eer) AS n_eer, avg(r.eer) AS p_eer,
       total(r.solver_version <> now.value) AS stale
FROM jobs j LEFT JOIN job_results r ON r.job_id = j.id
     LEFT JOIN settings now ON now.key = 'solver_version'
GROUP BY j.q, j.phi_d_deg, j.v_imp_cm_per_s, j.theta_imp_deg, j.v_over_v_esc,
         j.particles_per_target, j.end_time_s;
)sql";

}  // namespace eerie::db
