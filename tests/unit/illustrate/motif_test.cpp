// Motifs on points: each against what its path is on a surface whose geodesics are known.
#include <burin/base/error.h>
#include <burin/forms/charted/nurbs.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/forms/patches/parametric_form.h>
#include <burin/illustrate/illustrate.h>

#include <burin_test/nurbs_shapes.h>
#include <burin_test/shapes.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

namespace burin {
namespace {

constexpr double kSize = 6;  // paper mm
const std::string kCircle = "M0 5A5 5 0 1 1 10 5A5 5 0 1 1 0 5Z";

Style style_of(const std::string& motif) {
  Style style = builtin_style("engraving");
  style.hatch.placing = "discs";
  style.hatch.motif = motif;
  style.hatch.length = kSize;
  style.hatch.length_min = 0;
  style.hatch.field.name = "fixed";
  style.tone = {.law = "constant", .ambient = 0.8, .highlight = 1, .rim = 0};
  return style;
}

Drawing draw_motif(std::shared_ptr<const Form> form, const Style& style,
                   const char* view = "front") {
  Scene scene;
  scene.parts.push_back({"part", "part", std::move(form)});
  RunContext context;
  const NamedView v = named_view(view);
  const Camera camera = Camera::fit([&](const Mat3& axes) { return scene.bounds(axes); },
                                    {.direction = v.direction, .up = v.up, .paper = {120, 120}});
  return illustrate(scene, camera, style, {}, context);
}

std::vector<Path> strokes_of(const Drawing& drawing) {
  std::vector<Path> strokes;
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      if (path.kind == LineClass::Stroke) strokes.push_back(path);
    }
  }
  return strokes;
}

std::shared_ptr<const Form> exact(const NurbsData& nurbs) {
  return std::make_shared<ParametricForm>(
      std::vector<std::shared_ptr<const Chart>>{make_nurbs_chart(nurbs)});
}

TEST(Motifs, ACircleOnABallIsOneAsFarFromItsMiddleAsItsRadius) {
  constexpr double kRadius = 10;
  const auto mesh =
      std::make_shared<MeshForm>(test::ellipsoid({kRadius, kRadius, kRadius}, 192, 96));
  for (const bool faceted : {false, true}) {
    SCOPED_TRACE(faceted);
    const Drawing drawing = draw_motif(
        faceted ? std::static_pointer_cast<const Form>(mesh) : exact(test::sphere_nurbs(kRadius)),
        style_of(kCircle));
    int whole = 0;
    for (const Path& path : strokes_of(drawing)) {
      if (!path.closed) continue;
      ++whole;
      Vec3 sum(0);
      for (std::size_t i = 0; i < path.points3.size(); ++i) {
        const Vec3 a = path.points3[i], b = path.points3[(i + 1) % path.points3.size()];
        sum += glm::distance(a, b) * (a + b);  // points do not stand evenly
      }
      const Vec3 middle = glm::normalize(sum);
      // On the sphere the circle of all places r away by the shortest way.
      const double angle = 0.5 * kSize / drawing.view.scale / kRadius;
      for (const Vec3& p : path.points3) {
        const double off = std::acos(glm::dot(glm::normalize(p), middle));
        EXPECT_NEAR(off, angle, (faceted ? 0.03 : 0.01) * angle);
        EXPECT_NEAR(glm::length(p), kRadius, (faceted ? 2e-3 : 1e-6) * kRadius);
      }
    }
    EXPECT_GT(whole, 30);
  }
}

TEST(Motifs, LieAlongTheFieldAndHaveTheSizeThatTheLawOfLengthSays) {
  Style style = style_of("M3 3h7");
  style.hatch.field.direction = {1, 0, 1};
  style.hatch.length_law = "0.5 + step(z)";
  style.hatch.tone_min = 0.01;
  const Drawing drawing = draw_motif(exact(test::front_sheet()), style);
  const auto strokes = strokes_of(drawing);
  ASSERT_GT(strokes.size(), 50);
  int large = 0;
  for (const Path& path : strokes) {
    const Vec3 way = path.points3.back() - path.points3.front(),
               middle = 0.5 * (path.points3.back() + path.points3.front());
    if (std::max(std::abs(middle.x), std::abs(middle.z)) > 16) continue;  // cut at the border
    EXPECT_NEAR(glm::length(glm::cross(glm::normalize(way), glm::normalize(Vec3(1, 0, 1)))), 0,
                1e-6);
    EXPECT_GT(way.x, 0) << "from left to right";
    const double size = glm::length(way) * drawing.view.scale / kSize;
    if (std::abs(middle.z) > 0.5) {
      EXPECT_NEAR(size, middle.z > 0 ? 1.5 : 0.5, 0.01);
    }
    large += middle.z > 0.5;
  }
  EXPECT_GT(large, 10);
}

TEST(Motifs, StandUprightAsTheyAreDrawn) {
  // An L: of its three corners the one with the right angle is at the lower left.
  Style style = style_of("M0 0V10H10");
  style.hatch.field.direction = {1, 0, 0};
  int seen = 0;
  for (const Path& path : strokes_of(draw_motif(exact(test::front_sheet()), style))) {
    const Vec3 corner = path.points3[path.points3.size() / 2];
    if (std::max(std::abs(corner.x), std::abs(corner.z)) > 16) continue;  // cut at the border
    ASSERT_EQ(path.points.size(), 3);
    ++seen;
    EXPECT_NEAR(path.points[0].x, path.points[1].x, 1e-6);
    EXPECT_NEAR(path.points[0].y - path.points[1].y, kSize, 1e-3);
    EXPECT_NEAR(path.points[2].x - path.points[1].x, kSize, 1e-3);
  }
  EXPECT_GT(seen, 20);
}

TEST(Motifs, EndAtCreases) {
  const Drawing drawing = draw_motif(std::make_shared<MeshForm>(test::box({0, 0, 0}, {10, 10, 10})),
                                     style_of(kCircle), "iso");
  int cut = 0;
  for (const Path& path : strokes_of(drawing)) {
    cut += !path.closed;
    // All of it lies on one plane of the box.
    int planes = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const auto [low, high] =
          std::ranges::minmax(path.points3, {}, [axis](Vec3 p) { return p[axis]; });
      planes += high[axis] - low[axis] < 1e-6;
    }
    EXPECT_GE(planes, 1);
  }
  EXPECT_GT(cut, 5);
}

TEST(Motifs, KeepClearOnDiscsAndKeepTheTone) {
  Style style = style_of(kCircle);
  style.tone.ambient = 0.3;
  const Drawing drawing = draw_motif(exact(test::sphere_nurbs(10)), style);
  std::vector<Vec2> middles;
  for (const Path& path : strokes_of(drawing)) {
    if (!path.closed) continue;
    const auto [x0, x1] = std::ranges::minmax(path.points, {}, [](Vec2 p) { return p.x; });
    const auto [y0, y1] = std::ranges::minmax(path.points, {}, [](Vec2 p) { return p.y; });
    middles.emplace_back(0.5 * (x0.x + x1.x), 0.5 * (y0.y + y1.y));
  }
  ASSERT_GT(middles.size(), 40);
  for (std::size_t i = 0; i < middles.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_GT(glm::distance(middles[i], middles[j]), 0.95 * kSize);
  }
}

TEST(Motifs, AreDrawnWholeOrNotByTheLawOfPresence) {
  // Two strokes each.
  Style style = style_of("M0 0L10 10M0 10L10 0");
  const std::size_t all = strokes_of(draw_motif(exact(test::sphere_nurbs(10)), style)).size();
  style.hatch.presence_law = "0.5";
  const auto some = strokes_of(draw_motif(exact(test::sphere_nurbs(10)), style));
  EXPECT_NEAR(static_cast<double>(some.size()) / static_cast<double>(all), 0.5, 0.2);
  // Each has another that crosses it in the middle.
  const auto middle_of = [](const Path& path) {
    return 0.5 * (path.points3.front() + path.points3.back());
  };
  for (const Path& a : some) {
    const Vec3 middle = middle_of(a);
    if (std::abs(middle.x) > 6 || std::abs(middle.z) > 6) continue;
    EXPECT_TRUE(std::ranges::any_of(some, [&](const Path& b) {
      return &a != &b && glm::distance(middle_of(b), middle) < 0.1;
    }));
  }
}

TEST(Motifs, ThatAreNoPathsEndInOneLineThatNamesTheKey) {
  Style style = style_of("M0 0L");
  try {
    draw_motif(exact(test::sphere_nurbs(10)), style);
    FAIL() << "it was drawn";
  } catch (const UsageError& e) {
    EXPECT_EQ(std::string(e.what()),
              "style key 'hatch.motif': column 6: the path ends where a number follows L");
  }
}

}  // namespace
}  // namespace burin
