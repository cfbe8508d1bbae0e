#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "db/jobs/rows.hpp"
#include "db/store/connection.hpp"

namespace eerie::db {

/// What jobs have in common that differ in impact (q, speed, angle), friction angle, seed and
/// output only. Results of different settings are never averaged.
struct JobSettings {
  std::int64_t id = 0;
  std::string fidelity;  ///< empty: has no name
  std::string scene;     ///< the rest of the scene, canonical JSON
};

/// All settings of a database, by id.
std::vector<JobSettings> job_settings(const Connection& connection);

/// How many settings these jobs have among themselves.
std::size_t count_settings(std::span<const NewJob> jobs);

}  // namespace eerie::db
