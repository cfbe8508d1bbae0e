#pragma once

#include <vector>

#include "analysis/canvas.hpp"
#include "analysis/phase_diagram.hpp"

namespace eerie {

/// Marks that cells and legend share.
namespace map_mark {
inline constexpr Colour ink{0x1a, 0x1a, 0x1a};
inline constexpr Colour grey{0x9a, 0x9a, 0x9a};
inline constexpr Colour pale{0xf2, 0xf2, 0xf2};
inline constexpr Colour umber{0x70, 0x66, 0x5c};
inline constexpr Colour failure{0xb0, 0x1e, 0x3c};
inline constexpr Colour eer{0x14, 0x4f, 0xa8};
inline constexpr double letter_size = 5.5;

void pending(Canvas& canvas, const Area& area);
void failed(Canvas& canvas, const Area& area);
/// Hatched over the colour of its value.
void unsettled(Canvas& canvas, const Area& area);
/// A blue corner: the largest remnant is no EER, but a smaller one is.
void smaller_eer(Canvas& canvas, const Area& area);
/// A heavy frame.
void in_doubt(Canvas& canvas, const Area& area);
/// "v4": four runs; k: sketch, v: survey, p: paper.
std::string basis(const PhaseCell& cell);
}  // namespace map_mark

/// Explains the marks that occur in a map, in rows under it.
class PhaseLegend {
 public:
  explicit PhaseLegend(const PhaseDiagram& diagram, double width_pt);
  double height_pt() const;
  void draw(Canvas& canvas, Point upper_left) const;

 private:
  enum class Mark { letter, curve, blue, corner, pending, failed, unsettled, doubt };
  struct Entry {
    Mark mark;
    std::string letter, words;
    double x = 0;
    int row = 0;
  };
  std::vector<Entry> entries_;
};

}  // namespace eerie
