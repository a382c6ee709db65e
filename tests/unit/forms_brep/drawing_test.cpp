/// Drawings of trimmed faces: the same for every size, place and turn, and true where parts touch.

#include <burin/illustrate/illustrate.h>

#include "brep_checks.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <map>
#include <numbers>

namespace burin {
namespace {

using test::ModelPtr;

struct View {
  Vec3 direction{1, -1, 1}, up{0, 0, 1};
  std::optional<double> perspective;
};

Part part_of(const ModelPtr& model, const Placement& placement) {
  return {"part", "", std::make_shared<BrepForm>(model, placement)};
}

Drawing draw_parts(std::vector<Part> parts, const View& view,
                   const std::string& style = "outline") {
  Scene scene;
  scene.parts = std::move(parts);
  ViewOptions options;
  options.direction = view.direction;
  options.up = view.up;
  options.perspective = view.perspective;
  const Camera camera = Camera::fit([&](const Mat3& axes) { return scene.bounds(axes); }, options);
  RunContext context;
  return illustrate(scene, camera, builtin_style(style), {}, context);
}

double length(const Path& path) {
  double sum = 0;
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    sum += glm::distance(path.points[i - 1], path.points[i]);
  }
  return path.closed ? sum + glm::distance(path.points.back(), path.points.front()) : sum;
}

std::map<std::string, double> lengths(const Drawing& drawing) {
  std::map<std::string, double> sums;
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) sums[layer.name] += length(path);
  }
  return sums;
}

double distance_to_segment(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 e = b - a;
  const double l2 = glm::dot(e, e);
  const double t = l2 > 0 ? std::clamp(glm::dot(p - a, e) / l2, 0.0, 1.0) : 0;
  return glm::distance(p, a + t * e);
}

/// The largest distance of a point of `a` from the lines of the same layer of `b`.
double farthest(const Drawing& a, const Drawing& b) {
  double most = 0;
  for (const Layer& layer : a.layers) {
    for (const Path& path : layer.paths) {
      for (const Vec2& p : path.points) {
        double least = 1e9;
        for (const Layer& other : b.layers) {
          if (other.name != layer.name) continue;
          for (const Path& q : other.paths) {
            const std::size_t n = q.points.size();
            for (std::size_t i = 0; i + (q.closed ? 0 : 1) < n; ++i) {
              least = std::min(least, distance_to_segment(p, q.points[i], q.points[(i + 1) % n]));
            }
          }
        }
        most = std::max(most, least);
      }
    }
  }
  return most;
}

Mat3 rotation(double degrees, Vec3 axis) {
  return Mat3(glm::rotate(glm::dmat4(1), degrees * std::numbers::pi / 180, glm::normalize(axis)));
}

class SameDrawing : public testing::TestWithParam<std::optional<double>> {};

TEST_P(SameDrawing, ForEverySizePlaceAndTurn) {
  const ModelPtr models[] = {make_brep_model(test::filleted_box_shape(0.4)),
                             make_brep_model(test::plate_with_hole_shape()),
                             make_brep_model(test::cylinder_shape(2, 5))};
  const Placement placements[] = {{Mat3(1e-3), Vec3(0)},
                                  {Mat3(1e3), Vec3(0)},
                                  {Mat3(1), Vec3(2e4, -1e4, 3e4)},
                                  {rotation(37, {1, 2, 3}), Vec3(5, 6, 7)},
                                  {25.4 * rotation(-111, {3, -1, 0.5}), Vec3(-100, 30, 8)}};
  for (const ModelPtr& model : models) {
    const View view{{1, -0.8, 0.6}, {0, 0, 1}, GetParam()};
    const Drawing base = draw_parts({part_of(model, {})}, view);
    const auto expected = lengths(base);
    ASSERT_GT(expected.at("outline"), 300);
    for (const Placement& placement : placements) {
      View turned = view;
      turned.direction = placement.linear * view.direction;
      turned.up = placement.linear * view.up;
      const Drawing same = draw_parts({part_of(model, placement)}, turned);
      const auto found = lengths(same);
      ASSERT_EQ(found.size(), expected.size());
      for (const auto& [layer, sum] : expected) EXPECT_NEAR(found.at(layer), sum, 0.05) << layer;
      EXPECT_LT(farthest(base, same), 0.01);
      EXPECT_LT(farthest(same, base), 0.01);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Views, SameDrawing,
                         testing::Values(std::nullopt, std::optional<double>(30)),
                         [](const auto& view) {
                           return view.param ? "Perspective" : "Orthographic";
                         });

TEST(BrepDrawing, AShaftEndsWhereItEntersItsHole) {
  // A plate of 10 x 8 x 1 with a hole of radius 2 through its middle, and a shaft of that very
  // radius that stands 7 out of its top and 2 out of its bottom.
  const ModelPtr plate = make_brep_model(test::plate_with_hole_shape());
  const ModelPtr shaft = make_brep_model(test::cylinder_shape(2, 10));
  const Box3 box = BrepForm(plate, {}).bounds(Mat3(1));
  const Vec3 c = box.center();
  const View view{{0.3, -1, 0.7}, {0, 0, 1}, std::nullopt};
  const Drawing drawing = draw_parts(
      {part_of(plate, {}), part_of(shaft, {Mat3(1), Vec3(c.x, c.y, box.min.z - 2)})}, view);
  // Both contours of the shaft are straight, and vertical on paper; of each, what stands out of the
  // top is seen. The plate hides what is below.
  const Vec3 d = glm::normalize(view.direction);
  const double seen = 7 * drawing.view.scale * std::sqrt(1 - d.z * d.z);
  double sum = 0;
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      if (path.source.part != 1 || path.kind != LineClass::Contour || path.source.edge >= 0)
        continue;
      sum += length(path);
      for (const Vec3& p : path.points3) EXPECT_GT(p.z, box.max.z - 0.1 / drawing.view.scale);
    }
  }
  EXPECT_NEAR(sum, 2 * seen, 0.4);
}

TEST(BrepDrawing, EveryLineKnowsItsFaceOrEdge) {
  const ModelPtr model = make_brep_model(test::filleted_box_shape(0.4));
  const auto counts = count(*model);
  const Drawing drawing =
      draw_parts({part_of(model, {})}, {{1, -0.8, 0.6}, {0, 0, 1}, std::nullopt});
  EXPECT_EQ(drawing.parts.at(0).faces, counts.faces);
  std::size_t smooth = 0;
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      EXPECT_TRUE(path.source.face >= 0 || path.source.edge >= 0);
      EXPECT_LT(path.source.face, counts.faces);
      EXPECT_LT(path.source.edge, counts.edges);
      if (path.kind == LineClass::Smooth) {
        ++smooth;
        EXPECT_GE(path.source.edge, 0);
      }
      EXPECT_NE(path.kind, LineClass::Crease) << "all edges of this part are smooth";
    }
  }
  // Three faces are seen, each between four fillets.
  EXPECT_GE(smooth, 12u);
}

}  // namespace
}  // namespace burin
