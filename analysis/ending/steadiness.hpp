#pragma once

#include <concepts>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "analysis/remnants/remnants.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::ending {

/// A remnant at one moment, by the numbers that do not change once an impact has settled.
struct RemnantLook {
  double time_s = 0;
  int rank = 0;  ///< 1: the most massive; 0: no remnant existed at that moment
  double mass_over_total = 0, target_fraction = 0;
  double a_m = 0, b_over_a = 0, c_over_a = 0;
  double turns_per_h = 0;  ///< 0: it does not spin
};

/// Visits the numbers of a row with their names, in the order of the columns of remnants.csv.
template <class Row, class Visit>
requires std::same_as<std::remove_const_t<Row>, RemnantLook>
void visit_columns(Row& row, Visit&& visit) {
  visit("time_s", row.time_s);
  visit("rank", row.rank);
  visit("mass_over_total", row.mass_over_total);
  visit("target_fraction", row.target_fraction);
  visit("a_m", row.a_m);
  visit("b_over_a", row.b_over_a);
  visit("c_over_a", row.c_over_a);
  visit("turns_per_h", row.turns_per_h);
}

/// Looks at an impact once: makes a row for each remnant of at least settled.mass of all mass.
std::vector<RemnantLook> look(double time_s, const remnants::Remnants& found,
                              const Scene::Settled& settled);

/// Says what was not steady during the last window of `looks`, which ascend in time. The text is
/// empty where shapes, spins and masses stayed within the tolerances of `settled`. Remnants are
/// followed from look to look by their mass and origin, since two similar ones may exchange their
/// ranks.
std::string unsteadiness(std::span<const RemnantLook> looks, const Scene::Settled& settled);

/// Says what moves too fast for a late phase (numerics.late_sound_speed). The text is empty where
/// remnants stayed within three times the tolerances over half a window, and where no two of them
/// meet within `horizon` (s) at more than a tenth of `sound_speed` (m/s), which is that of the late
/// phase.
std::string liveliness(std::span<const RemnantLook> looks, const remnants::Remnants& found,
                       double horizon, double sound_speed, const Scene::Settled& settled);

/// The greatest speed at which two remnants meet within `horizon` (s), m/s, by the orbits of
/// encounters(); 0 where none meet.
double meeting_speed(const remnants::Remnants& found, double horizon,
                     const Scene::Settled& settled);

/// Says what prevents a flight of rigid remnants (numerics.rigid_flight). The text is empty where
/// remnants stayed within the tolerances over half a window, with three times the tolerance for
/// mass that falls back.
std::string restlessness(std::span<const RemnantLook> looks, const Scene::Settled& settled);

/// The time until the first contact of two remnants, s, by the orbits of encounters(); infinity
/// where none is ahead.
double next_meeting(const remnants::Remnants& found, const Scene::Settled& settled);

/// The mass of the fragments that touch a remnant within `horizon` (s), kg, by the orbits of
/// encounters().
double falling_back(const remnants::Remnants& found, double horizon, const Scene::Settled& settled);

/// Says what gravity will bring within `horizon` (s): a contact of two remnants, more fragments
/// that fall back than settled.fall_back allows, or fragments that gather into a remnant. The text
/// is empty where none of these is ahead. `total` is the mass of both bodies, kg. Orbits are those
/// of pairs, and contact is at the sum of the longest semi-axes.
std::string encounters(const remnants::Remnants& found, double total, double horizon,
                       const Scene::Settled& settled);

/// The time ahead for which encounters matter, s: to the end of the run, and at most
/// settled.horizon_s.
double horizon(const Scene::End& end, double time_s);

}  // namespace eerie::ending
