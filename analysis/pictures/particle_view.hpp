#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/pictures/bitmap.hpp"
#include "analysis/remnants/origin.hpp"
#include "analysis/shapes/hull.hpp"
#include "solver/io/snapshot.hpp"

namespace eerie::pictures {

/// The meaning of a particle's colour.
enum class ParticleColour {
  body,   ///< target or impactor
  depth,  ///< depth below the surface of its own body at the start, m
  speed   ///< speed relative to the centre of mass of its clump, m/s
};
inline constexpr std::array<std::string_view, 3> particle_colour_names = {"body", "depth", "speed"};

/// The particles of a snapshot, seen against the orbital angular momentum: x to the right, y up, z
/// towards the eye. Orbits lie in the x-y plane (solver/initial/orbit.hpp).
struct ParticleView {
  double time = 0;             ///< s
  double radius = 0;           ///< of a particle, m
  std::vector<Vec3> x;         ///< m; the farthest particle first
  std::vector<double> colour;  ///< Body, m or m/s
};

/// Makes the view. `depths`, by id, are needed where colours are depths. `cut` removes the half in
/// front of the plane of the orbit through the centre of mass, so that the inside is visible.
ParticleView particle_view(const io::Snapshot& snapshot, ParticleColour colour,
                           std::span<const double> depths = {}, bool cut = false);

/// A contiguous body, by the numbers that its picture needs.
struct SeenBody {
  Vec3 centre;                          ///< of mass, m
  double x_low, x_high, y_low, y_high;  ///< extent of its particles with their radius, m
  double length = 0;                    ///< its greatest extent in the plane of the orbit, m
};

/// The positions of bodies in a snapshot.
struct Layout {
  Vec3 centre;  ///< centre of mass of all particles, m
  /// Remnants, the most massive first; the largest clump where there are none.
  std::vector<SeenBody> bodies;
  double body_diameters = 0;  ///< of target and impactor together, m
};
Layout layout_of(const io::Snapshot& snapshot);

/// The square that every panel shows.
struct Frame {
  double width = 0;  ///< m
  /// Whether a panel whose remnants it cannot hold about the centre of mass is centred on the
  /// largest of them.
  bool on_largest = false;
};

/// Unless a width is given, a frame is at most this many times as wide as both bodies' diameters
/// together.
inline constexpr double widest_frame = 3;

/// The frame about the centre of mass that contains all remnants of all panels. Where that would be
/// wider than widest_frame, its width is limited to that. The limited frame is about the centre of
/// mass if it contains the largest remnant of each panel, and otherwise about that remnant. It
/// still holds all bodies of the first panel where the limit lets it. `width`, m, replaces the
/// width.
Frame frame_of(std::span<const Layout> panels, std::optional<double> width = std::nullopt);

/// The middle of the frame in a panel, m; the number of its remnants with their centre outside.
Vec3 frame_centre(const Frame& frame, const Layout& layout);
std::size_t remnants_outside(const Frame& frame, const Layout& layout);

/// The scale of colours from 0 to `top`, which all panels share.
struct ColourScale {
  ParticleColour colour = ParticleColour::body;
  double top = 0;      ///< m or m/s
  double highest = 0;  ///< highest value of any particle; may be above `top`
};

/// The scale that a panel needs, rounded up to a number with one or two digits. Depths go up to the
/// deepest particle, speeds up to the speed that one particle in a hundred exceeds.
ColourScale colour_scale(ParticleColour colour, const ParticleView& view);

/// The panel as a square picture with so many pixels along each side.
Bitmap panel_image(const ParticleView& view, const Frame& frame, const Vec3& centre,
                   const ColourScale& scale, int pixels);

inline constexpr drawing::Colour target_colour{0x00, 0x72, 0xb2};    ///< Okabe & Ito's blue
inline constexpr drawing::Colour impactor_colour{0xe6, 0x9f, 0x00};  ///< and orange

}  // namespace eerie::pictures
