#include "campaign/serve/views/job_report.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "campaign/job_folder/history.hpp"
#include "campaign/job_folder/job_directory.hpp"
#include "db/jobs/jobs.hpp"
#include "db/views/query.hpp"
#include "solver/scene/field_words.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::serve {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

json or_null(const std::string& text) { return text.empty() ? json() : json(text); }
template <class T>
json or_null(const std::optional<T>& value) {
  return value ? json(*value) : json();
}

json attempts_json(const std::vector<db::AttemptRow>& rows) {
  json list = json::array();
  for (const db::AttemptRow& a : rows)
    list.push_back({{"host", a.host},
                    {"worker", or_null(a.worker)},
                    {"version", a.version},
                    {"started", a.started},
                    {"ended", or_null(a.ended)},
                    {"exit_reason", or_null(a.exit_reason)},
                    {"failure_kind", or_null(a.failure_kind)},
                    {"message", or_null(a.message)},
                    {"core_seconds", or_null(a.core_seconds)},
                    {"particle_steps", or_null(a.particle_steps)},
                    {"peak_memory_bytes", or_null(a.peak_memory_bytes)}});
  return list;
}

/// Files of the job directory with their sizes, in order of their names.
std::vector<std::pair<fs::path, std::uintmax_t>> files_of(
    const job_folder::JobDirectory& directory) {
  std::vector<std::pair<fs::path, std::uintmax_t>> files;
  std::error_code missing;
  for (const auto& entry : fs::directory_iterator(directory.path, missing))
    if (entry.is_regular_file(missing)) files.emplace_back(entry.path(), entry.file_size(missing));
  std::ranges::sort(files);
  return files;
}

/// What the schema says of a field, by its dotted path; empty within arrays.
std::string meaning_of(const std::string& path) {
  const json* at = &scene_schema();
  std::istringstream words(path);
  for (std::string key; std::getline(words, key, '.');) {
    if (!at->contains("properties") || !at->at("properties").contains(key)) return "";
    at = &at->at("properties").at(key);
  }
  return at->value("description", "");
}

}  // namespace

json job_report(const db::Connection& connection, const db::Job& job) {
  const job_folder::JobDirectory directory = job_folder::job_folder(connection).of(job.hash);
  json files = json::array();
  for (const auto& [path, bytes] : files_of(directory))
    files.push_back({{"path", path.string()}, {"bytes", bytes}});
  const auto progress = job_folder::read_progress(directory);
  return {{"hash", job.hash},
          {"state", db::job_state_names.at(static_cast<std::size_t>(job.state))},
          {"wanted", db::wanted_names.at(static_cast<std::size_t>(job.wanted))},
          {"priority", job.priority},
          {"crashes", job.crashes},
          {"wall_limit_s", or_null(job.wall_limit_s)},
          {"sweeps", db::sweeps_of(connection, job.id)},
          {"scene", json::parse(db::scene(connection, job.id))},
          {"progress", progress ? to_json(*progress) : json()},
          {"result", job_folder::read_json(directory.result()).value_or(json())},
          {"failure", job_folder::read_json(directory.failure()).value_or(json())},
          {"attempts", attempts_json(db::attempts(connection, job.id))},
          {"directory", directory.path.string()},
          {"files", std::move(files)}};
}

json scene_leaves(const json& scene) {
  json plain = json::object();
  if (scene.contains("numerics") && scene.at("numerics").contains("scheme"))
    plain["numerics"]["scheme"] = scene.at("numerics").at("scheme");
  const json usual = to_json(parse_scene(plain)).flatten();
  const json unchanged = to_json(parse_scene(json::object())).flatten();
  const json flat = scene.flatten();
  json leaves = json::array();
  for (const auto& [pointer, value] : flat.items()) {
    const std::string path = dotted(pointer);
    // The scheme itself differs from the one that a scene has by default.
    const json& defaults = path == "numerics.scheme" ? unchanged : usual;
    const json by_default = defaults.value(pointer, json());
    leaves.push_back({{"path", path},
                      {"value", value},
                      {"default", by_default},
                      {"differs", by_default != value},
                      {"meaning", meaning_of(path)}});
  }
  std::ranges::stable_partition(leaves, [](const json& leaf) { return leaf.at("differs"); });
  return leaves;
}

json history_json(const db::Connection& connection, const db::Job& job) {
  json columns = json::object();
  for (const job_folder::HistoryRow& row :
       job_folder::read_history(job_folder::job_folder(connection).of(job.hash).history()))
    visit_columns(row,
                  [&](const char* name, const auto& value) { columns[name].push_back(value); });
  return {{"columns", std::move(columns)}};
}

}  // namespace eerie::serve
