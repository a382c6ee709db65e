#pragma once
/// Atlases of analytic faces with their triangles, as tests and benchmarks of exact forms want
/// them.

#include <burin/contour_cut/contour_cut.h>
#include <burin/forms/charted/atlas_sampler.h>
#include <burin/forms/charted/nurbs.h>
#include <burin/forms/charted/wedge_normals.h>

#include <burin_test/charts.h>

#include <map>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

namespace burin::test {

/// Faces with coedges given by functions.
class FunctionAtlas final : public Atlas {
 public:
  std::size_t face_count() const override { return charts.size(); }
  const Chart& chart(std::int32_t face) const override {
    return *charts[static_cast<std::size_t>(face)];
  }
  bool reversed(std::int32_t face) const override {
    return turned[static_cast<std::size_t>(face)] != 0;
  }
  Vec2 on_coedge(std::int32_t coedge, double t) const override {
    return coedges[static_cast<std::size_t>(coedge)](t);
  }

  std::vector<std::shared_ptr<const Chart>> charts;
  std::vector<std::uint8_t> turned;
  std::vector<std::function<Vec2(double)>> coedges;
};

/// An atlas in the making with its triangles: points at one place are one vertex.
class AtlasBuilder {
 public:
  /// Model edges of the sides v min, u max, v max, u min of a patch, -1 where a side is none.
  /// The edge's parameter is the side's own u or v.
  using Sides = std::array<int, 4>;
  using Borders = std::array<ChartMesh::Border, 3>;

  std::shared_ptr<FunctionAtlas> atlas = std::make_shared<FunctionAtlas>();
  ChartMesh mesh;
  Placement placement;

  explicit AtlasBuilder(Placement at = {}) : placement(at) {}

  int add_face(std::shared_ptr<const Chart> chart, bool turned = false) {
    atlas->charts.push_back(std::move(chart));
    atlas->turned.push_back(turned);
    return static_cast<int>(atlas->charts.size()) - 1;
  }
  int add_edge(ModelEdgeClass kind) {
    mesh.edge_class.push_back(kind);
    return static_cast<int>(mesh.edge_class.size()) - 1;
  }
  std::uint32_t vertex(Vec3 local) {
    const Vec3 q = local * 1e7;
    const auto key = std::tuple(std::llround(q.x), std::llround(q.y), std::llround(q.z));
    const auto [it, fresh] = vertices_.try_emplace(key, mesh.positions.size());
    if (fresh) mesh.positions.push_back(placement.point(local));
    return static_cast<std::uint32_t>(it->second);
  }

  std::uint32_t vertex_of(int face, Vec2 uv) {
    return vertex(atlas->charts[static_cast<std::size_t>(face)]->position(uv));
  }

  /// A triangle of a face by (u,v) counter-clockwise in (u,v); borders of its half-edges.
  void add_triangle(int face, std::array<Vec2, 3> uv, Borders borders) {
    const auto f = static_cast<std::size_t>(face);
    if ((atlas->turned[f] != 0) != placement.mirrors()) {
      std::swap(uv[1], uv[2]);
      std::swap(borders[0], borders[2]);
      for (ChartMesh::Border& b : borders) std::swap(b.t0, b.t1);
    }
    Triangle t;
    for (std::size_t k = 0; k < 3; ++k) t[k] = vertex(atlas->charts[f]->position(uv[k]));
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return;
    mesh.triangles.push_back(t);
    mesh.face.push_back(face);
    for (std::size_t k = 0; k < 3; ++k) {
      mesh.uv.push_back(uv[k]);
      mesh.border.push_back(borders[k].edge < 0 ? -1 : static_cast<int>(mesh.borders.size()));
      if (borders[k].edge >= 0) mesh.borders.push_back(borders[k]);
    }
  }

  void add_grid(int face, ParameterBox box, int nu, int nv, Sides sides) {
    std::array<int, 4> coedge{-1, -1, -1, -1};
    for (std::size_t s = 0; s < 4; ++s) {
      if (sides[s] < 0) continue;
      coedge[s] = static_cast<int>(atlas->coedges.size());
      atlas->coedges.push_back([=](double t) {
        return s % 2 == 0 ? Vec2(t, s == 0 ? box.min.y : box.max.y)
                          : Vec2(s == 3 ? box.min.x : box.max.x, t);
      });
    }
    const auto at = [&](int i, int j) {
      return box.min + box.size() * Vec2(double(i) / nu, double(j) / nv);
    };
    const auto border = [&](bool on, std::size_t s, double t0, double t1) {
      if (!on || sides[s] < 0) return ChartMesh::Border{};
      return ChartMesh::Border{sides[s], coedge[s], t0, t1};
    };
    for (int i = 0; i < nu; ++i) {
      for (int j = 0; j < nv; ++j) {
        const Vec2 a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
        const ChartMesh::Border below = border(j == 0, 0, a.x, b.x),
                                after = border(i == nu - 1, 1, b.y, c.y),
                                above = border(j == nv - 1, 2, c.x, d.x),
                                before = border(i == 0, 3, d.y, a.y);
        const auto same = [&](Vec2 p, Vec2 q) { return vertex_of(face, p) == vertex_of(face, q); };
        // Beside a pole one of the two triangles has both sides.
        add_triangle(face, {a, b, c},
                     Borders{below, after, same(c, d) ? before : ChartMesh::Border{}});
        add_triangle(face, {a, c, d},
                     Borders{same(a, b) ? after : ChartMesh::Border{}, above, before});
      }
    }
  }

  /// Makes the tolerance true and sets the normals.
  PlacedAtlas finish(const RunContext& context) {
    PlacedAtlas placed{atlas, placement, 1};
    Box3 box;
    for (const Vec3& p : mesh.positions) box.add(p);
    placed.size = box.diagonal();
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
      for (int k = 0; k < 4; ++k) {
        Vec3 bary(k == 0 ? 0 : 0.5, k == 1 ? 0 : 0.5, k == 2 ? 0 : 0.5);
        if (k == 3) bary = Vec3(1.0 / 3);
        Vec2 q(0);
        Vec3 p(0);
        for (int c = 0; c < 3; ++c) {
          q += bary[c] * mesh.uv[3 * f + static_cast<std::size_t>(c)];
          p += bary[c] * mesh.positions[mesh.triangles[f][static_cast<std::size_t>(c)]];
        }
        mesh.tolerance =
            std::max(mesh.tolerance, glm::distance(p, placed.position(mesh.face[f], q)));
      }
    }
    set_wedge_normals(mesh, placed, context);
    return placed;
  }

 private:
  std::map<std::tuple<long long, long long, long long>, std::size_t> vertices_;
};

/// A charted mesh at its place.
struct Charted {
  PlacedAtlas atlas;
  ChartMesh mesh;

  explicit Charted(AtlasBuilder builder) {
    atlas = builder.finish(RunContext());
    mesh = std::move(builder.mesh);
  }
};

inline Charted charted_torus(double major, double minor, int nu, int nv, Placement at = {}) {
  AtlasBuilder b(at);
  const int face = b.add_face(torus_chart(major, minor));
  const int u = b.add_edge(ModelEdgeClass::Seam), v = b.add_edge(ModelEdgeClass::Seam);
  b.add_grid(face, {Vec2(0), Vec2(2 * kPi)}, nu, nv, {u, v, u, v});
  return Charted(std::move(b));
}

inline Charted charted_sphere(double radius, int nu, int nv, Placement at = {}) {
  AtlasBuilder b(at);
  const int face = b.add_face(ellipsoid_chart(Vec3(radius)));
  const int seam = b.add_edge(ModelEdgeClass::Seam);
  b.add_grid(face, {{0, -kPi / 2}, {2 * kPi, kPi / 2}}, nu, nv, {-1, seam, -1, seam});
  return Charted(std::move(b));
}

/// A disc at height z with its rim as model edge `edge`, whose parameter is the angle.
inline void add_disc(AtlasBuilder& b, double radius, double z, bool down, int n, int edge) {
  const auto plane = [=](Vec2 p) {
    return SurfaceDerivatives{{p.x, p.y, z}, {1, 0, 0}, {0, 1, 0}, Vec3(0), Vec3(0), Vec3(0)};
  };
  const int face = b.add_face(chart_of(plane, Vec2(-radius), Vec2(radius)), down);
  const auto coedge = static_cast<int>(b.atlas->coedges.size());
  const auto rim = [=](double t) { return radius * Vec2(std::cos(t), std::sin(t)); };
  b.atlas->coedges.push_back(rim);
  for (int i = 0; i < n; ++i) {
    const double s = 2 * kPi * i / n, t = 2 * kPi * (i + 1) / n;
    b.add_triangle(face, {Vec2(0), rim(s), rim(t)}, {{{}, {edge, coedge, s, t}, {}}});
  }
}

/// Cylinder about z from 0 to `height`; `patches` faces round it that meet in smooth edges (1: a
/// seam), sharp rims, caps.
inline Charted charted_cylinder(double radius, double height, int n, int patches = 1,
                                Placement at = {}) {
  AtlasBuilder b(at);
  const int bottom = b.add_edge(ModelEdgeClass::Sharp), top = b.add_edge(ModelEdgeClass::Sharp);
  std::vector<int> joints;
  for (int i = 0; i < patches; ++i) {
    joints.push_back(b.add_edge(patches == 1 ? ModelEdgeClass::Seam : ModelEdgeClass::Smooth));
  }
  for (int i = 0; i < patches; ++i) {
    const int face = b.add_face(cylinder_chart(radius, height));
    const double from = 2 * kPi * i / patches, to = 2 * kPi * (i + 1) / patches;
    b.add_grid(face, {{from, 0}, {to, height}}, n / patches, 1,
               {bottom, joints[static_cast<std::size_t>((i + 1) % patches)], top,
                joints[static_cast<std::size_t>(i)]});
  }
  add_disc(b, radius, 0, true, n, bottom);
  add_disc(b, radius, height, false, n, top);
  return Charted(std::move(b));
}

/// Cone about z with its tip at `height` and its base at 0.
inline Charted charted_cone(double radius, double height, int n, Placement at = {}) {
  AtlasBuilder b(at);
  const auto cone = [=](Vec2 p) {
    const double c = radius * std::cos(p.x), s = radius * std::sin(p.x), w = 1 - p.y;
    return SurfaceDerivatives{{w * c, w * s, height * p.y}, {-w * s, w * c, 0}, {-c, -s, height},
                              {-w * c, -w * s, 0},          {s, -c, 0},         Vec3(0)};
  };
  const int face = b.add_face(chart_of(cone, {0, 0}, {2 * kPi, 1}, {2 * kPi, 0}));
  const int rim = b.add_edge(ModelEdgeClass::Sharp), seam = b.add_edge(ModelEdgeClass::Seam);
  b.add_grid(face, {{0, 0}, {2 * kPi, 1}}, n, 3, {rim, seam, -1, seam});
  add_disc(b, radius, 0, true, n, rim);
  return Charted(std::move(b));
}

/// A prism of height `height` over the rectangle of the given half sizes with rounded corners:
/// four plane walls, four quarter cylinders between them (smooth edges), two plane caps.
inline Charted charted_rounded_box(Vec2 half, double radius, double height, int n,
                                   Placement at = {}) {
  AtlasBuilder b(at);
  const int bottom = b.add_edge(ModelEdgeClass::Sharp), top = b.add_edge(ModelEdgeClass::Sharp);
  std::vector<int> joints;
  for (int i = 0; i < 8; ++i) joints.push_back(b.add_edge(ModelEdgeClass::Smooth));
  std::vector<std::pair<Vec2, double>> outline;  // of the caps: points and edge parameters
  double t = 0;
  std::function<Vec2(double)> along;
  std::vector<std::function<Vec2(double)>> pieces;
  for (int side = 0; side < 4; ++side) {
    const double a = side * kPi / 2;
    const Vec2 out(std::round(std::cos(a)), std::round(std::sin(a))), left(-out.y, out.x);
    const Vec2 inner = half - Vec2(radius);
    const double reach = std::abs(glm::dot(out, half)), width = std::abs(glm::dot(left, inner));
    const auto flat = [=](Vec2 p) {
      const Vec2 q = reach * out + (p.x - t) * left - width * left;
      return SurfaceDerivatives{{q, p.y}, {left, 0}, {0, 0, 1}, Vec3(0), Vec3(0), Vec3(0)};
    };
    const auto j = static_cast<std::size_t>(2 * side);
    int face = b.add_face(chart_of(flat, {t, 0}, {t + 2 * width, height}));
    b.add_grid(face, {{t, 0}, {t + 2 * width, height}}, 2, 1,
               {bottom, joints[j + 1], top, joints[j]});
    pieces.push_back([=](double s) { return Vec2(flat({s, 0}).p); });
    for (int i = 0; i < 2; ++i) outline.emplace_back(flat({t + i * width, 0}).p, t + i * width);
    t += 2 * width;
    const Vec2 middle = (reach - radius) * out + width * left;
    const auto round = [=](Vec2 p) {
      const double w = a + (p.x - t) / radius;
      const Vec2 e(std::cos(w), std::sin(w)), m(-e.y, e.x);
      return SurfaceDerivatives{{middle + radius * e, p.y}, {m, 0},  {0, 0, 1},
                                {-e / radius, 0},           Vec3(0), Vec3(0)};
    };
    const double length = radius * kPi / 2;
    face = b.add_face(chart_of(round, {t, 0}, {t + length, height}));
    b.add_grid(face, {{t, 0}, {t + length, height}}, n, 1,
               {bottom, joints[(j + 2) % 8], top, joints[j + 1]});
    pieces.push_back([=](double s) { return Vec2(round({s, 0}).p); });
    for (int i = 0; i < n; ++i) {
      outline.emplace_back(round({t + i * length / n, 0}).p, t + i * length / n);
    }
    t += length;
  }
  const double total = t;
  std::vector<double> ends;
  for (std::size_t i = 0; i < outline.size(); ++i) ends.push_back(outline[i].second);
  std::vector<double> starts;
  t = 0;
  for (int side = 0; side < 4; ++side) {
    const double width = side % 2 == 0 ? half.y - radius : half.x - radius;
    starts.push_back(t);
    t += 2 * width;
    starts.push_back(t);
    t += radius * kPi / 2;
  }
  const auto rim = [=](double s) {
    std::size_t i = 7;
    while (i > 0 && s < starts[i]) --i;
    return pieces[i](s);
  };
  for (const bool down : {true, false}) {
    const double z = down ? 0 : height;
    const auto plane = [=](Vec2 p) {
      return SurfaceDerivatives{{p.x, p.y, z}, {1, 0, 0}, {0, 1, 0}, Vec3(0), Vec3(0), Vec3(0)};
    };
    const int face = b.add_face(chart_of(plane, -half, half), down);
    const auto coedge = static_cast<int>(b.atlas->coedges.size());
    b.atlas->coedges.push_back(rim);
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const std::size_t k = (i + 1) % outline.size();
      const double to = k == 0 ? total : outline[k].second;
      b.add_triangle(face, {Vec2(0), outline[i].first, outline[k].first},
                     {{{}, {down ? bottom : top, coedge, outline[i].second, to}, {}}});
    }
  }
  return Charted(std::move(b));
}

/// The graph z = height(x, y) over a square of half size `half`, bounded, n x n cells.
inline Charted charted_graph(double half, int n, std::function<Vec3(Vec2)> graph,
                             Placement at = {}) {
  AtlasBuilder b(at);
  const int face = b.add_face(make_function_chart(std::move(graph), {{Vec2(-half), Vec2(half)}}));
  AtlasBuilder::Sides sides{};
  for (int& side : sides) side = b.add_edge(ModelEdgeClass::Boundary);
  b.add_grid(face, {Vec2(-half), Vec2(half)}, n, n, sides);
  return Charted(std::move(b));
}

}  // namespace burin::test
