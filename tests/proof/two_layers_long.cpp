#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/proof/record.hpp"
#include "tests/proof/two_layers.hpp"

namespace eerie::proof {
namespace {

TEST(TwoLayersLong, BehaveAsTheoryMoreAndMoreAsParticlesBecomeSmaller) {
  Record record("validation", 43, "Two densities",
                "Layers of 800 and 2,700 kg/m^3 (`impactor.material`), of particles of one mass. "
                "The lowest standing wave of an elastic bar, half of each, against theory "
                "(`tests/proof/two_layers.hpp`); and a light liquid on a dense one, against the "
                "weight above.");
  double coarser_wave = 0, coarser_light = 0;
  for (const int across : {12, 24, 48}) {
    const double wave = layered_wave_ratio(across);
    const LayeredLiquid liquid = layered_liquid(across);
    const double spacing = 1.0 / across;
    record.within(fmt::format("frequency over theory, {} across", across), wave, 1 - 0.1 * spacing,
                  1 + 0.1 * spacing, "the border is known to a tenth of a particle");
    record.within(fmt::format("pressure of the light liquid over its weight, {} across", across),
                  liquid.light, 1 - 0.5 * spacing, 1 + 0.5 * spacing,
                  "the surface is known to a third of the light spacing");
    record.within(fmt::format("pressure of the dense liquid over the weight, {} across", across),
                  liquid.dense, 1 - 0.1 * spacing, 1 + 0.1 * spacing, "as the border of the wave");
    record.within(fmt::format("particles that press nothing, {} across", across), liquid.voids, 0,
                  0.5 * spacing, "those of the surface; none at the border");
    if (coarser_wave != 0) {
      record.within(fmt::format("error of the wave over that of half of the particles, {}", across),
                    (1 - wave) / (1 - coarser_wave), -0.6, 0.6, "it falls by half or faster");
      record.within(fmt::format("error of the light liquid, the same, {}", across),
                    (1 - liquid.light) / (1 - coarser_light), -0.6, 0.6, "of first order, as said");
    }
    coarser_wave = wave, coarser_light = liquid.light;
  }
}

}  // namespace
}  // namespace eerie::proof
