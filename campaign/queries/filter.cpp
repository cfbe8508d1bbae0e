#include "campaign/queries/filter.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "analysis/remnants/outcome.hpp"
#include "campaign/queries/numbers.hpp"
#include "campaign/sweeps/fidelity.hpp"
#include "campaign/sweeps/scene_field.hpp"
#include "campaign/text/closest_names.hpp"
#include "db/store/bind.hpp"
#include "db/store/column_meanings.hpp"
#include "db/views/query.hpp"
#include "solver/base/error.hpp"

namespace eerie::queries {
namespace {

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, at);) {
    const std::size_t begin = part.find_first_not_of(' '), end = part.find_last_not_of(' ');
    parts.push_back(begin == std::string::npos ? "" : part.substr(begin, end - begin + 1));
  }
  return parts;
}

[[noreturn]] void refuse_column(const std::string& option, const std::string& column, db::View view,
                                const std::vector<db::ViewColumn>& known) {
  std::vector<std::string> names;
  names.reserve(known.size());
  for (const db::ViewColumn& one : known) names.push_back(one.name);
  throw InputError(fmt::format("{}: the view {} has no column \"{}\"; the closest are {}", option,
                               db::name(db::view_names, view), column,
                               text::closest_names(column, names)));
}

void require_column(const std::string& option, const std::string& column, db::View view,
                    const std::vector<db::ViewColumn>& known) {
  if (std::ranges::find(known, column, &db::ViewColumn::name) == known.end())
    refuse_column(option, column, view, known);
}

/// LO:HI with either end open, or one number; false where it is neither.
bool read_range(const std::string& value, db::Condition& c) {
  const std::size_t colon = value.find(':');
  const std::string low = value.substr(0, colon);
  const std::string high = colon == std::string::npos ? low : value.substr(colon + 1);
  if (!low.empty() && !(c.lo = finite_number(low))) return false;
  if (!high.empty() && !(c.hi = finite_number(high))) return false;
  return c.lo || c.hi;
}

/// The kind of a column that a condition may name, wherever it stands.
db::ColumnKind kind_of(const db::Connection& connection, db::View view, const std::string& name) {
  for (const db::View one : {view, db::View::results})
    for (const db::ViewColumn& column : db::columns(connection, one))
      if (column.name == name) return db::kind_of(one, column);
  return db::ColumnKind::word;
}

void require_fitting(const db::Connection& connection, db::View view, const db::Condition& c,
                     const std::string& option) {
  if (!db::is_condition_column(connection, view, c.column)) {
    std::vector<db::ViewColumn> known = db::columns(connection, view);
    const std::vector<db::ViewColumn> of_results = db::columns(connection, db::View::results);
    const bool results_have_it =
        std::ranges::find(of_results, c.column, &db::ViewColumn::name) != of_results.end();
    if (results_have_it)
      throw InputError(
          fmt::format("{}: rows of the view {} are of several jobs and have no {}; "
                      "--of results has",
                      option, db::name(db::view_names, view), c.column));
    if (db::has_jobs(connection, view)) std::ranges::copy(of_results, std::back_inserter(known));
    refuse_column(option, c.column, view, known);
  }
  const db::ColumnKind kind = kind_of(connection, view, c.column);
  if (c.words.empty() || kind == db::ColumnKind::word) return;
  throw InputError(
      kind == db::ColumnKind::flag
          ? fmt::format("{0}: {1} is true or false; give {1}=true, {1}=false or {1}=none", option,
                        c.column)
          : fmt::format("{0}: {1} is a number; give one, LO:HI, LO:, :HI or none, for example "
                        "{1}=0:0.3",
                        option, c.column));
}

/// Of a column of words a number is a word too, and a flag may be spelled as JSON spells it.
void as_column(const db::Connection& connection, db::View view, db::Condition& c,
               const std::string& value) {
  if (c.empty) return;
  const db::ColumnKind kind = kind_of(connection, view, c.column);
  if (kind == db::ColumnKind::word) {
    c.lo = c.hi = std::nullopt;
    c.words = split(value, ',');
  } else if (kind == db::ColumnKind::flag && (value == "true" || value == "false")) {
    c.lo = c.hi = value == "true" ? 1 : 0;
    c.words.clear();
  }
}

std::vector<std::int64_t> sweeps_named(const db::Connection& connection, const std::string& name) {
  std::vector<std::int64_t> found;
  std::vector<std::string> names;
  for (const db::SweepStatus& sweep : db::sweep_status(connection)) {
    const bool is_first = sweep.label == sweep.name;
    if (sweep.name == name || sweep.label == name || (is_first && sweep.name + "@1" == name))
      found.push_back(sweep.id);
    names.push_back(sweep.label);
  }
  if (found.empty())
    throw InputError(
        fmt::format("--sweep {}: the database has no sweep of this name; it has {}", name,
                    names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "))));
  return found;
}

std::pair<std::string, std::string> name_and_value(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
    throw InputError(fmt::format(
        "--where {}: must be COLUMN=VALUE or COLUMN=LO:HI; for example --where b_over_a=0:0.3",
        text));
  const bool negated = text[equals - 1] == '!';
  return {text.substr(0, equals - (negated ? 1 : 0)), text.substr(equals + 1)};
}

}  // namespace

db::Condition parse_condition(const std::string& text) {
  const auto [column, value] = name_and_value(text);
  db::Condition c{.column = column};
  c.negated = text[column.size()] == '!';
  if (value == "none") {
    c.empty = true;
  } else if (!read_range(value, c)) {
    c.lo = c.hi = std::nullopt;
    c.words = split(value, ',');
  }
  if (c.lo && c.hi && *c.hi < *c.lo)
    throw InputError(fmt::format("--where {}: LO is greater than HI; swap them", text));
  return c;
}

db::ViewQuery filtered(const db::Connection& connection, db::View view, const Filter& a) {
  db::ViewQuery query{.view = view};
  const auto add = [&](db::Condition c, const std::string& option) {
    require_fitting(connection, view, c, option);
    query.conditions.push_back(std::move(c));
  };
  const auto range = [&](const char* column, const std::string& text, const char* option) {
    if (text.empty()) return;
    const db::Range r = parse_range(text, option);
    add({.column = column, .lo = r.lo, .hi = r.hi}, option);
  };
  if (a.q) add({.column = "q", .lo = a.q, .hi = a.q}, "--q");
  if (a.phi_d_deg) add({.column = "phi_d_deg", .lo = a.phi_d_deg, .hi = a.phi_d_deg}, "--phi-d");
  range("v_imp_cm_per_s", a.v, "--v");
  range("theta_imp_deg", a.theta, "--theta");
  if (!a.outcome_class.empty()) {
    if (!remnants::outcome_named(a.outcome_class)) {
      std::vector<std::string_view> names;
      names.reserve(std::size(remnants::outcome_names));
      for (const remnants::OutcomeName& entry : remnants::outcome_names)
        names.push_back(entry.name);
      throw InputError(
          fmt::format("--class {}: must be one of {}", a.outcome_class, fmt::join(names, ", ")));
    }
    add({.column = "class", .words = {a.outcome_class}}, "--class");
  }
  if (!a.fidelity.empty()) {
    sweeps::overrides_of_fidelity(a.fidelity);  // throws for a name that is none
    add({.column = "fidelity", .words = {a.fidelity}}, "--fidelity");
  }
  if (a.eer) {
    // Of remnants each is one or not; impacts and points count theirs.
    if (view == db::View::remnants)
      add({.column = "eer", .lo = 1}, "--eer");
    else
      add({.column = "n_eer", .lo = 1e-9}, "--eer");
  }
  for (const std::string& text : a.where) {
    db::Condition c = parse_condition(text);
    as_column(connection, view, c, name_and_value(text).second);
    add(std::move(c), "--where " + text);
  }
  if (a.sweep.empty()) return query;
  if (!db::has_jobs(connection, view))
    throw InputError(
        fmt::format("--sweep {}: rows of the view {} belong to no single job; use "
                    "--of results or --of remnants",
                    a.sweep, db::name(db::view_names, view)));
  query.sweeps = sweeps_named(connection, a.sweep);
  return query;
}

std::vector<db::SortKey> parse_sort(const std::string& text, db::View view,
                                    const std::vector<db::ViewColumn>& known) {
  std::vector<db::SortKey> keys;
  for (const std::string& word : split(text, ',')) {
    const bool descending = word.starts_with('-');
    keys.push_back({descending ? word.substr(1) : word, descending});
    require_column("--sort " + text, keys.back().column, view, known);
  }
  return keys;
}

std::vector<std::string> parse_columns(const std::string& text, db::View view,
                                       const std::vector<db::ViewColumn>& known) {
  std::vector<std::string> names = split(text, ',');
  for (auto name = names.begin(); name != names.end(); ++name) {
    require_column("--columns " + text, *name, view, known);
    if (std::find(names.begin(), name, *name) != name)
      throw InputError(
          fmt::format("--columns {}: {} stands twice; remove one of them", text, *name));
  }
  return names;
}

}  // namespace eerie::queries
