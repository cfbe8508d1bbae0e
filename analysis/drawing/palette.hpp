#pragma once

#include <cstdint>
#include <string>

namespace eerie::drawing {

/// sRGB.
struct Colour {
  std::uint8_t r = 0, g = 0, b = 0;
  bool operator==(const Colour&) const = default;
};

std::string hex(Colour colour);  ///< "#rrggbb"

/// CIE L*, 0 (black) to 100 (white).
double lightness(Colour colour);

/// Fill of a map's cell for b/a in [0, 1] (clamped): blue below 0.3, where remnants are extremely
/// elongated, sand and cream above. Lightness rises all the way, so it reads in grey as well, and
/// blue against orange is told apart in every common form of colour blindness. Interpolated in
/// OKLab (Ottosson 2020).
Colour b_over_a_colour(double b_over_a);

/// Colour of a quantity at `part` of its scale, in [0, 1] (clamped): violet, blue, green, yellow.
/// Lightness rises evenly, so it reads in grey and with every common form of colour blindness;
/// its light end still stands out on white. Interpolated in OKLab.
Colour quantity_colour(double part);

/// Colour of how many remnants are extremely elongated, at `part` of its scale, in [0, 1]
/// (clamped): from cream to the blue that they have in maps of b/a. Lightness falls all the way.
Colour eer_count_colour(double part);

/// Black or white, whichever stands out better on `background`.
Colour text_colour(Colour background);

}  // namespace eerie::drawing
