#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "analysis/remnants/clumps.hpp"
#include "solver/initial/bodies.hpp"
#include "solver/tree/gravity.hpp"
#include "solver/tree/neighbour_list.hpp"
#include "tests/proof/impact.hpp"
#include "tests/proof/record.hpp"

namespace eerie::proof {
namespace {

/// Pairs closer than `radius` that `lists` lack, and those they hold, counted over all pairs.
struct Coverage {
  double missing = 0, listed = 0, close = 0;
};
Coverage coverage(const tree::NeighbourList& lists, const std::vector<Vec3>& x, double radius) {
  Coverage found;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const tree::BucketList& list = lists[i / tree::bucket_size];
    const std::size_t k = i % tree::bucket_size;
    std::vector<bool> has(x.size(), false);
    for (std::uint32_t l = list.begin[k]; l < list.begin[k + 1]; ++l)
      if (list.index[l] < list.rows.size()) has[list.rows[list.index[l]]] = true, ++found.listed;
    for (std::size_t j = 0; j < x.size(); ++j) {
      if (i == j || norm2(x[i] - x[j]) >= radius * radius) continue;
      ++found.close;
      found.missing += !has[j];
    }
  }
  return found;
}

TEST(BruteForce, AgreesWithTheFastCodeInTheMiddleOfAnImpact) {
  Record record("validation", 12, "Fast code against brute force",
                "The reference impact (1,000 per target) at 6,000 s, a cigar with ejecta: "
                "neighbour lists and remnants by friends-of-friends against all pairs, gravity "
                "against the direct sum. `make test` does so for a dozen clouds of points, and "
                "axes and spins of exact ellipsoids.");
  particles::State s;
  const Scene scene = impact_scene(1000, nlohmann::json::object());
  followed(scene, 6000, 1, [&](const step::Solver& solver) { s = solver.state(); });
  ASSERT_GT(s.size(), 0u);
  tree::KdTree tree(s.size());
  tree.fit(s.x);

  tree::NeighbourList lists(2 * s.h, 0.2 * s.h);
  lists.build(tree, s.x);
  const Coverage found = coverage(lists, s.x, 2 * s.h);
  record.within("pairs within 2h that the lists lack", found.missing, 0, 0, "lists are complete");
  record.within("listed over close pairs", found.listed / found.close, 1, 1.5,
                "a skin of 0.1 adds (1.1)^3 = 1.33 inside a body");

  std::vector<Vec3> direct, g;
  tree::Gravity({s.mass, s.h, 0}).accelerations(tree, s.x, direct);
  double scale = 0;
  for (const Vec3& a : direct) scale += norm2(a);
  Curve error{"root-mean-square error", {}, {}, "linespoints lw 2 pt 7 ps 0.4"};
  for (const double theta : {0.1, 0.2, 0.35, 0.5, 0.7, 0.9, 1.2}) {
    tree::Gravity({s.mass, s.h, theta}).accelerations(tree, s.x, g);
    double sum = 0;
    for (std::size_t i = 0; i < g.size(); ++i) sum += norm2(g[i] - direct[i]);
    error.x.push_back(theta), error.y.push_back(std::sqrt(sum / scale));
    if (theta == 0.35)
      record.within("error of gravity at the default, theta 0.35", error.y.back(), 1e-9, 1e-3,
                    "quadrupoles leave theta^3 and more, 0.04 of the part that is not softened; "
                    "and an error there is: the tree is not the direct sum");
  }
  record.within("order of the error between theta 0.35 and 0.7", std::log2(error.y[4] / error.y[2]),
                2, 6, "octupoles are the first left out: theta^3, less what averages away");

  const auto fast = remnants::friends_of_friends(s.x, s.id, remnants::linking_length_over_h * s.h);
  std::vector<std::size_t> piece(s.size());
  for (std::size_t i = 0; i < piece.size(); ++i) piece[i] = i;
  const double link = remnants::linking_length_over_h * s.h;
  const auto root = [&](std::size_t i) {
    while (piece[i] != i) i = piece[i];
    return i;
  };
  for (std::size_t i = 0; i < s.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (norm2(s.x[i] - s.x[j]) < link * link) piece[root(i)] = root(j);
  double pieces = 0, split = 0;
  for (std::size_t i = 0; i < s.size(); ++i) pieces += root(i) == i;
  for (const remnants::Clump& clump : fast)
    for (const std::uint32_t i : clump) split += root(i) != root(clump.front());
  record.within("clumps, fast minus brute force", static_cast<double>(fast.size()) - pieces, 0, 0,
                "the same pieces");
  record.within("particles in another clump", split, 0, 0, "the same particles in them");
  record.figure({"gravity-error",
                 "Error of gravity (quadrupoles)",
                 "opening angle",
                 "relative error",
                 {error},
                 "set logscale xy; set format y '10^{%T}'"});
}

}  // namespace
}  // namespace eerie::proof
