#pragma once

#include <vector>

#include "analysis/disk/encounter_speed.hpp"

namespace eerie::disk {

/// What is asked about one distance from the star.
struct PlaceQuestion {
  Body body;
  Stirrers stirrers;
  double alpha = 1e-4;
  double stirrer_radius = 2000;  ///< m
};

/// What one law of drag answers.
struct Place {
  DragLaw law = DragLaw::published;
  Drag drag;
  double t_s_omega_k = 0;                         ///< stopping time times Keplerian frequency
  double turbulent_speed = 0, stirred_speed = 0;  ///< m/s
  double alpha_slow = 0, alpha_fast = 0;          ///< alpha at `slow` and `fast`
  double stirrer_radius_slow = 0, stirrer_radius_fast = 0;  ///< likewise, m
};

/// By each law that knows the body: the published one, if it does, and Weidenschilling's.
std::vector<Place> places_at(const Nebula& nebula, const PlaceQuestion& question);

}  // namespace eerie::disk
