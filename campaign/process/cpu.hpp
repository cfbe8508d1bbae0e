#pragma once

namespace eerie::process {

/// Ends the program with a clear message (exit code 3) where this machine lacks vector instructions
/// that the program was built with; without it, the first of them would end it unexplained.
void require_cpu(bool avx2, bool fma, bool avx512f, bool avx512vbmi2);

}  // namespace eerie::process
