#pragma once

#include <functional>
#include <optional>
#include <span>

#include "analysis/ending/steadiness.hpp"
#include "analysis/remnants/remnants.hpp"
#include "solver/io/snapshot.hpp"
#include "solver/particles/landing.hpp"

namespace eerie::ending {

/// With numerics.rigid_flight: whether two remnants meet within half a window of end.settled, a
/// time in which matter is computed with its own moduli.
bool impact_ahead(const remnants::Remnants& found, const Scene::Settled& settled);

/// With numerics.rigid_flight: where remnants are at rest in themselves (`restlessness`) and
/// `encounters` lie ahead, the state after as long a flight (flight.hpp) as brings it to the next
/// thing to compute as matter: two bodies of at least 0.005 of the mass about to meet; half of
/// end.settled.fall_back of the mass landed; nothing left to wait for; or `until`. Nothing where
/// that is less than half a window ahead, or where by their orbits so many fragments fall back
/// within that time. The state as it is where it is soft and an impact is
/// ahead. `looks` and `found`: of the run so far, and of now.
std::optional<particles::Landing> flight_from(const io::Snapshot& now, double until,
                                              std::span<const RemnantLook> looks,
                                              const remnants::Remnants& found,
                                              const std::function<bool()>& stop);

}  // namespace eerie::ending
