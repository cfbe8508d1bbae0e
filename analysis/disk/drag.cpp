#include "analysis/disk/drag.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/base/error.hpp"

namespace eerie::disk {

namespace {

constexpr double newton_coefficient = 0.44;

/// One piece of Eq. (6): stopping time times Keplerian frequency = at_1_au (r / AU)^slope.
struct PublishedPiece {
  double from_au, at_1_au, slope;
  DragRegime regime;
};
constexpr PublishedPiece published_pieces[] = {{19, 2.2e1, 1.5, DragRegime::epstein},
                                               {1.6, 3.6e3, -0.25, DragRegime::stokes},
                                               {0, 1.8e3, 1.25, DragRegime::newton}};

}  // namespace

std::string name(DragRegime regime) {
  constexpr const char* names[] = {"Epstein", "Stokes", "intermediate", "Newton"};
  return names[static_cast<int>(regime)];
}

std::string name(DragLaw law) {
  return law == DragLaw::published ? "published" : "weidenschilling";
}

DragLaw drag_law(const std::string& word) {
  for (const DragLaw law : {DragLaw::published, DragLaw::weidenschilling})
    if (word == name(law)) return law;
  throw InputError(fmt::format("drag = {}: must be published or weidenschilling", word));
}

double drag_coefficient(double reynolds) {
  return std::max({24 / reynolds, 24 * std::pow(reynolds, -0.6), newton_coefficient});
}

DragRegime fluid_regime(double reynolds) {
  if (reynolds < 1) return DragRegime::stokes;
  return drag_coefficient(reynolds) > newton_coefficient ? DragRegime::intermediate
                                                         : DragRegime::newton;
}

Drag weidenschilling_drag(const Nebula& n, const Body& body) {
  const double viscosity = n.mean_free_path * n.thermal_speed / 2;
  const double reynolds = 2 * body.radius * n.head_wind / viscosity;
  const double column = body.density * body.radius / n.gas_density;
  const double epstein = column / n.thermal_speed;
  const double fluid = 8 * column / (3 * drag_coefficient(reynolds) * n.head_wind);
  return epstein > fluid ? Drag{epstein, DragRegime::epstein} : Drag{fluid, fluid_regime(reynolds)};
}

Drag published_drag(const Nebula& n) {
  const double au = n.r / astronomical_unit;
  const auto* piece = std::ranges::find_if(
      published_pieces, [au](const PublishedPiece& p) { return au >= p.from_au; });
  return {piece->at_1_au * std::pow(au, piece->slope) / n.omega_k, piece->regime};
}

bool has_published_drag(const Body& body) {
  return body.radius == published_body.radius && body.density == published_body.density;
}

Drag drag_of(DragLaw law, const Nebula& nebula, const Body& body) {
  if (law == DragLaw::weidenschilling) return weidenschilling_drag(nebula, body);
  if (!has_published_drag(body))
    throw InputError(
        fmt::format("drag = published: Eq. (6) of Sugiura et al. (2019) is about bodies of {:g} m "
                    "and {:g} kg/m^3, not {:g} m and {:g} kg/m^3; give drag = weidenschilling",
                    published_body.radius, published_body.density, body.radius, body.density));
  return published_drag(nebula);
}

}  // namespace eerie::disk
