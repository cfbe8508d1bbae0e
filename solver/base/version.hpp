#pragma once

namespace eerie {

/// The version of the solver. It changes when, and only when, the same scene may give other
/// numbers; the version of the program has other reasons to change. A run never continues a
/// checkpoint of another solver version, since its result would belong to neither.
inline constexpr const char* solver_version = "0.2.1";

}  // namespace eerie
