#pragma once

#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace eerie::sweeps {

/// A named set of fields of numerics and end. Fidelities differ in cost and accuracy.
struct Fidelity {
  const char* name;
  const char* settings;  ///< JSON, part of a scene; those of a rung go over rung_settings
  /// The mean core-seconds of thirteen impacts, and the root mean square error of b/a of a single
  /// run (docs/notebook/convergence/errors.py); 0: not known.
  double core_seconds = 0, error = 0;
  bool is_rung = true;  ///< whether it belongs to the ladder of the default scheme
  int seeds = 1;        ///< as many as its question needs
  /// The part of single runs whose class is the most frequent one of finer runs; 0: not known.
  double class_agrees = 0;
  const char* question = "";  ///< what it is for
  const char* caution = "";   ///< what can go wrong
};

/// The settings of all rungs. They take the default scheme. Runs end when remnants have settled, or
/// at the time of the paper's results. Matter is softer while it moves slowly, where viscosity then
/// damps in stages, and remnants that wait for each other fly as rigid bodies.
inline constexpr const char* rung_settings =
    R"({"numerics": {"scheme": "closing-gaps", "late_sound_speed": 0.125, "viscous_stages": 3,
                     "rigid_flight": true, "list_skin": 0.15},
        "end": {"time_s": 100000,
                "settled": {"window_s": 4000, "shape": 0.003, "spin": 0.05, "fall_back": 0.02}}})";

/// The rungs of the ladder, cheapest first, and the settings of the paper for comparison.
inline constexpr Fidelity fidelities[] = {
    // This is the smallest number of particles that makes an impactor of q = 0.25.
    {"sketch", R"({"numerics": {"particles_per_target": 400}})", 1.6, 0.21, true, 1, 0.77,
     "Where does anything happen?", "too stout by 0.1 and more: EERs are missed"},
    {"survey", R"({"numerics": {"particles_per_target": 1000}})", 4.9, 0.16, true, 2, 0.86,
     "What does the map look like?", "the ridge of 50 deg and small EERs are missed"},
    {"standard", R"({"numerics": {"particles_per_target": 5000}})", 41, 0.12, true, 4, 1,
     "What is b/a of this impact, and is it an EER?", "on the ridge of 50 deg b/a too low by 0.1"},
    {"fine", R"({"numerics": {"particles_per_target": 20000}})", 490, 0.07, true, 3, 0.97,
     "Does it hold with more particles?", "three pieces still differ from run to run"},
    // The particle number, scheme and time of Sugiura, Kobayashi & Inutsuka (2019). A run may end
    // earlier once it has settled by the default tolerances, which changes b/a by at most 0.006.
    {"paper",
     R"({"numerics": {"scheme": "libersky-petschek-2018", "particles_per_target": 50000},
         "end": {"time_s": 100000, "settled": {"window_s": 4000}}})",
     2000, 0, false, 1, 0, "What did the paper compute?", "one run each so far"},
};

/// The fidelity of scenes that name no scheme.
inline constexpr const char* default_fidelity = "standard";

/// The runs of one impact by --fidelity auto: at first on a rung, at most on a rung below the last,
/// and at most on the last one unless told otherwise.
inline constexpr std::int64_t first_auto_seeds = 2, most_auto_seeds = 4, most_last_auto_seeds = 8;

/// The settings of a fidelity, part of a scene. Throws InputError where no fidelity has this name,
/// with `where` in front.
nlohmann::json settings_of(const std::string& name, const std::string& where = "--fidelity");

/// The settings of a fidelity as overrides, such as "numerics.particles_per_target=1000". Throws
/// InputError where no fidelity has this name.
std::vector<std::string> overrides_of_fidelity(const std::string& name);

/// The fields that decide whether the default fidelity is meant for a scene.
inline constexpr std::array<std::string_view, 3> fields_against_default = {
    "numerics.scheme", "environment.self_gravity", "material.energy"};

/// Lays a scene, as given, over the settings of the default fidelity. A scene stays as it is if it
/// names its scheme, has no self-gravity, or integrates an energy equation.
nlohmann::json over_default_fidelity(const nlohmann::json& scene);

/// Says which settings of the default fidelity a scene, as given, replaces.
std::vector<std::string> departures(const nlohmann::json& scene, const std::string& where);

/// The rung above one; empty above the last one, and where `name` is no rung.
std::string_view rung_above(std::string_view name);

/// Says what a rung saves and errs against the one above, `name`; empty for the lowest rung and
/// for other names.
std::string cheaper_rung(std::string_view name);

/// The fidelity whose numerics (except the seed) and end a scene has, given its to_json(). Empty
/// where no fidelity matches.
std::string_view fidelity_of(const nlohmann::json& canonical);

}  // namespace eerie::sweeps
