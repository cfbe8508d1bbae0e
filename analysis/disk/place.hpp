#pragma once

#include <vector>

#include "analysis/disk/encounter_speed.hpp"

namespace eerie::disk {

/// A question about one distance from the star.
struct PlaceQuestion {
  Body body;
  Stirrers stirrers;
  double alpha = 1e-4;
  double stirrer_radius = 2000;  ///< m
};

/// The answer by one law of drag.
struct Place {
  DragLaw law = DragLaw::published;
  Drag drag;
  double t_s_omega_k = 0;  ///< the stopping time times the Keplerian frequency
  double turbulent_speed = 0, stirred_speed = 0;  ///< m/s
  double alpha_slow = 0, alpha_fast = 0;          ///< alpha that gives the speeds `slow` and `fast`
  double stirrer_radius_slow = 0, stirrer_radius_fast = 0;  ///< radii that give these speeds, m
};

/// The answers by each law that knows the body: the published law, if it does, and
/// Weidenschilling's.
std::vector<Place> places_at(const Nebula& nebula, const PlaceQuestion& question);

}  // namespace eerie::disk
