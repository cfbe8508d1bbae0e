#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace eerie {

/// A named way to solve the equations: it gives defaults for fields of scene.numerics. A scene may
/// still set each of these fields.
struct Scheme {
  const char* token;
  const char* numerics;   ///< JSON; what the scene says has precedence
  const char* base = "";  ///< an earlier scheme from which it takes all other defaults
};

inline constexpr Scheme schemes[] = {
    // The next four are former schemes, from which the default has grown. They are still read.
    // Corrects the gradient in the stress rate and in its dual, the force.
    {"dual", "{}"},
    // In addition density follows the corrected divergence and viscosity ignores shear. So flowing
    // rubble is not driven apart (docs/notebook/convergence.md).
    {"shear-free", R"({"gradient": "corrected-fully", "viscosity": "shear-free",
                      "integrator": "leapfrog-pece", "cfl": 0.8})"},
    // The faithful scheme, with the artificial viscosity of the paper at any particle number: its
    // alpha h and beta h^2 for 50,000 particles per target and h of one spacing.
    {"viscosity-50000",
     R"({"gradient": "corrected-fully", "viscosity_particles": 50000, "viscosity_alpha": 0.8333,
         "viscosity_beta": 1.3889, "integrator": "leapfrog-pece", "cfl": 0.8})"},
    // The scheme above; in addition surfaces that meet do not press before they touch.
    {"closing-voids", R"({"void_density": 0.95})", "viscosity-50000"},
    // The default: the scheme above, but a free surface is no void, and steps are cheaper.
    {"closing-gaps", R"({"voids": "gaps", "integrator": "staggered", "cfl": 1.1,
                         "flow_mach": 0.1, "gravity_tolerance": 2e-4})",
     "closing-voids"},
    // The scheme of Sugiura, Kobayashi & Inutsuka (2019), after Libersky & Petschek (1991) and
    // Sugiura et al. (2018): h of one spacing, correction in the stress rate alone, Monaghan's
    // viscosity.
    {"libersky-petschek-2018",
     R"({"gradient": "corrected-rate", "h_over_spacing": 1.0, "viscosity": "monaghan",
         "viscosity_alpha": 1, "viscosity_beta": 2})"},
};

/// The scheme of scenes that name none, as in the schema.
std::string default_scheme();

/// The defaults that the scheme of this name, which there is, gives to fields of scene.numerics.
const nlohmann::json& numerics_of_scheme(const std::string& token);

/// Fills in the fields of numerics that `document`, a valid scene, leaves out. Their values are the
/// defaults of its scheme.
nlohmann::json with_scheme(nlohmann::json document);

}  // namespace eerie
