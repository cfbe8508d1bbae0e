#include "campaign/studies/convergence_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <string_view>

#include "analysis/remnants/remnants.hpp"
#include "campaign/results/run_statistics.hpp"
#include "campaign/text/plain_text.hpp"

namespace eerie::studies {

namespace {

/// 50000 -> "50,000".
std::string thousands(std::int64_t n) {
  std::string text = fmt::format("{}", n);
  for (std::size_t at = text.size(); at > 3; at -= 3) text.insert(at - 3, ",");
  return text;
}

/// A title as Markdown shows it letter by letter, on one line.
std::string plain(const std::string& title) {
  std::string out;
  for (const char c : text::plain_text(title)) {
    if (std::string_view("\\`*<[]|").find(c) != std::string_view::npos) out += '\\';
    out += c;
  }
  return out;
}

std::string range(const statistics::Ensemble& e, int digits) {
  if (e.runs == 0) return "-";
  if (e.runs == 1) return fmt::format("{:.{}f}", e.mean, digits);
  return fmt::format("{:.{}f} ± {:.{}f}", e.mean, digits, e.deviation, digits);
}

/// Columns for the time of what was published, where the study says one.
std::string header_at(std::optional<double> time_s) {
  if (!time_s) return "";
  return fmt::format(" b/a at {0:g} s | M_1/M at {0:g} s | P(EER of 3) at {0:g} s |", *time_s);
}
std::string row_at_published(const ConvergenceCell::AtPublished& then) {
  return fmt::format(" {} | {} | {} |", range(then.b_over_a, 2), range(then.m_1, 2),
                     then.m_1.runs > 0 ? fmt::format("{:.2f}", then.p_top3_eer) : "-");
}

std::string row(const ConvergenceCell& c) {
  return fmt::format("| {} | `{}` | {} | {} | {} | {} | {:.2f} | {:.2f} | {} | {:.0f} |",
                     thousands(c.particles_per_target), c.scheme, c.m_1.runs, range(c.b_over_a, 2),
                     range(c.m_1, 2), range(c.period_h, 1), c.p_top3_eer, c.unsettled, c.classes,
                     c.core_seconds.mean);
}

std::string published_text(const ConvergenceStudy::Published& published) {
  std::string text;
  const auto add = [&](const char* name, std::optional<double> value, const char* unit) {
    if (value) text += fmt::format("{}{} {:.3g}{}", text.empty() ? "" : ", ", name, *value, unit);
  };
  add("b/a", published.b_over_a, "");
  add("M_1/M", published.m_1_over_m_total, "");
  add("period", published.period_h, " h");
  if (published.eer)
    text += fmt::format("{}{}", text.empty() ? "" : ", ", *published.eer ? "EER" : "no EER");
  return text;
}

/// "from 2,000 on", of a particle number that means are right from.
std::string from_on(std::optional<std::int64_t> n) {
  return n ? fmt::format("from {} on", thousands(*n)) : "not yet";
}

std::string sentence(const ParticlesNeeded& r) {
  std::string text = fmt::format("- `{}`: ", r.scheme);
  if (r.own)
    text += fmt::format("near its own {} {}", thousands(r.finest),
                        *r.own == r.finest ? "with no fewer" : from_on(r.own));
  else
    text += fmt::format("only {} were run", thousands(r.finest));
  if (r.has_published) text += fmt::format("; as published: {}", from_on(r.published));
  if (r.known_to && *r.known_to > b_over_a_within)
    text += fmt::format(". By chance, perhaps: the means of b/a are known to {:.2f}", *r.known_to);
  if (r.b_over_a && r.b_over_a->error <= known_limit)
    text += fmt::format(". As spacings vanish b/a goes to {:.2f} ± {:.2f}", r.b_over_a->value,
                        r.b_over_a->error);
  return text + ".\n";
}

/// Rows of one particle number stand together, in the order of the schemes.
std::vector<ConvergenceCell> by_particles(const ConvergenceStudy::Case& one,
                                          const std::vector<ConvergenceCell>& cells) {
  std::vector<ConvergenceCell> of_case;
  std::ranges::copy_if(cells, std::back_inserter(of_case),
                       [&](const ConvergenceCell& c) { return c.case_name == one.name; });
  std::ranges::stable_sort(of_case, {}, &ConvergenceCell::particles_per_target);
  return of_case;
}

}  // namespace

std::string convergence_page(const ConvergenceStudy& study,
                             const std::vector<ConvergenceCell>& cells,
                             const std::vector<ParticlesNeeded>& needed) {
  std::string page = fmt::format(
      "# {}\n\nMade by `eerie converge`; do not edit. Of the largest remnant: mean and standard "
      "deviation of single runs over seeds.\n\n- P(EER of 3): part of the runs with a remnant of "
      "b/a < {:g} among the three largest, of {:g} of the mass at least.\n- Unsettled: part of the "
      "runs that ended with remnants still to meet.\n- \"Near\": means within {:g} in b/a and {:g} "
      "in M_1/M, for that particle number and all larger ones.\n- \"As published\": near, and an "
      "EER in more than half of the runs, or in less, where one was published or not.\n",
      study.name, remnants::eer_max_b_over_a, results::eer_least_mass, b_over_a_within, m_1_within);
  for (const ConvergenceStudy::Case& one : study.cases) {
    const std::vector<ConvergenceCell> rows = by_particles(one, cells);
    if (rows.empty()) continue;
    page += fmt::format("\n## {}\n\n![{}]({}.svg)\n\n", plain(one.title), one.name, one.name);
    if (const std::string text = published_text(one.published); !text.empty())
      page += "Published: " + text + ".\n\n";
    page +=
        "| particles per target | scheme | runs | b/a | M_1/M | period, h | P(EER of 3) | "
        "unsettled | "
        "classes | core-s |" +
        header_at(study.published_at_s) + "\n|---|---|---|---|---|---|---|---|---|---|" +
        (study.published_at_s ? "---|---|---|\n" : "\n");
    for (const ConvergenceCell& cell : rows)
      page += row(cell) + (study.published_at_s ? row_at_published(cell.at_published) : "") + "\n";
    page += "\n";
    for (const ParticlesNeeded& one_scheme : needed)
      if (one_scheme.case_name == one.name) page += sentence(one_scheme);
  }
  return page;
}

}  // namespace eerie::studies
