#include "analysis/drawing/palette.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/remnants/remnants.hpp"
#include "solver/base/vec3.hpp"

namespace eerie::drawing {

namespace {

double to_linear(std::uint8_t channel) {
  const double c = channel / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

std::uint8_t from_linear(double c) {
  const double s = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(s, 0.0, 1.0)));
}

Vec3 to_oklab(Colour colour) {
  const double r = to_linear(colour.r), g = to_linear(colour.g), b = to_linear(colour.b);
  const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
          1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
          0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

Colour from_oklab(const Vec3& c) {
  const auto cube = [](double x) { return x * x * x; };
  const double l = cube(c.x + 0.3963377774 * c.y + 0.2158037573 * c.z);
  const double m = cube(c.x - 0.1055613458 * c.y - 0.0638541728 * c.z);
  const double s = cube(c.x - 0.0894841775 * c.y - 1.2914855480 * c.z);
  return {from_linear(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
          from_linear(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
          from_linear(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

struct Anchor {
  double at;  ///< b/a, or part of a scale
  Colour colour;
};
constexpr std::array<Anchor, 2> elongated = {
    {{0.0, {0x0b, 0x2a, 0x66}}, {remnants::eer_max_b_over_a, {0x5b, 0xa3, 0xe0}}}};
constexpr std::array<Anchor, 3> other = {{{remnants::eer_max_b_over_a, {0xde, 0x97, 0x5c}},
                                          {0.6, {0xf0, 0xc8, 0x8c}},
                                          {1.0, {0xfd, 0xf6, 0xdc}}}};

// Anchors of quantity_colour, evenly spaced in OKLab's lightness to within a few per cent.
constexpr std::array<Anchor, 4> quantity = {{{0.0, {0x2a, 0x0f, 0x52}},
                                             {0.33, {0x1f, 0x59, 0x9c}},
                                             {0.66, {0x2f, 0xa2, 0x7d}},
                                             {1.0, {0xf2, 0xd2, 0x3c}}}};

constexpr std::array<Anchor, 3> eer_count = {
    {{0.0, {0xfd, 0xf6, 0xdc}}, {0.5, {0x8f, 0xbf, 0xe3}}, {1.0, {0x12, 0x45, 0x92}}}};

template <std::size_t N>
Colour between(const std::array<Anchor, N>& anchors, double value) {
  std::size_t k = 0;
  while (k + 2 < N && value > anchors[k + 1].at) ++k;
  const Anchor &low = anchors[k], &high = anchors[k + 1];
  const double t = (value - low.at) / (high.at - low.at);
  return from_oklab((1 - t) * to_oklab(low.colour) + t * to_oklab(high.colour));
}

}  // namespace

std::string hex(Colour c) { return fmt::format("#{:02x}{:02x}{:02x}", c.r, c.g, c.b); }

double lightness(Colour c) {
  const double y = 0.2126 * to_linear(c.r) + 0.7152 * to_linear(c.g) + 0.0722 * to_linear(c.b);
  return y > 216.0 / 24389 ? 116 * std::cbrt(y) - 16 : y * 24389 / 27;
}

Colour b_over_a_colour(double b_over_a) {
  const double value = std::clamp(b_over_a, 0.0, 1.0);
  return value < remnants::eer_max_b_over_a ? between(elongated, value) : between(other, value);
}

Colour quantity_colour(double part) { return between(quantity, std::clamp(part, 0.0, 1.0)); }

Colour eer_count_colour(double part) { return between(eer_count, std::clamp(part, 0.0, 1.0)); }

Colour text_colour(Colour background) {
  return lightness(background) < 55 ? Colour{255, 255, 255} : Colour{0, 0, 0};
}

}  // namespace eerie::drawing
