#include "analysis/ending/steadiness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/remnants/encounter.hpp"

namespace eerie::ending {

namespace {

/// Spins slower than this, turns per hour, may change by as much as this one may.
constexpr double slow_spin = 0.01;

using Looks = std::span<const RemnantLook>;

/// Looks of one moment each, from the last on, as far back as so many intervals reach; empty where
/// a look is missing.
std::vector<Looks> last_moments(Looks looks, std::size_t intervals, double interval) {
  std::vector<Looks> moments;
  while (!looks.empty() && moments.size() <= intervals) {
    const double time = looks.back().time_s;
    if (!moments.empty() && moments.back().front().time_s - time > 1.5 * interval) return {};
    const auto first = std::ranges::find(looks, time, &RemnantLook::time_s);
    const auto others = static_cast<std::size_t>(first - looks.begin());
    moments.push_back(looks.subspan(others));
    looks = looks.first(others);
  }
  if (moments.size() <= intervals) return {};
  return moments;
}

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void include(double value) { low = std::min(low, value), high = std::max(high, value); }
  double width() const { return high - low; }
};

/// The numbers of one remnant over a window.
struct Track {
  RemnantLook at;  ///< the moment reached, going back
  Range mass, b_over_a, c_over_a, spin;

  void include(const RemnantLook& look) {
    at = look;
    mass.include(look.mass_over_total);
    b_over_a.include(look.b_over_a);
    c_over_a.include(look.c_over_a);
    spin.include(look.turns_per_h);
  }
  double unlikeness(const RemnantLook& look) const {
    return std::abs(look.mass_over_total - at.mass_over_total) +
           std::abs(look.target_fraction - at.target_fraction);
  }
};

/// Each track goes back to the remnant that is most like it, the likest first.
void go_back(std::vector<Track>& tracks, Looks moment) {
  std::vector<bool> taken(moment.size(), false), moved(tracks.size(), false);
  for (std::size_t step = 0; step < tracks.size(); ++step) {
    double least = std::numeric_limits<double>::infinity();
    std::size_t track = 0, remnant = 0;
    for (std::size_t t = 0; t < tracks.size(); ++t)
      for (std::size_t r = 0; r < moment.size(); ++r)
        if (const double unlike = tracks[t].unlikeness(moment[r]);
            !moved[t] && !taken[r] && unlike < least)
          least = unlike, track = t, remnant = r;
    moved[track] = taken[remnant] = true;
    tracks[track].include(moment[remnant]);
  }
}

std::string change(int rank, const char* what, const Range& range, double window) {
  return fmt::format("{} of remnant {} went from {:.3f} to {:.3f} within {:.0f} s", what, rank,
                     range.low, range.high, window);
}

/// unsteadiness() over the last `intervals` looks.
std::string unsteadiness(Looks looks, std::size_t intervals, const Scene::Settled& settled) {
  const double interval = settled.window_s / looks_per_window;
  const double duration = interval * static_cast<double>(intervals);
  const std::vector<Looks> moments = last_moments(looks, intervals, interval);
  if (moments.empty()) return "it was not watched for long enough";
  std::vector<Track> tracks(moments.front().size());
  for (std::size_t t = 0; t < tracks.size(); ++t) tracks[t].include(moments.front()[t]);
  for (const Looks& moment : moments) {
    if (moment.size() != tracks.size() || (moment.front().rank == 0) != (tracks[0].at.rank == 0))
      return fmt::format("the number of remnants changed within {:.0f} s", duration);
    go_back(tracks, moment);
  }
  for (std::size_t t = 0; t < tracks.size(); ++t) {
    const Track& track = tracks[t];
    const int rank = moments.front()[t].rank;
    if (track.b_over_a.width() > settled.shape)
      return change(rank, "b/a", track.b_over_a, duration);
    if (track.c_over_a.width() > settled.shape)
      return change(rank, "c/a", track.c_over_a, duration);
    if (track.mass.width() > settled.fall_back)
      return change(rank, "the part of the mass", track.mass, duration);
    if (track.spin.width() > settled.spin * std::max(track.spin.high, slow_spin))
      return change(rank, "the turns per hour", track.spin, duration);
  }
  return "";
}

bool is_watched(const remnants::Remnant& r, const Scene::Settled& settled) {
  return r.mass_over_total >= settled.mass;
}

}  // namespace

std::vector<RemnantLook> look(double time_s, const remnants::Remnants& found,
                              const Scene::Settled& settled) {
  std::vector<RemnantLook> rows;
  for (const remnants::Remnant& r : found.remnants)
    if (is_watched(r, settled))
      rows.push_back({time_s, r.rank, r.mass_over_total, r.target_fraction, r.shape.a,
                      r.shape.b_over_a(), r.shape.c_over_a(),
                      r.spin_period ? 3600 / *r.spin_period : 0});
  if (rows.empty()) rows.push_back({.time_s = time_s});
  return rows;
}

std::string unsteadiness(Looks looks, const Scene::Settled& settled) {
  return unsteadiness(looks, looks_per_window, settled);
}

std::string restlessness(Looks looks, const Scene::Settled& settled) {
  constexpr double slack = 3;
  Scene::Settled wide = settled;
  wide.fall_back *= slack;
  return unsteadiness(looks, looks_per_window / 2, wide);
}

std::string liveliness(Looks looks, const remnants::Remnants& found, double horizon,
                       double sound_speed, const Scene::Settled& settled) {
  constexpr double slack = 3, greatest_mach = 0.1;
  Scene::Settled wide = settled;
  wide.shape *= slack, wide.spin *= slack, wide.fall_back *= slack;
  if (std::string text = unsteadiness(looks, looks_per_window / 2, wide); !text.empty())
    return text;
  const double speed = meeting_speed(found, horizon, settled);
  return speed > greatest_mach * sound_speed
             ? fmt::format("two remnants will meet at {:.3f} m/s", speed)
             : "";
}

double meeting_speed(const remnants::Remnants& found, double horizon,
                     const Scene::Settled& settled) {
  const std::vector<remnants::Remnant>& all = found.remnants;
  double greatest = 0;
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = i + 1; j < all.size(); ++j) {
      if (!is_watched(all[i], settled) || !is_watched(all[j], settled)) continue;
      const remnants::Encounter pair = remnants::encounter(all[i], all[j]);
      if (pair.time_s() > horizon) continue;
      const double energy = pair.orbit.specific_energy + pair.orbit.mu / pair.contact;
      greatest = std::max(greatest, std::sqrt(2 * std::max(0.0, energy)));
    }
  return greatest;
}

double next_meeting(const remnants::Remnants& found, const Scene::Settled& settled) {
  const std::vector<remnants::Remnant>& all = found.remnants;
  double first = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = i + 1; j < all.size(); ++j)
      if (is_watched(all[i], settled) && is_watched(all[j], settled))
        first = std::min(first, remnants::encounter(all[i], all[j]).time_s());
  return first;
}

double falling_back(const remnants::Remnants& found, double horizon,
                    const Scene::Settled& settled) {
  const std::vector<remnants::Remnant>& all = found.remnants;
  std::vector<remnants::PointMass> fragments = found.debris;
  for (const remnants::Remnant& r : all)
    if (!is_watched(r, settled)) fragments.push_back(remnants::point(r));
  double falling = 0;
  for (const remnants::PointMass& fragment : fragments)
    if (std::ranges::any_of(all, [&](const remnants::Remnant& r) {
          return is_watched(r, settled) && remnants::encounter(r, fragment).time_s() <= horizon;
        }))
      falling += fragment.mass;
  return falling;
}

double horizon(const Scene::End& end, double time_s) {
  return std::min(end.settled.horizon_s, std::max(end.time_s, end.latest_s) - time_s);
}

std::string encounters(const remnants::Remnants& found, double total, double horizon,
                       const Scene::Settled& settled) {
  const std::vector<remnants::Remnant>& all = found.remnants;
  for (std::size_t group = 0; group < found.group_masses.size(); ++group) {
    const double loose = found.group_masses[group] - found.group_cores[group];
    if (found.group_cores[group] < settled.mass * total && loose > settled.fall_back * total)
      return fmt::format("{:.3f} of the mass is bound and has not gathered yet", loose / total);
  }
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = i + 1; j < all.size(); ++j) {
      if (!is_watched(all[i], settled) || !is_watched(all[j], settled)) continue;
      const double time = remnants::encounter(all[i], all[j]).time_s();
      if (time <= horizon)
        return fmt::format("remnants {} and {} will meet in about {:.0f} s", all[i].rank,
                           all[j].rank, time);
    }
  const double falling = falling_back(found, horizon, settled);
  if (falling > settled.fall_back * total)
    return fmt::format("{:.3f} of the mass will fall back", falling / total);
  return "";
}

}  // namespace eerie::ending
