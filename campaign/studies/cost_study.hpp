#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "solver/scene/scene.hpp"

namespace eerie::studies {

/// A study of cost against accuracy, as read from its file (cost_study.schema.json). It runs some
/// impacts with default settings, with one knob at a time changed, and with the settings of a
/// reference.
struct CostStudy {
  struct Case {
    std::string name, title;
    nlohmann::json scene;  ///< with the fields of the study's scene and its fidelity
  };
  struct Setting {
    std::string knob, label;
    nlohmann::json set;  ///< dotted path -> value
    std::int64_t seeds = 1;
  };
  std::string name;
  std::vector<Case> cases;
  std::vector<Setting> settings;  ///< the default first, the reference last
  nlohmann::json document;        ///< the document as given, for the database
};

inline constexpr const char* default_knob = "default";
inline constexpr const char* reference_knob = "reference";

/// Reads a study. Throws InputError, which names path, value, allowed range and mend.
CostStudy parse_cost_study(const nlohmann::json& document, const std::string& where);
CostStudy load_cost_study(const std::filesystem::path& path);

/// One run of a cost study.
struct CostRun {
  std::size_t setting = 0, case_index = 0;
  std::int64_t seed = 1;
  Scene scene;
};

/// All runs; the first seed of all settings comes first.
std::vector<CostRun> runs_of(const CostStudy& study);

}  // namespace eerie::studies
