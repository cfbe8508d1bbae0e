#pragma once

#include "solver/io/snapshot.hpp"
#include "solver/particles/state.hpp"

namespace eerie::step {

/// How fast matter deforms or turns, 1/s. For each particle it is the root mean square of
/// |v_i - v_j| over that of |x_i - x_j|, over its neighbours within 2h; 0 without neighbours. One
/// particle in a hundred may exceed what is returned: spray, and grains that roll on a surface.
double deformation_rate(const particles::State& state);

/// Speed across the radius of a sphere of all the mass at that rate, m/s. Density changes by the
/// square of its ratio to the speed of sound.
double flow_speed(const io::Snapshot& snapshot);

}  // namespace eerie::step
