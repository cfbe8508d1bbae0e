#pragma once

namespace eerie {

/// Changes whenever the same scene may give other numbers, and only then; the version of the
/// program changes for other reasons too. A run never goes on from a checkpoint of another one:
/// its result would be of neither.
inline constexpr const char* solver_version = "0.1.0";

}  // namespace eerie
