#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/base/random.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::material {

/// Flaws of all particles: particle `id` has the activation strains of[id], in rising order.
struct Flaws {
  std::vector<std::uint32_t> begin;  ///< flaws of id: strain[begin[id]..begin[id+1])
  std::vector<double> strain;
  std::span<const double> operator[](std::size_t id) const {
    return std::span(strain).subspan(begin[id], begin[id + 1] - begin[id]);
  }
};

/// Tensile fracture by the growth of flaws (Grady & Kipp 1980; Benz & Asphaug 1994, 1995). The
/// number of flaws per volume that are active at strain eps is k eps^m (Weibull 1939). Each
/// active flaw grows a crack at the speed c_g; volumes of cracks add up, so
///   d(D^(1/3))/dt = n_act^(1/3) c_g / R_s,  D <= n_act/n_tot,
/// with R_s the radius of the particle's volume. The strain is that of the largest tensile
/// principal stress, eps = sigma_max / ((1 - D) E).
class GradyKipp {
 public:
  static constexpr const char* token = "grady-kipp";

  explicit GradyKipp(const Scene::Material& m) : k_(m.grady_kipp) {}

  /// Flaw j >= 1 of the volume V (m^3) activates at (j/(k V))^(1/m); flaws are dealt to random
  /// particles until each has one (Benz & Asphaug 1994, sec. 3.4.1).
  Flaws deal(std::size_t particles, double V, Random& random) const;

  /// Growth of D^(1/3) per second. `flaws`: of the particle; c_l: longitudinal wave, m/s; R_s: m.
  double growth(double strain, std::span<const double> flaws, double c_l, double R_s) const {
    return std::cbrt(active(strain, flaws)) * k_.crack_speed * c_l / R_s;
  }

  /// D^(1/3) after dt: grown, but no further than the active flaws reach, and never healed.
  double grown(double damage_cbrt, double strain, std::span<const double> flaws, double c_l,
               double R_s, double dt) const {
    const double limit = std::cbrt(active(strain, flaws) / static_cast<double>(flaws.size()));
    const double next = damage_cbrt + dt * growth(strain, flaws, c_l, R_s);
    return std::max(damage_cbrt, std::min(next, limit));
  }

 private:
  static double active(double strain, std::span<const double> flaws) {
    return static_cast<double>(std::upper_bound(flaws.begin(), flaws.end(), strain) -
                               flaws.begin());
  }
  Scene::GradyKipp k_;
};

}  // namespace eerie::material
