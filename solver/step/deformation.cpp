#include "solver/step/deformation.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "solver/base/constants.hpp"
#include "solver/scene/two_materials.hpp"
#include "solver/tree/kd_tree.hpp"
#include "solver/tree/neighbour_list.hpp"

namespace eerie::step {

namespace {
constexpr std::size_t one_in = 100;  ///< particles may be faster
}  // namespace

double deformation_rate(const particles::State& s) {
  tree::KdTree tree(s.size());
  tree.fit(s.x);
  tree::NeighbourList lists(2 * s.h, 0);
  lists.build(tree, s.x);
  std::vector<double> rates(s.size());
#pragma omp parallel for schedule(static)
  for (std::size_t b = 0; b < lists.buckets(); ++b) {
    const tree::BucketList& list = lists[b];
    for (std::size_t k = 0, i = b * tree::bucket_size; k < tree::bucket_size && i < s.size();
         ++k, ++i) {
      double apart = 0, faster = 0;
      for (std::uint32_t e = list.begin[k]; e < list.begin[k + 1]; ++e) {
        const std::size_t place = list.index[e];
        if (place >= list.rows.size()) continue;  // padding
        const std::size_t j = list.rows[place];
        apart += norm2(s.x[i] - s.x[j]);
        faster += norm2(s.v[i] - s.v[j]);
      }
      rates[i] = apart > 0 ? std::sqrt(faster / apart) : 0;
    }
  }
  const auto nth = rates.begin() + static_cast<std::ptrdiff_t>((s.size() - 1) / one_in);
  std::ranges::nth_element(rates, nth, std::greater<>());
  return *nth;
}

double flow_speed(const io::Snapshot& snapshot) {
  const particles::State& s = snapshot.state;
  const double volume = s.mass * static_cast<double>(s.size()) / lowest_density(snapshot.scene);
  return deformation_rate(s) * std::cbrt(3 * volume / (4 * pi));
}

}  // namespace eerie::step
