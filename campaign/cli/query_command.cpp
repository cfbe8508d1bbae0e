#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "analysis/outcome.hpp"
#include "campaign/cli/commands.hpp"
#include "campaign/cli/options.hpp"
#include "campaign/cli/result_columns.hpp"
#include "solver/base/error.hpp"

namespace eerie::cli {
namespace {

db::ResultFilter filter_of(const QueryArguments& a) {
  db::ResultFilter filter;
  filter.q = a.q;
  filter.phi_d_deg = a.phi_d_deg;
  if (!a.v.empty()) filter.v_imp_cm_per_s = parse_range(a.v, "--v");
  if (!a.theta.empty()) filter.theta_imp_deg = parse_range(a.theta, "--theta");
  filter.eer_only = a.eer;
  if (a.outcome_class.empty()) return filter;
  if (!outcome_named(a.outcome_class)) {
    std::vector<std::string_view> names;
    for (const OutcomeName& entry : outcome_names) names.push_back(entry.name);
    throw InputError(
        fmt::format("--class {}: must be one of {}", a.outcome_class, fmt::join(names, ", ")));
  }
  filter.outcome_class = a.outcome_class;
  return filter;
}

}  // namespace

int query(const QueryArguments& a) {
  const db::ResultFilter filter = filter_of(a);
  const db::Connection connection(a.database, db::Access::read);
  const auto rows = db::results(connection, filter);
  if (rows.empty())
    fmt::print(stderr, "no result in {} matches; `eerie status --db {}` shows what it holds\n",
               a.database.string(), a.database.string());
  if (a.json || a.format == "json")
    fmt::print("{}\n", results_json(rows).dump(1));
  else if (a.format == "csv")
    fmt::print("{}", results_csv(rows));
  else
    fmt::print("{}", results_table(rows));
  return static_cast<int>(ExitCode::done);
}

}  // namespace eerie::cli
