#include "db/store/file_system.hpp"

#include <fmt/format.h>
#include <sys/vfs.h>

#include <cerrno>
#include <cstring>

#include "db/store/error.hpp"

namespace eerie::db {
namespace fs = std::filesystem;

namespace {

struct NamedType {
  unsigned long type;
  const char* name;
};

// statfs(2) and the file systems' own headers.
constexpr NamedType network_types[] = {
    {0x6969, "NFS"},        {0x517B, "SMB"},       {0xFF534D42, "CIFS"},   {0xFE534D42, "SMB2"},
    {0x0BD00BD0, "Lustre"}, {0x47504653, "GPFS"},  {0x19830326, "BeeGFS"}, {0x00C36400, "CephFS"},
    {0x5346414F, "AFS"},    {0xAAD7AAEA, "PanFS"}, {0x7461636F, "OCFS2"},  {0x20030528, "OrangeFS"},
};

}  // namespace

const char* network_file_system(unsigned long statfs_type) {
  for (const NamedType& entry : network_types)
    if (entry.type == (statfs_type & 0xFFFFFFFFUL)) return entry.name;
  return nullptr;
}

void require_local_disk(const fs::path& path) {
  std::error_code ignored;
  fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (fs::exists(path, ignored)) folder = path;
  struct statfs info {};
  if (::statfs(folder.c_str(), &info) != 0)
    throw Error(fmt::format(
        "database {}: cannot look at {}: {}; make the folder or give another file to --db",
        path.string(), folder.string(), std::strerror(errno)));
  if (const char* name = network_file_system(static_cast<unsigned long>(info.f_type)))
    throw Error(
        fmt::format("database {}: it lies on {}, where SQLite's locks do not hold and two hosts "
                    "would damage it; "
                    "give --db a file on a local disk (job folders may lie on {})",
                    path.string(), name, name));
}

}  // namespace eerie::db
