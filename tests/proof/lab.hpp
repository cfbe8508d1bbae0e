#pragma once

#include <functional>
#include <nlohmann/json.hpp>

#include "solver/base/random.hpp"
#include "solver/particles/state.hpp"
#include "solver/scene/scene.hpp"
#include "solver/step/solver.hpp"

namespace eerie::proof {

/// A block [lo, hi] filled with a cubic lattice of the given spacing, particles half a spacing
/// inside its faces, so that mirror walls on the faces continue the lattice; only where `inside`
/// says so. At rest, at the density `rho`, h = h_over_spacing x spacing.
/// `jitter`: random displacement, in spacings, away from walls of the lattice's symmetry.
particles::State lattice_block(const Vec3& lo, const Vec3& hi, double spacing, double rho,
                               const std::function<bool(const Vec3&)>& inside = {},
                               double h_over_spacing = 1.2, double jitter = 0);

/// A laboratory scene: no self-gravity, defaults otherwise, `changes` on top (a JSON merge patch).
Scene lab_scene(const nlohmann::json& changes);

/// The material of elastic tests: linear equation of state, no yield. SI.
nlohmann::json elastic_material(double rho0, double bulk_modulus, double shear_modulus);

/// Runs until `amplitude` has changed its sign `count` times, at most to `end_s`; the times, s, by
/// linear interpolation between cycles.
std::vector<double> zero_crossings(step::Solver& solver, const std::function<double()>& amplitude,
                                   std::size_t count, double end_s);

/// {"face": face, "at_m": at, "kind": kind}
nlohmann::json wall(const char* face, double at, const char* kind = "slip");

}  // namespace eerie::proof
