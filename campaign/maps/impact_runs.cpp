#include "campaign/maps/impact_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <tuple>

#include "db/jobs/jobs.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::maps {
using nlohmann::json;

namespace {

/// What makes bodies the paper's: all but the fields that a fact may vary, and how they are
/// computed.
json bodies(const json& scene) {
  json same = scene;
  for (const char* other : {"impact", "numerics", "end", "output"}) same.erase(other);
  same["material"]["drucker_prager"].erase("phi_d_deg");
  same["material"]["tillotson"].erase("A_Pa");
  same["material"]["tillotson"].erase("B_Pa");
  return same;
}

/// A = B over the paper's; nothing where A and B differ from it by unlike factors.
std::optional<double> stiffness(const json& scene, const json& paper) {
  const auto ratio = [&](const char* field) {
    const auto value = [&](const json& s) {
      return s.at("material").at("tillotson").at(field).get<double>();
    };
    return value(scene) / value(paper);
  };
  const double a = ratio("A_Pa"), b = ratio("B_Pa");
  return a == b ? std::optional(a) : std::nullopt;
}

/// What runs have to share to be compared: all that is neither bodies, impact nor seed.
std::string comparable(json scene) {
  scene["numerics"].erase("seed");
  return json{scene["numerics"], scene["end"], scene["impact"]["separation"]}.dump();
}

paper::ImpactRun run_of(const db::Connection& connection, const db::ResultRow& row,
                        const json& scene) {
  paper::ImpactRun run;
  run.q = row.q, run.phi_d_deg = row.phi_d_deg;
  run.v_imp_cm_per_s = row.v_imp_cm_per_s, run.theta_imp_deg = row.theta_imp_deg;
  const std::string scheme = scene.at("numerics").at("scheme").get<std::string>();
  run.settings = {row.particles_per_target, row.fidelity.empty() ? scheme : row.fidelity,
                  row.fidelity, row.settings};
  run.seed = row.seed;
  run.outcome = row.result.outcome_class;
  run.m_lr_over_m_total = row.result.m_lr_over_m_total;
  run.period_h = row.result.period_h;
  run.settled = row.result.settled;
  run.ended_at_s = row.result.ended_at_s.value_or(row.end_time_s);
  for (const db::Remnant& m : db::remnants(connection, row.job))
    run.remnants.push_back({m.rank, m.mass_over_total, m.a_m, m.b_m, m.b_over_a, m.eer});
  return run;
}

}  // namespace

ImpactRuns impact_runs(const db::Connection& connection, const db::ResultFilter& filter) {
  const json paper =
      to_json(parse_scene({{"impact", {{"v_imp_cm_per_s", 20}, {"theta_imp_deg", 15}}}}));
  const json paper_bodies = bodies(paper);
  ImpactRuns all;
  std::vector<std::string> kinds;  // of all.runs
  // To the database stiffer bodies have settings of their own; facts compare them with the
  // paper's. They go by the number of the latter.
  std::map<std::string, std::pair<bool, std::int64_t>> ids;
  for (const db::ResultRow& row : db::results(connection, filter)) {
    if (row.stale) {
      ++all.stale;
      continue;
    }
    // A scene of another version of the program may lack fields: defaults fill them in.
    const json scene = to_json(parse_scene(json::parse(db::scene(connection, row.job))));
    const std::optional<double> stiff = stiffness(scene, paper);
    if (!stiff || bodies(scene) != paper_bodies) {
      ++all.other_bodies;
      continue;
    }
    all.runs.push_back(run_of(connection, row, scene));
    all.runs.back().stiffness = *stiff;
    all.unsettled += row.result.settled ? 0 : 1;
    kinds.push_back(comparable(scene));
    const std::pair id(*stiff != 1, row.settings);
    const auto known = ids.emplace(kinds.back(), id).first;
    known->second = std::min(known->second, id);
  }
  for (std::size_t k = 0; k < kinds.size(); ++k) all.runs[k].settings.id = ids.at(kinds[k]).second;
  return all;
}

std::vector<ComparableRuns> groups_of(const std::vector<paper::ImpactRun>& runs) {
  std::map<std::tuple<double, double, paper::RunSettings>, ComparableRuns> groups;
  for (const paper::ImpactRun& run : runs) {
    if (run.stiffness != 1) continue;
    ComparableRuns& group = groups[{run.q, run.phi_d_deg, run.settings}];
    group.q = run.q, group.phi_d_deg = run.phi_d_deg, group.settings = run.settings;
    group.runs.push_back(run);
  }
  std::vector<ComparableRuns> list;
  for (auto& [key, group] : groups) list.push_back(std::move(group));
  return list;
}

std::string remark(const ImpactRuns& runs) {
  std::string text;
  const auto add = [&](std::size_t count, const char* what) {
    if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : "; ", count, what);
  };
  add(runs.unsettled, "results are not settled (remnants will meet again) and count as they stand");
  add(runs.stale, "are of another solver version and left out");
  add(runs.other_bodies, "are of other bodies than the paper's and left out");
  return text;
}

}  // namespace eerie::maps
