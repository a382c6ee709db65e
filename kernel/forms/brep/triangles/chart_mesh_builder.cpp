#include "chart_mesh_builder.h"

#include <burin/base/disjoint_sets.h>

#include "occt_vec.h"
#include "wide_triangles.h"

#include <BRep_Tool.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>

#include <algorithm>

namespace burin {
namespace {

/// One piece of a coedge between two nodes of its face.
struct Segment {
  std::uint32_t low, high;  // nodes
  std::int32_t coedge;
  double t_low, t_high;
};

bool comes_before(const Segment& s, const Segment& t) {
  return s.low != t.low ? s.low < t.low : s.high < t.high;
}

class Builder {
 public:
  explicit Builder(const ModelParts& parts)
      : parts_(parts), edge_start_(parts.edges.size(), kNone) {
    positions_ = parts.vertices;
  }

  RawMesh build(std::vector<std::int32_t>& unmeshed) {
    for (std::size_t f = 0; f < parts_.faces.size(); ++f) {
      if (!parts_.faces[f].chart || !add_face(f)) unmeshed.push_back(static_cast<std::int32_t>(f));
    }
    finish();
    return {std::move(mesh_), std::move(pole_)};
  }

 private:
  bool add_face(std::size_t f) {
    const ModelFace& face = parts_.faces[f];
    TopLoc_Location location;
    const Handle(Poly_Triangulation) t = BRep_Tool::Triangulation(face.face, location);
    if (t.IsNull() || t->NbTriangles() == 0 || !t->HasUVNodes()) return false;
    global_.assign(static_cast<std::size_t>(t->NbNodes()) + 1, kNone);
    node_pole_.assign(global_.size(), 0);
    segments_.clear();
    for (auto c = index(face.first_coedge);
         c < parts_.coedges.size() && parts_.coedges[c].face == static_cast<std::int32_t>(f); ++c) {
      add_coedge(static_cast<std::int32_t>(c), t, location);
    }
    std::ranges::sort(segments_, comes_before);
    const gp_Trsf& move = location.Transformation();
    for (int i = 1; i <= t->NbNodes(); ++i) {
      std::uint32_t& g = global_[static_cast<std::size_t>(i)];
      if (g == kNone) g = add_vertex(to_vec(t->Node(i).Transformed(move)));
    }
    add_triangles(f, *t);
    return true;
  }

  /// The way in u and in v from one side of a seam of the face to the other; 0 without one.
  Vec2 way_round(std::size_t f) const {
    Vec2 way(0);
    const auto first = index(parts_.faces[f].first_coedge);
    for (std::size_t c = first; c < parts_.coedges.size(); ++c) {
      const ModelCoedge& a = parts_.coedges[c];
      if (a.face != static_cast<std::int32_t>(f)) break;
      const ModelEdge& e = parts_.edges[index(a.edge)];
      for (const std::int32_t other : e.coedges) {
        const ModelCoedge& b = parts_.coedges[index(other)];
        if (index(other) <= c || b.face != a.face || !a.curve.known() || !b.curve.known()) continue;
        const double t = 0.5 * (e.first + e.last);
        way = glm::max(way, glm::abs(a.curve.at(t) - b.curve.at(t)));
      }
    }
    // Rounding of the other direction is no way.
    for (int i = 0; i < 2; ++i) {
      if (way[i] < 1e-6 * way[1 - i]) way[i] = 0;
    }
    return way;
  }

  void add_triangles(std::size_t f, const Poly_Triangulation& t) {
    node_uv_.assign(1, Vec2(0));
    for (int i = 1; i <= t.NbNodes(); ++i) node_uv_.push_back(to_vec(t.UVNode(i)));
    std::vector<Triangle> triangles;
    for (int i = 1; i <= t.NbTriangles(); ++i) {
      std::array<int, 3> n{};
      t.Triangle(i).Get(n[0], n[1], n[2]);
      triangles.push_back({static_cast<std::uint32_t>(n[0]), static_cast<std::uint32_t>(n[1]),
                           static_cast<std::uint32_t>(n[2])});
    }
    split_wide_triangles(node_uv_, node_pole_, triangles, way_round(f));
    for (std::size_t i = global_.size(); i < node_uv_.size(); ++i) {
      global_.push_back(add_vertex(parts_.faces[f].chart->position(node_uv_[i])));
    }
    for (const Triangle& n : triangles) add_triangle(f, n);
  }

  /// The vertices of the model edge, made when its first face with triangles comes; of this coedge
  /// alone where another number of nodes was used for it.
  std::uint32_t edge_vertices(std::int32_t edge, const std::vector<Vec3>& inner) {
    std::uint32_t& start = edge_start_[index(edge)];
    if (start != kNone && inner_count(edge) == inner.size()) return start;
    const auto made = static_cast<std::uint32_t>(positions_.size());
    positions_.insert(positions_.end(), inner.begin(), inner.end());
    if (start == kNone) {
      start = made;
      inner_.resize(parts_.edges.size(), 0);
      inner_[index(edge)] = inner.size();
    }
    return made;
  }
  std::size_t inner_count(std::int32_t edge) const { return inner_[index(edge)]; }

  void add_coedge(std::int32_t coedge, const Handle(Poly_Triangulation) & t,
                  const TopLoc_Location& location) {
    const ModelCoedge& c = parts_.coedges[index(coedge)];
    const ModelEdge& e = parts_.edges[index(c.edge)];
    const Handle(Poly_PolygonOnTriangulation) polygon = polygon_of(c, t, location);
    if (polygon.IsNull()) return;
    const int n = polygon->NbNodes();
    const auto node = [&](int k) { return static_cast<std::uint32_t>(polygon->Node(k + 1)); };
    std::vector<Vec3> inner;
    for (int k = 1; k + 1 < n && !e.degenerate; ++k) {
      inner.push_back(to_vec(t->Node(polygon->Node(k + 1)).Transformed(location.Transformation())));
    }
    const std::uint32_t start = edge_vertices(c.edge, inner);
    for (int k = 0; k < n; ++k) {
      const bool end = k == 0 || k + 1 == n;
      std::int32_t vertex = e.vertex[k == 0 ? 0 : 1];
      if (e.degenerate) vertex = e.vertex[0];
      if (e.degenerate) node_pole_[node(k)] = direction_of(c, e);
      if (vertex >= 0 && (end || e.degenerate)) {
        assign(node(k), static_cast<std::uint32_t>(vertex));
      } else if (!end && !e.degenerate) {
        assign(node(k), start + static_cast<std::uint32_t>(k) - 1);
      }
    }
    if (!e.degenerate) add_segments(coedge, e, *polygon);
  }

  /// Whether the nodes of a polygon are nodes of the triangles: the mesher may leave that of a try
  /// before, with other nodes, on an edge of a face that it failed at.
  static bool belongs(const Handle(Poly_PolygonOnTriangulation) & p, const Poly_Triangulation& t) {
    if (p.IsNull()) return false;
    for (int k = 1; k <= p->NbNodes(); ++k) {
      if (p->Node(k) < 1 || p->Node(k) > t.NbNodes()) return false;
    }
    return true;
  }

  /// Of the two polygons of a seam the mesher keeps now the one, now the other first: the nearer
  /// to the coedge's own curve is taken.
  Handle(Poly_PolygonOnTriangulation)
      polygon_of(const ModelCoedge& c, const Handle(Poly_Triangulation) & t,
                 const TopLoc_Location& location) const {
    Handle(Poly_PolygonOnTriangulation) own = BRep_Tool::PolygonOnTriangulation(c.use, t, location);
    if (!belongs(own, *t)) return nullptr;
    if (!c.curve.known()) return own;
    const Handle(Poly_PolygonOnTriangulation) other =
        BRep_Tool::PolygonOnTriangulation(TopoDS::Edge(c.use.Reversed()), t, location);
    if (other == own || !belongs(other, *t)) return own;
    const ModelEdge& e = parts_.edges[index(c.edge)];
    const auto off = [&](const Handle(Poly_PolygonOnTriangulation) & p) {
      return glm::length(to_vec(t->UVNode(p->Node(1))) - c.curve.at(e.first)) +
             glm::length(to_vec(t->UVNode(p->Node(p->NbNodes()))) - c.curve.at(e.last));
    };
    return off(other) < off(own) ? other : own;
  }

  void add_segments(std::int32_t coedge, const ModelEdge& e, const Poly_PolygonOnTriangulation& p) {
    const int n = p.NbNodes();
    const Handle(TColStd_HArray1OfReal)& known = p.Parameters();
    const auto t = [&](int k) {
      if (!known.IsNull()) return known->Value(known->Lower() + k);
      return e.first + (e.last - e.first) * k / (n - 1);
    };
    for (int k = 0; k + 1 < n; ++k) {
      Segment s{static_cast<std::uint32_t>(p.Node(k + 1)),
                static_cast<std::uint32_t>(p.Node(k + 2)), coedge, t(k), t(k + 1)};
      if (s.low == s.high) continue;
      if (s.low > s.high) {
        std::swap(s.low, s.high);
        std::swap(s.t_low, s.t_high);
      }
      segments_.push_back(s);
    }
  }

  /// The parameter that runs along a point-like edge: 1 = u, 2 = v.
  static std::uint8_t direction_of(const ModelCoedge& c, const ModelEdge& e) {
    if (!c.curve.known()) return 0;
    const Vec2 d = glm::abs(c.curve.at(e.last) - c.curve.at(e.first));
    return d.x >= d.y ? 1 : 2;
  }

  /// A node that stands for two places (ends of an edge shorter than the mesher sees) joins them.
  void assign(std::uint32_t node, std::uint32_t vertex) {
    if (global_[node] != kNone && global_[node] != vertex)
      joined_.emplace_back(global_[node], vertex);
    global_[node] = vertex;
  }

  std::uint32_t add_vertex(Vec3 p) {
    positions_.push_back(p);
    return static_cast<std::uint32_t>(positions_.size() - 1);
  }

  void add_triangle(std::size_t f, Triangle n) {
    if (parts_.faces[f].reversed) std::swap(n[1], n[2]);
    mesh_.triangles.push_back({global_[n[0]], global_[n[1]], global_[n[2]]});
    mesh_.face.push_back(static_cast<std::int32_t>(f));
    for (std::size_t k = 0; k < 3; ++k) {
      mesh_.uv.push_back(node_uv_[n[k]]);
      pole_.push_back(node_pole_[n[k]]);
      mesh_.border.push_back(add_border(n[k], n[(k + 1) % 3]));
    }
  }

  std::int32_t add_border(std::uint32_t a, std::uint32_t b) {
    const Segment key{std::min(a, b), std::max(a, b), -1, 0, 0};
    const auto s = std::ranges::lower_bound(segments_, key, comes_before);
    if (s == segments_.end() || s->low != key.low || s->high != key.high) return -1;
    const bool up = a < b;
    mesh_.borders.push_back({parts_.coedges[index(s->coedge)].edge,
                             parts_.coedges[index(s->coedge)].curve.known() ? s->coedge : -1,
                             up ? s->t_low : s->t_high, up ? s->t_high : s->t_low});
    return static_cast<std::int32_t>(mesh_.borders.size() - 1);
  }

  /// Joins, drops triangles without extent and vertices without a triangle.
  void finish() {
    DisjointSets sets(positions_.size());
    for (const auto& [a, b] : joined_) sets.join(a, b);
    ChartMesh out;
    std::vector<std::uint8_t> pole;
    std::vector<std::uint32_t> number(positions_.size(), kNone);
    for (std::size_t f = 0; f < mesh_.triangles.size(); ++f) {
      Triangle t = mesh_.triangles[f];
      for (std::uint32_t& v : t) v = static_cast<std::uint32_t>(sets.find(v));
      if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
      for (std::uint32_t& v : t) {
        if (number[v] == kNone) {
          number[v] = static_cast<std::uint32_t>(out.positions.size());
          out.positions.push_back(positions_[v]);
        }
        v = number[v];
      }
      out.triangles.push_back(t);
      out.face.push_back(mesh_.face[f]);
      out.uv.insert(out.uv.end(), &mesh_.uv[3 * f], &mesh_.uv[3 * f] + 3);
      out.border.insert(out.border.end(), &mesh_.border[3 * f], &mesh_.border[3 * f] + 3);
      pole.insert(pole.end(), &pole_[3 * f], &pole_[3 * f] + 3);
      centre_poles(&out.uv[out.uv.size() - 3], &pole[pole.size() - 3]);
    }
    out.borders = std::move(mesh_.borders);
    out.edge_class = parts_.edge_class;
    mesh_ = std::move(out);
    pole_ = std::move(pole);
  }

  /// The mesher has some node of a pole there, not the one that lies beside the triangle.
  static void centre_poles(Vec2* uv, const std::uint8_t* pole) {
    for (int k = 0; k < 3; ++k) {
      const int a = (k + 1) % 3, b = (k + 2) % 3, i = pole[k] - 1;
      if (i >= 0) uv[k][i] = pole[a] ? uv[b][i] : pole[b] ? uv[a][i] : 0.5 * (uv[a][i] + uv[b][i]);
    }
  }

  const ModelParts& parts_;
  ChartMesh mesh_;
  std::vector<std::uint8_t> pole_;
  std::vector<Vec3> positions_;
  std::vector<std::uint32_t> edge_start_;  // first inner vertex of each model edge
  std::vector<std::size_t> inner_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> joined_;
  // Of the present face: the vertex of each node (from 1), and the pieces of its coedges.
  std::vector<std::uint32_t> global_;
  std::vector<Vec2> node_uv_;
  std::vector<std::uint8_t> node_pole_;
  std::vector<Segment> segments_;
};

}  // namespace

RawMesh build_chart_mesh(const ModelParts& parts, std::vector<std::int32_t>& unmeshed) {
  return Builder(parts).build(unmeshed);
}

}  // namespace burin
