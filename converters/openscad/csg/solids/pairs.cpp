#include "pairs.h"

#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <limits>

namespace burin::csg {
namespace {

struct Interval {
  Id from = 0, to = 0;
};

/// The part of a line that lies in a facet, the line being where its plane meets `other`.
class Section {
 public:
  Section(Space& space, const Facet& facet, Id other)
      : space_(space), facet_(facet), other_(other) {}

  /// False where the facet lies on one side.
  bool crosses() {
    double low = 1, high = -1;
    sides_.resize(facet_.edges.size());
    for (std::size_t i = 0; i < facet_.edges.size(); ++i) {
      const int s = space_.side(facet_.edges[i].a, other_);
      sides_[i] = {s, 0};
      low = std::min<double>(low, s);
      high = std::max<double>(high, s);
    }
    if (low > 0 || high < 0) return false;
    for (std::size_t i = 0; i < facet_.edges.size(); ++i) {
      sides_[i].second = space_.side(facet_.edges[i].b, other_);
    }
    return true;
  }

  /// Where the section surely ends, seen along a direction; wider where an edge runs nearly along
  /// the other plane.
  std::pair<double, double> range(Vec3 way) const {
    std::pair<double, double> out{std::numeric_limits<double>::infinity(),
                                  -std::numeric_limits<double>::infinity()};
    const auto take = [&](Vec3 p) {
      const double t = glm::dot(way, p);
      out = {std::min(out.first, t), std::max(out.second, t)};
    };
    for (std::size_t i = 0; i < facet_.edges.size(); ++i) {
      const auto [sa, sb] = sides_[i];
      if (sa * sb > 0) continue;
      const Vec3 a = space_.at(facet_.edges[i].a), b = space_.at(facet_.edges[i].b);
      const double da = space_.distance(other_, a).first, db = space_.distance(other_, b).first;
      if (sa * sb < 0 && std::abs(da - db) > 1e-5 * glm::length(b - a)) {
        take(a + std::clamp(da / (da - db), 0.0, 1.0) * (b - a));
      } else {
        if (sa == 0 || sa * sb < 0) take(a);
        if (sb == 0 || sa * sb < 0) take(b);
      }
    }
    return out;
  }

  /// As closed intervals, sorted, apart or touching.
  std::vector<Interval> intervals(Id line) {
    std::vector<Interval> out;
    std::vector<Id> below, above;
    for (std::size_t i = 0; i < facet_.edges.size(); ++i) {
      const Edge& e = facet_.edges[i];
      const auto [sa, sb] = sides_[i];
      if (sa == 0 && sb == 0) {
        out.push_back(space_.along(line, e.a, e.b) <= 0 ? Interval{e.a, e.b} : Interval{e.b, e.a});
      } else if (sa == 0) {
        out.push_back({e.a, e.a});
      }
      // The facet a little to either side of the line: where it enters and leaves.
      if ((sa < 0) != (sb < 0)) below.push_back(point(e, sa, sb));
      if ((sa <= 0) != (sb <= 0)) above.push_back(point(e, sa, sb));
    }
    for (std::vector<Id>* ends : {&below, &above}) {
      sort(line, *ends);
      for (std::size_t i = 0; i + 1 < ends->size(); i += 2)
        out.push_back({(*ends)[i], (*ends)[i + 1]});
    }
    std::ranges::sort(out, [&](const Interval& x, const Interval& y) {
      const int c = space_.along(line, x.from, y.from);
      return c < 0 || (c == 0 && space_.along(line, x.to, y.to) < 0);
    });
    return joined(line, out);
  }

 private:
  Id point(const Edge& e, int sa, int sb) {
    if (sa == 0) return e.a;
    if (sb == 0) return e.b;
    const Id p = space_.meet(e.line, other_);
    space_.lies_in(p, facet_.plane);
    return p;
  }
  void sort(Id line, std::vector<Id>& points) {
    std::ranges::sort(points, [&](Id x, Id y) { return space_.along(line, x, y) < 0; });
  }
  /// Overlapping ones become one, divided again at all ends: each may be a corner elsewhere.
  std::vector<Interval> joined(Id line, const std::vector<Interval>& sorted) {
    if (sorted.size() < 2) return sorted;
    std::vector<Id> ends;
    for (const Interval& i : sorted) ends.insert(ends.end(), {i.from, i.to});
    sort(line, ends);
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    std::vector<Interval> out;
    std::size_t at = 0,
                last = 0;  // of `ends`: where the next interval may begin, where the last ended
    for (const Interval& i : sorted) {
      const auto place = [&](Id p) {
        return static_cast<std::size_t>(std::ranges::find(ends, p) - ends.begin());
      };
      const std::size_t from = std::max(place(i.from), at), to = place(i.to);
      for (std::size_t k = from; k < to; ++k) out.push_back({ends[k], ends[k + 1]});
      if (from >= to && (out.empty() || place(i.to) > last)) out.push_back({i.to, i.to});
      last = std::max(last, to);
      at = std::max(at, to);
    }
    return out;
  }

  Space& space_;
  const Facet& facet_;
  Id other_;
  std::vector<std::pair<int, int>> sides_;
};

struct BoxOf {
  using NT = double;
  using ID = std::size_t;
  const FacetBox* f = nullptr;
  std::uint32_t index = 0;
  static int dimension() { return 3; }
  ID id() const { return index; }
  NT min_coord(int d) const { return f->box.min[d]; }
  NT max_coord(int d) const { return f->box.max[d]; }
};

}  // namespace

void meet_facets(Space& space, const Facet& f, const Facet& g, std::vector<Meeting>& out) {
  Section sf(space, f, g.plane), sg(space, g, f.plane);
  if (!sf.crosses() || !sg.crosses()) return;
  const Vec3 way = glm::cross(space.normal(f.plane), space.normal(g.plane));
  if (glm::length(way) > 1e-6) {
    // Far above what rounding does to the ends: points are made only where the sections come close.
    const double near = 1e-8 * space.size();
    const auto u = sf.range(way), v = sg.range(way);
    if (u.first > v.second + near || v.first > u.second + near) return;
  }
  const Id line = space.line(f.plane, g.plane);
  const std::vector<Interval> a = sf.intervals(line);
  if (a.empty()) return;
  const std::vector<Interval> b = sg.intervals(line);
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    const Id from = space.along(line, a[i].from, b[j].from) >= 0 ? a[i].from : b[j].from;
    const bool a_first = space.along(line, a[i].to, b[j].to) <= 0;
    const Id to = a_first ? a[i].to : b[j].to;
    if (space.along(line, from, to) <= 0) out.push_back({from, to, line});
    ++(a_first ? i : j);
  }
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> overlapping(std::span<const FacetBox> boxes,
                                                                 std::span<const char> tangled,
                                                                 RunContext& context) {
  std::vector<BoxOf> all(boxes.size());
  std::vector<const BoxOf*> pointers;
  pointers.reserve(all.size());
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    all[i] = {&boxes[i], i};
    pointers.push_back(&all[i]);
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> out;
  std::size_t looked = 0;
  const auto meet = [&](const BoxOf* a, const BoxOf* b) {
    if (++looked % 4096 == 0) context.check();
    if (a->f->mesh == b->f->mesh && !tangled[a->f->mesh]) return;
    out.emplace_back(std::min(a->index, b->index), std::max(a->index, b->index));
  };
  CGAL::box_self_intersection_d(pointers.begin(), pointers.end(), meet, std::ptrdiff_t{30});
  std::ranges::sort(out);
  return out;
}

}  // namespace burin::csg
