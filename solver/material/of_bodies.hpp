#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <variant>
#include <vector>

#include "solver/material/material.hpp"
#include "solver/scene/two_materials.hpp"

namespace eerie::material {

/// The materials of both bodies. Their laws are the same, constants in them may differ.
class OfBodies {
 public:
  explicit OfBodies(const Scene& scene)
      : of_{make_material(scene.material), make_material(impactor_material(scene))} {}

  const Material& target() const { return of_[0]; }
  /// `body`: particles::Body as a number.
  const Material& operator[](std::uint8_t body) const { return of_[body]; }

  /// Reference densities, kg/m^3.
  double reference_density(std::uint8_t body) const { return of_[body].reference_density; }
  double lowest_density() const {
    return std::min(of_[0].reference_density, of_[1].reference_density);
  }
  double highest_density() const {
    return std::max(of_[0].reference_density, of_[1].reference_density);
  }
  /// Whether a free surface of any of them can carry stress.
  bool has_stressed_surface() const {
    return of_[0].stressed_surface() || of_[1].stressed_surface();
  }
  /// Of the longitudinal waves, m/s.
  double fastest_wave() const {
    return std::max(of_[0].longitudinal_speed(), of_[1].longitudinal_speed());
  }
  bool has_two_densities() const { return lowest_density() != highest_density(); }

  /// One law with the constants of each body, by particle.
  template <class Law>
  struct ByParticle {
    std::array<Law, 2> of;
    const std::vector<std::uint8_t>& body;
    const Law& operator[](std::size_t i) const { return of[body[i]]; }
  };
  /// Calls visit(eos, rheology), each a ByParticle; dispatched once for all of them.
  template <class Visit>
  void visit_laws(const std::vector<std::uint8_t>& body, Visit&& visit) const {
    std::visit(
        [&]<class Eos, class Rheology>(const Eos& eos, const Rheology& rheology) {
          visit(ByParticle<Eos>{{eos, std::get<Eos>(of_[1].eos)}, body},
                ByParticle<Rheology>{{rheology, std::get<Rheology>(of_[1].rheology)}, body});
        },
        of_[0].eos, of_[0].rheology);
  }

 private:
  std::array<Material, 2> of_;
};

}  // namespace eerie::material
