#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace eerie::sweeps {

/// How much an impact may cost: a named set of numerics and end. What each costs and how true it
/// is stands in docs/accuracy.md.
struct Fidelity {
  const char* name;
  const char* settings;  ///< JSON, part of a scene, merged over what all rungs have
  bool is_rung = true;   ///< of the ladder of one scheme; else its settings are all that it has
};

/// What every rung has: the default scheme, until remnants have settled or to the time at which
/// the paper looks, with softer matter once it moves slowly, and flights while remnants wait.
inline constexpr const char* rung_settings =
    R"({"numerics": {"scheme": "closing-gaps", "late_sound_speed": 0.125, "rigid_flight": true},
        "end": {"time_s": 100000,
                "settled": {"window_s": 4000, "shape": 0.003, "spin": 0.05, "fall_back": 0.02}}})";

/// The ladder from below, and what it is compared with.
inline constexpr Fidelity fidelities[] = {
    // The fewest particles that make an impactor of q = 0.25.
    {"sketch", R"({"numerics": {"particles_per_target": 400}})"},
    {"survey", R"({"numerics": {"particles_per_target": 1000}})"},
    {"standard", R"({"numerics": {"particles_per_target": 5000}})"},
    {"fine", R"({"numerics": {"particles_per_target": 20000}})"},
    // Sugiura, Kobayashi & Inutsuka (2019): their particle number, scheme and time, or until
    // settled by the default tolerances, which move b/a by 0.006 at most.
    {"paper",
     R"({"numerics": {"scheme": "libersky-petschek-2018", "particles_per_target": 50000},
         "end": {"time_s": 100000, "settled": {"window_s": 4000}}})",
     false},
};

/// That of scenes that say nothing else.
inline constexpr const char* default_fidelity = "standard";

/// The settings of a fidelity, part of a scene. Throws InputError for a name that is none; `where`
/// stands in front.
nlohmann::json settings_of(const std::string& name, const std::string& where = "--fidelity");

/// The settings of a fidelity as overrides, "numerics.particles_per_target=1000" ... Throws
/// InputError for a name that is none.
std::vector<std::string> overrides_of_fidelity(const std::string& name);

/// `scene`, as given, over the settings of the default fidelity. A scene that names its scheme, or
/// that is no impact under self-gravity without an energy budget, stays as it is.
nlohmann::json over_default_fidelity(const nlohmann::json& scene);

/// In sentences, which settings of the default fidelity a scene, as given, replaces.
std::vector<std::string> departures(const nlohmann::json& scene, const std::string& where);

/// The name of the fidelity whose numerics (but for the seed) and end a scene has, given by its
/// to_json(); empty where it has other ones.
std::string_view fidelity_of(const nlohmann::json& canonical);

}  // namespace eerie::sweeps
