// The same shape as a mesh and as NURBS draws the same.

#include <burin/forms/mesh/mesh_form.h>
#include <burin/forms/patches/parametric_form.h>
#include <burin/illustrate/illustrate.h>

#include <burin_test/charts.h>
#include <burin_test/nurbs_shapes.h>
#include <burin_test/shapes.h>
#include <gtest/gtest.h>

#include <limits>

namespace burin {
namespace {

Camera camera_for(Vec3 direction) {
  return Camera::fit(
      [](const Mat3& axes) {
        return ParametricForm({make_nurbs_chart(test::torus_nurbs(3, 1))}).bounds(axes);
      },
      {.direction = direction});
}

Drawing outline(std::shared_ptr<const Form> form, const Camera& camera) {
  Scene scene;
  scene.parts.push_back({"torus", "test", std::move(form)});
  RunContext context;
  return illustrate(scene, camera, builtin_style("outline"), {}, context);
}

using Lines = std::vector<std::vector<Vec2>>;

Lines lines(const Drawing& drawing, LineClass kind) {
  Lines result;
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      if (path.kind != kind || !path.visible) continue;
      result.push_back(path.points);
      if (path.closed) result.back().push_back(path.points.front());
    }
  }
  return result;
}

double distance(Vec2 p, const Lines& all) {
  double best = std::numeric_limits<double>::infinity();
  for (const auto& line : all) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const Vec2 e = line[i + 1] - line[i];
      const double square = glm::dot(e, e);
      const double t = square > 0 ? std::clamp(glm::dot(p - line[i], e) / square, 0.0, 1.0) : 0;
      best = std::min(best, glm::distance(p, line[i] + t * e));
    }
  }
  return best;
}

/// The largest distance of `a`, sampled every 0.25 mm, from `b`.
double farthest(const Lines& a, const Lines& b) {
  double worst = 0;
  for (const auto& line : a) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const int n = 1 + static_cast<int>(4 * glm::distance(line[i], line[i + 1]));
      for (int k = 0; k <= n; ++k) {
        const double t = static_cast<double>(k) / n;
        worst = std::max(worst, distance(line[i] + t * (line[i + 1] - line[i]), b));
      }
    }
  }
  return worst;
}

TEST(RepresentationIndependence, ATorusAsMeshAndAsNurbsHasTheSameContours) {
  for (const Vec3 direction : {Vec3(1, -1, 1), Vec3(0.2, -0.3, 1), Vec3(1, 0.2, 0.45)}) {
    const Camera camera = camera_for(direction);
    const Lines exact = lines(outline(std::make_shared<ParametricForm>(
                                          std::vector{make_nurbs_chart(test::torus_nurbs(3, 1))}),
                                      camera),
                              LineClass::Contour);
    const Lines mesh =
        lines(outline(std::make_shared<MeshForm>(test::torus(3, 1, 480, 240)), camera),
              LineClass::Contour);
    ASSERT_FALSE(exact.empty());
    EXPECT_LT(farthest(exact, mesh), 0.03);
    EXPECT_LT(farthest(mesh, exact), 0.03);
  }
}

TEST(RepresentationIndependence, SixPatchesDrawAsOneSphere) {
  Scene scene;
  scene.parts.push_back(
      {"sphere", "test", std::make_shared<ParametricForm>(test::six_patches(Vec3(2)))});
  const Camera camera = Camera::fit([&](const Mat3& a) { return scene.bounds(a); }, {});
  RunContext context;
  const Drawing d = illustrate(scene, camera, builtin_style("outline"), {}, context);
  const Lines contours = lines(d, LineClass::Contour);
  // One closed circle of the sphere's radius, nothing else that is drawn.
  ASSERT_EQ(contours.size(), 1u);
  for (const Vec2& p : contours[0]) {
    EXPECT_NEAR(glm::distance(p, camera.to_paper(Vec3(0))), 2 * camera.scale(), 0.02);
  }
  for (const LineClass kind : {LineClass::Crease, LineClass::Boundary}) {
    EXPECT_TRUE(lines(d, kind).empty());
  }
}

TEST(RepresentationIndependence, StrokesRunOnOverTheBordersOfPatches) {
  // Strokes of six patches lie on several faces, and their points are those of the sphere.
  Scene scene;
  scene.parts.push_back(
      {"ellipsoid", "test", std::make_shared<ParametricForm>(test::six_patches({3, 2, 1}))});
  const Camera camera = Camera::fit([&](const Mat3& a) { return scene.bounds(a); }, {});
  RunContext context;
  const Drawing d = illustrate(scene, camera, builtin_style("engraving"), {}, context);
  std::size_t strokes = 0, over_borders = 0;
  for (const Layer& layer : d.layers) {
    for (const Path& path : layer.paths) {
      if (path.kind != LineClass::Stroke) continue;
      ++strokes;
      over_borders += path.faces.size() > 1;
      for (const Vec3& p : path.points3) {
        EXPECT_NEAR(glm::length(p / Vec3(3, 2, 1)), 1, 2e-3);
      }
    }
  }
  EXPECT_GT(strokes, 50u);
  EXPECT_GT(over_borders, strokes / 4);
}

}  // namespace
}  // namespace burin
