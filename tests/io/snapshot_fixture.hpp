#pragma once

#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "solver/base/random.hpp"
#include "solver/io/snapshot.hpp"

namespace eerie::test {

/// A folder of its own for one test, removed with its content.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "eerie-test-XXXXXX").string();
    path_ = ::mkdtemp(pattern.data());
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::filesystem::path operator/(const char* name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

inline void fill(Random& random, double& value) { value = random.uniform(-1, 1) / 3; }
inline void fill(Random& random, float& value) {
  value = static_cast<float>(random.uniform(-1, 1) / 3);
}
inline void fill(Random& random, Vec3& value) { value = random.direction() * 123.456; }
inline void fill(Random& random, SymTensor& s) {
  for (double* x : {&s.xx, &s.yy, &s.zz, &s.xy, &s.xz, &s.yz}) fill(random, *x);
}
inline void fill(Random& random, Vec3f& value) { value = Vec3f(random.direction() * 123.456); }
inline void fill(Random& random, SymTensorf& s) {
  SymTensor wide;
  fill(random, wide);
  s = to_single(wide);
}
inline void fill(Random& random, std::uint8_t& body) { body = random.uniform() < 0.5 ? 0 : 1; }
inline void fill(Random&, std::uint32_t&) {}

/// A checkpoint of `n` particles with every bit of every field in use, in scrambled order.
inline io::Snapshot random_snapshot(std::size_t n, bool checkpoint = true) {
  Random random(7, n);
  io::Snapshot s;
  s.scene = parse_scene({{"impact", {{"v_imp_cm_per_s", 20.1}}},
                         {"material",
                          {{"energy", "integrated"},
                           {"rheology", "lundborg"},
                           {"fracture", "grady-kipp"},
                           {"drucker_prager", {{"pressure", "total"}}}}},
                         {"numerics", {{"viscosity", "shear-free"}}},
                         {"environment",
                          {{"gravity_m_per_s2", {0, 0.1, -1}},
                           {"walls", {{{"face", "z_low"}, {"at_m", -60.5}, {"kind", "rough"}}}}}}});
  s.state.time = 1234.5 / 7;
  s.state.step = 321;
  s.state.mass = 1.0e5 / 3;
  s.state.h = 8.1 / 7;
  particles::resize(s.state, n, io::optional_fields(s.scene));
  s.pressure.resize(n);
  const auto fill_all = [&](const char*, auto& array) {
    for (auto& value : array) fill(random, value);
  };
  particles::visit_state(s.state, fill_all);
  fill_all("", s.pressure);
  for (std::size_t i = 0; i < n; ++i) {
    s.state.id[i] = static_cast<std::uint32_t>(i);
    s.state.rho[i] = 2700 + s.state.rho[i];
  }
  for (std::size_t i = n - 1; i > 0; --i)
    std::swap(s.state.id[i],
              s.state.id[static_cast<std::size_t>(random.uniform() * static_cast<double>(i + 1))]);
  if (checkpoint) {
    particles::resize(s.rates.emplace(), n, io::optional_fields(s.scene));
    particles::visit_rates(*s.rates, fill_all);
    s.restart.emplace().list_support = 2.3 / 7;
    s.restart->builds_in_order = 5;
    particles::visit_restart(*s.restart, [&](const char* name, auto& array) {
      array.resize(n);
      fill_all(name, array);
    });
  }
  return s;
}

/// Equality of bits: tells -0 from 0.
template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

/// Names of all fields that differ in some bit; empty when the two are the same.
inline std::vector<std::string> differences(const io::Snapshot& a, const io::Snapshot& b) {
  std::vector<std::string> found;
  const auto note = [&](bool same, const char* name) {
    if (!same) found.push_back(name);
  };
  const auto against = [&](const auto& walk, const auto& left, const auto& right) {
    walk(left, [&](const char* name, const auto& array) {
      walk(right, [&](const char* other, const auto& other_array) {
        if constexpr (std::is_same_v<decltype(array), decltype(other_array)>)
          if (std::string(name) == other) note(same_bits(array, other_array), name);
      });
    });
  };
  note(to_json(a.scene) == to_json(b.scene), "scene");
  note(a.state.time == b.state.time, "time");
  note(a.state.step == b.state.step, "step");
  note(a.state.mass == b.state.mass, "mass");
  note(a.state.h == b.state.h, "h");
  note(same_bits(a.pressure, b.pressure), "pressure");
  against([](const auto& s, auto&& visit) { particles::visit_state(s, visit); }, a.state, b.state);
  note(a.rates.has_value() == b.rates.has_value(), "rates");
  note(a.restart.has_value() == b.restart.has_value(), "restart");
  if (a.rates && b.rates)
    against([](const auto& r, auto&& visit) { particles::visit_rates(r, visit); }, *a.rates,
            *b.rates);
  if (a.restart && b.restart) {
    note(a.restart->list_support == b.restart->list_support, "list_support");
    note(a.restart->builds_in_order == b.restart->builds_in_order, "builds_in_order");
    against([](const auto& r, auto&& visit) { particles::visit_restart(r, visit); }, *a.restart,
            *b.restart);
  }
  return found;
}

}  // namespace eerie::test
