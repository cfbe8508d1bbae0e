#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "solver/io/seal.hpp"
#include "solver/io/snapshot.hpp"
#include "solver/io/swift_layout.hpp"

namespace eerie::io {

namespace {

/// Arrays of unequal length are a mistake of the caller, not of the user or the disk.
void require_consistent(const Snapshot& snapshot) {
  const std::size_t n = snapshot.state.size();
  if (n == 0) throw std::logic_error("a snapshot needs at least one particle");
  const auto same_length = [n](const char* name, const auto& array) {
    if (array.size() != n)
      throw std::logic_error(fmt::format("{}: {} entries for {} particles", name, array.size(), n));
  };
  particles::visit_state(snapshot.state, same_length);
  same_length("Pressures", snapshot.pressure);
  if (snapshot.rates) particles::visit_rates(*snapshot.rates, same_length);
  if (snapshot.restart) particles::visit_restart(*snapshot.restart, same_length);
}

h5::Handle write_state(hid_t file, const Snapshot& snapshot) {
  const particles::State& state = snapshot.state;
  h5::Handle group = h5::new_group(file, "State");
  h5::write_attribute(group, "FormatVersion", snapshot_format_version);
  h5::write_attribute(group, "SolverVersion", snapshot.solver_version);
  h5::write_attribute(group, "Time", state.time);
  h5::write_attribute(group, "Step", std::int64_t{state.step});
  h5::write_attribute(group, "ParticleMass", state.mass);
  h5::write_attribute(group, "Softening", state.softening.sound_speed);
  h5::write_attribute(group, "IsCalm", std::int64_t{state.softening.is_calm});
  h5::write_attribute(group, "SmoothingLength", state.h);
  return group;
}

void write_groups(hid_t file, const Snapshot& snapshot) {
  const auto into = [](hid_t group) {
    return [group](const char* name, const auto& array) {
      write_field(group, name, std::span(array));
    };
  };
  const h5::Handle parameters = h5::new_group(file, "Parameters");
  h5::write_attribute(parameters, "InitialConditions:periodic", std::string("0"));
  h5::write_attribute(parameters, "eerie:scene", to_json(snapshot.scene).dump());
  const h5::Handle state = write_state(file, snapshot);
  particles::visit_state(snapshot.state, into(state));
  write_swift_groups(file, state, snapshot);
  write_vtkhdf_group(file, snapshot);
  if (snapshot.rates) particles::visit_rates(*snapshot.rates, into(h5::new_group(file, "Rates")));
  if (snapshot.restart) {
    const h5::Handle restart = h5::new_group(file, "Restart");
    h5::write_attribute(restart, "ListSupport", snapshot.restart->list_support);
    h5::write_attribute(restart, "BuildsInOrder", std::int64_t{snapshot.restart->builds_in_order});
    particles::visit_restart(*snapshot.restart, into(restart));
  }
}

}  // namespace

void write_snapshot(const std::filesystem::path& path, const Snapshot& snapshot,
                    const std::filesystem::path& previous) {
  require_consistent(snapshot);
  std::string bytes;
  try {
    const h5::Silence silence;
    bytes = h5::new_file([&](hid_t file) { write_groups(file, snapshot); });
  } catch (const h5::Failure& failure) {
    throw EnvironmentError(fmt::format("cannot make {}: {}", path.string(), failure.what()));
  }
  bytes += seal(bytes);
  install_text(path, bytes, previous);
}

}  // namespace eerie::io
