#include <algorithm>
#include <nlohmann/json.hpp>

#include "campaign/job_folder/result_file.hpp"
#include "campaign/text/json_file.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "solver/base/sha256.hpp"

namespace eerie::job_folder {
using nlohmann::json;

namespace {

template <class T>
std::optional<T> optional_value(const json& object, const char* key) {
  const json& value = object.at(key);
  if (value.is_null()) return std::nullopt;
  if constexpr (std::integral<T>) {
    T number{};
    text::read_whole(value, number);
    return number;
  } else {
    return value.get<T>();
  }
}

db::Remnant remnant_row(const json& m) {
  db::Remnant row;
  text::read_whole(m.at("rank"), row.rank);
  text::read_whole(m.at("particles"), row.particles);
  m.at("mass_kg").get_to(row.mass_kg);
  m.at("mass_over_total").get_to(row.mass_over_total);
  row.a_m = optional_value<double>(m, "a_m");
  row.b_m = optional_value<double>(m, "b_m");
  row.c_m = optional_value<double>(m, "c_m");
  row.b_over_a = optional_value<double>(m, "b_over_a");
  row.c_over_a = optional_value<double>(m, "c_over_a");
  row.spin_period_h = optional_value<double>(m, "spin_period_h");
  m.at("eer").get_to(row.eer);
  row.target_fraction = optional_value<double>(m, "target_fraction");
  row.bound_group = optional_value<std::int64_t>(m, "bound_group");
  row.bound_mass_over_total = optional_value<double>(m, "bound_mass_over_total");
  row.x_m = optional_value<double>(m, "x_m");
  row.y_m = optional_value<double>(m, "y_m");
  row.z_m = optional_value<double>(m, "z_m");
  row.vx_m_per_s = optional_value<double>(m, "vx_m_per_s");
  row.vy_m_per_s = optional_value<double>(m, "vy_m_per_s");
  row.vz_m_per_s = optional_value<double>(m, "vz_m_per_s");
  if (!m.contains("shape_class")) return row;  // written before there were details
  m.at("shape_class").get_to(row.shape_class);
  for (std::size_t k = 0; k < db::remnant_detail_columns.size(); ++k)
    row.details[k] = optional_value<double>(m, db::remnant_detail_columns[k]);
  return row;
}

/// "0.6.0": digits and dots.
bool is_version(const std::string& text) {
  constexpr std::size_t longest = 40;
  return !text.empty() && text.size() <= longest &&
         text.find_first_not_of("0123456789.") == std::string::npos && text.front() != '.';
}

StoredResult stored_result(const json& document) {
  StoredResult stored;
  for (const json& m : document.at("analysis").at("remnants"))
    stored.remnants.push_back(remnant_row(m));
  db::Result& r = stored.result;
  const json& outcome = document.at("analysis").at("outcome");
  outcome.at("class").get_to(r.outcome_class);
  outcome.at("m_lr_over_m_total").get_to(r.m_lr_over_m_total);
  outcome.at("m_slr_over_m_total").get_to(r.m_slr_over_m_total);
  outcome.at("settled").get_to(r.settled);
  outcome.at("unsettled_reason").get_to(r.unsettled_reason);
  r.n_remnants = static_cast<int>(stored.remnants.size());
  r.n_eer = static_cast<int>(std::count_if(stored.remnants.begin(), stored.remnants.end(),
                                           [](const auto& m) { return m.eer; }));
  if (!stored.remnants.empty()) {
    const db::Remnant& largest = stored.remnants.front();
    r.b_over_a = largest.b_over_a;
    r.c_over_a = largest.c_over_a;
    r.period_h = largest.spin_period_h;
    r.eer = largest.eer;
  }
  const json& run = document.at("run");
  r.dL_over_L = optional_value<double>(run, "dL_over_L");
  r.ended_at_s = optional_value<double>(run, "end_time_s");
  r.end_reason = run.value("end_reason", "");
  text::read_whole(run.at("steps"), r.steps);
  run.at("particle_steps").get_to(r.particle_steps);
  run.at("wall_s").get_to(r.wall_s);
  text::read_whole(run.at("threads"), r.threads);
  const json& source = document.at("provenance");
  // Until the solver had a version of its own, it was the program's.
  source.at(source.contains("solver_version") ? "solver_version" : "version")
      .get_to(r.solver_version);
  source.at("host").get_to(r.host);
  // It becomes part of a file's name where the result is set aside.
  if (!is_version(r.solver_version)) throw InputError("its version is none");
  return stored;
}

/// Whether the document is as it was written. Version 1 had no checksum.
bool is_sound(const json& document) {
  const bool has_checksum = document.contains("sha256");
  if (document.at("version") == 1) return !has_checksum;
  if (document.at("version") != result_version || !has_checksum) return false;
  json rest = document;
  rest.erase("sha256");
  return document.at("sha256") == sha256_hex(rest.dump());
}

}  // namespace

std::optional<StoredResult> parse_result(std::string_view text, const std::string& hash) {
  try {
    const json document = text::parse_json(text, "result.json");
    if (!is_sound(document) || document.at("scene_hash") != hash) return std::nullopt;
    return stored_result(document);
  } catch (const InputError&) {  // torn, or no JSON at all
    return std::nullopt;
  } catch (const json::exception&) {  // lacks what a result has
    return std::nullopt;
  }
}

std::optional<StoredResult> read_result(const JobDirectory& directory, const std::string& hash) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(directory.result(), ignored)) return std::nullopt;
  return parse_result(read_file(directory.result()), hash);
}

}  // namespace eerie::job_folder
