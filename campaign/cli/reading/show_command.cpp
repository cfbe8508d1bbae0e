#include "campaign/cli/options/command_list.hpp"
#include "campaign/cli/options/particle_pictures.hpp"
#include "campaign/cli/output/outcome_tables.hpp"
#include "campaign/results/job_report.hpp"
#include "db/views/query.hpp"

namespace eerie::cli {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

struct ShowArguments {
  fs::path database;
  std::string job;
  PictureArguments pictures;
};

/// "material.rho0_kg_per_m3 = 2700", one line per leaf.
void add_leaves(Answer& answer, const json& object, const std::string& path) {
  for (const auto& [key, value] : object.items()) {
    const std::string here = path.empty() ? key : path + "." + key;
    if (value.is_object())
      add_leaves(answer, value, here);
    else
      answer.say("  {} = {}\n", here, value.dump());
  }
}

void add_result(Answer& answer, const json& result) {
  answer.say("\nresult: ");
  add_outcome(answer, result.at("analysis"));
  const json& run = result.at("run");
  answer.say("{} steps, {} particle-steps, {} on {} threads, |dL|/L {}\n", run.at("steps").dump(),
             magnitude(run.at("particle_steps").get<double>()),
             duration(run.at("wall_s").get<double>()), run.at("threads").dump(),
             run.at("dL_over_L").is_null() ? "-" : run.at("dL_over_L").dump());
  answer.say("\nprovenance\n");
  add_leaves(answer, result.at("provenance"), "");
}

void add_head(Answer& answer, const json& r) {
  std::string extra;
  for (const json& sweep : r.at("sweeps"))
    extra += (extra.empty() ? "; sweeps: " : ", ") + sweep.get<std::string>();
  if (r.at("priority") != 0) extra += "; priority " + r.at("priority").dump();
  if (!r.at("wall_limit_s").is_null())
    extra += "; wall limit " + duration(r.at("wall_limit_s").get<double>());
  const auto wanted = r.at("wanted").get<std::string>();
  answer.say("job {}\nstate: {}{}{}\n\nscene\n", r.at("hash").get<std::string>(),
             r.at("state").get<std::string>(),
             wanted == "run" ? "" : fmt::format(" (wanted: {})", wanted), extra);
  add_leaves(answer, r.at("scene"), "");
}

void add_progress(Answer& answer, const json& progress) {
  answer.say("\nat {:.4g} of {:.4g} s, step {}, {} particle-steps\n",
             progress.at("time_s").get<double>(), progress.at("end_time_s").get<double>(),
             progress.at("step").dump(), magnitude(progress.at("particle_steps").get<double>()));
}

/// The document for people.
Answer answer_of(json r, Table attempts) {
  Answer answer;
  add_head(answer, r);
  if (!r["result"].is_null())
    add_result(answer, r["result"]);
  else if (!r["progress"].is_null())
    add_progress(answer, r["progress"]);
  if (!r["failure"].is_null())
    answer.say("\nfailure: {}\n", r["failure"].value("message", "unreadable"));
  if (!attempts.rows.empty()) {
    answer.say("\nattempts\n");
    answer.add(std::move(attempts));
  }
  answer.say("\nfiles in {}\n", r["directory"].get<std::string>());
  Table files{{shown("file"), shown("size")}, {}};
  for (const json& file : r["files"])
    files.rows.push_back({fs::path(file["path"].get<std::string>()).filename().string(),
                          magnitude(file["bytes"].get<double>()) + "B"});
  answer.add(std::move(files));
  answer.data = std::move(r);
  return answer;
}

Answer show(const ShowArguments& a, Format format) {
  if (a.pictures.wanted())
    return draw_pictures(a.pictures, queries::folder_of(a.database, a.job).path, format);
  if (queries::is_folder(a.job))
    throw InputError(
        fmt::format("JOB = {}: of a folder only pictures are shown; for example -o panels.svg, "
                    "--movie film.mp4",
                    a.job));
  const db::Connection connection(a.database, db::Access::read);
  const db::Job job = queries::find_job(connection, a.job);
  return answer_of(results::job_report(connection, job),
                   results::table_of_attempts(db::attempts(connection, job.id)));
}

}  // namespace

Action add_show(CLI::App& app) {
  auto a = std::make_shared<ShowArguments>();
  app.add_option("JOB", a->job,
                 "the first digits of the job's hash; for pictures also a folder with snapshots")
      ->required();
  add_database(app, a->database);
  add_pictures(app, a->pictures);
  add_formats(app);
  return [a](Output& out) { return show(*a, out.format); };
}

}  // namespace eerie::cli
