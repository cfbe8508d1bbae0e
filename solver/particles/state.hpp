#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solver/base/tensor.hpp"
#include "solver/base/vec3.hpp"

namespace eerie::particles {

/// The body that a particle comes from.
enum class Body : std::uint8_t { target = 0, impactor = 1 };

/// How much softer matter is than in the scene, while nothing moves fast (step/late.hpp).
struct Softening {
  double sound_speed = 1;  ///< factor on the sound speeds of the scene
  /// Whether remnants hardly move. While they still move, viscosity keeps its size: alpha grows by
  /// the inverse of the factor.
  bool is_calm = false;

  double viscosity_alpha() const { return is_calm ? 1 : 1 / sound_speed; }
  bool operator==(const Softening&) const = default;
};

/// What the solver integrates, in SI. Arrays have one entry per particle, in memory order
/// (tree/kd_tree.hpp). All particles have the same constant mass. Arrays of physics that the scene
/// does not use are empty.
struct State {
  double time = 0;  ///< s since the start of the run
  long step = 0;    ///< steps done
  double mass = 0;  ///< of one particle, kg
  Softening softening;
  double h = 0;                    ///< smoothing length at the reference density, m
  std::vector<std::uint32_t> id;   ///< 0..N-1, fixed for the whole run
  std::vector<std::uint8_t> body;  ///< Body
  std::vector<Vec3> x;             ///< m
  std::vector<Vec3> v;             ///< m/s
  std::vector<double> rho;         ///< kg/m^3
  std::vector<SymTensor> S;        ///< deviatoric stress, Pa

  // These exist with an energy equation. The last two are parts of u, kept for the energy budget.
  std::vector<double> u;             ///< specific internal energy, elastic energy included, J/kg
  std::vector<double> viscous_heat;  ///< heat that artificial viscosity has made, J/kg
  /// Work of the deviatoric stress, J/kg: partly elastic energy, partly heat.
  std::vector<double> shear_work;
  // This exists with fracture.
  std::vector<double> damage_cbrt;  ///< cube root of the damage D, which grows evenly

  std::size_t size() const { return x.size(); }
};

/// The smoothing length that keeps the number of neighbours, m. It is h at the density rho0.
inline double evolved_h(double h, double rho0, double rho) { return h * std::cbrt(rho0 / rho); }

/// rho + change. Where a lone particle would lose more than half of its density in one step, a
/// smooth continuation keeps the density positive.
inline double changed_density(double rho, double change) {
  return change > -0.5 * rho ? rho + change : -0.25 * rho * rho / change;
}

/// Time derivatives of the state at its last evaluation. dv_dt holds elastic and frictional forces.
/// Gravity stands apart, since it is evaluated less often.
struct Rates {
  std::vector<Vec3> dv_dt;
  std::vector<double> drho_dt;
  std::vector<SymTensor> dS_dt;
  std::vector<SymTensorf> correction;   ///< L, inverse moment matrix of the corrected gradient
  std::vector<Vec3f> g;                 ///< gravity when it was last evaluated, m/s^2
  std::vector<Vec3f> dg_dt;             ///< its change since the evaluation before, m/s^3
  std::vector<SymTensorf> shear_rate;   ///< traceless strain rate, 1/s; for shear-free viscosity
  std::vector<float> viscous_pressure;  ///< carried by viscosity, Pa; exists where friction uses it
  std::vector<double> du_dt;            ///< W/kg; with an energy equation
  std::vector<double> viscous_heating;  ///< the part of du_dt that viscosity makes, W/kg
  std::vector<double> shear_power;      ///< the part of du_dt of the deviatoric stress, W/kg
};

/// What a run needs besides State and Rates to continue with the same bits. Neighbour lists are a
/// pure function of the memory order and of the positions at their last build.
struct Restart {
  std::vector<Vec3> list_x;  ///< positions at the last list build, m
  double list_support = 0;   ///< the support radius of that build, m
  long builds_in_order = 0;  ///< list builds since particles were last sorted
};

/// A visit includes an optional field where it is in use, that is, not empty.
template <class Visit, class Array>
void visit_some(Visit& visit, const char* name, Array& array) {
  if (!array.empty()) visit(name, array);
}

/// The one table of per-particle fields: it calls visit(name, array) for each. Reordering,
/// resizing, saving, loading and comparing all use it.
template <class S, class Visit>
void visit_state(S& state, Visit&& visit) {
  visit("ParticleIDs", state.id);
  visit("BodyIDs", state.body);
  visit("Coordinates", state.x);
  visit("Velocities", state.v);
  visit("Densities", state.rho);
  visit("DeviatoricStresses", state.S);
  visit_some(visit, "InternalEnergies", state.u);
  visit_some(visit, "ViscousHeats", state.viscous_heat);
  visit_some(visit, "ShearWorks", state.shear_work);
  visit_some(visit, "DamageCubeRoots", state.damage_cbrt);
}
template <class R, class Visit>
void visit_rates(R& rates, Visit&& visit) {
  visit("Accelerations", rates.dv_dt);
  visit("DensityRates", rates.drho_dt);
  visit("StressRates", rates.dS_dt);
  visit("CorrectionMatrices", rates.correction);
  visit("GravityAccelerations", rates.g);
  visit("GravityRates", rates.dg_dt);
  visit_some(visit, "ShearRates", rates.shear_rate);
  visit_some(visit, "ViscousPressures", rates.viscous_pressure);
  visit_some(visit, "EnergyRates", rates.du_dt);
  visit_some(visit, "ViscousHeatingRates", rates.viscous_heating);
  visit_some(visit, "ShearPowers", rates.shear_power);
}
template <class R, class Visit>
void visit_restart(R& restart, Visit&& visit) {
  visit("ListCoordinates", restart.list_x);
}

/// Says which optional fields are in use.
struct OptionalFields {
  bool energy = false, damage = false, shear = false, viscous_pressure = false;
};
inline void resize(State& state, std::size_t n, OptionalFields use = {}) {
  if (use.energy) state.u.resize(n), state.viscous_heat.resize(n), state.shear_work.resize(n);
  if (use.damage) state.damage_cbrt.resize(n);
  visit_state(state, [n](const char*, auto& array) { array.resize(n); });
}
inline void resize(Rates& rates, std::size_t n, OptionalFields use = {}) {
  if (use.energy)
    rates.du_dt.resize(n), rates.viscous_heating.resize(n), rates.shear_power.resize(n);
  if (use.shear) rates.shear_rate.resize(n);
  if (use.viscous_pressure) rates.viscous_pressure.resize(n);
  visit_rates(rates, [n](const char*, auto& array) { array.resize(n); });
}

/// Reorders: array[i] becomes array[order[i]].
template <class T>
void permute(std::vector<T>& array, const std::vector<std::uint32_t>& order) {
  std::vector<T> sorted(array.size());
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < array.size(); ++i) sorted[i] = array[order[i]];
  array.swap(sorted);
}

}  // namespace eerie::particles
