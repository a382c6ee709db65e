#include "unfold.h"

#include <burin/work_mesh/half_edges.h>

#include <algorithm>

namespace burin {
namespace {

constexpr int kPasses = 8;
/// Cosine between neighbouring triangles of one smooth face below which they are a fold: 60
/// degrees, more than the mesher's angle and two halvings leave. A flip has to better it by so much
/// that none is undone.
constexpr double kBend = 0.5, kBetter = 0.05;

class Unfolder {
 public:
  Unfolder(RawMesh& raw, std::vector<HalfEdge>& opposite, const Atlas& atlas,
           const detail::BreakLines& lines)
      : raw_(raw), m_(raw.mesh), opposite_(opposite), atlas_(atlas), lines_(lines) {}

  std::vector<std::size_t> run() {
    turn_up();
    for (int pass = 0; pass < kPasses && flatten(); ++pass) {
    }
    return std::move(changed_);
  }

 private:
  void turn_up() {
    std::vector<std::size_t> turned = turned_triangles();
    for (int pass = 0; pass < kPasses && !turned.empty(); ++pass) {
      const std::size_t before = changed_.size();
      for (const std::size_t f : turned) {
        if (area(f) <= 0) flip_best(f);
      }
      if (changed_.size() == before) break;
      std::erase_if(turned, [&](std::size_t f) { return area(f) > 0; });
      // A flip may leave its neighbour turned.
      for (std::size_t i = before; i < changed_.size(); ++i) {
        if (area(changed_[i]) <= 0) turned.push_back(changed_[i]);
      }
      std::ranges::sort(turned);
      turned.erase(std::unique(turned.begin(), turned.end()), turned.end());
    }
  }

  /// Flips edges inside faces over which triangles bend sharply; false where there was none.
  bool flatten() {
    bool any = false;
    for (HalfEdge h = 0; h < static_cast<HalfEdge>(opposite_.size()); ++h) {
      if (opposite_[at(h)] < h || !inside(h)) continue;
      const HalfEdge o = opposite_[at(h)];
      const std::uint32_t a = from(h), b = from(o), c = from(prev_in_face(h)),
                          d = from(prev_in_face(o));
      const double now = bend(a, b, c, b, a, d);
      if (now >= kBend || lines_.along_line(m_.face[face_of(h)], m_.uv[at(h)], m_.uv[at(o)])) {
        continue;
      }
      if (atlas_.chart(m_.face[face_of(h)]).kind() == FaceKind::Plane) continue;
      if (bend(a, d, c, d, b, c) <= now + kBetter || !(smaller_area(h) > 0)) continue;
      flip(h);
      any = true;
    }
    return any;
  }

  /// The cosine between the normals of two triangles.
  double bend(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d, std::uint32_t e,
              std::uint32_t f) const {
    const auto normal = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
      const Vec3 o = m_.positions[i];
      return normalize_or(glm::cross(m_.positions[j] - o, m_.positions[k] - o), Vec3(0));
    };
    return glm::dot(normal(a, b, c), normal(d, e, f));
  }

  /// Whether an edge may be flipped: no model edge, not at a pole, whose corners have several
  /// (u,v).
  bool inside(HalfEdge h) const {
    const HalfEdge o = opposite_[at(h)];
    if (o < 0 || m_.border[at(h)] >= 0 || m_.border[at(o)] >= 0) return false;
    if (m_.face[face_of(o)] != m_.face[face_of(h)]) return false;
    const HalfEdge n = next_in_face(h), p = prev_in_face(h), q = prev_in_face(o);
    if (m_.uv[at(h)] != m_.uv[at(next_in_face(o))] || m_.uv[at(n)] != m_.uv[at(o)]) return false;
    return !raw_.pole[at(p)] && !raw_.pole[at(q)];
  }

  /// The smaller area in (u,v) of the two triangles once h is flipped; -1 where it cannot be.
  double smaller_area(HalfEdge h) const {
    const HalfEdge o = opposite_[at(h)], p = prev_in_face(h), q = prev_in_face(o);
    if (joined(p, from(q))) return -1;
    const std::int32_t face = m_.face[face_of(h)];
    const Vec2 a = m_.uv[at(h)], b = m_.uv[at(o)], c = m_.uv[at(p)], d = m_.uv[at(q)];
    return std::min(area(a, d, c, face), area(d, b, c, face));
  }

  double area(Vec2 a, Vec2 b, Vec2 c, std::int32_t face) const {
    return (atlas_.reversed(face) ? -1 : 1) * cross2(b - a, c - a);
  }
  double area(std::size_t f) const {
    return area(m_.uv[3 * f], m_.uv[3 * f + 1], m_.uv[3 * f + 2], m_.face[f]);
  }
  std::uint32_t from(HalfEdge h) const { return m_.triangles[face_of(h)][at(h % 3)]; }

  std::vector<std::size_t> turned_triangles() const {
    std::vector<std::size_t> out;
    for (std::size_t f = 0; f < m_.triangles.size(); ++f) {
      if (area(f) <= 0) out.push_back(f);
    }
    return out;
  }

  /// The smaller area that two triangles would have, once their common edge h is flipped, less the
  /// smaller that they have; nothing to gain (-1) where it cannot be.
  double gain(HalfEdge h) const {
    if (!inside(h)) return -1;
    const double now = std::min(area(face_of(h)), area(face_of(opposite_[at(h)])));
    const HalfEdge o = opposite_[at(h)];
    const std::int32_t face = m_.face[face_of(h)];
    const Vec2 a = m_.uv[at(h)], b = m_.uv[at(o)], c = m_.uv[at(prev_in_face(h))],
               d = m_.uv[at(prev_in_face(o))];
    const double then = std::min(area(a, d, c, face), area(d, b, c, face));
    if (then <= now || joined(prev_in_face(h), from(prev_in_face(o)))) return -1;
    return then - now;
  }

  /// Whether an edge runs from the origin of h to the vertex already.
  bool joined(HalfEdge h, std::uint32_t vertex) const {
    const auto seen = [&](HalfEdge x) {
      return from(next_in_face(x)) == vertex || from(prev_in_face(x)) == vertex;
    };
    HalfEdge x = h;
    do {
      if (seen(x)) return true;
      x = opposite_[at(prev_in_face(x))];
    } while (x >= 0 && x != h);
    if (x == h) return false;
    for (x = opposite_[at(h)]; x >= 0; x = opposite_[at(x)]) {
      x = next_in_face(x);
      if (seen(x)) return true;
    }
    return false;
  }

  void flip_best(std::size_t f) {
    HalfEdge best = kNoHalfEdge;
    double most = 0;
    for (auto h = static_cast<HalfEdge>(3 * f); h < static_cast<HalfEdge>(3 * f + 3); ++h) {
      if (const double g = gain(h); g > most) {
        most = g;
        best = h;
      }
    }
    if (best >= 0) flip(best);
  }

  void flip(HalfEdge h) {
    changed_.push_back(face_of(h));
    changed_.push_back(face_of(opposite_[at(h)]));
    const auto flipped = flip_edge(m_.triangles, opposite_, h);
    carry(flipped, &FlippedSide::corner, m_.uv);
    carry(flipped, &FlippedSide::corner, raw_.pole);
    carry(flipped, &FlippedSide::side, m_.border, -1);
  }

  RawMesh& raw_;
  ChartMesh& m_;
  std::vector<HalfEdge>& opposite_;
  const Atlas& atlas_;
  const detail::BreakLines& lines_;
  std::vector<std::size_t> changed_;
};

}  // namespace

std::vector<std::size_t> unfold(RawMesh& raw, std::vector<HalfEdge>& opposite, const Atlas& atlas,
                                const detail::BreakLines& lines) {
  return Unfolder(raw, opposite, atlas, lines).run();
}

}  // namespace burin
