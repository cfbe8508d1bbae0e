#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace eerie::sweeps {

/// A named set of fields of numerics and end, which --set could give as well. Fidelities differ in
/// cost and accuracy (docs/accuracy.md).
struct Fidelity {
  const char* name;
  const char* settings;  ///< JSON, part of a scene
};

inline constexpr Fidelity fidelities[] = {
    // This is the smallest number of particles that makes an impactor of q = 0.25.
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
    // The particle number, scheme and time of Sugiura, Kobayashi & Inutsuka (2019). A run may end
    // earlier once it has settled by the default tolerances, which changes b/a by at most 0.006.
    {"paper",
     R"({"numerics": {"scheme": "libersky-petschek-2018", "particles_per_target": 50000},
         "end": {"time_s": 100000, "settled": {"window_s": 4000}}})"},
};

/// The settings of a fidelity as overrides, such as "numerics.particles_per_target=1000". Throws
/// InputError where no fidelity has this name.
std::vector<std::string> overrides_of_fidelity(const std::string& name);

/// The fidelity whose numerics (except the seed) and end a scene has, given its to_json(). Empty
/// where no fidelity matches.
std::string_view fidelity_of(const nlohmann::json& canonical);

}  // namespace eerie::sweeps
