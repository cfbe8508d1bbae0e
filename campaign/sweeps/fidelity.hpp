#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace eerie::sweeps {

/// How much an impact may cost: a named set of numerics and end, as --set would give them. What
/// each costs and how true it is stands in docs/notebook/accuracy.md.
struct Fidelity {
  const char* name;
  const char* settings;  ///< JSON, part of a scene
};

inline constexpr Fidelity fidelities[] = {
    // The fewest particles that make an impactor of q = 0.25.
    {"sketch",
     R"({"numerics": {"scheme": "viscosity-50000", "particles_per_target": 400,
                     "late_sound_speed": 0.25},
         "end": {"time_s": 60000,
                 "settled": {"window_s": 4000, "shape": 0.003, "spin": 0.05, "fall_back": 0.02}}})"},
    {"survey",
     R"({"numerics": {"scheme": "viscosity-50000", "particles_per_target": 1000,
                     "late_sound_speed": 0.25},
         "end": {"time_s": 60000,
                 "settled": {"window_s": 4000, "shape": 0.003, "spin": 0.05, "fall_back": 0.02}}})"},
    // Sugiura, Kobayashi & Inutsuka (2019): their particle number, scheme and time, or until
    // settled by the default tolerances, which move b/a by 0.006 at most.
    {"paper",
     R"({"numerics": {"scheme": "libersky-petschek-2018", "particles_per_target": 50000},
         "end": {"time_s": 100000, "settled": {"window_s": 4000}}})"},
};

/// The settings of a fidelity as overrides, "numerics.particles_per_target=1000" ... Throws
/// InputError for a name that is none.
std::vector<std::string> overrides_of_fidelity(const std::string& name);

/// The name of the fidelity whose numerics (but for the seed) and end a scene has, given by its
/// to_json(); empty where it has other ones.
std::string_view fidelity_of(const nlohmann::json& canonical);

}  // namespace eerie::sweeps
