#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "solver/base/error.hpp"
#include "solver/io/hdf5.hpp"
#include "solver/io/seal.hpp"
#include "solver/io/snapshot.hpp"

namespace eerie::io {

namespace {

using h5::Failure;

bool finite(double x) { return std::isfinite(x); }
bool finite(const Vec3& v) { return finite(v.x) && finite(v.y) && finite(v.z); }
bool finite(const SymTensor& s) {
  return finite(s.xx) && finite(s.yy) && finite(s.zz) && finite(s.xy) && finite(s.xz) &&
         finite(s.yz);
}
bool finite(const Vec3f& v) { return finite(Vec3(v)); }
bool finite(const SymTensorf& s) { return finite(to_double(s)); }
bool finite(std::uint8_t) { return true; }
bool finite(std::uint32_t) { return true; }

/// Reads `n` rows and refuses NaN and infinity.
template <class T>
void read_field(hid_t group, const char* name, std::size_t n, std::vector<T>& array) {
  array.resize(n);
  h5::read_array(group, name, std::span(array));
  for (std::size_t i = 0; i < n; ++i)
    if (!finite(array[i])) throw Failure(fmt::format("{}[{}] is not finite", name, i));
}

void require_permutation(const std::vector<std::uint32_t>& id) {
  std::vector<bool> seen(id.size(), false);
  for (const std::uint32_t i : id) {
    if (i >= id.size() || seen[i])
      throw Failure(fmt::format("ParticleIDs is no permutation of 0..{}: {} is {}", id.size() - 1,
                                i, i < id.size() ? "there twice" : "too large"));
    seen[i] = true;
  }
}

double positive(hid_t group, const char* name) {
  const double value = h5::read_double(group, name);
  if (!(value > 0) || !std::isfinite(value))
    throw Failure(fmt::format("{} = {}: must be positive and finite", name, value));
  return value;
}

/// Files without a version are older than both it and the seal. One that has a version has lost its
/// seal: it was cut off or overwritten.
std::string read_solver_version(hid_t file, bool sealed) {
  const h5::Handle group = h5::open_group(file, "State");
  if (!h5::has_attribute(group, "SolverVersion")) return "0.1.0";
  if (!sealed) throw Failure("it is damaged: its last line, the SHA-256 of the rest, is missing");
  return h5::read_text(group, "SolverVersion");
}

/// Before there is memory for them: each array has n rows in the file.
void require_rows(hid_t group, std::size_t n, const particles::OptionalFields& use) {
  particles::State one;
  particles::resize(one, 1, use);
  particles::visit_state(one, [&]<class T>(const char* name, std::vector<T>&) {
    const hsize_t rows = h5::rows_of(group, name, h5::Layout<T>::type(), h5::Layout<T>::columns);
    if (rows != n)
      throw Failure(fmt::format("dataset '{}' has {} rows, expected {}", name, rows, n));
  });
}

particles::State read_state(hid_t file, const particles::OptionalFields& use) {
  const h5::Handle group = h5::open_group(file, "State");
  const std::int64_t version = h5::read_integer(group, "FormatVersion");
  if (version != snapshot_format_version)
    throw Failure(
        fmt::format("format version {}, this program reads {}", version, snapshot_format_version));
  particles::State state;
  state.time = h5::read_double(group, "Time");
  state.step = h5::read_integer(group, "Step");
  if (!std::isfinite(state.time) || state.step < 0)
    throw Failure(
        fmt::format("time {} and step {} are not those of a run", state.time, state.step));
  state.mass = positive(group, "ParticleMass");
  state.h = positive(group, "SmoothingLength");
  // Files from before there was a late phase have none, and that one began when all was calm.
  if (h5::has_attribute(group, "Softening")) {
    state.softening.sound_speed = positive(group, "Softening");
    state.softening.is_calm = h5::has_attribute(group, "IsCalm")
                                  ? h5::read_integer(group, "IsCalm") != 0
                                  : state.softening.sound_speed < 1;
  }
  const std::size_t n = h5::rows_of(group, "ParticleIDs", h5::Layout<std::uint32_t>::type(), 1);
  if (n == 0) throw Failure("it has no particles");
  require_rows(group, n, use);
  particles::resize(state, n, use);
  particles::visit_state(state,
                         [&](const char* name, auto& array) { read_field(group, name, n, array); });
  require_permutation(state.id);
  for (std::size_t i = 0; i < n; ++i) {
    if (!(state.rho[i] > 0)) throw Failure(fmt::format("Densities[{}] = {}", i, state.rho[i]));
    if (state.body[i] > static_cast<std::uint8_t>(particles::Body::impactor))
      throw Failure(fmt::format("BodyIDs[{}] = {}: must be 0 or 1", i, state.body[i]));
  }
  return state;
}

Scene read_scene(hid_t file) {
  const std::string text = h5::read_text(h5::open_group(file, "Parameters"), "eerie:scene");
  // What walks over a document later on is recursive, and the stack has an end.
  const auto shallow = [](int depth, nlohmann::json::parse_event_t, nlohmann::json&) {
    return depth <= 32 ? true : throw Failure("its scene is nested deeper than any scene");
  };
  const nlohmann::json json = nlohmann::json::parse(text, shallow, false);
  if (json.is_discarded()) throw Failure("its scene is not JSON");
  return parse_scene(json);
}

Snapshot read_file_bytes(std::string bytes) {
  const h5::Silence silence;
  const bool sealed = take_off_seal(bytes);
  const h5::Handle file = h5::open_bytes(bytes);
  Snapshot snapshot;
  snapshot.solver_version = read_solver_version(file, sealed);
  snapshot.scene = read_scene(file);
  const particles::OptionalFields use = optional_fields(snapshot.scene);
  snapshot.state = read_state(file, use);
  const std::size_t n = snapshot.state.size();
  const auto from = [n](hid_t group) {
    return [group, n](const char* name, auto& array) { read_field(group, name, n, array); };
  };
  read_field(h5::open_group(file, "PartType0"), "Pressures", n, snapshot.pressure);
  if (h5::has(file, "Rates")) {
    particles::resize(snapshot.rates.emplace(), n, use);
    particles::visit_rates(*snapshot.rates, from(h5::open_group(file, "Rates")));
  }
  if (h5::has(file, "Restart")) {
    const h5::Handle restart = h5::open_group(file, "Restart");
    snapshot.restart.emplace().list_support = positive(restart, "ListSupport");
    snapshot.restart->builds_in_order = h5::read_integer(restart, "BuildsInOrder");
    if (snapshot.restart->builds_in_order < 0) throw Failure("BuildsInOrder is negative");
    particles::visit_restart(*snapshot.restart, from(restart));
  }
  return snapshot;
}

InputError unusable(const std::filesystem::path& path, const std::exception& reason) {
  return InputError(fmt::format("{} is not a usable snapshot: {}", path.string(), reason.what()));
}

/// An open file, closed with this.
struct Descriptor {
  int fd;
  explicit Descriptor(int number) : fd(number) {}
  ~Descriptor() { ::close(fd); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
};

/// Of a file, and of nothing that would let the reader wait or has no end: pipes and devices.
std::string present_bytes(const std::filesystem::path& path) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  if (file.fd < 0 && errno == ENOENT)
    throw InputError(fmt::format("{}: there is no such snapshot", path.string()));
  struct stat info {};
  if (file.fd < 0 || ::fstat(file.fd, &info) != 0)
    throw EnvironmentError(fmt::format("cannot read {}: {}", path.string(), std::strerror(errno)));
  if (S_ISDIR(info.st_mode))
    throw EnvironmentError(fmt::format("cannot read {}: it is a folder", path.string()));
  if (!S_ISREG(info.st_mode))
    throw InputError(
        fmt::format("{}: is no regular file but a pipe, a socket or a device; give a "
                    "snapshot that lies on a disk",
                    path.string()));
  const auto memory =
      static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGESIZE));
  if (static_cast<double>(info.st_size) > memory)
    throw InputError(fmt::format("{}: its {} bytes are more than the memory of this machine",
                                 path.string(), info.st_size));
  std::string bytes(static_cast<std::size_t>(info.st_size), '\0');
  std::size_t at = 0;
  while (at < bytes.size()) {
    const ssize_t got = ::read(file.fd, bytes.data() + at, bytes.size() - at);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0)
      throw EnvironmentError(
          fmt::format("cannot read {}: {}", path.string(), std::strerror(errno)));
    if (got == 0) break;  // it was cut since
    at += static_cast<std::size_t>(got);
  }
  bytes.resize(at);
  return bytes;
}

}  // namespace

double snapshot_time(const std::filesystem::path& path) {
  const std::string bytes = present_bytes(path);
  try {
    const h5::Silence silence;
    const h5::Handle file = h5::open_bytes(bytes);
    const double time = h5::read_double(h5::open_group(file, "State"), "Time");
    if (!std::isfinite(time)) throw Failure("its time is not finite");
    return time;
  } catch (const Failure& failure) {
    throw unusable(path, failure);
  }
}

Snapshot read_snapshot(const std::filesystem::path& path) {
  std::string bytes = present_bytes(path);
  try {
    return read_file_bytes(std::move(bytes));
  } catch (const Failure& failure) {
    throw unusable(path, failure);
  } catch (const InputError& error) {  // the scene inside
    throw unusable(path, error);
  }
}

}  // namespace eerie::io
