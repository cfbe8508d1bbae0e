#pragma once

#include <algorithm>
#include <cmath>

#include "solver/base/tensor.hpp"

namespace eerie::sph {

/// Below this determinant of C the neighbours of a particle lie in a plane or on a line, or there
/// are none. No linear correction is possible then, and the identity replaces it.
inline constexpr double smallest_correctable_determinant = 0.01;

/// Below this trace of C, with volumes at the reference density, a particle belongs to a pair, a
/// chain or a loose sheet, and rightly has no correction. In impacts such particles reach 0.5 at
/// 1,000 particles per target and 0.9 at 50,000. Inside a body the trace is 3.
inline constexpr double full_neighbourhood = 1.8;

/// Whether C belongs to a full neighbourhood that lies in one plane or on one line. No sound
/// arrangement does; it means a collapse. `filling` is the density over the reference density.
/// Loose particles have large volumes, so that a few of them make a large C. A dense particle among
/// a few loose ones still looks full here, so callers must look at the volumes of its neighbours.
inline bool is_collapsed(const SymTensor& C, double filling = 1) {
  return !(determinant(C) > smallest_correctable_determinant) &&
         !(trace(C) * std::min(filling, 1.0) < full_neighbourhood);
}

inline constexpr double largest_moderate_norm = 6;

/// The correction L = C^-1, which makes the SPH gradient exact for linear fields (Bonet & Lok
/// 1999).
template <class T>
SymTensorOf<T> correction_matrix(const SymTensorOf<T>& C) {
  const T det = determinant(C), none = T{}, one = none + 1;
  const auto correctable = det > smallest_correctable_determinant;
  const SymTensorOf<T> L = inverse(C, T(correctable ? det : one));
  return {correctable ? L.xx : one,  correctable ? L.yy : one,  correctable ? L.zz : one,
          correctable ? L.xy : none, correctable ? L.xz : none, correctable ? L.yz : none};
}

/// The correction of density and pressure: L, but the identity where L is large. There a particle
/// has so few neighbours in some direction that L would magnify their noise. L is 2 on a flat
/// surface (norm 3.5) and 4 along an edge (norm 6.9).
template <class T>
SymTensorOf<T> moderate(const SymTensorOf<T>& L) {
  const T none = T{}, one = none + 1;
  const auto small = contract(L) < largest_moderate_norm * largest_moderate_norm;
  return {small ? L.xx : one,  small ? L.yy : one,  small ? L.zz : one,
          small ? L.xy : none, small ? L.xz : none, small ? L.yz : none};
}

/// Whether a particle hangs on too few neighbours for its gradient: no correction is possible, or
/// it is large. Stress there would turn bodies, as a force conserves angular momentum only where
/// the gradient that it is dual to is exact.
inline bool is_frayed(const SymTensorf& L) {
  const bool is_uncorrected = L == SymTensorf{1, 1, 1, 0, 0, 0};
  return is_uncorrected || contract(to_double(L)) >= largest_moderate_norm * largest_moderate_norm;
}

/// The traceless symmetric part of a velocity gradient, that is, its shear rate.
template <class T>
SymTensorOf<T> deviatoric_strain(const Mat3Of<T>& g) {
  const T third = trace(g) / 3;
  return {g[0][0] - third,         g[1][1] - third,         g[2][2] - third,
          (g[0][1] + g[1][0]) / 2, (g[0][2] + g[2][0]) / 2, (g[1][2] + g[2][1]) / 2};
}

/// Hooke's law with the Jaumann rate (Libersky & Petschek 1991, eq. 2):
/// dS/dt = 2 G (e - tr(e)/3 1) + R S - S R, with strain rate e and spin R of the velocity
/// gradient g[a][b] = dv_a/dx_b.
template <class T>
SymTensorOf<T> stress_rate(const SymTensorOf<T>& S, const Mat3Of<T>& g, double shear_modulus) {
  const T third = trace(g) / 3;
  const double twoG = 2 * shear_modulus;
  // Spin components R_ab = (g_ab - g_ba) / 2.
  const T rxy = (g[0][1] - g[1][0]) / 2, rxz = (g[0][2] - g[2][0]) / 2,
          ryz = (g[1][2] - g[2][1]) / 2;
  return {twoG * (g[0][0] - third) + 2 * (rxy * S.xy + rxz * S.xz),
          twoG * (g[1][1] - third) + 2 * (ryz * S.yz - rxy * S.xy),
          twoG * (g[2][2] - third) - 2 * (rxz * S.xz + ryz * S.yz),
          twoG * (g[0][1] + g[1][0]) / 2 + rxy * (S.yy - S.xx) + rxz * S.yz + ryz * S.xz,
          twoG * (g[0][2] + g[2][0]) / 2 + rxz * (S.zz - S.xx) + rxy * S.yz - ryz * S.xy,
          twoG * (g[1][2] + g[2][1]) / 2 + ryz * (S.zz - S.yy) - rxy * S.xz - rxz * S.xy};
}

}  // namespace eerie::sph
