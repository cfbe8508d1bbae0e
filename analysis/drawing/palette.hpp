#pragma once

#include <cstdint>
#include <string>

namespace eerie::drawing {

/// A colour in sRGB.
struct Colour {
  std::uint8_t r = 0, g = 0, b = 0;
  bool operator==(const Colour&) const = default;
};

std::string hex(Colour colour);  ///< "#rrggbb"

/// The lightness CIE L*, from 0 (black) to 100 (white).
double lightness(Colour colour);

/// The fill of a map's cell for b/a, limited to [0, 1]: blue below 0.3, where remnants are
/// extremely elongated, and sand and cream above. Lightness rises with b/a, so the scale works in
/// grey, and blue and orange differ in every common form of colour blindness. Colours are
/// interpolated in OKLab (Ottosson 2020).
Colour b_over_a_colour(double b_over_a);

/// The colour of a quantity at `part` of its scale, limited to [0, 1]: violet, blue, green, yellow.
/// Lightness rises evenly, so the scale works in grey and with every common form of colour
/// blindness. Its light end still stands out on white. Colours are interpolated in OKLab.
Colour quantity_colour(double part);

/// The colour for a number of extremely elongated remnants, at `part` of its scale, limited to [0,
/// 1]. It goes from cream to the blue of such remnants in maps of b/a, and its lightness falls.
Colour eer_count_colour(double part);

/// Black or white, whichever has more contrast on `background`.
Colour text_colour(Colour background);

}  // namespace eerie::drawing
