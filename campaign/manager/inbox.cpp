#include "campaign/manager/inbox.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <thread>

#include "campaign/text/json_file.hpp"
#include "db/jobs/control.hpp"
#include "db/store/error.hpp"
#include "db/store/lock.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "solver/base/kill_point.hpp"

namespace eerie::manager {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

std::vector<fs::path> files(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code missing;
  for (const auto& entry : fs::directory_iterator(folder, missing))
    if (entry.path().extension() == ".json" && entry.path().filename().string().front() != '.')
      found.push_back(entry.path());
  std::ranges::sort(found);  // ids sort by time
  return found;
}

/// A manager that has just begun may still be making the database.
std::optional<std::string> answer_in(const fs::path& database, const std::string& id) {
  try {
    return db::answer(db::Connection(database, db::Access::read), id);
  } catch (const db::Error&) {
    return std::nullopt;
  }
}

void refuse(const fs::path& file, const char* why) {
  spdlog::warn("event=request-refused file={} reason=\"{}\"", file.string(), why);
  std::error_code ignored;
  fs::rename(file, file.string() + ".refused", ignored);
}

}  // namespace

Inbox::Inbox(const fs::path& database) : folder_(database.string() + ".inbox") {}

void Inbox::put(const Request& request) const {
  std::error_code problem;
  fs::create_directories(folder_, problem);
  if (problem)
    throw EnvironmentError(fmt::format("cannot make {}: {}", folder_.string(), problem.message()));
  install_text(folder_ / (request.id + ".json"), to_json(request).dump() + "\n");
}

std::size_t Inbox::take(db::Connection& connection) const {
  std::size_t count = 0;
  for (const fs::path& file : files(folder_)) {
    try {
      const Request request = parse_request(text::load_json(file), file.string());
      if (request.id != file.stem()) throw InputError("its id is not its name");
      const json answer = apply(connection, request);
      // Also an answer that says no is kept, for whoever waits for it.
      db::once(connection, request.id, request.kind, [&](auto&) { return answer.dump(); });
      spdlog::info("event=request id={} kind={} answer={}", request.id, request.kind,
                   answer.dump());
      kill_point("inbox.before-remove");
      fs::remove(file);
      ++count;
    } catch (const InputError& error) {
      refuse(file, error.what());
    }
  }
  return count;
}

bool Inbox::is_empty() const { return files(folder_).empty(); }

std::optional<json> send(const fs::path& database, const Request& request,
                         std::chrono::milliseconds patience) {
  const auto deadline = std::chrono::steady_clock::now() + patience;
  const Inbox inbox(database);
  for (bool put = false;; put = true) {
    try {
      const db::Lock lock(database);
      db::Connection connection(database, db::Access::write);
      inbox.take(connection);  // also ours, where the one it was meant for has gone
      if (const auto text = db::answer(connection, request.id)) return json::parse(*text);
      return apply(connection, request);
    } catch (const db::LockedError&) {
      if (!put) inbox.put(request);
    }
    if (const auto text = answer_in(database, request.id)) return json::parse(*text);
    if (std::chrono::steady_clock::now() > deadline) return std::nullopt;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

}  // namespace eerie::manager
