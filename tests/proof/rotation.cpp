#include "tests/proof/rotation.hpp"

#include <cmath>

#include "analysis/shapes/shape.hpp"
#include "solver/step/solver.hpp"
#include "tests/proof/lab.hpp"

namespace eerie::proof {

Rotated rotated_sphere(const std::string& gradient, double turns, double cfl) {
  const Scene scene = lab_scene({{"material", elastic_material(1000, 1000, 1000)},
                                 {"numerics", {{"gradient", gradient}, {"cfl", cfl}}}});
  particles::State state =
      lattice_block({-1, -1, -1}, {1, 1, 1}, 0.2, 1000, [](const Vec3& x) { return norm2(x) < 1; });
  const Vec3 omega{0, 0, 2 * pi / 100};
  for (std::size_t i = 0; i < state.size(); ++i) state.v[i] = cross(omega, state.x[i]);
  step::Solver solver(scene, state);
  struct Now {
    double spin, momentum, radius;
  };
  const auto now = [&] {
    double L = 0, r2 = 0;
    const particles::State& s = solver.state();
    for (std::size_t i = 0; i < s.size(); ++i) L += cross(s.x[i], s.v[i]).z, r2 += norm2(s.x[i]);
    const auto spin = shapes::angular_velocity(s.x, s.v);
    return Now{spin ? spin->z : 0, L, std::sqrt(r2)};
  };
  const Now first = now();
  Rotated result;
  for (int row = 0; row <= 100; ++row) {
    const double time = turns * 100 * row / 100;
    while (solver.state().time < time * (1 - 1e-12)) solver.cycle(time);
    const Now n = now();
    result.turns.push_back(time / 100);
    result.spin.push_back(n.spin / first.spin);
    result.angular_momentum.push_back(n.momentum / first.momentum);
    result.radius.push_back(n.radius / first.radius);
  }
  return result;
}

}  // namespace eerie::proof
