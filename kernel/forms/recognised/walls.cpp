#include "walls.h"

#include <burin/base/disjoint_sets.h>

#include <algorithm>

namespace burin::recognised {
namespace {

// A wall is at least this share of the part's size wide ...
constexpr double kMinWidth = 0.02;
// ... and, along at least this share of its smooth border, this many times as wide as the facets
// behind. The same numbers tell the flat parts of a mesh (kernel/field/flat_patches).
constexpr double kBorderShare = 0.6, kWider = 3;
// Border edges that are looked at, at the most.
constexpr std::size_t kMostSamples = 48;

class Measure {
 public:
  Measure(const ProxyMesh& proxy, const Facets& facets, const Recognised& round)
      : proxy_(proxy),
        facets_(facets),
        round_(round),
        least_(kMinWidth * proxy.mesh.bounds().diagonal()),
        border_(facets.list.size()) {
    for (std::size_t h = 0; h < proxy.edge_kind.size(); ++h) {
      const HalfEdge o = proxy.topology.opposite[h];
      if (o == kNoHalfEdge || proxy.edge_kind[h] != EdgeKind::Smooth) continue;
      const std::int32_t a = facet_of(static_cast<HalfEdge>(h)), b = facet_of(o);
      if (a != b && plain(a) && plain(b)) {
        border_[static_cast<std::size_t>(a)].push_back(static_cast<HalfEdge>(h));
      }
    }
  }

  bool is_wall(std::size_t facet) const {
    const auto& border = border_[facet];
    if (border.empty()) return false;
    const std::size_t stride = (border.size() + kMostSamples - 1) / kMostSamples;
    double all = 0, wider = 0;
    for (std::size_t i = 0; i < border.size(); i += stride) {
      const HalfEdge h = border[i];
      const double length = glm::distance(start(h), start(next_in_face(h)));
      const double own = width(h), behind = width(opposite(h));
      all += length;
      if (own >= least_ && own >= kWider * behind) wider += length;
    }
    return wider >= kBorderShare * all;
  }

  /// Makes walls of facets of which so few meet at small angles, one after the other, that they are
  /// no rounding: a side and the two cuts at its corners, as those of `offset` with few fragments.
  void add_few(std::vector<std::uint8_t>& wall) const {
    constexpr std::uint32_t kFewest = 4;  // facets of a rounding
    DisjointSets groups(border_.size());
    for (std::uint32_t f = 0; f < border_.size(); ++f) {
      for (const HalfEdge h : border_[f]) {
        groups.join(f, static_cast<std::uint32_t>(facet_of(opposite(h))));
      }
    }
    std::vector<std::uint32_t> count(border_.size(), 0);
    for (std::uint32_t f = 0; f < border_.size(); ++f) {
      // A sliver is no wall, and says nothing of those that it meets.
      const bool wide =
          std::ranges::all_of(border_[f], [&](HalfEdge h) { return width(h) >= least_; });
      count[groups.find(f)] += wide ? 1 : kFewest;
    }
    for (std::uint32_t f = 0; f < border_.size(); ++f) {
      if (!border_[f].empty() && count[groups.find(f)] < kFewest) wall[f] = 1;
    }
  }

  /// Whether the facet meets one that is no wall.
  bool bends(std::size_t facet, const std::vector<std::uint8_t>& wall) const {
    return std::any_of(border_[facet].begin(), border_[facet].end(), [&](HalfEdge h) {
      return wall[static_cast<std::size_t>(facet_of(opposite(h)))] == 0;
    });
  }

 private:
  std::int32_t facet_of(HalfEdge h) const { return facets_.of[face_of(h)]; }
  bool plain(std::int32_t f) const { return round_.patch_of[static_cast<std::size_t>(f)] < 0; }
  HalfEdge opposite(HalfEdge h) const {
    return proxy_.topology.opposite[static_cast<std::size_t>(h)];
  }
  Vec3 start(HalfEdge h) const { return proxy_.mesh.positions[origin(proxy_.mesh, h)]; }

  /// How far the facet of a half-edge reaches from it, in its plane.
  double width(HalfEdge h) const {
    const Facet& f = facets_.list[static_cast<std::size_t>(facet_of(h))];
    const Vec3 a = start(h), along = normalize_or(start(next_in_face(h)) - a, Vec3(0));
    const Vec3 inwards = glm::cross(f.normal, along);
    double width = 0;
    for (const std::uint32_t v : f.vertices) {
      width = std::max(width, glm::dot(proxy_.mesh.positions[v] - a, inwards));
    }
    return width;
  }

  const ProxyMesh& proxy_;
  const Facets& facets_;
  const Recognised& round_;
  /// Width (mm) of the narrowest wall.
  double least_;
  /// For each plain facet its half-edges that meet another one smoothly.
  std::vector<std::vector<HalfEdge>> border_;
};

}  // namespace

Walls::Walls(const ProxyMesh& proxy, const Facets& facets, const Recognised& round)
    : wall_(facets.list.size(), 0), bends_(facets.list.size(), 0) {
  const Measure measure(proxy, facets, round);
  for (std::size_t f = 0; f < wall_.size(); ++f) wall_[f] = measure.is_wall(f);
  // Without a round face only what is known to be flat gets here.
  if (round.patches.empty()) measure.add_few(wall_);
  for (std::size_t f = 0; f < wall_.size(); ++f) {
    bends_[f] = wall_[f] == 0 && measure.bends(f, wall_);
  }
}

}  // namespace burin::recognised
