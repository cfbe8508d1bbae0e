#include "campaign/serve/views/jobs_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "campaign/queries/filter.hpp"
#include "campaign/results/view_tables.hpp"
#include "db/store/column_meanings.hpp"
#include "db/views/view.hpp"
#include "solver/base/error.hpp"

namespace eerie::serve {
using nlohmann::json;

namespace {

constexpr auto view = db::View::all_jobs;

/// What makes one job another: shown where it differs.
const std::vector<std::string> parameter_columns = {
    "q",        "phi_d_deg", "v_imp_cm_per_s", "theta_imp_deg", "fidelity", "particles_per_target",
    "settings", "seed",      "end_time_s",     "wanted",        "priority"};
const std::vector<std::string> outcome_columns = {
    "class", "b_over_a", "m_lr_over_m_total", "period_h", "n_eer", "settled", "stale", "wall_s"};

db::ViewQuery query_of(const db::Connection& connection, const Parameters& p) {
  queries::Filter a;
  a.q = number(p, "q"), a.phi_d_deg = number(p, "phi_d");
  a.v = word(p, "v"), a.theta = word(p, "theta");
  a.outcome_class = word(p, "class"), a.fidelity = word(p, "fidelity");
  a.sweep = word(p, "sweep"), a.eer = word(p, "eer") == "1";
  for (const char* column : {"state", "settings", "hash"})
    if (const std::string value = word(p, column); !value.empty())
      a.where.push_back(fmt::format("{}={}", column, value));
  for (auto [at, end] = p.equal_range("where"); at != end; ++at)
    if (!at->second.empty()) a.where.push_back(at->second);
  db::ViewQuery query = queries::filtered(connection, view, a);
  query.sort = queries::parse_sort(word(p, "sort"), view, db::columns(connection, view));
  return query;
}

std::int64_t bounded(const Parameters& p, const std::string& name, std::int64_t usual,
                     std::int64_t most) {
  const std::int64_t value = whole_number(p, name).value_or(usual);
  if (value < 0 || value > most)
    throw InputError(fmt::format("{} = {}: must be from 0 to {}", name, value, most));
  return value;
}

/// The columns of the page, of a query that finds these.
std::vector<std::string> shown(const db::ViewSummary& found) {
  std::vector<std::string> columns = {"hash", "state"};
  for (const std::string& column : parameter_columns)
    if (std::ranges::count(found.differing, column) > 0) columns.push_back(column);
  columns.insert(columns.end(), outcome_columns.begin(), outcome_columns.end());
  return columns;
}

json column_json(const std::string& name) {
  const db::ColumnMeaning* known = db::meaning_of(view, name);
  return {{"name", name},
          {"unit", db::unit_of(view, name)},
          {"meaning", known != nullptr ? known->meaning : ""}};
}

}  // namespace

json jobs_json(const db::Connection& connection, const Parameters& p) {
  db::ViewQuery query = query_of(connection, p);
  const db::ViewSummary found = db::summary(connection, query, parameter_columns);
  query.limit = bounded(p, "limit", 50, 1000);
  query.offset = bounded(p, "offset", 0, std::int64_t{1} << 40);
  query.columns = shown(found);
  const std::size_t visible = query.columns.size();
  for (const std::string& column : parameter_columns)
    if (std::ranges::count(query.columns, column) == 0) query.columns.push_back(column);
  const json records = text::records(results::plain_table(db::rows(connection, query)));
  json page = {{"total", found.rows},
               {"columns", json::array()},
               {"shared", json::array()},
               {"rows", json::array()}};
  for (std::size_t k = 0; k < query.columns.size(); ++k) {
    json column = column_json(query.columns[k]);
    if (k < visible) {
      page["columns"].push_back(std::move(column));
    } else if (!records.empty()) {
      column["value"] = records.front().at(query.columns[k]);
      page["shared"].push_back(std::move(column));
    }
  }
  for (const json& record : records) {
    json& row = page["rows"].emplace_back(json::array());
    for (std::size_t k = 0; k < visible; ++k) row.push_back(record.at(query.columns[k]));
  }
  return page;
}

std::string jobs_csv(const db::Connection& connection, const Parameters& p) {
  db::ViewQuery query = query_of(connection, p);
  query.columns = shown(db::summary(connection, query, parameter_columns));
  return text::csv(results::plain_table(db::rows(connection, query)));
}

json cell_jobs_json(const db::Connection& connection, const Parameters& p) {
  for (const char* name : {"q", "phi_d", "v", "theta", "settings"})
    if (!number(p, name))
      throw InputError(fmt::format("{}: must be given, to name a cell of a map", name));
  db::ViewQuery query = query_of(connection, p);
  query.columns = {"hash",
                   "state",
                   "seed",
                   "fidelity",
                   "particles_per_target",
                   "class",
                   "b_over_a",
                   "m_lr_over_m_total",
                   "period_h",
                   "n_eer",
                   "settled",
                   "stale"};
  query.limit = 1000;
  return {{"jobs", text::records(results::plain_table(db::rows(connection, query)))}};
}

}  // namespace eerie::serve
