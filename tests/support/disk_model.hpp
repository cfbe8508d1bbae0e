#pragma once

#include <map>
#include <memory>
#include <random>
#include <string>
#include <variant>
#include <vector>

#include "tests/support/disk_events.hpp"

namespace eerie::test {

/// What becomes of what was not flushed when the power goes.
enum class Unsynced {
  kept,         ///< all of it happens to be on the disk
  dropped,      ///< neither bytes nor names
  zero_filled,  ///< names and sizes are there, bytes are zeros
  cut_off,      ///< names are there, files end where they were last flushed
  mixed,        ///< for each file and folder one of these, as the dice fall
};
inline constexpr Unsynced unsynced_kinds[] = {
    Unsynced::kept, Unsynced::dropped, Unsynced::zero_filled, Unsynced::cut_off, Unsynced::mixed};

/// A file as programs see it, and as much of it as was flushed.
struct ModelFile {
  std::string now, flushed;
  std::vector<std::pair<std::size_t, std::size_t>> dirty = {};  ///< [begin, end) written since

  void write(std::size_t at, const std::string& bytes);
  void resize(std::size_t size);
  void sync();
  std::string after_cut(Unsynced unsynced) const;
};

struct ModelFolder;
using ModelNode = std::variant<std::shared_ptr<ModelFile>, std::shared_ptr<ModelFolder>>;

/// Entries as programs see them, and as they were last flushed. POSIX promises no more: neither a
/// new name nor a rename is on the disk before its folder is flushed.
struct ModelFolder {
  std::map<std::string, ModelNode> now, flushed;
};

/// A disk to which events happen, one after another.
class DiskModel {
 public:
  /// Begins with what lies in `root`, all of it flushed.
  explicit DiskModel(const std::filesystem::path& root);

  void apply(const DiskEvent& event);

  /// What would be found after a power cut now: bytes of files by their path from the root on;
  /// folders end in '/'.
  using State = std::map<std::string, std::string>;
  State after_cut(Unsynced unsynced, std::mt19937& dice) const;

 private:
  ModelFolder* folder(const std::filesystem::path& path);
  ModelFolder* parent_of(const std::filesystem::path& path) { return folder(path.parent_path()); }
  void make_file(const DiskEvent& event);
  void rename(const DiskEvent& event);

  std::filesystem::path root_;
  std::shared_ptr<ModelFolder> top_ = std::make_shared<ModelFolder>();
  std::map<std::uint64_t, std::shared_ptr<ModelFile>> files_;  ///< by inode
};

/// Writes a state into an empty folder.
void install_state(const DiskModel::State& state, const std::filesystem::path& folder);

}  // namespace eerie::test
