#include "point_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace burin {
namespace {

constexpr std::uint32_t kLeaf = 8;  // points

double squared(Vec2 v) { return glm::dot(v, v); }

double squared_distance(const Box2& box, Vec2 p) {
  return squared(glm::max(glm::max(box.min - p, p - box.max), Vec2(0)));
}

}  // namespace

PointTree::PointTree(std::vector<Vec2> points, const RunContext& context)
    : points_(std::move(points)), order_(points_.size()), leaf_(points_.size(), kNone) {
  std::iota(order_.begin(), order_.end(), 0U);
  nodes_.reserve(points_.size() / 2 + 1);
  Node root;
  root.end = static_cast<std::uint32_t>(points_.size());
  nodes_.push_back(root);
  // Nodes are divided in the order in which they were made.
  for (std::uint32_t node = 0; node < nodes_.size(); ++node) divide(node, context);
}

void PointTree::divide(std::uint32_t node, const RunContext& context) {
  const std::uint32_t begin = nodes_[node].begin, end = nodes_[node].end;
  Box2& box = nodes_[node].box;
  for (std::uint32_t i = begin; i < end; ++i) box.add(points_[order_[i]]);
  nodes_[node].count = end - begin;
  const auto at = [&](std::uint32_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  if (end - begin <= kLeaf) {
    std::sort(at(begin), at(end));
    for (std::uint32_t i = begin; i < end; ++i) leaf_[order_[i]] = node;
    return;
  }
  const int axis = box.size().x < box.size().y ? 1 : 0;
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(at(begin), at(middle), at(end), [&](std::uint32_t a, std::uint32_t b) {
    context.check();
    return std::pair(points_[a][axis], a) < std::pair(points_[b][axis], b);
  });
  Node low, high;
  low.begin = begin;
  low.end = high.begin = middle;
  high.end = end;
  low.above = high.above = node;
  nodes_[node].left = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back(low);
  nodes_.push_back(high);
}

void PointTree::remove(std::uint32_t point) {
  for (std::uint32_t node = std::exchange(leaf_[point], kNone); node != kNone;
       node = nodes_[node].above) {
    --nodes_[node].count;
  }
}

/// Calls `visit` with each point that is left and its squared distance, but for those in boxes not
/// nearer than `reach()`; near ones first.
template <class Visit, class Reach>
void PointTree::search(Vec2 place, const Visit& visit, const Reach& reach) const {
  // Halving leaves at most 32 levels.
  std::array<std::pair<std::uint32_t, double>, 40> open;
  std::size_t depth = 0;
  open[depth++] = {0, squared_distance(nodes_[0].box, place)};
  while (depth > 0) {
    const auto [number, distance] = open[--depth];
    const Node& node = nodes_[number];
    if (node.count == 0 || distance >= reach()) continue;
    if (node.left == 0) {
      for (std::uint32_t i = node.begin; i < node.end; ++i) {
        const std::uint32_t point = order_[i];
        if (leaf_[point] != kNone) visit(point, squared(points_[point] - place));
      }
      continue;
    }
    std::pair low(node.left, squared_distance(nodes_[node.left].box, place));
    std::pair high(node.left + 1, squared_distance(nodes_[node.left + 1].box, place));
    if (high.second < low.second) std::swap(low, high);
    open[depth++] = high;
    open[depth++] = low;
  }
}

std::optional<std::uint32_t> PointTree::nearest(Vec2 place) const {
  std::optional<std::uint32_t> found;
  double best = std::numeric_limits<double>::infinity();
  search(
      place,
      [&](std::uint32_t point, double distance) {
        if (distance >= best) return;
        best = distance;
        found = point;
      },
      [&] { return best; });
  return found;
}

std::vector<PointTree::Near> PointTree::near(Vec2 place, std::size_t most, double radius) const {
  std::vector<Near> found;
  found.reserve(most + 1);
  // Points exactly at the radius count: boxes are asked for a little more.
  const double limit = radius * radius * (1 + 1e-12);
  const auto reach = [&] { return found.size() < most ? limit : found.back().distance; };
  search(
      place,
      [&](std::uint32_t point, double distance) {
        if (distance > limit || (found.size() == most && distance >= found.back().distance)) return;
        const auto after =
            std::upper_bound(found.begin(), found.end(), distance,
                             [](double d, const Near& other) { return d < other.distance; });
        found.insert(after, {point, distance});
        if (found.size() > most) found.pop_back();
      },
      reach);
  for (Near& one : found) one.distance = std::sqrt(one.distance);
  return found;
}

}  // namespace burin
