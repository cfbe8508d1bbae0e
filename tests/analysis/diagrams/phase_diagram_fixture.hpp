#pragma once

#include "analysis/diagrams/phase_diagram.hpp"

namespace eerie::test {

/// A map with every kind of cell on an irregular grid; one place of the grid has none, and one
/// result is without shape.
inline diagrams::PhaseDiagram small_map() {
  diagrams::PhaseDiagram map;
  map.particles_per_target = 1000;
  map.v_esc_cm_per_s = 6.14;
  map.threshold_cm_per_s = 5.1;
  const auto done = diagrams::CellState::done;
  map.cells = {{15, 10, done, 0.91, "perfect-merging", false},
               {18, 10, done, 0.47, "graze-and-merge", false},
               {22, 10, done, 0.24, "perfect-merging", false},
               {15, 15, diagrams::CellState::unsettled, 0.63, "perfect-merging", false},
               {18, 15, diagrams::CellState::failed, 0, "", false},
               {22, 15, diagrams::CellState::pending, 0, "", false},
               {15, 20, done, 0.82, "hit-and-run", true},
               {18, 20, done, std::nullopt, "catastrophic-disruption", false}};
  map.cells[0].stale = true;
  map.cells[1].class_share = 0.75;
  return map;
}

}  // namespace eerie::test
