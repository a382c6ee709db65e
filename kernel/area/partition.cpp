#include <burin/area/largest_disc.h>
#include <burin/area/partition.h>
#include <burin/base/disjoint_sets.h>

#include "labelled.h"
#include "network.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

namespace burin {
namespace {

using detail::LabelledMesh;

/// Times that narrow regions go to a neighbour: what is left has no neighbour wide enough.
constexpr int kMostCleaned = 6;
/// Squares of the least width of a tone: what is larger is a band or an area, not a speck.
constexpr double kSpeck = 2;

/// For each triangle the lowest one of the piece that it is in: triangles of one label that hang
/// together.
std::vector<std::uint32_t> pieces_of(const LabelledMesh& labelled) {
  const std::size_t n = labelled.labels.size();
  DisjointSets sets(n);
  for (std::uint32_t t = 0; t < n; ++t) {
    for (const std::int32_t beyond : labelled.mesh.beyond[t]) {
      const auto other = static_cast<std::uint32_t>(beyond);
      if (beyond >= 0 && labelled.labels[t] == labelled.labels[other]) sets.join(t, other);
    }
  }
  std::vector<std::uint32_t> pieces;
  for (std::uint32_t t = 0; t < n; ++t) pieces.push_back(sets.find(t));
  return pieces;
}

/// Side `i` of a triangle, counterclockwise.
std::array<std::uint32_t, 2> side(const PlanarMesh& mesh, std::size_t t, std::size_t i) {
  return {mesh.triangles[t][(i + 1) % 3], mesh.triangles[t][(i + 2) % 3]};
}

double length(const PlanarMesh& mesh, std::size_t t, std::size_t i) {
  const auto [a, b] = side(mesh, t, i);
  return glm::distance(mesh.points[a], mesh.points[b]);
}

bool differ_in_tone_alone(const AreaLabel& a, const AreaLabel& b) {
  return a.part >= 0 && a.part == b.part && a.face == b.face;
}

/// Pieces, what they are beside, and which of them are narrow.
class Cleaner {
 public:
  Cleaner(const LabelledMesh& labelled, const PartitionOptions& options)
      : mesh_(labelled.mesh),
        labels_(labelled.labels),
        options_(options),
        pieces_(pieces_of(labelled)),
        sizes_(pieces_.size()) {
    for (std::uint32_t t = 0; t < pieces_.size(); ++t) {
      Size& size = sizes_[pieces_[t]];
      size.area += detail::area_of(mesh_, t);
      for (std::size_t i = 0; i < 3; ++i) {
        const std::int32_t n = mesh_.beyond[t][i];
        const std::uint32_t other = n < 0 ? pieces_[t] : pieces_[static_cast<std::size_t>(n)];
        if (n >= 0 && other == pieces_[t]) continue;
        size.border += length(mesh_, t, i);
        beside_.push_back({pieces_[t], other, side(mesh_, t, i)});
      }
    }
    std::ranges::stable_sort(beside_, {},
                             [](const Beside& b) { return std::pair(b.piece, b.other); });
  }

  /// The label of each triangle; nothing where all stay as they are.
  std::optional<std::vector<AreaLabel>> clean() const {
    std::vector<std::uint32_t> taken(pieces_.size());
    std::iota(taken.begin(), taken.end(), 0U);
    bool any = false;
    for (auto first = beside_.begin(); first != beside_.end();) {
      const auto last = std::find_if(first, beside_.end(),
                                     [&](const Beside& b) { return b.piece != first->piece; });
      taken[first->piece] = taker({first, last});
      any = any || taken[first->piece] != first->piece;
      first = last;
    }
    if (!any) return std::nullopt;
    std::vector<AreaLabel> out;
    out.reserve(pieces_.size());
    for (const std::uint32_t piece : pieces_) out.push_back(labels_[taken[piece]]);
    return out;
  }

 private:
  struct Size {
    double area = 0, border = 0;
    double width() const { return 2 * area / border; }
  };
  struct Beside {
    /// `other`: the piece itself at the edge of the sheet.
    std::uint32_t piece, other;
    std::array<std::uint32_t, 2> ends;
  };

  /// The piece whose label a piece takes, given its border: its own where it stays.
  std::uint32_t taker(std::span<const Beside> border) const {
    const std::uint32_t piece = border.front().piece;
    const Size& size = sizes_[piece];
    const bool narrow = size.width() < options_.least_width;
    std::uint32_t best = piece;
    double longest = 0;
    if (!narrow && !is_speck(border)) return best;
    for (auto it = border.begin(); it != border.end();) {
      const std::uint32_t other = it->other;
      double common = 0;
      for (; it != border.end() && it->other == other; ++it) {
        common += glm::distance(mesh_.points[it->ends[0]], mesh_.points[it->ends[1]]);
      }
      if (other == piece) continue;
      const bool counts = narrow || differ_in_tone_alone(labels_[piece], labels_[other]);
      // Of two narrow ones side by side the smaller goes to the larger one.
      const bool wide = (narrow && sizes_[other].width() >= options_.least_width) ||
                        sizes_[other].area > size.area;
      if (counts && wide && common > longest) best = other, longest = common;
    }
    return best;
  }

  /// Whether it is small, and no place in it as wide as a pen.
  bool is_speck(std::span<const Beside> border) const {
    const double least = options_.least_tone_width;
    const Size& size = sizes_[border.front().piece];
    if (size.area >= kSpeck * least * least || size.width() >= least) return false;
    if (size.area < 0.25 * std::numbers::pi * least * least) return true;
    std::vector<BorderSide> sides;
    for (const Beside& b : border) {
      sides.push_back({mesh_.points[b.ends[0]], mesh_.points[b.ends[1]]});
    }
    const double enough = 0.5 * least;
    return largest_disc(sides, {}, {.precision = 0.02 * least, .enough = enough}).radius < enough;
  }

  const PlanarMesh& mesh_;
  const std::vector<AreaLabel>& labels_;
  const PartitionOptions& options_;
  std::vector<std::uint32_t> pieces_;
  /// By the lowest triangle.
  std::vector<Size> sizes_;
  std::vector<Beside> beside_;
};

/// Narrow pieces take the label of the neighbour with the longest common border; whether any did.
bool clean(LabelledMesh& labelled, const PartitionOptions& options) {
  auto labels = Cleaner(labelled, options).clean();
  if (labels) labelled.labels = std::move(*labels);
  return labels.has_value();
}

class RingWalk {
 public:
  /// `near`: none where no line has a name.
  RingWalk(const LabelledMesh& labelled, const detail::NearSegments* near, double reach)
      : mesh_(labelled.mesh), pieces_(pieces_of(labelled)), near_(near), reach_(reach) {
    numbers_.assign(mesh_.triangles.size(), -1);
    walked_.assign(mesh_.triangles.size(), {});
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (pieces_[t] == t) {
        numbers_[t] = static_cast<std::int32_t>(regions_.size());
        regions_.push_back({labelled.labels[t], 0, {}});
      }
    }
  }

  std::vector<AreaRegion> walk() {
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      AreaRegion& region = regions_[static_cast<std::size_t>(number(t))];
      region.area += detail::area_of(mesh_, t);
      for (std::size_t i = 0; i < 3; ++i) {
        if (is_border(t, i) && !walked_[t][i]) region.rings.push_back(ring(t, i));
      }
    }
    for (AreaRegion& region : regions_) {
      std::stable_partition(region.rings.begin(), region.rings.end(),
                            [&](const AreaRing& r) { return turns_left(r); });
    }
    return std::move(regions_);
  }

 private:
  std::int32_t number(std::uint32_t t) const { return numbers_[pieces_[t]]; }
  bool is_border(std::uint32_t t, std::size_t i) const {
    const std::int32_t n = mesh_.beyond[t][i];
    return n < 0 || pieces_[static_cast<std::size_t>(n)] != pieces_[t];
  }

  /// Around each corner through the triangles of the region itself, so that a ring which touches
  /// itself does not cross itself.
  AreaRing ring(std::uint32_t t, std::size_t i) {
    AreaRing out;
    while (!walked_[t][i]) {
      walked_[t][i] = true;
      const auto [a, b] = side(mesh_, t, i);
      const std::int32_t n = mesh_.beyond[t][i];
      out.corners.push_back(a);
      out.beyond.push_back(n < 0 ? -1 : number(static_cast<std::uint32_t>(n)));
      out.lines.push_back(near_ && mesh_.constrained[t][i]
                              ? near_->line_along(mesh_.points[a], mesh_.points[b], reach_)
                              : -1);
      i = (i + 1) % 3;  // the side that begins at b
      while (!is_border(t, i)) {
        t = static_cast<std::uint32_t>(mesh_.beyond[t][i]);
        const auto& corners = mesh_.triangles[t];
        const auto at = static_cast<std::size_t>(std::ranges::find(corners, b) - corners.begin());
        i = (at + 2) % 3;  // sides are opposite corners
      }
    }
    return out;
  }

  bool turns_left(const AreaRing& ring) const {
    double sum = 0;
    for (std::size_t i = 0, n = ring.corners.size(); i < n; ++i) {
      const Vec2 a = mesh_.points[ring.corners[i]], b = mesh_.points[ring.corners[(i + 1) % n]];
      sum += a.x * b.y - a.y * b.x;
    }
    return sum > 0;
  }

  const PlanarMesh& mesh_;
  std::vector<std::uint32_t> pieces_;
  const detail::NearSegments* near_;
  double reach_;
  std::vector<std::int32_t> numbers_;
  std::vector<std::array<bool, 3>> walked_;
  std::vector<AreaRegion> regions_;
};

}  // namespace

std::vector<Vec2> Partition::polygon(const AreaRing& ring) const {
  std::vector<Vec2> out;
  out.reserve(ring.corners.size());
  for (const std::uint32_t i : ring.corners) out.push_back(points[i]);
  return out;
}

std::vector<std::vector<Vec2>> Partition::outline(std::span<const std::uint32_t> of) const {
  std::vector<bool> inside(regions.size(), false);
  for (const std::uint32_t i : of) inside[i] = true;
  struct Side {
    std::uint32_t from, to;
    bool walked = false;
  };
  std::vector<Side> sides;
  for (const std::uint32_t i : of) {
    for (const AreaRing& ring : regions[i].rings) {
      for (std::size_t k = 0; k < ring.corners.size(); ++k) {
        const std::int32_t beyond = ring.beyond[k];
        if (beyond >= 0 && inside[static_cast<std::size_t>(beyond)]) continue;
        sides.push_back({ring.corners[k], ring.corners[(k + 1) % ring.corners.size()]});
      }
    }
  }
  std::ranges::sort(sides, {}, [](const Side& s) { return std::pair(s.from, s.to); });
  // The first side clockwise from the one that comes in: next to it round the corner, so that a
  // ring which touches itself does not cross itself.
  const auto next = [&](const Side& in) -> Side* {
    Side* best = nullptr;
    double least = 0;
    const Vec2 back = points[in.from] - points[in.to];
    const auto first = std::ranges::lower_bound(sides, in.to, {}, &Side::from);
    for (auto it = first; it != sides.end() && it->from == in.to; ++it) {
      Side& out = *it;
      if (out.walked) continue;
      const Vec2 on = points[out.to] - points[out.from];
      double turn = std::atan2(back.y * on.x - back.x * on.y, glm::dot(back, on));
      if (turn <= 0) turn += 2 * std::numbers::pi;
      if (!best || turn < least) best = &out, least = turn;
    }
    return best;
  };
  std::vector<std::vector<Vec2>> rings;
  for (Side& first : sides) {
    if (first.walked) continue;
    std::vector<Vec2>& ring = rings.emplace_back();
    for (Side* at = &first; at; at = next(*at)) {
      at->walked = true;
      ring.push_back(points[at->from]);
    }
  }
  return rings;
}

Partition partition(const Box2& sheet, std::span<const BorderLine> lines, const LabelAt& label_at,
                    const PartitionOptions& options, const RunContext& context) {
  detail::Network network = detail::make_network(sheet, lines, options);
  context.check();
  LabelledMesh labelled = detail::label_triangles(network, label_at, options, context);
  for (int k = 0; k < kMostCleaned && clean(labelled, options); ++k) context.check();
  std::optional<detail::NearSegments> near;
  if (std::ranges::any_of(lines, [](const BorderLine& l) { return l.line >= 0; })) {
    near.emplace(network);
  }
  Partition out;
  out.regions = RingWalk(labelled, near ? &*near : nullptr, 2 * options.weld).walk();
  out.points = std::move(labelled.mesh.points);
  out.mixed = labelled.mixed;
  out.mixed_area = labelled.mixed_area;
  return out;
}

}  // namespace burin
