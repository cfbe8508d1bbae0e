#pragma once

namespace eerie::process {

/// Makes OpenMP's environment fit; since its library reads it before main(), the program starts
/// itself once more where something has to change (same process, same arguments). Call first.
///
/// Threads that wait for each other sleep soon instead of spinning, unless OMP_WAIT_POLICY or
/// GOMP_SPINCOUNT say how they wait: on a busy machine a thread that spins takes the core of the
/// one it waits for. Where the program is to start workers (`starts_workers`), threads are not
/// bound to cores, as workers would inherit the first thread's core, all of them; the places that
/// OMP_PLACES allows stay the cores of this process. Tells of that on standard error.
void prepare_openmp(char** arguments, bool starts_workers);

}  // namespace eerie::process
