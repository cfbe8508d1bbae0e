#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "db/jobs/rows.hpp"
#include "db/store/connection.hpp"

namespace eerie::db {

/// The settings that jobs share which differ only in impact (q, speed, angle), friction angle, seed
/// and output. Results of different settings are never averaged.
struct JobSettings {
  std::int64_t id = 0;
  std::string fidelity;  ///< empty where the settings have no name
  std::string scene;     ///< the other fields of the scene, in canonical JSON
};

/// All settings of a database, by their id.
std::vector<JobSettings> job_settings(const Connection& connection);

/// The number of different settings among these jobs.
std::size_t count_settings(std::span<const NewJob> jobs);

}  // namespace eerie::db
