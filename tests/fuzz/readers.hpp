#pragma once

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "campaign/catalogue/catalogue_sweep.hpp"
#include "campaign/job_folder/result_file.hpp"
#include "campaign/sweeps/sweep.hpp"
#include "campaign/text/json_file.hpp"
#include "solver/base/error.hpp"
#include "solver/base/sha256.hpp"
#include "solver/io/seal.hpp"

/// What a fuzzer throws at the readers of files: any bytes are either read or refused with an
/// InputError, and what was read comes back the same. Everything else ends the process.
namespace eerie::fuzz {

inline void hold(bool condition) {
  if (!condition) std::abort();
}

/// Sweeps of more points are not expanded: they take long for no other reason than their number.
inline constexpr std::size_t most_points = 200;

inline void read_as_sweep(std::string_view text) {
  try {
    const sweeps::Sweep sweep =
        sweeps::parse_sweep(text::parse_json(text, "sweep.json"), {}, "sweep.json");
    const std::size_t points = sweeps::point_count(sweep);
    if (points > most_points) return;
    const std::size_t jobs = sweeps::expand(sweep).size();
    hold(jobs == points);
    const std::string written = sweeps::document(sweep);
    hold(sweeps::document(sweeps::parse_sweep(text::parse_json(written, "again"), {}, "again")) ==
         written);
  } catch (const InputError&) {
  }
}

inline void read_as_scene(std::string_view text) {
  try {
    const Scene scene = parse_scene(text::parse_json(text, "scene.json"), "scene.json");
    hold(scene_hash(parse_scene(to_json(scene))) == scene_hash(scene));
  } catch (const InputError&) {
  }
}

/// As it is, and with hash, version and checksum put right: no mutation guesses a checksum.
inline void read_as_result(std::string_view text) {
  static const std::string hash(64, 'a');
  job_folder::parse_result(text, hash);
  nlohmann::json document;
  try {
    document = text::parse_json(text, "result.json");
  } catch (const InputError&) {
    return;
  }
  if (!document.is_object()) return;
  document.erase("sha256");
  document["scene_hash"] = hash;
  document["version"] = job_folder::result_version;
  document["sha256"] = sha256_hex(document.dump());
  const auto stored = job_folder::parse_result(document.dump(), hash);
  if (stored) hold(stored->remnants.size() == document["analysis"]["remnants"].size());
}

/// As it is, and with a seal that fits.
inline void read_as_checkpoint(std::string_view bytes) {
  static const std::filesystem::path path =
      (std::filesystem::exists("/dev/shm") ? "/dev/shm" : "/tmp") +
      ("/eerie-fuzz-" + std::to_string(::getpid()) + ".hdf5");
  const std::string_view unsealed = bytes.substr(0, bytes.rfind("eerie-sha256:"));
  for (const std::string& file : {std::string(bytes), std::string(unsealed) + io::seal(unsealed)}) {
    std::ofstream(path, std::ios::binary | std::ios::trunc) << file;
    try {
      const io::Snapshot snapshot = io::read_snapshot(path);
      hold(snapshot.state.size() == snapshot.pressure.size());
    } catch (const InputError&) {
    }
  }
  std::filesystem::remove(path);
}

/// A sweep that is made of a catalogue is one that can be run.
inline void read_as_catalogue(std::string_view text) {
  for (const catalogue::CatalogueOptions& options :
       {catalogue::CatalogueOptions{}, catalogue::CatalogueOptions{1000, 50}}) {
    nlohmann::json document;
    try {
      const catalogue::Catalogue catalogue =
          catalogue::parse_catalogue(text, "catalogue.csv", options);
      if (catalogue.rows.size() > most_points) return;
      document = catalogue::sweep_of(catalogue, {}, "catalogue.csv");
    } catch (const InputError&) {
      continue;
    }
    const std::size_t jobs = sweeps::expand(sweeps::parse_sweep(document, {}, "made")).size();
    hold(jobs == document["points"].size());
  }
}

}  // namespace eerie::fuzz
