#include "analysis/pictures/particle_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "analysis/remnants/clumps.hpp"
#include "analysis/remnants/remnants.hpp"
#include "solver/base/constants.hpp"
#include "solver/base/error.hpp"

namespace eerie::pictures {

namespace {

constexpr double margin = 1.06;  ///< room about the remnants

std::vector<remnants::Clump> clumps_of(const particles::State& state) {
  return remnants::friends_of_friends(state.x, state.id, remnants::linking_length_over_h * state.h);
}

/// Smallest of 1, 1.5, 2, 3, 4, 5, 6, 8, 10 times a power of ten that is no less than `value`.
double rounded_up(double value) {
  if (!(value > 0)) return 0;
  const double decade = std::pow(10, std::floor(std::log10(value)));
  for (const double digits : {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0})
    if (digits * decade >= value * (1 - 1e-12)) return digits * decade;
  return 10 * decade;
}

Vec3 centre_of_mass(const particles::State& state) {
  Vec3 sum;
  for (const Vec3& x : state.x) sum += x;
  return sum / static_cast<double>(state.size());
}

std::vector<double> speeds(const particles::State& state) {
  std::vector<double> speed(state.size());
  for (const remnants::Clump& clump : clumps_of(state)) {
    Vec3 mean;
    for (const std::uint32_t i : clump) mean += state.v[i];
    mean = mean / static_cast<double>(clump.size());
    for (const std::uint32_t i : clump) speed[i] = norm(state.v[i] - mean);
  }
  return speed;
}

std::vector<double> colour_values(const particles::State& state, ParticleColour colour,
                                  std::span<const double> depths) {
  if (colour == ParticleColour::speed) return speeds(state);
  if (colour == ParticleColour::body) return {state.body.begin(), state.body.end()};
  if (depths.size() != state.size())
    throw InputError(fmt::format("a snapshot with {} particles cannot belong to a run with {}",
                                 state.size(), depths.size()));
  std::vector<double> values;
  for (const std::uint32_t id : state.id) values.push_back(depths[id]);
  return values;
}

/// The greatest extent over 24 directions in the x-y plane: right to 1 %, m.
double length_of(const particles::State& state, const remnants::Clump& clump) {
  constexpr int directions = 24;
  double longest = 0;
  for (int k = 0; k < directions; ++k) {
    const double angle = pi * k / directions, cosine = std::cos(angle), sine = std::sin(angle);
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const std::uint32_t i : clump) {
      const double along = cosine * state.x[i].x + sine * state.x[i].y;
      low = std::min(low, along), high = std::max(high, along);
    }
    longest = std::max(longest, high - low);
  }
  return longest;
}

SeenBody seen(const particles::State& state, const remnants::Clump& clump, double radius) {
  const Vec3 first = state.x[clump.front()];
  SeenBody body{{}, first.x, first.x, first.y, first.y};
  for (const std::uint32_t i : clump) {
    const Vec3& x = state.x[i];
    body.centre += x;
    body.x_low = std::min(body.x_low, x.x), body.x_high = std::max(body.x_high, x.x);
    body.y_low = std::min(body.y_low, x.y), body.y_high = std::max(body.y_high, x.y);
  }
  body.centre = body.centre / static_cast<double>(clump.size());
  body.length = length_of(state, clump) + 2 * radius;
  body.x_low -= radius, body.x_high += radius, body.y_low -= radius, body.y_high += radius;
  return body;
}

/// Width of the square about `centre` that holds a body, m.
double width_about(const Vec3& centre, const SeenBody& b) {
  return 2 * std::max({centre.x - b.x_low, b.x_high - centre.x, centre.y - b.y_low,
                       b.y_high - centre.y});
}

/// Width of the square about the centre of mass that holds all bodies, m.
double width_of_all(const Layout& layout) {
  double width = 0;
  for (const SeenBody& body : layout.bodies)
    width = std::max(width, width_about(layout.centre, body));
  return width;
}

drawing::Colour colour_of(double value, const ColourScale& scale) {
  if (scale.colour == ParticleColour::body) return value == 0 ? target_colour : impactor_colour;
  return drawing::quantity_colour(scale.top > 0 ? value / scale.top : 0);
}

}  // namespace

ParticleView particle_view(const io::Snapshot& snapshot, ParticleColour colour,
                           std::span<const double> depths, bool cut) {
  const particles::State& state = snapshot.state;
  const double nearest = cut ? centre_of_mass(state).z : std::numeric_limits<double>::infinity();
  const std::vector<double> values = colour_values(state, colour, depths);
  std::vector<std::uint32_t> order(state.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, [&](std::uint32_t i, std::uint32_t j) {
    return state.x[i].z != state.x[j].z ? state.x[i].z < state.x[j].z : state.id[i] < state.id[j];
  });
  ParticleView view{state.time, shapes::particle_radius(snapshot), {}, {}};
  for (const std::uint32_t i : order)
    if (state.x[i].z <= nearest) view.x.push_back(state.x[i]), view.colour.push_back(values[i]);
  return view;
}

Layout layout_of(const io::Snapshot& snapshot) {
  const particles::State& state = snapshot.state;
  Layout layout;
  layout.centre = centre_of_mass(state);
  const double radius = shapes::particle_radius(snapshot);
  for (const remnants::Clump& clump : clumps_of(state)) {
    if (!layout.bodies.empty() && clump.size() < remnants::remnant_min_particles) break;
    layout.bodies.push_back(seen(state, clump, radius));
  }
  layout.body_diameters = 2 * (snapshot.scene.target.radius_m + impactor_radius(snapshot.scene));
  return layout;
}

Frame frame_of(std::span<const Layout> panels, std::optional<double> width) {
  double all = 0, largest = 0, alone = 0, most = 0;
  for (const Layout& p : panels) {
    all = std::max(all, width_of_all(p));
    largest = std::max(largest, width_about(p.centre, p.bodies.front()));
    alone = std::max(alone, width_about(p.bodies.front().centre, p.bodies.front()));
    most = std::max(most, widest_frame * p.body_diameters);
  }
  const double limit = width.value_or(most);
  const Frame about_all{width.value_or(std::min(margin * all, most)), false};
  if (margin * all <= limit || margin * largest <= limit) return about_all;
  const double first = margin * width_of_all(panels.front());
  const double needed = std::max({margin * alone, most / 2, first <= most ? first : 0});
  return {width.value_or(std::min(needed, most)), true};
}

Vec3 frame_centre(const Frame& frame, const Layout& layout) {
  return frame.on_largest && width_of_all(layout) > frame.width ? layout.bodies.front().centre
                                                                : layout.centre;
}

std::size_t remnants_outside(const Frame& frame, const Layout& layout) {
  const Vec3 middle = frame_centre(frame, layout);
  return static_cast<std::size_t>(std::ranges::count_if(layout.bodies, [&](const SeenBody& body) {
    const Vec3 off = body.centre - middle;
    return std::max(std::abs(off.x), std::abs(off.y)) > frame.width / 2;
  }));
}

ColourScale colour_scale(ParticleColour colour, const ParticleView& view) {
  if (colour == ParticleColour::body || view.colour.empty()) return {colour, 0, 0};
  std::vector<double> values = view.colour;
  const double exceeded_by = colour == ParticleColour::speed ? 0.01 : 0;
  const auto rank =
      static_cast<std::ptrdiff_t>((1 - exceeded_by) * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, values.begin() + rank);
  return {colour, rounded_up(values[static_cast<std::size_t>(rank)]), std::ranges::max(values)};
}

Bitmap panel_image(const ParticleView& view, const Frame& frame, const Vec3& centre,
                   const ColourScale& scale, int pixels) {
  const double zoom = pixels / frame.width;
  std::vector<Disc> discs;
  discs.reserve(view.x.size());
  for (std::size_t i = 0; i < view.x.size(); ++i) {
    const Vec3 off = view.x[i] - centre;
    discs.push_back({zoom * off.x + pixels / 2.0, zoom * off.y + pixels / 2.0, zoom * view.radius,
                     colour_of(view.colour[i], scale)});
  }
  return painted(discs, pixels, pixels);
}

}  // namespace eerie::pictures
