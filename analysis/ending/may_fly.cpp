#include "analysis/ending/may_fly.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>

#include "analysis/flight/flight.hpp"
#include "solver/scene/two_materials.hpp"

namespace eerie::ending {

namespace {

/// Of all the mass: lighter bodies may land without being computed as matter.
constexpr double heavy_over_total = 0.005;

std::string why(flight::FlightEnd end) {
  switch (end) {
    case flight::FlightEnd::time:
      return "until the next snapshot or the end";
    case flight::FlightEnd::encounter:
      return "two of them are about to meet";
    case flight::FlightEnd::landed:
      return "so much has landed that shapes may change";
    case flight::FlightEnd::nothing_left:
      return "nothing will meet any more";
    case flight::FlightEnd::stopped:
      return "stopped";
  }
  return "";
}

}  // namespace

bool impact_ahead(const remnants::Remnants& found, const Scene::Settled& settled) {
  return next_meeting(found, settled) <= settled.window_s / 2;
}

std::optional<particles::Landing> flight_from(const io::Snapshot& now, double until,
                                              std::span<const RemnantLook> looks,
                                              const remnants::Remnants& found,
                                              const std::function<bool()>& stop) {
  const Scene& scene = now.scene;
  const Scene::Settled& settled = scene.end.settled;
  const double total = now.state.mass * static_cast<double>(now.state.size());
  if (impact_ahead(found, settled)) {
    if (now.state.softening.sound_speed == 1) return std::nullopt;
    return particles::Landing{now.state, true, "two of them are about to meet"};
  }
  const auto something_ahead = [&](double time, const remnants::Remnants& there) {
    return !encounters(there, total, horizon(scene.end, time), settled).empty();
  };
  if (!restlessness(looks, settled).empty() || !something_ahead(now.state.time, found))
    return std::nullopt;
  const double shortest = settled.window_s / 2, most_landed = settled.fall_back / 2 * total;
  if (falling_back(found, shortest, settled) >= most_landed) return std::nullopt;

  flight::FlightPlan plan;
  plan.until_s = until;
  plan.spacing = std::cbrt(now.state.mass / lowest_density(scene));
  plan.opening_angle = scene.numerics.opening_angle;
  plan.heavy = heavy_over_total * total;
  plan.most_landed = most_landed;
  plan.waits = [&](const particles::State& s) {
    return something_ahead(s.time, remnants::find_remnants(s));
  };
  plan.stop = stop;
  flight::Flight flight = flight::fly(now.state, plan);
  const double duration = flight.state.time - now.state.time;
  if (flight.end == flight::FlightEnd::stopped || duration < shortest) return std::nullopt;
  return particles::Landing{
      std::move(flight.state), flight.end == flight::FlightEnd::encounter,
      fmt::format("{:.4f} of the mass landed, {}", flight.landed / total, why(flight.end))};
}

}  // namespace eerie::ending
