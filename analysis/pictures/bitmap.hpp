#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "analysis/drawing/palette.hpp"

namespace eerie::pictures {

/// A picture of pixels, rows from the top down, sRGB.
struct Bitmap {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;  ///< 3 * width * height

  drawing::Colour at(int column, int row) const {
    const std::size_t i = 3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                               static_cast<std::size_t>(column));
    return {rgb[i], rgb[i + 1], rgb[i + 2]};
  }
};

/// A round spot, pixels from the lower left corner of the picture.
struct Disc {
  double x = 0, y = 0, radius = 0;
  drawing::Colour colour;
};

/// Discs on white, the last ones on top, each with a darker rim where it is wide enough to be seen
/// (three pixels and more), so that neighbours of one colour can be told apart. Edges are smooth:
/// three by three samples per pixel.
Bitmap painted(std::span<const Disc> discs, int width, int height);

/// The colours of a scale from left (0) to right (1).
Bitmap scale_image(int width, int height);

}  // namespace eerie::pictures
