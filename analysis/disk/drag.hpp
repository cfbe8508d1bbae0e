#pragma once

#include <string>

#include "analysis/disk/nebula.hpp"

namespace eerie::disk {

/// A sphere in the gas.
struct Body {
  double radius = 100;    ///< m
  double density = 2700;  ///< kg/m^3
};

/// The laws of gas drag, by the size of the body over the mean free path and by the Reynolds
/// number. Between 1.6 and 19 AU the paper names Stokes' law, but its formula has the slope of
/// `intermediate`.
enum class DragRegime { epstein, stokes, intermediate, newton };
std::string name(DragRegime regime);

/// The drag on a body.
struct Drag {
  double stopping_time = 0;  ///< momentum over drag force, s
  DragRegime regime = DragRegime::epstein;
};

/// The drag coefficient of a sphere of radius s in a fluid, force / (pi s^2 rho v^2 / 2). It is the
/// largest of 24/Re, 24 Re^-0.6 and 0.44 (Weidenschilling 1977, MNRAS 180, 57). He joins the last
/// two at Re = 800, where they differ by 1%; they cross at 784. The Reynolds number is 2 s v / nu
/// and above 0.
double drag_coefficient(double reynolds);
DragRegime fluid_regime(double reynolds);

/// The drag of Weidenschilling (1977) on a body in the head wind of the nebula. The stopping time
/// is the longer of Epstein's, rho_s s / (rho v_thermal), and that of a sphere in a fluid, 8 rho_s
/// s / (3 C_D rho v). For slow flows Epstein's law holds below s = 9/4 of the mean free path. The
/// viscosity is half the mean free path times the mean thermal speed.
Drag weidenschilling_drag(const Nebula& nebula, const Body& body);

/// Eq. (6) of Sugiura et al. (2019), as printed, for bodies of 100 m in Hayashi's nebula. Its
/// pieces do not quite meet: outwards it steps by -1% at 1.6 AU and by +6% at 19 AU.
Drag published_drag(const Nebula& nebula);

enum class DragLaw { published, weidenschilling };
std::string name(DragLaw law);
/// The law of this name. Throws InputError for another name.
DragLaw drag_law(const std::string& name);

/// The drag by this law. Throws InputError where `law` is the published one and the body is not its
/// own.
Drag drag_of(DragLaw law, const Nebula& nebula, const Body& body);

/// The one body that the published law knows.
inline constexpr Body published_body;
bool has_published_drag(const Body& body);

}  // namespace eerie::disk
