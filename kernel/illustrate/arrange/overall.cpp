#include "overall.h"

#include <burin/base/box_corners.h>
#include <burin/illustrate/illustrate.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <utility>

namespace burin::detail {
namespace {

constexpr std::array<const char*, 3> kNames{"width", "depth", "height"};

/// A direction of the model on paper, per mm.
Vec2 on_paper(const Mat3& axes, const Vec3& direction) {
  const Vec3 p = axes * direction;
  return {p.x, p.y};
}

Vec3 unit(int axis) {
  Vec3 u(0);
  u[axis] = 1;
  return u;
}

/// Whether a length is seen as long as it is, and whether it is seen at all.
bool is_square(const SheetView& view, int axis) { return is_seen_square(view.as.axes, unit(axis)); }
bool is_seen(const SheetView& view, int axis) {
  constexpr double kLeast = 0.2;  // 12 degrees from the line of sight
  return glm::length(on_paper(view.as.axes, unit(axis))) > kLeast;
}

/// The number of the view; that of none. `whole`: whether what a break leaves out counts as shown.
std::size_t view_of(std::span<const SheetView> views, int axis, bool whole = false) {
  for (const auto shows : {is_square, is_seen}) {
    for (int rank = 0; rank <= 2; ++rank) {
      for (std::size_t i = 0; i < views.size(); ++i) {
        const bool reaches = whole || views[i].reaches[static_cast<std::size_t>(axis)];
        if (views[i].rank == rank && reaches && shows(views[i], axis)) return i;
      }
    }
  }
  return views.size();
}

/// An edge of the box along an axis, and the way from it to the line of its dimension.
struct Edge {
  Vec3 from{0}, to{0}, outwards{0};
  double rank = std::numeric_limits<double>::infinity();
};

/// Whether a place on paper is outside of what a box covers.
bool is_outside(const Box3& box, const Mat3& axes, Vec2 place) {
  // A convex outline: beyond it in a direction across one of its edges.
  for (int axis = 0; axis < 3; ++axis) {
    const Vec2 along = on_paper(axes, unit(axis)), across(-along.y, along.x);
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Vec3& p : corners_of(box)) {
      const double at = glm::dot(across, on_paper(axes, p));
      low = std::min(low, at), high = std::max(high, at);
    }
    const double at = glm::dot(across, place);
    if (at < low || at > high) return true;
  }
  return false;
}

/// How well a dimension stands: across its length, below what is wide and at the left of what is
/// high; the less the better.
double rank_of(Vec2 along, Vec2 out) {
  constexpr double kSide = 0.25;
  const double slant = std::abs(glm::dot(along, out));
  const bool wide = std::abs(along.x) >= std::abs(along.y) - 1e-9;
  return slant + kSide * (wide ? out.y : out.x);
}

/// Whether an extension line of two edges would be one.
bool share_a_line(const Edge& a, const Edge& b) {
  return a.outwards == b.outwards &&
         (a.from == b.from || a.from == b.to || a.to == b.from || a.to == b.to);
}

/// The edge of the box along an axis that is best for its dimension, beside those that have one.
Edge best_edge(const Box3& box, const Mat3& axes, int axis, std::span<const Edge> others) {
  constexpr double kSeen = 0.2, kNear = 1e-6, kBetter = 1e-9;
  // Lengths on the ground are measured there, where a view shows more than one way.
  constexpr double kUpwards = 0.3;
  const Vec2 along = glm::normalize(on_paper(axes, unit(axis)));
  const double step = kNear * box.diagonal();
  Edge best;
  for (int k = 0; k < 8; ++k) {
    const int out_axis = (axis + 1 + (k & 1)) % 3, other = 3 - axis - out_axis;
    Edge edge;
    edge.from[axis] = box.min[axis];
    edge.from[out_axis] = (k & 2) != 0 ? box.max[out_axis] : box.min[out_axis];
    edge.from[other] = (k & 4) != 0 ? box.max[other] : box.min[other];
    edge.outwards = ((k & 2) != 0 ? 1.0 : -1.0) * unit(out_axis);
    const Vec2 out = on_paper(axes, edge.outwards);
    if (glm::length(out) < kSeen) continue;
    Vec3 middle = edge.from;
    middle[axis] = 0.5 * (box.min[axis] + box.max[axis]);
    if (!is_outside(box, axes, on_paper(axes, middle) + step * glm::normalize(out))) continue;
    edge.to = edge.from;
    edge.to[axis] = box.max[axis];
    edge.rank = rank_of(along, glm::normalize(out)) + (out_axis == 2 ? kUpwards : 0);
    for (const Edge& laid : others) edge.rank += share_a_line(edge, laid) ? 1 : 0;
    if (edge.rank < best.rank - kBetter) best = edge;
  }
  return best;
}

}  // namespace

std::vector<OverallShares> share_overall(Scene& scene, const Illustration& illustration,
                                         const Box3& drawn, std::span<const SheetView> views) {
  std::vector<OverallShares> shares(views.size());
  if (!illustration.overall_dimensions || !illustration.whole) return shares;
  const Box3& whole = *illustration.whole;
  const bool apart = illustration.explode.wanted;
  constexpr double kSame = 1e-6;
  const double near = kSame * whole.diagonal();
  const auto not_drawn = [&](int axis, const char* why) {
    scene.diagnostics.add(Severity::Warning, "dimensions.not_drawn", 1,
                          fmt::format("the {} has no dimension: {}", kNames[axis], why));
  };
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(drawn.min[axis] - whole.min[axis]) > near ||
        std::abs(drawn.max[axis] - whole.max[axis]) > near) {
      not_drawn(axis, apart ? "the parts have come apart" : "a section takes a part of it away");
      continue;
    }
    if (whole.size()[axis] <= near) continue;  // there is none
    if (const std::size_t view = view_of(views, axis); view < views.size()) {
      shares[view][static_cast<std::size_t>(axis)] = true;
    } else {
      const bool left_out = view_of(views, axis, true) < views.size();
      not_drawn(axis, left_out ? "the break leaves out one of its ends"
                               : "no view of the sheet shows it");
    }
  }
  return shares;
}

std::vector<Dimension> overall_of_view(const Box3& drawn, const Mat3& axes,
                                       const OverallShares& shares, const DimensionOptions& style) {
  std::vector<Dimension> dimensions;
  std::vector<Edge> edges;
  for (int axis = 0; axis < 3; ++axis) {
    if (!shares[static_cast<std::size_t>(axis)]) continue;
    const Edge edge = best_edge(drawn, axes, axis, edges);
    if (!std::isfinite(edge.rank)) continue;
    edges.push_back(edge);
    Dimension& one = dimensions.emplace_back();
    one.from = edge.from;
    one.to = edge.to;
    one.outwards = edge.outwards;
    one.overall = true;
    one.text = dimension_text(drawn.size()[axis], style);
  }
  return dimensions;
}

}  // namespace burin::detail
