#include "analysis/disk/place.hpp"

namespace eerie::disk {

namespace {

Place place_by(DragLaw law, const Nebula& n, const PlaceQuestion& q) {
  const Drag drag = drag_of(law, n, q.body);
  return {law,
          drag,
          drag.stopping_time * n.omega_k,
          turbulent_speed(n, drag, q.alpha),
          stirred_speed(n, drag, q.stirrers, q.stirrer_radius),
          alpha_at_speed(n, drag, slow),
          alpha_at_speed(n, drag, fast),
          stirrer_radius_at_speed(n, drag, q.stirrers, slow),
          stirrer_radius_at_speed(n, drag, q.stirrers, fast)};
}

}  // namespace

std::vector<Place> places_at(const Nebula& nebula, const PlaceQuestion& question) {
  std::vector<Place> places;
  if (has_published_drag(question.body))
    places.push_back(place_by(DragLaw::published, nebula, question));
  places.push_back(place_by(DragLaw::weidenschilling, nebula, question));
  return places;
}

}  // namespace eerie::disk
