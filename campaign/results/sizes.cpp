#include "campaign/results/sizes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>

#include "analysis/remnants/remnants.hpp"

namespace eerie::results {
using text::data, text::shown;
using text::Table, text::Value;

namespace {

struct Step {
  const figures::SizeDistribution* of;
  figures::SizeStep step;
};

}  // namespace

std::vector<figures::SizeDistribution> size_distributions(const db::Connection& connection,
                                                          const db::ViewQuery& query) {
  std::map<std::int64_t, std::vector<double>> masses;  // by job
  const db::ViewQuery all{.view = db::View::remnants, .columns = {"job", "mass_over_total"}};
  for (const auto& row : db::rows(connection, all).rows)
    masses[std::get<std::int64_t>(row[0])].push_back(std::get<double>(row[1]));
  std::map<std::pair<std::int64_t, std::string>, figures::SizeDistribution> found;
  for (const db::ResultRow& row : db::selected_results(connection, query)) {
    figures::SizeDistribution& d = found[{row.particles_per_target, row.fidelity}];
    d.name = row.fidelity.empty() ? "no named settings" : row.fidelity;
    d.particles_per_target = row.particles_per_target;
    ++d.impacts;
    d.limit = std::max(d.limit, static_cast<double>(remnants::remnant_min_particles) /
                                    (static_cast<double>(row.particles_per_target) * (1 + row.q)));
    if (const auto of_job = masses.find(row.job); of_job != masses.end())
      d.masses.insert(d.masses.end(), of_job->second.begin(), of_job->second.end());
  }
  std::vector<figures::SizeDistribution> list;
  for (auto& [key, d] : found) {
    std::ranges::sort(d.masses, std::greater());
    list.push_back(std::move(d));
  }
  return list;
}

text::Table table_of_steps(const std::vector<figures::SizeDistribution>& all) {
  std::vector<Step> steps;
  for (const figures::SizeDistribution& d : all)
    for (const figures::SizeStep& step : figures::steps(d)) steps.push_back({&d, step});
  const auto number = [](double value) { return fmt::format("{}", value); };
  return text::table_of<Step>(
      {{data("settings"), [](const Step& s) { return s.of->name; }},
       {data("particles_per_target"), [](const Step& s) { return s.of->particles_per_target; }},
       {data("impacts"), [](const Step& s) { return s.of->impacts; }},
       {data("mass_over_total"), [&](const Step& s) { return number(s.step.mass); }},
       {data("remnants_per_impact"), [&](const Step& s) { return number(s.step.count); }},
       {data("limit_over_total"), [&](const Step& s) { return number(s.of->limit); }}},
      steps);
}

text::Table table_of_counts(const std::vector<figures::SizeDistribution>& all) {
  Table table{{shown("m/M at least", "{:g}")}, {}};
  double finest = 1;
  for (const figures::SizeDistribution& d : all) {
    table.columns.push_back(
        shown(fmt::format("{} ({})", d.name, d.particles_per_target), "{:.3f}"));
    finest = std::min(finest, d.limit);
  }
  std::vector<double> masses = {0.9};
  for (double decade = 1; decade > finest / 10; decade /= 10)
    for (const double part : {0.5, 0.2, 0.1})
      if (part * decade >= finest * (1 - 1e-9)) masses.push_back(part * decade);
  for (const double mass : masses) {
    std::vector<Value>& line = table.rows.emplace_back();
    line.push_back(mass);
    for (const figures::SizeDistribution& d : all)
      line.push_back(mass < d.limit * (1 - 1e-9) ? Value() : Value(d.count_from(mass)));
  }
  return table;
}

}  // namespace eerie::results
