#pragma once

#include <concepts>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "analysis/remnants/remnants.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::ending {

/// A remnant at one moment, in what must stay as it is once an impact has settled.
struct RemnantLook {
  double time_s = 0;
  int rank = 0;  ///< 1: the most massive; 0: there was no remnant at that moment
  double mass_over_total = 0, target_fraction = 0;
  double a_m = 0, b_over_a = 0, c_over_a = 0;
  double turns_per_h = 0;  ///< 0: it does not spin
};

/// Names the numbers of a row, in the order of the columns of remnants.csv.
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

/// One look at an impact: a row for each remnant of at least settled.mass of all the mass.
std::vector<RemnantLook> look(double time_s, const remnants::Remnants& found,
                              const Scene::Settled& settled);

/// What was not steady during the last window of `looks` (ascending in time); empty where shapes,
/// spins and masses kept within the tolerances of `settled`. Remnants are followed from look to
/// look by their mass and origin, not by their rank, which two alike may exchange.
std::string unsteadiness(std::span<const RemnantLook> looks, const Scene::Settled& settled);

/// What moves too fast for a late phase (numerics.late_sound_speed); empty where nothing does: over
/// half a window remnants kept within three times the tolerances, and no two of them meet within
/// `horizon` (s) at more than a tenth of `sound_speed` (m/s), the one of the late phase.
std::string liveliness(std::span<const RemnantLook> looks, const remnants::Remnants& found,
                       double horizon, double sound_speed, const Scene::Settled& settled);

/// The greatest speed at which two remnants meet within `horizon` (s), m/s; 0 where none do. As in
/// encounters().
double meeting_speed(const remnants::Remnants& found, double horizon,
                     const Scene::Settled& settled);

/// What keeps remnants from flying as rigid bodies (numerics.rigid_flight); empty where nothing
/// does: over half a window they kept within the tolerances, three times that for mass that falls
/// back.
std::string restlessness(std::span<const RemnantLook> looks, const Scene::Settled& settled);

/// Time until the first contact of two remnants, s; infinity where none is to come. As in
/// encounters().
double next_meeting(const remnants::Remnants& found, const Scene::Settled& settled);

/// Mass of the fragments that come into contact with a remnant within `horizon` (s), kg. As in
/// encounters().
double falling_back(const remnants::Remnants& found, double horizon, const Scene::Settled& settled);

/// What gravity will bring within `horizon` (s): the first contact of two remnants, more fragments
/// falling back than settled.fall_back allows, or a remnant that gathers from fragments; empty
/// where nothing. `total`: mass of both bodies, kg. Orbits are those of pairs; contact is at the
/// sum of half the longest axes.
std::string encounters(const remnants::Remnants& found, double total, double horizon,
                       const Scene::Settled& settled);

/// How far encounters of a run matter: to its end, and no further than settled.horizon_s.
double horizon(const Scene::End& end, double time_s);

}  // namespace eerie::ending
