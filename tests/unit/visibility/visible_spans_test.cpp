#include <burin/base/parallel.h>

#include <burin_test/view.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace burin {
namespace {

using test::View;

struct Ink {
  int visible = 0, hidden = 0;  // spans
  double length = 0;            // visible paper mm
};

[[maybe_unused]] Ink ink(const View& view) {
  Ink out;
  for (std::size_t c = 0; c < view.features.size(); ++c) {
    for (const Span& s : view.spans[c]) {
      (s.visible ? out.visible : out.hidden)++;
      if (s.visible)
        out.length += test::paper_length(view.camera, view.features[c], s.begin, s.end);
    }
  }
  return out;
}

// Segments of the creases of boxes that are seen; chains may hold several edges.
int visible_box_edges(const View& view, double edge) {
  double length = 0;
  for (std::size_t c = 0; c < view.features.size(); ++c) {
    for (const Span& s : view.spans[c]) {
      if (!s.visible) continue;
      const Curve3 part = slice(view.features[c], s.begin, s.end);
      for (std::size_t i = 0; i < part.segment_count(); ++i) {
        length += glm::length(part.points[part.next(i)] - part.points[i]);
      }
    }
  }
  return static_cast<int>(std::lround(length / edge));
}

TEST(VisibleSpans, ShowsNineEdgesOfABox) {
  for (const bool perspective : {false, true}) {
    ViewOptions options;
    if (perspective) options.perspective = 30;
    const View view({test::box({0, 0, 0}, {1, 1, 1})}, options);
    EXPECT_EQ(visible_box_edges(view, 1), 9);
  }
}

// Two boxes along x, looked at from +x and a little from above: the far one rises behind the near
// one.
TEST(VisibleSpans, CutsTheFarBoxExactlyAtTheNearOne) {
  ViewOptions options;
  options.direction = {1, 0.3, 0.5};
  const View view({test::box({0, -1, 0}, {1, 1, 2}), test::box({3, -0.4, 0}, {4, 0.3, 1.5})},
                  options);
  // Against dense rays along every edge.
  for (std::size_t c = 0; c < view.features.size(); ++c) {
    const Curve3& curve = view.features[c];
    for (const Span& s : view.spans[c]) {
      for (const double end : {s.begin, s.end}) {
        if (end == std::floor(end)) continue;
        // A cut inside a segment lies on a segment of the near box in the picture.
        const Vec2 p = view.camera.to_paper(test::point_at(curve, end));
        double nearest = 1e9;
        for (const Curve3& other : view.features) {
          if (other.source.part != 1) continue;
          for (std::size_t i = 0; i < other.segment_count(); ++i) {
            const Vec2 a = view.camera.to_paper(other.points[i]);
            const Vec2 b = view.camera.to_paper(other.points[other.next(i)]);
            const double t = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
            nearest = std::min(nearest, glm::length(glm::mix(a, b, t) - p));
          }
        }
        EXPECT_LT(nearest, 1e-9);
      }
    }
  }
}

// A line behind a box: hidden exactly where the box's faces cover it.
TEST(VisibleSpans, HidesALineBehindABoxExactly) {
  for (const bool perspective : {false, true}) {
    ViewOptions options;
    options.direction = {0, 0, 1};
    options.up = {0, 1, 0};
    if (perspective) options.perspective = 40;
    const View view({test::box({-1, -1, 0}, {1, 1, 1}), test::box({-4, -4, -3}, {4, 4, -2.5})},
                    options);
    const Curve3 across = test::line({-3, 0.25, -2}, {3, 0.25, -2}, 7);
    const auto spans = view.classify(across);
    ASSERT_EQ(spans.size(), 3u);
    EXPECT_TRUE(spans[0].visible);
    EXPECT_FALSE(spans[1].visible);
    EXPECT_TRUE(spans[2].visible);
    double half = 1;
    if (perspective) {
      const double eye = view.camera.eye().z;
      half = (eye + 2) / (eye - 1);  // the near rim of the box as seen in the plane z = -2
    }
    EXPECT_NEAR(test::point_at(across, spans[0].end).x, -half, 1e-9);
    EXPECT_NEAR(test::point_at(across, spans[1].end).x, half, 1e-9);
  }
}

TEST(VisibleSpans, CutsAtTheContourOfASphere) {
  for (const bool perspective : {false, true}) {
    ViewOptions options;
    options.direction = {0, 0, 1};
    options.up = {0, 1, 0};
    if (perspective) options.perspective = 40;
    const std::uint32_t n = 160;
    const View view({test::ellipsoid({1, 1, 1}, n, n / 2), test::box({-2, -2, -3}, {2, 2, -2.5})},
                    options);
    const double sagitta = test::kPi * test::kPi / (2.0 * n * n) * 4;
    double wanted = 1;
    if (perspective) {
      const double eye = view.camera.eye().z;  // tangent cone of the ball at the depth of the line
      wanted = (eye + 2) * std::tan(std::asin(1 / eye));
    }
    const Curve3 across = test::line({-1.9, 0.0, -2}, {1.9, 0.0, -2}, 11);
    const auto spans = view.classify(across);
    ASSERT_EQ(spans.size(), 3u);
    EXPECT_FALSE(spans[1].visible);
    EXPECT_NEAR(test::point_at(across, spans[0].end).x, -wanted, 2 * sagitta * wanted);
    EXPECT_NEAR(test::point_at(across, spans[1].end).x, wanted, 2 * sagitta * wanted);
  }
}

TEST(VisibleSpans, ShowsTheWholeContourOfABall) {
  const View view({test::ellipsoid({1, 1, 1}, 60, 30)}, {});
  ASSERT_EQ(view.features.size(), 1u);
  ASSERT_EQ(view.spans[0].size(), 1u);
  EXPECT_TRUE(view.spans[0][0].visible);
}

TEST(VisibleSpans, SlicesOpenCurves) {
  Curve3 c = test::line({0, 0, 0}, {4, 0, 0}, 4);
  c.widths = {0, 1, 2, 3, 4};
  c.faces = {10, 11, 12, 13};
  c.self_hidden = {0, 1, 0, 1};
  c.normals.assign(5, Vec3(0, 0, 1));
  const Curve3 part = slice(c, 0.5, 2.25);
  ASSERT_EQ(part.points.size(), 4u);
  EXPECT_EQ(part.points[0].x, 0.5);
  EXPECT_EQ(part.points[1].x, 1);
  EXPECT_EQ(part.points[3].x, 2.25);
  EXPECT_EQ(part.widths[3], 2.25);
  EXPECT_EQ(part.faces, (std::vector<std::int32_t>{10, 11, 12}));
  EXPECT_EQ(part.self_hidden, (std::vector<std::uint8_t>{0, 1, 0}));
  EXPECT_EQ(part.normals.size(), 4u);
  const Curve3 whole = slice(c, 0, 4);
  EXPECT_EQ(whole.points.size(), 5u);
  EXPECT_EQ(whole.faces.size(), 4u);
  const Curve3 one = slice(c, 2, 3);
  ASSERT_EQ(one.points.size(), 2u);
  EXPECT_EQ(one.points[0].x, 2);
  EXPECT_EQ(one.points[1].x, 3);
  EXPECT_EQ(one.faces, (std::vector<std::int32_t>{12}));
}

TEST(VisibleSpans, SlicesClosedCurvesOverTheirStart) {
  Curve3 c;
  c.closed = true;
  c.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  c.faces = {1, 2, 3, 4};
  const Curve3 part = slice(c, 3.5, 5.5);
  ASSERT_EQ(part.points.size(), 4u);
  EXPECT_FALSE(part.closed);
  EXPECT_EQ(part.points[0], Vec3(0, 0.5, 0));
  EXPECT_EQ(part.points[1], Vec3(0, 0, 0));
  EXPECT_EQ(part.points[2], Vec3(1, 0, 0));
  EXPECT_EQ(part.points[3], Vec3(1, 0.5, 0));
  EXPECT_EQ(part.faces, (std::vector<std::int32_t>{4, 1, 2}));
  const Curve3 turn = slice(c, 2, 6);
  EXPECT_TRUE(turn.closed);
  EXPECT_EQ(turn.points[0], Vec3(1, 1, 0));
  EXPECT_EQ(turn.faces, (std::vector<std::int32_t>{3, 4, 1, 2}));
  EXPECT_TRUE(slice(c, 0, 4).closed);
}

}  // namespace
}  // namespace burin
