#include "intersections.h"

#include <burin/base/box.h>
#include <burin/base/parallel.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <utility>

namespace burin {

namespace {

/// Triangles that are looked at together, in the order of the mesh.
constexpr std::size_t kBlock = 64;

struct Component {
  PieceOfPart piece;
  bool closed = false;
  Box3 box;
  std::vector<std::uint32_t> faces;
};

Box3 face_box(const ProxyMesh& proxy, std::uint32_t f) {
  Box3 box;
  for (const std::uint32_t v : proxy.mesh.triangles[f]) box.add(proxy.mesh.positions[v]);
  return box;
}

std::vector<Component> components(std::span<const ProxyMesh* const> proxies,
                                  const RunContext& context) {
  std::vector<Component> all;
  for (std::size_t p = 0; p < proxies.size(); ++p) {
    const ProxyMesh& proxy = *proxies[p];
    const std::size_t first = all.size();
    for (const std::uint8_t closed : proxy.topology.component_closed) {
      all.push_back({{static_cast<std::int32_t>(p), &proxy}, closed != 0, {}, {}});
    }
    for (std::uint32_t f = 0; f < proxy.mesh.triangles.size(); ++f) {
      if (f % 65536 == 0) context.check();
      Component& c = all[first + static_cast<std::size_t>(proxy.topology.face_component[f])];
      c.faces.push_back(f);
      c.box.add(face_box(proxy, f));
    }
  }
  return all;
}

// Pairs of pieces of one part, one of them open, whose boxes overlap. A part of patches has some
// hundred; a damaged mesh whose triangles all lie apart, across each other, has millions.
constexpr std::size_t kMostOpenPairs = 100'000;

bool open_pair(const Component& a, const Component& b) {
  return a.piece.part == b.piece.part && !(a.closed && b.closed);
}

using Pair = std::pair<std::size_t, std::size_t>;

/// Components whose boxes overlap: a sweep along x. Open pieces of a part that has too many pairs
/// of them across each other are left out; `crowded` counts such parts.
std::vector<Pair> overlapping(const std::vector<Component>& all, std::int64_t& crowded,
                              const RunContext& context) {
  std::map<std::int32_t, std::size_t> open;  // pairs of open pieces, by part
  const auto too_many = [](std::size_t count) { return count > kMostOpenPairs; };
  std::vector<std::size_t> order(all.size()), active;
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return all[i].box.min.x; });
  std::vector<Pair> pairs;
  for (const std::size_t i : order) {
    context.check();
    std::erase_if(active, [&](std::size_t j) { return all[j].box.max.x < all[i].box.min.x; });
    for (const std::size_t j : active) {
      if (!all[i].box.overlaps(all[j].box)) continue;
      if (open_pair(all[i], all[j]) && too_many(++open[all[i].piece.part])) continue;
      pairs.emplace_back(std::min(i, j), std::max(i, j));
    }
    active.push_back(i);
  }
  std::erase_if(pairs, [&](const Pair& p) {
    const Component &a = all[p.first], &b = all[p.second];
    return open_pair(a, b) && too_many(open.at(a.piece.part));
  });
  crowded =
      std::ranges::count_if(open, [&](const auto& of_part) { return too_many(of_part.second); });
  std::ranges::sort(pairs);
  return pairs;
}

/// The triangles of `c` that meet each of the boxes.
std::vector<std::vector<std::uint32_t>> faces_near(const Component& c,
                                                   const std::vector<Box3>& boxes,
                                                   const RunContext& context) {
  std::vector<std::vector<std::uint32_t>> out(boxes.size());
  std::vector<Box3> block;
  for (std::size_t begin = 0; begin < c.faces.size(); begin += kBlock) {
    context.check();
    const std::size_t end = std::min(begin + kBlock, c.faces.size());
    block.clear();
    Box3 all;
    for (std::size_t i = begin; i < end; ++i) {
      block.push_back(face_box(*c.piece.proxy, c.faces[i]));
      all.add(block.back());
    }
    for (std::size_t b = 0; b < boxes.size(); ++b) {
      if (!all.overlaps(boxes[b])) continue;
      for (std::size_t i = begin; i < end; ++i) {
        if (block[i - begin].overlaps(boxes[b])) out[b].push_back(c.faces[i]);
      }
    }
  }
  return out;
}

/// For each pair the triangles of its two components that lie in the other's box.
struct Candidates {
  std::vector<std::uint32_t> a, b;
};

std::vector<Candidates> candidates(const std::vector<Component>& all,
                                   const std::vector<Pair>& pairs, const RunContext& context) {
  struct Use {
    std::size_t pair;
    bool second;
  };
  std::vector<std::vector<Use>> uses(all.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    uses[pairs[i].first].push_back({i, false});
    uses[pairs[i].second].push_back({i, true});
  }
  std::vector<Candidates> out(pairs.size());
  parallel_for(
      all.size(), 1,
      [&](std::size_t c, std::size_t) {
        if (uses[c].empty()) return;
        std::vector<Box3> boxes;
        for (const Use& u : uses[c]) {
          boxes.push_back(all[u.second ? pairs[u.pair].first : pairs[u.pair].second].box);
        }
        auto faces = faces_near(all[c], boxes, context);
        for (std::size_t i = 0; i < boxes.size(); ++i) {
          Candidates& to = out[uses[c][i].pair];
          (uses[c][i].second ? to.b : to.a) = std::move(faces[i]);
        }
      },
      &context);
  return out;
}

/// As they are between `b` and `a`.
std::vector<PairSegment> mirrored(std::vector<PairSegment> segments) {
  for (PairSegment& s : segments) std::swap(s.face_a, s.face_b);
  return segments;
}

}  // namespace

std::vector<Curve3> intersection_curves(std::span<const ProxyMesh* const> proxies,
                                        const Camera& camera, const MeetingParts& meeting,
                                        Diagnostics& diagnostics, const RunContext& context) {
  std::size_t count = 0;
  for (const ProxyMesh* p : proxies) count += p->topology.component_closed.size();
  if (count < 2) return {};
  const std::vector<Component> all = components(proxies, context);
  std::int64_t crowded = 0;
  const std::vector<Pair> pairs = overlapping(all, crowded, context);
  if (crowded > 0) {
    diagnostics.add(Severity::Warning, "feature.open_pieces", crowded,
                    "parts consist of so many open pieces across each other that the lines in "
                    "which those pass through each other are left out; the file may be damaged");
  }
  const std::vector<Candidates> near = candidates(all, pairs, context);
  std::vector<std::vector<Curve3>> found(pairs.size());
  parallel_for(
      pairs.size(), 1,
      [&](std::size_t i, std::size_t) {
        if (near[i].a.empty() || near[i].b.empty()) return;
        PieceOfPart a = all[pairs[i].first].piece, b = all[pairs[i].second].piece;
        std::span<const std::uint32_t> of_a = near[i].a, of_b = near[i].b;
        for (PieceOfPart* p : {&a, &b}) {
          const auto part = static_cast<std::size_t>(p->part);
          p->transparent = part < meeting.transparent.size() && meeting.transparent[part];
          p->ink = part < meeting.ink.size() ? meeting.ink[part] : 0;
        }
        if (b.transparent != a.transparent ? a.transparent : b.ink > a.ink) {
          std::swap(a, b);
          std::swap(of_a, of_b);
        }
        const std::vector<PairSegment> segments =
            intersect_triangles(*a.proxy, of_a, *b.proxy, of_b, context);
        found[i] = chain_intersections(segments, a, b, camera);
        // Neither hides lines of the other: it is a line of both, as each of them shows it.
        if (!a.transparent || !b.transparent || a.part == b.part) return;
        std::ranges::move(chain_intersections(mirrored(segments), b, a, camera),
                          std::back_inserter(found[i]));
      },
      &context);
  std::vector<Curve3> curves;
  for (auto& f : found) {
    curves.insert(curves.end(), std::move_iterator(f.begin()), std::move_iterator(f.end()));
  }
  return curves;
}

}  // namespace burin
