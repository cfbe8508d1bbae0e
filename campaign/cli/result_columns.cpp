#include "campaign/cli/result_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "campaign/cli/text_table.hpp"
#include "campaign/csv.hpp"

namespace eerie::cli {
using db::ResultRow;
using nlohmann::json;

namespace {

struct Column {
  const char* name;
  json (*value)(const ResultRow&);
};

json or_null(const std::optional<double>& value) { return value ? json(*value) : json(); }
json text_or_null(const std::string& text) { return text.empty() ? json() : json(text); }

/// The one table of result columns, named as in the view `results`.
constexpr Column columns[] = {
    {"job", [](const ResultRow& r) { return json(r.job); }},
    {"hash", [](const ResultRow& r) { return json(r.hash); }},
    {"q", [](const ResultRow& r) { return json(r.q); }},
    {"phi_d_deg", [](const ResultRow& r) { return json(r.phi_d_deg); }},
    {"v_imp_cm_per_s", [](const ResultRow& r) { return json(r.v_imp_cm_per_s); }},
    {"theta_imp_deg", [](const ResultRow& r) { return json(r.theta_imp_deg); }},
    {"v_over_v_esc", [](const ResultRow& r) { return json(r.v_over_v_esc); }},
    {"particles_per_target", [](const ResultRow& r) { return json(r.particles_per_target); }},
    {"seed", [](const ResultRow& r) { return json(r.seed); }},
    {"end_time_s", [](const ResultRow& r) { return json(r.end_time_s); }},
    {"class", [](const ResultRow& r) { return json(r.result.outcome_class); }},
    {"m_lr_over_m_total", [](const ResultRow& r) { return json(r.result.m_lr_over_m_total); }},
    {"m_slr_over_m_total", [](const ResultRow& r) { return json(r.result.m_slr_over_m_total); }},
    {"b_over_a", [](const ResultRow& r) { return or_null(r.result.b_over_a); }},
    {"c_over_a", [](const ResultRow& r) { return or_null(r.result.c_over_a); }},
    {"period_h", [](const ResultRow& r) { return or_null(r.result.period_h); }},
    {"eer", [](const ResultRow& r) { return json(r.result.eer); }},
    {"n_eer", [](const ResultRow& r) { return json(r.result.n_eer); }},
    {"n_remnants", [](const ResultRow& r) { return json(r.result.n_remnants); }},
    {"settled", [](const ResultRow& r) { return json(r.result.settled); }},
    {"unsettled_reason", [](const ResultRow& r) { return json(r.result.unsettled_reason); }},
    {"dL_over_L", [](const ResultRow& r) { return or_null(r.result.dL_over_L); }},
    {"steps", [](const ResultRow& r) { return json(r.result.steps); }},
    {"particle_steps", [](const ResultRow& r) { return json(r.result.particle_steps); }},
    {"wall_s", [](const ResultRow& r) { return json(r.result.wall_s); }},
    {"threads", [](const ResultRow& r) { return json(r.result.threads); }},
    {"solver_version", [](const ResultRow& r) { return json(r.result.solver_version); }},
    {"host", [](const ResultRow& r) { return json(r.result.host); }},
    {"finished", [](const ResultRow& r) { return json(r.finished); }},
    {"stale", [](const ResultRow& r) { return json(r.stale); }},
    {"stale_reason", [](const ResultRow& r) { return text_or_null(r.stale_reason); }},
    {"fidelity", [](const ResultRow& r) { return text_or_null(r.fidelity); }},
    {"ended_at_s", [](const ResultRow& r) { return or_null(r.result.ended_at_s); }},
    {"end_reason", [](const ResultRow& r) { return text_or_null(r.result.end_reason); }},
};

std::string csv_field(const json& value) {
  if (value.is_null()) return "";
  if (!value.is_string())
    return value.is_boolean() ? (value.get<bool>() ? "1" : "0") : value.dump();
  const std::string text = value.get<std::string>();
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  return csv_quoted(text);
}

std::string number(const std::optional<double>& value, int digits) {
  return value ? fmt::format("{:.{}f}", *value, digits) : "-";
}

/// Parameters that belong to a row of the table only where they differ between rows.
struct Parameter {
  const char* header;
  double (*value)(const ResultRow&);
  const char* unit;
};
constexpr Parameter parameters[] = {
    {"q", [](const ResultRow& r) { return r.q; }, ""},
    {"phi_d", [](const ResultRow& r) { return r.phi_d_deg; }, " deg"},
    {"particles per target",
     [](const ResultRow& r) { return static_cast<double>(r.particles_per_target); }, ""},
    {"seed", [](const ResultRow& r) { return static_cast<double>(r.seed); }, ""},
    {"end", [](const ResultRow& r) { return r.end_time_s; }, " s"},
};

bool differs(const std::vector<ResultRow>& rows, const Parameter& parameter) {
  return std::any_of(rows.begin(), rows.end(), [&](const ResultRow& row) {
    return parameter.value(row) != parameter.value(rows.front());
  });
}

/// "*": the largest remnant is an EER; "+": only smaller ones are.
std::string eer_mark(const db::Result& r) { return r.eer ? "*" : r.n_eer > 0 ? "+" : ""; }

std::string legend(const std::vector<ResultRow>& rows) {
  std::string text;
  const auto any = [&](auto&& condition) {
    return std::any_of(rows.begin(), rows.end(), condition);
  };
  if (any([](const ResultRow& r) { return r.result.eer; }))
    text += "*  the largest remnant is extremely elongated (b/a < 0.3)\n";
  if (any([](const ResultRow& r) { return !r.result.eer && r.result.n_eer > 0; }))
    text += "+  a smaller remnant is extremely elongated\n";
  if (any([](const ResultRow& r) { return !r.result.settled; }))
    text += "~  not settled at the end: remnants will meet again; a later end.time_s tells\n";
  if (any([](const ResultRow& r) { return r.stale; }))
    text += "!  made by another solver version; `eerie retry --stale` repeats it\n";
  return text.empty() ? "" : "\n" + text;
}

}  // namespace

json results_json(const std::vector<ResultRow>& rows) {
  json list = json::array();
  for (const ResultRow& row : rows) {
    json object;
    for (const Column& column : columns) object[column.name] = column.value(row);
    list.push_back(std::move(object));
  }
  return list;
}

std::string results_csv(const std::vector<ResultRow>& rows) {
  std::string text;
  for (const Column& column : columns) text += std::string(text.empty() ? "" : ",") + column.name;
  text += "\n";
  for (const ResultRow& row : rows) {
    std::string line;
    for (const Column& column : columns) line += csv_field(column.value(row)) + ",";
    line.back() = '\n';
    text += line;
  }
  return text;
}

std::string results_table(const std::vector<ResultRow>& rows) {
  if (rows.empty()) return "";
  std::string shared;
  std::vector<const Parameter*> shown;
  for (const Parameter& parameter : parameters) {
    if (differs(rows, parameter))
      shown.push_back(&parameter);
    else
      shared += fmt::format("{}{} {}{}", shared.empty() ? "" : ", ", parameter.header,
                            parameter.value(rows.front()), parameter.unit);
  }
  std::vector<std::vector<std::string>> table(1);
  for (const Parameter* parameter : shown) table[0].push_back(parameter->header);
  for (const char* header :
       {"v cm/s", "theta deg", "class", "", "M_lr/M", "b/a", "c/a", "period h", "EER", "job"})
    table[0].push_back(header);
  for (const ResultRow& row : rows) {
    std::vector<std::string> line;
    for (const Parameter* parameter : shown)
      line.push_back(fmt::format("{}", parameter->value(row)));
    const db::Result& r = row.result;
    for (const std::string& cell :
         {fmt::format("{}", row.v_imp_cm_per_s), fmt::format("{}", row.theta_imp_deg),
          r.outcome_class, std::string(r.settled ? "" : "~"), number(r.m_lr_over_m_total, 3),
          number(r.b_over_a, 3), number(r.c_over_a, 3), number(r.period_h, 2), eer_mark(r),
          row.hash.substr(0, 8) + (row.stale ? " !" : "")})
      line.push_back(cell);
    table.push_back(std::move(line));
  }
  return shared + "\n\n" + text_table(table) + legend(rows);
}

}  // namespace eerie::cli
