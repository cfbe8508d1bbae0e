#pragma once

#include <vector>

#include "solver/base/box.hpp"
#include "solver/base/tensor.hpp"
#include "solver/base/vec3.hpp"

namespace eerie::tree {

/// A mirror image of the whole scene: x becomes sign x + shift, component by component. The kind of
/// wall decides how velocities and stresses change sign.
struct MirrorImage {
  Vec3 sign{1, 1, 1}, shift;
  Vec3 velocity_sign{1, 1, 1};
  Vec3 stress_sign{1, 1, 1};  ///< component ab is multiplied by stress_sign[a] stress_sign[b]

  Vec3 operator()(const Vec3& x) const {
    return {sign.x * x.x + shift.x, sign.y * x.y + shift.y, sign.z * x.z + shift.z};
  }
  Box operator()(const Box& box) const {
    Box image;
    image.include((*this)(box.lo));
    image.include((*this)(box.hi));
    return image;
  }
  Vec3 velocity(const Vec3& v) const {
    return {velocity_sign.x * v.x, velocity_sign.y * v.y, velocity_sign.z * v.z};
  }
  SymTensor stress(const SymTensor& s) const { return with_signs(s, stress_sign); }
  /// The image of a tensor that is made of positions.
  SymTensor geometry(const SymTensor& s) const { return with_signs(s, sign); }

 private:
  static SymTensor with_signs(const SymTensor& s, const Vec3& e) {
    return {s.xx, s.yy, s.zz, e.x * e.y * s.xy, e.x * e.z * s.xz, e.y * e.z * s.yz};
  }
};

/// A plane that mirrors. A slip wall reflects velocity and stress, and so carries no shear. A rough
/// wall reverses the whole velocity and keeps the stress, so that material sticks to it until its
/// own strength yields.
struct Mirror {
  int axis;
  bool low;  ///< the scene lies above it
  double at;
  bool rough;
};

/// `image`, seen in a further mirror on another axis.
inline MirrorImage reflected(MirrorImage image, const Mirror& mirror) {
  image.sign[mirror.axis] = -1;
  image.shift[mirror.axis] = 2 * mirror.at;
  for (int a = 0; a < 3; ++a)
    if (mirror.rough || a == mirror.axis) image.velocity_sign[a] *= -1;
  if (!mirror.rough) image.stress_sign[mirror.axis] *= -1;
  return image;
}

/// All images that `mirrors` (at most two on each axis) make with at most one reflection per axis.
/// These suffice while two mirrors of an axis are further apart than the radius of the neighbour
/// search.
inline std::vector<MirrorImage> images_of(const std::vector<Mirror>& mirrors) {
  std::vector<MirrorImage> images{MirrorImage{}};
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t before = images.size();
    for (const Mirror& mirror : mirrors) {
      if (mirror.axis != axis) continue;
      for (std::size_t k = 0; k < before; ++k) images.push_back(reflected(images[k], mirror));
    }
  }
  images.erase(images.begin());  // the scene itself
  return images;
}

}  // namespace eerie::tree
