#pragma once

namespace eerie::process {

/// Ends the program with a clear message (exit code 3) where this machine lacks vector instructions
/// that the program uses. Without this check the first such instruction would end it without a
/// message.
void require_cpu(bool avx2, bool fma, bool avx512f, bool avx512vbmi2);

}  // namespace eerie::process
