#include "solver/io/swift_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

#include "solver/io/units.hpp"
#include "solver/scene/two_materials.hpp"

namespace eerie::io {

namespace {

void write_unit_attributes(hid_t dataset, const FieldUnit& unit) {
  // 1 kg = 1e3 g, 1 m = 1e2 cm.
  const double cgs = std::pow(1e3, unit.mass) * std::pow(1e2, unit.length);
  h5::write_attribute(dataset, "CGS conversion factor", cgs);
  h5::write_attribute(dataset, "Physical CGS conversion factor", cgs);
  h5::write_attribute(dataset, "U_M exponent", static_cast<double>(unit.mass));
  h5::write_attribute(dataset, "U_L exponent", static_cast<double>(unit.length));
  h5::write_attribute(dataset, "U_t exponent", static_cast<double>(unit.time));
  h5::write_attribute(dataset, "U_T exponent", 0.0);
  h5::write_attribute(dataset, "U_I exponent", 0.0);
  h5::write_attribute(dataset, "a-scale exponent", 0.0);
  h5::write_attribute(dataset, "h-scale exponent", 0.0);
  h5::write_attribute(dataset, "Description", std::string(unit.description));
  h5::write_attribute(dataset, "Expression for physical CGS units",
                      fmt::format("U_M^{} U_L^{} U_t^{} [ g^{} cm^{} s^{} ]", unit.mass,
                                  unit.length, unit.time, unit.mass, unit.length, unit.time));
}

template <class T>
void write_constant(hid_t group, const char* name, std::size_t n, T value) {
  const std::vector<T> values(n, value);
  write_field<T>(group, name, values);
}

void link(hid_t from, const char* name, hid_t to, const char* new_name) {
  h5::require(H5Lcreate_hard(from, name, to, new_name, H5P_DEFAULT, H5P_DEFAULT), new_name);
}

void alias(hid_t group, const char* target, const char* name) {
  h5::require(H5Lcreate_soft(target, group, name, H5P_DEFAULT, H5P_DEFAULT), name);
}

/// The h of each particle: that of its body, or as its density says.
void write_smoothing_lengths(hid_t group, const Snapshot& snapshot) {
  const particles::State& state = snapshot.state;
  const Scene& scene = snapshot.scene;
  const std::array<double, 2> size = particle_sizes(scene);
  const bool evolves = scene.numerics.smoothing == "evolving";
  std::vector<double> h(state.size());
  for (std::size_t i = 0; i < state.size(); ++i)
    h[i] = evolves ? particles::evolved_h(state.h, lowest_density(scene), state.rho[i])
                   : state.h * size[state.body[i]];
  write_field<double>(group, "SmoothingLengths", h);
}

void write_header(hid_t file, const Snapshot& snapshot, const SnapshotBox& box) {
  const h5::Handle header = h5::new_group(file, "Header");
  const std::array<double, 3> size{box.size.x, box.size.y, box.size.z};
  const std::array<double, 3> low{box.low.x, box.low.y, box.low.z};
  const std::array<std::int64_t, 7> count{static_cast<std::int64_t>(snapshot.state.size())};
  const std::array<std::int64_t, 7> none{};
  const std::array<double, 7> no_mass{};
  h5::write_attribute(header, "Code", std::string("SWIFT"));  // whose layout readers recognise
  h5::write_attribute(header, "RunName", std::string("eerie"));
  h5::write_attribute(header, "BoxSize", size);
  h5::write_attribute(header, "CoordinatesOffset", low);
  h5::write_attribute(header, "Dimension", std::int64_t{3});
  h5::write_attribute(header, "Time", snapshot.state.time);
  h5::write_attribute(header, "NumPart_ThisFile", count);
  h5::write_attribute(header, "NumPart_Total", count);
  h5::write_attribute(header, "NumPart_Total_HighWord", none);
  h5::write_attribute(header, "MassTable", no_mass);
  h5::write_attribute(header, "NumFilesPerSnapshot", std::int64_t{1});
  h5::write_attribute(header, "ThisFile", std::int64_t{0});
  h5::write_attribute(header, "Redshift", 0.0);
  h5::write_attribute(header, "Scale-factor", 1.0);
}

void write_settings(hid_t file) {
  const h5::Handle units = h5::new_group(file, "Units");
  h5::write_attribute(units, "Unit mass in cgs (U_M)", 1e3);
  h5::write_attribute(units, "Unit length in cgs (U_L)", 1e2);
  h5::write_attribute(units, "Unit time in cgs (U_t)", 1.0);
  h5::write_attribute(units, "Unit temperature in cgs (U_T)", 1.0);
  h5::write_attribute(units, "Unit current in cgs (U_I)", 1.0);
  const h5::Handle policy = h5::new_group(file, "Policy");
  h5::write_attribute(policy, "cosmological integration", std::int64_t{0});
  const h5::Handle runtime = h5::new_group(file, "RuntimePars");
  h5::write_attribute(runtime, "PeriodicBoundariesOn", std::int64_t{0});
  const h5::Handle hydro = h5::new_group(file, "HydroScheme");
  h5::write_attribute(hydro, "Scheme", std::string("SPH for elastic dynamics"));
  h5::new_group(file, "SubgridScheme");
}

}  // namespace

template <class T>
void write_field(hid_t group, const char* name, std::span<const T> data) {
  const h5::Handle dataset = h5::write_array(group, name, data);
  if (const FieldUnit* unit = unit_of(name)) write_unit_attributes(dataset, *unit);
}
template void write_field(hid_t, const char*, std::span<const std::uint8_t>);
template void write_field(hid_t, const char*, std::span<const std::uint32_t>);
template void write_field(hid_t, const char*, std::span<const std::int64_t>);
template void write_field(hid_t, const char*, std::span<const float>);
template void write_field(hid_t, const char*, std::span<const double>);
template void write_field(hid_t, const char*, std::span<const Vec3>);
template void write_field(hid_t, const char*, std::span<const SymTensor>);
template void write_field(hid_t, const char*, std::span<const Vec3f>);
template void write_field(hid_t, const char*, std::span<const SymTensorf>);

SnapshotBox snapshot_box(const particles::State& state) {
  Vec3 low = state.x.front(), high = low;
  for (const Vec3& x : state.x)
    for (int k = 0; k < 3; ++k) low[k] = std::min(low[k], x[k]), high[k] = std::max(high[k], x[k]);
  const double margin = 2 * state.h;  // so that no kernel is cut
  low -= {margin, margin, margin}, high += {margin, margin, margin};
  return {low, high - low};
}

void write_swift_groups(hid_t file, hid_t state_group, const Snapshot& snapshot) {
  const particles::State& state = snapshot.state;
  const SnapshotBox box = snapshot_box(state);
  write_header(file, snapshot, box);
  write_settings(file);
  const h5::Handle gas = h5::new_group(file, "PartType0");
  particles::visit_state(state, [&](const char* name, const auto& array) {
    // Exact positions may be negative; readers need them in [0, BoxSize].
    if (static_cast<const void*>(&array) != &state.x) link(state_group, name, gas, name);
  });
  std::vector<Vec3> shifted = state.x;
  for (Vec3& x : shifted) x -= box.low;
  write_field<Vec3>(gas, "Coordinates", shifted);
  write_field<double>(gas, "Pressures", snapshot.pressure);
  write_constant(gas, "Masses", state.size(), state.mass);
  write_smoothing_lengths(gas, snapshot);
  if (state.u.empty()) write_constant(gas, "InternalEnergies", state.size(), 0.0);
  write_constant(gas, "MaterialIDs", state.size(), std::int64_t{103});
  alias(gas, "SmoothingLengths", "SmoothingLength");
  alias(gas, "InternalEnergies", "InternalEnergy");
  alias(gas, "Densities", "Density");
}

void write_vtkhdf_group(hid_t file, const Snapshot& snapshot) {
  const std::size_t n = snapshot.state.size();
  const h5::Handle vtk = h5::new_group(file, "VTKHDF");
  h5::write_attribute(vtk, "Version", std::array<std::int64_t, 2>{1, 0});
  h5::write_attribute(vtk, "Type", std::string("UnstructuredGrid"));
  // Every particle is a cell of type 1 (vertex) with one point.
  std::vector<std::int64_t> index(n + 1);
  std::iota(index.begin(), index.end(), 0);
  const std::int64_t one_count = static_cast<std::int64_t>(n);
  const std::vector<std::uint8_t> types(n, 1);
  const std::span<const std::int64_t> count(&one_count, 1), indices(index);
  h5::write_array(vtk, "NumberOfConnectivityIds", count);
  h5::write_array(vtk, "NumberOfPoints", count);
  h5::write_array(vtk, "NumberOfCells", count);
  h5::write_array(vtk, "Connectivity", indices.first(n));
  h5::write_array(vtk, "Offsets", indices);
  h5::write_array(vtk, "Types", std::span<const std::uint8_t>(types));
  link(file, "State/Coordinates", vtk, "Points");
  const h5::Handle point_data = h5::new_group(vtk, "PointData");
  particles::visit_state(snapshot.state, [&](const char* name, const auto& array) {
    if (static_cast<const void*>(&array) != &snapshot.state.x)
      link(file, (std::string("State/") + name).c_str(), point_data, name);
  });
  link(file, "PartType0/Pressures", point_data, "Pressures");
}

}  // namespace eerie::io
