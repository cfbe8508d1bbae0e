#pragma once

#include <algorithm>
#include <cmath>

#include "solver/base/constants.hpp"
#include "solver/material/eos_point.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::material {

/// The equation of state of Tillotson (1962), as in Benz & Asphaug (1999), with all branches.
class Tillotson {
 public:
  static constexpr const char* token = "tillotson";
  static constexpr bool is_cold = true;  ///< resists compression without heat

  explicit Tillotson(const Scene::Material& m) : k_(m.tillotson), rho0_(m.rho0_kg_per_m3) {}

  /// p(rho, u) and c = sqrt(dp/drho + (p/rho^2) dp/du), for rho > 0 (kg/m^3) and u (J/kg). The
  /// pressure may be negative; damage limits it elsewhere.
  EosPoint operator()(double rho, double u) const {
    if (u == 0) return cold(rho);
    const bool expanded = rho < rho0_;
    const Slope cold = compressed(rho, u);
    if (!expanded || u <= k_.u_iv_J_per_kg) return point(cold, rho);
    const Slope hot = vapour(rho, u);
    if (u >= k_.u_cv_J_per_kg) return point(hot, rho);
    // Between incipient and complete vaporisation p is linear in u between the two branches.
    const double width = k_.u_cv_J_per_kg - k_.u_iv_J_per_kg;
    const double w = (u - k_.u_iv_J_per_kg) / width;
    const Slope mixed{(1 - w) * cold.p + w * hot.p, (1 - w) * cold.dp_drho + w * hot.dp_drho,
                      (1 - w) * cold.dp_du + w * hot.dp_du + (hot.p - cold.p) / width};
    return point(mixed, rho);
  }

  double reference_density() const { return rho0_; }
  /// The bulk sound speed of the uncompressed cold material, sqrt(A/rho0), m/s.
  double reference_sound_speed() const { return std::sqrt(k_.A_Pa / rho0_); }

  /// The density at which the cold material has pressure p >= 0, that is the root of A mu + B mu^2
  /// = p with mu = rho/rho0 - 1.
  double density_at(double p) const {
    const double mu = 2 * p / (k_.A_Pa + std::sqrt(k_.A_Pa * k_.A_Pa + 4 * k_.B_Pa * p));
    return rho0_ * (1 + mu);
  }

 private:
  /// The compressed branch at u = 0, for impacts without heat. Most of its terms vanish.
  EosPoint cold(double rho) const {
    const double mu = rho / rho0_ - 1;
    return point(
        {(k_.A_Pa + k_.B_Pa * mu) * mu, (k_.A_Pa + 2 * k_.B_Pa * mu) / rho0_, (k_.a + k_.b) * rho},
        rho);
  }

  struct Slope {
    double p, dp_drho, dp_du;
  };

  EosPoint point(const Slope& s, double rho) const {
    // The speed never falls below that of the uncompressed cold material. The slope of the expanded
    // law falls to zero at half density, which says nothing about loose rubble (decisions.md, 10).
    const double c2 = s.dp_drho + s.p / (rho * rho) * s.dp_du;
    return {s.p, std::sqrt(std::max(c2, k_.A_Pa / rho0_))};
  }

  /// Compressed or cold states: p = [a + b/w] rho u + A mu + B mu^2, w = u rho0^2/(u0 rho^2) + 1.
  Slope compressed(double rho, double u) const {
    const double eta = rho / rho0_, mu = eta - 1;
    const double w = u / (k_.u0_J_per_kg * eta * eta) + 1;
    const double f = k_.a + k_.b / w;
    const double dw_drho = -2 * (w - 1) / rho, dw_du = 1 / (k_.u0_J_per_kg * eta * eta);
    const double df_dw = -k_.b / (w * w);
    return {f * rho * u + k_.A_Pa * mu + k_.B_Pa * mu * mu,
            f * u + df_dw * dw_drho * rho * u + (k_.A_Pa + 2 * k_.B_Pa * mu) / rho0_,
            f * rho + df_dw * dw_du * rho * u};
  }

  /// Completely vaporised, expanded states:
  /// p = a rho u + [b rho u / w + A mu e^(-beta z)] e^(-alpha z^2), z = rho0/rho - 1.
  Slope vapour(double rho, double u) const {
    const double eta = rho / rho0_, mu = eta - 1, z = 1 / eta - 1;
    const double w = u / (k_.u0_J_per_kg * eta * eta) + 1;
    const double dw_drho = -2 * (w - 1) / rho, dw_du = 1 / (k_.u0_J_per_kg * eta * eta);
    const double dz_drho = -rho0_ / (rho * rho);
    const double gauss = std::exp(-k_.alpha * z * z), decay = std::exp(-k_.beta * z);
    const double thermal = k_.b * rho * u / w, cold = k_.A_Pa * mu * decay;
    const double dthermal_drho = k_.b * u / w - thermal / w * dw_drho;
    const double dcold_drho = k_.A_Pa * decay / rho0_ - k_.beta * cold * dz_drho;
    return {
        k_.a * rho * u + (thermal + cold) * gauss,
        k_.a * u +
            (dthermal_drho + dcold_drho - 2 * k_.alpha * z * dz_drho * (thermal + cold)) * gauss,
        k_.a * rho + (k_.b * rho / w - thermal / w * dw_du) * gauss};
  }

  Scene::Tillotson k_;
  double rho0_;
};

}  // namespace eerie::material
