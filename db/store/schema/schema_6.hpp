#pragma once

namespace eerie::db {

/// Version 6 says in the views what a job was computed with and where its files are, numbers sweeps
/// of one name, and holds the units of all columns (db/store/column_meanings.hpp).
inline constexpr const char* schema_6 = R"sql(
CREATE TABLE units (
  view        TEXT NOT NULL,
  column_name TEXT NOT NULL,
  unit        TEXT NOT NULL,    -- '' where the column has none
  meaning     TEXT NOT NULL,
  PRIMARY KEY (view, column_name)
) STRICT, WITHOUT ROWID;

ALTER TABLE job_settings ADD COLUMN scheme TEXT;
UPDATE job_settings SET scheme = scene ->> '$.numerics.scheme';
CREATE TRIGGER note_scheme AFTER INSERT ON job_settings BEGIN
  UPDATE job_settings SET scheme = NEW.scene ->> '$.numerics.scheme' WHERE id = NEW.id;
END;

-- Sweeps of one name with other contents: name, name@2, name@3 in the order of their coming.
CREATE VIEW sweep_labels AS
SELECT id, name, number, CASE number WHEN 1 THEN name ELSE name || '@' || number END AS label
FROM (SELECT id, name, row_number() OVER (PARTITION BY name ORDER BY id) AS number FROM sweeps);

-- Relative to the folder of the database, unless --jobs-dir chose another.
CREATE VIEW job_folders AS
SELECT j.id AS job_id,
       coalesce(chosen.value, file.value || '.jobs') || '/' || substr(j.hash, 1, 16) AS job_folder
FROM jobs j LEFT JOIN settings chosen ON chosen.key = 'jobs_folder'
     LEFT JOIN settings file ON file.key = 'database_name';

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
       j.fidelity, r.ended_at_s, r.end_reason, j.settings, s.scheme,
       -- Rounding may leave a sum of 1 + 1e-16.
       max(0, 1 - (SELECT total(mass_over_total) FROM job_remnants m WHERE m.job_id = j.id))
         AS debris_fraction,
       f.job_folder
FROM job_results r JOIN jobs j ON j.id = r.job_id
     JOIN job_folders f ON f.job_id = j.id
     LEFT JOIN job_settings s ON s.id = j.settings
     LEFT JOIN settings now ON now.key = 'solver_version';

DROP VIEW remnants;
CREATE VIEW remnants AS
SELECT m.job_id AS job, j.q, j.phi_d_deg, j.v_imp_cm_per_s, j.theta_imp_deg, j.seed,
       m.rank, m.particles, m.mass_kg, m.mass_over_total, m.a_m, m.b_m, m.c_m,
       m.b_over_a, m.c_over_a, m.spin_period_h, m.eer, m.target_fraction,
       m.bound_group, m.bound_mass_over_total,
       m.x_m, m.y_m, m.z_m, m.vx_m_per_s, m.vy_m_per_s, m.vz_m_per_s,
       j.particles_per_target, j.fidelity, j.settings, 1 - m.target_fraction AS impactor_fraction,
       m.shape_class, m.neck, m.box_a_m, m.box_b_m, m.box_c_m, m.box_b_over_a,
       m.bulk_density_kg_per_m3, m.spin_axis_x, m.spin_axis_y, m.spin_axis_z, m.spin_tilt_deg,
       m.origin_depth_mean_m, m.origin_depth_p10_m, m.origin_depth_p90_m,
       m.orbit_eccentricity < 1 AS bound_to_largest, m.orbit_pericentre_m, m.orbit_eccentricity,
       m.orbit_semi_major_axis_m, m.orbit_period_h, m.orbit_v_inf_m_per_s,
       j.hash AS hash, s.scheme
FROM job_remnants m JOIN jobs j ON j.id = m.job_id
     LEFT JOIN job_settings s ON s.id = j.settings;

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
            * count(r.period_h) / nullif(count(r.period_h) - 1, 0)) AS period_std_h,
       max(s.scheme) AS scheme
FROM jobs j LEFT JOIN job_results r ON r.job_id = j.id
     LEFT JOIN settings now ON now.key = 'solver_version'
     LEFT JOIN job_settings s ON s.id = j.settings
     LEFT JOIN classes c ON c.place = 1 AND c.q = j.q AND c.phi_d_deg = j.phi_d_deg
               AND c.v_imp_cm_per_s = j.v_imp_cm_per_s AND c.theta_imp_deg = j.theta_imp_deg
               AND c.settings IS j.settings
GROUP BY j.q, j.phi_d_deg, j.v_imp_cm_per_s, j.theta_imp_deg, j.v_over_v_esc,
         j.particles_per_target, j.end_time_s, j.settings;
)sql";

}  // namespace eerie::db
