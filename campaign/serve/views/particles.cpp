#include "campaign/serve/views/particles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <mutex>
#include <nlohmann/json.hpp>

#include "analysis/drawing/palette.hpp"
#include "analysis/pictures/particle_view.hpp"
#include "analysis/remnants/clumps.hpp"
#include "analysis/remnants/origin.hpp"
#include "analysis/remnants/remnants.hpp"
#include "analysis/shapes/hull.hpp"
#include "analysis/shapes/shape.hpp"
#include "campaign/job_folder/snapshot_files.hpp"
#include "solver/base/error.hpp"
#include "solver/io/snapshot.hpp"

namespace eerie::serve {
namespace fs = std::filesystem;
using nlohmann::json;
static_assert(std::endian::native == std::endian::little);

namespace {

constexpr int colour_stops = 64;
constexpr int last_rank = 254;

/// Debian's HDF5 may be used by one thread at a time.
std::mutex& one_reader() {
  static std::mutex mutex;
  return mutex;
}

/// What is drawn of each particle, in memory order, and the remnants that they make.
struct Picture {
  std::vector<double> depth, speed, pressure;
  std::vector<std::uint8_t> remnant;
  json remnants = json::array();
};

json to_json(const Vec3& v) { return {v.x, v.y, v.z}; }

Vec3 mean(const std::vector<Vec3>& values, const remnants::Clump& of) {
  Vec3 sum;
  for (const std::uint32_t i : of) sum += values[i];
  return sum / static_cast<double>(of.size());
}

json remnant_json(int rank, const particles::State& state, const remnants::Clump& clump,
                  const Vec3& origin) {
  std::vector<Vec3> x;
  for (const std::uint32_t i : clump) x.push_back(state.x[i]);
  const shapes::Shape shape = shapes::ellipsoid_of_inertia(x);
  json axes = json::array();
  for (const Vec3& axis : shape.axes) axes.push_back(to_json(axis));
  return {{"rank", rank},
          {"particles", clump.size()},
          {"x", to_json(mean(state.x, clump) - origin)},
          {"axes", std::move(axes)},
          {"lengths", {shape.a, shape.b, shape.c}}};
}

/// Clumps come from the largest on, and all particles have one mass: their order is the rank.
void look_at_clumps(Picture& p, const particles::State& state, const Vec3& origin) {
  p.speed.resize(state.size()), p.remnant.assign(state.size(), 0);
  int rank = 0;
  for (const remnants::Clump& clump :
       remnants::friends_of_friends(state.x, state.id, remnants::linking_length_over_h * state.h)) {
    const Vec3 v = mean(state.v, clump);
    for (const std::uint32_t i : clump) p.speed[i] = norm(state.v[i] - v);
    if (clump.size() < remnants::remnant_min_particles) continue;
    ++rank;
    for (const std::uint32_t i : clump)
      p.remnant[i] = static_cast<std::uint8_t>(std::min(rank, last_rank + 1));
    if (rank <= last_rank) p.remnants.push_back(remnant_json(rank, state, clump, origin));
  }
}

std::vector<double> depths_of(const io::Snapshot& snapshot,
                              const job_folder::JobDirectory& directory) {
  std::vector<double> by_id;
  if (snapshot.state.time == 0) {
    by_id = remnants::initial_depths(snapshot);
  } else if (std::error_code missing; fs::exists(directory.first_snapshot(), missing)) {
    by_id = remnants::initial_depths(io::read_snapshot(directory.first_snapshot()));
  }
  std::vector<double> depth(snapshot.state.size(), 0);
  if (by_id.size() == depth.size())
    for (std::size_t i = 0; i < depth.size(); ++i) depth[i] = by_id[snapshot.state.id[i]];
  return depth;
}

/// Ids are fixed for the whole run: a particle that is there once is there in all snapshots.
std::vector<std::size_t> kept(const particles::State& state, std::size_t most) {
  const std::size_t stride = (state.size() + most - 1) / std::max<std::size_t>(most, 1);
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < state.size(); ++i)
    if (stride <= 1 || state.id[i] % stride == 0) order.push_back(i);
  return order;
}

/// From the least value to one that one particle in a hundred exceeds.
json range(std::vector<double> values) {
  if (values.empty()) return {0, 1};
  const auto high =
      values.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, high);
  const double top = *high, low = *std::ranges::min_element(values);
  return {low, top > low ? top : low + 1};
}

json colours_json() {
  json stops = json::array();
  for (int k = 0; k < colour_stops; ++k)
    stops.push_back(
        drawing::hex(drawing::quantity_colour(static_cast<double>(k) / (colour_stops - 1))));
  return {
      {"bodies", {drawing::hex(pictures::target_colour), drawing::hex(pictures::impactor_colour)}},
      {"stops", std::move(stops)}};
}

template <class T>
void append(std::string& bytes, T value) {
  const auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
  bytes.append(raw.data(), raw.size());
}

void append(std::string& bytes, const std::vector<double>& values,
            const std::vector<std::size_t>& order) {
  for (const std::size_t i : order) append(bytes, static_cast<float>(values[i]));
}

std::string packed(const io::Snapshot& snapshot, const Picture& p, const Vec3& origin,
                   std::size_t most) {
  const particles::State& state = snapshot.state;
  const std::vector<std::size_t> order = kept(state, most);
  std::string head = json{
      {"n", order.size()},
      {"of", state.size()},
      {"time_s", state.time},
      {"radius_m", shapes::particle_radius(snapshot)},
      {"ranges",
       {{"depth", range(p.depth)}, {"speed", range(p.speed)}, {"pressure", range(p.pressure)}}},
      {"remnants", p.remnants},
      {"colours",
       colours_json()}}.dump();
  head.append((4 - head.size() % 4) % 4, ' ');
  std::string bytes = "eer1";
  bytes.reserve(8 + head.size() + 26 * order.size());
  append(bytes, static_cast<std::uint32_t>(head.size()));
  bytes += head;
  for (const std::size_t i : order) {
    const Vec3f x{state.x[i] - origin};
    append(bytes, x.x), append(bytes, x.y), append(bytes, x.z);
  }
  append(bytes, p.depth, order), append(bytes, p.speed, order), append(bytes, p.pressure, order);
  for (const std::size_t i : order) bytes += static_cast<char>(state.body[i]);
  for (const std::size_t i : order) bytes += static_cast<char>(p.remnant[i]);
  return bytes;
}

}  // namespace

json snapshots_json(const job_folder::JobDirectory& directory) {
  json list = json::array();
  const std::lock_guard lock(one_reader());
  try {
    for (const job_folder::SnapshotFile& file : job_folder::snapshot_files(directory.path))
      list.push_back({{"name", file.path.filename().string()}, {"time_s", file.time}});
  } catch (const InputError&) {
    // None yet, or a worker writes the first one: the page shows what there is.
  }
  return {{"snapshots", std::move(list)}};
}

std::string particles(const job_folder::JobDirectory& directory, const std::string& name,
                      std::size_t most) {
  // Only names that are in the list are ever opened: none leads out of the folder.
  const std::lock_guard lock(one_reader());
  for (const job_folder::SnapshotFile& file : job_folder::snapshot_files(directory.path)) {
    if (file.path.filename() != name) continue;
    const io::Snapshot snapshot = io::read_snapshot(file.path);
    remnants::Clump all(snapshot.state.size());
    for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
    const Vec3 origin = mean(snapshot.state.x, all);
    Picture picture;
    picture.depth = depths_of(snapshot, directory);
    picture.pressure = snapshot.pressure;
    look_at_clumps(picture, snapshot.state, origin);
    return packed(snapshot, picture, origin, most);
  }
  throw InputError(fmt::format("the job has no snapshot \"{}\"", name));
}

}  // namespace eerie::serve
