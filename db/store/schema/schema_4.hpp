#pragma once

namespace eerie::db {

/// Version 4 says which jobs may be averaged. Jobs with the same settings differ only in impact,
/// friction angle, seed and output.
inline constexpr const char* schema_4 = R"sql(
CREATE TABLE job_settings (
  id    INTEGER PRIMARY KEY,
  scene TEXT NOT NULL UNIQUE    -- what all of its jobs share, canonical JSON
) STRICT;

-- The one rule for what jobs of the same settings share. Fields younger than the first results go
-- where they are off, as in a job's hash: their absence means the same.
CREATE VIEW shared_scenes AS
SELECT job_id,
       json_remove(scene, '$.impact.q', '$.impact.v_imp_cm_per_s', '$.impact.theta_imp_deg',
                   '$.material.drucker_prager.phi_d_deg', '$.numerics.seed', '$.output',
                   CASE WHEN scene ->> '$.end.settled.window_s' = 0
                        THEN '$.end.settled' ELSE '$.output' END,
                   CASE WHEN scene ->> '$.numerics.late_sound_speed' = 1
                        THEN '$.numerics.late_sound_speed' ELSE '$.output' END) AS scene
FROM job_scenes;

INSERT INTO job_settings (scene)
SELECT scene FROM shared_scenes GROUP BY scene ORDER BY min(job_id);

ALTER TABLE jobs ADD COLUMN settings INTEGER REFERENCES job_settings (id);
UPDATE jobs SET settings = s.id
FROM shared_scenes c JOIN job_settings s ON s.scene = c.scene WHERE c.job_id = jobs.id;

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
       END AS stale_reason,
       j.fidelity, r.ended_at_s, r.end_reason, j.settings
FROM job_results r JOIN jobs j ON j.id = r.job_id
     LEFT JOIN settings now ON now.key = 'solver_version';

DROP VIEW maps;
CREATE VIEW maps AS
WITH classes AS (
  SELECT j.q, j.phi_d_deg, j.v_imp_cm_per_s, j.theta_imp_deg, j.settings, r.class,
         count(*) AS results,
         row_number() OVER (PARTITION BY j.q, j.phi_d_deg, j.v_imp_cm_per_s, j.theta_imp_deg,
                                         j.settings ORDER BY count(*) DESC, r.class) AS place
  FROM job_results r JOIN jobs j ON j.id = r.job_id
  GROUP BY j.q, j.phi_d_deg, j.v_imp_cm_per_s, j.theta_imp_deg, j.settings, r.class
)
SELECT j.q, j.phi_d_deg, j.v_imp_cm_per_s, j.theta_imp_deg, j.v_over_v_esc,
       j.particles_per_target, j.end_time_s,
       count(*) AS jobs, sum(j.state = 'done') AS done, sum(j.state = 'failed') AS failed,
       avg(r.b_over_a) AS b_over_a, min(r.b_over_a) AS b_over_a_min, max(r.b_over_a) AS b_over_a_max,
       avg(r.c_over_a) AS c_over_a, avg(r.m_lr_over_m_total) AS m_lr_over_m_total,
       avg(r.period_h) AS period_h, avg(r.n_eer) AS n_eer, avg(r.eer) AS p_eer,
       total(r.solver_version <> now.value) AS stale,
       j.settings, max(j.fidelity) AS fidelity,
       c.class, 1.0 * c.results / count(r.job_id) AS class_share,
       sqrt(max(avg(r.b_over_a * r.b_over_a) - avg(r.b_over_a) * avg(r.b_over_a), 0)
            * count(r.b_over_a) / nullif(count(r.b_over_a) - 1, 0)) AS b_over_a_std,
       sqrt(max(avg(r.c_over_a * r.c_over_a) - avg(r.c_over_a) * avg(r.c_over_a), 0)
            * count(r.c_over_a) / nullif(count(r.c_over_a) - 1, 0)) AS c_over_a_std,
       sqrt(max(avg(r.m_lr_over_m_total * r.m_lr_over_m_total) - avg(r.m_lr_over_m_total) * avg(r.m_lr_over_m_total), 0)
            * count(r.m_lr_over_m_total) / nullif(count(r.m_lr_over_m_total) - 1, 0)) AS m_lr_over_m_total_std,
       sqrt(max(avg(r.period_h * r.period_h) - avg(r.period_h) * avg(r.period_h), 0)
            * count(r.period_h) / nullif(count(r.period_h) - 1, 0)) AS period_std_h
FROM jobs j LEFT JOIN job_results r ON r.job_id = j.id
     LEFT JOIN settings now ON now.key = 'solver_version'
     LEFT JOIN classes c ON c.place = 1 AND c.q = j.q AND c.phi_d_deg = j.phi_d_deg
               AND c.v_imp_cm_per_s = j.v_imp_cm_per_s AND c.theta_imp_deg = j.theta_imp_deg
               AND c.settings IS j.settings
GROUP BY j.q, j.phi_d_deg, j.v_imp_cm_per_s, j.theta_imp_deg, j.v_over_v_esc,
         j.particles_per_target, j.end_time_s, j.settings;
)sql";

}  // namespace eerie::db
