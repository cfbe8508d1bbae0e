#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "analysis/drawing/palette.hpp"

namespace eerie::pictures {

/// A picture of pixels in sRGB, with rows from the top down.
struct Bitmap {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;  ///< 3 * width * height

  drawing::Colour at(int column, int row) const {
    const std::size_t i = 3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                               static_cast<std::size_t>(column));
    return {rgb[i], rgb[i + 1], rgb[i + 2]};
  }
};

/// A disc, in pixels from the lower left corner of the picture.
struct Disc {
  double x = 0, y = 0, radius = 0;
  drawing::Colour colour;
};

/// Draws discs on white, the last ones on top. Discs of three pixels and more have a darker rim, so
/// that neighbours of one colour can be distinguished. Edges are smooth, with three by three
/// samples per pixel.
Bitmap painted(std::span<const Disc> discs, int width, int height);

/// Draws the colours of a scale from left (0) to right (1).
Bitmap scale_image(int width, int height);

}  // namespace eerie::pictures
