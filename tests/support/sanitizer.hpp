#pragma once

namespace eerie::test {

/// Whether a sanitizer keeps the books of memory: it holds back what was freed, and must be loaded
/// before any other library.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool is_sanitized = true;
#else
inline constexpr bool is_sanitized = false;
#endif

}  // namespace eerie::test
