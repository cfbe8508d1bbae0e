#pragma once

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

/// What the colour of a particle says.
enum class ParticleColour {
  body,   ///< target or impactor
  depth,  ///< below the surface of its own body at the start, m
  speed   ///< relative to the centre of mass of its clump, m/s
};

/// What a snapshot has to show, seen against the orbital angular momentum: x to the right, y up,
/// z towards the eye (orbits lie in the x-y plane, solver/initial/orbit.hpp).
struct ParticleView {
  double time = 0;             ///< s
  double radius = 0;           ///< of a particle, m
  std::vector<Vec3> x;         ///< m, from the farthest particle to the nearest
  std::vector<double> colour;  ///< Body, m or m/s
};

/// `depths` by id, where colours are depths. `cut` leaves out the half before the plane of the
/// orbit through the centre of mass, so that the inside is seen.
ParticleView particle_view(const io::Snapshot& snapshot, ParticleColour colour,
                           std::span<const double> depths = {}, bool cut = false);

/// A contiguous body as its picture needs it.
struct SeenBody {
  Vec3 centre;                          ///< of mass, m
  double x_low, x_high, y_low, y_high;  ///< of its particles with their radius, m
};

/// Where things are in a snapshot.
struct Layout {
  Vec3 centre;  ///< of mass of everything, m
  std::vector<SeenBody>
      bodies;                 ///< remnants, the most massive first; without any, the largest clump
  double body_diameters = 0;  ///< of target and impactor together, m
};
Layout layout_of(const io::Snapshot& snapshot);

/// The square that every panel shows.
struct Frame {
  double width = 0;  ///< m
  bool on_largest =
      false;  ///< about the largest remnant of each panel, else about the centre of mass
};

/// A frame is no wider than so many times both bodies' diameters unless it is asked for.
inline constexpr double widest_frame = 3;

/// The frame that holds all remnants of all panels about the centre of mass; where that would be
/// wider than widest_frame, one of that width at most: about the centre of mass if it holds the
/// largest remnant of each panel, else about that. `width` in m overrides the width.
Frame frame_of(std::span<const Layout> panels, std::optional<double> width = std::nullopt);

/// Middle of the frame in a panel, m, and how many of its remnants have their centre outside.
Vec3 frame_centre(const Frame& frame, const Layout& layout);
std::size_t remnants_outside(const Frame& frame, const Layout& layout);

/// What colours stand for, from 0 to `top`; the same in all panels.
struct ColourScale {
  ParticleColour colour = ParticleColour::body;
  double top = 0;      ///< m or m/s
  double highest = 0;  ///< of any particle; may lie above the top
};

/// The scale that a panel needs: depths up to the deepest particle, speeds up to one that one
/// particle in a hundred exceeds, rounded up to a number with one or two digits.
ColourScale colour_scale(ParticleColour colour, const ParticleView& view);

/// The panel as a square picture of so many pixels.
Bitmap panel_image(const ParticleView& view, const Frame& frame, const Vec3& centre,
                   const ColourScale& scale, int pixels);

inline constexpr drawing::Colour target_colour{0x00, 0x72, 0xb2};    ///< Okabe & Ito's blue
inline constexpr drawing::Colour impactor_colour{0xe6, 0x9f, 0x00};  ///< and orange

}  // namespace eerie::pictures
