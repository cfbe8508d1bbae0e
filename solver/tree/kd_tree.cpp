#include "solver/tree/kd_tree.hpp"

#include <algorithm>
#include <numeric>

namespace eerie::tree {

namespace {

/// Where a range is halved: at a multiple of the bucket size while it is longer than a bucket.
std::uint32_t middle(std::uint32_t begin, std::uint32_t end) {
  const std::uint32_t n = end - begin, unit = n > bucket_size ? std::uint32_t{bucket_size} : 1;
  const std::uint32_t units = (n + unit - 1) / unit;
  return begin + (units + 1) / 2 * unit;
}

std::uint32_t grow(std::vector<KdTree::Node>& nodes, std::uint32_t begin, std::uint32_t end) {
  const auto self = static_cast<std::uint32_t>(nodes.size());
  nodes.push_back({begin, end, KdTree::none, KdTree::none, {}});
  if (end - begin > KdTree::leaf_size) {
    const std::uint32_t mid = middle(begin, end);
    const std::uint32_t left = grow(nodes, begin, mid), right = grow(nodes, mid, end);
    nodes[self].left = left;
    nodes[self].right = right;
  }
  return self;
}

struct Sorter {
  const std::vector<Vec3>& x;
  const std::vector<std::uint32_t>& id;
  std::vector<std::uint32_t>& order;

  void sort(std::uint32_t begin, std::uint32_t end) {
    const auto first = order.begin() + begin, last = order.begin() + end;
    if (end - begin <= KdTree::leaf_size) {
      std::sort(first, last, [&](auto i, auto j) { return id[i] < id[j]; });
      return;
    }
    Box box;
    for (auto it = first; it != last; ++it) box.include(x[*it]);
    const Vec3 e = box.extent();
    const int axis = e.x >= e.y && e.x >= e.z ? 0 : e.y >= e.z ? 1 : 2;
    const std::uint32_t mid = middle(begin, end);
    // Ties are broken by id, so the two halves do not depend on the order they came in.
    std::nth_element(first, order.begin() + mid, last, [&](auto i, auto j) {
      return x[i][axis] != x[j][axis] ? x[i][axis] < x[j][axis] : id[i] < id[j];
    });
    sort(begin, mid);
    sort(mid, end);
  }
};

}  // namespace

KdTree::KdTree(std::size_t particles) {
  nodes.reserve(2 * particles / leaf_size + 64);  // full leaves, but for the last bucket
  grow(nodes, 0, static_cast<std::uint32_t>(particles));
}

void KdTree::fit(const std::vector<Vec3>& x) {
#pragma omp parallel for schedule(static)
  for (Node& node : nodes) {
    node.box = Box{};
    if (node.is_leaf())
      for (std::uint32_t i = node.begin; i < node.end; ++i) node.box.include(x[i]);
  }
  for (std::size_t n = nodes.size(); n-- > 0;) {  // children come after their parent
    Node& node = nodes[n];
    if (node.is_leaf()) continue;
    node.box.include(nodes[node.left].box);
    node.box.include(nodes[node.right].box);
  }
}

std::vector<std::uint32_t> kd_order(const std::vector<Vec3>& x,
                                    const std::vector<std::uint32_t>& id) {
  std::vector<std::uint32_t> order(x.size());
  std::iota(order.begin(), order.end(), 0u);
  Sorter{x, id, order}.sort(0, static_cast<std::uint32_t>(x.size()));
  return order;
}

}  // namespace eerie::tree
