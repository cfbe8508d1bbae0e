#include "analysis/disk/contours.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace eerie::disk {

namespace {

constexpr int per_decade = 50;
/// Relative distance of the pair at a step.
constexpr double step_width = 1e-9;

template <class ValueAt>
Contours contours(DragLaw law, const Body& body, const std::vector<double>& r,
                  const ValueAt& value_at) {
  Contours c{law, r, {}, std::vector<std::vector<double>>(contour_speeds.size())};
  for (const double distance : r) {
    const Nebula nebula = hayashi_nebula(distance);
    c.drag.push_back(drag_of(law, nebula, body));
    for (std::size_t s = 0; s < contour_speeds.size(); ++s)
      c.y[s].push_back(value_at(nebula, c.drag.back(), contour_speeds[s]));
  }
  return c;
}

}  // namespace

const std::vector<double>& Contours::of(double speed) const {
  for (std::size_t s = 0; s < contour_speeds.size(); ++s)
    if (contour_speeds[s] == speed) return y.at(s);
  throw std::out_of_range(fmt::format("there is no contour at {} m/s", speed));
}

std::vector<double> contour_distances(double low, double high) {
  const double decades = std::log10(high / low);
  const int n = std::max(2, static_cast<int>(std::ceil(per_decade * decades)));
  std::vector<double> r = {low};
  for (int i = 1; i < n; ++i) r.push_back(low * std::pow(high / low, static_cast<double>(i) / n));
  r.push_back(high);
  for (const double au : {hayashi.snow_line_au, 1.6, 19.0}) {
    const double step = au * astronomical_unit;
    if (step > low && step < high) r.insert(r.end(), {step * (1 - step_width), step});
  }
  std::ranges::sort(r);
  r.erase(std::unique(r.begin(), r.end()), r.end());
  return r;
}

Contours alpha_contours(DragLaw law, const Body& body, const std::vector<double>& r) {
  return contours(law, body, r, alpha_at_speed);
}

Contours stirrer_contours(DragLaw law, const Body& body, const Stirrers& stirrers,
                          const std::vector<double>& r) {
  return contours(law, body, r, [&](const Nebula& nebula, const Drag& drag, double speed) {
    return stirrer_radius_at_speed(nebula, drag, stirrers, speed);
  });
}

std::string contours_csv(const std::vector<Contours>& laws, const std::string& quantity,
                         double unit) {
  std::string text = "drag,r_au,regime,t_s_s,t_s_omega_k";
  for (const double speed : contour_speeds)
    text += fmt::format(",{}_at_{:g}_cm_per_s", quantity, 100 * speed);
  text += "\n";
  for (const Contours& c : laws)
    for (std::size_t i = 0; i < c.r.size(); ++i) {
      const Drag& drag = c.drag[i];
      text += fmt::format("{},{:.10g},{},{:.6g},{:.6g}", name(c.law), c.r[i] / astronomical_unit,
                          name(drag.regime), drag.stopping_time,
                          drag.stopping_time * hayashi_nebula(c.r[i]).omega_k);
      for (const auto& values : c.y) text += fmt::format(",{:.6g}", values[i] / unit);
      text += "\n";
    }
  return text;
}

}  // namespace eerie::disk
