#pragma once

#include "analysis/diagrams/map_quantity.hpp"
#include "analysis/diagrams/phase_diagram.hpp"
#include "analysis/drawing/canvas.hpp"
#include "analysis/statistics/map_axis.hpp"

namespace eerie::diagrams {

/// Marks that cells and legend share.
namespace map_mark {
inline constexpr drawing::Colour ink{0x1a, 0x1a, 0x1a};
inline constexpr drawing::Colour grey{0x9a, 0x9a, 0x9a};
inline constexpr drawing::Colour pale{0xf2, 0xf2, 0xf2};
inline constexpr drawing::Colour failure{0xb0, 0x1e, 0x3c};
inline constexpr drawing::Colour eer{0x14, 0x4f, 0xa8};
inline constexpr double letter_size = 5.5;

void missing(drawing::Canvas& canvas, const drawing::Area& area);
void pending(drawing::Canvas& canvas, const drawing::Area& area);
void failed(drawing::Canvas& canvas, const drawing::Area& area);
/// Hatched over the colour of its value.
void unsettled(drawing::Canvas& canvas, const drawing::Area& area, drawing::Colour fill,
               double distance = 4);
/// Ruled over the colour of its value.
void stale(drawing::Canvas& canvas, const drawing::Area& area, drawing::Colour fill,
           double distance = 4);
/// A blue corner: some remnant but the largest is an EER.
void smaller_eer(drawing::Canvas& canvas, const drawing::Area& area);
/// A heavy frame.
void in_doubt(drawing::Canvas& canvas, const drawing::Area& area);
/// "v4": four runs; k: sketch, v: survey, p: paper.
std::string basis(const PhaseCell& cell);
}  // namespace map_mark

/// A panel's frame on the page and the way from data to page.
struct PanelFrame {
  double v_low = 0, v_high = 1, theta_low = 0, theta_high = 1;  ///< cm/s and deg at its borders
  drawing::Area area;

  double x(double v) const { return area.low.x + area.width() * (v - v_low) / (v_high - v_low); }
  double y(double theta) const {
    return area.low.y + area.height() * (theta - theta_low) / (theta_high - theta_low);
  }
};

/// The places of a diagram's cells: its own speeds by its own angles.
struct CellGrid {
  statistics::MapAxis v, theta;

  explicit CellGrid(const PhaseDiagram& diagram);
  drawing::Area area(const PanelFrame& frame, std::size_t i, std::size_t j) const;
  /// By i + j * v.at.size(); nullptr: no impact there.
  std::vector<const PhaseCell*> cells;
};

/// Fills, marks and words of all places. Words that a place has no room for are left out.
void draw_cells(drawing::Canvas& canvas, const CellGrid& grid, const PanelFrame& frame,
                const MapScale& scale);

}  // namespace eerie::diagrams
