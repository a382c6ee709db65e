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

// Degrees: slices that turn by more are meant, as the sides of a prism are.
constexpr double kLargestStep = 360.0 / kFewestRound;

class Extruder {
 public:
  Extruder(Evaluation& e, const Extrusion& extrusion, const Region& region, int slices)
      : e_(e), x_(extrusion), region_(region), cap_(cap_of(region)), slices_(slices) {}

  Solid run() {
    layers_ = narrow() ? slices_ : slices_ + 1;
    for (int j = 0; j < layers_; ++j) {
      for (const Vec2& p : cap_.points) solid_.positions.emplace_back(at(p, j), height(j));
    }
    for (const auto& [a, b, c] : cap_.triangles) add({a, c, b}, -1);
    surfaces();
    if (layers_ > 1 && std::abs(x_.twist) <= kLargestStep * slices_) smooth_walls();
    for (int j = 0; j + 1 < layers_; ++j) walls(j);
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

  /// Walls over splines, and all that twist or grow unevenly, are smooth surfaces through the
  /// corners of their slices.
  void smooth_walls() {
    wall_.assign(cap_.rim.size() * static_cast<std::size_t>(slices_), -1);
    std::vector<std::size_t> leaving(cap_.points.size());
    for (std::size_t i = 0; i < cap_.rim.size(); ++i) leaving[cap_.rim[i].from] = i;
    std::vector<char> done(cap_.rim.size(), 0);
    for (std::size_t i = 0; i < cap_.rim.size(); ++i) {
      std::vector<std::size_t> loop;
      for (std::size_t k = i; done[k] == 0; k = leaving[cap_.rim[k].to]) {
        done[k] = 1;
        loop.push_back(k);
      }
      if (!loop.empty()) smooth_loop(std::move(loop));
    }
  }

  /// Edges of circles that stay circles are cylinders and cones; one or two of them may be
  /// anything.
  bool round(const std::vector<std::size_t>& loop, std::size_t i) const {
    constexpr std::size_t kFewest = 3;
    const std::size_t n = loop.size();
    const std::int32_t arc = cap_.rim[loop[i]].arc;
    if (row_of(cap_.rim[loop[i]]) < 0) return false;
    std::size_t alike = 1;
    while (alike < kFewest && cap_.rim[loop[(i + alike) % n]].arc == arc) ++alike;
    for (std::size_t k = 1; alike < kFewest && cap_.rim[loop[(i + n - k) % n]].arc == arc; ++k) {
      ++alike;
    }
    return alike >= kFewest;
  }

  /// The stretches between circles.
  void smooth_loop(std::vector<std::size_t> loop) {
    std::vector<char> is_round(loop.size());
    for (std::size_t i = 0; i < loop.size(); ++i) is_round[i] = round(loop, i);
    const auto first = std::ranges::find(is_round, 1);
    if (first == is_round.end()) {
      smooth_stretch(loop, true);
      return;
    }
    const auto shift = first - is_round.begin();
    std::rotate(is_round.begin(), first, is_round.end());
    std::rotate(loop.begin(), loop.begin() + shift, loop.end());
    std::vector<std::size_t> stretch;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      if (is_round[i] == 0) stretch.push_back(loop[i]);
      if ((is_round[i] != 0 || i + 1 == loop.size()) && !stretch.empty()) {
        smooth_stretch(stretch, false);
        stretch.clear();
      }
    }
  }

  void smooth_stretch(const std::vector<std::size_t>& edges, bool closes) {
    e_.run.check();
    PointGrid grid;
    grid.rows = layers_;
    grid.columns = static_cast<std::int32_t>(edges.size()) + (closes ? 0 : 1);
    grid.columns_close = closes;
    for (int j = 0; j < grid.rows; ++j) {
      for (const std::size_t i : edges) {
        grid.points.push_back(solid_.positions[vertex(cap_.rim[i].from, j)]);
      }
      if (!closes) {
        grid.points.push_back(solid_.positions[vertex(cap_.rim[edges.back()].to, j)]);
      }
    }
    SmoothGrids smooth = smooth_grids(std::move(grid), Rows::Steps);
    const std::int32_t first = add_grids(solid_.surfaces, std::move(smooth.pieces));
    for (std::size_t c = 0; c < smooth.piece_of.size(); ++c) {
      if (smooth.piece_of[c] < 0) continue;
      wall_[edges[c % edges.size()] * static_cast<std::size_t>(slices_) + c / edges.size()] =
          first + smooth.piece_of[c];
    }
  }

  std::int32_t wall_row(std::size_t edge, int j) const {
    const auto at = edge * static_cast<std::size_t>(slices_) + static_cast<std::size_t>(j);
    return !wall_.empty() && wall_[at] >= 0 ? wall_[at] : row_of(cap_.rim[edge]);
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
    for (std::size_t i = 0; i < cap_.rim.size(); ++i) {
      const Cap::Edge& edge = cap_.rim[i];
      const std::uint32_t a = vertex(edge.from, j), b = vertex(edge.to, j),
                          c = vertex(edge.to, j + 1), d = vertex(edge.from, j + 1);
      const std::int32_t row = wall_row(i, j);
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
  /// Of points: one less where the top is a point or a ridge.
  int layers_ = 0;
  Solid solid_;
  std::vector<std::int32_t> row_;
  /// For each edge of the rim and each slice the surface of its wall, or -1.
  std::vector<std::int32_t> wall_;
};

}  // namespace

Solid linear_extruded(Evaluation& e, std::uint32_t node, const Region& region) {
  const Node& n = e.tree.nodes[node];
  Extrusion x;
  x.height = n.number("height", 100);
  x.twist = n.number("twist", 0);
  x.center = n.truth("center", false);
  const auto [top_x, top_y] = top_scale(n);
  x.scale = glm::max(Vec2(top_x, top_y), Vec2(0));
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
