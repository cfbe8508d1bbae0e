#pragma once

#include <string>

#include "solver/base/vec3.hpp"
#include "solver/scene/scene.hpp"

namespace eerie {

/// Whether the bodies are about a heavier one (scene.environment.primary).
bool has_primary(const Scene& scene);
/// Whether remnants may fly as rigid bodies (numerics.rigid_flight). Flights know no tide.
bool may_fly(const Scene& scene);
/// The same impact far from everything.
Scene without_primary(Scene scene);

/// Throws InputError where the primary lies among the bodies, has no extent, or acts on bodies that
/// do not attract each other. `where` names the scene.
void require_primary(const Scene& scene, const std::string& where);

/// The tide of a primary, in the frame of a point that goes about it on a circle without turning:
/// the frame of the bodies' common centre. The circle lies in the plane of the impact. The
/// primary is a homogeneous ball, and so heavy that the bodies do not move it.
class Tide {
 public:
  explicit Tide(const Scene::Primary& primary);

  /// Where the primary is at a time (s), m.
  Vec3 place(double time) const;
  /// The pull at the place x (m) of a primary at the place `primary`, less that on the origin,
  /// m/s^2. Without a primary it is zero.
  Vec3 acceleration(const Vec3& x, const Vec3& primary) const;
  /// The rate of its revolution about +z, rad/s; negative where it is retrograde.
  double rate() const { return rate_; }

 private:
  double pull_, distance_, radius_, azimuth_, rate_;
};

/// Where the tide of the primary outdoes the attraction of both bodies, m from their centre
/// (Hill's radius); infinity without a primary.
double hill_radius(const Scene& scene);

}  // namespace eerie
