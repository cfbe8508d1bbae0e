#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace eerie {

/// A named way to solve the equations: defaults for fields of scene.numerics. A scene may still
/// set any of them otherwise.
struct Scheme {
  const char* token;
  const char* numerics;   ///< JSON, merged under what the scene says
  const char* base = "";  ///< token of the scheme whose numerics are merged under these
};

inline constexpr Scheme schemes[] = {
    // Correction of the gradient in stress rate and its dual force.
    {"dual", "{}"},
    // Besides, density follows the corrected divergence and viscosity leaves shear alone, so that
    // flowing rubble is not driven apart (docs/notebook/convergence.md).
    {"shear-free", R"({"gradient": "corrected-fully", "viscosity": "shear-free",
                      "integrator": "leapfrog-pece", "cfl": 0.8})"},
    // Faithful density, and the artificial viscosity that the paper has with 50,000 particles per
    // target and h of one spacing, at any particle number: its alpha h and beta h^2.
    {"viscosity-50000",
     R"({"gradient": "corrected-fully", "viscosity_particles": 50000, "viscosity_alpha": 0.8333,
         "viscosity_beta": 1.3889, "integrator": "leapfrog-pece", "cfl": 0.8})"},
    // The same, and surfaces that meet do not press before they touch.
    {"closing-voids", R"({"void_density": 0.95})", "viscosity-50000"},
    // The same, but a free surface is no void; and the cheaper integrator.
    {"closing-gaps", R"({"voids": "gaps", "integrator": "staggered", "cfl": 1.1})",
     "closing-voids"},
    // Sugiura, Kobayashi & Inutsuka (2019) after Libersky & Petschek (1991) and Sugiura et al.
    // (2018): h of one spacing, the correction in the stress rate alone, Monaghan's viscosity.
    {"libersky-petschek-2018",
     R"({"gradient": "corrected-rate", "h_over_spacing": 1.0, "viscosity": "monaghan",
         "viscosity_alpha": 1, "viscosity_beta": 2})"},
};

/// That of scenes that name none, as the schema says.
std::string default_scheme();

/// `document`, a valid scene as given, with the defaults of its scheme for the fields of numerics
/// that it leaves out.
nlohmann::json with_scheme(nlohmann::json document);

}  // namespace eerie
