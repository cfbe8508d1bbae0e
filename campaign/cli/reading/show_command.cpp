#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "campaign/cli/options/command_list.hpp"
#include "campaign/cli/options/find_job.hpp"
#include "campaign/cli/options/particle_pictures.hpp"
#include "campaign/cli/output/text_table.hpp"
#include "campaign/job_folder/job_directory.hpp"
#include "db/jobs/jobs.hpp"
#include "db/views/query.hpp"
#include "solver/base/error.hpp"

namespace eerie::cli {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

struct ShowArguments {
  fs::path database;
  std::string job;
  PictureArguments pictures;
  bool json = false;
};

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

/// All that is known of a job.
json report(const db::Connection& connection, const db::Job& job) {
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
          {"progress", progress ? job_folder::to_json(*progress) : json()},
          {"result", job_folder::read_json(directory.result()).value_or(json())},
          {"failure", job_folder::read_json(directory.failure()).value_or(json())},
          {"attempts", attempts_json(db::attempts(connection, job.id))},
          {"directory", directory.path.string()},
          {"files", std::move(files)}};
}

/// "material.rho0_kg_per_m3 = 2700", one line per leaf.
void print_leaves(const json& object, const std::string& path, const char* indent) {
  for (const auto& [key, value] : object.items()) {
    const std::string here = path.empty() ? key : path + "." + key;
    if (value.is_object())
      print_leaves(value, here, indent);
    else
      fmt::print("{}{} = {}\n", indent, here, value.dump());
  }
}

void print_remnants(const json& remnants) {
  std::vector<std::vector<std::string>> rows = {
      {"remnant", "particles", "M/M_total", "a m", "b m", "c m", "b/a", "period h", "EER"}};
  const auto cell = [](const json& m, const char* key, int digits) {
    return m.at(key).is_null() ? std::string("-")
                               : fmt::format("{:.{}f}", m.at(key).get<double>(), digits);
  };
  for (const json& m : remnants)
    rows.push_back({m.at("rank").dump(), m.at("particles").dump(), cell(m, "mass_over_total", 3),
                    cell(m, "a_m", 1), cell(m, "b_m", 1), cell(m, "c_m", 1), cell(m, "b_over_a", 3),
                    cell(m, "spin_period_h", 2), m.at("eer").get<bool>() ? "yes" : ""});
  fmt::print("{}", text_table(rows));
}

void print_result(const json& result) {
  const json& outcome = result.at("analysis").at("outcome");
  const json& run = result.at("run");
  fmt::print("\nresult: {}{}\n", outcome.at("class").get<std::string>(),
             outcome.at("settled").get<bool>()
                 ? ""
                 : "; not settled: " + outcome.at("unsettled_reason").get<std::string>());
  print_remnants(result.at("analysis").at("remnants"));
  fmt::print("{} steps, {} particle-steps, {} on {} threads, |dL|/L {}\n", run.at("steps").dump(),
             magnitude(run.at("particle_steps").get<double>()),
             duration(run.at("wall_s").get<double>()), run.at("threads").dump(),
             run.at("dL_over_L").is_null() ? "-" : run.at("dL_over_L").dump());
  fmt::print("\nprovenance\n");
  print_leaves(result.at("provenance"), "", "  ");
}

void print(const json& r) {
  fmt::print("job {}\nstate: {}", r.at("hash").get<std::string>(),
             r.at("state").get<std::string>());
  if (r.at("wanted") != "run") fmt::print(" (wanted: {})", r.at("wanted").get<std::string>());
  fmt::print("; sweeps: {}", fmt::join(r.at("sweeps").get<std::vector<std::string>>(), ", "));
  if (r.at("priority") != 0) fmt::print("; priority {}", r.at("priority").dump());
  if (!r.at("wall_limit_s").is_null())
    fmt::print("; wall limit {}", duration(r.at("wall_limit_s").get<double>()));
  fmt::print("\n\nscene\n");
  print_leaves(r.at("scene"), "", "  ");
  if (!r.at("result").is_null())
    print_result(r.at("result"));
  else if (!r.at("progress").is_null())
    fmt::print("\nat {:.4g} of {:.4g} s, step {}, {} particle-steps\n",
               r.at("progress").at("time_s").get<double>(),
               r.at("progress").at("end_time_s").get<double>(), r.at("progress").at("step").dump(),
               magnitude(r.at("progress").at("particle_steps").get<double>()));
  if (!r.at("failure").is_null())
    fmt::print("\nfailure: {}\n", r.at("failure").value("message", "unreadable"));

  std::vector<std::vector<std::string>> rows = {
      {"started", "host", "worker", "ended", "because", "core-s", "peak MB", "message"}};
  const auto text = [](const json& value) {
    return value.is_null() ? std::string("-") : value.get<std::string>();
  };
  const auto number = [](const json& value, double unit) {
    return value.is_null() ? std::string("-") : fmt::format("{:.1f}", value.get<double>() / unit);
  };
  for (const json& a : r.at("attempts"))
    rows.push_back({text(a.at("started")), text(a.at("host")), text(a.at("worker")),
                    text(a.at("ended")), text(a.at("exit_reason")), number(a.at("core_seconds"), 1),
                    number(a.at("peak_memory_bytes"), 1e6),
                    a.at("message").is_null() ? "" : text(a.at("message"))});
  if (rows.size() > 1) fmt::print("\nattempts\n{}", text_table(rows));
  fmt::print("\nfiles in {}\n", r.at("directory").get<std::string>());
  for (const json& file : r.at("files"))
    fmt::print("  {:<28} {:>9}B\n",
               fs::path(file.at("path").get<std::string>()).filename().string(),
               magnitude(file.at("bytes").get<double>()));
}

int draw(const ShowArguments& a) {
  const json drawn = draw_pictures(a.pictures, folder_of(a.database, a.job).path);
  fmt::print("{}", a.json ? drawn.dump(1) + "\n" : pictures_text(drawn));
  return static_cast<int>(ExitCode::done);
}

int show(const ShowArguments& a) {
  if (a.pictures.wanted()) return draw(a);
  if (is_folder(a.job))
    throw InputError(
        fmt::format("JOB = {}: of a folder only pictures are shown; for example -o panels.svg, "
                    "--movie film.mp4",
                    a.job));
  const db::Connection connection(a.database, db::Access::read);
  const json all = report(connection, find_job(connection, a.job));
  if (a.json)
    fmt::print("{}\n", all.dump(1));
  else
    print(all);
  return static_cast<int>(ExitCode::done);
}

}  // namespace

Action add_show(CLI::App& app) {
  auto a = std::make_shared<ShowArguments>();
  app.add_option("JOB", a->job,
                 "the first digits of the job's hash; for pictures also a folder with snapshots")
      ->required();
  add_database(app, a->database);
  add_pictures(app, a->pictures);
  add_json(app, a->json);
  return [a] { return show(*a); };
}

}  // namespace eerie::cli
