#include "analysis/pictures/bitmap.hpp"

#include <algorithm>
#include <cmath>

namespace eerie::pictures {

namespace {

constexpr int samples = 3;  ///< per pixel and direction
constexpr double rim = 0.2, rim_brightness = 0.62, least_radius_with_rim = 3;

/// White samples, to be painted on.
struct Samples {
  int width, height;
  std::vector<drawing::Colour> colour;

  Samples(int w, int h)
      : width(w),
        height(h),
        colour(static_cast<std::size_t>(w) * static_cast<std::size_t>(h),
               drawing::Colour{255, 255, 255}) {}

  /// The centres of samples lie at half-integers.
  void fill(double x, double y, double radius, drawing::Colour c) {
    const int top = std::min(height - 1, static_cast<int>(std::floor(y + radius - 0.5)));
    for (int row = std::max(0, static_cast<int>(std::ceil(y - radius - 0.5))); row <= top; ++row) {
      const double dy = row + 0.5 - y, half = std::sqrt(std::max(radius * radius - dy * dy, 0.0));
      const int from = std::max(0, static_cast<int>(std::ceil(x - half - 0.5)));
      const int to = std::min(width - 1, static_cast<int>(std::floor(x + half - 0.5)));
      const auto line = colour.begin() + static_cast<std::ptrdiff_t>(row) * width;
      if (from <= to) std::fill(line + from, line + to + 1, c);
    }
  }
};

drawing::Colour darker(drawing::Colour c) {
  const auto part = [](std::uint8_t x) {
    return static_cast<std::uint8_t>(std::lround(rim_brightness * x));
  };
  return {part(c.r), part(c.g), part(c.b)};
}

/// The mean of the samples of each pixel.
Bitmap averaged(const Samples& fine) {
  Bitmap image{fine.width / samples, fine.height / samples, {}};
  image.rgb.reserve(3 * static_cast<std::size_t>(image.width) *
                    static_cast<std::size_t>(image.height));
  for (int row = image.height - 1; row >= 0; --row)
    for (int column = 0; column < image.width; ++column) {
      int r = 0, g = 0, b = 0;
      for (int k = 0; k < samples * samples; ++k) {
        const int i = samples * column + k % samples, j = samples * row + k / samples;
        const drawing::Colour& c =
            fine.colour[static_cast<std::size_t>(j) * static_cast<std::size_t>(fine.width) +
                        static_cast<std::size_t>(i)];
        r += c.r, g += c.g, b += c.b;
      }
      for (const int sum : {r, g, b})
        image.rgb.push_back(static_cast<std::uint8_t>(sum / (samples * samples)));
    }
  return image;
}

}  // namespace

Bitmap painted(std::span<const Disc> discs, int width, int height) {
  Samples fine(samples * width, samples * height);
  for (const Disc& disc : discs) {
    const double x = samples * disc.x, y = samples * disc.y;
    // A disc smaller than a sample would vanish between them.
    const double radius = std::max(samples * disc.radius, 0.75);
    if (disc.radius < least_radius_with_rim) {
      fine.fill(x, y, radius, disc.colour);
    } else {
      fine.fill(x, y, radius, darker(disc.colour));
      fine.fill(x, y, (1 - rim) * radius, disc.colour);
    }
  }
  return averaged(fine);
}

Bitmap scale_image(int width, int height) {
  Bitmap image{width, height, {}};
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      const drawing::Colour c = drawing::quantity_colour((column + 0.5) / width);
      image.rgb.insert(image.rgb.end(), {c.r, c.g, c.b});
    }
  return image;
}

}  // namespace eerie::pictures
