#pragma once

namespace eerie::material {

/// Pressure and sound speed at one point of an equation of state.
struct EosPoint {
  double p;  ///< Pa
  double c;  ///< adiabatic sound speed, m/s
};

}  // namespace eerie::material
