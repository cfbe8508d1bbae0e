#include "campaign/comparison/comparison_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "campaign/text/quantities.hpp"

namespace eerie::comparison {
using text::both, text::data, text::or_null, text::shown;
using Field = text::Field<ImpactCompared>;
using text::Value;

namespace {

struct QuantityColumns {
  SeedsCompared ImpactCompared::*member;
  std::string name, unit;  ///< as in the view `results`: "period", "_h"
  std::string header, pattern;
};

std::string with_scatter(const statistics::Ensemble& e, const std::string& pattern) {
  if (e.runs == 0) return "";
  std::string text = fmt::format(fmt::runtime(pattern), e.mean);
  if (e.runs > 1) text += fmt::format(fmt::runtime(" +- " + pattern), e.deviation);
  return text;
}

void add_quantity(std::vector<Field>& fields, const QuantityColumns& c) {
  const auto of = [member = c.member](auto number) {
    return [member, number](const ImpactCompared& i) -> Value { return number(i.*member); };
  };
  const auto for_side = [&](statistics::Ensemble SeedsCompared::*side, const std::string& letter) {
    fields.push_back({data(c.name + "_" + letter + c.unit),
                      of([side](const SeedsCompared& s) { return or_null(mean_of(s.*side)); })});
    fields.push_back({data(c.name + "_std_" + letter + c.unit), of([side](const SeedsCompared& s) {
                        return or_null(deviation_of(s.*side));
                      })});
    fields.push_back(
        {shown(c.header + " " + letter), of([side, pattern = c.pattern](const SeedsCompared& s) {
           return with_scatter(s.*side, pattern);
         })});
  };
  for_side(&SeedsCompared::a, "a");
  for_side(&SeedsCompared::b, "b");
  fields.push_back({data(c.name + "_difference" + c.unit),
                    of([](const SeedsCompared& s) { return or_null(s.difference()); })});
  fields.push_back(
      {data(c.name + "_chance"), of([](const SeedsCompared& s) { return or_null(s.chance()); })});
  fields.push_back(
      {shown("beyond"), of([](const SeedsCompared& s) { return s.is_beyond_scatter(); })});
}

std::string with_count(const std::string& name, std::size_t of_class, std::size_t runs) {
  return of_class == runs ? name : fmt::format("{} ({} of {})", name, of_class, runs);
}

}  // namespace

text::Table table_of_impacts(const Compared& all) {
  using I = ImpactCompared;
  std::vector<Field> fields = {
      {both("q", "q", "{:.4g}"), [](const I& i) { return i.q; }},
      {both("phi_d_deg", "phi_d deg", "{:.4g}"), [](const I& i) { return i.phi_d_deg; }},
      {both("v_imp_cm_per_s", "v cm/s", "{:.5g}"), [](const I& i) { return i.v_imp_cm_per_s; }},
      {both("theta_imp_deg", "theta deg", "{:.4g}"), [](const I& i) { return i.theta_imp_deg; }},
      {both("settings_a", "settings a"), [](const I& i) { return i.settings_a; }},
      {both("settings_b", "settings b"), [](const I& i) { return i.settings_b; }},
      {both("runs_a", "runs a"), [](const I& i) { return i.runs_a; }},
      {both("runs_b", "runs b"), [](const I& i) { return i.runs_b; }},
      {data("class_a"), [](const I& i) { return i.class_a; }},
      {data("runs_of_class_a"), [](const I& i) { return i.of_class_a; }},
      {shown("class a"), [](const I& i) { return with_count(i.class_a, i.of_class_a, i.runs_a); }},
      {data("class_b"), [](const I& i) { return i.class_b; }},
      {data("runs_of_class_b"), [](const I& i) { return i.of_class_b; }},
      {shown("class b"), [](const I& i) { return with_count(i.class_b, i.of_class_b, i.runs_b); }}};
  for (auto& field : fields)
    if (field.column.name == "q" || field.column.name == "phi_d_deg" ||
        field.column.name == "settings_a" || field.column.name == "settings_b")
      field.column.above = true;
  add_quantity(fields, {&I::b_over_a, "b_over_a", "", "b/a", "{:.3f}"});
  add_quantity(fields, {&I::m_lr, "m_lr_over_m_total", "", "M_lr/M", "{:.3f}"});
  add_quantity(fields, {&I::period_h, "period", "_h", "period h", "{:.2f}"});
  fields.push_back({data("same_class"), [](const I& i) { return i.has_same_class(); }});
  fields.push_back({data("beyond_scatter"), [](const I& i) { return i.is_beyond_scatter(); }});
  fields.push_back({data("same_jobs"), [](const I& i) { return i.same_jobs; }});
  fields.push_back({data("same_results"), [](const I& i) { return i.same_results; }});
  return text::table_of<I>(fields, all.impacts);
}

std::string summary(const Compared& all) {
  const auto count = [&](auto&& holds) { return std::ranges::count_if(all.impacts, holds); };
  const auto differ = count([](const ImpactCompared& i) { return !i.has_same_class(); });
  const auto beyond = count([](const ImpactCompared& i) { return i.is_beyond_scatter(); });
  const auto untold = count([](const ImpactCompared& i) { return !i.m_lr.chance(); });
  std::size_t jobs = 0, same = 0;
  for (const ImpactCompared& i : all.impacts) jobs += i.same_jobs, same += i.same_results;
  std::string text = fmt::format("{}: the class differs in {}; {} beyond the scatter of seeds",
                                 text::count_of(all.impacts.size(), "impact"), differ, beyond);
  text +=
      fmt::format(" in b/a, M_lr or period (each test errs in {:g} % of impacts that are alike)\n",
                  100 * significant);
  if (untold > 0)
    text += fmt::format("{} have one run on either side: nothing is known of their scatter\n",
                        text::count_of(static_cast<std::size_t>(untold), "impact"));
  if (jobs > 0)
    text += fmt::format("{} on both sides, {} with the same numbers\n", text::count_of(jobs, "job"),
                        same);
  if (all.only_a + all.only_b > 0)
    text += fmt::format("only in a: {}; only in b: {}\n", text::count_of(all.only_a, "impact"),
                        text::count_of(all.only_b, "impact"));
  return text;
}

}  // namespace eerie::comparison
