#include "cutter.h"

#include <burin/base/box.h>
#include <burin/planar/triangulate.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace burin::detail {
namespace {

/// Of the diagonal: a vertex so near the plane lies on it. Coordinates of files are rounded to
/// 1e-7 of themselves.
constexpr double kOnPlane = 1e-6;

Vec3 unit(std::size_t k) {
  Vec3 bary(0);
  bary[static_cast<int>(k)] = 1;
  return bary;
}

/// Drops the edges of what hangs together with a vertex that as many edges do not leave as come.
/// False where there are any.
bool keep_closed_loops(std::vector<DirectedEdge>& edges) {
  std::unordered_map<std::uint32_t, int> balance;
  for (const auto& [from, to] : edges) ++balance[from], --balance[to];
  if (std::ranges::all_of(balance, [](const auto& entry) { return entry.second == 0; }))
    return true;
  std::unordered_map<std::uint32_t, std::uint32_t> joined;
  const auto root = [&](std::uint32_t v) {
    std::uint32_t top = v;
    for (auto at = joined.find(top); at != joined.end(); at = joined.find(top)) top = at->second;
    for (; v != top; v = std::exchange(joined.at(v), top)) {
    }
    return top;
  };
  for (const auto& [from, to] : edges) {
    const std::uint32_t a = root(from), b = root(to);
    if (a != b) joined[a] = b;
  }
  std::unordered_set<std::uint32_t> open;
  for (const auto& [vertex, count] : balance) {
    if (count != 0) open.insert(root(vertex));
  }
  std::erase_if(edges, [&](const DirectedEdge& e) { return open.contains(root(e[0])); });
  return false;
}

/// Two axes of the plane that make a right-handed system with its normal.
std::pair<Vec3, Vec3> axes_of(const CutPlane& plane) {
  const Vec3 u = any_orthogonal(plane.normal);
  return {u, glm::cross(plane.normal, u)};
}

Vec3 across(const std::vector<Vec3>& positions, const Triangle& t) {
  return glm::cross(positions[t[1]] - positions[t[0]], positions[t[2]] - positions[t[0]]);
}

CutTriangle turned_over(CutTriangle t) {
  std::swap(t.corners[0], t.corners[2]);
  std::swap(t.piece.bary[0], t.piece.bary[2]);
  return t;
}

}  // namespace

/// What is left of a triangle: up to four corners, each once.
class Cutter::Polygon {
 public:
  void add(Corner c) {
    if (size_ == 0 || corners_[size_ - 1].vertex != c.vertex) corners_[size_++] = c;
  }
  void end() {
    if (size_ > 1 && corners_[size_ - 1].vertex == corners_[0].vertex) --size_;
  }
  std::size_t size() const { return size_; }
  const Corner& operator[](std::size_t i) const { return corners_[i]; }

 private:
  std::array<Corner, 5> corners_{};
  std::size_t size_ = 0;
};

Cutter::Cutter(const TriMesh& mesh, Lift lift, const RunContext& context)
    : positions(mesh.positions),
      lift_(std::move(lift)),
      context_(context),
      on_some_plane_(mesh.positions.size(), 0) {
  Box3 box;
  for (const Vec3& p : positions) box.add(p);
  on_plane_ = kOnPlane * box.diagonal();
  body_.reserve(mesh.triangles.size());
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
    body_.push_back({mesh.triangles[f], {f, {unit(0), unit(1), unit(2)}}});
  }
}

void Cutter::measure(const CutPlane& plane) {
  plane_ = plane;
  height_.clear();
  height_.reserve(positions.size());
  for (Vec3& p : positions) {
    double height = glm::dot(plane.normal, p) - plane.offset;
    // What counts as on the plane lies on it: the face that closes the cut is flat, and the lines
    // of its hatching are not behind it.
    if (std::abs(height) <= on_plane_) {
      p -= height * plane.normal;
      height = 0;
    }
    height_.push_back(height);
  }
  points_.clear();
}

bool Cutter::lies_on_plane(std::uint32_t vertex) const {
  return vertex >= height_.size() || std::abs(height_[vertex]) <= on_plane_;
}

bool Cutter::lies_in_plane(const CutTriangle& t) const {
  return std::ranges::all_of(t.corners, [&](std::uint32_t v) { return lies_on_plane(v); });
}

void Cutter::cut(const CutPlane& plane, std::int32_t number, bool last) {
  if (whole_) return;
  measure(plane);
  const auto any = [&](const auto& side) {
    return std::ranges::any_of(body_, [&](const CutTriangle& t) {
      return std::ranges::any_of(t.corners, [&](std::uint32_t v) { return side(height_[v]); });
    });
  };
  whole_ = !any([&](double h) { return h > on_plane_; });
  if (whole_ || !any([&](double h) { return h < -on_plane_; })) return;
  std::vector<CutTriangle> near, far, in_plane, sheets;
  for (std::size_t i = 0; i < body_.size(); ++i) {
    if (i % 65536 == 0) context_.check();
    const CutTriangle& t = body_[i];
    const bool wall = t.piece.facet == kNoFacet;
    if (!last && !wall && lies_in_plane(t) &&
        glm::dot(plane.normal, across(positions, t.corners)) > 0) {
      in_plane.push_back(t);
      in_plane.back().piece.plane = number;
    } else {
      divide(t, &near, last && !wall ? nullptr : &far);
    }
  }
  for (const CutTriangle& t : sheets_) divide(t, &kept_, &sheets);
  sheets_ = std::move(sheets);
  std::vector<CutTriangle> walls;
  if (!close(plane, number, near, in_plane, walls)) open_ = true;
  divide_kept_edges();
  sheets_.insert(sheets_.end(), in_plane.begin(), in_plane.end());
  std::ranges::copy_if(near, std::back_inserter(kept_),
                       [](const CutTriangle& t) { return t.piece.facet != kNoFacet; });
  body_ = std::move(far);
  body_.insert(body_.end(), walls.begin(), walls.end());
  on_some_plane_.resize(positions.size(), 0);
  for (std::uint32_t v = 0; v < positions.size(); ++v)
    on_some_plane_[v] |= lies_on_plane(v) ? 1 : 0;
}

/// Into what lies before the plane and beyond it; what lies on the plane is beyond it.
void Cutter::divide(const CutTriangle& t, std::vector<CutTriangle>* near,
                    std::vector<CutTriangle>* far) {
  Polygon before, behind;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t j = (k + 1) % 3;
    const bool here = beyond(t.corners[k]), there = beyond(t.corners[j]);
    (here ? behind : before).add({t.corners[k], t.piece.bary[k]});
    if (here == there) continue;
    const Corner middle = between(t, k, j);
    before.add(middle);
    behind.add(middle);
  }
  if (near) add_polygon(before, t.piece, *near);
  if (far) add_polygon(behind, t.piece, *far);
}

void Cutter::add_polygon(Polygon polygon, const FacetPiece& piece,
                         std::vector<CutTriangle>& out) const {
  polygon.end();
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    out.push_back({{polygon[a].vertex, polygon[b].vertex, polygon[c].vertex}, piece});
    out.back().piece.bary = {polygon[a].bary, polygon[b].bary, polygon[c].bary};
  };
  const auto at = [&](std::size_t i) { return positions[polygon[i].vertex]; };
  if (polygon.size() == 3) return add(0, 1, 2);
  if (polygon.size() < 3) return;
  if (glm::distance(at(0), at(2)) <= glm::distance(at(1), at(3))) {
    add(0, 1, 2);
    add(0, 2, 3);
  } else {
    add(0, 1, 3);
    add(1, 2, 3);
  }
}

/// Finds the walls of what lies beyond the plane, by the loops of what lies before it: its edges on
/// the plane beside which the other triangle is gone. False where some do not close.
bool Cutter::close(const CutPlane& plane, std::int32_t number, std::span<const CutTriangle> near,
                   std::span<const CutTriangle> sheets, std::vector<CutTriangle>& walls) {
  // In the order of the triangles, so that no hash decides about anything; as the triangle that
  // closes them has them.
  std::vector<DirectedEdge> edges;
  std::unordered_map<std::uint64_t, int> count;
  for (const auto& triangles : {near, sheets}) {
    for (const CutTriangle& t : triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = t.corners[k], b = t.corners[(k + 1) % 3];
        if (!lies_on_plane(a) || !lies_on_plane(b)) continue;
        ++count[edge_key(a, b)];
        edges.push_back({b, a});
      }
    }
  }
  std::erase_if(edges, [&](const DirectedEdge& e) {
    const auto other = count.find(edge_key(e[0], e[1]));
    if (other == count.end() || other->second == 0) return false;
    --other->second;  // each takes one away: walls may lie on edges of others
    return true;
  });
  const bool closed = keep_closed_loops(edges);
  if (edges.empty()) return closed;
  std::map<std::uint32_t, std::uint32_t> index;  // of the vertices that the loops have
  for (const auto& [from, to] : edges) index.try_emplace(from, 0);
  std::vector<std::uint32_t> vertices;
  std::vector<Vec2> points;
  const auto [u, v] = axes_of(plane);
  for (auto& [vertex, i] : index) {
    i = static_cast<std::uint32_t>(vertices.size());
    vertices.push_back(vertex);
    const Vec3& p = positions[vertex];
    points.emplace_back(glm::dot(u, p), glm::dot(v, p));
  }
  std::vector<DirectedEdge> inner;
  for (const auto& [from, to] : edges) inner.push_back({index.at(from), index.at(to)});
  const Triangulated area = triangulate(points, inner);
  for (const Vec2& p : area.added) {
    vertices.push_back(static_cast<std::uint32_t>(positions.size()));
    positions.push_back(p.x * u + p.y * v + plane.offset * plane.normal);
  }
  for (const auto& t : area.triangles) {
    walls.push_back(
        turned_over({{vertices[t[0]], vertices[t[1]], vertices[t[2]]}, {.plane = number}}));
  }
  return closed;
}

/// What was kept before has edges in common with what is divided now, on the planes before: they
/// are divided alike.
void Cutter::divide_kept_edges() {
  if (points_.empty() || kept_.empty()) return;
  const auto on_border = [&](std::uint32_t v) {
    return v < on_some_plane_.size() && on_some_plane_[v] != 0;
  };
  // A triangle with a point on an edge becomes two; those are looked at again.
  for (std::size_t i = 0; i < kept_.size(); ++i) {
    if (i % 65536 == 0) context_.check();
    for (std::size_t k = 0; k < 3;) {
      const CutTriangle t = kept_[i];
      const std::size_t j = (k + 1) % 3;
      const std::uint32_t a = t.corners[k], b = t.corners[j];
      if (!on_border(a) || !on_border(b)) {
        ++k;
        continue;
      }
      const auto point = points_.find(edge_key(std::min(a, b), std::max(a, b)));
      if (point == points_.end()) {
        ++k;
        continue;
      }
      const std::uint32_t vertex = point->second.vertex;
      const double share = point->second.share;
      const Vec3 bary = a < b ? glm::mix(t.piece.bary[k], t.piece.bary[j], share)
                              : glm::mix(t.piece.bary[j], t.piece.bary[k], share);
      const auto with = [&](std::size_t corner) {
        CutTriangle half = t;
        half.corners[corner] = vertex;
        half.piece.bary[corner] = bary;
        return half;
      };
      kept_.push_back(with(k));
      kept_[i] = with(j);
    }
  }
}

/// Where solids touch on a plane, an edge may have its two triangles already: then the area that
/// closes the cut stands beside them on vertices of its own.
void Cutter::stand_beside(std::span<const CutTriangle> kept, std::vector<CutTriangle>& caps) {
  std::unordered_map<std::uint64_t, int> taken;
  const auto ends = [](const CutTriangle& t, std::size_t k) {
    return edge_key(t.corners[k], t.corners[(k + 1) % 3]);
  };
  std::vector<std::uint8_t> of_cap(positions.size(), 0);
  for (const CutTriangle& t : caps) {
    for (const std::uint32_t v : t.corners) of_cap[v] = 1;
  }
  for (const CutTriangle& t : kept) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (of_cap[t.corners[k]] && of_cap[t.corners[(k + 1) % 3]]) ++taken[ends(t, k)];
    }
  }
  for (auto first = caps.begin(); first != caps.end();) {
    const auto last = std::find_if(first, caps.end(), [&](const CutTriangle& t) {
      return t.piece.plane != first->piece.plane;
    });
    const bool clashes = std::any_of(first, last, [&](const CutTriangle& t) {
      return taken.contains(ends(t, 0)) || taken.contains(ends(t, 1)) || taken.contains(ends(t, 2));
    });
    std::map<std::uint32_t, std::uint32_t> own;
    for (auto t = first; t != last; ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (!clashes) ++taken[ends(*t, k)];
      }
      if (!clashes) continue;
      for (std::uint32_t& v : t->corners) {
        const auto [it, is_new] = own.try_emplace(v, static_cast<std::uint32_t>(positions.size()));
        if (is_new) positions.push_back(Vec3(positions[v]));
        v = it->second;
      }
    }
    first = last;
  }
}

std::vector<CutTriangle> Cutter::result() {
  std::ranges::stable_sort(kept_, {}, [](const CutTriangle& t) { return t.piece.facet; });
  std::vector<CutTriangle> caps;
  for (const CutTriangle& t : body_) {
    if (t.piece.facet == kNoFacet) caps.push_back(turned_over(t));
  }
  for (CutTriangle t : sheets_) {
    t.piece.facet = kNoFacet;
    t.piece.bary = {};
    caps.push_back(t);
  }
  std::ranges::stable_sort(caps, {}, [](const CutTriangle& t) { return t.piece.plane; });
  stand_beside(kept_, caps);
  std::vector<CutTriangle> all = std::move(kept_);
  all.insert(all.end(), caps.begin(), caps.end());
  return all;
}

}  // namespace burin::detail
