#include "network.h"

#include <burin/base/nearest_along.h>
#include <burin/planar/segment_in_box.h>

#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <utility>

namespace burin::detail {
namespace {

namespace bg = boost::geometry;
using Point = bg::model::d2::point_xy<double>;
using Square = bg::model::box<Point>;
using Boxes = bg::index::rtree<std::pair<Square, std::uint32_t>, bg::index::rstar<16>>;

Square square(Vec2 a, Vec2 b, double around) {
  const Vec2 low = glm::min(a, b) - around, high = glm::max(a, b) + around;
  return {{low.x, low.y}, {high.x, high.y}};
}

std::vector<std::uint32_t> inside(const Boxes& tree, const Square& box) {
  std::vector<std::uint32_t> found;
  for (auto it = tree.qbegin(bg::index::intersects(box)); it != tree.qend(); ++it) {
    found.push_back(it->second);
  }
  std::ranges::sort(found);
  return found;
}

Boxes tree_of(const std::vector<Vec2>& points) {
  std::vector<std::pair<Square, std::uint32_t>> boxes;
  boxes.reserve(points.size());
  for (const Vec2& p : points) {
    boxes.emplace_back(square(p, p, 0), static_cast<std::uint32_t>(boxes.size()));
  }
  return Boxes(boxes);
}

Boxes tree_of(const Network& network) {
  std::vector<std::pair<Square, std::uint32_t>> boxes;
  boxes.reserve(network.segments.size());
  for (const Segment& s : network.segments) {
    boxes.emplace_back(square(network.points[s.ends[0]], network.points[s.ends[1]], 0),
                       static_cast<std::uint32_t>(boxes.size()));
  }
  return Boxes(boxes);
}

/// The share of the way from `a` to `b` that is nearest to `p`, from 0 to 1.
double share_along(Vec2 p, Vec2 a, Vec2 b) { return nearest_along(a, b - a, p); }

class Builder {
 public:
  Builder(const Box2& sheet, const PartitionOptions& options) : sheet_(sheet), options_(options) {}

  Network build(std::span<const BorderLine> lines) {
    add_frame();
    for (const BorderLine& line : lines) add(line);
    weld();
    divide();
    join_ends();
    return std::move(net_);
  }

 private:
  std::uint32_t add(Vec2 p) {
    net_.points.push_back(p);
    return static_cast<std::uint32_t>(net_.points.size() - 1);
  }

  void add_frame() {
    const Vec2 a = sheet_.min, b = sheet_.max;
    for (const Vec2& p : {a, Vec2(b.x, a.y), b, Vec2(a.x, b.y)}) add(p);
    for (std::uint32_t i = 0; i < 4; ++i) net_.segments.push_back({{i, (i + 1) % 4}, -1});
  }

  void add(const BorderLine& line) {
    const std::size_t n = line.points.size();
    if (n < 2) return;
    const std::size_t sides = line.closed ? n : n - 1;
    constexpr std::uint32_t kNone = ~0U;
    std::uint32_t last = kNone, first = kNone;
    for (std::size_t i = 0; i < sides; ++i) {
      const Vec2 a = line.points[i], b = line.points[(i + 1) % n];
      const auto inside = segment_in_box(a, b, sheet_);
      if (!inside) {
        last = kNone;
        continue;
      }
      const auto [from, to] = *inside;
      if (last == kNone || from > 0) last = add(glm::mix(a, b, from));
      if (i == 0 && from == 0) first = last;
      const bool closes = i + 1 == n && first != kNone && to == 1;
      const std::uint32_t next = closes ? first : add(glm::mix(a, b, to));
      net_.segments.push_back({{last, next}, line.line});
      last = to < 1 ? kNone : next;
    }
  }

  /// Segments without a length go; of two on each other one stays.
  void unite() {
    std::map<std::array<std::uint32_t, 2>, std::size_t> seen;
    std::vector<Segment> kept;
    for (const Segment& s : net_.segments) {
      if (s.ends[0] == s.ends[1]) continue;
      const auto [it, is_new] = seen.try_emplace(
          std::array{std::min(s.ends[0], s.ends[1]), std::max(s.ends[0], s.ends[1])}, kept.size());
      if (is_new) {
        kept.push_back(s);
        continue;
      }
      std::int32_t& line = kept[it->second].line;
      if (line < 0 || (s.line >= 0 && s.line < line)) line = s.line;
    }
    net_.segments = std::move(kept);
  }

  void weld() {
    const Boxes tree = tree_of(net_.points);
    std::vector<std::uint32_t> stands(net_.points.size());
    std::iota(stands.begin(), stands.end(), 0U);
    for (std::uint32_t i = 0; i < stands.size(); ++i) {
      const Vec2 p = net_.points[i];
      double nearest = options_.weld;
      for (const std::uint32_t j : inside(tree, square(p, p, options_.weld))) {
        if (j >= i) break;
        const double d = glm::distance(p, net_.points[j]);
        if (stands[j] == j && (d < nearest || (stands[i] == i && d <= nearest))) {
          nearest = d;
          stands[i] = j;
        }
      }
    }
    for (Segment& s : net_.segments) {
      for (std::uint32_t& end : s.ends) end = stands[end];
    }
    unite();
  }

  std::vector<std::uint32_t> degrees() const {
    std::vector<std::uint32_t> degree(net_.points.size(), 0);
    for (const Segment& s : net_.segments) ++degree[s.ends[0]], ++degree[s.ends[1]];
    return degree;
  }

  void divide() {
    const Boxes tree = tree_of(net_.points);
    const std::vector<std::uint32_t> degree = degrees();
    std::vector<Segment> out;
    for (const Segment& s : net_.segments) {
      const Vec2 a = net_.points[s.ends[0]], b = net_.points[s.ends[1]];
      std::vector<std::pair<double, std::uint32_t>> on;
      for (const std::uint32_t j : inside(tree, square(a, b, options_.weld))) {
        if (degree[j] == 0 || j == s.ends[0] || j == s.ends[1]) continue;
        const double t = share_along(net_.points[j], a, b);
        if (t > 0 && t < 1 && glm::distance(glm::mix(a, b, t), net_.points[j]) <= options_.weld) {
          on.emplace_back(t, j);
        }
      }
      std::ranges::sort(on);
      std::uint32_t last = s.ends[0];
      for (const auto& [t, j] : on) {
        out.push_back({{last, j}, s.line});
        last = j;
      }
      out.push_back({{last, s.ends[1]}, s.line});
    }
    net_.segments = std::move(out);
    unite();
  }

  void join_ends() {
    const Boxes tree = tree_of(net_);
    const std::vector<std::uint32_t> degree = degrees();
    const std::size_t count = net_.segments.size();
    for (std::size_t i = 0; i < count; ++i) {
      for (const bool back : {false, true}) {
        const auto [from, end] =
            back ? std::pair(net_.segments[i].ends[1], net_.segments[i].ends[0])
                 : std::pair(net_.segments[i].ends[0], net_.segments[i].ends[1]);
        if (degree[end] == 1) join(tree, from, end);
      }
    }
  }

  /// The triangulation divides the line that is met.
  void join(const Boxes& tree, std::uint32_t from, std::uint32_t end) {
    const Vec2 p = net_.points[end], back = net_.points[from] - p;
    double nearest = options_.gap;
    Vec2 foot = p;
    for (const std::uint32_t k : inside(tree, square(p, p, options_.gap))) {
      const auto& [a, b] = net_.segments[k].ends;
      if (a == end || b == end) continue;
      const Vec2 q =
          glm::mix(net_.points[a], net_.points[b], share_along(p, net_.points[a], net_.points[b]));
      const double d = glm::distance(p, q);
      // Not back beside the line itself.
      if (d < nearest && glm::dot(q - p, back) <= 0.7 * d * glm::length(back)) {
        nearest = d;
        foot = q;
      }
    }
    if (foot == p) return;
    // A little beyond, so that it meets in spite of rounding.
    net_.segments.push_back({{end, add(foot + 1e-9 * (foot - p))}, -1});
  }

  const Box2& sheet_;
  const PartitionOptions& options_;
  Network net_;
};

}  // namespace

Network make_network(const Box2& sheet, std::span<const BorderLine> lines,
                     const PartitionOptions& options) {
  return Builder(sheet, options).build(lines);
}

struct NearSegments::Tree {
  Boxes boxes;
};

NearSegments::NearSegments(const Network& network)
    : network_(network), tree_(std::make_unique<Tree>(Tree{tree_of(network)})) {}

NearSegments::~NearSegments() = default;

std::int32_t NearSegments::line_along(Vec2 a, Vec2 b, double reach) const {
  std::int32_t line = -1;
  double nearest = reach;
  for (const std::uint32_t k : inside(tree_->boxes, square(a, b, reach))) {
    const Segment& s = network_.segments[k];
    if (s.line < 0) continue;
    const Vec2 p = network_.points[s.ends[0]], q = network_.points[s.ends[1]];
    const double away = std::max(glm::distance(a, glm::mix(p, q, share_along(a, p, q))),
                                 glm::distance(b, glm::mix(p, q, share_along(b, p, q))));
    if (away < nearest || (away <= nearest && (line < 0 || s.line < line))) {
      nearest = away;
      line = s.line;
    }
  }
  return line;
}

}  // namespace burin::detail
