#pragma once

#include <numbers>

namespace eerie {

/// Newton's constant, m^3 kg^-1 s^-2 (CODATA 2018).
inline constexpr double newton_G = 6.67430e-11;
inline constexpr double pi = std::numbers::pi;

constexpr double cubed(double x) { return x * x * x; }
constexpr double radians(double degrees) { return degrees * (pi / 180); }
constexpr double degrees(double radians) { return radians * (180 / pi); }
constexpr double sphere_volume(double radius) { return 4 * pi / 3 * cubed(radius); }

}  // namespace eerie
