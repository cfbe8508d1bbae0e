#include "campaign/manager/request.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <random>

#include "campaign/sweeps/plan.hpp"
#include "campaign/sweeps/sweep.hpp"
#include "db/jobs/control.hpp"
#include "db/jobs/jobs.hpp"
#include "solver/base/error.hpp"

namespace eerie::manager {
using nlohmann::json;

namespace {

/// Kinds that change selected jobs, and what they do.
struct Change {
  const char* kind;
  std::size_t (*apply)(SQLite::Database&, const Request&);
};
constexpr Change changes[] = {
    {"pause", [](auto& sql, const Request& r) { return db::pause(sql, r.selection); }},
    {"resume", [](auto& sql, const Request& r) { return db::resume(sql, r.selection); }},
    {"cancel", [](auto& sql, const Request& r) { return db::cancel(sql, r.selection); }},
    {"retry", [](auto& sql, const Request& r) { return db::retry(sql, r.selection); }},
    {"rerun-stale", [](auto& sql, const Request& r) { return db::rerun_stale(sql, r.selection); }},
    {"priority",
     [](auto& sql, const Request& r) {
       return db::set_priority(sql, r.selection, r.priority.value_or(0));
     }},
    {"wall-limit",
     [](auto& sql, const Request& r) {
       return db::set_wall_limit(sql, r.selection, r.wall_limit_s);
     }},
};

json range_json(const db::Range& range) { return {range.lo, range.hi}; }

template <class T>
void take(const json& document, const char* key, std::optional<T>& value) {
  if (document.contains(key)) value = document.at(key).get<T>();
}
void take(const json& document, const char* key, std::optional<db::Range>& value) {
  if (document.contains(key))
    value = db::Range{document.at(key).at(0).get<double>(), document.at(key).at(1).get<double>()};
}

db::Selection selection_of(const json& document) {
  db::Selection s;
  take(document, "sweep", s.sweep);
  if (document.contains("hashes")) document.at("hashes").get_to(s.hashes);
  take(document, "q", s.q);
  take(document, "phi_d_deg", s.phi_d_deg);
  take(document, "v_imp_cm_per_s", s.v_imp_cm_per_s);
  take(document, "theta_imp_deg", s.theta_imp_deg);
  return s;
}

json to_json(const db::Selection& s) {
  json document = json::object();
  if (s.sweep) document["sweep"] = *s.sweep;
  if (!s.hashes.empty()) document["hashes"] = s.hashes;
  if (s.q) document["q"] = *s.q;
  if (s.phi_d_deg) document["phi_d_deg"] = *s.phi_d_deg;
  if (s.v_imp_cm_per_s) document["v_imp_cm_per_s"] = range_json(*s.v_imp_cm_per_s);
  if (s.theta_imp_deg) document["theta_imp_deg"] = range_json(*s.theta_imp_deg);
  return document;
}

/// Adds the sweep; its new jobs get the priority and the limit.
json submit(db::Connection& connection, const Request& request) {
  // Expanding takes seconds for a hundred thousand jobs: before the transaction.
  const sweeps::Plan plan = sweeps::plan(json::parse(request.sweep), {}, "submitted sweep");
  return json::parse(db::once(connection, request.id, request.kind, [&](SQLite::Database& sql) {
    const db::AddedSweep added = sweeps::store(sql, plan);
    if (request.priority || request.wall_limit_s)
      db::prepare_new_jobs(sql, added.sweep, request.priority, request.wall_limit_s);
    return json{{"sweep", plan.sweep.name}, {"jobs", added.jobs}, {"added", added.added}}.dump();
  }));
}

json change(db::Connection& connection, const Request& request, const Change& one) {
  return json::parse(db::once(connection, request.id, request.kind, [&](SQLite::Database& sql) {
    return json{{"jobs", one.apply(sql, request)}}.dump();
  }));
}

}  // namespace

json to_json(const Request& r) {
  json document = {{"id", r.id}, {"kind", r.kind}, {"selection", to_json(r.selection)}};
  if (!r.sweep.empty()) document["sweep"] = r.sweep;
  if (r.priority) document["priority"] = *r.priority;
  if (r.wall_limit_s) document["wall_limit_s"] = *r.wall_limit_s;
  return document;
}

Request parse_request(const json& document, const std::string& where) {
  try {
    Request r;
    document.at("id").get_to(r.id);
    document.at("kind").get_to(r.kind);
    r.selection = selection_of(document.at("selection"));
    if (document.contains("sweep")) document.at("sweep").get_to(r.sweep);
    take(document, "priority", r.priority);
    take(document, "wall_limit_s", r.wall_limit_s);
    return r;
  } catch (const json::exception& error) {
    throw InputError(fmt::format("{}: no request: {}", where, error.what()));
  }
}

std::string new_request_id() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return fmt::format("{:020d}-{}-{:08x}", std::chrono::nanoseconds(now).count(), ::getpid(),
                     std::random_device{}());
}

json apply(db::Connection& connection, const Request& request) {
  try {
    if (request.kind == "submit") return submit(connection, request);
    const auto* one =
        std::ranges::find_if(changes, [&](const Change& c) { return c.kind == request.kind; });
    if (one == std::end(changes))
      throw InputError(fmt::format("there is no request of the kind \"{}\"", request.kind));
    return change(connection, request, *one);
  } catch (const InputError& error) {
    return {{"error", error.what()}};
  } catch (const json::exception& error) {
    return {{"error", error.what()}};
  }
}

}  // namespace eerie::manager
