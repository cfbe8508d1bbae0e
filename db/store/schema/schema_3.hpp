#pragma once

namespace eerie::db {

/// Version 3 adds runs that end once settled, and fidelities.
inline constexpr const char* schema_3 = R"sql(
ALTER TABLE jobs ADD COLUMN fidelity TEXT;             -- NULL: settings that have no name
ALTER TABLE job_results ADD COLUMN ended_at_s REAL;    -- simulated time; NULL: not noted
ALTER TABLE job_results ADD COLUMN end_reason TEXT;    -- 'settled', 'end-time' or 'latest-time'

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
       j.fidelity, r.ended_at_s, r.end_reason
FROM job_results r JOIN jobs j ON j.id = r.job_id
     LEFT JOIN settings now ON now.key = 'solver_version';
)sql";

}  // namespace eerie::db
