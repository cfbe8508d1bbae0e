#pragma once

#include "solver/io/hdf5.hpp"
#include "solver/io/snapshot.hpp"

namespace eerie::io {

/// Writes one field into `group`, under its name in the field tables (state.hpp), with SWIFT's
/// attributes for description and unit.
template <class T>
void write_field(hid_t group, const char* name, std::span<const T> data);

/// Writes the groups that readers of SWIFT files (yt, swiftsimio) and of VTKHDF files (ParaView)
/// expect. Where possible these are links to the exact fields in `state_group`. eerie never reads
/// them back. docs/reference/snapshots.md lists them.
void write_swift_groups(hid_t file, hid_t state_group, const Snapshot& snapshot);
void write_vtkhdf_group(hid_t file, const Snapshot& snapshot);

/// The smallest box along the axes, with a margin, around all particles. Readers drop or wrap
/// particles outside [0, size].
struct SnapshotBox {
  Vec3 low;   ///< m; Coordinates = exact position - low
  Vec3 size;  ///< m
};
SnapshotBox snapshot_box(const particles::State& state);

}  // namespace eerie::io
