#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace eerie::io {

/// The meaning and the dimension (powers of kg, m, s) of a dataset, for its attributes.
struct FieldUnit {
  std::string_view name, description;
  int mass, length, time;
};

/// The table has one row for each dataset that a snapshot can hold. A field without a row would be
/// saved without unit attributes; a test checks that no row is missing.
inline constexpr std::array field_units = {
    FieldUnit{"ParticleIDs", "0..N-1, fixed for the whole run", 0, 0, 0},
    FieldUnit{"BodyIDs", "0: from the target, 1: from the impactor", 0, 0, 0},
    FieldUnit{"MaterialIDs", "103: Tillotson basalt", 0, 0, 0},
    FieldUnit{"Coordinates", "positions", 0, 1, 0},
    FieldUnit{"Velocities", "velocities", 0, 1, -1},
    FieldUnit{"Densities", "densities", 1, -3, 0},
    FieldUnit{"DeviatoricStresses", "xx, yy, zz, xy, xz, yz", 1, -1, -2},
    FieldUnit{"Pressures", "EOS pressure as in the momentum equation", 1, -1, -2},
    FieldUnit{"Masses", "masses", 1, 0, 0},
    FieldUnit{"SmoothingLengths", "h; the kernel reaches to 2h", 0, 1, 0},
    FieldUnit{"InternalEnergies", "elastic energy included; 0 without an energy equation", 0, 2,
              -2},
    FieldUnit{"ViscousHeats", "part of the internal energy made by artificial viscosity", 0, 2, -2},
    FieldUnit{"ShearWorks", "part of the internal energy: work of the deviatoric stress", 0, 2, -2},
    FieldUnit{"ShearPowers", "d / dt of ShearWorks", 0, 2, -3},
    FieldUnit{"DamageCubeRoots", "cube roots of the damage, 0 intact, 1 rubble", 0, 0, 0},
    FieldUnit{"EnergyRates", "d u / dt", 0, 2, -3},
    FieldUnit{"ViscousHeatingRates", "of artificial viscosity", 0, 2, -3},
    FieldUnit{"Accelerations", "of stress and viscosity, without gravity", 0, 1, -2},
    FieldUnit{"DensityRates", "d rho / dt", 1, -3, -1},
    FieldUnit{"StressRates", "d S / dt: xx, yy, zz, xy, xz, yz", 1, -1, -3},
    FieldUnit{"CorrectionMatrices", "of the corrected gradient: xx, yy, zz, xy, xz, yz", 0, 0, 0},
    FieldUnit{"ShearRates", "traceless strain rate: xx, yy, zz, xy, xz, yz", 0, 0, -1},
    FieldUnit{"ViscousPressures", "that artificial viscosity carries", 1, -1, -2},
    FieldUnit{"GravityAccelerations", "of self-gravity at its last evaluation", 0, 1, -2},
    FieldUnit{"GravityRates", "d g / dt at its last evaluation", 0, 1, -3},
    FieldUnit{"ListCoordinates", "positions when the neighbour lists were built", 0, 1, 0},
};

/// The row of a dataset; nullptr where there is none.
constexpr const FieldUnit* unit_of(std::string_view name) {
  const auto* row = std::ranges::find(field_units, name, &FieldUnit::name);
  return row == field_units.end() ? nullptr : row;
}

}  // namespace eerie::io
