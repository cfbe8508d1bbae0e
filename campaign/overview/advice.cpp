#include "campaign/overview/advice.hpp"

#include <map>
#include <optional>

#include "campaign/sweeps/fidelity.hpp"
#include "campaign/sweeps/job.hpp"

namespace eerie::overview {
using nlohmann::json;

namespace {

/// The scenes that differ in more than their settings, each with the number of impacts that it
/// stands for. Cost varies slowly over a grid: of many impacts one in a few is enough.
struct Impacts {
  std::vector<json> sample;
  double each = 1;
  std::size_t count = 0;

  explicit Impacts(const std::vector<Scene>& scenes) {
    constexpr std::size_t most = 200;
    std::map<std::string, json> distinct;
    for (const Scene& scene : scenes) {
      json canonical = to_json(scene);
      for (const char* settings : {"numerics", "end", "output"}) canonical.erase(settings);
      std::string key = canonical.dump();
      distinct.emplace(std::move(key), std::move(canonical));
    }
    count = distinct.size();
    const std::size_t step = count / most + 1;
    std::size_t k = 0;
    for (auto& [key, impact] : distinct)
      if (k++ % step == 0) sample.push_back(std::move(impact));
    if (!sample.empty()) each = static_cast<double>(count) / static_cast<double>(sample.size());
  }

  /// Of one run of each; nothing where some impactor has too few particles for these settings.
  std::optional<double> particle_steps(const json& settings) const {
    double sum = 0;
    try {
      for (json scene : sample) {
        scene.merge_patch(settings);
        sum += sweeps::expected_particle_steps(parse_scene(scene));
      }
    } catch (const TooFewParticles&) {
      return std::nullopt;
    }
    return each * sum;
  }
};

}  // namespace

Advice advice(const std::vector<Scene>& scenes, double particle_steps_per_core_second) {
  const Impacts impacts(scenes);
  Advice advice{impacts.count, {}};
  for (const sweeps::Fidelity& f : sweeps::fidelities) {
    const json settings = sweeps::settings_of(f.name);
    const std::optional<double> particle_steps = impacts.particle_steps(settings);
    if (!particle_steps) continue;
    const double core_hours = *particle_steps / particle_steps_per_core_second / 3600;
    advice.choices.push_back({f.name, settings.at("numerics").at("particles_per_target"), f.seeds,
                              f.seeds * core_hours, f.error, f.class_agrees});
    if (!f.is_rung) continue;
    const auto runs = [core_hours](std::int64_t seeds) {
      return static_cast<double>(seeds) * core_hours;
    };
    if (advice.auto_least_core_hours == 0)
      advice.auto_least_core_hours = runs(sweeps::first_auto_seeds);
    const bool last = sweeps::rung_above(f.name).empty();
    advice.auto_most_core_hours +=
        runs(last ? sweeps::most_last_auto_seeds : sweeps::most_auto_seeds);
  }
  return advice;
}

text::Table table_of(const Advice& advice) {
  using text::both, text::Value;
  const auto known = [](double value) { return value > 0 ? Value(value) : Value(); };
  return text::table_of<Choice>(
      {{both("fidelity", "fidelity"), [](const Choice& c) { return c.fidelity; }},
       {both("particles_per_target", "particles"),
        [](const Choice& c) { return c.particles_per_target; }},
       {both("seeds", "seeds"), [](const Choice& c) { return c.seeds; }},
       {both("core_hours", "core-hours", "{:.3g}"), [](const Choice& c) { return c.core_hours; }},
       {both("b_over_a_error", "b/a off by", "{:g}"),
        [known](const Choice& c) { return known(c.b_over_a_error); }},
       {both("class_agrees", "class agrees", "{:.2f}"),
        [known](const Choice& c) { return known(c.class_agrees); }}},
      advice.choices);
}

std::optional<Choice> finest_within(const Advice& advice, double hours, std::size_t cores) {
  std::optional<Choice> finest;
  for (const Choice& c : advice.choices)
    if (c.b_over_a_error > 0 && c.core_hours <= hours * static_cast<double>(cores)) finest = c;
  return finest;
}

}  // namespace eerie::overview
