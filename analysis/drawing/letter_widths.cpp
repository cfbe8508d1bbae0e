#include "analysis/drawing/letter_widths.hpp"

#include <array>

#include "solver/base/utf8.hpp"

namespace eerie::drawing {

namespace {

/// The advance widths of the letters from space to tilde in DejaVu Sans 2.37, in 1/1000 em.
constexpr std::array<int, 95> regular = {
    318, 401, 460, 838, 636, 950, 780, 275, 390, 390, 500, 838, 318, 361,  318, 337, 636, 636, 636,
    636, 636, 636, 636, 636, 636, 636, 337, 337, 838, 838, 838, 531, 1000, 684, 686, 698, 770, 632,
    575, 775, 752, 295, 295, 656, 557, 863, 748, 787, 603, 787, 695, 635,  611, 732, 684, 989, 685,
    611, 685, 390, 337, 390, 838, 500, 500, 613, 635, 550, 635, 615, 352,  635, 634, 278, 278, 579,
    278, 974, 634, 612, 635, 635, 411, 521, 392, 634, 592, 818, 592, 592,  525, 636, 337, 636, 838};
constexpr std::array<int, 95> heavy = {
    348,  456, 521, 838, 696, 1002, 872, 306,  457, 457, 523, 838, 380, 415,  380, 365,
    696,  696, 696, 696, 696, 696,  696, 696,  696, 696, 400, 400, 838, 838,  838, 580,
    1000, 774, 762, 734, 830, 683,  683, 821,  837, 372, 372, 775, 637, 995,  837, 850,
    733,  850, 770, 720, 682, 812,  774, 1103, 771, 724, 725, 457, 365, 457,  838, 500,
    500,  675, 716, 593, 716, 678,  435, 716,  712, 343, 343, 665, 343, 1042, 712, 687,
    716,  716, 493, 595, 478, 712,  652, 924,  645, 652, 582, 712, 365, 712,  838};
constexpr double greek = 0.66, small_type = 0.8;

double width_of(char32_t code, bool bold) {
  constexpr char32_t no_width = 0x200b, no_break = 0xa0, ellipsis = 0x2026;
  if (code == no_width) return 0;
  if (code == no_break) code = ' ';
  if (code == ellipsis) return 1;
  if (code < ' ' || code > '~') return greek;
  return (bold ? heavy : regular)[code - ' '] / 1000.0;
}

}  // namespace

double width_in_em(std::string_view text, bool bold) {
  double width = 0, scale = 1;
  bool escaped = false, one_letter = false;
  for (std::size_t at = 0; at < text.size();) {
    const Letter letter = letter_at(text, at);
    at += letter.bytes.size();
    if (!escaped && letter.code == '\\') {
      escaped = true;
      continue;
    }
    if (!escaped && (letter.code == '_' || letter.code == '^')) {
      scale = small_type, one_letter = at >= text.size() || text[at] != '{';
      continue;
    }
    if (!escaped && letter.code == '{') continue;
    if (!escaped && letter.code == '}') {
      scale = 1;
      continue;
    }
    escaped = false;
    width += scale * width_of(letter.code, bold);
    if (one_letter) scale = 1, one_letter = false;
  }
  return width;
}

}  // namespace eerie::drawing
