#pragma once

#include <vector>

#include "solver/base/vec3.hpp"

namespace eerie::proof {

/// Two rubber rings (radii 3 and 4 cm, rho 1000 kg/m^3, E 10 MPa, nu 0.3975, plane strain) that
/// meet head-on with 0.059 c0 each, c0 the bulk sound speed (Monaghan 2000; Gray, Monaghan & Swift
/// 2001). h is 1.5 spacings: with 1.2 the lattice, stretched by a third where the rings bend, comes
/// apart.
struct Rings {
  double spacing;            ///< m
  double artificial_stress;  ///< 0: off
  bool quarter = false;      ///< half of one ring against slip walls, the same by symmetry
};

struct RingsOutcome {
  std::vector<Vec3> x;   ///< of the particles of one layer, m
  int pieces;            ///< connected pieces with at least a hundredth of all particles
  double largest_piece;  ///< share of all particles in the largest piece
  double rebound;        ///< mean speed along the line of centres over that before; > 0: apart
};

/// The rings `time` after the start, in units of outer radius over c0; they touch at 2 or so.
RingsOutcome collide(const Rings& rings, double time);

}  // namespace eerie::proof
