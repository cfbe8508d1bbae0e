#pragma once

#include "solver/io/hdf5.hpp"
#include "solver/io/snapshot.hpp"

namespace eerie::io {

/// Writes one field, with SWIFT's description and unit attributes, into `group` under the name
/// of the field tables (state.hpp).
template <class T>
void write_field(hid_t group, const char* name, std::span<const T> data);

/// Writes what readers of SWIFT files (yt, swiftsimio) and of VTKHDF files (ParaView) look for,
/// by links to the exact fields in `state_group` wherever those will do. Nothing of it is read
/// back. docs/reference/snapshots.md lists it.
void write_swift_groups(hid_t file, hid_t state_group, const Snapshot& snapshot);
void write_vtkhdf_group(hid_t file, const Snapshot& snapshot);

/// Smallest axis-aligned box with a margin around all particles: readers drop or wrap what lies
/// outside [0, size].
struct SnapshotBox {
  Vec3 low;   ///< m; Coordinates = exact position - low
  Vec3 size;  ///< m
};
SnapshotBox snapshot_box(const particles::State& state);

}  // namespace eerie::io
