#pragma once

#include "analysis/drawing/script.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::drawing {

/// An impact and its settings for the title of a figure: "q = 1, phi_d = 40 deg, 20 cm/s, 15 deg;
/// 1,000 particles per target, closing-gaps, seed 1", with the symbols of the field. What of
/// bodies, matter and surroundings is not the default follows: "; material.tillotson.A_Pa=267000".
Quoted impact_words(const Scene& scene);

}  // namespace eerie::drawing
