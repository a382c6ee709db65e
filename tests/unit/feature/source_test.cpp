// Lines of proxies that know the faces and edges of their input.

#include <burin/feature/kind_borders.h>
#include <burin/feature/source_faces.h>

#include "feature_support.h"

#include <burin_test/sourced.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace burin::test {
namespace {

constexpr std::uint32_t kFacets = 64;
constexpr double kHeight = 3;

bool at(double x, double y) { return std::abs(x - y) < 1e-9; }

/// A cylinder about z of radius 1: caps 0 and 1, the halves of its side 2 (y > 0) and 3; the rims
/// are edges 10 (bottom) and 11, the halves meet in the smooth edge 12 at x = 1 and in the seam 13
/// at x = -1.
ProxyMesh split_cylinder() {
  const RunContext run;
  ProxyMesh proxy = build_proxy(cylinder(1, kHeight, kFacets), {}, run);
  const TriMesh mesh = proxy.mesh;
  const auto on_side = [](Vec3 p) { return p.x * p.x + p.y * p.y > 0.5; };
  return sourced(std::move(proxy),
                 {.face =
                      [mesh](std::uint32_t f) {
                        const Vec3 n = mesh.normal(f);
                        return n.z < -0.5 ? 0 : n.z > 0.5 ? 1 : n.y > 0 ? 2 : 3;
                      },
                  .edge =
                      [on_side](Vec3 a, Vec3 b) {
                        if (!on_side(a) || !on_side(b)) return -1;
                        if (a.z == b.z) return a.z == 0 ? 10 : 11;
                        if (!at(a.x, b.x) || !at(a.y, 0) || !at(b.y, 0)) return -1;
                        return a.x > 0 ? 12 : 13;
                      },
                  .seam = [](Vec3 a, Vec3 b) { return at(a.x, -1) && at(b.x, -1) && a.z != b.z; }});
}

struct Seen {
  RunContext run;
  ProxyMesh proxy;
  Camera camera;
  Diagnostics diagnostics;
  std::vector<Curve3> curves;

  Seen(ProxyMesh p, const ViewOptions& view, const FeatureOptions& options)
      : proxy(std::move(p)), camera(fit(proxy, view)) {
    const ProxyMesh* pointer = &proxy;
    curves = extract_features({&pointer, 1}, camera, options, diagnostics, run);
  }
  static Camera fit(const ProxyMesh& proxy, const ViewOptions& view) {
    return Camera::fit(
        [&](const Mat3& axes) {
          Box3 box;
          for (const Vec3& p : proxy.mesh.positions) box.add(axes * p);
          return box;
        },
        view);
  }
  std::vector<Curve3> of(LineClass kind) const {
    std::vector<Curve3> out;
    std::ranges::copy_if(curves, std::back_inserter(out),
                         [&](const Curve3& c) { return c.kind == kind; });
    return out;
  }
};

TEST(Source, SmoothEdgesAndSeamsAreCurvesOfTheirEdge) {
  // From x = +, a little to the side and above: edge 12 in front, the seam behind.
  const Seen s(split_cylinder(), {.direction = {1, 0.2, 0.3}}, {.smooth = true, .seams = true});
  const auto smooth = s.of(LineClass::Smooth), seams = s.of(LineClass::Seam);
  ASSERT_EQ(smooth.size(), 1u);
  ASSERT_EQ(seams.size(), 1u);
  EXPECT_EQ(smooth[0].source.edge, 12);
  EXPECT_EQ(seams[0].source.edge, 13);
  EXPECT_TRUE(smooth[0].source.face == 2 || smooth[0].source.face == 3);
  for (const Curve3& c : {smooth[0], seams[0]}) {
    EXPECT_FALSE(c.occluding);
    EXPECT_FALSE(c.closed);
    EXPECT_NEAR(length(c), kHeight, 1e-12);
    EXPECT_EQ(c.faces.size(), c.segment_count());
    EXPECT_EQ(c.crease_sign, 0);
  }
  EXPECT_TRUE(none_hidden(smooth[0]));
  EXPECT_TRUE(all_hidden(seams[0]));
  EXPECT_NEAR(smooth[0].normals[0].x, 1, 1e-3);
}

TEST(Source, LeftOutUnlessAskedFor) {
  const Seen s(split_cylinder(), {.direction = {1, 0.2, 0.3}}, {.smooth = false});
  EXPECT_TRUE(s.of(LineClass::Smooth).empty());
  EXPECT_TRUE(s.of(LineClass::Seam).empty());
}

// The border of two colours is a line of its own wherever the drawing finds none.
TEST(Source, BordersOfKindsAreWhereNoOtherLineIs) {
  const ProxyMesh proxy = split_cylinder();
  const auto borders = [&](const FeatureOptions& lines) {
    std::vector<double> at;  // x of each
    for (const Curve3& c : kind_borders(
             proxy, 0, [](std::int32_t face) { return face; }, lines)) {
      EXPECT_NEAR(length(c), kHeight, 1e-12);
      at.push_back(std::round(c.points[0].x));
    }
    std::ranges::sort(at);
    return at;
  };
  EXPECT_EQ(borders({.smooth = false, .seams = false}), (std::vector<double>{-1, 1}));
  EXPECT_EQ(borders({.smooth = true, .seams = false}), std::vector<double>{-1}) << "the seam";
  EXPECT_EQ(borders({.smooth = false, .seams = true}), std::vector<double>{1});
  EXPECT_EQ(borders({.smooth = true, .seams = true}), std::vector<double>{});
}

TEST(Source, CreasesHaveTheEdgeAndFaceOfTheInput) {
  const Seen s(split_cylinder(), {.direction = {1, 0.2, 0.3}}, {.smooth = true, .seams = true});
  double rim[2] = {0, 0};
  for (const Curve3& c : s.curves) {
    if (c.source.edge != 10 && c.source.edge != 11) continue;
    rim[c.source.edge - 10] += length(c);
    EXPECT_EQ(c.source.face, s.proxy.source_face[static_cast<std::size_t>(c.faces[0])]);
  }
  // The facets' corners are samples of a circle, and it is that circle that is drawn: the polygon
  // is 2.5e-3 shorter.
  EXPECT_NEAR(rim[0], 2 * kPi, 2e-4);
  EXPECT_NEAR(rim[1], 2 * kPi, 2e-4);
}

TEST(Source, AWholeRimStaysOneClosedCurve) {
  // Seen from above both sides of the upper rim look alike all round, though an edge ends there.
  const Seen s(split_cylinder(), {.direction = {0, 0, 1}, .up = {0, 1, 0}},
               {.smooth = true, .seams = true});
  int closed = 0;
  for (const Curve3& c : s.curves) {
    if (c.source.edge == 11) {
      EXPECT_TRUE(c.closed);
      ++closed;
    }
  }
  EXPECT_EQ(closed, 1);
}

TEST(Source, AContourAlongASmoothEdgeIsDrawnOnce) {
  // Looking along y: the contours of the side run exactly along edges 12 and 13.
  const Seen s(split_cylinder(), {.direction = {0, -1, 0}}, {.smooth = true, .seams = true});
  EXPECT_TRUE(s.of(LineClass::Smooth).empty());
  EXPECT_TRUE(s.of(LineClass::Seam).empty());
  int along = 0;
  for (const Curve3& c : s.of(LineClass::Contour)) {
    if (c.source.edge >= 0) continue;
    EXPECT_NEAR(length(c), kHeight, 1e-9);
    EXPECT_NEAR(std::abs(c.points[0].x), 1, 1e-5);
    EXPECT_EQ(c.source.face, 3);  // the front side
    ++along;
  }
  EXPECT_EQ(along, 2);
}

TEST(Source, ASmoothEdgeSeenFromItsEndIsNoLine) {
  const Seen s(split_cylinder(), {.direction = {0, 0, 1}, .up = {0, 1, 0}},
               {.smooth = true, .seams = true});
  for (const LineClass kind : {LineClass::Smooth, LineClass::Seam}) {
    for (const Curve3& c : s.of(kind)) EXPECT_TRUE(all_hidden(c));
  }
}

TEST(Source, AContourRunsOnOverTheFacesOfASmoothRegion) {
  // A sphere of a small cap (face 7) and the rest (face 8).
  RunContext run;
  ProxyMesh proxy = build_proxy(ellipsoid({1, 1, 1}, 64, 32), {}, run);
  const TriMesh mesh = proxy.mesh;
  const auto high = [](Vec3 p) { return p.z > 0.7; };
  const Seen s(sourced(std::move(proxy), {.face =
                                              [&](std::uint32_t f) {
                                                const Triangle& t = mesh.triangles[f];
                                                return high(mesh.positions[t[0]]) ||
                                                               high(mesh.positions[t[1]]) ||
                                                               high(mesh.positions[t[2]])
                                                           ? 7
                                                           : 8;
                                              },
                                          .edge =
                                              [&](Vec3 a, Vec3 b) {
                                                const double ring =
                                                    std::sin(kPi * 23 / 32 - kPi / 2);
                                                return at(a.z, ring) && at(b.z, ring) ? 4 : -1;
                                              }}),
               {.direction = {0, -1, 0.1}}, {.smooth = true});
  const auto contours = s.of(LineClass::Contour);
  ASSERT_EQ(contours.size(), 1u);
  EXPECT_TRUE(contours[0].closed);
  EXPECT_EQ(contours[0].source.face, 8);
  EXPECT_EQ(contours[0].source.edge, -1);
  const auto runs = source_faces(contours[0], s.proxy, s.camera);
  std::set<std::int32_t> faces;
  double on_cap = 0, all = 0;
  for (const FaceRun& r : runs) {
    faces.insert(r.face);
    all += r.paper_length;
    if (r.face == 7) on_cap += r.paper_length;
  }
  EXPECT_EQ(faces, (std::set<std::int32_t>{7, 8}));
  // The contour is within 0.1 rad of the meridian: the cap begins at latitude 39.4 degrees.
  EXPECT_NEAR(on_cap / all, (90 - 39.4) / 180, 0.02);
  // Edge 4 is a circle that is seen in front of the contour and hidden behind it.
  double seen = 0, behind = 0;
  for (const Curve3& c : s.of(LineClass::Smooth)) {
    EXPECT_EQ(c.source.edge, 4);
    for (std::size_t i = 0; i < c.segment_count(); ++i) {
      (hidden(c, i) ? behind : seen) += glm::distance(c.points[i], c.points[c.next(i)]);
    }
  }
  EXPECT_GT(seen, 0.45 * (seen + behind));
  EXPECT_GT(behind, 0.4 * (seen + behind));
}

TEST(Source, ChainsSplitWhereTheEdgeChanges) {
  // A ring of square section.
  RunContext run;
  ProxyMesh proxy = build_proxy(grid(8, 8, true, true,
                                     [](std::uint32_t i, std::uint32_t j) {
                                       const double u = 2 * kPi * i / 8;
                                       const double c[4][2] = {{1, 0}, {2, 0}, {2, 1}, {1, 1}};
                                       const auto k = j / 2;
                                       const auto next = (k + 1) % 4;
                                       const double t = 0.5 * (j % 2);
                                       const double r = (1 - t) * c[k][0] + t * c[next][0];
                                       const double z = (1 - t) * c[k][1] + t * c[next][1];
                                       return Vec3(r * std::cos(u), r * std::sin(u), -z);
                                     }),
                                {.crease_angle = 60}, run);
  // Four closed creases of eight segments; the outer lower one is of two edges: 0 and 1.
  const auto radius = [](Vec3 p) { return std::hypot(p.x, p.y); };
  const Seen s(sourced(std::move(proxy), {.face = [](std::uint32_t) { return 0; },
                                          .edge =
                                              [&](Vec3 a, Vec3 b) {
                                                if (!at(radius(a), radius(b)) || !at(a.z, b.z))
                                                  return -1;
                                                if (at(a.z, -0.5) || at(radius(a), 1.5)) return -1;
                                                const bool outer = at(radius(a), 2),
                                                           low = at(a.z, -1);
                                                if (!outer) return low ? 2 : 3;
                                                if (!low) return 4;
                                                return a.y + b.y > 0 ? 0 : 1;
                                              }}),
               {.direction = {0, 0, -1}, .up = {0, 1, 0}}, {});
  std::vector<Curve3> halves;
  for (const Curve3& c : s.curves) {
    if (c.source.edge == 0 || c.source.edge == 1) halves.push_back(c);
  }
  ASSERT_EQ(halves.size(), 2u);
  EXPECT_NE(halves[0].source.edge, halves[1].source.edge);
  for (const Curve3& c : halves) {
    EXPECT_FALSE(c.closed);
    EXPECT_EQ(c.segment_count(), 4u);
    EXPECT_EQ(ends_at(halves, c.points.front()), 2);  // bit for bit
    EXPECT_EQ(ends_at(halves, c.points.back()), 2);
  }
}

}  // namespace
}  // namespace burin::test
