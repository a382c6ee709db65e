#include <burin/base/error.h>

#include "fragments.h"
#include "ridge.h"
#include "slices.h"
#include "sweep.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin::csg {
namespace {

/// Points are compared within ten parts in a million, as in OpenSCAD, so that what is symmetric is
/// divided alike.
int compare_lengths(Vec2 a, Vec2 b) {
  constexpr double kPartsOf = 1e5;
  const double x = glm::length(a), y = glm::length(b);
  return 2 * std::abs(x - y) * kPartsOf > x + y ? (x < y ? -1 : 1) : 0;
}

class Extruder {
 public:
  Extruder(Evaluation& e, const Extrusion& extrusion, const Region& region, int slices)
      : e_(e), x_(extrusion), region_(region), cap_(cap_of(region)), slices_(slices) {}

  Solid run() {
    const int layers = narrow() ? slices_ : slices_ + 1;
    for (int j = 0; j < layers; ++j) {
      for (const Vec2& p : cap_.points) solid_.positions.emplace_back(at(p, j), height(j));
    }
    for (const auto& [a, b, c] : cap_.triangles) add({a, c, b}, -1);
    surfaces();
    for (int j = 0; j + 1 < layers; ++j) walls(j);
    if (narrow())
      close_narrow();
    else
      for (const auto& [a, b, c] : cap_.triangles) {
        add({vertex(a, slices_), vertex(b, slices_), vertex(c, slices_)}, -1);
      }
    drop_unused(solid_);
    return std::move(solid_);
  }

 private:
  bool narrow() const { return x_.scale.x == 0 || x_.scale.y == 0; }
  double share(int j) const { return static_cast<double>(j) / slices_; }
  double height(int j) const { return (x_.center ? -x_.height / 2 : 0) + x_.height * share(j); }
  Vec2 turned(Vec2 p, int j) const {
    const Vec2 turn = direction(-x_.twist * share(j));
    return {turn.x * p.x - turn.y * p.y, turn.y * p.x + turn.x * p.y};
  }
  Vec2 at(Vec2 p, int j) const {
    return (Vec2(1) - (Vec2(1) - x_.scale) * share(j)) * turned(p, j);
  }
  std::uint32_t vertex(std::uint32_t p, int j) const {
    return p + static_cast<std::uint32_t>(j) * static_cast<std::uint32_t>(cap_.points.size());
  }
  void add(const std::array<std::uint32_t, 3>& triangle, std::int32_t surface) {
    solid_.triangles.push_back(triangle);
    solid_.surface.push_back(surface);
  }

  /// Straight walls over an arc are a cylinder, or a cone where all shrinks towards its middle.
  void surfaces() {
    row_.assign(region_.arcs.size(), -1);
    if (x_.twist != 0 || x_.scale.x != x_.scale.y) return;
    for (std::size_t i = 0; i < region_.arcs.size(); ++i) {
      const Arc& arc = region_.arcs[i];
      if (x_.scale.x != 1 && glm::length(arc.middle) > 1e-9 * arc.radius) continue;
      Turned t;
      t.origin = Vec3(arc.middle, height(0));
      t.step = arc.step;
      t.a = {arc.radius, 0};
      t.b = {arc.radius * x_.scale.x, x_.height};
      row_[i] = static_cast<std::int32_t>(solid_.surfaces.size());
      solid_.surfaces.push_back(t);
    }
  }
  std::int32_t row_of(const Cap::Edge& edge) const {
    return edge.arc < 0 ? -1 : row_[static_cast<std::size_t>(edge.arc)];
  }

  /// Whether the diagonal goes from the edge's beginning below to its end above.
  bool rises_forward(const Cap::Edge& edge, int j) const {
    const Vec2 from = cap_.points[edge.from], to = cap_.points[edge.to];
    const int shorter = compare_lengths(at(from, j) - at(to, j + 1), at(to, j) - at(from, j + 1));
    const bool back = x_.twist <= 0;
    return shorter == -1 || (shorter == 0 && edge.hole == back);
  }

  void walls(int j) {
    e_.run.check();
    for (const Cap::Edge& edge : cap_.rim) {
      const std::uint32_t a = vertex(edge.from, j), b = vertex(edge.to, j),
                          c = vertex(edge.to, j + 1), d = vertex(edge.from, j + 1);
      const std::int32_t row = row_of(edge);
      if (rises_forward(edge, j)) {
        add({a, b, c}, row);
        add({a, c, d}, row);
      } else {
        add({a, b, d}, row);
        add({b, c, d}, row);
      }
    }
  }

  void close_narrow() {
    const int j = slices_ - 1;
    std::vector<Vec2> top, wide;
    for (const Vec2& p : cap_.points) {
      top.push_back(at(p, slices_));
      wide.push_back(turned(p, slices_));
    }
    const Ridge ridge(cap_, top, wide, x_.scale.x != 0 ? 0 : x_.scale.y != 0 ? 1 : -1);
    const auto first = static_cast<std::uint32_t>(solid_.positions.size());
    for (const Vec2& p : ridge.points) solid_.positions.emplace_back(p, height(slices_));
    for (std::size_t i = 0; i < cap_.rim.size(); ++i) {
      const Cap::Edge& edge = cap_.rim[i];
      const std::uint32_t a = vertex(edge.from, j), b = vertex(edge.to, j);
      // From above the edge's beginning to above its end.
      const std::vector<std::uint32_t>& chain = ridge.chains[i];
      // OpenSCAD takes the other diagonal where the top has no area.
      const bool from_begin = !rises_forward(edge, j);
      const std::uint32_t fan = from_begin ? a : b;
      add({a, b, first + (from_begin ? chain.back() : chain.front())}, row_of(edge));
      for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
        add({fan, first + chain[k + 1], first + chain[k]}, row_of(edge));
      }
    }
  }

  Evaluation& e_;
  const Extrusion& x_;
  const Region& region_;
  Cap cap_;
  int slices_;
  Solid solid_;
  std::vector<std::int32_t> row_;
};

}  // namespace

Solid linear_extruded(Evaluation& e, std::uint32_t node, const Region& region) {
  const Node& n = e.tree.nodes[node];
  Extrusion x;
  x.height = n.number("height", 100);
  x.twist = n.number("twist", 0);
  x.center = n.truth("center", false);
  const std::vector<double> scale = n.numbers("scale");
  if (scale.size() >= 2) x.scale = glm::max(Vec2(scale[0], scale[1]), Vec2(0));
  if (!std::isfinite(x.height) || !std::isfinite(x.twist) ||
      !std::isfinite(x.scale.x + x.scale.y)) {
    throw InputError("linear_extrude() with a height, twist or scale that is no finite number");
  }
  if (region.empty() || x.height <= 0) return {};
  double edges = 0;
  for (const Outline& o : region.outlines) edges += static_cast<double>(o.points.size());
  const double slices = slices_of(n, x, region);
  check_swept(2 * edges * (slices + 1), "linear_extrude()");
  return Extruder(e, x, region, static_cast<int>(slices)).run();
}

}  // namespace burin::csg
