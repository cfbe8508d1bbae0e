#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "campaign/job_folder/job_directory.hpp"
#include "campaign/studies/convergence_results.hpp"
#include "campaign/studies/particles_needed.hpp"
#include "campaign/text/table.hpp"

namespace eerie::studies {

/// A table with one row per ensemble, for people.
text::Table table_of_cells(const std::vector<ConvergenceCell>& cells);
/// A table of the particle numbers from which on schemes are right, for people.
text::Table table_of_particles_needed(const std::vector<ParticlesNeeded>& needed);

/// Writes all tables, the page and the figures of a study into a folder that exists. It writes the
/// diagnosis where job folders exist. Returns the files.
std::vector<std::filesystem::path> write_convergence_study(
    const ConvergenceStudy& study, const std::vector<ConvergenceResult>& results,
    const std::filesystem::path& folder, const std::optional<job_folder::JobFolder>& jobs);

}  // namespace eerie::studies
