#pragma once
/// Analytic charts, and charted surfaces of one face over a plain grid.

#include <burin/forms/charted/charted_surface.h>
#include <burin/forms/charted/nurbs.h>

#include <burin_test/shapes.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace burin::test {

inline std::shared_ptr<const Chart> chart_of(std::function<SurfaceDerivatives(Vec2)> f, Vec2 min,
                                             Vec2 max, Vec2 period = Vec2(0)) {
  return make_function_chart(std::move(f), {{min, max}, period});
}

/// Torus about z: u round the axis, v round the tube, both periodic.
inline std::shared_ptr<const Chart> torus_chart(double major, double minor) {
  const auto f = [=](Vec2 p) {
    const double cu = std::cos(p.x), su = std::sin(p.x), cv = std::cos(p.y), sv = std::sin(p.y);
    const double r = major + minor * cv;
    SurfaceDerivatives d;
    d.p = {r * cu, r * su, minor * sv};
    d.u = {-r * su, r * cu, 0};
    d.v = {-minor * sv * cu, -minor * sv * su, minor * cv};
    d.uu = {-r * cu, -r * su, 0};
    d.uv = {minor * sv * su, -minor * sv * cu, 0};
    d.vv = {-minor * cv * cu, -minor * cv * su, -minor * sv};
    return d;
  };
  return chart_of(f, Vec2(0), Vec2(2 * kPi), Vec2(2 * kPi));
}

/// Ellipsoid: u longitude (periodic), v latitude from pole to pole.
inline std::shared_ptr<const Chart> ellipsoid_chart(Vec3 half) {
  const auto f = [=](Vec2 p) {
    const double cu = std::cos(p.x), su = std::sin(p.x), cv = std::cos(p.y), sv = std::sin(p.y);
    SurfaceDerivatives d;
    d.p = half * Vec3(cv * cu, cv * su, sv);
    d.u = half * Vec3(-cv * su, cv * cu, 0);
    d.v = half * Vec3(-sv * cu, -sv * su, cv);
    d.uu = half * Vec3(-cv * cu, -cv * su, 0);
    d.uv = half * Vec3(sv * su, -sv * cu, 0);
    d.vv = half * Vec3(-cv * cu, -cv * su, -sv);
    return d;
  };
  return chart_of(f, {0, -kPi / 2}, {2 * kPi, kPi / 2}, {2 * kPi, 0});
}

/// Cylinder about z: u the angle (periodic where it goes all the way round), v the height.
inline std::shared_ptr<const Chart> cylinder_chart(double radius, double height,
                                                   double angle = 2 * kPi) {
  const auto f = [=](Vec2 p) {
    const double c = radius * std::cos(p.x), s = radius * std::sin(p.x);
    return SurfaceDerivatives{{c, s, p.y}, {-s, c, 0}, {0, 0, 1}, {-c, -s, 0}, Vec3(0), Vec3(0)};
  };
  return chart_of(f, {0, 0}, {angle, height}, {angle < 2 * kPi ? 0 : 2 * kPi, 0});
}

/// The plane z = 0 over a rectangle.
inline std::shared_ptr<const Chart> plane_chart(Vec2 min, Vec2 max) {
  const auto f = [](Vec2 p) {
    return SurfaceDerivatives{{p.x, p.y, 0}, {1, 0, 0}, {0, 1, 0}, Vec3(0), Vec3(0), Vec3(0)};
  };
  return chart_of(f, min, max);
}

/// The faces of a cube blown up to an ellipsoid: six patches without poles, every other one
/// oriented inwards.
inline std::vector<std::shared_ptr<const Chart>> six_patches(Vec3 half) {
  std::vector<std::shared_ptr<const Chart>> patches;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      const auto f = [=](Vec2 p) {
        Vec3 q(0), x(0), y(0);
        x[(axis + 1) % 3] = y[(axis + 2) % 3] = 1;
        q[axis] = sign;
        q += p.x * x + p.y * y;
        const double n = 1 / glm::length(q), n3 = n * n * n, n5 = n3 * n * n;
        // Derivatives of q / |q|.
        const auto second = [&](Vec3 a, Vec3 b) {
          const double qa = glm::dot(q, a), qb = glm::dot(q, b);
          return half * (-n3 * (qb * a + qa * b + glm::dot(a, b) * q) + 3 * n5 * qa * qb * q);
        };
        SurfaceDerivatives d;
        d.p = half * q * n;
        d.u = half * (x * n - q * (glm::dot(q, x) * n3));
        d.v = half * (y * n - q * (glm::dot(q, y) * n3));
        d.uu = second(x, x);
        d.uv = second(x, y);
        d.vv = second(y, y);
        return d;
      };
      patches.push_back(chart_of(f, Vec2(-1), Vec2(1)));
    }
  }
  return patches;
}

/// The faces of a box from the origin, bilinear, every other one oriented inwards.
inline std::vector<std::shared_ptr<const Chart>> box_patches(Vec3 size) {
  std::vector<std::shared_ptr<const Chart>> patches;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double at : {0.0, 1.0}) {
      std::vector<Vec3> points;
      for (const Vec2 q : {Vec2(0, 0), Vec2(0, 1), Vec2(1, 0), Vec2(1, 1)}) {
        Vec3 p;
        p[axis] = at;
        p[(axis + 1) % 3] = q.x;
        p[(axis + 2) % 3] = q.y;
        points.push_back(size * p);
      }
      patches.push_back(make_nurbs_chart(bezier_patch(1, 1, points)));
    }
  }
  return patches;
}

/// Charts with straight coedges: coedge 4 * face + side, t in [0,1] along the side; sides 0: v min,
/// 1: u max, 2: v max, 3: u min; t runs with the parameter.
class PlainAtlas final : public Atlas {
 public:
  explicit PlainAtlas(std::vector<std::shared_ptr<const Chart>> charts)
      : charts_(std::move(charts)) {}
  std::size_t face_count() const override { return charts_.size(); }
  const Chart& chart(std::int32_t face) const override {
    return *charts_[static_cast<std::size_t>(face)];
  }
  bool reversed(std::int32_t) const override { return false; }
  Vec2 on_coedge(std::int32_t coedge, double t) const override {
    const ParameterBox box = charts_[static_cast<std::size_t>(coedge / 4)]->domain();
    const Vec2 p = box.min + t * box.size();
    switch (coedge % 4) {
      case 0:
        return {p.x, box.min.y};
      case 1:
        return {box.max.x, p.y};
      case 2:
        return {p.x, box.max.y};
      default:
        return {box.min.x, p.y};
    }
  }

 private:
  std::vector<std::shared_ptr<const Chart>> charts_;
};

/// A surface of one chart over a grid of nu x nv cells. Points of the grid at one place in space
/// are one vertex, so that seams close and collapsed sides become poles.
inline std::shared_ptr<const Surface> grid_surface(const std::shared_ptr<const Chart>& chart,
                                                   int nu, int nv,
                                                   const Placement& placement = {}) {
  const ParameterBox box = chart->domain();
  PlacedAtlas atlas{std::make_shared<PlainAtlas>(std::vector{chart}), placement, 1};
  ChartMesh m;
  std::vector<std::uint32_t> vertex(static_cast<std::size_t>((nu + 1) * (nv + 1)));
  const auto uv = [&](int i, int j) {
    return box.min + box.size() * Vec2(static_cast<double>(i) / nu, static_cast<double>(j) / nv);
  };
  Box3 bounds;
  for (int i = 0; i <= nu; ++i) {
    for (int j = 0; j <= nv; ++j) {
      const Vec3 p = atlas.position(0, uv(i, j));
      bounds.add(p);
      const bool border = i == 0 || j == 0 || i == nu || j == nv;
      auto found = static_cast<std::uint32_t>(m.positions.size());
      for (std::uint32_t k = 0; border && k < m.positions.size(); ++k) {
        if (glm::distance(p, m.positions[k]) < 1e-9 * bounds.diagonal()) found = k;
      }
      if (found == m.positions.size()) m.positions.push_back(p);
      vertex[static_cast<std::size_t>(i * (nv + 1) + j)] = found;
    }
  }
  atlas.size = bounds.diagonal();
  using Node = std::array<int, 2>;
  const bool reversed = atlas.reversed(0);
  const auto add = [&](Node a, Node b, Node c) {
    std::array<Node, 3> nodes{a, b, c};
    if (reversed) std::swap(nodes[1], nodes[2]);
    Triangle t;
    for (std::size_t k = 0; k < 3; ++k) {
      t[k] = vertex[static_cast<std::size_t>(nodes[k][0] * (nv + 1) + nodes[k][1])];
    }
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return;
    m.triangles.push_back(t);
    m.face.push_back(0);
    for (std::size_t k = 0; k < 3; ++k) {
      Node p = nodes[k], q = nodes[(k + 1) % 3];
      const Vec2 at = uv(p[0], p[1]);
      m.uv.push_back(at);
      m.normal.push_back(atlas.normal(0, at, atlas.derivatives(0, at)));
      m.on_contour.push_back(0);
      // A pole lies on every line of the direction that collapses there.
      const auto pole = [&](Node n) {
        return vertex[static_cast<std::size_t>(n[1])] ==
                   vertex[static_cast<std::size_t>(nu / 2 * (nv + 1) + n[1])] &&
               (n[1] == 0 || n[1] == nv);
      };
      if (pole(p)) p[0] = q[0];
      if (pole(q)) q[0] = p[0];
      int side = -1;
      for (int s = 0; s < 4; ++s) {
        const int axis = s % 2 == 0 ? 1 : 0, end = s == 1 ? nu : s == 2 ? nv : 0;
        if (p[static_cast<std::size_t>(axis)] == end && q[static_cast<std::size_t>(axis)] == end) {
          side = s;
        }
      }
      if (side < 0) {
        m.border.push_back(-1);
        continue;
      }
      m.border.push_back(static_cast<std::int32_t>(m.borders.size()));
      const std::size_t along = side % 2 == 0 ? 0 : 1;
      const double n = along == 0 ? nu : nv;
      m.borders.push_back({side, side, p[along] / n, q[along] / n});
    }
  };
  for (int i = 0; i < nu; ++i) {
    for (int j = 0; j < nv; ++j) {
      add({i, j}, {i + 1, j}, {i + 1, j + 1});
      add({i, j}, {i + 1, j + 1}, {i, j + 1});
    }
  }
  // Sides that share their vertices are seams.
  const auto at = [&](int i, int j) { return vertex[static_cast<std::size_t>(i * (nv + 1) + j)]; };
  const bool seam_u = at(0, nv / 2) == at(nu, nv / 2), seam_v = at(nu / 2, 0) == at(nu / 2, nv);
  const auto kind = [](bool seam) {
    return seam ? ModelEdgeClass::Seam : ModelEdgeClass::Boundary;
  };
  m.edge_class = {kind(seam_v), kind(seam_u), kind(seam_v), kind(seam_u)};
  for (std::size_t f = 0; f < m.triangles.size(); ++f) {
    for (int k = 0; k < 4; ++k) {
      const Vec3 bary =
          k == 3 ? Vec3(1.0 / 3) : Vec3(k == 0 ? 0 : 0.5, k == 1 ? 0 : 0.5, k == 2 ? 0 : 0.5);
      Vec2 q(0);
      Vec3 p(0);
      for (int c = 0; c < 3; ++c) {
        q += bary[c] * m.uv[3 * f + static_cast<std::size_t>(c)];
        p += bary[c] * m.positions[m.triangles[f][static_cast<std::size_t>(c)]];
      }
      m.tolerance = std::max(m.tolerance, 1.1 * glm::distance(p, atlas.position(0, q)));
    }
  }
  return make_charted_surface(atlas, std::move(m), RunContext());
}

}  // namespace burin::test
