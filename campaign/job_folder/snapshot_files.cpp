#include "campaign/job_folder/snapshot_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/base/error.hpp"
#include "solver/base/text/shell_word.hpp"
#include "solver/io/snapshot.hpp"

namespace eerie::job_folder {
namespace fs = std::filesystem;

namespace {

bool is_snapshot(const fs::path& path) {
  const std::string name = path.filename();
  return name == "final.hdf5" || (name.starts_with("snapshot_") && path.extension() == ".hdf5");
}

std::size_t nearest_one(const std::vector<SnapshotFile>& series, double time) {
  const auto at = std::ranges::min_element(
      series, {}, [time](const SnapshotFile& s) { return std::abs(s.time - time); });
  return static_cast<std::size_t>(at - series.begin());
}

}  // namespace

std::vector<SnapshotFile> snapshot_files(const fs::path& folder) {
  std::vector<SnapshotFile> series;
  std::error_code problem;
  for (const auto& entry : fs::directory_iterator(folder, problem))
    if (is_snapshot(entry.path()))
      series.push_back({entry.path(), io::snapshot_time(entry.path())});
  if (series.empty())
    throw InputError(
        fmt::format("{}: holds no snapshots{}", folder.string(),
                    problem ? " (" + problem.message() + ")"
                            : "; a run writes them when it starts, when it ends, and every "
                              "output.snapshot_interval_s"));
  // "final" comes before "snapshot": at one time the snapshot is the one that is kept.
  std::ranges::sort(series, [](const SnapshotFile& a, const SnapshotFile& b) {
    return a.time != b.time ? a.time < b.time : a.path > b.path;
  });
  const auto same_time = [](const SnapshotFile& a, const SnapshotFile& b) {
    return a.time == b.time;
  };
  series.erase(std::unique(series.begin(), series.end(), same_time), series.end());
  return series;
}

std::vector<std::size_t> nearest(const std::vector<SnapshotFile>& series,
                                 const std::vector<double>& times) {
  const double interval = io::read_snapshot(series.back().path).scene.output.snapshot_interval_s;
  const double tolerance = std::max(interval / 2, 0.02 * series.back().time);
  std::vector<std::size_t> chosen;
  for (const double time : times) {
    chosen.push_back(nearest_one(series, time));
    if (std::abs(series[chosen.back()].time - time) <= tolerance * (1 + 1e-9)) continue;
    throw InputError(fmt::format(
        "--panels {:g}: no snapshot within {:g} s of it; there are {}. More are written by `eerie "
        "solve {} --out FOLDER --set output.snapshot_interval_s={:g}`, or by a sweep that sets it",
        time, tolerance, times_text(series),
        shell_word((series.back().path.parent_path() / "scene.json").string()), 500.0));
  }
  return chosen;
}

std::string times_text(const std::vector<SnapshotFile>& series) {
  std::string text;
  constexpr std::size_t most = 12;
  for (std::size_t k = 0; k < series.size(); ++k) {
    if (series.size() > most && k >= 3 && k + 1 < series.size()) continue;
    const bool jump = series.size() > most && k + 1 == series.size();
    text += fmt::format("{}{:g}", text.empty() ? "" : jump ? " ... " : ", ", series[k].time);
  }
  return text + fmt::format(" s ({} snapshot{})", series.size(), series.size() == 1 ? "" : "s");
}

}  // namespace eerie::job_folder
