#include "arrange.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <unordered_map>

namespace burin::csg {
namespace {

std::uint64_t undirected(Id a, Id b) {
  return (std::uint64_t{std::min(a, b)} << 32) | std::max(a, b);
}

/// Part of a line that edges and meetings cover without a gap, to be divided where others end on it
/// or cross it.
struct Segment {
  Id a = 0, b = 0, line = 0;
  /// Where it is divided: the ends of all that it is made of, and what crosses it.
  std::vector<Id> splits;
  /// The edges of facets in it.
  struct Side {
    Id a = 0, b = 0, facet = 0;
  };
  std::vector<Side> sides;
};

class Divider {
 public:
  Divider(Space& space, Id plane) : space_(space), plane_(plane) {
    const int axis = space.main_axis(plane);
    i_ = (axis + 1) % 3;
    j_ = (axis + 2) % 3;
  }

  /// `facet`: whose edge it is, or kNone.
  void add(Id a, Id b, Id line, Id facet) {
    if (space_.along(line, a, b) > 0) std::swap(a, b);
    by_line_[line].push_back({a, b, facet});
  }
  void add_point(Id p) { points_.push_back(p); }

  std::vector<Segment>& divide() {
    for (auto& [line, parts] : by_line_) join(line, parts);
    std::vector<std::uint32_t> order(segments_.size());
    std::iota(order.begin(), order.end(), 0u);
    low_.resize(order.size());
    high_.resize(order.size());
    for (const std::uint32_t s : order) {
      const Vec3 a = space_.at(segments_[s].a), b = space_.at(segments_[s].b);
      const double e = 4 * (space_.error(segments_[s].a) + space_.error(segments_[s].b));
      low_[s] = {std::min(a[i_], b[i_]) - e, std::min(a[j_], b[j_]) - e};
      high_[s] = {std::max(a[i_], b[i_]) + e, std::max(a[j_], b[j_]) + e};
    }
    std::ranges::stable_sort(
        order, [&](std::uint32_t x, std::uint32_t y) { return low_[x].x < low_[y].x; });
    for (std::size_t k = 0; k < order.size(); ++k) {
      const std::uint32_t s = order[k];
      for (std::size_t l = k + 1; l < order.size() && low_[order[l]].x <= high_[s].x; ++l) {
        const std::uint32_t t = order[l];
        if (low_[t].y <= high_[s].y && low_[s].y <= high_[t].y) cross(segments_[s], segments_[t]);
      }
    }
    std::ranges::sort(points_);
    points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
    for (const Id p : points_) put_on_all(p);
    return segments_;
  }

 private:
  /// Many facets meet in one line where walls stand on one floor: what overlaps is one segment.
  void join(Id line, std::vector<Segment::Side>& parts) {
    std::ranges::sort(parts, [&](const Segment::Side& x, const Segment::Side& y) {
      const int c = space_.along(line, x.a, y.a);
      return c != 0 ? c < 0 : x.facet < y.facet;
    });
    for (const Segment::Side& part : parts) {
      if (segments_.empty() || segments_.back().line != line ||
          space_.along(line, part.a, segments_.back().b) > 0) {
        segments_.push_back({part.a, part.b, line, {}, {}});
      }
      Segment& s = segments_.back();
      if (space_.along(line, part.b, s.b) > 0) s.b = part.b;
      s.splits.insert(s.splits.end(), {part.a, part.b});
      if (part.facet != kNone) s.sides.push_back(part);
    }
  }

  bool inner(const Segment& s, Id p) {
    if (p == s.a || p == s.b) return false;
    return space_.along(s.line, s.a, p) * space_.along(s.line, p, s.b) > 0;
  }
  void split_at(Segment& s, Id p) {
    if (inner(s, p)) s.splits.push_back(p);
  }
  /// The side of a segment on which a point lies.
  int side(const Segment& s, Id p) {
    if (p == s.a || p == s.b) return 0;
    return space_.turn(plane_, s.a, s.b, p);
  }

  void cross(Segment& s, Segment& t) {
    if (s.line == t.line) return;
    const bool shared = s.a == t.a || s.a == t.b || s.b == t.a || s.b == t.b;
    const int ta = side(s, t.a), tb = side(s, t.b);
    if (ta * tb > 0 || (shared && (ta != 0 || tb != 0))) return;
    if (ta == 0 && tb == 0) {
      for (const Id p : {t.a, t.b}) split_at(s, p);
      for (const Id p : {s.a, s.b}) split_at(t, p);
      return;
    }
    const int sa = side(t, s.a), sb = side(t, s.b);
    if (sa * sb > 0) return;
    if (ta == 0) return split_at(s, t.a);
    if (tb == 0) return split_at(s, t.b);
    if (sa == 0) return split_at(t, s.a);
    if (sb == 0) return split_at(t, s.b);
    const Id p = crossing(s, t);
    space_.lies_in(p, plane_);
    s.splits.push_back(p);
    t.splits.push_back(p);
  }

  Id crossing(const Segment& s, const Segment& t) {
    // Where s passes t, from the areas to both sides of t.
    const auto [ua, ue] = space_.area(plane_, t.a, t.b, s.a);
    const auto [va, ve] = space_.area(plane_, t.a, t.b, s.b);
    const double whole = std::abs(ua - va), share = ua / (ua - va);
    const Vec3 a = space_.at(s.a), b = space_.at(s.b);
    const double error = 2 * glm::length(b - a) * ((ue + ve) / whole) + space_.error(s.a) +
                         space_.error(s.b) + 4e-16 * space_.size();
    return space_.meet(s.line, space_.other_plane(t.line, plane_), a + share * (b - a),
                       whole > 0 ? error : -1);
  }

  void put_on_all(Id p) {
    const Vec3 at = space_.at(p);
    for (std::uint32_t k = 0; k < segments_.size(); ++k) {
      if (at[i_] < low_[k].x - 4 * space_.error(p) || at[i_] > high_[k].x + 4 * space_.error(p) ||
          at[j_] < low_[k].y - 4 * space_.error(p) || at[j_] > high_[k].y + 4 * space_.error(p)) {
        continue;
      }
      Segment& s = segments_[k];
      if (p != s.a && p != s.b && side(s, p) == 0) split_at(s, p);
    }
  }

  Space& space_;
  Id plane_;
  int i_ = 0, j_ = 1;
  std::map<Id, std::vector<Segment::Side>> by_line_;
  std::vector<Segment> segments_;
  std::vector<Id> points_;
  std::vector<Vec2> low_, high_;
};

/// A piece of an edge, and the facets that end on it.
struct Part {
  Id line = 0;
  std::vector<std::uint32_t> facets;
};

class Pieces {
 public:
  Pieces(Space& space, const Sheet& sheet) : space_(space), sheet_(sheet) {}

  void run(const Judge& judge, std::vector<Facet>& out) {
    cut();
    flood();
    pieces_.resize(covering_.size());
    for (std::uint32_t r = 0; r < covering_.size(); ++r) {
      if (!covering_[r].empty()) pieces_[r] = judge(net_.triangles[largest_[r]], covering_[r]);
    }
    collect(out);
  }

 private:
  void cut() {
    Divider divider(space_, sheet_.plane);
    for (std::uint32_t f = 0; f < sheet_.facets.size(); ++f) {
      for (const Edge& e : sheet_.facets[f]->edges) divider.add(e.a, e.b, e.line, f);
    }
    for (const Meeting& m : sheet_.meetings) {
      if (m.a == m.b) {
        divider.add_point(m.a);
      } else {
        divider.add(m.a, m.b, m.line, kNone);
      }
    }
    std::vector<std::array<Id, 2>> edges;
    for (Segment& s : divider.divide()) {
      std::vector<Id>& at = s.splits;
      std::ranges::sort(at, [&](Id x, Id y) { return space_.along(s.line, x, y) < 0; });
      at.erase(std::unique(at.begin(), at.end()), at.end());
      for (std::size_t k = 0; k + 1 < at.size(); ++k) {
        const auto [part, fresh] = parts_.try_emplace(undirected(at[k], at[k + 1]));
        if (!fresh) continue;
        part->second.line = s.line;
        edges.push_back({at[k], at[k + 1]});
      }
      for (const Segment::Side& side : s.sides) {
        const auto first = std::ranges::find(at, side.a);
        for (auto k = first; *k != side.b; ++k) {
          parts_.at(undirected(*k, *(k + 1))).facets.push_back(side.facet);
        }
      }
    }
    net_ = triangulate(space_, sheet_.plane, edges);
  }

  const Part* part(std::size_t t, std::size_t k) const {
    const auto& c = net_.triangles[t];
    const auto found = parts_.find(undirected(c[(k + 1) % 3], c[(k + 2) % 3]));
    return found == parts_.end() ? nullptr : &found->second;
  }

  static std::vector<std::uint32_t> toggled(const std::vector<std::uint32_t>& set,
                                            const std::vector<std::uint32_t>& by) {
    std::vector<std::uint32_t> sorted = by, out;
    std::ranges::sort(sorted);
    std::ranges::set_symmetric_difference(set, sorted, std::back_inserter(out));
    return out;
  }

  /// Regions between edges, from outside inwards.
  void flood() {
    region_.assign(net_.triangles.size(), kNone);
    std::vector<std::uint32_t> seeds;
    for (std::uint32_t t = 0; t < net_.triangles.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (net_.neighbor[t][k] != kNone || region_[t] != kNone) continue;
        const Part* p = net_.is_edge[t][k] ? part(t, k) : nullptr;
        fill(t, p ? toggled({}, p->facets) : std::vector<std::uint32_t>{}, seeds);
      }
    }
    for (std::size_t s = 0; s < seeds.size(); ++s) {
      const std::uint32_t t = seeds[s];
      for (std::size_t k = 0; k < 3; ++k) {
        const Id n = net_.neighbor[t][k];
        if (n == kNone || region_[n] != kNone) continue;
        const Part* p = part(t, k);
        fill(n, toggled(covering_[region_[t]], p ? p->facets : std::vector<std::uint32_t>{}),
             seeds);
      }
    }
  }
  void fill(std::uint32_t seed, std::vector<std::uint32_t> covering,
            std::vector<std::uint32_t>& seeds) {
    const auto r = static_cast<Id>(covering_.size());
    covering_.push_back(std::move(covering));
    largest_.push_back(seed);
    double most = -1;
    std::vector<std::uint32_t> open{seed};
    region_[seed] = r;
    while (!open.empty()) {
      const std::uint32_t t = open.back();
      open.pop_back();
      const auto& c = net_.triangles[t];
      const Vec3 u = space_.at(c[1]) - space_.at(c[0]), v = space_.at(c[2]) - space_.at(c[0]);
      // The one that holds the widest circle, nearly: slivers are long.
      const double twice = glm::length(glm::cross(u, v));
      const double width = twice / (glm::length(u) + glm::length(v) + glm::length(u - v));
      if (width > most) most = width, largest_[r] = t;
      for (std::size_t k = 0; k < 3; ++k) {
        const Id n = net_.neighbor[t][k];
        if (n == kNone) continue;
        if (net_.is_edge[t][k]) {
          seeds.push_back(t);
        } else if (region_[n] == kNone) {
          region_[n] = r;
          open.push_back(n);
        }
      }
    }
  }

  /// Facets of what is kept, and their edges.
  void collect(std::vector<Facet>& out) {
    std::vector<char> done(net_.triangles.size(), 0);
    for (std::uint32_t seed = 0; seed < net_.triangles.size(); ++seed) {
      const Piece piece = pieces_[region_[seed]];
      if (piece.way == 0 || done[seed]) continue;
      Facet facet{sheet_.plane, piece.way > 0, piece.surface, {}, {}};
      std::vector<std::uint32_t> open{seed};
      done[seed] = 1;
      // Triangles turn about the main axis, facets about their outside.
      const bool same =
          (space_.normal(sheet_.plane)[space_.main_axis(sheet_.plane)] > 0) == facet.along;
      while (!open.empty()) {
        const std::uint32_t t = open.back();
        open.pop_back();
        for (std::size_t k = 0; k < 3; ++k) {
          const Id n = net_.neighbor[t][k];
          if (n != kNone && pieces_[region_[n]] == piece) {
            if (!done[n]) done[n] = 1, open.push_back(n);
            continue;
          }
          const Id a = net_.triangles[t][(k + 1) % 3], b = net_.triangles[t][(k + 2) % 3];
          facet.edges.push_back({same ? a : b, same ? b : a, part(t, k)->line});
        }
      }
      out.push_back(std::move(facet));
    }
  }

  Space& space_;
  const Sheet& sheet_;
  std::unordered_map<std::uint64_t, Part> parts_;
  Triangulation net_;
  std::vector<Id> region_;
  std::vector<std::vector<std::uint32_t>> covering_;
  std::vector<std::uint32_t> largest_;
  std::vector<Piece> pieces_;
};

}  // namespace

void arrange(Space& space, const Sheet& sheet, const Judge& judge, std::vector<Facet>& out) {
  Pieces(space, sheet).run(judge, out);
}

}  // namespace burin::csg
