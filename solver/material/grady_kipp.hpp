#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/base/random.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::material {

/// The flaws of all particles. Particle `id` has the activation strains of[id], in rising order.
struct Flaws {
  std::vector<std::uint32_t> begin;  ///< strain[begin[id]..begin[id+1]) are the flaws of id
  std::vector<double> strain;
  std::span<const double> operator[](std::size_t id) const {
    return std::span(strain).subspan(begin[id], begin[id + 1] - begin[id]);
  }
};

/// Tensile fracture by the growth of flaws (Grady & Kipp 1980; Benz & Asphaug 1994, 1995). The
/// number of flaws per volume that are active at strain eps is k eps^m (Weibull 1939). Each
/// active flaw grows a crack at the speed c_g; volumes of cracks add up, so
///   d(D^(1/3))/dt = n_act^(1/3) c_g / R_s,  D <= n_act/n_tot,
/// where R_s is the radius of the particle's volume. The strain is that of the largest tensile
/// principal stress, eps = sigma_max / ((1 - D) E).
class GradyKipp {
 public:
  static constexpr const char* token = "grady-kipp";

  explicit GradyKipp(const Scene::Material& m) : k_(m.grady_kipp) {}

  /// Flaw j >= 1 of the volume V (m^3) activates at (j/(k V))^(1/m). Random particles receive one
  /// flaw after another until each has one (Benz & Asphaug 1994, sec. 3.4.1).
  Flaws deal(std::size_t particles, double V, Random& random) const;

  /// The growth of D^(1/3), 1/s. `flaws` are those of the particle, c_l is the speed of the
  /// longitudinal wave, m/s, R_s is in m.
  double growth(double strain, std::span<const double> flaws, double c_l, double R_s) const {
    return std::cbrt(active(strain, flaws)) * k_.crack_speed * c_l / R_s;
  }

  /// D^(1/3) after dt. It never falls, and it rises at most to what the active flaws allow.
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
