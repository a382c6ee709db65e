#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/drawing/writers.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/illustrate/illustrate.h>

#include "burin_test/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <sstream>

namespace burin {
namespace {

Scene scene_of(std::vector<TriMesh> meshes) {
  Scene scene;
  for (TriMesh& m : meshes) {
    scene.parts.push_back({"part", "part.stl", std::make_shared<MeshForm>(std::move(m))});
  }
  return scene;
}

Camera camera_for(const Scene& scene, const char* view) {
  const NamedView v = named_view(view);
  return Camera::fit([&](const Mat3& axes) { return scene.bounds(axes); },
                     {.direction = v.direction, .up = v.up, .paper = {100, 80}});
}

Drawing draw(const Scene& scene, const char* view, const char* style,
             HiddenLines hidden = HiddenLines::None) {
  RunContext context;
  return illustrate(scene, camera_for(scene, view), builtin_style(style), {.hidden = hidden},
                    context);
}

double length(const Path& path) {
  double sum = 0;
  const std::size_t n = path.points.size();
  for (std::size_t i = 0; i + (path.closed ? 0 : 1) < n; ++i) {
    sum += glm::length(path.points[(i + 1) % n] - path.points[i]);
  }
  return sum;
}

// Total length on paper of the paths of each layer.
std::map<std::string, double> lengths(const Drawing& drawing) {
  std::map<std::string, double> out;
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) out[layer.name] += length(path);
  }
  return out;
}

std::string json(const Drawing& drawing) {
  RunContext context;
  std::ostringstream out;
  write_json(drawing, {}, out, context);
  return out.str();
}

TEST(Illustrate, ABoxHasItsOutlineItsThreeInnerEdgesAndNothingElse) {
  const Scene scene = scene_of({test::box({0, 0, 0}, {10, 10, 10})});
  const Drawing d = draw(scene, "iso", "outline");
  const double edge = 10 * std::sqrt(2.0 / 3) * camera_for(scene, "iso").scale();
  const auto l = lengths(d);
  ASSERT_EQ(l.size(), 2u);
  EXPECT_NEAR(l.at("outline"), 6 * edge, 1e-6);
  EXPECT_NEAR(l.at("crease"), 3 * edge, 1e-6);
  const auto with_hidden = lengths(draw(scene, "iso", "outline", HiddenLines::Dashed));
  EXPECT_NEAR(with_hidden.at("hidden"), 3 * edge, 1e-6);
}

TEST(Illustrate, PointsAreTheProjectionOfTheirModelPoints) {
  const Scene scene = scene_of({test::torus(20, 8, 64, 32), test::box({-5, -5, -30}, {5, 5, -8})});
  const Camera camera = camera_for(scene, "iso");
  const Drawing d = draw(scene, "iso", "engraving");
  std::size_t points = 0;
  for (const Layer& layer : d.layers) {
    for (const Path& path : layer.paths) {
      ASSERT_EQ(path.points.size(), path.points3.size());
      EXPECT_GE(path.source.part, 0);
      EXPECT_GE(path.source.face, 0);
      for (std::size_t i = 0; i < path.points.size(); ++i, ++points) {
        ASSERT_LT(glm::length(camera.to_paper(path.points3[i]) - path.points[i]), 1e-9);
      }
      if (path.kind == LineClass::Stroke) {
        EXPECT_TRUE(path.family == 1 || path.family == 2);
        EXPECT_FALSE(path.field.empty());
        EXPECT_EQ(path.width.size(), path.points.size());
      }
    }
  }
  EXPECT_GT(points, 2000u);
}

TEST(Illustrate, AMovedOrScaledPartDrawsTheSame) {
  const TriMesh torus = test::torus(20, 8, 64, 32), box = test::box({-40, -3, -3}, {40, 3, 3});
  const auto reference = lengths(draw(scene_of({torus, box}), "iso", "outline"));
  for (const double scale : {1e-3, 1.0, 1e4}) {
    for (const Vec3 move : {Vec3(0), Vec3(1e5, -2e4, 7e4)}) {
      if (scale < 1 && move != Vec3(0))
        continue;  // 1e5 away, doubles keep 1e-11 mm: of a part of 0.05 mm that shows
      const auto map = [&](Vec3 p) { return scale * p + move; };
      const auto moved = lengths(
          draw(scene_of({test::mapped(torus, map), test::mapped(box, map)}), "iso", "outline"));
      ASSERT_EQ(moved.size(), reference.size());
      for (const auto& [layer, l] : reference)
        EXPECT_NEAR(moved.at(layer), l, 0.02) << layer << " " << scale;
    }
  }
}

TEST(Illustrate, SameBytesForAnyNumberOfThreads) {
  const Scene scene = scene_of({test::torus(20, 8, 64, 32), test::box({-40, -3, -3}, {40, 3, 3})});
  std::set<std::string> outputs;
  for (const int threads : {1, 2, 3, 0}) {
    const ThreadLimit limit(threads);
    outputs.insert(json(draw(scene, "iso", "engraving")));
  }
  EXPECT_EQ(outputs.size(), 1u);
}

TEST(Illustrate, OutlineAloneHasNoStrokesAndStylesDiffer) {
  const Scene scene = scene_of({test::torus(20, 8, 64, 32)});
  EXPECT_EQ(draw(scene, "iso", "outline").stats.strokes, 0);
  const auto technical = draw(scene, "iso", "technical").stats.strokes;
  const auto engraving = draw(scene, "iso", "engraving").stats.strokes;
  EXPECT_GT(technical, 20);
  EXPECT_GT(engraving, technical);
}

TEST(Illustrate, PerspectiveDrawsOnTheSheet) {
  const Scene scene = scene_of({test::torus(20, 8, 64, 32)});
  const Camera camera = Camera::fit([&](const Mat3& axes) { return scene.bounds(axes); },
                                    {.perspective = 45, .paper = {100, 80}});
  RunContext context;
  const Drawing d = illustrate(scene, camera, builtin_style("engraving"), {}, context);
  EXPECT_EQ(d.view.projection, "perspective");
  EXPECT_GT(d.stats.strokes, 100);
  for (const Layer& layer : d.layers) {
    for (const Path& path : layer.paths) {
      for (const Vec2& p : path.points) {
        EXPECT_GE(p.x, 9.9);
        EXPECT_LE(p.x, 90.1);
        EXPECT_GE(p.y, 9.9);
        EXPECT_LE(p.y, 70.1);
      }
    }
  }
}

TEST(Illustrate, RefusesAnEmptySceneAndStopsWhenCancelled) {
  const Scene scene = scene_of({test::torus(20, 8, 64, 32)});
  RunContext context;
  EXPECT_THROW(illustrate({}, camera_for(scene, "iso"), builtin_style("outline"), {}, context),
               GeometryError);
  context.cancel();
  EXPECT_THROW(illustrate(scene, camera_for(scene, "iso"), builtin_style("outline"), {}, context),
               Cancelled);
}

}  // namespace
}  // namespace burin
