#include <burin/base/parallel.h>
#include <burin/forms/charted/refine.h>
#include <burin/work_mesh/division.h>
#include <burin/work_mesh/half_edges.h>

#include "break_lines.h"
#include "unfold.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace burin {
namespace {

constexpr int kLevels = 12;                // an edge into 4096 pieces at the most
constexpr std::size_t kRefineGrain = 256;  // triangles
// Levels after which edges shorter than this share of the tolerance are left alone: S is far from
// them for other reasons than their length (it runs to and fro, or its tolerances are worse).
constexpr int kFirstLevels = 6;
constexpr double kShortestEdge = 0.25;
// From the middle of an edge, where it may be split at a break line.
constexpr double kCentral = 0.25;
// Halvings after which an edge that is still too far off is taken to cross a kink: most break
// lines are none, and regular triangles are worth more than triangles along them.
constexpr int kKinkLevel = 4;
// Square tolerances a triangle (at 0.05 mm of paper: 0.04 mm2), triangles that any part may have,
// and that none may: with their contours cut these took a gigabyte.
constexpr double kLeastArea = 16;
constexpr double kFewest = 100'000, kMost = 600'000;

/// How far S is off: in full, and with deviations along the triangle or edge counted less, by
/// which is split.
struct Off {
  double full = 0, weighted = 0;
  void add(Vec3 d, double part, bool across, double along) {
    // `part`: of d along the unit normal (or, not `across`, along the edge).
    const double all = glm::dot(d, d), other = std::max(0.0, all - part * part);
    const double less = 1 / (along * along);
    full = std::max(full, std::sqrt(all));
    const double w = across ? part * part + less * other : other + less * part * part;
    weighted = std::max(weighted, std::sqrt(w));
  }
};

class Refiner {
 public:
  Refiner(RawMesh& raw, const Atlas& atlas, const RefineOptions& options, const RunContext& context)
      : raw_(raw),
        m_(raw.mesh),
        atlas_(atlas),
        lines_(atlas),
        options_(options),
        context_(context) {
    known_.assign(m_.uv.size(), 0);
    error_.resize(m_.uv.size());
    centre_.resize(m_.triangles.size());
    centre_known_.assign(m_.triangles.size(), 0);
  }

  bool run(ManifoldPairs pairs) {
    bool complete = true;
    opposite_ = std::move(pairs.opposite);
    for (int level = 0;; ++level) {
      level_ = level;
      forget(unfold(raw_, opposite_, atlas_, lines_));
      measure(level < 2);
      bool more = mark(options_.tolerance, pairs.to_split) > 0;
      if (!more || (level >= kLevels && pairs.to_split.empty())) break;
      if (!fits()) {
        complete = false;
        more = mark(farthest(), pairs.to_split) > 0;
        if (!more || (!fits() && pairs.to_split.empty())) break;
      }
      split();
      pairs.to_split.clear();
      opposite_ = pair_half_edges(m_.triangles, m_.positions.size());
    }
    m_.tolerance = 0;
    for (std::size_t h = 0; h < error_.size(); ++h) {
      if (known_[h]) m_.tolerance = std::max(m_.tolerance, error_[h].full);
    }
    for (const Off& e : centre_) m_.tolerance = std::max(m_.tolerance, e.full);
    return complete;
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

  /// The share of an edge inside a face at which it crosses the break line nearest to its middle;
  /// the middle itself where it crosses none, or one so near to an end that slivers would be left.
  double split_share(std::size_t h) const {
    const std::int32_t face = m_.face[h / 3];
    if (level_ < kKinkLevel || m_.border[h] >= 0 || lines_.none(face)) return 0.5;
    const double share =
        lines_.crossing(face, raw_.on_edge(atlas_, h, 0), raw_.on_edge(atlas_, h, 1));
    return std::abs(share - 0.5) <= kCentral ? share : 0.5;
  }

  void measure_edge(std::size_t h, bool quarters) {
    const Chart& chart = atlas_.chart(m_.face[h / 3]);
    const Vec3 a = m_.positions[m_.triangles[h / 3][h % 3]];
    const Vec3 b = m_.positions[m_.triangles[h / 3][(h + 1) % 3]];
    Off e;
    const bool border = m_.border[h] >= 0;
    if (border || chart.kind() != FaceKind::Plane) {
      const Vec3 axis = border ? normalize_or(b - a, Vec3(0)) : normal(h / 3);
      const auto look = [&](double s) {
        const Vec3 d = chart.position(raw_.on_edge(atlas_, h, s)) - (a + s * (b - a));
        e.add(d, glm::dot(d, axis), !border, options_.along);
      };
      look(0.5);
      const double kink = split_share(h);
      if (kink != 0.5) look(kink);
      if (quarters) {
        look(0.25);
        look(0.75);
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
    centre_[f].add(d, glm::dot(d, normal(f)), true, options_.along);
  }

  void measure(bool quarters) {
    parallel_for(
        m_.triangles.size(), kRefineGrain,
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

  bool first_of_edge(std::size_t h) const { return opposite_[h] < 0 || h < at(opposite_[h]); }

  /// Whether shorter edges would come nearer to S.
  bool may_split(std::size_t h) const {
    return level_ < kFirstLevels || length(h) > kShortestEdge * options_.tolerance;
  }

  std::size_t longest_edge(std::size_t f) const {
    std::size_t longest = 3 * f;
    for (std::size_t h = 3 * f + 1; h < 3 * f + 3; ++h) {
      if (length(h) > length(longest)) longest = h;
    }
    return longest;
  }

  /// Marks the edges that are to be split, on both sides, and returns their number.
  std::size_t mark(double limit, const std::vector<HalfEdge>& in_any_case) {
    split_.assign(m_.uv.size(), 0);
    std::size_t count = 0;
    const auto mark_edge = [&](std::size_t h) {
      split_[h] = 1;
      if (opposite_[h] >= 0) split_[at(opposite_[h])] = 1;
      ++count;
    };
    for (std::size_t h = 0; h < split_.size(); ++h) {
      if (first_of_edge(h) && error_[h].weighted > limit && may_split(h)) mark_edge(h);
    }
    for (const HalfEdge h : in_any_case) mark_edge(at(h));
    for (std::size_t f = 0; f < m_.triangles.size(); ++f) {
      if (centre_[f].weighted <= limit || split_[3 * f] || split_[3 * f + 1] || split_[3 * f + 2]) {
        continue;
      }
      const std::size_t h = longest_edge(f);
      if (may_split(h)) mark_edge(h);
    }
    return count;
  }

  /// Every half-edge that is split makes one triangle more.
  bool fits() const {
    const auto more = static_cast<std::size_t>(std::ranges::count(split_, 1));
    return m_.triangles.size() + more <= options_.most;
  }

  /// The deviation above which there is room to split all edges.
  double farthest() const {
    const std::size_t now = m_.triangles.size();
    const std::size_t room = options_.most > now ? (options_.most - now) / 2 : 0;
    std::vector<double> off;
    for (std::size_t h = 0; h < error_.size(); ++h) {
      const double centre = centre_[h / 3].weighted;
      const bool through_centre = centre > options_.tolerance && longest_edge(h / 3) == h;
      const double edge = first_of_edge(h) && may_split(h) ? error_[h].weighted : 0;
      const double w = through_centre ? std::max(edge, centre) : edge;
      if (w > options_.tolerance) off.push_back(w);
    }
    if (room == 0 || off.empty()) return 1e300;
    if (room >= off.size()) return options_.tolerance;
    std::nth_element(off.begin(), off.begin() + static_cast<std::ptrdiff_t>(room), off.end(),
                     std::greater<>());
    return off[room];
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

  /// The new vertex on half-edge h, as a corner.
  Corner middle(std::size_t h) {
    const std::size_t owner = opposite_[h] >= 0 ? std::min(h, at(opposite_[h])) : h;
    std::uint32_t& v = made_[owner];
    const double share = split_share(owner);
    const Vec2 uv =
        lines_.snap(m_.face[h / 3], raw_.on_edge(atlas_, h, owner == h ? share : 1 - share));
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
    std::array<Corner, 6> c{};
    std::array<std::array<std::int32_t, 2>, 3> borders{};
    std::array<Vec3, 6> points{};
    std::uint8_t marks = 0;
    // Of two marked edges the one that the other follows is first: new vertices are numbered so.
    const std::size_t first = count == 2 && !split_[h + 1] ? 2 : 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t k = (first + i) % 3;
      c[k] = corner(h + k);
      if (!split_[h + k]) continue;
      marks |= static_cast<std::uint8_t>(1U << k);
      c[3 + k] = middle(h + k);
      borders[k] = halves(h + k);
    }
    for (std::size_t k = 0; k < 6; ++k) {
      if (k < 3 || split_[h + k - 3]) points[k] = m_.positions[c[k].vertex];
    }
    for (const Division::Piece& piece : divide(marks, points)) {
      std::array<Corner, 3> corners;
      for (std::size_t k = 0; k < 3; ++k) {
        corners[k] = leaving(c, borders, piece[k], piece[(k + 1) % 3]);
      }
      emit(face, nullptr, corners);
    }
  }

  /// Corner p of a divided triangle, with the edge to q that leaves it there.
  static Corner leaving(const std::array<Corner, 6>& corners,
                        const std::array<std::array<std::int32_t, 2>, 3>& borders, std::uint8_t p,
                        std::uint8_t q) {
    Corner out = corners[p];
    if (p < 3 && q == (p + 1) % 3) return out;  // a side that stayed whole
    const int side = side_of(p, q);
    out.border = side < 0 ? -1 : borders[at(side)][p < 3 ? 0 : 1];
    out.known = 0;
    return out;
  }

  RawMesh& raw_;
  ChartMesh& m_;
  const Atlas& atlas_;
  detail::BreakLines lines_;
  RefineOptions options_;
  int level_ = 0;
  const RunContext& context_;
  std::vector<HalfEdge> opposite_;
  // Of edges (at the lower half-edge) and triangles: measured, and by how much they are off.
  std::vector<std::uint8_t> known_, split_;
  std::vector<Off> error_, centre_;
  std::vector<std::uint8_t> centre_known_;
  std::vector<std::uint32_t> made_;  // vertex in the middle of an edge; 0: none yet
  ChartMesh out_;
  std::vector<std::uint8_t> out_pole_, out_known_;
  std::vector<std::uint8_t> out_centre_known_;
  std::vector<Off> out_error_, out_centre_;
};

}  // namespace

bool refine(RawMesh& raw, ManifoldPairs pairs, const Atlas& atlas, const RefineOptions& options,
            const RunContext& context) {
  return Refiner(raw, atlas, options, context).run(std::move(pairs));
}

std::size_t triangle_bound(double size, double tolerance) {
  const double half = 0.5 * size / tolerance;
  return static_cast<std::size_t>(std::clamp(half * half / kLeastArea, kFewest, kMost));
}

void add_triangles_bounded(Diagnostics& diagnostics, std::size_t triangles, double distance,
                           double tolerance) {
  diagnostics.add(Severity::Warning, "surface.triangles_bounded", 1,
                  fmt::format("{} triangles are the most that this part gets on this sheet: they "
                              "are up to {:.3g} mm off the surface, not {:.3g}; a larger "
                              "`tolerance` asks for fewer, a larger sheet allows more",
                              triangles, distance, tolerance));
}

}  // namespace burin
