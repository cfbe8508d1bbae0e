#include "campaign/serve/actions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "campaign/manager/inbox.hpp"
#include "campaign/manager/request.hpp"
#include "campaign/sweeps/sweep.hpp"
#include "campaign/text/json_file.hpp"
#include "db/jobs/control.hpp"
#include "db/store/error.hpp"
#include "db/store/lock.hpp"
#include "solver/base/error.hpp"

namespace eerie::serve {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr std::array kinds = {"submit", "pause",    "resume",     "cancel",
                              "retry",  "priority", "rerun-stale"};
constexpr auto patience = std::chrono::seconds(4);

void require_known(const std::string& kind) {
  if (std::ranges::find(kinds, kind) == kinds.end())
    throw InputError(
        fmt::format("kind = {}: must be one of submit, pause, resume, cancel, retry, "
                    "priority, rerun-stale",
                    kind));
}

void require_complete(const manager::Request& request) {
  for (const std::string& hash : request.selection.hashes)
    if (hash.size() < 4 || hash.size() > 64 ||
        hash.find_first_not_of("0123456789abcdef") != std::string::npos)
      throw InputError(fmt::format("hash = {}: must be 4 to 64 digits 0-9, a-f", hash));
  // Mistakes in a sweep are told here and now.
  if (request.kind == "submit")
    sweeps::expand(sweeps::parse_sweep(text::parse_json(request.sweep, "sweep"), {}, "sweep"));
}

/// The page says "all" beside the selection; the inbox has it within.
void put_all_into_selection(json& document) {
  if (document.value("kind", "") == "submit") return;
  json selection = document.value("selection", json::object());
  if (selection.is_object() && document.value("all", false)) selection["all"] = true;
  document.erase("all");
  document["selection"] = std::move(selection);
}

manager::Request request_of(const std::string& body) {
  json document = text::parse_json(body, "action");
  if (!document.is_object()) throw InputError("action: must be an object");
  try {
    require_known(document.value("kind", ""));
    put_all_into_selection(document);
  } catch (const json::exception& error) {
    throw InputError(fmt::format("action: {}", error.what()));
  }
  document["id"] = manager::new_request_id();
  const manager::Request request = manager::parse_request(document, "action");
  require_complete(request);
  return request;
}

std::optional<std::string> answer_in(const fs::path& database, const std::string& id) {
  return db::answer(db::Connection(database, db::Access::read_any), id);
}

}  // namespace

Reply act(const fs::path& database, const std::string& body) {
  const manager::Request request = request_of(body);
  // Without its database a request would wait for whichever comes to lie there.
  static_cast<void>(db::Connection(database, db::Access::read));
  manager::Inbox(database).put(request);
  if (!db::lock_holder(database))
    return json_reply({{"waits",
                        "nobody works on the database: whoever does next carries it out "
                        "(`eerie daemon`, or any command that asks something of it)"}},
                      202);
  const auto deadline = std::chrono::steady_clock::now() + patience;
  while (std::chrono::steady_clock::now() < deadline) {
    if (const auto text = answer_in(database, request.id)) {
      const json answer = json::parse(*text);
      return json_reply(answer, answer.contains("error") ? 400 : 200);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return json_reply({{"waits", "the manager at work is busy; it will do it"}}, 202);
}

}  // namespace eerie::serve
