#include <algorithm>
#include <cmath>

#include "solver/base/constants.hpp"
#include "solver/base/packs.hpp"
#include "solver/base/principal.hpp"
#include "solver/scene/tide.hpp"
#include "solver/sph/kernel.hpp"
#include "solver/sph/stress.hpp"
#include "solver/step/solver.hpp"

// The rates of a Solver: laws of the material, rows, neighbour sums.

namespace eerie::step {

void Solver::evaluate(double ahead) {
  apply_material({ahead, ahead});
  sum_over_neighbours(ahead);
}

/// What strength depends on, at the time of the rates.
material::Condition Solver::condition(std::size_t i, double ahead) const {
  material::Condition now{0, materials_.target().initial_damage()};
  if (fields_.energy) now.u = state_.u[i] + ahead * rates_.du_dt[i];
  if (fields_.damage) now.damage = cubed(state_.damage_cbrt[i]);
  return now;
}

/// Pressure, sound speed and yielded stress of the predicted state; the rows for pair sums.
void Solver::apply_material(Ahead ahead) {
  const StageTimer timer(stages_, Stage::material);
  std::size_t too_thin = nobody, too_cold = nobody;
#pragma omp parallel for schedule(static) reduction(min : too_thin, too_cold)
  for (std::size_t b = 0; b < tree::bucket_count(state_.size()); ++b) {
    std::array<Predicted, tree::bucket_size> bucket;
    apply_laws(b, ahead.stress, bucket);
    fill_rows(b, ahead, bucket);
    const std::size_t first = b * tree::bucket_size;
    for (std::size_t i = first; i < std::min(first + tree::bucket_size, state_.size()); ++i) {
      if (!(bucket[i - first].rho > 0)) too_thin = std::min(too_thin, i);
      if (!(bucket[i - first].c >= 0)) too_cold = std::min(too_cold, i);
      if (!ahead.is_final) continue;
      state_.S[i] = predicted_stress(i, 0);
      yield_factor_[i] = 1;
    }
  }
  check(too_thin, "negative-density", "lower numerics.cfl");
  check(too_cold, "no-sound-speed", "its pressure has no real sound speed; lower numerics.cfl");
}

/// The laws of one bucket; dispatched once for its particles.
void Solver::apply_laws(std::size_t b, double ahead,
                        std::array<Predicted, tree::bucket_size>& out) {
  const std::size_t first = b * tree::bucket_size,
                    last = std::min(first + tree::bucket_size, state_.size());
  materials_.visit_laws(state_.body, [&](const auto& eos, const auto& rheology) {
    for (std::size_t i = first; i < last; ++i) {
      const double rho = predicted_density(i, ahead);
      const material::Condition now = condition(i, ahead);
      const material::EosPoint point = eos[i](rho, now.u);
      double p = rheology[i].pressure(point.p, now);
      if (is_void(i)) p = std::min(p, 0.0);
      pressure_[i] = p;
      const SymTensor trial = state_.S[i] + ahead * rates_.dS_dt[i];
      yield_factor_[i] = is_frayed(i) ? 0.0F
                                      : static_cast<float>(rheology[i].yield_factor(
                                            second_invariant(trial), confining_pressure(i), now));
      out[i - first] = {rho, point.c};
    }
  });
}

/// The yielded stress of the predicted state, for as long as its rates are still the old ones.
SymTensor Solver::predicted_stress(std::size_t i, double ahead) const {
  if (ahead == 0) return double{yield_factor_[i]} * state_.S[i];
  return double{yield_factor_[i]} * (state_.S[i] + ahead * rates_.dS_dt[i]);
}

/// The momentum flux -p 1 + S L, or (-p 1 + S) L where the continuity equation is corrected too,
/// with the L of the last sums: it follows the arrangement of the neighbours, which hardly moves
/// in a step.
sph::FluxRows Solver::momentum_flux(std::size_t i, double ahead) const {
  const SymTensor S = predicted_stress(i, ahead);
  const double p = pressure_[i];
  Quad<double> x{1, 0, 0, 0}, y{0, 1, 0, 0}, z{0, 0, 1, 0};  // rows of L
  sph::FluxRows pressure = {p * x, p * y, p * z};
  if (gradient_ == Gradient::corrected || gradient_ == Gradient::corrected_fully) {
    const SymTensor L = to_double(rates_.correction[i]);
    if (gradient_ == Gradient::corrected_fully) {
      const SymTensor M = sph::moderate(L);
      pressure = {p * Quad<double>{M.xx, M.xy, M.xz, 0}, p * Quad<double>{M.xy, M.yy, M.yz, 0},
                  p * Quad<double>{M.xz, M.yz, M.zz, 0}};
    }
    x = Quad<double>{L.xx, L.xy, L.xz, 0}, y = Quad<double>{L.xy, L.yy, L.yz, 0},
    z = Quad<double>{L.xz, L.yz, L.zz, 0};
  }
  return {S.xx * x + S.xy * y + S.xz * z - pressure[0],
          S.xy * x + S.yy * y + S.yz * z - pressure[1],
          S.xz * x + S.yz * y + S.zz * z - pressure[2]};
}

void Solver::fill_rows(std::size_t b, Ahead ahead,
                       const std::array<Predicted, tree::bucket_size>& bucket) {
  const std::size_t first = b * tree::bucket_size,
                    last = std::min(first + tree::bucket_size, state_.size());
  const double age = gravity_age();
  visit_sums([&](auto& sums) {
    sums.rows.set_origin(b, state_.x[first], state_.v[first]);
    for (std::size_t i = first; i < last; ++i) {
      const auto [rho, c] = bucket[i - first];
      const Vec3 v = state_.v[i] + ahead.velocity * (rates_.dv_dt[i] + gravity(i, age));
      sums.rows.set(i, state_.x[i], v, state_.mass / filling_density(rho), c,
                    momentum_flux(i, ahead.stress));
      using Family = std::remove_cvref_t<decltype(sums)>;
      if constexpr (Family::sheared)
        if (fields_.shear) sums.rows.set_shear(i, rates_.shear_rate[i]);
      if constexpr (Family::extended)
        sums.rows.set_extra(i, artificial_stress(i, ahead.stress), smoothing_length(i, rho));
    }
  });
}

/// R = -eps (tensile part of the stress): pushes particles apart that tension would clump
/// (Gray, Monaghan & Swift 2001, sec. 4).
SymTensor Solver::artificial_stress(std::size_t i, double ahead) const {
  const double eps = scene_.numerics.artificial_stress;
  if (eps == 0) return {};
  SymTensor stress = predicted_stress(i, ahead);
  stress.xx -= pressure_[i], stress.yy -= pressure_[i], stress.zz -= pressure_[i];
  return -eps * positive_part(stress);
}

/// A thin layer on a wall meets its own images there: twice the neighbours in one plane, and sound.
bool Solver::is_at_wall(std::size_t i) const {
  return std::ranges::any_of(walls_, [&](const tree::Mirror& wall) {
    return std::abs(state_.x[i][wall.axis] - wall.at) < state_.h;
  });
}

/// What falls into the primary meets no surface there and piles up about its centre.
bool Solver::is_inside_primary(std::size_t i) const {
  if (!has_primary(scene_)) return false;
  const Scene::Primary& primary = scene_.environment.primary;
  return norm2(state_.x[i] - Tide(primary).place(state_.time)) <
         primary.radius_m * primary.radius_m;
}

/// Rates of the energy and its parts, from the sums of particle i.
void Solver::set_heating(std::size_t i, double ahead, const sph::NeighbourSums& s) {
  const sph::FluxRows T = momentum_flux(i, ahead);
  double strain_power = 0;
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) strain_power += T[static_cast<std::size_t>(a)][b] * s.G[a][b];
  const double rho = filling_density(predicted_density(i, ahead));
  const double dilation =
      gradient_ == Gradient::corrected_fully
          ? trace(s.G * to_matrix(sph::moderate(to_double(rates_.correction[i]))))
          : trace(s.G);
  rates_.viscous_heating[i] = s.heat / rho;
  rates_.shear_power[i] = (strain_power + pressure_[i] * dilation) / rho;
  rates_.du_dt[i] = (strain_power + s.heat) / rho;
}

/// Whether the neighbours of a particle fill its surroundings with the volumes that they have at
/// rest. A few that have expanded only seem to.
bool Solver::is_surrounded(std::size_t i) const {
  const double h = smoothing_length(i, state_.rho[i]);
  double trace = 0;
  std::visit(
      [&](auto kernel) {
        using Kernel = decltype(kernel);
        lists_.visit_listed(i / tree::bucket_size, i % tree::bucket_size, state_.x,
                            [&](const Vec3& there, std::size_t j) {
                              const double q = norm(there - state_.x[i]) / h;
                              if (q == 0 || q >= 2) return;
                              const double volume = state_.mass / reference_density(j) / cubed(h);
                              trace -= volume * Kernel::normalisation *
                                       Kernel::dw_over_q(q, 1 / q) * q * q;
                            });
      },
      sph::make_kernel(scene_.numerics.kernel));
  return !(trace < sph::full_neighbourhood);
}

/// The first of `count` particles from i on whose neighbourhood has collapsed, or nobody.
std::size_t Solver::first_collapsed(std::size_t i, std::size_t count, const sph::PackedSums& s,
                                    const Pack<double>& rho) const {
  const Pack<double> determinants = determinant(s.C);
  for (std::size_t l = 0; l < count; ++l)
    if (!(determinants[l] > sph::smallest_correctable_determinant) &&
        sph::is_collapsed(sph::lane(s, l).C, rho[l] / reference_density(i + l)) &&
        is_surrounded(i + l) && !is_at_wall(i + l) && !is_inside_primary(i + l))
      return i + l;
  return nobody;
}

void Solver::check_collapse(std::size_t singular) const {
  if (goes_on_)
    check(singular, "singular-matrix",
          "its neighbours have collapsed onto a plane or a line; lower numerics.cfl or raise "
          "numerics.viscosity_alpha");
}

/// Rates of `count` particles from i on; several at once, as everything here is arithmetic.
/// Returns the first whose neighbourhood has collapsed, or nobody.
std::size_t Solver::set_rates(std::size_t i, std::size_t count, double ahead,
                              const sph::PackedSums& s) {
  using P = DoublePack;
  const P rho = gathered(count, [&](std::size_t l) { return predicted_density(i + l, ahead); });
  const SymTensorOf<P> trial = gathered_tensors(count, &state_.S[i]) +
                               splat(ahead) * gathered_tensors(count, &rates_.dS_dt[i]);
  const P factor = gathered(count, [&](std::size_t l) { return double{yield_factor_[i + l]}; });
  const SymTensorOf<P> S = factor * trial;
  SymTensorOf<P> L{P{} + 1, P{} + 1, P{} + 1, P{}, P{}, P{}};
  std::size_t collapsed = nobody;
  if (gradient_ != Gradient::plain) {
    L = sph::correction_matrix(s.C);
    collapsed = first_collapsed(i, count, s, rho);
  }
  const P thin = splat(thinnest_), per_rho = 1 / (rho < thin ? thin : rho);
  scatter_tensors(count, L, &rates_.correction[i]);
  const Mat3Of<P> gradient = s.G * to_matrix(L);
  const P divergence = gradient_ == Gradient::corrected_fully
                           ? trace(s.G * to_matrix(sph::moderate(L)))
                           : trace(s.G);
  scatter_tensors(count, sph::stress_rate(S, gradient, materials_.target().shear_modulus),
                  &rates_.dS_dt[i]);
  scatter(count, P(-rho * divergence),
          [&](std::size_t l, double rate) { rates_.drho_dt[i + l] = rate; });
  if (fields_.shear)
    scatter_tensors(count, sph::deviatoric_strain(gradient), &rates_.shear_rate[i]);
  if (fields_.viscous_pressure)
    scatter(count, s.viscous_pressure, [&](std::size_t l, double p) {
      rates_.viscous_pressure[i + l] = static_cast<float>(p);
    });
  for (int a = 0; a < 3; ++a)
    scatter(count, P(s.force[static_cast<std::size_t>(a)] * per_rho),
            [&](std::size_t l, double rate) { rates_.dv_dt[i + l][a] = rate; });
  return collapsed;
}

/// All neighbour sums in one visit; from them the corrected velocity gradient and the rates of
/// density, stress, velocity and energy.
void Solver::sum_over_neighbours(double ahead) {
  const StageTimer timer(stages_, Stage::pairs);
  std::size_t singular = nobody;
  visit_sums([&](auto& sums) {
    sums.sweep(lists_, state_.size(), [&](std::size_t i, std::size_t count, const auto& s) {
      if constexpr (std::remove_cvref_t<decltype(sums)>::extended)
        if (fields_.energy)
          for (std::size_t l = 0; l < count; ++l) set_heating(i + l, ahead, sph::lane(s, l));
      if (const std::size_t collapsed = set_rates(i, count, ahead, s); collapsed != nobody) {
#pragma omp critical
        singular = std::min(singular, collapsed);
      }
    });
  });
  check_collapse(singular);
}

/// Cracks grow while the stress at the end of the step pulls.
void Solver::grow_damage(double duration) {
  const StageTimer timer(stages_, Stage::material);
  const material::Material& rock = materials_.target();  // what breaks is of one material
  const auto& law = std::get<material::GradyKipp>(rock.fracture);
  const double E = rock.young_modulus(), c_l = rock.longitudinal_speed();
  const double R_s = std::cbrt(3 * state_.mass / (4 * pi * rock.reference_density));
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < state_.size(); ++i) {
    const double intact = 1 - cubed(state_.damage_cbrt[i]);
    if (intact <= 0) continue;
    const double tension = largest_principal(state_.S[i]) - pressure_[i];
    if (tension <= 0) continue;
    state_.damage_cbrt[i] = law.grown(state_.damage_cbrt[i], tension / (intact * E),
                                      flaws_[state_.id[i]], c_l, R_s, duration);
  }
}

}  // namespace eerie::step
