#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

#include "analysis/remnants/clumps.hpp"
#include "analysis/remnants/orbit.hpp"
#include "analysis/shapes/shape.hpp"
#include "solver/base/vec3.hpp"
#include "solver/particles/state.hpp"

namespace eerie::remnants {

/// A clump of fewer particles is debris, since it is too coarse for a shape.
inline constexpr std::size_t remnant_min_particles = 100;
/// An extremely elongated remnant has b/a below this.
inline constexpr double eer_max_b_over_a = 0.3;

/// One contiguous clump of at least remnant_min_particles particles. Two clumps in orbit about
/// each other are two remnants, each with its own shape and spin, in one bound group.
struct Remnant {
  int rank = 0;  ///< 1: the most massive
  std::size_t particles = 0;
  double mass = 0;  ///< kg
  double mass_over_total = 0;
  shapes::Shape shape;
  std::optional<double> spin_period;  ///< s; nothing when it does not spin
  bool eer = false;                   ///< b/a < eer_max_b_over_a
  double target_fraction = 0;         ///< fraction of its particles that come from the target
  int bound_group = 0;                ///< 1: the most massive group of mutually bound clumps
  double bound_mass_over_total = 0;   ///< mass of that group, debris included
  Vec3 x, v;                          ///< centre of mass, m and m/s
};

/// The remnants, bound groups and debris of a state.
struct Remnants {
  std::vector<Remnant> remnants;     ///< from the most massive on
  std::vector<double> group_masses;  ///< of the bound groups, kg, from the most massive on
  std::vector<double> group_cores;   ///< mass of the most massive clump of each group, kg
  /// Mass of clumps below remnant_min_particles that are in some group, kg.
  double debris_bound_mass = 0;
  std::vector<PointMass> debris;  ///< these clumps, the most massive first
};

/// Finds clumps by friends-of-friends, then bound groups, then the shape and spin of every remnant.
/// Sums run in the order of particle ids, so the result has the same bits for any memory order.
Remnants find_remnants(const particles::State& state);

/// The particles of the remnant of this rank, from 1 on. Throws InputError, which names the
/// snapshot's `path`, where there are fewer.
Clump clump_of_rank(const particles::State& state, int rank, const std::filesystem::path& path);

}  // namespace eerie::remnants
