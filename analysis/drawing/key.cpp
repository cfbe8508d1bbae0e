#include "analysis/drawing/key.hpp"

namespace eerie::drawing {

namespace {
constexpr double sample = 15, between = 3, gap = 10;
constexpr Colour ink{0x22, 0x22, 0x22};

/// Words without a sample are a note.
double room_for_sample(const KeyEntry& entry) {
  const bool note = entry.line.empty() && entry.point.empty() && !entry.fill;
  return note ? 0 : sample + between;
}
}  // namespace

Key::Key(std::vector<KeyEntry> entries, double width_pt) : entries_(std::move(entries)) {
  Place next;
  for (const KeyEntry& entry : entries_) {
    const double width = room_for_sample(entry) + text_width(entry.words, size);
    if (next.x > 0 && next.x + width > width_pt) next = {0, next.row + 1};
    places_.push_back(next);
    next.x += width + gap;
    rows_ = next.row + 1;
  }
}

void Key::draw(Canvas& canvas, Point upper_left) const {
  for (std::size_t k = 0; k < entries_.size(); ++k) {
    const KeyEntry& entry = entries_[k];
    const Point left{upper_left.x + places_[k].x,
                     upper_left.y - row_height * (places_[k].row + 0.5)};
    if (entry.fill) canvas.fill({{left.x, left.y - 3}, {left.x + sample, left.y + 3}}, *entry.fill);
    if (!entry.line.empty()) canvas.styled_line(left, {left.x + sample, left.y}, entry.line);
    if (!entry.point.empty()) canvas.mark({left.x + sample / 2, left.y}, entry.point);
    canvas.text({left.x + room_for_sample(entry), left.y}, entry.words,
                {.size = size, .colour = ink, .align = Align::left});
  }
}

}  // namespace eerie::drawing
