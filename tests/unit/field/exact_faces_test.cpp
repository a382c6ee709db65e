// Directions on forms that know the kinds of their faces.

#include <burin_test/fields.h>
#include <burin_test/sourced.h>
#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <set>

namespace burin {
namespace {

using test::kPi;
using test::line_angle;
using test::Probe;

/// What SmoothedField asks of a surface: a proxy with sources and exact frames.
class Framed final : public Surface {
 public:
  using Frames = std::function<Frame(std::int32_t face, Vec3 position)>;
  Framed(ProxyMesh proxy, Frames frames) : proxy_(std::move(proxy)), frames_(std::move(frames)) {}

  MarchStep march(const SurfacePoint&, Vec3, double) const override { return {}; }
  Frame frame(const SurfacePoint& p) const override {
    return frames_(proxy_.source_face[p.triangle], p.position);
  }
  bool exact() const override { return true; }
  const ProxyMesh& proxy() const override { return proxy_; }
  ProxyPoint to_proxy(const SurfacePoint& p) const override { return {p.triangle, p.coords}; }
  SurfacePoint lift(const ProxyPoint& p) const override {
    return {0, p.bary, proxy_.position(p.face, p.bary), p.face};
  }

 private:
  ProxyMesh proxy_;
  Frames frames_;
};

struct Exact {
  Framed surface;
  field::SmoothedField field;

  Exact(ProxyMesh proxy, Framed::Frames frames, const field::SmoothedOptions& options = {})
      : surface(std::move(proxy), std::move(frames)), field({&surface}, options, RunContext()) {}
  Vec3 at(const Probe& p, int family = 1) const {
    const auto d = test::direction(field, p.query(family));
    EXPECT_TRUE(d);
    return d.value_or(Vec3(0));
  }
};

Frame plane(Vec3 p, Vec3 n) {
  Frame f;
  f.position = p;
  f.normal = n;
  f.kind = FaceKind::Plane;
  return f;
}

/// A frame of a cylinder about z of the given radius.
Frame cylinder(Vec3 p, Vec3 axis_point, double radius) {
  Frame f;
  f.position = p;
  f.normal = glm::normalize(Vec3(p.x - axis_point.x, p.y - axis_point.y, 0));
  f.kind = FaceKind::Cylinder;
  f.k1 = 1 / radius;
  f.d2 = {0, 0, 1};
  f.d1 = glm::cross(f.d2, f.normal);
  f.umbilic = false;
  f.confidence = 1;
  return f;
}

/// A bar along z of height 4 whose section is a rectangle with corners rounded by `radius`: faces
/// 0..3 are the planes at +x +y -x -y, 4..7 the fillets after each, 8 and 9 the ends.
struct Bar {
  Vec2 half;
  double radius;

  Vec2 center(std::int32_t fillet) const {
    const double x = half.x - radius, y = half.y - radius;
    return fillet == 4   ? Vec2(x, y)
           : fillet == 5 ? Vec2(-x, y)
           : fillet == 6 ? Vec2(-x, -y)
                         : Vec2(x, -y);
  }
  std::int32_t face_at(Vec3 n) const {
    if (std::abs(n.z) > 0.5) return n.z < 0 ? 8 : 9;
    for (int k = 0; k < 4; ++k) {
      const double a = k * kPi / 2;
      if (std::cos(a) * n.x + std::sin(a) * n.y > 1 - 1e-9) return k;
    }
    return n.y > 0 ? (n.x > 0 ? 4 : 5) : (n.x < 0 ? 6 : 7);
  }
  ProxyMesh proxy() const {
    constexpr int kArc = 6;
    std::vector<Vec2> section;
    for (int k = 0; k < 4; ++k) {
      for (int i = 0; i <= kArc; ++i) {
        const double a = (k + static_cast<double>(i) / kArc) * kPi / 2;
        section.push_back(center(4 + k) + radius * Vec2(std::cos(a), std::sin(a)));
      }
    }
    // As a mesher of CAD parts makes it: vertices on the ends alone.
    TriMesh m;
    const auto n = static_cast<std::uint32_t>(section.size());
    for (const Vec2 p : section) {
      m.positions.push_back({p.x, p.y, 0});
      m.positions.push_back({p.x, p.y, 4});
    }
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = 2 * i, b = 2 * ((i + 1) % n);
      m.triangles.push_back({a, b, b + 1});
      m.triangles.push_back({a, b + 1, a + 1});
      if (i > 0 && i + 1 < n) {
        m.triangles.push_back({0, b, a});
        m.triangles.push_back({1, a + 1, b + 1});
      }
    }
    ProxyMesh p = build_proxy(m, {}, RunContext());
    return test::sourced(std::move(p),
                         {.face = [&](std::uint32_t f) { return face_at(m.normal(f)); },
                          .edge = [](Vec3, Vec3) { return -1; }});
  }
  Framed::Frames frames() const {
    return [bar = *this](std::int32_t face, Vec3 p) {
      if (face >= 8) return plane(p, {0, 0, face == 8 ? -1.0 : 1.0});
      if (face >= 4) return cylinder(p, Vec3(bar.center(face), 0), bar.radius);
      const double a = face * kPi / 2;
      return plane(p, {std::round(std::cos(a)), std::round(std::sin(a)), 0});
    };
  }
};

TEST(ExactFaces, StrokesFollowTheExactLinesOnCoarseTriangles) {
  const Bar bar{{2, 1}, 0.9};
  const Exact s(bar.proxy(), bar.frames());
  for (const Probe& p : test::probes(s.surface)) {
    const Vec3 n = p.frame.normal;
    if (std::abs(n.z) > 0.5) continue;
    // Round the bar, over planes and fillets alike.
    EXPECT_LT(line_angle(s.at(p), glm::cross(Vec3(0, 0, 1), n)), 1e-6);
    EXPECT_LT(line_angle(s.at(p, 2), {0, 0, 1}), 1e-6);
  }
}

TEST(ExactFaces, RulingsWhereTheStyleAsksForThem) {
  const Bar bar{{2, 1}, 0.9};
  const Exact s(bar.proxy(), bar.frames(),
                {.policy = {.cylinder = field::FacePolicy::Ruled::Rulings}});
  for (const Probe& p : test::probes(s.surface)) {
    if (std::abs(p.frame.normal.z) < 0.5) {
      EXPECT_LT(line_angle(s.at(p), {0, 0, 1}), 1e-6);
    }
  }
}

// A wall whose triangles have vertices on its borders alone, between narrow fillets that bend the
// other way: what most of the surface has names the families, not what the borders have.
TEST(ExactFaces, WallsNameTheirFamiliesBetweenFillets) {
  const Bar bar{{2, 1}, 0.1};
  const auto frames = [exact = bar.frames()](std::int32_t face, Vec3 p) {
    Frame f = exact(face, p);
    if (face >= 8) return f;
    f.kind = FaceKind::Freeform;
    if (face >= 4) return f;
    // The walls bend along the bar.
    f.k1 = 0.1;
    f.d2 = glm::cross(f.normal, Vec3(0, 0, 1));
    f.normal = glm::normalize(f.normal + f.k1 * (p.z - 2) * Vec3(0, 0, 1));
    f.d1 = glm::cross(f.d2, f.normal);
    f.umbilic = false;
    f.confidence = 0.9;
    return f;
  };
  const Exact s(bar.proxy(), frames);
  std::size_t along = 0, all = 0;
  for (const Probe& p : test::probes(s.surface)) {
    if (std::abs(p.frame.normal.z) > 0.5) continue;
    ++all;
    along += line_angle(s.at(p), {0, 0, 1}) < 30 ? 1 : 0;
  }
  EXPECT_EQ(along, all);
}

TEST(ExactFaces, PlanesAreFlatPatchesWhateverTheirSize) {
  const Bar bar{{2, 0.91}, 0.9};  // the planes at x are 0.02 wide
  const Exact s(bar.proxy(), bar.frames());
  const auto& patch = s.field.flat_patches(0);
  for (std::size_t f = 0; f < patch.size(); ++f) {
    const std::int32_t face = s.surface.proxy().source_face[f];
    EXPECT_EQ(patch[f] >= 0, face < 4 || face >= 8) << face;
  }
}

TEST(ExactFaces, NeighbouringPlanesDiffer) {
  const TriMesh m = test::box({0, 0, 0}, {3, 2, 1});
  const auto face_at = [](Vec3 n) {
    return static_cast<std::int32_t>(std::lround(2.5 + 0.5 * n.x + 1.5 * n.y + 2.5 * n.z));
  };
  const auto normals = [m, face_at](std::int32_t face, Vec3 p) {
    for (std::uint32_t f = 0; f < m.triangles.size(); ++f) {
      if (face_at(m.normal(f)) == face) return plane(p, m.normal(f));
    }
    return Frame();
  };
  const ProxyMesh proxy =
      test::sourced(build_proxy(m, {}, RunContext()),
                    {.face = [&](std::uint32_t f) { return face_at(m.normal(f)); },
                     .edge = [](Vec3, Vec3) { return -1; }});
  const Exact s(proxy, normals);
  std::map<std::int32_t, Vec3> direction;
  for (const Probe& p : test::probes(s.surface)) {
    const std::int32_t face = face_at(p.frame.normal);
    const Vec3 d = s.at(p);
    if (direction.count(face)) {
      EXPECT_LT(line_angle(d, direction[face]), 1e-9);
    }
    direction[face] = d;
  }
  ASSERT_EQ(direction.size(), 6u);
  for (const auto& [a, x] : direction) {
    for (const auto& [b, y] : direction) {
      if (a + b == 5) {
        EXPECT_LT(line_angle(x, y), 1e-6) << "opposite faces are alike";
      } else if (a != b) {
        EXPECT_GT(line_angle(x, y), 89) << a << " and " << b;
      }
    }
  }
  // And all upright where the style wants one direction.
  const Exact upright(proxy, normals, {.policy = {.plane = field::FacePolicy::Plane::Direction}});
  for (const Probe& p : test::probes(upright.surface)) {
    if (std::abs(p.frame.normal.z) < 0.5) {
      EXPECT_LT(line_angle(upright.at(p), {0, 0, 1}), 1e-9);
    }
  }
}

TEST(ExactFaces, ABallHasCirclesOfLatitude) {
  using Sphere = field::FacePolicy::Sphere;
  const Vec3 view = glm::normalize(Vec3(1, -1, 1));
  const auto frames = [](std::int32_t, Vec3 p) {
    Frame f = plane(p, glm::normalize(p));
    f.kind = FaceKind::Sphere;
    f.k1 = f.k2 = 1;
    return f;
  };
  const ProxyMesh proxy = test::sourced(
      build_proxy(test::ellipsoid({1, 1, 1}, 48, 24), {}, RunContext()),
      {.face = [](std::uint32_t) { return 0; }, .edge = [](Vec3, Vec3) { return -1; }});
  for (const auto& [sphere, axis] :
       {std::pair(Sphere::Axis, Vec3(0, 0, 1)), std::pair(Sphere::View, view)}) {
    const Exact s(proxy, frames, {.policy = {.sphere = sphere}, .view = view});
    std::vector<double> off;
    for (const Probe& p : test::probes(s.surface)) {
      const Vec3 n = p.frame.normal;
      if (std::abs(glm::dot(n, axis)) > 0.9) continue;  // the poles
      off.push_back(line_angle(s.at(p), glm::cross(axis, n)));
    }
    EXPECT_LT(test::quantile(off, 1), 1e-6);
  }
}

TEST(ExactFaces, ADomeHasCirclesAlongItsRim) {
  // Half a ball that lies on its side, given as some spline or other, with its flat face.
  const Vec3 axis(1, 0, 0);
  constexpr std::uint32_t kN = 48, kM = 12;
  TriMesh m = test::grid(kN, kM, true, false, [&](std::uint32_t i, std::uint32_t j) {
    const double u = 2 * kPi * i / kN, v = kPi / 2 * j / kM;
    return Vec3(2 * std::sin(v), 2 * std::cos(v) * std::cos(u), 2 * std::cos(v) * std::sin(u));
  });
  const auto pole = static_cast<std::uint32_t>(m.positions.size());
  m.positions.push_back({2, 0, 0});
  for (std::uint32_t i = 0; i < kN; ++i) {
    const std::uint32_t next = (i + 1) % kN;
    m.triangles.push_back({i * kM + kM - 1, next * kM + kM - 1, pole});
    if (i > 0 && i + 1 < kN) m.triangles.push_back({0, next * kM, i * kM});
  }
  const auto is_flat = [](Vec3 n) { return n.x < -0.9; };
  const ProxyMesh proxy =
      test::sourced(build_proxy(m, {}, RunContext()),
                    {.face = [&](std::uint32_t f) { return is_flat(m.normal(f)) ? 1 : 0; },
                     .edge = [](Vec3, Vec3) { return -1; }});
  const Exact s(proxy, [](std::int32_t face, Vec3 p) {
    if (face == 1) return plane(p, {-1, 0, 0});
    Frame f = plane(p, glm::normalize(p));
    f.kind = FaceKind::Freeform;
    f.k1 = f.k2 = 0.5;
    return f;
  });
  for (const Probe& p : test::probes(s.surface)) {
    const Vec3 n = p.frame.normal;
    if (is_flat(n) || n.x > 0.99) continue;
    EXPECT_LT(line_angle(s.at(p), glm::cross(axis, n)), 0.01);
  }
}

}  // namespace
}  // namespace burin
