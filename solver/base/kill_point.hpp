#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace eerie {

/// The places at which a test can kill the process, as a power cut or SIGKILL would. A test
/// compares this table with the sources.
inline constexpr std::array<std::string_view, 11> kill_point_names = {
    "install.before-write",        // the temporary file does not exist
    "install.before-sync",         // the file is written, perhaps in memory only
    "install.before-rename",       // the file is on the disk under its temporary name
    "install.before-folder-sync",  // the file has its final name, perhaps in memory only
    "checkpoint.between",          // the former checkpoint is renamed, the new one has no name yet
    "manager.before-note",         // a worker has started, the database does not know
    "manager.before-commit",       // a worker has ended, the database does not know
    "manager.after-commit",        // the database knows, the manager's memory does not yet
    "inbox.before-remove",         // a request was carried out and still lies in the inbox
    "merge.before-commit",         // job directories are in place, the database is as it was
    "merge.before-install",        // a merged database is whole and has no name yet
};
inline constexpr bool is_kill_point(std::string_view name) {
  return std::ranges::find(kill_point_names, name) != kill_point_names.end();
}

/// Whether any kill point is armed; see arm_kill_point(). Unarmed points cost this one test.
extern bool kill_points_are_armed;

/// Arms a point at which this process kills itself. `NAME` arms a point, `NAME@FILE` arms it for
/// files of that name only, and `:N` behind either means the N-th passing (default: the first). The
/// program calls this at its start with the environment variable EERIE_KILL_AT. Throws InputError
/// for a name that is not in the table, since a test that misspells it would prove nothing.
void arm_kill_point(std::string_view where);

/// The slow part of kill_point().
void pass_kill_point(std::string_view name, std::string_view file);

/// Kills the process (SIGKILL) where a test has armed this point. Does nothing otherwise.
inline void kill_point(std::string_view name, std::string_view file = {}) {
  if (kill_points_are_armed) [[unlikely]]
    pass_kill_point(name, file);
}

}  // namespace eerie
