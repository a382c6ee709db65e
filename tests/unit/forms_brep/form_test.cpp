#include <burin/base/error.h>
#include <burin/camera/facing.h>

#include "brep_checks.h"

#include <BRepPrimAPI_MakeTorus.hxx>
#include <burin_test/shapes.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace burin::test {
namespace {

double signed_volume(const TriMesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    sum +=
        glm::dot(mesh.positions[t[0]], glm::cross(mesh.positions[t[1]], mesh.positions[t[2]])) / 6;
  }
  return sum;
}

TEST(BrepForm, PlacementsScaleMirrorAndMove) {
  Placement p;
  p.linear = 2.0 * Mat3(0, 1, 0, 1, 0, 0, 0, 0, 1);  // swaps x and y: a mirror
  p.offset = {100, 200, -50};
  ASSERT_TRUE(p.mirrors());
  const auto form = brep_form(box_shape(1, 2, 3), p);
  const Box3 b = form->bounds(Mat3(1));
  EXPECT_LT(glm::distance(b.min, Vec3(100, 200, -50)), 1e-12);
  EXPECT_LT(glm::distance(b.max, Vec3(104, 202, -44)), 1e-12);
  RunContext context;
  const auto surface = form->realise({.tolerance = 0.1}, context);
  const ProxyMesh& proxy = surface->proxy();
  EXPECT_NEAR(signed_volume(proxy.mesh), 8 * 6, 1e-6);
  for (std::uint32_t f = 0; f < proxy.wedges.size(); ++f) {
    EXPECT_NEAR(glm::dot(proxy.mesh.normal(f), proxy.normal(f, Vec3(1.0 / 3))), 1, 1e-12);
  }
}

TEST(BrepForm, FacesAndEdgesKnowTheirNumbers) {
  RunContext context;
  const auto surface = brep_form(filleted_box_shape(0.25))->realise({.tolerance = 0.01}, context);
  const ProxyMesh& proxy = surface->proxy();
  std::vector<double> area(26, 0.0);
  for (std::uint32_t f = 0; f < proxy.wedges.size(); ++f) {
    area.at(static_cast<std::size_t>(proxy.face_source(f))) += proxy.mesh.area(f);
  }
  // 6 flat faces, 12 quarter cylinders, 8 eighths of a sphere.
  int corners = 0;
  for (const double a : area) {
    EXPECT_GT(a, 0);
    corners += std::abs(a - 0.25 * 0.25 * kPi / 2) < 0.005;
  }
  EXPECT_EQ(corners, 8);
  EXPECT_EQ(proxy.region_count, 1);  // smooth all round
}

TEST(BrepForm, MarchOverAFilletGoesStraight) {
  const double r = 1.5;
  RunContext context;
  const auto surface = brep_form(one_fillet_shape(r))->realise({.tolerance = 0.005}, context);
  // From the middle of the top over the rounded edge down the side at x = 10.
  SurfacePoint start;
  double nearest = 1e9;
  for (std::uint32_t f = 0; f < surface->proxy().wedges.size(); ++f) {
    const SurfacePoint p = surface->lift({f, Vec3(1.0 / 3)});
    const double d = glm::distance(p.position, Vec3(6, 5, 5));
    if (d < nearest) nearest = d, start = p;
  }
  ASSERT_LT(nearest, 6);
  ASSERT_NEAR(start.position.z, 5, 1e-9);
  const double to_fillet = 10 - r - start.position.x, arc = r * kPi / 2;
  ASSERT_GT(to_fillet, 0);
  for (const double down : {0.5, 2.0}) {
    const MarchStep step = surface->march(start, {1, 0, 0}, to_fillet + arc + down);
    EXPECT_EQ(step.stop, MarchStop::Completed);
    EXPECT_LT(glm::distance(step.end.position, Vec3(10, start.position.y, 5 - r - down)), 1e-6);
    EXPECT_LT(glm::distance(glm::normalize(step.direction), Vec3(0, 0, -1)), 1e-6);
  }
  // Half way round: the fillet's own curvature.
  const MarchStep half = surface->march(start, {1, 0, 0}, to_fillet + arc / 2);
  EXPECT_NEAR(surface->frame(half.end).k1, 1 / r, 1e-9);
  EXPECT_NEAR(surface->frame(half.end).k2, 0, 1e-9);
  // The sharp edge below stops it.
  EXPECT_EQ(surface->march(start, {1, 0, 0}, 20).stop, MarchStop::Crease);
}

TEST(BrepForm, ContoursOfATorusAreExact) {
  RunContext context;
  const auto form = brep_form(BRepPrimAPI_MakeTorus(3, 1).Shape());
  const Camera camera =
      Camera::fit([&](const Mat3& axes) { return form->bounds(axes); }, ViewOptions());
  const auto surface = form->realise({.tolerance = 0.01, .view = &camera}, context);
  const ProxyMesh& proxy = surface->proxy();
  std::size_t on = 0;
  for (std::uint32_t w = 0; w < proxy.wedge_vertex.size(); ++w) {
    if (!proxy.on_contour[w]) continue;
    ++on;
    EXPECT_NEAR(glm::dot(proxy.wedge_normal[w], camera.direction()), kEdgeOn, 2e-3);
  }
  EXPECT_GT(on, 100u);
}

TEST(BrepForm, RealPartsAreManifoldAndWithinTolerance) {
  struct Case {
    const char* file;
    std::size_t faces;
    bool closed;
  };
  int drawn = 0;
  for (const Case& c :
       {Case{"nurbs/freecad/filletBox.brep", 17, true}, Case{"nurbs/freecad/spline.brep", 10, true},
        Case{"nurbs/occt/hammer.brep", 45, true}, Case{"nurbs/occt/wing.brep", 4, false},
        Case{"nurbs/gmsh/tank.brep", 52, false}}) {
    const auto path = data(c.file);
    if (!std::filesystem::exists(path)) continue;
    SCOPED_TRACE(c.file);
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    const ModelPtr model = brep_from_text(text.str());
    EXPECT_EQ(model->face_count(), c.faces);
    RunContext context;
    Diagnostics diagnostics;
    const double tolerance = 2e-4 * model->size();
    const auto mesh = model->tessellate(tolerance, context, &diagnostics);
    EXPECT_TRUE(diagnostics.empty());
    EXPECT_EQ(open_half_edges(*mesh) == 0, c.closed);
    EXPECT_LE(mesh->tolerance, 4.01 * tolerance);  // along the triangles
    ++drawn;
  }
  if (drawn == 0) GTEST_SKIP() << "no " << data("nurbs");
}

}  // namespace
}  // namespace burin::test
