#pragma once

namespace eerie {

/// The version of the numbers, apart from the program's: it changes whenever the same scene may
/// give another result. Results of another version are marked stale and kept.
inline constexpr const char* solver_version = "0.1.0";

}  // namespace eerie
