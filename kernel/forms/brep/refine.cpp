#include "refine.h"

#include <burin/base/parallel.h>

#include "half_edges.h"
#include "unfold.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

constexpr int kLevels = 12;          // an edge into 4096 pieces at the most
constexpr std::size_t kGrain = 256;  // triangles

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }
std::size_t next(std::size_t h) { return h % 3 == 2 ? h - 2 : h + 1; }

/// How far S is off: in full, and with deviations along the triangle or edge counted a quarter, by
/// which is split.
struct Off {
  double full = 0, weighted = 0;
  void add(Vec3 d, double part, bool across) {
    // `part`: of d along the unit normal (or, not `across`, along the edge).
    const double all = glm::dot(d, d), other = std::max(0.0, all - part * part);
    full = std::max(full, std::sqrt(all));
    const double w = across ? part * part + other / 16 : other + part * part / 16;
    weighted = std::max(weighted, std::sqrt(w));
  }
};

class Refiner {
 public:
  Refiner(RawMesh& raw, const Atlas& atlas, double tolerance, const RunContext& context)
      : raw_(raw), m_(raw.mesh), atlas_(atlas), tolerance_(tolerance), context_(context) {
    known_.assign(m_.uv.size(), 0);
    error_.resize(m_.uv.size());
    centre_.resize(m_.triangles.size());
    centre_known_.assign(m_.triangles.size(), 0);
  }

  void run(ManifoldPairs pairs) {
    opposite_ = std::move(pairs.opposite);
    for (int level = 0;; ++level) {
      forget(unfold(raw_, opposite_, atlas_));
      measure(level < 2);
      const bool more = mark(pairs.to_split);
      if (!more || (level >= kLevels && pairs.to_split.empty())) break;
      split();
      pairs.to_split.clear();
      opposite_ = pair_half_edges(m_.triangles, m_.positions.size());
    }
    m_.tolerance = 0;
    for (std::size_t h = 0; h < error_.size(); ++h) {
      if (known_[h]) m_.tolerance = std::max(m_.tolerance, error_[h].full);
    }
    for (const Off& e : centre_) m_.tolerance = std::max(m_.tolerance, e.full);
  }

 private:
  /// What flips have changed is to be measured anew, on both sides of each edge.
  void forget(const std::vector<std::size_t>& changed) {
    for (const std::size_t f : changed) {
      centre_known_[f] = 0;
      for (std::size_t h = 3 * f; h < 3 * f + 3; ++h) {
        known_[h] = 0;
        if (opposite_[h] >= 0) known_[at(opposite_[h])] = 0;
      }
    }
  }

  Vec3 normal(std::size_t f) const {
    const auto& t = m_.triangles[f];
    return normalize_or(glm::cross(m_.positions[t[1]] - m_.positions[t[0]],
                                   m_.positions[t[2]] - m_.positions[t[0]]),
                        Vec3(0));
  }

  void measure_edge(std::size_t h, bool quarters) {
    const Chart& chart = atlas_.chart(m_.face[h / 3]);
    const Vec3 a = m_.positions[m_.triangles[h / 3][h % 3]];
    const Vec3 b = m_.positions[m_.triangles[h / 3][(h + 1) % 3]];
    Off e;
    const bool border = m_.border[h] >= 0;
    if (border || chart.kind() != FaceKind::Plane) {
      const Vec3 axis = border ? normalize_or(b - a, Vec3(0)) : normal(h / 3);
      for (const double s : {0.5, 0.25, 0.75}) {
        const Vec3 d = chart.position(raw_.on_edge(atlas_, h, s)) - (a + s * (b - a));
        e.add(d, glm::dot(d, axis), !border);
        if (!quarters) break;
      }
    }
    error_[h] = e;
    known_[h] = 1;
  }

  void measure_centre(std::size_t f) {
    const Chart& chart = atlas_.chart(m_.face[f]);
    centre_known_[f] = 1;
    centre_[f] = {};
    if (chart.kind() == FaceKind::Plane) return;
    const auto& t = m_.triangles[f];
    const Vec3 p = (m_.positions[t[0]] + m_.positions[t[1]] + m_.positions[t[2]]) / 3.0;
    const Vec2 uv = (m_.uv[3 * f] + m_.uv[3 * f + 1] + m_.uv[3 * f + 2]) / 3.0;
    const Vec3 d = chart.position(uv) - p;
    centre_[f].add(d, glm::dot(d, normal(f)), true);
  }

  void measure(bool quarters) {
    parallel_for(
        m_.triangles.size(), kGrain,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t f = begin; f < end; ++f) {
            for (std::size_t h = 3 * f; h < 3 * f + 3; ++h) {
              const bool first = opposite_[h] < 0 || h < at(opposite_[h]);
              if (first && !known_[h]) measure_edge(h, quarters);
            }
            if (!centre_known_[f]) measure_centre(f);
          }
        },
        &context_);
  }

  /// Edges that are to be split, on both sides; false where there are none.
  bool mark(const std::vector<HalfEdge>& in_any_case) {
    split_.assign(m_.uv.size(), 0);
    bool any = false;
    const auto mark_edge = [&](std::size_t h) {
      split_[h] = 1;
      if (opposite_[h] >= 0) split_[at(opposite_[h])] = 1;
      any = true;
    };
    for (std::size_t h = 0; h < split_.size(); ++h) {
      const bool first = opposite_[h] < 0 || h < at(opposite_[h]);
      if (first && error_[h].weighted > tolerance_) mark_edge(h);
    }
    for (const HalfEdge h : in_any_case) mark_edge(at(h));
    for (std::size_t f = 0; f < m_.triangles.size(); ++f) {
      if (centre_[f].weighted <= tolerance_ || split_[3 * f] || split_[3 * f + 1] ||
          split_[3 * f + 2]) {
        continue;
      }
      std::size_t longest = 3 * f;
      for (std::size_t h = 3 * f + 1; h < 3 * f + 3; ++h) {
        if (length(h) > length(longest)) longest = h;
      }
      mark_edge(longest);
    }
    return any;
  }

  double length(std::size_t h) const {
    return glm::length(m_.positions[m_.triangles[h / 3][(h + 1) % 3]] -
                       m_.positions[m_.triangles[h / 3][h % 3]]);
  }

  /// What a corner of a new triangle brings along, with the half-edge that starts there.
  struct Corner {
    std::uint32_t vertex;
    Vec2 uv;
    std::uint8_t pole;
    std::int32_t border;
    std::uint8_t known;
    Off error;
  };

  Corner corner(std::size_t h) const {
    return {m_.triangles[h / 3][h % 3], m_.uv[h], raw_.pole[h], m_.border[h], known_[h], error_[h]};
  }

  /// The new vertex in the middle of half-edge h, as the corner that the second half starts at.
  Corner middle(std::size_t h) {
    const std::size_t owner = opposite_[h] >= 0 ? std::min(h, at(opposite_[h])) : h;
    std::uint32_t& v = made_[owner];
    const Vec2 uv = raw_.on_edge(atlas_, h, 0.5);
    if (v == 0) {
      v = static_cast<std::uint32_t>(m_.positions.size());
      m_.positions.push_back(atlas_.chart(m_.face[h / 3]).position(uv));
    }
    return {v, uv, 0, -1, 0, {}};
  }

  /// The two halves of the border entry of h; -1 inside faces.
  std::array<std::int32_t, 2> halves(std::size_t h) {
    if (m_.border[h] < 0) return {-1, -1};
    const ChartMesh::Border b = m_.borders[at(m_.border[h])];
    const double t = 0.5 * (b.t0 + b.t1);
    m_.borders[at(m_.border[h])] = {b.edge, b.coedge, b.t0, t};
    m_.borders.push_back({b.edge, b.coedge, t, b.t1});
    return {m_.border[h], static_cast<std::int32_t>(m_.borders.size() - 1)};
  }

  static void centre_pole(Corner& c, const Corner& a, const Corner& b) {
    const int i = c.pole - 1;
    c.uv[i] = a.pole ? b.uv[i] : b.pole ? a.uv[i] : 0.5 * (a.uv[i] + b.uv[i]);
  }

  void emit(std::int32_t face, const Off* centre, std::array<Corner, 3> c) {
    Triangle t{};
    for (std::size_t k = 0; k < 3; ++k) {
      t[k] = c[k].vertex;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      if (c[k].pole) centre_pole(c[k], c[(k + 1) % 3], c[(k + 2) % 3]);
    }
    out_.triangles.push_back(t);
    out_.face.push_back(face);
    out_centre_.push_back(centre ? *centre : Off());
    out_centre_known_.push_back(centre != nullptr);
    for (const Corner& k : c) {
      out_.uv.push_back(k.uv);
      out_.border.push_back(k.border);
      out_pole_.push_back(k.pole);
      out_known_.push_back(k.known);
      out_error_.push_back(k.error);
    }
  }

  void split() {
    context_.check();
    out_ = {};
    out_pole_.clear(), out_known_.clear(), out_error_.clear(), out_centre_.clear(),
        out_centre_known_.clear();
    made_.assign(m_.uv.size(), 0);
    for (std::size_t f = 0; f < m_.triangles.size(); ++f) split_triangle(f);
    out_.positions = std::move(m_.positions);
    out_.borders = std::move(m_.borders);
    out_.edge_class = std::move(m_.edge_class);
    m_ = std::move(out_);
    raw_.pole.swap(out_pole_);
    known_.swap(out_known_);
    error_.swap(out_error_);
    centre_.swap(out_centre_);
    centre_known_.swap(out_centre_known_);
  }

  void split_triangle(std::size_t f) {
    const std::size_t h = 3 * f;
    const std::int32_t face = m_.face[f];
    const int count = split_[h] + split_[h + 1] + split_[h + 2];
    if (count == 0) return emit(face, &centre_[f], {corner(h), corner(h + 1), corner(h + 2)});
    if (count == 3) return split_in_four(face, h);
    // Turned so that the marked edge is the first, or the one not marked the last.
    std::size_t a = h;
    while (!(split_[a] && (count == 1 || split_[next(a)]))) a = next(a);
    const std::size_t b = next(a), c = next(b);
    if (count == 1) {
      const Corner m = half(a);
      emit(face, nullptr, {first_, m_inner(m), corner(c)});
      emit(face, nullptr, {m, corner(b), m_inner(corner(c))});
    } else {
      split_in_three(face, a, b, c);
    }
  }

  /// Corner without its half-edge: a new edge starts there.
  static Corner m_inner(Corner c) {
    c.border = -1;
    c.known = 0;
    return c;
  }

  /// Splits half-edge h: `first_` starts the first half, the result the second.
  Corner half(std::size_t h) {
    Corner m = middle(h);
    first_ = corner(h);
    first_.known = 0;
    const auto b = halves(h);
    first_.border = b[0];
    m.border = b[1];
    return m;
  }

  void split_in_four(std::int32_t face, std::size_t h) {
    const Corner m0 = half(h), a = first_;
    const Corner m1 = half(h + 1), b = first_;
    const Corner m2 = half(h + 2), c = first_;
    emit(face, nullptr, {a, m_inner(m0), m2});
    emit(face, nullptr, {b, m_inner(m1), m0});
    emit(face, nullptr, {c, m_inner(m2), m1});
    emit(face, nullptr, {m_inner(m0), m_inner(m1), m_inner(m2)});
  }

  /// Edges a and b split: the triangle at their common corner, and the rest by its shorter
  /// diagonal.
  void split_in_three(std::int32_t face, std::size_t ha, std::size_t hb, std::size_t hc) {
    const Corner ma = half(ha), a = first_;
    const Corner mb = half(hb), b = first_;
    const Corner c = corner(hc);
    emit(face, nullptr, {b, m_inner(mb), ma});
    const auto far = [&](const Corner& p, const Corner& q) {
      return glm::length(m_.positions[p.vertex] - m_.positions[q.vertex]);
    };
    if (far(a, mb) <= far(ma, c)) {
      emit(face, nullptr, {a, m_inner(ma), m_inner(mb)});
      emit(face, nullptr, {m_inner(a), mb, c});
    } else {
      emit(face, nullptr, {a, m_inner(ma), c});
      emit(face, nullptr, {m_inner(ma), mb, m_inner(c)});
    }
  }

  RawMesh& raw_;
  ChartMesh& m_;
  const Atlas& atlas_;
  double tolerance_;
  const RunContext& context_;
  std::vector<HalfEdge> opposite_;
  // Of edges (at the lower half-edge) and triangles: measured, and by how much they are off.
  std::vector<std::uint8_t> known_, split_;
  std::vector<Off> error_, centre_;
  std::vector<std::uint8_t> centre_known_;
  std::vector<std::uint32_t> made_;  // vertex in the middle of an edge; 0: none yet
  Corner first_{};
  ChartMesh out_;
  std::vector<std::uint8_t> out_pole_, out_known_;
  std::vector<std::uint8_t> out_centre_known_;
  std::vector<Off> out_error_, out_centre_;
};

}  // namespace

void refine(RawMesh& raw, ManifoldPairs pairs, const Atlas& atlas, double tolerance,
            const RunContext& context) {
  Refiner(raw, atlas, tolerance, context).run(std::move(pairs));
}

}  // namespace burin
