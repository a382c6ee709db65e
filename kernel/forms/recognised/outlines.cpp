#include "outlines.h"

#include <burin/forms/recognised/point_grid.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

namespace burin::recognised {
namespace {

// What meets at less is smooth in meshes of which nothing is known, too.
constexpr double kSmoothTurn = 29.9 * std::numbers::pi / 180;
// What meets at more is an edge: a chamfer of 45 degrees along a rim, not the next meridian of a
// coarse ball.
constexpr double kEdge = 44 * std::numbers::pi / 180;
// Two cells that only meet each other are an edge.
constexpr std::size_t kFewestWalls = 4;

/// The straight edge that two facets share.
struct OutlineEdge {
  Vec3 middle{0}, along{0};
};

/// Facets that follow one another around an axis along their edges.
struct Chain {
  std::vector<std::int32_t> facets;
  /// Between a facet and the next; closed: and between the last and the first.
  std::vector<OutlineEdge> edges;
  bool closed = false;
  /// Whether it goes over into what is no wall.
  bool lost = false;
};

class OutlineFinder {
 public:
  OutlineFinder(const TriMesh& mesh, const Facets& facets, const RunContext& context)
      : mesh_(mesh), facets_(facets), context_(context), seen_(facets.list.size()) {}

  OutlineWalls run() {
    out_.of.assign(facets_.list.size(), -1);
    for (std::size_t f = 0; f < facets_.list.size(); ++f) {
      if (f % 64 == 0) context_.check();
      begin_at(static_cast<std::int32_t>(f));
    }
    return std::move(out_);
  }

 private:
  const Facet& facet(std::int32_t f) const { return facets_.list[static_cast<std::size_t>(f)]; }
  Vec3 position(std::uint32_t v) const { return mesh_.positions[v]; }
  /// How far, in mm, points may be off what they lie on.
  double off() const { return 4 * facets_.noise; }

  void begin_at(std::int32_t f) {
    for (const FacetLink& l : facet(f).links) {
      if (out_.of[static_cast<std::size_t>(f)] >= 0) return;
      if (!bends_to(f, l.facet)) continue;
      const std::optional<OutlineEdge> edge = edge_between(f, l.facet);
      if (!edge) continue;
      const Vec3 up = glm::normalize(edge->along);
      if (seen(f, up) || !upright(f, up)) continue;
      const Chain chain = chain_through(f, up);
      for (const std::int32_t g : chain.facets) seen_[static_cast<std::size_t>(g)].push_back(up);
      if (!chain.lost && chain.facets.size() >= kFewestWalls) take(chain, up);
    }
  }

  bool seen(std::int32_t f, Vec3 up) const {
    return std::ranges::any_of(seen_[static_cast<std::size_t>(f)],
                               [&](Vec3 d) { return std::abs(glm::dot(d, up)) > 1 - 1e-6; });
  }

  bool bends_to(std::int32_t f, std::int32_t g, double most = kSmoothTurn) const {
    return facet(f).area > 0 && facet(g).area > 0 &&
           angle_between(facet(f).normal, facet(g).normal) <= most;
  }

  /// None where the corners that both have are not on one line.
  std::optional<OutlineEdge> edge_between(std::int32_t f, std::int32_t g) const {
    const auto& a = facet(f).vertices;
    const auto& b = facet(g).vertices;
    std::vector<std::uint32_t> common;
    std::ranges::set_intersection(a, b, std::back_inserter(common));
    if (common.size() < 2) return std::nullopt;
    const Vec3 first = position(common.front());
    const auto farthest = [&](Vec3 from) {
      return position(*std::ranges::max_element(
          common, {}, [&](std::uint32_t v) { return glm::distance(position(v), from); }));
    };
    const Vec3 begin = farthest(first), end = farthest(begin);
    if (!(glm::distance(begin, end) > off())) return std::nullopt;
    const OutlineEdge edge{0.5 * (begin + end), end - begin};
    const bool straight = std::ranges::all_of(common, [&](std::uint32_t v) {
      return beside(position(v) - begin, glm::normalize(edge.along)) <= off();
    });
    return straight ? std::optional(edge) : std::nullopt;
  }

  /// mm from a line through the origin.
  static double beside(Vec3 p, Vec3 direction) { return glm::length(glm::cross(p, direction)); }

  bool runs_along(const OutlineEdge& edge, Vec3 up) const {
    return beside(edge.along, up) <= off() + 1e-5 * glm::length(edge.along);
  }

  /// Whether a facet bends into others across edges along a direction alone.
  bool upright(std::int32_t f, Vec3 up) const {
    return std::ranges::all_of(facet(f).links, [&](const FacetLink& l) {
      if (!bends_to(f, l.facet, kEdge)) return facet(l.facet).area > 0;
      const std::optional<OutlineEdge> edge = edge_between(f, l.facet);
      return edge && runs_along(*edge, up);
    });
  }

  /// The facet that follows where a wall ends.
  struct Step {
    std::int32_t facet = -1;
    OutlineEdge edge;
    /// Whether something bends away that is no wall: then all of it is something else.
    bool lost = false;
  };
  Step next(std::int32_t f, Vec3 up, double sense) const {
    Step best;
    for (const FacetLink& l : facet(f).links) {
      if (!bends_to(f, l.facet)) continue;
      const std::optional<OutlineEdge> edge = edge_between(f, l.facet);
      if (!edge || !runs_along(*edge, up) || !ends_at(f, *edge, up, sense)) continue;
      if (!upright(l.facet, up)) best.lost = true;
      if (best.lost || !ends_at(l.facet, *edge, up, -sense)) continue;
      if (best.facet < 0 || glm::length(edge->along) > glm::length(best.edge.along)) {
        best = {l.facet, *edge, false};
      }
    }
    return best;
  }

  Vec3 onwards(std::int32_t f, Vec3 up) const { return glm::cross(up, facet(f).normal); }

  bool ends_at(std::int32_t f, const OutlineEdge& edge, Vec3 up, double sense) const {
    const Vec3 way = sense * onwards(f, up);
    return std::ranges::all_of(facet(f).vertices, [&](std::uint32_t v) {
      return glm::dot(position(v) - edge.middle, way) <= off();
    });
  }

  Chain chain_through(std::int32_t f, Vec3 up) const {
    Chain chain{{f}, {}};
    std::set<std::int32_t> in{f};
    const auto follow = [&](double sense) {
      for (;;) {
        const Step step = next(chain.facets.back(), up, sense);
        chain.lost = chain.lost || step.lost;
        if (step.lost || step.facet < 0) return;
        const bool fresh = in.insert(step.facet).second;
        chain.closed = step.facet == chain.facets.front();
        if (!fresh && !chain.closed) return;
        chain.edges.push_back(step.edge);
        if (chain.closed) return;
        chain.facets.push_back(step.facet);
      }
    };
    follow(-1);
    if (chain.lost) return chain;
    if (chain.closed) return turned_round(std::move(chain));
    std::ranges::reverse(chain.facets);
    std::ranges::reverse(chain.edges);
    follow(1);
    return chain;
  }

  /// A ring that was followed backwards: the edge after the last facet stays the last one.
  static Chain turned_round(Chain chain) {
    std::ranges::reverse(chain.facets);
    std::ranges::reverse(chain.edges.begin(), chain.edges.end() - 1);
    return chain;
  }

  /// The point of a facet that is farthest on (1) or back (-1).
  Vec3 end_of(std::int32_t f, Vec3 up, double sense) const {
    const Vec3 way = sense * onwards(f, up);
    return position(*std::ranges::max_element(
        facet(f).vertices, {}, [&](std::uint32_t v) { return glm::dot(position(v), way); }));
  }

  /// The corners of the outline, at any height. An outline that meets itself in an edge closes,
  /// too.
  std::vector<Vec3> corners_of(const Chain& chain, Vec3 up, bool& closes) const {
    std::vector<Vec3> corners;
    for (const OutlineEdge& e : chain.edges) corners.push_back(e.middle);
    closes = chain.closed;
    if (closes) {
      std::rotate(corners.begin(), corners.end() - 1, corners.end());
      return corners;
    }
    const Vec3 begin = end_of(chain.facets.front(), up, -1);
    const Vec3 end = end_of(chain.facets.back(), up, 1);
    corners.insert(corners.begin(), begin);
    closes = beside(end - begin, up) <= off();
    if (!closes) corners.push_back(end);
    return corners;
  }

  PointGrid grid_of(const Chain& chain, Vec3 up) const {
    PointGrid grid;
    const std::vector<Vec3> corners = corners_of(chain, up, grid.columns_close);
    double low = 1e300, high = -1e300;
    for (const std::int32_t f : chain.facets) {
      for (const std::uint32_t v : facet(f).vertices) {
        low = std::min(low, glm::dot(position(v), up));
        high = std::max(high, glm::dot(position(v), up));
      }
    }
    grid.rows = 2;
    grid.columns = static_cast<std::int32_t>(corners.size());
    for (const double height : {low, high}) {
      for (const Vec3& p : corners) grid.points.push_back(p + (height - glm::dot(p, up)) * up);
    }
    return grid;
  }

  void take(const Chain& chain, Vec3 up) {
    SmoothGrids smooth = smooth_grids(grid_of(chain, up), Rows::Judged);
    const auto first = static_cast<std::int32_t>(out_.patches.size());
    for (const PointGrid& piece : smooth.pieces) add(piece);
    for (std::size_t i = 0; i < chain.facets.size(); ++i) {
      if (smooth.piece_of[i] < 0) continue;
      const std::int32_t p = first + smooth.piece_of[i];
      out_.of[static_cast<std::size_t>(chain.facets[i])] = p;
      Patch& patch = out_.patches[static_cast<std::size_t>(p)];
      const Facet& f = facet(chain.facets[i]);
      if (glm::dot(patch.normal_at(f.center), f.normal) < 0) patch.side = -patch.side;
    }
  }

  /// Two parts of one surface go over into one another.
  void add(const PointGrid& piece) {
    if (piece.window.columns == 0 || piece.window.column == 0) {
      out_.patches.push_back(patch_on(std::make_shared<const Sheet>(piece), piece.window));
      return;
    }
    Patch& before = out_.patches.back();
    before.chain = chains_++;
    Patch second = patch_on(before.sheet, piece.window);
    second.chain = before.chain;
    out_.patches.push_back(std::move(second));
  }

  const TriMesh& mesh_;
  const Facets& facets_;
  const RunContext& context_;
  /// For each facet the directions along which its chain is known.
  std::vector<std::vector<Vec3>> seen_;
  std::int32_t chains_ = 0;
  OutlineWalls out_;
};

}  // namespace

OutlineWalls find_outline_walls(const TriMesh& mesh, const Facets& facets,
                                const RunContext& context) {
  return OutlineFinder(mesh, facets, context).run();
}

}  // namespace burin::recognised
