#pragma once

#include <functional>
#include <optional>
#include <span>

#include "analysis/ending/steadiness.hpp"
#include "analysis/remnants/remnants.hpp"
#include "solver/io/snapshot.hpp"
#include "solver/particles/landing.hpp"

namespace eerie::ending {

/// With numerics.rigid_flight: whether two remnants meet within half a window of end.settled.
/// Matter keeps its own moduli for that time.
bool impact_ahead(const remnants::Remnants& found, const Scene::Settled& settled);

/// Flies the remnants as rigid bodies (flight.hpp; numerics.rigid_flight) until the solver must
/// compute matter again. The flight ends at `until` (s) at the latest, or when
/// - two bodies of at least 0.005 of all mass are about to meet,
/// - fragments of half of end.settled.fall_back of all mass have landed, or
/// - nothing is left to wait for.
/// Returns nothing where remnants still deform, where no encounter is ahead, or where the flight
/// would last less than half a window of end.settled. Where matter is soft and an impact is ahead,
/// it returns the present state, so that matter gets its own sound speed back. `looks` are those of
/// the run so far, and `found` are the remnants of `now`.
std::optional<particles::Landing> flight_from(const io::Snapshot& now, double until,
                                              std::span<const RemnantLook> looks,
                                              const remnants::Remnants& found,
                                              const std::function<bool()>& stop);

}  // namespace eerie::ending
