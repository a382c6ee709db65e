// Proxies cut along exact contours against their analytic truths.

#include <burin/base/parallel.h>
#include <burin/camera/facing.h>
#include <burin/feature/feature.h>
#include <burin/work_mesh/proxy_draft.h>

#include <burin_test/atlases.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace burin {
namespace {

using test::Charted;
using test::kPi;

Camera camera_on(const ChartMesh& mesh, const ViewOptions& view) {
  return Camera::fit(
      [&](const Mat3& axes) {
        Box3 box;
        for (const Vec3& p : mesh.positions) box.add(axes * p);
        return box;
      },
      view);
}

double area_of(const ChartMesh& mesh) {
  double area = 0;
  const TriMesh m{mesh.positions, mesh.triangles};
  for (std::uint32_t f = 0; f < m.triangles.size(); ++f) area += m.area(f);
  return area;
}

/// A charted mesh, cut for a view, and its features.
struct Cut {
  RunContext context;
  Charted charted;
  std::size_t triangles_before;
  double area_before;
  Camera camera;
  ProxyMesh proxy;
  std::vector<Curve3> contours;

  Cut(Charted shape, const ViewOptions& view, const ContourCutOptions& options = {})
      : charted(std::move(shape)),
        triangles_before(charted.mesh.triangles.size()),
        area_before(area_of(charted.mesh)),
        camera(camera_on(charted.mesh, view)) {
    cut_along_contours(charted.mesh, AtlasSampler(charted.atlas), camera, options, context);
    proxy = assemble_proxy(proxy_draft(charted.mesh), context);
    const ProxyMesh* pointer = &proxy;
    Diagnostics diagnostics;
    for (Curve3& c : extract_features({&pointer, 1}, camera, {}, diagnostics, context)) {
      if (c.kind == LineClass::Contour) contours.push_back(std::move(c));
    }
  }

  double size() const { return charted.atlas.size; }
};

int sign_at(const ChartMesh& mesh, const FacingFunction& g, std::size_t h) {
  if (mesh.on_contour[h]) return 0;
  const double value = g(mesh.positions[mesh.triangles[h / 3][h % 3]], mesh.normal[h]);
  return (value > 0) - (value < 0);
}

/// What holds after every cut.
void expect_sound(const Cut& cut) {
  const ChartMesh& mesh = cut.charted.mesh;
  const FacingFunction g(cut.camera);
  const std::size_t n = 3 * mesh.triangles.size();
  ASSERT_EQ(mesh.uv.size(), n);
  ASSERT_EQ(mesh.normal.size(), n);
  ASSERT_EQ(mesh.on_contour.size(), n);
  ASSERT_EQ(mesh.border.size(), n);
  ASSERT_EQ(mesh.face.size(), n / 3);
  int mixed = 0, off = 0, leaning = 0;
  for (std::size_t f = 0; f < n / 3; ++f) {
    const int a = sign_at(mesh, g, 3 * f), b = sign_at(mesh, g, 3 * f + 1),
              c = sign_at(mesh, g, 3 * f + 2);
    mixed += std::min({a, b, c}) < 0 && std::max({a, b, c}) > 0;
  }
  for (std::size_t h = 0; h < n; ++h) {
    const Vec3 p = mesh.positions[mesh.triangles[h / 3][h % 3]];
    const std::int32_t face = mesh.face[h / 3];
    off += glm::distance(p, cut.charted.atlas.position(face, mesh.uv[h])) > 1e-9 * cut.size();
    if (mesh.normal[h] == Vec3(0)) continue;
    const Vec3 exact =
        cut.charted.atlas.normal(face, mesh.uv[h], cut.charted.atlas.derivatives(face, mesh.uv[h]));
    leaning += glm::distance(exact, mesh.normal[h]) > 1e-8;
  }
  EXPECT_EQ(mixed, 0);
  EXPECT_EQ(off, 0);
  EXPECT_EQ(leaning, 0);
  // Both uses of an edge of the model run over the same parameters.
  for (std::size_t h = 0; h < n; ++h) {
    const HalfEdge o = cut.proxy.topology.opposite[h];
    if (mesh.border[h] < 0 || o == kNoHalfEdge) continue;
    const auto& border = mesh.borders[static_cast<std::size_t>(mesh.border[h])];
    const auto& other =
        mesh.borders[static_cast<std::size_t>(mesh.border[static_cast<std::size_t>(o)])];
    EXPECT_EQ(border.edge, other.edge);
  }
}

void expect_closed(const Cut& cut) {
  for (const HalfEdge o : cut.proxy.topology.opposite) ASSERT_NE(o, kNoHalfEdge);
  for (const std::uint8_t closed : cut.proxy.topology.component_closed) EXPECT_TRUE(closed);
}

/// The zero set of g over a chart: for each u of many the zeros along v.
std::vector<Vec3> zero_set(const PlacedAtlas& atlas, std::int32_t face, const Camera& camera, int n,
                           bool swap = false) {
  const FacingFunction g(camera);
  const ParameterBox box = atlas.atlas->chart(face).domain();
  const auto at = [&](double s, double t) {
    const Vec2 share = swap ? Vec2(t, s) : Vec2(s, t);
    return box.min + share * box.size();
  };
  const auto value = [&](double s, double t) {
    const Vec2 uv = at(s, t);
    const SurfaceDerivatives d = atlas.derivatives(face, uv);
    return g(d.p, atlas.normal(face, uv, d));
  };
  std::vector<Vec3> out;
  const int m = 400;
  for (int i = 0; i < n; ++i) {
    const double s = (i + 0.5) / n;
    double before = value(s, 0);
    for (int j = 0; j < m; ++j) {
      double a = double(j) / m, b = double(j + 1) / m;
      const double after = value(s, b), start = before;
      before = after;
      if ((start > 0) == (after > 0)) continue;
      for (int k = 0; k < 50; ++k) {
        const double c = 0.5 * (a + b);
        ((value(s, c) > 0) == (start > 0) ? a : b) = c;
      }
      out.push_back(atlas.position(face, at(s, a)));
    }
  }
  return out;
}

double distance_to(const std::vector<Curve3>& curves, const Camera& camera, Vec3 p) {
  double best = 1e300;
  const Vec2 q = camera.to_paper(p);
  for (const Curve3& c : curves) {
    for (std::size_t i = 0; i < c.segment_count(); ++i) {
      const Vec3 &a3 = c.points[i], &b3 = c.points[c.next(i)];
      // The same sheet of the surface: near in space, too.
      if (glm::distance(a3, p) > 2 * glm::distance(a3, b3) + 1 / camera.scale()) continue;
      const Vec2 a = camera.to_paper(a3), d = camera.to_paper(b3) - a;
      const double l = glm::dot(d, d);
      const double t = l > 0 ? std::clamp(glm::dot(q - a, d) / l, 0.0, 1.0) : 0;
      best = std::min(best, glm::distance(q, a + t * d));
    }
  }
  return best;
}

/// Largest distance on paper from the analytic zero set to the contours.
double farthest_off(const Cut& cut, int n = 400) {
  double worst = 0;
  for (const bool swap : {false, true}) {
    for (const Vec3& p : zero_set(cut.charted.atlas, 0, cut.camera, n, swap)) {
      worst = std::max(worst, distance_to(cut.contours, cut.camera, p));
    }
  }
  return worst;
}

/// Largest |g| / |gradient of g| in model mm at the points of the contours: how far they are from
/// the zero set.
double largest_error(const Cut& cut, bool inside_only = true) {
  const ChartMesh& mesh = cut.charted.mesh;
  const FacingFunction g(cut.camera);
  std::vector<std::uint8_t> bordered(mesh.positions.size(), 0);
  for (std::size_t h = 0; h < mesh.border.size(); ++h) {
    if (mesh.border[h] < 0) continue;
    bordered[mesh.triangles[h / 3][h % 3]] = 1;
    bordered[mesh.triangles[h / 3][(h + 1) % 3]] = 1;
  }
  double worst = 0;
  for (std::size_t h = 0; h < mesh.uv.size(); ++h) {
    const std::uint32_t v = mesh.triangles[h / 3][h % 3];
    if (!mesh.on_contour[h] || mesh.normal[h] == Vec3(0) || (inside_only && bordered[v])) continue;
    worst = std::max(worst, std::abs(g(mesh.positions[v], mesh.normal[h])));
  }
  return worst;
}

std::vector<Vec3> sorted_zero_vertices(const Cut& cut) {
  std::vector<Vec3> out;
  const ChartMesh& mesh = cut.charted.mesh;
  for (std::size_t h = 0; h < mesh.uv.size(); ++h) {
    if (mesh.on_contour[h]) out.push_back(mesh.positions[mesh.triangles[h / 3][h % 3]]);
  }
  const auto key = [](const Vec3& p) { return std::tuple(p.x, p.y, p.z); };
  std::ranges::sort(out, {}, key);
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

void expect_points_are_vertices(const Cut& cut) {
  const std::vector<Vec3> zeros = sorted_zero_vertices(cut);
  const auto key = [](const Vec3& p) { return std::tuple(p.x, p.y, p.z); };
  int others = 0;
  for (const Curve3& c : cut.contours) {
    if (c.source.edge >= 0) continue;
    for (const Vec3& p : c.points) {
      others += !std::ranges::binary_search(zeros, key(p), {}, key);
    }
  }
  EXPECT_EQ(others, 0);
}

const std::vector<ViewOptions>& views() {
  static const std::vector<ViewOptions> all = {
      {.direction = {1, -1, 1}},
      {.direction = {0.3, -1, 0.25}},
      {.direction = {0.2, 0.5, 0.08}},
      {.direction = {1, -1, 1}, .perspective = 40},
      {.direction = {0.3, -1, 0.25}, .perspective = 60},
  };
  return all;
}

TEST(ContourCut, SphereHasItsCircle) {
  for (const ViewOptions& view : views()) {
    for (const int n : {6, 12, 40}) {
      const Cut cut(test::charted_sphere(2, 2 * n, n), view);
      expect_sound(cut);
      expect_closed(cut);
      EXPECT_EQ(cut.contours.size(), 1u);
      EXPECT_TRUE(cut.contours[0].closed);
      EXPECT_LT(farthest_off(cut), 0.01) << n;
      EXPECT_LT(largest_error(cut), 1e-9);
      expect_points_are_vertices(cut);
      EXPECT_GT(area_of(cut.charted.mesh), cut.area_before);
      EXPECT_LT(area_of(cut.charted.mesh), 4 * kPi * 4);
    }
  }
}

TEST(ContourCut, TorusHasBothItsLoops) {
  for (const ViewOptions& view : views()) {
    for (const int n : {8, 16, 48}) {
      const Cut cut(test::charted_torus(3, 1, 2 * n, n), view);
      expect_sound(cut);
      expect_closed(cut);
      EXPECT_LT(farthest_off(cut), 0.01) << n;
      EXPECT_LT(largest_error(cut), 1e-9);
      expect_points_are_vertices(cut);
      EXPECT_LT(area_of(cut.charted.mesh), 4 * kPi * kPi * 3 * 1.0001);
      int closed = 0;
      for (const Curve3& c : cut.contours) closed += c.closed;
      EXPECT_EQ(closed, 2) << n;
      EXPECT_EQ(cut.contours.size(), 2u) << n;
    }
  }
}

/// Contours inside faces (on no crease).
std::vector<Curve3> smooth_contours(const Cut& cut) {
  std::vector<Curve3> out;
  for (const Curve3& c : cut.contours) {
    if (c.source.edge < 0) out.push_back(c);
  }
  return out;
}

TEST(ContourCut, CylinderWithCapsHasTwoRulingsThatEndOnTheRims) {
  for (const int patches : {1, 2, 3}) {
    for (const int n : {6, 24, 90}) {
      for (const ViewOptions& view : views()) {
        const Cut cut(test::charted_cylinder(2, 5, n, patches), view);
        expect_sound(cut);
        expect_closed(cut);
        const auto rulings = smooth_contours(cut);
        ASSERT_EQ(rulings.size(), 2u) << patches << " " << n;
        for (const Curve3& c : rulings) {
          EXPECT_FALSE(c.closed);
          const Vec3 a = c.points.front(), b = c.points.back();
          EXPECT_NEAR(std::abs(a.z - b.z), 5, 1e-9);
          // Exactly straight, and where n . v = 1e-4.
          for (const Vec3& p : c.points) {
            EXPECT_LT(glm::length(glm::cross(p - a, b - a)) / glm::length(b - a), 2e-3 / 20);
          }
          if (!view.perspective) {
            const Vec3 normal(a.x / 2, a.y / 2, 0);
            EXPECT_NEAR(glm::dot(normal, cut.camera.direction()), kEdgeOn, 1e-4);
          }
        }
        expect_points_are_vertices(cut);
        // The rims: whole circles between crease and contour pieces, ends meet bit for bit.
        for (const Curve3& c : rulings) {
          for (const Vec3& end : {c.points.front(), c.points.back()}) {
            int meet = 0;
            for (const Curve3& d : cut.contours) {
              if (d.source.edge < 0 || d.closed) continue;
              meet += d.points.front() == end || d.points.back() == end;
            }
            EXPECT_EQ(meet, 1);  // the rim is a contour on one side of the ruling's end
          }
        }
      }
    }
  }
}

TEST(ContourCut, CylinderSeenAlongItsAxisOrFromTheSideHasNoStrayLines) {
  const Cut along(test::charted_cylinder(2, 5, 24), {.direction = {0, 0, 1}, .up = {0, 1, 0}});
  expect_sound(along);
  EXPECT_EQ(smooth_contours(along).size(), 0u);
  const Cut side(test::charted_cylinder(2, 5, 24), {.direction = {0, -1, 0}});
  expect_sound(side);
  EXPECT_EQ(smooth_contours(side).size(), 2u);
}

TEST(ContourCut, ConeHasTwoRulingsThroughItsTip) {
  for (const int n : {8, 30}) {
    for (const ViewOptions& view : {views()[0], views()[1], views()[3]}) {
      const Cut cut(test::charted_cone(2, 3, n), view);
      expect_sound(cut);
      expect_closed(cut);
      const auto rulings = smooth_contours(cut);
      // One chain over the tip, or two that end there.
      double length = 0;
      int through = 0;
      for (const Curve3& c : rulings) {
        for (std::size_t i = 0; i < c.segment_count(); ++i) {
          length += glm::distance(c.points[i], c.points[c.next(i)]);
        }
        for (const Vec3& p : c.points) through += p == Vec3(0, 0, 3);
      }
      EXPECT_NEAR(length, 2 * std::sqrt(13.0), 1e-3) << n;
      EXPECT_GE(through, 1);
      expect_points_are_vertices(cut);
    }
  }
  const Cut above(test::charted_cone(2, 3, 24), {.direction = {0, 0, 1}, .up = {0, 1, 0}});
  EXPECT_EQ(smooth_contours(above).size(), 0u);
}

TEST(ContourCut, RoundedBoxHasFourRulingsObliqueAndNoDoubleLinesEdgeOn) {
  for (const int n : {2, 6}) {
    for (const ViewOptions& view : {views()[0], views()[1], views()[3]}) {
      const Cut cut(test::charted_rounded_box({4, 3}, 1, 5, n), view);
      expect_sound(cut);
      expect_closed(cut);
      const auto rulings = smooth_contours(cut);
      EXPECT_EQ(rulings.size(), 2u);
      for (const Curve3& c : rulings) {
        EXPECT_NEAR(glm::distance(c.points.front(), c.points.back()), 5, 1e-9);
      }
    }
    // Front view: two walls are seen edge-on; each contour lies where the fillet begins.
    const Cut front(test::charted_rounded_box({4, 3}, 1, 5, n), {.direction = {0, -1, 0}});
    expect_sound(front);
    const auto lines = smooth_contours(front);
    ASSERT_EQ(lines.size(), 2u);
    for (const Curve3& c : lines) {
      for (const Vec3& p : c.points) {
        EXPECT_NEAR(std::abs(p.x), 4, 1e-4);
        EXPECT_NEAR(p.y, -2, 2e-4);
      }
    }
  }
}

TEST(ContourCut, SmallBumpsThatNoCornerSeesAreFound) {
  // A dome of radius 1.5 mm on a gentle slope, in triangles of 4 mm.
  for (const Vec2 at : {Vec2(1.3, 0.9), Vec2(-2.2, 3.1), Vec2(0.4, -1.7), Vec2(2.0, 0.0)}) {
    const auto graph = [at](Vec2 p) {
      const Vec2 d = p - at;
      return Vec3(p, 0.6 * std::exp(-glm::dot(d, d)) + 0.01 * p.x);
    };
    Charted dome = test::charted_graph(8, 4, graph);
    dome.mesh.tolerance = 0.6;
    const Cut cut(std::move(dome), {.direction = {0.1, -1, 0.3}});
    expect_sound(cut);
    ASSERT_GE(cut.contours.size(), 1u) << at.x << " " << at.y;  // cut at cusps: an open sheet
    EXPECT_LT(farthest_off(cut), 0.01);
    EXPECT_LT(largest_error(cut), 1e-8);
  }
}

TEST(ContourCut, ShallowDentsOfExactSurfacesAreNoNoise) {
  // Its far side turns by less than a degree through edge-on.
  const auto graph = [](Vec2 p) { return Vec3(p, 0.2 * std::exp(-0.5 * glm::dot(p, p))); };
  const Cut cut(test::charted_graph(4, 30, graph), {.direction = {0, -1, 0.11}});
  expect_sound(cut);
  ASSERT_GE(cut.contours.size(), 1u);
  EXPECT_LT(farthest_off(cut, 100), 0.01);
}

TEST(ContourCut, WavesHaveAllTheirContours) {
  const auto graph = [](Vec2 p) {
    return Vec3(p, 0.5 * std::sin(1.3 * p.x + 0.2) * std::cos(1.1 * p.y) + 0.05 * p.y * p.y);
  };
  for (const int n : {12, 40}) {
    const Cut cut(test::charted_graph(6, n, graph), {.direction = {0.4, -1, 0.35}});
    expect_sound(cut);
    EXPECT_LT(farthest_off(cut, 90), 0.01) << n;
    EXPECT_LT(largest_error(cut), 1e-8);
    expect_points_are_vertices(cut);
  }
}

TEST(ContourCut, SameOnPaperAtAnyScalePlaceAndRotation) {
  const Vec3 axis = glm::normalize(Vec3(1, 2, -0.5));
  const auto rotation = [&](double w) {
    const auto turn = [&](Vec3 v) {
      return std::cos(w) * v + std::sin(w) * glm::cross(axis, v) +
             (1 - std::cos(w)) * glm::dot(axis, v) * axis;
    };
    return Mat3(turn({1, 0, 0}), turn({0, 1, 0}), turn({0, 0, 1}));
  };
  const Cut plain(test::charted_torus(3, 1, 24, 12), {.direction = {0.3, -1, 0.5}, .scale = 20});
  struct Move {
    double scale, angle;
    Vec3 offset;
  };
  for (const Move& move : {Move{1e-3, 0, Vec3(0)}, Move{1e3, 0, Vec3(0)}, Move{1, 0.7, Vec3(0)},
                           Move{1, 0, Vec3(1e4, -1e4, 5e3)}}) {
    const Mat3 r = rotation(move.angle);
    const Placement at{r * move.scale, move.offset};
    const Cut moved(
        test::charted_torus(3, 1, 24, 12, at),
        {.direction = r * Vec3(0.3, -1, 0.5), .up = r * Vec3(0, 0, 1), .scale = 20 / move.scale});
    expect_sound(moved);
    EXPECT_EQ(moved.contours.size(), 2u);
    EXPECT_NEAR(double(moved.charted.mesh.triangles.size()),
                double(plain.charted.mesh.triangles.size()),
                0.02 * double(plain.charted.mesh.triangles.size()));
    double worst = 0;
    const Vec2 shift =
        moved.camera.to_paper(at.point({4, 0, 0})) - plain.camera.to_paper({4, 0, 0});
    for (const Curve3& c : moved.contours) {
      for (const Vec3& p : c.points) {
        const Vec3 back = glm::inverse(at.linear) * (p - at.offset);
        EXPECT_LT(glm::distance(moved.camera.to_paper(p) - shift, plain.camera.to_paper(back)),
                  1e-6);
        worst = std::max(worst, distance_to(plain.contours, plain.camera, back));
      }
    }
    EXPECT_LT(worst, 0.01) << move.scale << " " << move.angle;
  }
}

TEST(ContourCut, MirroredPartsAreCutToo) {
  const Cut cut(test::charted_torus(3, 1, 32, 16, {Mat3(-1, 0, 0, 0, 1, 0, 0, 0, 1), Vec3(0)}),
                views()[1]);
  expect_sound(cut);
  expect_closed(cut);
  EXPECT_LT(farthest_off(cut), 0.01);
}

TEST(ContourCut, SameBytesForAnyNumberOfThreads) {
  const auto run = [] { return Cut(test::charted_torus(3, 1, 64, 32), views()[3]); };
  const auto one = [&] {
    const ThreadLimit limit(1);
    return run();
  }();
  const Cut many = run();
  EXPECT_EQ(one.charted.mesh.positions, many.charted.mesh.positions);
  EXPECT_EQ(one.charted.mesh.triangles, many.charted.mesh.triangles);
  EXPECT_EQ(one.charted.mesh.uv, many.charted.mesh.uv);
  EXPECT_EQ(one.charted.mesh.on_contour, many.charted.mesh.on_contour);
}

TEST(ContourCut, AFineChordNeedsMoreTrianglesACoarseOneFewer) {
  const auto count = [](double chord) {
    return Cut(test::charted_torus(3, 1, 32, 16), views()[1], {.chord = chord})
        .charted.mesh.triangles.size();
  };
  const std::size_t coarse = count(0.08), usual = count(0.005), fine = count(0.0003);
  EXPECT_LT(coarse, usual);
  EXPECT_LT(usual, fine);
  EXPECT_LT(usual, 1024u * 4);
}

TEST(ContourCut, WedgeNormalsAreTheMeanOfBothFacesOfASmoothEdge) {
  const RunContext context;
  Charted c = test::charted_rounded_box({4, 3}, 1, 5, 3);
  for (std::size_t h = 0; h < c.mesh.normal.size(); ++h) {
    EXPECT_NEAR(glm::length(c.mesh.normal[h]), 1, 1e-14);
    const std::int32_t face = c.mesh.face[h / 3];
    const Vec3 own = c.atlas.normal(face, c.mesh.uv[h], c.atlas.derivatives(face, c.mesh.uv[h]));
    EXPECT_LT(glm::distance(own, c.mesh.normal[h]), 1e-12);  // tangent faces agree
    EXPECT_EQ(c.mesh.on_contour[h], 0);
  }
  // Planes that meet at an angle in an edge that is called smooth.
  test::AtlasBuilder b;
  for (const double slope : {0.1, -0.1}) {
    const auto plane = [=](Vec2 p) {
      return SurfaceDerivatives{
          {p.x, p.y, slope * p.x}, {1, 0, slope}, {0, 1, 0}, Vec3(0), Vec3(0), Vec3(0)};
    };
    b.add_face(test::chart_of(plane, {-1, 0}, {1, 1}));
  }
  const int joint = b.add_edge(ModelEdgeClass::Smooth);
  b.add_grid(0, {{-1, 0}, {0, 1}}, 1, 1, {-1, joint, -1, -1});
  b.add_grid(1, {{0, 0}, {1, 1}}, 1, 1, {-1, -1, -1, joint});
  const Charted roof(std::move(b));
  for (std::size_t h = 0; h < roof.mesh.normal.size(); ++h) {
    const bool ridge = roof.mesh.uv[h].x == 0;
    const double x = ridge ? 0 : roof.mesh.uv[h].x < 0 ? -0.1 : 0.1;
    EXPECT_LT(glm::distance(roof.mesh.normal[h], glm::normalize(Vec3(x, 0, 1))), 1e-14);
  }
}

TEST(ContourCut, AFaceSeenEdgeOnBesideALeaningTangentFaceIsCutOnce) {
  // A vault along y, seen edge-on all over, and one that rises beyond it, which meet in an edge
  // that is called smooth: by their mean normal the first one faces the viewer at the joint.
  test::AtlasBuilder b;
  for (const double slope : {0.0, 0.1}) {
    const auto vault = [=](Vec2 p) {
      return SurfaceDerivatives{{p.x, p.y, std::cos(p.x) - slope * p.y},
                                {1, 0, -std::sin(p.x)},
                                {0, 1, -slope},
                                {0, 0, -std::cos(p.x)},
                                Vec3(0),
                                Vec3(0)};
    };
    b.add_face(test::chart_of(vault, {-1, slope > 0 ? 0 : -1}, {1, slope > 0 ? 1 : 0}));
  }
  const int joint = b.add_edge(ModelEdgeClass::Smooth);
  b.add_grid(0, {{-1, -1}, {1, 0}}, 9, 2, {-1, -1, joint, -1});
  b.add_grid(1, {{-1, 0}, {1, 1}}, 9, 2, {joint, -1, -1, -1});
  for (const double width : {50.0, 150.0, 400.0}) {
    SCOPED_TRACE(width);
    const Cut cut(Charted(test::AtlasBuilder(b)),
                  {.direction = {0, 1, 0}, .paper = {width, width}});
    EXPECT_LT(cut.charted.mesh.triangles.size(), 8 * cut.triangles_before);
  }
}

TEST(ContourCut, TheTipOfAConeHasNoNormalAndIsOnTheContour) {
  const Charted cone = test::charted_cone(2, 3, 12);
  int tips = 0;
  for (std::size_t h = 0; h < cone.mesh.normal.size(); ++h) {
    const bool tip = cone.mesh.positions[cone.mesh.triangles[h / 3][h % 3]] == Vec3(0, 0, 3);
    tips += tip;
    EXPECT_EQ(cone.mesh.on_contour[h] != 0, tip);
    EXPECT_EQ(cone.mesh.normal[h] == Vec3(0), tip);
  }
  EXPECT_EQ(tips, 12);
}

TEST(ContourCut, NothingToCutLeavesTheMeshAsItWas) {
  const RunContext context;
  const auto graph = [](Vec2 p) { return Vec3(p, 0.1 * std::sin(p.x)); };
  Charted c = test::charted_graph(3, 6, graph);
  const ChartMesh before = c.mesh;
  cut_along_contours(c.mesh, AtlasSampler(c.atlas),
                     camera_on(c.mesh, {.direction = {0, 0, 1}, .up = {0, 1, 0}}), {}, context);
  EXPECT_EQ(c.mesh.triangles, before.triangles);
  EXPECT_EQ(c.mesh.positions, before.positions);
  EXPECT_EQ(c.mesh.on_contour, before.on_contour);
}

}  // namespace
}  // namespace burin
