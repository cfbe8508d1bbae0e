#pragma once

#include <filesystem>

#include "analysis/shapes/shape.hpp"
#include "solver/io/snapshot.hpp"

namespace eerie::remnants {

/// A remnant by itself, as target of another impact (scene.target.remnant): about the origin, its
/// longest axis along x, its shortest along z, and its spin with a part along +z.
struct Alone {
  io::Snapshot snapshot;  ///< its particles, with ids from 0, at time 0
  shapes::Shape shape;    ///< its axes are those of space
};

/// The remnant of this rank in mass, from 1 on, of a snapshot read from `path`. Throws InputError
/// where there are fewer.
Alone alone(const io::Snapshot& snapshot, int rank, const std::filesystem::path& path);

}  // namespace eerie::remnants
