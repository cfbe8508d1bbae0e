#pragma once

#include <string>

#include "analysis/disk/nebula.hpp"

namespace eerie::disk {

/// A sphere that feels the gas.
struct Body {
  double radius = 100;    ///< m
  double density = 2700;  ///< kg/m^3
};

/// Laws of gas drag, by the size of the body over the mean free path and by the Reynolds number.
/// What the paper calls Stokes' law between 1.6 and 19 AU has the slope of `intermediate`.
enum class DragRegime { epstein, stokes, intermediate, newton };
std::string name(DragRegime regime);

/// How fast a body loses its speed against the gas.
struct Drag {
  double stopping_time = 0;  ///< momentum over drag force, s
  DragRegime regime = DragRegime::epstein;
};

/// Drag coefficient of a sphere in a fluid: force / (pi s^2 rho v^2 / 2), s its radius;
/// Weidenschilling (1977), MNRAS 180, 57: 24/Re, 24 Re^-0.6 and 0.44, whichever is largest. He has
/// the last two meet at Re = 800, where they differ by 1%; they cross at 784. Reynolds number
/// 2 s v / nu, above 0.
double drag_coefficient(double reynolds);
DragRegime fluid_regime(double reynolds);

/// Of a body in the head wind of the nebula, Weidenschilling (1977): Epstein's law,
/// rho_s s / (rho v_thermal), or that of a sphere in a fluid, 8 rho_s s / (3 C_D rho v), whichever
/// takes longer. For slow flows that is Epstein's below s = 9/4 of the mean free path. Viscosity:
/// mean free path times mean thermal speed over two.
Drag weidenschilling_drag(const Nebula& nebula, const Body& body);

/// Sugiura et al. (2019), Eq. (6), as printed: bodies of 100 m in Hayashi's nebula. The pieces do
/// not quite meet: outwards it steps by -1% at 1.6 AU and by +6% at 19 AU.
Drag published_drag(const Nebula& nebula);

enum class DragLaw { published, weidenschilling };
std::string name(DragLaw law);
/// Throws InputError for another name.
DragLaw drag_law(const std::string& name);

/// Throws InputError where the published law is asked about another body than its own.
Drag drag_of(DragLaw law, const Nebula& nebula, const Body& body);

/// The published law is about this body alone.
inline constexpr Body published_body;
bool has_published_drag(const Body& body);

}  // namespace eerie::disk
