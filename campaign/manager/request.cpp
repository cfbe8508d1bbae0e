#include "campaign/manager/request.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <random>
#include <set>

#include "campaign/manager/requests/extend.hpp"
#include "campaign/sweeps/plan.hpp"
#include "campaign/sweeps/sweep.hpp"
#include "campaign/text/json_file.hpp"
#include "db/jobs/control.hpp"
#include "db/jobs/jobs.hpp"
#include "db/store/error.hpp"
#include "solver/base/error.hpp"

namespace eerie::manager {
using nlohmann::json;

namespace {

constexpr std::int64_t most_priority = 1'000'000;
constexpr const char* priority_range = "between -1000000 and 1000000";
constexpr double longest_limit_s = 1e9;

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

InputError wrong(const std::string& key, const json& value, const char* wanted) {
  constexpr std::size_t longest = 60;
  std::string text = value.dump();
  if (text.size() > longest) text = text.substr(0, longest) + "...";
  return InputError(fmt::format("{} = {}: must be {}", key, text, wanted));
}

/// The members of an object, each of which is taken once; what is left over is an error.
class Members {
 public:
  Members(const json& object, std::string where) : object_(object), where_(std::move(where)) {
    if (!object_.is_object()) throw wrong(where_, object_, "an object");
  }

  const json* take(const std::string& key) {
    const auto found = object_.find(key);
    if (found == object_.end()) return nullptr;
    taken_.insert(key);
    return &*found;
  }
  std::optional<std::string> text(const std::string& key) {
    const json* value = take(key);
    if (value == nullptr) return std::nullopt;
    if (!value->is_string()) throw wrong(key, *value, "a text");
    return value->get<std::string>();
  }
  std::optional<double> number(const std::string& key) {
    const json* value = take(key);
    if (value == nullptr) return std::nullopt;
    if (!value->is_number()) throw wrong(key, *value, "a number");
    return value->get<double>();
  }
  std::optional<db::Range> range(const std::string& key) {
    const json* value = take(key);
    if (value == nullptr) return std::nullopt;
    if (!value->is_array() || value->size() != 2 || !value->at(0).is_number() ||
        !value->at(1).is_number())
      throw wrong(key, *value, "two numbers");
    return db::Range{value->at(0).get<double>(), value->at(1).get<double>()};
  }
  std::string required_text(const std::string& key) {
    auto value = text(key);
    if (!value || value->empty()) throw InputError(fmt::format("{}: lacks \"{}\"", where_, key));
    return *std::move(value);
  }
  void require_nothing_left() const {
    for (const auto& member : object_.items())
      if (!taken_.contains(member.key()))
        throw InputError(fmt::format("{}: \"{}\" means nothing here", where_, member.key()));
  }

 private:
  const json& object_;
  std::string where_;
  std::set<std::string> taken_;
};

std::vector<std::string> hashes_of(const json& list) {
  if (!list.is_array() || list.empty() ||
      !std::ranges::all_of(list, [](const json& hash) { return hash.is_string(); }))
    throw wrong("hashes", list, "a list of texts");
  return list.get<std::vector<std::string>>();
}

db::Selection selection_of(const json* document) {
  if (document == nullptr) throw InputError("it lacks a selection");
  Members members(*document, "selection");
  db::Selection s;
  s.sweep = members.text("sweep");
  if (const json* list = members.take("hashes")) s.hashes = hashes_of(*list);
  s.q = members.number("q");
  s.phi_d_deg = members.number("phi_d_deg");
  s.v_imp_cm_per_s = members.range("v_imp_cm_per_s");
  s.theta_imp_deg = members.range("theta_imp_deg");
  const json* all = members.take("all");
  if (all != nullptr && *all != true) throw wrong("all", *all, "true");
  members.require_nothing_left();
  if (s.is_everything() == (all == nullptr))
    throw InputError(s.is_everything() ? "selection: says nothing; {\"all\": true} is every job"
                                       : "selection: says \"all\" and a condition");
  return s;
}

std::optional<int> priority_of(Members& members) {
  const json* value = members.take("priority");
  if (value == nullptr) return std::nullopt;
  if (!value->is_number_integer()) throw wrong("priority", *value, "a whole number");
  const auto wide = value->get<std::int64_t>();
  const bool is_huge =
      value->is_number_unsigned() && value->get<std::uint64_t>() > std::uint64_t{most_priority};
  if (is_huge || wide > most_priority || wide < -most_priority)
    throw wrong("priority", *value, priority_range);
  return static_cast<int>(wide);
}

json to_json(const db::Selection& s) {
  json document = json::object();
  if (s.is_everything()) document["all"] = true;
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
  const sweeps::Plan plan =
      sweeps::plan(text::parse_json(request.sweep, "submitted sweep"), {}, "submitted sweep");
  return json::parse(db::once(connection, request.id, request.kind, [&](SQLite::Database& sql) {
    const db::AddedSweep added = sweeps::store(sql, plan);
    if (request.priority || request.wall_limit_s)
      db::prepare_new_jobs(sql, added.sweep, request.priority, request.wall_limit_s);
    return json{{"sweep", added.label}, {"jobs", added.jobs}, {"added", added.added}}.dump();
  }));
}

json change(db::Connection& connection, const Request& request, const Change& one) {
  return json::parse(db::once(connection, request.id, request.kind, [&](SQLite::Database& sql) {
    return json{{"jobs", one.apply(sql, request)}}.dump();
  }));
}

}  // namespace

json to_json(const Request& r) {
  json document = {{"id", r.id}, {"kind", r.kind}};
  if (r.kind != "submit") document["selection"] = to_json(r.selection);
  if (!r.sweep.empty()) document["sweep"] = r.sweep;
  if (r.priority) document["priority"] = *r.priority;
  if (r.wall_limit_s)
    document["wall_limit_s"] = *r.wall_limit_s;
  else if (r.kind == "wall-limit")
    document["wall_limit_s"] = nullptr;  // none, which must be said
  if (r.until_s) document["until_s"] = *r.until_s;
  return document;
}

Request parse_request(const json& document, const std::string& where) {
  try {
    Members members(document, "request");
    Request r;
    r.id = members.required_text("id");
    r.kind = members.required_text("kind");
    const bool submits = r.kind == "submit";
    if (submits)
      r.sweep = members.required_text("sweep");
    else
      r.selection = selection_of(members.take("selection"));
    if (submits || r.kind == "priority") r.priority = priority_of(members);
    if (r.kind == "extend") r.until_s = members.number("until_s");
    if (r.kind == "wall-limit") {
      const json* limit = members.take("wall_limit_s");
      if (limit == nullptr) throw InputError("it lacks wall_limit_s: a number, or null for none");
      if (!limit->is_null()) r.wall_limit_s = members.number("wall_limit_s");
    } else if (submits) {
      r.wall_limit_s = members.number("wall_limit_s");
    }
    members.require_nothing_left();
    require_usable(r);
    return r;
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: no request: {}", where, error.what()));
  }
}

void require_usable(const Request& r) {
  if (r.kind != "submit" && r.kind != "extend" &&
      std::ranges::none_of(changes, [&](const Change& c) { return c.kind == r.kind; }))
    throw InputError(fmt::format("there is no request of the kind \"{}\"", r.kind));
  if (r.kind == "priority" && !r.priority) throw InputError("it lacks a priority");
  if (r.kind == "extend" && !(r.until_s.value_or(0) > 0))
    throw InputError("it lacks until_s, a simulated time above 0 s");
  if (r.priority && std::abs(std::int64_t{*r.priority}) > most_priority)
    throw InputError(fmt::format("priority = {}: must be {}", *r.priority, priority_range));
  if (r.wall_limit_s && !(*r.wall_limit_s > 0 && *r.wall_limit_s <= longest_limit_s))
    throw InputError(fmt::format("wall_limit_s = {:g}: must be above 0 and at most {:g}",
                                 *r.wall_limit_s, longest_limit_s));
  db::require_usable(r.selection);
}

std::string new_request_id() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return fmt::format("{:020d}-{}-{:08x}", std::chrono::nanoseconds(now).count(), ::getpid(),
                     std::random_device{}());
}

json apply(db::Connection& connection, const Request& request) {
  try {
    require_usable(request);
    if (request.kind == "submit") return submit(connection, request);
    if (request.kind == "extend") return extend(connection, request);
    const auto* one =
        std::ranges::find_if(changes, [&](const Change& c) { return c.kind == request.kind; });
    return change(connection, request, *one);
  } catch (const db::TemporaryError&) {
    throw;
  } catch (const db::GoneError&) {
    throw;
  } catch (const std::exception& error) {  // whatever it is, it is this request's own trouble
    return {{"error", error.what()}};
  }
}

}  // namespace eerie::manager
