#include "campaign/cli/options/command_list.hpp"
#include "campaign/sweeps/fidelity.hpp"

namespace eerie::cli {
namespace {

Answer fidelities() {
  Table table{
      {both("name", "fidelity"), both("particles_per_target", "particles"), data("scheme"),
       both("seeds", "seeds"), both("core_seconds", "core-s of a run", "{:g}"),
       both("b_over_a_error", "b/a off by", "{:g}"), both("class_agrees", "class agrees", "{:.2f}"),
       both("question", "question"), data("caution")},
      {}};
  const auto known = [](double value) { return value > 0 ? Value(value) : Value(); };
  for (const sweeps::Fidelity& f : sweeps::fidelities) {
    const nlohmann::json numerics = sweeps::settings_of(f.name).at("numerics");
    table.rows.push_back({f.name, numerics.at("particles_per_target").get<std::int64_t>(),
                          numerics.at("scheme").get<std::string>(), f.seeds, f.core_seconds,
                          known(f.error), known(f.class_agrees), f.question, f.caution});
  }
  Answer answer;
  answer.data = {{"fidelities", records(table)}};
  answer.add(std::move(table));
  answer.say("\nWhat can go wrong\n");
  for (const sweeps::Fidelity& f : sweeps::fidelities) answer.say("  {}: {}\n", f.name, f.caution);
  answer.say(
      "\n{} is the default; --fidelity auto begins with sketches and runs finer where in doubt. "
      "Errors are of a single run. `eerie expand SWEEP` says the same for a sweep.\n",
      sweeps::default_fidelity);
  return answer;
}

}  // namespace

Action add_fidelities(CLI::App& app) {
  add_formats(app);
  return [](Output&) { return fidelities(); };
}

}  // namespace eerie::cli
