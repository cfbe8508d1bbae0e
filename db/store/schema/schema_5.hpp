#pragma once

namespace eerie::db {

/// Version 5 adds details of remnants, from shape class to orbit. They are NULL in older results
/// until these are analysed again.
inline constexpr const char* schema_5 = R"sql(
ALTER TABLE job_remnants ADD COLUMN shape_class TEXT;
ALTER TABLE job_remnants ADD COLUMN neck REAL;
ALTER TABLE job_remnants ADD COLUMN box_a_m REAL;
ALTER TABLE job_remnants ADD COLUMN box_b_m REAL;
ALTER TABLE job_remnants ADD COLUMN box_c_m REAL;
ALTER TABLE job_remnants ADD COLUMN box_b_over_a REAL;
ALTER TABLE job_remnants ADD COLUMN bulk_density_kg_per_m3 REAL;
ALTER TABLE job_remnants ADD COLUMN spin_axis_x REAL;
ALTER TABLE job_remnants ADD COLUMN spin_axis_y REAL;
ALTER TABLE job_remnants ADD COLUMN spin_axis_z REAL;
ALTER TABLE job_remnants ADD COLUMN spin_tilt_deg REAL;
ALTER TABLE job_remnants ADD COLUMN origin_depth_mean_m REAL;
ALTER TABLE job_remnants ADD COLUMN origin_depth_p10_m REAL;
ALTER TABLE job_remnants ADD COLUMN origin_depth_p90_m REAL;
ALTER TABLE job_remnants ADD COLUMN orbit_pericentre_m REAL;
ALTER TABLE job_remnants ADD COLUMN orbit_eccentricity REAL;
ALTER TABLE job_remnants ADD COLUMN orbit_semi_major_axis_m REAL;
ALTER TABLE job_remnants ADD COLUMN orbit_period_h REAL;
ALTER TABLE job_remnants ADD COLUMN orbit_v_inf_m_per_s REAL;

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
       m.orbit_semi_major_axis_m, m.orbit_period_h, m.orbit_v_inf_m_per_s
FROM job_remnants m JOIN jobs j ON j.id = m.job_id;
)sql";

}  // namespace eerie::db
