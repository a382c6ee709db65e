#include "at_node.h"
#include "clip.h"
#include "flat.h"
#include "origins.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>
#include <utility>

namespace burin::csg {
namespace {

/// The circle about a vertical axis that a horizontal chord of a facet stands for.
std::optional<Arc> circle_of(const Turned& turned, Vec2 a, Vec2 b) {
  if (turned.profile == Turned::Profile::Grid) return std::nullopt;
  const double tilt = std::hypot(turned.axis.x, turned.axis.y);
  if (tilt > 1e-9) return std::nullopt;
  const Vec2 middle(turned.origin.x, turned.origin.y);
  const Vec2 along = b - a;
  const double length = glm::length(along);
  if (!(length > 0)) return std::nullopt;
  const double inner = std::abs(cross2(along, a - middle)) / length;
  return Arc{middle, inner / std::cos(turned.step / 2), turned.step};
}

std::int32_t surface_of(const Solid& solid, std::size_t triangle) {
  return triangle < solid.surface.size() ? solid.surface[triangle] : -1;
}

/// The outlines of a solid cut by z = 0. Corners on the plane count as above it, or as below it:
/// both together are what the plane has in common with the solid, its faces in the plane included.
class Cut {
 public:
  Cut(const Solid& solid, bool on_is_above) : solid_(solid), on_is_above_(on_is_above) {}

  Region outlines(RunContext& run) {
    for (std::size_t t = 0; t < solid_.triangles.size(); ++t) {
      if (t % kPoll == 0) run.check();
      cross(t);
    }
    Region region;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (!pieces_[i].used) region.outlines.push_back(follow(i, region));
    }
    return region;
  }

 private:
  static constexpr std::size_t kPoll = 4096;
  struct Piece {
    std::uint64_t from = 0, to = 0;
    std::int32_t surface = -1;
    bool used = false;
  };

  bool above(std::uint32_t v) const {
    const double z = solid_.positions[v].z;
    return on_is_above_ ? z >= 0 : z > 0;
  }
  static std::uint64_t key(std::uint32_t a, std::uint32_t b) {
    return (static_cast<std::uint64_t>(std::min(a, b)) << 32) | std::max(a, b);
  }
  Vec2 point(std::uint64_t edge) const {
    const Vec3 &a = solid_.positions[edge >> 32], &b = solid_.positions[edge & 0xffffffffu];
    if (a.z == 0 || a.z == b.z) return {a.x, a.y};
    if (b.z == 0) return {b.x, b.y};
    const Vec3 p = glm::mix(a, b, a.z / (a.z - b.z));
    return {p.x, p.y};
  }

  /// From the edge where the triangle goes down through the plane to the one where it comes up:
  /// seen from above that has the inside to the left.
  void cross(std::size_t t) {
    const auto& v = solid_.triangles[t];
    std::uint64_t down = 0, up = 0;
    bool any = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = v[k], b = v[(k + 1) % 3];
      if (above(a) == above(b)) continue;
      any = true;
      (above(a) ? down : up) = key(a, b);
    }
    if (!any) return;
    next_[down].push_back(pieces_.size());
    pieces_.push_back({down, up, surface_of(solid_, t)});
  }

  Outline follow(std::size_t first, Region& region) {
    Outline outline;
    for (std::size_t i = first;;) {
      Piece& piece = pieces_[i];
      piece.used = true;
      const Vec2 a = point(piece.from), b = point(piece.to);
      // The diagonal of a facet divides its chord.
      if (outline.points.empty() || !straight(outline, a, b, piece.surface)) {
        outline.points.push_back(a);
        outline.arc.push_back(-1);
        surfaces_.push_back(piece.surface);
      }
      const auto onward = next_.find(piece.to);
      if (onward == next_.end()) break;
      const auto open = std::ranges::find_if(onward->second,
                                             [&](std::size_t next) { return !pieces_[next].used; });
      if (open == onward->second.end()) break;
      i = *open;
    }
    // Where the walk begins may be such a place too.
    const std::size_t n = outline.points.size();
    if (n > 3 && surfaces_.back() == surfaces_.front() &&
        straight(outline, outline.points[0], outline.points[1], surfaces_.front())) {
      outline.points.erase(outline.points.begin());
      outline.arc.pop_back();
      surfaces_.erase(surfaces_.begin());
    }
    tag(outline, region);
    return outline;
  }

  bool straight(const Outline& outline, Vec2 a, Vec2 b, std::int32_t surface) const {
    if (surface < 0 || surfaces_.back() != surface) return false;
    const Vec2 from = outline.points.back(), d = b - from;
    const double length = glm::length(d);
    return length > 0 && std::abs(cross2(d, a - from)) <= length / kGrid;
  }

  void tag(Outline& outline, Region& region) {
    for (std::size_t i = 0; i < outline.points.size(); ++i) {
      if (surfaces_[i] < 0) continue;
      const auto arc =
          circle_of(solid_.surfaces[static_cast<std::size_t>(surfaces_[i])], outline.points[i],
                    outline.points[(i + 1) % outline.points.size()]);
      if (!arc) continue;
      outline.arc[i] = static_cast<std::int32_t>(region.arcs.size());
      region.arcs.push_back(*arc);
    }
    surfaces_.clear();
  }

  const Solid& solid_;
  bool on_is_above_;
  std::vector<Piece> pieces_;
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> next_;
  std::vector<std::int32_t> surfaces_;
};

Region cut(Evaluation& e, const Solid& solid) {
  std::vector<Region> sides;
  for (const bool above : {true, false}) {
    sides.push_back(odd_places(Cut(solid, above).outlines(e.run)));
  }
  return clip(ClipOp::Union, sides);
}

/// Level edges of walls about a vertical axis, whichever way these look.
void add_level_edges(const Solid& solid, std::size_t t, Origins& origins) {
  const std::int32_t surface = surface_of(solid, t);
  const auto& v = solid.triangles[t];
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 &a = solid.positions[v[k]], &b = solid.positions[v[(k + 1) % 3]];
    origins.add_point(a);
    if (surface < 0 || std::abs(a.z - b.z) > 1e-9 * glm::length(b - a)) continue;
    const auto arc = circle_of(solid.surfaces[static_cast<std::size_t>(surface)], a, b);
    if (arc) origins.add_edge(a, b, *arc);
  }
}

Region shadow(Evaluation& e, const Solid& solid) {
  e.run.check();
  std::vector<Outline> triangles;
  Origins origins;
  for (std::size_t t = 0; t < solid.triangles.size(); ++t) {
    add_level_edges(solid, t, origins);
    Outline o;
    for (const std::uint32_t i : solid.triangles[t]) o.points.emplace_back(solid.positions[i]);
    o.arc.assign(3, -1);
    // Those that look up cover what those that look down do.
    if (doubled_area(o) > 0) triangles.push_back(std::move(o));
  }
  return covered(triangles, origins);
}

}  // namespace

Region projected(Evaluation& e, std::uint32_t node, const Solid& solid) {
  if (solid.empty()) return {};
  return at_node(e, node, [&] {
    return e.tree.nodes[node].truth("cut", false) ? cut(e, solid) : shadow(e, solid);
  });
}

}  // namespace burin::csg
