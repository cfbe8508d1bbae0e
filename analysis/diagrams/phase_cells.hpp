#pragma once

#include "analysis/diagrams/map_quantity.hpp"
#include "analysis/diagrams/phase_diagram.hpp"
#include "analysis/diagrams/phase_words.hpp"
#include "analysis/drawing/canvas.hpp"
#include "analysis/statistics/map_axis.hpp"

namespace eerie::diagrams {

/// The marks that cells and legend share.
namespace map_mark {
inline constexpr drawing::Colour ink{0x1a, 0x1a, 0x1a};
inline constexpr drawing::Colour grey{0x9a, 0x9a, 0x9a};
inline constexpr drawing::Colour pale{0xf2, 0xf2, 0xf2};
inline constexpr drawing::Colour failure{0xb0, 0x1e, 0x3c};
inline constexpr drawing::Colour eer{0x14, 0x4f, 0xa8};
inline constexpr drawing::Colour border{0xc6, 0x4a, 0x1e};

void missing(drawing::Canvas& canvas, const drawing::Area& area);
void pending(drawing::Canvas& canvas, const drawing::Area& area);
void failed(drawing::Canvas& canvas, const drawing::Area& area);
/// Draws hatches over the colour of the value.
void unsettled(drawing::Canvas& canvas, const drawing::Area& area, drawing::Colour fill,
               double distance = 4);
/// Draws rules over the colour of the value.
void stale(drawing::Canvas& canvas, const drawing::Area& area, drawing::Colour fill,
           double distance = 4);
/// Draws a blue corner: some remnant other than the largest is an EER.
void smaller_eer(drawing::Canvas& canvas, const drawing::Area& area);
/// Where that corner lies.
drawing::Area corner_of(const drawing::Area& area);
/// Draws a heavy frame.
void in_doubt(drawing::Canvas& canvas, const drawing::Area& area);
/// The word for fidelity and number of runs: "v4" means four surveys; k is sketch, s standard, f
/// fine, p paper.
std::string basis(const PhaseCell& cell);
}  // namespace map_mark

/// The frame of a panel on the page, and the map from data to page.
struct PanelFrame {
  double v_low = 0, v_high = 1, theta_low = 0, theta_high = 1;  ///< cm/s and deg at its borders
  drawing::Area area;

  double x(double v) const { return area.low.x + area.width() * (v - v_low) / (v_high - v_low); }
  double y(double theta) const {
    return area.low.y + area.height() * (theta - theta_low) / (theta_high - theta_low);
  }
};

/// The cells of a diagram by its speeds and angles.
struct CellGrid {
  statistics::MapAxis v, theta;

  explicit CellGrid(const PhaseDiagram& diagram);
  drawing::Area area(const PanelFrame& frame, std::size_t i, std::size_t j) const;
  /// Indexed by i + j * v.at.size(); nullptr where there is no impact.
  std::vector<const PhaseCell*> cells;
};

/// Draws fills, marks and words of all cells. It leaves out words that do not fit into their cell.
void draw_cells(drawing::Canvas& canvas, const CellGrid& grid, const PanelFrame& frame,
                const MapScale& scale, const CellWords& words = {});

}  // namespace eerie::diagrams
