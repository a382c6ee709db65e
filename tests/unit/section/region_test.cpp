/// Forms without what lies beyond several planes: quarters, steps and openings.

#include <burin/forms/mesh/mesh_form.h>
#include <burin/section/section.h>

#include <burin_test/irregular.h>
#include <burin_test/shapes.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace burin {
namespace {

std::shared_ptr<const Form> region_mesh(TriMesh m) {
  return std::make_shared<MeshForm>(std::move(m));
}

std::shared_ptr<const Surface> realised_region(const std::shared_ptr<const Form>& form,
                                               Diagnostics* diagnostics = nullptr) {
  RunContext context;
  return form->realise({.tolerance = 0.01, .diagnostics = diagnostics}, context);
}

bool closed_region(const ProxyMesh& proxy) {
  return std::ranges::all_of(proxy.topology.component_closed, [](auto c) { return c != 0; });
}

double region_volume(const TriMesh& m) {
  double six = 0;
  for (const Triangle& t : m.triangles) {
    six += glm::dot(m.positions[t[0]], glm::cross(m.positions[t[1]], m.positions[t[2]]));
  }
  return six / 6;
}

double region_area(const ProxyMesh& proxy, std::int32_t number) {
  double area = 0;
  for (std::uint32_t f = 0; f < proxy.mesh.triangles.size(); ++f) {
    if (!proxy.is_cut(f)) continue;
    const auto region = static_cast<std::size_t>(proxy.face_region[f]);
    if (proxy.cut_plane[region] == number) area += proxy.mesh.area(f);
  }
  return area;
}

double surface_area(const TriMesh& m) {
  double area = 0;
  for (std::uint32_t f = 0; f < m.triangles.size(); ++f) area += m.area(f);
  return area;
}

/// The planes of a box, turned inwards.
CutRegion inside(const Box3& box) {
  CutRegion region;
  for (int k = 0; k < 3; ++k) {
    Vec3 n(0);
    n[k] = 1;
    region.push_back({n, box.min[k]});
    region.push_back({-n, -box.max[k]});
  }
  return region;
}

/// What is beyond all planes, by cuts of one plane.
double beyond(std::shared_ptr<const Form> form, const CutRegion& region) {
  for (const CutPlane& plane : region) {
    form = cut_form(form, {-plane.normal, -plane.offset}, 0, "");
  }
  return region_volume(realised_region(form)->proxy().mesh);
}

TEST(CutRegions, OfTwoPlanesTakeAQuarter) {
  const auto box = region_mesh(test::box({0, 0, 0}, {2, 3, 4}));
  const auto cut = cut_form(box, CutRegion{{{1, 0, 0}, 0.5}, {{0, 1, 0}, 1}}, 5, "box");
  const auto proxy_surface = realised_region(cut);
  const ProxyMesh& proxy = proxy_surface->proxy();
  EXPECT_TRUE(closed_region(proxy));
  EXPECT_NEAR(region_volume(proxy.mesh), 24 - 1.5 * 2 * 4, 1e-12);
  EXPECT_NEAR(region_area(proxy, 5), 2 * 4, 1e-12);
  EXPECT_NEAR(region_area(proxy, 6), 1.5 * 4, 1e-12);
  // Nothing is there twice.
  EXPECT_NEAR(surface_area(proxy.mesh), 2 * (6 + 8 + 12) - 2 * 1.5 * 2, 1e-12);
  // What is left has the size of the whole.
  EXPECT_EQ(cut->bounds(Mat3(1)).max, Vec3(2, 3, 4));
}

TEST(CutRegions, OfABoxMakeAnOpening) {
  const auto box = region_mesh(test::box({0, 0, 0}, {2, 3, 4}));
  // From a face inwards, and over an edge.
  for (const Box3 hole : {Box3{{0.5, 1, 3}, {1.5, 2, 5}}, Box3{{1.5, 1, 3}, {2.5, 2, 5}}}) {
    const Box3 inner{hole.min, glm::min(hole.max, Vec3(2, 3, 4))};
    const auto proxy_surface = realised_region(cut_form(box, inside(hole), 0, ""));
    const ProxyMesh& proxy = proxy_surface->proxy();
    EXPECT_TRUE(closed_region(proxy));
    const Vec3 size = inner.max - inner.min;
    EXPECT_NEAR(region_volume(proxy.mesh), 24 - size.x * size.y * size.z, 1e-12);
    EXPECT_NEAR(region_area(proxy, 4), size.x * size.y, 1e-12);  // its floor
  }
  // Inside of it: a hollow.
  const auto hollow_surface =
      realised_region(cut_form(box, inside({{0.5, 1, 1}, {1.5, 2, 3}}), 0, ""));
  const ProxyMesh& hollow = hollow_surface->proxy();
  EXPECT_TRUE(closed_region(hollow));
  EXPECT_NEAR(region_volume(hollow.mesh), 22, 1e-12);
  EXPECT_NEAR(surface_area(hollow.mesh), 52 + 10, 1e-12);
}

TEST(CutRegions, ThatLieElsewhereTakeNothing) {
  const auto box = region_mesh(test::box({0, 0, 0}, {2, 3, 4}));
  const auto whole = realised_region(cut_form(box, inside({{3, 0, 0}, {4, 1, 1}}), 0, ""));
  EXPECT_EQ(whole->proxy().mesh.triangles.size(), 12U);
  EXPECT_TRUE(whole->proxy().cut_plane.empty());
  EXPECT_TRUE(realised_region(cut_form(box, inside({{-1, -1, -1}, {5, 5, 5}}), 0, ""))
                  ->proxy()
                  .mesh.triangles.empty());
  // In line with its faces on all sides, or on one.
  EXPECT_TRUE(realised_region(cut_form(box, inside({{0, 0, 0}, {2, 3, 4}}), 0, ""))
                  ->proxy()
                  .mesh.triangles.empty());
  const auto flush_surface = realised_region(cut_form(box, inside({{0, 0, 3}, {2, 2, 4}}), 0, ""));
  const ProxyMesh& flush = flush_surface->proxy();
  EXPECT_TRUE(closed_region(flush));
  EXPECT_NEAR(region_volume(flush.mesh), 20, 1e-12);
}

TEST(CutRegions, OneAfterTheOtherMakeSteps) {
  const auto box = region_mesh(test::box({0, 0, 0}, {4, 4, 1}));
  auto cut = cut_form(box, CutRegion{{{-1, 0, 0}, -2}, {{0, -1, 0}, -1}}, 0, "");  // x < 2, y < 1
  cut = cut_form(cut, CutRegion{{{1, 0, 0}, 2}, {{0, -1, 0}, -3}}, 2, "");         // x > 2, y < 3
  const auto proxy_surface = realised_region(cut);
  const ProxyMesh& proxy = proxy_surface->proxy();
  EXPECT_TRUE(closed_region(proxy));
  EXPECT_NEAR(region_volume(proxy.mesh), 16 - 2 - 6, 1e-12);
  EXPECT_NEAR(region_area(proxy, 1), 2, 1e-12);
  EXPECT_NEAR(region_area(proxy, 3), 2, 1e-12);
  EXPECT_NEAR(region_area(proxy, 0) + region_area(proxy, 2), 2, 1e-12);  // the riser
  EXPECT_NEAR(surface_area(proxy.mesh), 2 * 8 + 4 + 1 + 3 + 4 + 2, 1e-12);
}

TEST(CutRegions, CloseWhereverTheirPlanesLie) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-1, 1);
  const TriMesh meshes[] = {test::box({-1, -1, -1}, {1, 1, 1}), test::torus(3, 1, 24, 12),
                            test::irregular_ellipsoid({3, 2, 1}, 400), test::cylinder(2, 4, 12)};
  int cut_somewhere = 0;
  for (const TriMesh& coarse : meshes) {
    const auto form = region_mesh(coarse);
    const auto whole_surface = realised_region(form);
    const TriMesh& m = whole_surface->proxy().mesh;
    const auto vertex = [&] { return m.positions[random() % m.positions.size()]; };
    for (int i = 0; i < 75; ++i) {
      CutRegion region;
      for (std::size_t k = 0; k < 2 + static_cast<std::size_t>(i) % 4; ++k) {
        Vec3 n(any(random), any(random), any(random));
        const int kind = (i + static_cast<int>(k)) % 3;
        if (kind == 1) n = glm::cross(vertex() - vertex(), vertex() - vertex());
        if (kind == 2) n = m.normal(static_cast<std::uint32_t>(random() % m.triangles.size()));
        if (glm::length(n) < 1e-9) continue;
        n = glm::normalize(n);
        region.push_back({n, glm::dot(n, kind == 0 ? 0.5 * vertex() : vertex())});
      }
      Diagnostics said;
      const auto left = realised_region(cut_form(form, region, 0, ""), &said);
      for (const Diagnostic& d : said.entries()) EXPECT_NE(d.code, "section.open") << i;
      const ProxyMesh& proxy = left->proxy();
      EXPECT_TRUE(proxy.mesh.triangles.empty() || closed_region(proxy)) << i;
      const double all = region_volume(m), gone = beyond(form, region);
      EXPECT_NEAR(region_volume(proxy.mesh) + gone, all, 1e-4 * all) << i;
      cut_somewhere += gone > 0.001 * all && gone < 0.999 * all ? 1 : 0;
    }
  }
  EXPECT_GT(cut_somewhere, 150);
}

TEST(CutRegions, EndMarchesAtAllTheirPlanes) {
  const auto ball = region_mesh(test::ellipsoid(Vec3(5), 120, 60));
  const CutRegion region{{{0, 0, 1}, 1}, {{1, 0, 0}, 2}};
  const auto surface = realised_region(cut_form(ball, region, 0, ""));
  const ProxyMesh& proxy = surface->proxy();
  ASSERT_TRUE(closed_region(proxy));
  std::size_t tried = 0, ended = 0, flat = 0;
  for (std::uint32_t f = 0; f < proxy.mesh.triangles.size(); f += 7) {
    const SurfacePoint p = surface->lift({f, Vec3(1.0 / 3)});
    for (const Vec3 way : {Vec3(0.3, 0.2, 1), Vec3(1, -0.4, 0.1)}) {
      const Vec3 n = surface->frame(p).normal;
      const Vec3 tangent = way - glm::dot(way, n) * n;
      if (glm::length(tangent) < 0.1) continue;
      const MarchStep step = surface->march(p, glm::normalize(tangent), 12);
      ++tried;
      const Vec3 e = step.end.position;
      EXPECT_FALSE(e.z > 1 + 1e-6 && e.x > 2 + 1e-6) << e.x << " " << e.y << " " << e.z;
      ASSERT_LT(step.end.triangle, proxy.mesh.triangles.size());
      if (!proxy.is_cut(f)) {
        EXPECT_FALSE(proxy.is_cut(step.end.triangle));
        ended += step.stop == MarchStop::Crease ? 1 : 0;
        continue;
      }
      ++flat;
      EXPECT_EQ(step.stop, MarchStop::Crease);
      EXPECT_EQ(proxy.face_region[step.end.triangle], proxy.face_region[f]);
    }
  }
  EXPECT_GT(tried, 300U);
  EXPECT_GT(ended, 50U);
  EXPECT_GT(flat, 20U);
}

}  // namespace
}  // namespace burin
