#include "analysis/statistics/isolines.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

namespace eerie::statistics {

namespace {

using Point = std::array<double, 2>;
using Piece = std::pair<Point, Point>;

struct Corner {
  double x, y, height;  ///< height above the level
  bool above() const { return height > 0; }
};

/// The same from either side, to the last bit, so that pieces of two cells meet.
Point crossing(const Corner& a, const Corner& b) {
  if (b.above()) return crossing(b, a);
  const double part = a.height / (a.height - b.height);
  return {a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)};
}

/// Edge k joins the corners k and k + 1, counted round the cell.
void add_cell(const std::array<Corner, 4>& corners, std::vector<Piece>& pieces) {
  std::vector<Point> crossed;
  for (std::size_t k = 0; k < 4; ++k) {
    const Corner &a = corners[k], &b = corners[(k + 1) % 4];
    if (a.above() != b.above()) crossed.push_back(crossing(a, b));
  }
  if (crossed.size() == 2) pieces.push_back({crossed[0], crossed[1]});
  if (crossed.size() < 4) return;
  double middle = 0;
  for (const Corner& c : corners) middle += c.height / 4;
  // A corner that the middle is not like is cut off alone: corner 1 or, if the first, corner 0.
  const bool like_first = (middle > 0) == corners[0].above();
  pieces.push_back({crossed[0], crossed[like_first ? 1 : 3]});
  pieces.push_back({crossed[2], crossed[like_first ? 3 : 1]});
}

/// Hangs pieces together at the ends that they share.
class Chain {
 public:
  explicit Chain(std::vector<Piece> pieces) : pieces_(std::move(pieces)), used_(pieces_.size()) {
    for (std::size_t k = 0; k < pieces_.size(); ++k)
      for (const Point& end : {pieces_[k].first, pieces_[k].second}) at_[end].push_back(k);
  }
  std::vector<Isoline> lines() {
    std::vector<Isoline> lines;
    for (std::size_t k = 0; k < pieces_.size(); ++k) {
      if (used_[k]) continue;
      used_[k] = true;
      Isoline line = {pieces_[k].first, pieces_[k].second};
      go_on(line);
      std::ranges::reverse(line);
      go_on(line);
      lines.push_back(std::move(line));
    }
    return lines;
  }

 private:
  void go_on(Isoline& line) {
    while (const auto next = unused_at(line.back())) {
      used_[*next] = true;
      const auto& [from, to] = pieces_[*next];
      line.push_back(from == line.back() ? to : from);
    }
  }
  std::optional<std::size_t> unused_at(const Point& end) const {
    for (const std::size_t k : at_.at(end))
      if (!used_[k]) return k;
    return std::nullopt;
  }
  std::vector<Piece> pieces_;
  std::vector<bool> used_;
  std::map<Point, std::vector<std::size_t>> at_;
};

}  // namespace

std::vector<Isoline> isolines(const std::vector<double>& x, const std::vector<double>& y,
                              const std::vector<double>& values, double level) {
  if (values.size() != x.size() * y.size())
    throw std::invalid_argument("isolines: one value at each x and y");
  std::vector<Piece> pieces;
  const auto corner = [&](std::size_t i, std::size_t j) {
    return Corner{x[i], y[j], values[j * x.size() + i] - level};
  };
  for (std::size_t j = 0; j + 1 < y.size(); ++j)
    for (std::size_t i = 0; i + 1 < x.size(); ++i)
      add_cell({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)}, pieces);
  return Chain(std::move(pieces)).lines();
}

}  // namespace eerie::statistics
