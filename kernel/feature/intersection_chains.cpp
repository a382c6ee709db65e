#include "edge_chains.h"
#include "intersections.h"
#include "paper_limits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>

namespace burin {

namespace {

/// A segment on its way into a chain.
struct Link {
  std::uint32_t face_a = 0, face_b = 0;
  Vec3 from{0}, to{0};
  double paper_length = 0;
  bool on_border = false;
  bool tangential = false;
};

struct Chain {
  std::vector<Link> links;
  bool closed = false;
};

/// Joins segments whose ends have equal keys. Where surfaces lie on each other there are millions.
class Joiner {
 public:
  explicit Joiner(std::span<const PairSegment> segments)
      : segments_(segments), used_(segments.size(), 0) {
    struct End {
      Key key;
      std::size_t segment;
      bool at_to;
    };
    std::vector<End> ends;
    ends.reserve(2 * segments.size());
    for (std::size_t i = 0; i < segments.size(); ++i) {
      ends.push_back({segments[i].from.key(), i, false});
      ends.push_back({segments[i].to.key(), i, true});
    }
    std::ranges::sort(ends, {}, [](const End& e) { return std::tie(e.key, e.segment); });
    across_.fill(std::vector<std::size_t>(segments.size(), kNone));
    for (std::size_t i = 0, last = 0; i < ends.size(); i = last) {
      while (last < ends.size() && ends[last].key == ends[i].key) ++last;
      const End &a = ends[i], &b = ends[last - 1];
      if (last - i != 2 || a.segment == b.segment) continue;
      across_[a.at_to ? 1 : 0][a.segment] = b.segment;
      across_[b.at_to ? 1 : 0][b.segment] = a.segment;
    }
  }

  std::vector<Chain> chains() {
    std::vector<Chain> out;
    for (const bool open : {true, false}) {
      for (std::size_t i = 0; i < segments_.size(); ++i) {
        if (used_[i]) continue;
        const bool at_from = across(i, false) == kNone, at_to = across(i, true) == kNone;
        if (open && !at_from && !at_to) continue;
        out.push_back(follow(i, at_from || !at_to));
      }
    }
    return out;
  }

 private:
  using Key = decltype(Piercing().key());

  /// The other segment at an end, kNone where it is the end of a curve or a branching.
  std::size_t across(std::size_t segment, bool at_to) const {
    return across_[at_to ? 1 : 0][segment];
  }

  Chain follow(std::size_t start, bool forward) {
    Chain chain;
    for (std::size_t i = start;;) {
      used_[i] = 1;
      const PairSegment& s = segments_[i];
      const Piercing &from = forward ? s.from : s.to, &to = forward ? s.to : s.from;
      chain.links.push_back({s.face_a, s.face_b, from.position, to.position});
      const std::size_t next = across(i, forward);
      if (next == kNone) return chain;
      if (used_[next]) {
        chain.closed = next == start;
        return chain;
      }
      forward = segments_[next].from.key() == to.key();
      i = next;
    }
  }

  std::span<const PairSegment> segments_;
  std::vector<std::uint8_t> used_;
  /// What follows at the end `from` of each segment, and at `to`.
  std::array<std::vector<std::size_t>, 2> across_;
};

double distance_to_line(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 d = normalize_or(b - a, Vec3(0));
  return glm::length(reject(p - a, d));
}

bool along_border(const ProxyMesh& proxy, std::uint32_t face, const Link& link, double limit) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (proxy.edge_kind[3 * std::size_t{face} + k] == EdgeKind::Smooth) continue;
    const Triangle& t = proxy.mesh.triangles[face];
    const Vec3 &a = proxy.mesh.positions[t[k]], &b = proxy.mesh.positions[t[(k + 1) % 3]];
    if (distance_to_line(link.from, a, b) < limit && distance_to_line(link.to, a, b) < limit) {
      return true;
    }
  }
  return false;
}

Vec3 smooth_normal(const ProxyMesh& proxy, std::uint32_t face, const Vec3& p) {
  const Triangle& t = proxy.mesh.triangles[face];
  const Vec3 &a = proxy.mesh.positions[t[0]], &b = proxy.mesh.positions[t[1]],
             &c = proxy.mesh.positions[t[2]];
  const Vec3 n = glm::cross(b - a, c - a);
  const double area = glm::dot(n, n);
  if (!(area > 0)) return proxy.wedge_normal[proxy.wedges[face][0]];
  const double u = glm::dot(glm::cross(c - b, p - b), n) / area;
  const double v = glm::dot(glm::cross(a - c, p - c), n) / area;
  return proxy.normal(face, {u, v, 1 - u - v});
}

class CurveMaker {
 public:
  CurveMaker(const PieceOfPart& a, const PieceOfPart& b, const Camera& camera)
      : a_(a), b_(b), camera_(camera) {}

  void make(Chain&& chain, std::vector<Curve3>& out) {
    tidy(chain);
    if (chain.links.empty()) return;
    for (Link& l : chain.links) measure(l);
    for (Chain& c : without_borders(std::move(chain))) {
      if (mostly_tangential(c)) continue;
      for (const Chain& region : by_region(std::move(c))) out.push_back(curve(region));
    }
  }

 private:
  std::int32_t region(const Link& l) const { return a_.proxy->face_region[l.face_a]; }

  /// Leaves out links of no length to speak of: the chain goes straight over them.
  void tidy(Chain& chain) const {
    std::vector<Link> kept;
    Vec3 at = chain.links.front().from;
    for (const Link& l : chain.links) {
      if (glm::length(l.to - at) * camera_.scale_at(at) < kSnapLength) continue;
      kept.push_back(l);
      kept.back().from = at;
      at = l.to;
    }
    if (chain.closed && kept.size() < 3) kept.clear();
    if (!kept.empty()) kept.back().to = chain.closed ? kept.front().from : chain.links.back().to;
    chain.links = std::move(kept);
  }

  void measure(Link& l) const {
    const Vec3 middle = 0.5 * (l.from + l.to);
    const double scale = camera_.scale_at(middle);
    l.paper_length = glm::length(l.to - l.from) * scale;
    const double limit = kContactLength / scale;
    l.on_border =
        along_border(*a_.proxy, l.face_a, l, limit) || along_border(*b_.proxy, l.face_b, l, limit);
    const Vec3 na = smooth_normal(*a_.proxy, l.face_a, middle);
    const Vec3 nb = smooth_normal(*b_.proxy, l.face_b, middle);
    const double limit_angle = glm::dot(na, nb) < 0 ? kContactAngle : kOverlapAngle;
    l.tangential = glm::length(glm::cross(na, nb)) < std::sin(limit_angle);
  }

  static double length(const Chain& c) {
    double sum = 0;
    for (const Link& l : c.links) sum += l.paper_length;
    return sum;
  }

  static bool mostly_tangential(const Chain& c) {
    double sum = 0;
    for (const Link& l : c.links) sum += l.tangential ? l.paper_length : 0;
    return sum > 0.5 * length(c);
  }

  /// Cuts a chain where `key` changes; a closed one is turned so that it begins at a cut.
  template <class Key>
  static std::vector<Chain> split(Chain&& chain, Key key) {
    const std::size_t n = chain.links.size();
    std::size_t start = 0;
    if (chain.closed) {
      while (start < n && key(chain.links[start]) == key(chain.links[(start + n - 1) % n])) ++start;
    }
    std::vector<Chain> out;
    if (start == n) {
      out.push_back(std::move(chain));
      return out;
    }
    std::rotate(chain.links.begin(), chain.links.begin() + static_cast<std::ptrdiff_t>(start),
                chain.links.end());
    for (const Link& l : chain.links) {
      if (out.empty() || key(out.back().links.back()) != key(l)) out.emplace_back();
      out.back().links.push_back(l);
    }
    return out;
  }

  std::vector<Chain> by_region(Chain&& chain) const {
    return split(std::move(chain), [&](const Link& l) { return region(l); });
  }

  /// The pieces of a chain that do not run along a crease or boundary.
  static std::vector<Chain> without_borders(Chain&& chain) {
    const auto on_border = [](const Link& l) { return l.on_border; };
    Chain whole;
    whole.closed = chain.closed;
    for (Chain& run : split(std::move(chain), on_border)) {
      const bool crossing = length(run) < kSpeckLength;
      for (Link& l : run.links) {
        l.on_border &= !crossing;
        whole.links.push_back(l);
      }
    }
    std::vector<Chain> out = split(std::move(whole), on_border);
    const bool contact = std::ranges::any_of(out, on_border, first_link);
    std::erase_if(out, [&](const Chain& r) {
      return on_border(first_link(r)) || (contact && length(r) < kSpeckLength);
    });
    return out;
  }
  static const Link& first_link(const Chain& c) { return c.links.front(); }

  /// Unit, towards the outside of both surfaces.
  Vec3 open_side(const Link& l) const {
    const Vec3 na = a_.proxy->mesh.normal(l.face_a), nb = b_.proxy->mesh.normal(l.face_b);
    return normalize_or(na + nb, na);
  }

  bool hidden(const Link& l) const {
    if (!a_.proxy->closed(l.face_a) || !b_.proxy->closed(l.face_b)) return false;
    const Vec3 v = camera_.to_viewer(0.5 * (l.from + l.to));
    const bool seen_through = b_.transparent && a_.part != b_.part;
    return glm::dot(a_.proxy->mesh.normal(l.face_a), v) < 0 ||
           (!seen_through && glm::dot(b_.proxy->mesh.normal(l.face_b), v) < 0);
  }

  Curve3 curve(const Chain& chain) const {
    Curve3 c;
    c.kind = LineClass::Intersection;
    c.source = {a_.part, region(chain.links.front()), -1};
    c.closed = chain.closed;
    c.crease_sign = -1;
    const std::size_t n = chain.links.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Link& l = chain.links[i];
      c.points.push_back(l.from);
      const bool joined = i > 0 || chain.closed;
      const Vec3 before = joined ? open_side(chain.links[(i + n - 1) % n]) : Vec3(0);
      c.normals.push_back(normalize_or(before + open_side(l), open_side(l)));
      c.faces.push_back(static_cast<std::int32_t>(l.face_a));
      c.self_hidden.push_back(hidden(l));
    }
    if (!chain.closed) {
      c.points.push_back(chain.links.back().to);
      c.normals.push_back(open_side(chain.links.back()));
    }
    return c;
  }

  PieceOfPart a_, b_;
  const Camera& camera_;
};

}  // namespace

std::vector<Curve3> chain_intersections(std::span<const PairSegment> segments, const PieceOfPart& a,
                                        const PieceOfPart& b, const Camera& camera) {
  std::vector<Curve3> out;
  CurveMaker maker(a, b, camera);
  for (Chain& chain : Joiner(segments).chains()) maker.make(std::move(chain), out);
  return out;
}

}  // namespace burin
