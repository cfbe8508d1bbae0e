#include "campaign/job_folder/job_directory.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>

#include "campaign/text/json_file.hpp"
#include "db/store/settings.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "solver/base/files/folders.hpp"

namespace eerie::job_folder {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {
constexpr const char* folder_key = "jobs_folder";
}

fs::path JobDirectory::shared_bodies() const {
  // With a slash at its end, which lexically_normal() keeps, "." has a folder above it, too.
  const fs::path whole = fs::absolute(path / "").lexically_normal();
  return JobFolder{whole.parent_path().parent_path()}.bodies();
}

JobFolder job_folder(const db::Connection& connection) {
  if (const auto chosen = db::setting(connection, folder_key)) return {*chosen};
  return {fs::path(connection.path().string() + ".jobs")};
}

void require_usable(const fs::path& root) {
  make_folders(root);
  std::error_code ignored;
  for (const fs::path& left : half_written_files(root)) fs::remove(left, ignored);
  const fs::path probe = root / fmt::format(".probe.{}.tmp", ::getpid());
  const int descriptor = ::open(probe.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  const int reason = errno;
  if (descriptor >= 0) {
    ::close(descriptor);
    ::unlink(probe.c_str());
    return;
  }
  const std::string text = fmt::format("the folder of job directories {} cannot be written to: {}",
                                       root.string(), std::strerror(reason));
  if (reason == ENOSPC || reason == EDQUOT) throw DiskFullError(text);
  throw EnvironmentError(text);
}

void require_usable(const JobDirectory& directory) {
  make_folders(directory.path);
  std::error_code problem;
  for (const fs::directory_entry& entry : fs::directory_iterator(directory.path, problem))
    require_file(entry.path());
  if (problem)
    throw EnvironmentError(
        fmt::format("{} cannot be read: {}", directory.path.string(), problem.message()));
}

void require_file(const fs::path& path) {
  std::error_code problem;
  const auto type = fs::status(path, problem).type();
  if (type != fs::file_type::not_found && type != fs::file_type::regular)
    throw EnvironmentError(
        fmt::format("{} is in the way: it is no file; remove it", path.string()));
}

void choose_job_folder(db::Connection& connection, const fs::path& root) {
  const fs::path chosen = fs::absolute(root).lexically_normal();
  const fs::path present = fs::absolute(job_folder(connection).root).lexically_normal();
  if (chosen == present) return;
  std::error_code ignored;
  if (fs::equivalent(chosen, present, ignored)) return;
  if (fs::exists(present, ignored) && !fs::is_empty(present, ignored))
    throw InputError(fmt::format(
        "--jobs-dir = {}: the job directories of {} lie in {}; leave the option out, or move them "
        "and change the row 'jobs_folder' of the table settings",
        root.string(), connection.path().string(), present.string()));
  try {
    require_usable(chosen);
  } catch (const EnvironmentError& error) {
    throw InputError(
        fmt::format("--jobs-dir {}: {}; give another folder", root.string(), error.what()));
  }
  db::set(connection, folder_key, chosen.string());
}

json to_json(const WorkerProgress& p) {
  return {{"time_s", p.time_s},
          {"end_time_s", p.end_time_s},
          {"expected_end_s", p.expected_end_s},
          {"step", p.step},
          {"particle_steps", p.particle_steps},
          {"wall_s", p.wall_s},
          {"pid", p.pid}};
}

std::optional<WorkerProgress> read_progress(const JobDirectory& directory) {
  const auto document = read_json(directory.progress());
  if (!document || !document->is_object()) return std::nullopt;
  WorkerProgress p;
  // A field of another type means a foreign file; progress only feeds the display.
  try {
    document->at("time_s").get_to(p.time_s);
    document->at("end_time_s").get_to(p.end_time_s);
    p.expected_end_s = document->value("expected_end_s", p.end_time_s);
    text::read_whole(document->at("step"), p.step);
    document->at("particle_steps").get_to(p.particle_steps);
    document->at("wall_s").get_to(p.wall_s);
    text::read_whole(document->at("pid"), p.pid);
  } catch (const json::exception&) {
    return std::nullopt;
  }
  return p;
}

json to_json(const AttemptEnded& e) {
  return {{"exit_code", e.exit_code},
          {"core_seconds", e.core_seconds},
          {"peak_memory_bytes", e.peak_memory_bytes},
          {"host", e.host},
          {"pid", e.pid}};
}

std::optional<AttemptEnded> read_ended(const JobDirectory& directory) {
  const auto document = read_json(directory.ended());
  if (!document || !document->is_object()) return std::nullopt;
  AttemptEnded e;
  try {
    text::read_whole(document->at("exit_code"), e.exit_code);
    document->at("core_seconds").get_to(e.core_seconds);
    text::read_whole(document->at("peak_memory_bytes"), e.peak_memory_bytes);
    document->at("host").get_to(e.host);
    text::read_whole(document->at("pid"), e.pid);
  } catch (const json::exception&) {
    return std::nullopt;
  }
  return e;
}

json to_json(const Failure& f) {
  return {
      {"kind", f.kind}, {"step", f.step}, {"particle_id", f.particle_id}, {"message", f.message}};
}

std::optional<Failure> read_failure(const JobDirectory& directory) {
  const auto document = read_json(directory.failure());
  if (!document || !document->is_object()) return std::nullopt;
  Failure f;
  try {
    document->at("kind").get_to(f.kind);
    text::read_whole(document->at("step"), f.step);
    text::read_whole(document->at("particle_id"), f.particle_id);
    document->at("message").get_to(f.message);
  } catch (const json::exception&) {
    return std::nullopt;
  }
  return f;
}

std::optional<json> read_json(const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return std::nullopt;
  try {
    return text::load_json(path);
  } catch (const InputError&) {
    return std::nullopt;  // foreign, removed since, or a slip of a network file system
  }
}

}  // namespace eerie::job_folder
