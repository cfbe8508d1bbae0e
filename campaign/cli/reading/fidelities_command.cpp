#include "campaign/cli/options/command_list.hpp"
#include "campaign/sweeps/fidelity.hpp"

namespace eerie::cli {
namespace {

Answer fidelities() {
  Table table{{both("name", "fidelity"), both("particles_per_target", "particles"), data("scheme"),
               both("core_seconds", "core-s of an impact", "{:g}"),
               both("b_over_a_error", "b/a off by", "{:g}"), shown("")},
              {}};
  for (const sweeps::Fidelity& f : sweeps::fidelities) {
    const nlohmann::json numerics = sweeps::settings_of(f.name).at("numerics");
    table.rows.push_back({f.name, numerics.at("particles_per_target").get<std::int64_t>(),
                          numerics.at("scheme").get<std::string>(), f.core_seconds,
                          f.error > 0 ? Value(f.error) : Value(),
                          f.name == std::string(sweeps::default_fidelity) ? "the default" : ""});
  }
  Answer answer;
  answer.data = {{"fidelities", records(table)}};
  answer.add(std::move(table));
  answer.say("\nOf a single run; docs/how-to/settings.md says which one to take for what.\n");
  return answer;
}

}  // namespace

Action add_fidelities(CLI::App& app) {
  add_formats(app);
  return [](Output&) { return fidelities(); };
}

}  // namespace eerie::cli
