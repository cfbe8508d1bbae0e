#include "solver/base/bodies/ellipsoid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/base/constants.hpp"

namespace eerie {

namespace {

/// Carlson's symmetric integral R_D(x, y, z) = (3/2) int_0^inf dt (t+x)^-1/2 (t+y)^-1/2 (t+z)^-3/2,
/// by his duplication theorem (Carlson 1995; DLMF 19.36): each round brings the arguments four
/// times closer together, and a series about their mean does the rest.
double carlson_RD(double x, double y, double z) {
  constexpr int rounds = 12;
  const double mean_0 = (x + y + 3 * z) / 5, dx = mean_0 - x, dy = mean_0 - y;
  double mean = mean_0, part = 1, sum = 0;
  for (int n = 0; n < rounds; ++n) {
    const double rx = std::sqrt(x), ry = std::sqrt(y), rz = std::sqrt(z);
    const double shift = rx * ry + rx * rz + ry * rz;
    sum += part / (rz * (z + shift));
    x = (x + shift) / 4, y = (y + shift) / 4, z = (z + shift) / 4, mean = (mean + shift) / 4;
    part /= 4;
  }
  const double X = dx * part / mean, Y = dy * part / mean, Z = -(X + Y) / 3;
  const double E2 = X * Y - 6 * Z * Z, E3 = (3 * X * Y - 8 * Z * Z) * Z;
  return part / (mean * std::sqrt(mean)) * (1 - 3 * E2 / 14 + E3 / 6) + 3 * sum;
}

}  // namespace

Vec3 attraction_coefficients(const Vec3& a) {
  const double x2 = a.x * a.x, y2 = a.y * a.y, z2 = a.z * a.z, f = 2 * a.x * a.y * a.z / 3;
  return {f * carlson_RD(y2, z2, x2), f * carlson_RD(z2, x2, y2), f * carlson_RD(x2, y2, z2)};
}

double needed_friction(const Vec3& a, double rho, double omega) {
  const Vec3 A = attraction_coefficients(a);
  // In units of 2 pi G rho^2/5.
  const double W = omega * omega / (2 * pi * newton_G * rho);
  if (W >= std::min(A.x, A.y)) return std::numeric_limits<double>::infinity();
  const double x = a.x * a.x * (W - A.x), y = a.y * a.y * (W - A.y), z = -a.z * a.z * A.z;
  const double p = -(x + y + z) / 3;
  const double J2 = ((x - y) * (x - y) + (y - z) * (y - z) + (z - x) * (z - x)) / 6;
  return std::sqrt(J2) / p;
}

}  // namespace eerie
