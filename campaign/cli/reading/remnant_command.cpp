#include <cmath>
#include <sstream>

#include "analysis/remnants/alone.hpp"
#include "campaign/cli/options/command_list.hpp"
#include "campaign/cli/output/files.hpp"
#include "campaign/text/json_text.hpp"
#include "solver/base/bodies/sphere.hpp"
#include "solver/base/constants.hpp"
#include "solver/base/file.hpp"
#include "solver/base/sha256.hpp"
#include "solver/scene/two_materials.hpp"

namespace eerie::cli {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

struct RemnantArguments {
  fs::path database;
  std::string job;
  int rank = 1;
  fs::path file;
};

/// The fields of a scene whose target is the remnant.
json scene_of(const remnants::Alone& remnant, const fs::path& file) {
  const Scene& first = remnant.snapshot.scene;
  const particles::State& s = remnant.snapshot.state;
  const double volume = s.mass * static_cast<double>(s.size()) / first.material.rho0_kg_per_m3;
  return {
      {"target",
       {{"radius_m", std::cbrt(volume / sphere_volume(1))},
        {"shape", {{"b_over_a", remnant.shape.b_over_a()}, {"c_over_a", remnant.shape.c_over_a()}}},
        {"remnant",
         {{"file", fs::absolute(file).lexically_normal().string()},
          {"sha256", sha256_hex(read_file(file))}}}}},
      {"material",
       {{"rho0_kg_per_m3", first.material.rho0_kg_per_m3},
        {"drucker_prager", {{"phi_d_deg", first.material.drucker_prager.phi_d_deg}}}}},
      {"numerics", {{"particles_per_target", s.size()}}}};
}

Answer keep_remnant(const RemnantArguments& a) {
  if (a.file.extension() != ".hdf5")
    throw InputError(fmt::format("-o {}: must end with .hdf5", a.file.string()));
  text::require_folder_of(a.file);
  const fs::path path = queries::snapshot_of(a.database, a.job);
  const remnants::Alone remnant = remnants::alone(io::read_snapshot(path), a.rank, path);
  if (has_two_materials(remnant.snapshot.scene))
    throw InputError(fmt::format(
        "job {}: its bodies are of two materials, and a kept remnant is of one; keep one of an "
        "impact without impactor.material",
        a.job));
  io::write_snapshot(a.file, remnant.snapshot);
  Answer answer;
  answer.data = {{"snapshot", path.string()},
                 {"rank", a.rank},
                 {"b_over_a", remnant.shape.b_over_a()},
                 {"c_over_a", remnant.shape.c_over_a()},
                 {"scene", scene_of(remnant, a.file)},
                 {"files", names_of({a.file})}};
  answer.say("remnant {} of {}: {} particles, b/a {:.3f}, c/a {:.3f}\n", a.rank, path,
             remnant.snapshot.state.size(), remnant.shape.b_over_a(), remnant.shape.c_over_a());
  answer.say("as the target, in a scene or in the \"scene\" of a sweep:\n");
  std::istringstream lines(text::json_text(answer.data["scene"], 1));
  for (std::string line; std::getline(lines, line);) answer.say("{}\n", line);
  answer.add_files({a.file});
  return answer;
}

}  // namespace

Action add_remnant(CLI::App& app) {
  auto a = std::make_shared<RemnantArguments>();
  add_remnant_of_snapshot(app, a->job, a->database, a->rank);
  app.add_option("-o,--output", a->file, "file for the body (.hdf5)")->required();
  add_formats(app);
  return [a](Output&) { return keep_remnant(*a); };
}

}  // namespace eerie::cli
