#pragma once

namespace eerie::db {

/// Version 1 of the schema. Tables belong to the program. Users rely on the stable views `results`,
/// `remnants` and `maps` (docs/reference/database.md), so no table has one of these names.
inline constexpr const char* schema_1 = R"sql(
CREATE TABLE sweeps (
  id       INTEGER PRIMARY KEY,
  name     TEXT NOT NULL,
  document TEXT NOT NULL,          -- the sweep file after --set, canonical JSON
  created  TEXT NOT NULL DEFAULT (strftime('%Y-%m-%dT%H:%M:%fZ', 'now')),
  UNIQUE (name, document)
) STRICT;

CREATE TABLE jobs (
  id       INTEGER PRIMARY KEY,
  hash     TEXT NOT NULL UNIQUE,   -- SHA-256 of the canonical scene: what the job is
  state    TEXT NOT NULL DEFAULT 'pending'
           CHECK (state IN ('pending', 'running', 'done', 'failed', 'cancelled')),
  priority INTEGER NOT NULL DEFAULT 0,
  crashes  INTEGER NOT NULL DEFAULT 0,   -- since the job was last set to pending by hand
  created  TEXT NOT NULL DEFAULT (strftime('%Y-%m-%dT%H:%M:%fZ', 'now')),
  q                       REAL NOT NULL,
  phi_d_deg               REAL NOT NULL,
  v_imp_cm_per_s          REAL NOT NULL,
  theta_imp_deg           REAL NOT NULL,
  v_over_v_esc            REAL NOT NULL,
  particles_per_target    INTEGER NOT NULL,
  seed                    INTEGER NOT NULL,
  end_time_s              REAL NOT NULL,
  expected_particle_steps REAL NOT NULL
) STRICT;
CREATE INDEX jobs_by_turn ON jobs (state, priority DESC, expected_particle_steps DESC);
CREATE INDEX jobs_by_point ON jobs (q, phi_d_deg, v_imp_cm_per_s, theta_imp_deg);

-- Apart from jobs, so that counting and filtering 100,000 jobs does not read 100 MB of JSON.
CREATE TABLE job_scenes (
  job_id INTEGER PRIMARY KEY REFERENCES jobs (id),
  scene  TEXT NOT NULL
) STRICT;

CREATE TABLE sweep_jobs (
  sweep_id INTEGER NOT NULL REFERENCES sweeps (id),
  job_id   INTEGER NOT NULL REFERENCES jobs (id),
  PRIMARY KEY (sweep_id, job_id)
) STRICT, WITHOUT ROWID;
CREATE INDEX sweep_jobs_by_job ON sweep_jobs (job_id);

CREATE TABLE attempts (
  id                INTEGER PRIMARY KEY,
  job_id            INTEGER NOT NULL REFERENCES jobs (id),
  host              TEXT NOT NULL,
  pid               INTEGER NOT NULL,
  version           TEXT NOT NULL,       -- of the program
  started           TEXT NOT NULL DEFAULT (strftime('%Y-%m-%dT%H:%M:%fZ', 'now')),
  ended             TEXT,
  exit_reason       TEXT CHECK (exit_reason IN ('finished', 'failed', 'stopped', 'crashed', 'lost')),
  failure_kind      TEXT,                -- e.g. 'not-finite', 'signal 9'
  message           TEXT,
  core_seconds      REAL,
  particle_steps    REAL,                -- of the job when the attempt ended
  peak_memory_bytes INTEGER
) STRICT;
CREATE INDEX attempts_by_job ON attempts (job_id);

CREATE TABLE job_results (
  job_id               INTEGER PRIMARY KEY REFERENCES jobs (id),
  finished             TEXT NOT NULL DEFAULT (strftime('%Y-%m-%dT%H:%M:%fZ', 'now')),
  class                TEXT NOT NULL,
  m_lr_over_m_total    REAL NOT NULL,
  m_slr_over_m_total   REAL NOT NULL,
  b_over_a             REAL,             -- of the largest remnant
  c_over_a             REAL,
  period_h             REAL,             -- NULL: does not spin
  eer                  INTEGER NOT NULL, -- the largest remnant is extremely elongated
  n_eer                INTEGER NOT NULL,
  n_remnants           INTEGER NOT NULL,
  settled              INTEGER NOT NULL,
  unsettled_reason     TEXT,
  dL_over_L            REAL,
  steps                INTEGER NOT NULL,
  particle_steps       REAL NOT NULL,
  wall_s               REAL NOT NULL,
  threads              INTEGER NOT NULL,
  solver_version       TEXT NOT NULL,
  host                 TEXT NOT NULL
) STRICT;

CREATE TABLE job_remnants (
  job_id                INTEGER NOT NULL REFERENCES jobs (id),
  rank                  INTEGER NOT NULL,
  particles             INTEGER NOT NULL,
  mass_kg               REAL NOT NULL,
  mass_over_total       REAL NOT NULL,
  a_m                   REAL,
  b_m                   REAL,
  c_m                   REAL,
  b_over_a              REAL,
  c_over_a              REAL,
  spin_period_h         REAL,
  eer                   INTEGER NOT NULL,
  target_fraction       REAL,
  bound_group           INTEGER,
  bound_mass_over_total REAL,
  x_m REAL, y_m REAL, z_m REAL,
  vx_m_per_s REAL, vy_m_per_s REAL, vz_m_per_s REAL,
  PRIMARY KEY (job_id, rank)
) STRICT, WITHOUT ROWID;

CREATE VIEW results AS
SELECT j.id AS job, j.hash AS hash, j.q, j.phi_d_deg, j.v_imp_cm_per_s, j.theta_imp_deg,
       j.v_over_v_esc, j.particles_per_target, j.seed, j.end_time_s,
       r.class, r.m_lr_over_m_total, r.m_slr_over_m_total, r.b_over_a, r.c_over_a, r.period_h,
       r.eer, r.n_eer, r.n_remnants, r.settled, r.unsettled_reason, r.dL_over_L,
       r.steps, r.particle_steps, r.wall_s, r.threads, r.solver_version, r.host, r.finished
FROM job_results r JOIN jobs j ON j.id = r.job_id;

CREATE VIEW remnants AS
SELECT m.job_id AS job, j.q, j.phi_d_deg, j.v_imp_cm_per_s, j.theta_imp_deg, j.seed,
       m.rank, m.particles, m.mass_kg, m.mass_over_total, m.a_m, m.b_m, m.c_m,
       m.b_over_a, m.c_over_a, m.spin_period_h, m.eer, m.target_fraction,
       m.bound_group, m.bound_mass_over_total,
       m.x_m, m.y_m, m.z_m, m.vx_m_per_s, m.vy_m_per_s, m.vz_m_per_s
FROM job_remnants m JOIN jobs j ON j.id = m.job_id;

CREATE VIEW maps AS
SELECT j.q, j.phi_d_deg, j.v_imp_cm_per_s, j.theta_imp_deg, j.v_over_v_esc,
       j.particles_per_target, j.end_time_s,
       count(*) AS jobs, sum(j.state = 'done') AS done, sum(j.state = 'failed') AS failed,
       avg(r.b_over_a) AS b_over_a, min(r.b_over_a) AS b_over_a_min, max(r.b_over_a) AS b_over_a_max,
       avg(r.c_over_a) AS c_over_a, avg(r.m_lr_over_m_total) AS m_lr_over_m_total,
       avg(r.period_h) AS period_h, avg(r.n_eer) AS n_eer, avg(r.eer) AS p_eer
FROM jobs j LEFT JOIN job_results r ON r.job_id = j.id
GROUP BY j.q, j.phi_d_deg, j.v_imp_cm_per_s, j.theta_imp_deg, j.v_over_v_esc,
         j.particles_per_target, j.end_time_s;
)sql";

}  // namespace eerie::db
