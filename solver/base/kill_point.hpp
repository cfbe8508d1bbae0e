#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace eerie {

/// Places at which a test can have the process killed, as a power cut or SIGKILL would. A test
/// holds this table against the sources.
inline constexpr std::array<std::string_view, 9> kill_point_names = {
    "install.before-write",        // the temporary file does not exist
    "install.before-sync",         // it is written, maybe in memory only
    "install.before-rename",       // it is on the disk under its temporary name
    "install.before-folder-sync",  // it has its name, maybe in memory only
    "checkpoint.between",          // the former checkpoint has moved on, the new one has no name
    "manager.before-note",         // a worker has started, the database does not know
    "manager.before-commit",       // a worker has ended, the database does not know
    "manager.after-commit",        // the database knows, the manager has not moved on
    "inbox.before-remove",         // a request was carried out and lies in the inbox still
};
inline constexpr bool is_kill_point(std::string_view name) {
  return std::ranges::find(kill_point_names, name) != kill_point_names.end();
}

/// Whether the next lines cost more than this look; see arm_kill_point().
extern bool kill_points_are_armed;

/// Has this process kill itself at a point: "NAME", "NAME@FILE" (only where the point is passed
/// for a file of that name), either with ":N" behind it (at the N-th passing, default the first).
/// Done at the start from the environment variable EERIE_KILL_AT. Throws InputError for a name
/// that is not in the table: a test that misspells it would prove nothing.
void arm_kill_point(std::string_view where);

/// Behind kill_point().
void pass_kill_point(std::string_view name, std::string_view file);

/// Kills the process (SIGKILL) where a test armed this point; else does nothing.
inline void kill_point(std::string_view name, std::string_view file = {}) {
  if (kill_points_are_armed) [[unlikely]]
    pass_kill_point(name, file);
}

}  // namespace eerie
