#include "campaign/cli/output/results_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "campaign/cli/output/text_table.hpp"

namespace eerie::cli {
using db::ResultRow;

namespace {

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
