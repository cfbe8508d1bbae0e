#include "campaign/serve/site.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>

#include "campaign/job_folder/job_directory.hpp"
#include "campaign/job_folder/provenance.hpp"
#include "campaign/queries/find_job.hpp"
#include "campaign/serve/assets.hpp"
#include "campaign/serve/views/job_report.hpp"
#include "campaign/serve/views/jobs_json.hpp"
#include "campaign/serve/views/map_json.hpp"
#include "campaign/serve/views/overview.hpp"
#include "campaign/serve/views/particles.hpp"
#include "db/store/error.hpp"
#include "solver/base/error.hpp"

namespace eerie::serve {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// No such address.
struct NotFound {};

db::MapFilter map_filter(const Parameters& p) {
  db::MapFilter filter;
  filter.q = number(p, "q"), filter.phi_d_deg = number(p, "phi_d");
  filter.settings = whole_number(p, "settings");
  return filter;
}

constexpr auto of_map = "q phi_d settings";
constexpr auto of_cell = "q phi_d settings v theta";
constexpr auto of_jobs =
    "q phi_d v theta class fidelity sweep eer state settings hash where sort limit offset";

struct View {
  const char* name;
  const char* parameters;
  Reply (*make)(const db::Connection&, const Parameters&);
};
constexpr View views[] = {
    {"campaign", "", [](auto& c, const Parameters&) { return json_reply(campaign_json(c)); }},
    {"timeline", "", [](auto& c, const Parameters&) { return json_reply(timeline_json(c)); }},
    {"maps", "", [](auto& c, const Parameters&) { return json_reply(map_names_json(c)); }},
    {"map", of_map,
     [](auto& c, const Parameters& p) { return json_reply(map_json(c, map_filter(p))); }},
    {"ridge", of_map,
     [](auto& c, const Parameters& p) { return json_reply(ridge_json(c, map_filter(p))); }},
    {"cell", of_cell,
     [](auto& c, const Parameters& p) { return json_reply(cell_jobs_json(c, p)); }},
    {"jobs", of_jobs, [](auto& c, const Parameters& p) { return json_reply(jobs_json(c, p)); }},
    {"jobs.csv", of_jobs,
     [](auto& c, const Parameters& p) {
       return Reply{
           .type = "text/csv; charset=utf-8", .body = jobs_csv(c, p), .file_name = "jobs.csv"};
     }},
};

/// Of this thread.
std::chrono::nanoseconds processor_time() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return std::chrono::seconds(now.tv_sec) + std::chrono::nanoseconds(now.tv_nsec);
}

std::string key_of(const std::string& name, const Parameters& parameters) {
  std::string key = name;
  for (const auto& [one, value] : parameters) key += '\n' + one + '=' + value;
  return key;
}

/// The log from a place on, a piece of it at most: {"text", "next", "size"}.
Reply log_reply(const job_folder::JobDirectory& directory, std::int64_t from) {
  constexpr std::int64_t piece = 1 << 18;
  std::ifstream in(directory.log(), std::ios::binary | std::ios::ate);
  const std::int64_t size = in ? static_cast<std::int64_t>(in.tellg()) : 0;
  if (from < 0 || from > size) from = std::max<std::int64_t>(0, size - piece);  // made anew
  std::string text(static_cast<std::size_t>(std::min(piece, size - from)), '\0');
  in.seekg(from);
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  return json_reply(
      {{"text", text}, {"next", from + static_cast<std::int64_t>(text.size())}, {"size", size}});
}

Reply job_reply(const db::Connection& connection, const db::Job& job) {
  json report = job_report(connection, job);
  report["leaves"] = scene_leaves(report.at("scene"));
  report["snapshots"] =
      snapshots_json(job_folder::job_folder(connection).of(job.hash)).at("snapshots");
  return json_reply(report);
}

Reply guarded(const std::function<Reply()>& body) {
  try {
    return body();
  } catch (const NotFound&) {
    return refusal(404, "there is nothing at this address");
  } catch (const InputError& error) {
    return refusal(400, error.what());
  } catch (const std::exception& error) {
    // db::Error, EnvironmentError and whatever the system's libraries throw.
    return refusal(503, error.what());
  }
}

constexpr std::array pages = {"/", "/campaign", "/map", "/jobs", "/compare"};

}  // namespace

Site::Site(fs::path database, bool read_only, Events& events)
    : database_(std::move(database)), read_only_(read_only), events_(events) {}

Reply Site::answer(const std::string& path, const Parameters& parameters) {
  return guarded([&]() -> Reply {
    if (path.starts_with("/api/job/")) return of_job(path.substr(9), parameters);
    if (path.starts_with("/api/")) return api(path.substr(5), parameters);
    if (path.starts_with("/page/")) return page_file(path.substr(6));
    if (path.starts_with("/job/") || std::ranges::find(pages, path) != pages.end())
      return page_file("index.html");
    throw NotFound{};
  });
}

Reply Site::api(const std::string& name, const Parameters& parameters) {
  if (name == "about" || name == "news") require_known(parameters, "");
  if (name == "news") return {.body = events_.latest()};
  if (name == "about") {
    const job_folder::Provenance source = job_folder::provenance();
    return json_reply({{"database", fs::absolute(database_).filename().string()},
                       {"path", fs::absolute(database_).string()},
                       {"read_only", read_only_},
                       {"version", source.version},
                       {"commit", source.commit}});
  }
  const auto* view = std::ranges::find(views, name, &View::name);
  if (view == std::end(views)) throw NotFound{};
  require_known(parameters, view->parameters);
  const auto make = [&] {
    const auto before = processor_time();
    Reply reply = view->make(db::Connection(database_, db::Access::read), parameters);
    events_.note_cost(processor_time() - before);
    return reply;
  };
  // A table of all jobs may be large, and is asked for once.
  if (name == "jobs.csv") return make();
  return cache_.reply(events_.generation(), key_of(name, parameters), make);
}

Reply Site::of_job(const std::string& address, const Parameters& parameters) {
  const std::size_t slash = address.find('/');
  const std::string what = slash == std::string::npos ? "" : address.substr(slash + 1);
  require_known(parameters, what == "log" ? "from" : what == "particles" ? "snapshot" : "");
  const db::Connection connection(database_, db::Access::read);
  const db::Job job = queries::find_job(connection, address.substr(0, slash));
  if (what.empty()) return job_reply(connection, job);
  const job_folder::JobDirectory directory = job_folder::job_folder(connection).of(job.hash);
  if (what == "history") return json_reply(history_json(connection, job));
  if (what == "snapshots") return json_reply(snapshots_json(directory));
  if (what == "log") return log_reply(directory, whole_number(parameters, "from").value_or(0));
  if (what == "particles")
    return {.type = "application/octet-stream",
            .body = particles(directory, word(parameters, "snapshot"))};
  throw NotFound{};
}

Reply Site::page_file(const std::string& name) const {
  const Asset* asset = asset_named(name);
  if (asset == nullptr) throw NotFound{};
  return {.type = std::string(type_of(*asset)),
          .body = std::string(asset->text),
          .etag = etag_of(*asset)};
}

}  // namespace eerie::serve
