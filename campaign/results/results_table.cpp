#include "campaign/results/results_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "campaign/job_folder/result_file.hpp"
#include "campaign/results/settings_choice.hpp"
#include "solver/base/text/shell_word.hpp"

namespace eerie::results {
using db::ResultRow;
using text::Column, text::Field, text::or_null, text::shown;

namespace {

Column parameter(const char* header, const char* unit = "") {
  return {.header = header, .unit_above = unit, .above = true};
}

Column dispensable(Column column, int order) {
  column.dispensable = order;
  return column;
}

/// "*": the largest remnant is an EER; "+": only smaller ones are.
std::string eer_mark(const db::Result& r) { return r.eer ? "*" : r.n_eer > 0 ? "+" : ""; }

const std::vector<Field<ResultRow>>& fields() {
  static const std::vector<Field<ResultRow>> all = {
      {parameter("q"), [](const ResultRow& r) { return r.q; }},
      {parameter("phi_d", " deg"), [](const ResultRow& r) { return r.phi_d_deg; }},
      {parameter("particles per target"),
       [](const ResultRow& r) { return r.particles_per_target; }},
      {parameter("scheme"), [](const ResultRow& r) { return r.scheme; }},
      {parameter("seed"), [](const ResultRow& r) { return r.seed; }},
      {parameter("end", " s"), [](const ResultRow& r) { return r.end_time_s; }},
      {shown("v cm/s"), [](const ResultRow& r) { return r.v_imp_cm_per_s; }},
      {shown("theta deg"), [](const ResultRow& r) { return r.theta_imp_deg; }},
      {shown("class"), [](const ResultRow& r) { return r.result.outcome_class; }},
      {shown(""), [](const ResultRow& r) { return r.result.settled ? "" : "~"; }},
      {dispensable(shown("M_lr/M", "{:.3f}"), 1),
       [](const ResultRow& r) { return r.result.m_lr_over_m_total; }},
      {shown("b/a", "{:.3f}"), [](const ResultRow& r) { return or_null(r.result.b_over_a); }},
      {dispensable(shown("c/a", "{:.3f}"), 3),
       [](const ResultRow& r) { return or_null(r.result.c_over_a); }},
      {dispensable(shown("period h", "{:.2f}"), 2),
       [](const ResultRow& r) { return or_null(r.result.period_h); }},
      {shown("EER"), [](const ResultRow& r) { return eer_mark(r.result); }},
      {shown("job"),
       [](const ResultRow& r) { return r.hash.substr(0, 8) + (r.stale ? " !" : ""); }}};
  return all;
}

struct Legend {
  bool (*occurs)(const ResultRow&);
  const char* text;
};
constexpr Legend legends[] = {
    {[](const ResultRow& r) { return r.result.eer; },
     "*  the largest remnant is extremely elongated (b/a < 0.3)\n"},
    {[](const ResultRow& r) { return !r.result.eer && r.result.n_eer > 0; },
     "+  a smaller remnant is extremely elongated\n"},
    {[](const ResultRow& r) { return !r.result.settled; },
     "~  not settled at the end: remnants will meet again; a later end.time_s tells\n"},
    {[](const ResultRow& r) { return r.stale; }, "!  made by another solver version\n"}};

std::set<std::int64_t> settings_of(const std::vector<ResultRow>& rows) {
  std::set<std::int64_t> ids;
  for (const ResultRow& row : rows) ids.insert(row.settings);
  return ids;
}

}  // namespace

text::Table results_table(const std::vector<ResultRow>& rows) {
  std::vector<Field<ResultRow>> shown_fields = fields();
  if (settings_of(rows).size() > 1)
    shown_fields.push_back({shown("settings"), [](const ResultRow& r) { return r.settings; }});
  return text::table_of(shown_fields, rows);
}

std::string legend_of(const std::vector<ResultRow>& rows) {
  std::string legend;
  for (const Legend& one : legends)
    if (std::ranges::any_of(rows, one.occurs)) legend += one.text;
  return legend;
}

std::string legend_of(const db::Connection& connection, const std::vector<ResultRow>& rows) {
  std::string legend = legend_of(rows);
  if (std::ranges::any_of(rows, &ResultRow::stale))
    legend += fmt::format("   `eerie retry --stale --all --db {}` repeats what is marked !\n",
                          shell_word(connection.path().string()));
  if (const std::set<std::int64_t> ids = settings_of(rows); ids.size() > 1)
    for (const auto& [settings, fields] : differences(connection, ids))
      legend += fmt::format("settings {}: {}\n", settings.id, fields);
  return legend;
}

std::string drift_warning(const db::Connection& connection, const std::vector<ResultRow>& rows) {
  const auto drifting = std::ranges::count_if(rows, [](const ResultRow& row) {
    return row.result.dL_over_L > job_folder::most_angular_momentum_drift;
  });
  if (drifting == 0) return "";
  return fmt::format(
      "{} of {} results changed their angular momentum by more than {:g} %; `eerie query --db {} "
      "--where dL_over_L={:g}:` shows them, docs/notebook/stability.md what to change",
      drifting, rows.size(), 100 * job_folder::most_angular_momentum_drift,
      shell_word(connection.path().string()), job_folder::most_angular_momentum_drift);
}

std::string drift_warning(const db::Connection& connection, const std::string& sweep_name) {
  std::vector<ResultRow> all;
  for (const db::SweepStatus& sweep : db::sweep_status(connection)) {
    if (sweep.name != sweep_name) continue;
    const std::vector<ResultRow> rows = db::results(connection, {.sweep = sweep.id});
    all.insert(all.end(), rows.begin(), rows.end());
  }
  return drift_warning(connection, all);
}

}  // namespace eerie::results
