#include <burin/base/error.h>

#include "at_node.h"
#include "fragments.h"
#include "sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace burin::csg {
namespace {

constexpr std::uint32_t kNoPoint = std::numeric_limits<std::uint32_t>::max();

class Turner {
 public:
  Turner(Evaluation& e, const Region& region, double start, double angle, int fragments)
      : e_(e),
        region_(region),
        cap_(cap_of(region)),
        whole_(angle == 360),
        start_(start),
        angle_(angle),
        fragments_(fragments) {
    for (const Vec2& p : cap_.points) left_ = left_ || p.x < 0;
    // A whole turn goes clockwise, as OpenSCAD's does.
    flipped_ = (whole_ || angle < 0) != left_;
  }

  Solid run() {
    const int rings = whole_ ? fragments_ : fragments_ + 1;
    first_.assign(cap_.points.size(), kNoPoint);
    for (std::uint32_t p = 0; p < cap_.points.size(); ++p) {
      first_[p] = static_cast<std::uint32_t>(solid_.positions.size());
      const int copies = on_axis(p) ? 1 : rings;
      for (int j = 0; j < copies; ++j) solid_.positions.push_back(at(cap_.points[p], j));
    }
    if (!whole_) {
      for (const auto& [a, b, c] : cap_.triangles) {
        add(vertex(a, 0), vertex(b, 0), vertex(c, 0), -1);
        add(vertex(a, fragments_), vertex(c, fragments_), vertex(b, fragments_), -1);
      }
    }
    arcs_.assign(region_.arcs.size(), -1);
    for (const Cap::Edge& edge : cap_.rim) wall(edge);
    drop_unused(solid_);
    return std::move(solid_);
  }

 private:
  bool on_axis(std::uint32_t p) const { return cap_.points[p].x == 0; }
  Vec3 at(Vec2 p, int j) const {
    const Vec2 d =
        whole_ ? Vec2(-1, 1) * corner(j, fragments_) : direction(start_ + angle_ * j / fragments_);
    return {p.x * d.x, p.x * d.y, p.y};
  }
  std::uint32_t vertex(std::uint32_t p, int j) const {
    if (on_axis(p)) return first_[p];
    return first_[p] + static_cast<std::uint32_t>(whole_ ? j % fragments_ : j);
  }
  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::int32_t surface) {
    if (flipped_) std::swap(b, c);
    solid_.triangles.push_back({a, b, c});
    solid_.surface.push_back(surface);
  }
  double step() const {
    return whole_ ? 2 * M_PI / fragments_ : std::abs(angle_) * M_PI / 180 / fragments_;
  }

  std::int32_t new_row(Turned turned) {
    turned.step = step();
    solid_.surfaces.push_back(turned);
    return static_cast<std::int32_t>(solid_.surfaces.size()) - 1;
  }
  /// What a wall stands for: a ring of its arc, a cylinder or cone of its line; a plane where it is
  /// square to the axis.
  std::int32_t row_of(const Cap::Edge& edge) {
    if (step() * kFewestRound > 2 * M_PI * (1 + 1e-9)) return -1;
    const auto profile = [](Vec2 p) { return Vec2(std::abs(p.x), p.y); };
    if (edge.arc >= 0) {
      std::int32_t& row = arcs_[static_cast<std::size_t>(edge.arc)];
      if (row < 0) row = new_row(ring(region_.arcs[static_cast<std::size_t>(edge.arc)]));
      return row;
    }
    const Vec2 a = profile(cap_.points[edge.from]), b = profile(cap_.points[edge.to]);
    if (std::abs(a.y - b.y) <= kFinest) return -1;
    Turned turned;
    turned.a = a;
    turned.b = b;
    return new_row(turned);
  }
  Turned ring(const Arc& arc) const {
    Turned turned;
    turned.profile = Turned::Profile::Circle;
    turned.middle = {left_ ? -arc.middle.x : arc.middle.x, arc.middle.y};
    if (std::abs(turned.middle.x) <= kFinest) turned.middle.x = 0;
    turned.radius = arc.radius;
    turned.profile_step = arc.step;
    return turned;
  }

  void wall(const Cap::Edge& edge) {
    e_.run.check();
    const bool from = !on_axis(edge.from), to = !on_axis(edge.to);
    if (!from && !to) return;
    const std::int32_t row = row_of(edge);
    // Two walls that meet on the axis after a whole turn do so in a point of each.
    const std::uint32_t a = from ? kNoPoint : tip(edge.from), b = to ? kNoPoint : tip(edge.to);
    for (int j = 0; j < fragments_; ++j) {
      const std::uint32_t a0 = from ? vertex(edge.from, j) : a, b0 = to ? vertex(edge.to, j) : b;
      const std::uint32_t a1 = from ? vertex(edge.from, j + 1) : a,
                          b1 = to ? vertex(edge.to, j + 1) : b;
      if (to) add(a0, b1, b0, row);
      if (from) add(a0, a1, b1, row);
    }
  }
  std::uint32_t tip(std::uint32_t p) {
    if (!whole_) return first_[p];
    solid_.positions.push_back(at(cap_.points[p], 0));
    return static_cast<std::uint32_t>(solid_.positions.size()) - 1;
  }

  Evaluation& e_;
  const Region& region_;
  Cap cap_;
  bool whole_;
  double start_, angle_;
  int fragments_;
  bool left_ = false, flipped_ = false;
  Solid solid_;
  std::vector<std::uint32_t> first_;
  /// Rows of the arcs, -1 as long as they have none.
  std::vector<std::int32_t> arcs_;
};

/// What is within a grid unit of the axis lies on it.
Region onto_axis(const Region& region) {
  Region out = region;
  for (Outline& o : out.outlines) {
    for (Vec2& p : o.points) {
      if (std::abs(p.x) < kFinest) p.x = 0;
    }
  }
  return out;
}

}  // namespace

Solid rotate_extruded(Evaluation& e, std::uint32_t node, const Region& region) {
  const Node& n = e.tree.nodes[node];
  const double angle = n.number("angle", 360);
  if (region.empty() || angle == 0) return {};
  if (!std::isfinite(angle + n.number("start", 0)))
    throw InputError("rotate_extrude() by an angle that is no number");
  const Region profile = onto_axis(region);
  double low = 0, high = 0, edges = 0;
  for (const Outline& o : profile.outlines) {
    edges += static_cast<double>(o.points.size());
    for (const Vec2& p : o.points) {
      low = std::min(low, p.x);
      high = std::max(high, p.x);
    }
  }
  if (low < 0 && high > 0) {
    report(e, node, "openscad.across_axis",
           fmt::format("rotate_extrude() of a shape on both sides of the axis (x from {:.2f} to "
                       "{:.2f}); it is left out: move it to one side",
                       low, high));
    return {};
  }
  const double whole = angle <= -360 || angle > 360 ? 360 : angle;
  const int count = fragments(high - low, fineness_of(n));
  const int part = std::max(static_cast<int>(count * std::abs(whole) / 360), 1);
  check_swept(2 * edges * part, "rotate_extrude()");
  return Turner(e, profile, n.number("start", 0), whole, part).run();
}

}  // namespace burin::csg
