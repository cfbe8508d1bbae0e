#include "tests/support/disk_model.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <fstream>

#include "solver/base/file.hpp"

namespace eerie::test {
namespace fs = std::filesystem;

void ModelFile::write(std::size_t at, const std::string& bytes) {
  if (now.size() < at + bytes.size()) now.resize(at + bytes.size(), '\0');
  now.replace(at, bytes.size(), bytes);
  dirty.emplace_back(at, at + bytes.size());
}

void ModelFile::resize(std::size_t size) {
  if (size > now.size()) dirty.emplace_back(now.size(), size);
  now.resize(size, '\0');
}

void ModelFile::sync() {
  flushed = now;
  dirty.clear();
}

std::string ModelFile::after_cut(Unsynced unsynced) const {
  if (unsynced == Unsynced::kept) return now;
  if (unsynced != Unsynced::zero_filled) return flushed;
  std::string zeroed = now;
  for (const auto& [begin, end] : dirty)
    for (std::size_t k = begin; k < std::min(end, zeroed.size()); ++k) zeroed[k] = '\0';
  return zeroed;
}

DiskModel::DiskModel(const fs::path& root) : root_(fs::canonical(root)) {
  for (const auto& entry : fs::directory_iterator(root_)) {
    struct stat info {};
    ::stat(entry.path().c_str(), &info);
    if (!S_ISREG(info.st_mode)) throw std::runtime_error("the disk must begin with files alone");
    auto file = std::make_shared<ModelFile>();
    file->now = file->flushed = read_file(entry.path());
    files_[info.st_ino] = file;
    top_->now[entry.path().filename()] = file;
  }
  top_->flushed = top_->now;
}

ModelFolder* DiskModel::folder(const fs::path& path) {
  ModelFolder* here = top_.get();
  for (const fs::path& part : path.lexically_relative(root_)) {
    if (part == ".") continue;
    const auto entry = here->now.find(part);
    if (entry == here->now.end()) return nullptr;
    const auto* next = std::get_if<std::shared_ptr<ModelFolder>>(&entry->second);
    if (next == nullptr) return nullptr;
    here = next->get();
  }
  return here;
}

void DiskModel::make_file(const DiskEvent& event) {
  ModelFolder* parent = parent_of(event.path);
  if (parent == nullptr) return;
  const auto entry = parent->now.find(event.path.filename());
  const auto known = files_.find(event.inode);
  const bool is_there = entry != parent->now.end() && known != files_.end() &&
                        entry->second == ModelNode(known->second);
  if (!is_there) {
    files_[event.inode] = std::make_shared<ModelFile>();
    parent->now[event.path.filename()] = files_[event.inode];
  } else if (event.size == 0) {
    known->second->resize(0);
  }
}

void DiskModel::rename(const DiskEvent& event) {
  ModelFolder *from = parent_of(event.path), *to = parent_of(event.target);
  if (from == nullptr || to == nullptr) return;
  const auto entry = from->now.find(event.path.filename());
  if (entry == from->now.end()) return;
  const ModelNode node = entry->second;
  from->now.erase(entry);
  to->now[event.target.filename()] = node;
}

void DiskModel::apply(const DiskEvent& event) {
  using Kind = DiskEvent::Kind;
  const auto file = files_.find(event.inode);
  const bool known = file != files_.end();
  switch (event.kind) {
    case Kind::make_folder:
      if (ModelFolder* parent = parent_of(event.path))
        parent->now.try_emplace(event.path.filename(), std::make_shared<ModelFolder>());
      return;
    case Kind::make_file:
      return make_file(event);
    case Kind::write:
      if (known) file->second->write(static_cast<std::size_t>(event.offset), event.bytes);
      return;
    case Kind::resize:
      if (known) file->second->resize(static_cast<std::size_t>(event.size));
      return;
    case Kind::sync:
      if (known) file->second->sync();
      return;
    case Kind::sync_folder:
      if (ModelFolder* synced = folder(event.path)) synced->flushed = synced->now;
      return;
    case Kind::rename:
      return rename(event);
    case Kind::remove:
      if (ModelFolder* parent = parent_of(event.path)) parent->now.erase(event.path.filename());
      return;
    case Kind::say:
      return;
  }
}

namespace {

/// Of one file or folder.
Unsynced chosen(Unsynced unsynced, std::mt19937& dice) {
  if (unsynced != Unsynced::mixed) return unsynced;
  return unsynced_kinds[dice() % (std::size(unsynced_kinds) - 1)];
}

void add(const ModelFolder& folder, const std::string& prefix, Unsynced unsynced,
         std::mt19937& dice, DiskModel::State& state) {
  const bool names_are_lost = chosen(unsynced, dice) == Unsynced::dropped;
  for (const auto& [name, node] : names_are_lost ? folder.flushed : folder.now) {
    if (const auto* below = std::get_if<std::shared_ptr<ModelFolder>>(&node)) {
      state[prefix + name + "/"];
      add(**below, prefix + name + "/", unsynced, dice, state);
    } else {
      const auto& file = *std::get<std::shared_ptr<ModelFile>>(node);
      state[prefix + name] = file.after_cut(chosen(unsynced, dice));
    }
  }
}

}  // namespace

DiskModel::State DiskModel::after_cut(Unsynced unsynced, std::mt19937& dice) const {
  State state;
  add(*top_, "", unsynced, dice, state);
  return state;
}

void install_state(const DiskModel::State& state, const fs::path& folder) {
  for (const auto& [name, bytes] : state)  // a folder's name comes before those in it
    if (name.ends_with('/'))
      fs::create_directories(folder / name);
    else
      std::ofstream(folder / name, std::ios::binary) << bytes;
}

}  // namespace eerie::test
