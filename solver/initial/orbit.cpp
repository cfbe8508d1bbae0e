#include "solver/initial/orbit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/base/error.hpp"

namespace eerie::initial {

RelativeOrbit orbit_at_contact(double contact, double v_imp, double theta_imp) {
  // Line of centres turned by theta_imp from +x, towards +y: then x cross v has +z.
  return {{contact * std::cos(theta_imp), contact * std::sin(theta_imp), 0}, {-v_imp, 0, 0}};
}

RelativeOrbit orbit_before_contact(const RelativeOrbit& at_contact, double mu, double distance) {
  const Vec3 &r = at_contact.position, &v = at_contact.velocity;
  const double energy = 0.5 * norm2(v) - mu / norm(r);
  const double speed2 = 2 * (energy + mu / distance);
  const Vec3 momentum = cross(r, v);
  const double h2 = norm2(momentum), radial2 = speed2 - h2 / (distance * distance);
  if (radial2 < 0)
    throw InputError(fmt::format(
        "scene.impact.v_imp_cm_per_s = {:g}: on this orbit the bodies were never {:.4g} m apart; "
        "raise v_imp_cm_per_s or lower impact.separation",
        100 * norm(v), distance));

  // Laplace-Runge-Lenz vector: points to pericentre, its length is the eccentricity.
  const Vec3 e = cross(v, momentum) / mu - r / norm(r);
  const double eccentricity = norm(e);
  const double p = h2 / mu;  // semi-latus rectum
  const double cosine = std::clamp((p / distance - 1) / eccentricity, -1.0, 1.0);
  const double sine = -std::sqrt(1 - cosine * cosine);  // before pericentre: negative anomaly
  const Vec3 to_pericentre = e / eccentricity;
  // In the orbital plane, 90 deg ahead of pericentre; a head-on orbit has no plane and no need.
  const Vec3 ahead = h2 > 0 ? cross(momentum / std::sqrt(h2), to_pericentre) : Vec3{};
  const Vec3 outward = cosine * to_pericentre + sine * ahead;
  const Vec3 tangent = h2 > 0 ? cross(momentum / std::sqrt(h2), outward) : Vec3{};
  return {distance * outward, -std::sqrt(radial2) * outward + (std::sqrt(h2) / distance) * tangent};
}

namespace {

/// The two bodies as points, and the tide upon them.
class Approach {
 public:
  Approach(double mu, const Tide& tide, double share) : mu_(mu), tide_(tide), share_(share) {}

  /// The state a while later (earlier, where dt is negative), by one step of the classical
  /// Runge-Kutta method.
  RelativeOrbit after(const RelativeOrbit& o, double time, double dt) const {
    const RelativeOrbit a = rate(o, time);
    const RelativeOrbit b = rate(moved(o, a, dt / 2), time + dt / 2);
    const RelativeOrbit c = rate(moved(o, b, dt / 2), time + dt / 2);
    const RelativeOrbit d = rate(moved(o, c, dt), time + dt);
    return {o.position + dt / 6 * (a.position + 2.0 * b.position + 2.0 * c.position + d.position),
            o.velocity + dt / 6 * (a.velocity + 2.0 * b.velocity + 2.0 * c.velocity + d.velocity)};
  }

 private:
  static RelativeOrbit moved(const RelativeOrbit& o, const RelativeOrbit& rate, double dt) {
    return {o.position + dt * rate.position, o.velocity + dt * rate.velocity};
  }
  RelativeOrbit rate(const RelativeOrbit& o, double time) const {
    const Vec3 &r = o.position, primary = tide_.place(time);
    const double distance = norm(r);
    return {o.velocity, -mu_ / (distance * distance * distance) * r +
                            tide_.acceleration((1 - share_) * r, primary) -
                            tide_.acceleration(-share_ * r, primary)};
  }

  double mu_;
  const Tide& tide_;
  double share_;
};

struct Start {
  RelativeOrbit orbit;
  double lead;  ///< from there to contact, s
};

/// Goes back from a contact at the time `contact_at` until the bodies are `distance` apart.
Start back_from(const RelativeOrbit& at_contact, double contact_at, double distance,
                const Approach& approach) {
  constexpr int steps_per_contact = 200, most_steps = 100'000;
  constexpr int halvings = 50;
  const double dt = norm(at_contact.position) / norm(at_contact.velocity) / steps_per_contact;
  RelativeOrbit now = at_contact;
  for (int k = 0; k < most_steps; ++k) {
    const double time = contact_at - k * dt;
    const RelativeOrbit before = approach.after(now, time, -dt);
    if (norm(before.position) < norm(now.position)) break;  // they would have come from contact
    if (norm(before.position) < distance) {
      now = before;
      continue;
    }
    double low = 0, high = dt;
    for (int h = 0; h < halvings; ++h) {
      const double middle = (low + high) / 2;
      const bool is_near = norm(approach.after(now, time, -middle).position) < distance;
      (is_near ? low : high) = middle;
    }
    return {approach.after(now, time, -high), k * dt + high};
  }
  throw InputError(
      fmt::format("scene.impact.v_imp_cm_per_s = {:g}: in the tide of environment.primary the "
                  "bodies were never "
                  "{:.4g} m apart; raise v_imp_cm_per_s or lower impact.separation",
                  100 * norm(at_contact.velocity), distance));
}

}  // namespace

RelativeOrbit orbit_before_contact(const RelativeOrbit& at_contact, double mu, double distance,
                                   const Tide& tide, double share) {
  const Approach approach(mu, tide, share);
  // Where the primary is at contact depends on how long the bodies have come: the secant method.
  constexpr int rounds = 30;
  double before = 0, off_before = back_from(at_contact, before, distance, approach).lead;
  double lead = off_before;
  for (int k = 0; k < rounds; ++k) {
    const Start start = back_from(at_contact, lead, distance, approach);
    const double off = start.lead - lead;
    if (std::abs(off) <= 1e-9 * start.lead) return start.orbit;
    const double next = lead - off * (lead - before) / (off - off_before);
    before = lead, off_before = off;
    if (!(next > 0 && std::isfinite(next))) break;
    lead = next;
  }
  throw InputError(fmt::format(
      "scene.impact.separation: on the way of the bodies from {:.4g} m apart to their contact the "
      "primary turns too far; lower impact.separation or raise v_imp_cm_per_s",
      distance));
}

}  // namespace eerie::initial
