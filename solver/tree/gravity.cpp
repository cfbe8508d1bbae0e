#include "solver/tree/gravity.hpp"

#include <cmath>

#include "solver/base/constants.hpp"
#include "solver/base/simd/pack.hpp"

namespace eerie::tree {

namespace {

using P = Pack<float>;
constexpr int packs = static_cast<int>(bucket_size) / lanes<float>;

/// Targets of one bucket relative to its centre, and what they have gathered, in units of
/// particle mass and with G = 1.
struct Targets {
  P x[packs] = {}, y[packs] = {}, z[packs] = {};
  P ax[packs] = {}, ay[packs] = {}, az[packs] = {}, phi[packs] = {};
};

/// What a walk gathers at every target: the acceleration by all sources, or the potential by those
/// that follow in memory and half of that by its own bucket, so that the sum has every pair once.
enum class Field { acceleration, potential };

/// The particles of one leaf, relative to the centre of the targets' bucket.
struct Sources {
  int count;
  float x[KdTree::leaf_size], y[KdTree::leaf_size], z[KdTree::leaf_size];
};

/// Adds to one pack of targets what strength(r^2) gives for each source in turn.
template <Field field, class Strength>
[[gnu::always_inline]] inline void add_sources(Targets& t, int k, const Sources& sources,
                                               Strength&& strength) {
  const P x = t.x[k], y = t.y[k], z = t.z[k];
  P ax = t.ax[k], ay = t.ay[k], az = t.az[k], phi = t.phi[k];
  for (int j = 0; j < sources.count; ++j) {
    const P dx = x - sources.x[j], dy = y - sources.y[j], dz = z - sources.z[j];
    const P s = strength(P(dx * dx + dy * dy + dz * dz));
    if constexpr (field == Field::acceleration)
      ax -= dx * s, ay -= dy * s, az -= dz * s;
    else
      phi -= s;
  }
  t.ax[k] = ax, t.ay[k] = ay, t.az[k] = az, t.phi[k] = phi;
}

/// Point sources far enough for Newton's law.
template <Field field>
void add_points(Targets& t, int k, const Sources& sources) {
  add_sources<field>(
      t, k, sources, [](P r2) __attribute__((always_inline)) {
        const P s = inverse_sqrt(r2);
        return field == Field::acceleration ? P(s * s * s) : s;
      });
}

/// Particles that may be inside the softening: mass of the cubic spline within r.
template <Field field>
void add_softened(Targets& t, int k, const Sources& sources, float h) {
  const float ih = 1 / h;
  add_sources<field>(
      t, k, sources, [&](P d2) __attribute__((always_inline)) {
        const P r2 = d2 + 1e-12f * h * h, s = inverse_sqrt(r2), q = r2 * s * ih, q2 = q * q,
                q3 = q2 * q;
        const auto far = q >= 2, inner = q < 1;
        if constexpr (field == Field::acceleration) {
          const P newton = s * s * s;
          const P shell =
              newton * (q3 * (8.f / 3 + q * (-3.f + q * (1.2f - q * (1.f / 6)))) - 1.f / 15);
          const P core = ih * ih * ih * (4.f / 3 + q2 * (-1.2f + 0.5f * q));
          return P(far ? newton : inner ? core : shell);
        } else {
          const P shell = ih * (1.6f + q2 * (-4.f / 3 + q * (1.f + q * (-0.3f + q * (1.f / 30))))) -
                          s * (1.f / 15);
          const P core = ih * (1.4f + q2 * (-2.f / 3 + q2 * (0.3f - 0.1f * q)));
          return P(far ? s : inner ? core : shell);
        }
      });
}

/// A distant node: monopole and quadrupole about its centre of mass.
template <Field field>
void add_node(Targets& t, const Vec3& centre, float count, const SymTensorf& Q) {
  const auto sx = static_cast<float>(centre.x), sy = static_cast<float>(centre.y),
             sz = static_cast<float>(centre.z);
  const auto [xx, yy, zz, xy, xz, yz] = Q;
  for (int k = 0; k < packs; ++k) {
    const P dx = t.x[k] - sx, dy = t.y[k] - sy, dz = t.z[k] - sz;
    const P s = inverse_sqrt(P(dx * dx + dy * dy + dz * dz)), s2 = s * s;
    const P qx = xx * dx + xy * dy + xz * dz, qy = xy * dx + yy * dy + yz * dz,
            qz = xz * dx + yz * dy + zz * dz;
    const P rqr = (dx * qx + dy * qy + dz * qz) * s2;
    const P s3 = s2 * s, s5 = s3 * s2;
    if constexpr (field == Field::acceleration) {
      const P strength = count * s3 + 2.5f * rqr * s5;
      t.ax[k] -= dx * strength, t.ay[k] -= dy * strength, t.az[k] -= dz * strength;
      t.ax[k] += qx * s5, t.ay[k] += qy * s5, t.az[k] += qz * s5;
    } else {
      t.phi[k] -= count * s + 0.5f * rqr * s3;
    }
  }
}

}  // namespace

void Gravity::fit_moments(const KdTree& tree, const std::vector<Vec3>& x) {
  moments_.resize(tree.nodes.size());
  for (std::size_t n = tree.nodes.size(); n-- > 0;) {
    const KdTree::Node& node = tree.nodes[n];
    const double count = node.size();
    Vec3 centre, corner;
    SymTensor quadrupole;
    const auto add_quadrupole = [&](const Vec3& d, double n_of) {
      const double r2 = norm2(d);
      quadrupole += SymTensor{3 * d.x * d.x - r2, 3 * d.y * d.y - r2, 3 * d.z * d.z - r2,
                              3 * d.x * d.y,      3 * d.x * d.z,      3 * d.y * d.z} *
                    n_of;
    };
    if (node.is_leaf()) {
      for (std::uint32_t i = node.begin; i < node.end; ++i) centre += x[i];
      centre *= 1 / count;
      for (std::uint32_t i = node.begin; i < node.end; ++i) add_quadrupole(x[i] - centre, 1);
    } else {
      const Moments &l = moments_[node.left], &r = moments_[node.right];
      centre = (l.centre * l.count + r.centre * r.count) / count;
      for (const Moments* child : {&l, &r}) {
        quadrupole += to_double(child->quadrupole);
        add_quadrupole(child->centre - centre, child->count);
      }
    }
    for (int k = 0; k < 3; ++k)
      corner[k] = std::max(centre[k] - node.box.lo[k], node.box.hi[k] - centre[k]);
    const Moments m{centre, static_cast<float>(count), static_cast<float>(norm(corner)),
                    to_single(quadrupole)};
    moments_[n] = m;
  }
}

template <bool potential, class Store>
void Gravity::walk(const KdTree& tree, const std::vector<Vec3>& sources,
                   const std::vector<Vec3>& targets, Store&& store) {
  fit_moments(tree, sources);
  constexpr Field field = potential ? Field::potential : Field::acceleration;
  const double reach = 2 * p_.h;
  const double surely_beyond = 1.00001 * reach;  // with rounded distances too
  const auto h = static_cast<float>(p_.h);
#pragma omp parallel
  {
    std::vector<std::uint32_t> stack;
#pragma omp for schedule(dynamic, 2)
    for (std::size_t b = 0; b < bucket_count(targets.size()); ++b) {
      const std::size_t first = b * bucket_size,
                        last = std::min(first + bucket_size, targets.size());
      const int filled = static_cast<int>(last - first + lanes<float> - 1) / lanes<float>;
      Box box, boxes[packs];
      for (std::size_t i = first; i < last; ++i)
        boxes[static_cast<int>(i - first) / lanes<float>].include(targets[i]);
      for (int k = 0; k < filled; ++k) box.include(boxes[k]);
      const Vec3 origin = box.centre();
      Targets t;
      for (std::size_t i = first; i < last; ++i) {
        const int k = static_cast<int>(i - first) / lanes<float>,
                  l = static_cast<int>(i - first) % lanes<float>;
        const Vec3 d = targets[i] - origin;
        t.x[k][l] = static_cast<float>(d.x), t.y[k][l] = static_cast<float>(d.y),
        t.z[k][l] = static_cast<float>(d.z);
      }
      bool among_own = true;
      const auto leave_own = [&] {
        among_own = false;
        for (P& phi : t.phi) phi *= 0.5f;
      };
      stack.assign(1, 0);
      while (!stack.empty()) {
        const std::uint32_t n = stack.back();
        stack.pop_back();
        const KdTree::Node& node = tree.nodes[n];
        if constexpr (potential) {
          if (node.end <= first) continue;  // these pairs are theirs
          if (among_own && node.begin >= last) leave_own();
        }
        const Moments& m = moments_[n];
        const double d2 = distance2(box, m.centre),
                     theta_d2 = p_.opening_angle * p_.opening_angle * d2, size = m.size;
        if (size * size < theta_d2 && d2 > (size + reach) * (size + reach)) {
          add_node<field>(t, m.centre - origin, m.count, m.quadrupole);
        } else if (!node.is_leaf()) {
          stack.push_back(node.right);
          stack.push_back(node.left);
        } else {
          Sources leaf{static_cast<int>(node.size()), {}, {}, {}};
          for (int j = 0; j < leaf.count; ++j) {
            const Vec3 d = sources[node.begin + static_cast<std::uint32_t>(j)] - origin;
            leaf.x[j] = static_cast<float>(d.x), leaf.y[j] = static_cast<float>(d.y),
            leaf.z[j] = static_cast<float>(d.z);
          }
          const bool all_far = distance2(box, node.box) > reach * reach;
          for (int k = 0; k < filled; ++k)
            if (all_far || distance2(boxes[k], node.box) > surely_beyond * surely_beyond)
              add_points<field>(t, k, leaf);
            else
              add_softened<field>(t, k, leaf, h);
        }
      }
      if (potential && among_own) leave_own();
      for (std::size_t i = first; i < last; ++i) {
        const int k = static_cast<int>(i - first) / lanes<float>,
                  l = static_cast<int>(i - first) % lanes<float>;
        store(i, Vec3{t.ax[k][l], t.ay[k][l], t.az[k][l]}, static_cast<double>(t.phi[k][l]));
      }
    }
  }
}

void Gravity::accelerations(const KdTree& tree, const std::vector<Vec3>& x, std::vector<Vec3>& g) {
  g.resize(x.size());
  const RigidField net = accelerations(tree, x, [&](std::size_t i, const Vec3& a) { g[i] = a; });
  for (std::size_t i = 0; i < x.size(); ++i) g[i] -= net.at(x[i]);
}

RigidField Gravity::accelerations(const KdTree& tree, const std::vector<Vec3>& x,
                                  const std::function<void(std::size_t, const Vec3&)>& store) {
  const double scale = newton_G * p_.particle_mass;
  // Sums of each bucket, so that every number of threads finds the same.
  std::vector<RigidSums> parts(bucket_count(x.size()));
  walk<false>(tree, x, x, [&](std::size_t i, const Vec3& a, double) {
    store(i, scale * a);
    parts[i / bucket_size].add(x[i] - moments_.front().centre, scale * a);
  });
  RigidSums sum;
  for (const RigidSums& part : parts) sum += part;
  return sum.field(moments_.front().centre, static_cast<double>(x.size()));
}

void Gravity::accelerations(const KdTree& tree, const std::vector<Vec3>& sources,
                            const std::vector<Vec3>& targets,
                            const std::function<void(std::size_t, const Vec3&)>& store) {
  const double scale = newton_G * p_.particle_mass;
  walk<false>(tree, sources, targets,
              [&](std::size_t i, const Vec3& a, double) { store(i, scale * a); });
}

double Gravity::potential_energy(const KdTree& tree, const std::vector<Vec3>& x) {
  std::vector<double> phi(x.size());
  // A particle does not feel itself: take half of its softened potential, 1.4/h, out again.
  walk<true>(tree, x, x, [&](std::size_t i, const Vec3&, double p) { phi[i] = p + 0.7 / p_.h; });
  double sum = 0;
  for (double p : phi) sum += p;
  return newton_G * p_.particle_mass * p_.particle_mass * sum;
}

}  // namespace eerie::tree
