#include "campaign/maps/ridge_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace eerie::maps {
namespace {

std::string title(const ComparableRuns& g) {
  return fmt::format(
      "q = {:g}, phi_d = {:g} deg, {} ({} particles per target), {} runs of {} impacts", g.q,
      g.phi_d_deg, g.settings.name, g.settings.particles_per_target, g.runs.size(),
      paper::ridge_cells(g.runs).size());
}

/// The part of a title that distinguishes groups of one name: ", settings 3".
std::string distinction(const ComparableRuns& g, const std::vector<RidgeFit>& all) {
  const bool alone =
      std::ranges::count_if(all, [&](const RidgeFit& f) {
        return f.group.q == g.q && f.group.phi_d_deg == g.phi_d_deg &&
               f.group.settings.name == g.settings.name &&
               f.group.settings.particles_per_target == g.settings.particles_per_target;
      }) == 1;
  return alone ? "" : fmt::format(", settings {}", g.settings.id);
}

/// "12.5 to 17.5 deg (below: none at 10; above: not sampled)".
std::string bound_text(const paper::RidgeBound& b, const char* unit) {
  const auto next = [](const std::optional<double>& value) {
    return value ? fmt::format("none at {:g}", *value) : std::string("not sampled");
  };
  return fmt::format("{:g} to {:g} {} (below: {}; above: {})", b.low, b.high, unit, next(b.below),
                     next(b.above));
}

std::string constants_text(const paper::Threshold& t, const std::optional<double>& paper) {
  std::string text = fmt::format("  v sin(theta) = {:.2f} cm/s, 95 %: {:.2f} to {:.2f}", t.constant,
                                 t.low, t.high);
  if (paper)
    text += fmt::format("; paper {:g}, {:+.2f} ({} the interval)", *paper, t.constant - *paper,
                        t.low <= *paper && *paper <= t.high ? "inside" : "outside");
  text += fmt::format(
      "\n  EERs at v = {}\n          theta = {}\n  band +- {:.2f} cm/s: {:.0f} % of the runs that "
      "are EERs or in it are both\n",
      bound_text(t.v_imp, "cm/s"), bound_text(t.theta_imp, "deg"), t.half_width(), 100 * t.success);
  if (t.valley)
    text += fmt::format("  least b/a along {} angle{}: v sin(theta) = {:.2f} cm/s\n", t.valley_rows,
                        t.valley_rows == 1 ? "" : "s", *t.valley);
  if (t.scatter_s)
    text +=
        fmt::format("  centres of rows scatter by {:.0f} % in v sin(theta), {:.0f} % in v alone\n",
                    100 * *t.scatter_s, 100 * *t.scatter_v);
  else
    text +=
        "  fewer than two angles have EERs with both sides sampled: whether v sin(theta) is the "
        "same at all angles is not known\n";
  return text;
}

}  // namespace

std::string ridge_text(const RidgeFit& f, const std::vector<RidgeFit>& all) {
  const std::string first = title(f.group) + distinction(f.group, all) + "\n";
  if (const paper::Threshold* t = f.found())
    return first + constants_text(*t, paper::published_threshold(f.group.q, f.group.phi_d_deg));
  return first +
         fmt::format("  not enough data: {}\n", std::get<paper::TooFewForThreshold>(f.fit).reason);
}

}  // namespace eerie::maps
