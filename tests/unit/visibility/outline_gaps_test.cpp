// Gaps of the outer outline are closed along the border that rays see.
#include <burin/visibility/outline_gaps.h>

#include <burin_test/view.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

using test::View;

/// Hides a stretch of the longest outer contour, as if it had been missed; its ends on paper.
std::pair<Vec2, Vec2> make_gap(View& view, double share) {
  std::size_t longest = 0;
  for (std::size_t c = 0; c < view.features.size(); ++c) {
    const bool longer = view.features[c].points.size() > view.features[longest].points.size();
    if (longer && view.features[c].kind == LineClass::Contour) longest = c;
  }
  const Curve3& curve = view.features[longest];
  const auto count = static_cast<double>(curve.segment_count());
  const double from = std::floor(0.3 * count), to = std::floor((0.3 + share) * count);
  view.spans[longest] = {{.begin = 0, .end = from, .visible = true, .outer = true},
                         {.begin = from, .end = to, .visible = false},
                         {.begin = to, .end = count, .visible = true, .outer = true}};
  const auto paper = [&](double at) {
    return view.camera.to_paper(curve.points[static_cast<std::size_t>(at)]);
  };
  return {paper(from), paper(to)};
}

std::vector<Curve3> gaps_of(const View& view) {
  return outline_gaps(*view.occluder, view.pointers, view.camera, view.features, view.spans,
                      view.context);
}

TEST(OutlineGaps, AreClosedAlongTheBorder) {
  const double radius = 10;
  for (const double perspective : {0.0, 30.0}) {
    ViewOptions options;
    if (perspective > 0) options.perspective = perspective;
    View view({test::ellipsoid(Vec3(radius), 400, 200)}, options, {.classify_outer = true});
    const auto [a, b] = make_gap(view, 0.02);
    ASSERT_GT(glm::distance(a, b), 2);
    const std::vector<Curve3> gaps = gaps_of(view);
    ASSERT_EQ(gaps.size(), 1U);
    const Curve3& gap = gaps[0];
    EXPECT_EQ(gap.kind, LineClass::Contour);
    EXPECT_EQ(gap.faces.size(), gap.segment_count());
    const Vec2 first = view.camera.to_paper(gap.points.front());
    const Vec2 last = view.camera.to_paper(gap.points.back());
    EXPECT_LT(std::min(glm::distance(first, a), glm::distance(first, b)), 1e-9);
    EXPECT_LT(std::min(glm::distance(last, a), glm::distance(last, b)), 0.25);
    EXPECT_GT(glm::distance(first, last), glm::distance(a, b) - 0.25);
    // The ball is seen as a circle around the middle of the sheet.
    const Vec2 middle = view.camera.to_paper(Vec3(0));
    const double seen = glm::distance(a, middle);
    for (const Vec3& p : gap.points) {
      EXPECT_NEAR(glm::distance(view.camera.to_paper(p), middle), seen, 0.05);
    }
  }
}

TEST(OutlineGaps, AreNotLookedForWhereTheOutlineIsWhole) {
  const View view({test::torus(10, 4, 200, 100)}, {}, {.classify_outer = true});
  EXPECT_TRUE(gaps_of(view).empty());
}

TEST(OutlineGaps, LongerOnesThanTwentyMmStayOpen) {
  View view({test::ellipsoid(Vec3(10), 400, 200)}, {}, {.classify_outer = true});
  make_gap(view, 0.3);
  EXPECT_TRUE(gaps_of(view).empty());
}

TEST(OutlineGaps, RunOverTwoPartsAsOneCurveEach) {
  // Two boxes of one height side by side: the gap lies over the joint of their upper edges.
  View view({test::box({0, 0, 0}, {10, 10, 10}), test::box({10, 0, 0}, {20, 10, 10})},
            {.direction = {0, -1, 0}, .up = {0, 0, 1}}, {.classify_outer = true});
  const Vec2 joint = view.camera.to_paper({10, 0, 10});
  for (std::size_t c = 0; c < view.features.size(); ++c) {
    const Curve3& curve = view.features[c];
    const auto count = static_cast<double>(curve.segment_count());
    std::vector<Span> spans;
    const int pieces = 200 * static_cast<int>(count);
    for (int i = 0; i < pieces; ++i) {
      const double from = count * i / pieces, to = count * (i + 1) / pieces;
      const Curve3 part = slice(curve, from, to);
      const bool near = glm::distance(view.camera.to_paper(part.points[0]), joint) < 3 ||
                        glm::distance(view.camera.to_paper(part.points.back()), joint) < 3;
      Span span{.begin = from, .end = to};
      const auto& known = view.spans[c];
      const auto at = std::ranges::find_if(known, [&](const Span& s) {
        return s.begin <= 0.5 * (from + to) && 0.5 * (from + to) < s.end;
      });
      ASSERT_NE(at, known.end());
      span.visible = at->visible && !near;
      span.outer = at->outer && !near;
      spans.push_back(span);
    }
    view.spans[c] = spans;
  }
  const std::vector<Curve3> gaps = gaps_of(view);
  ASSERT_EQ(gaps.size(), 2U);
  EXPECT_NE(gaps[0].source.part, gaps[1].source.part);
  double length = 0;
  for (const Curve3& gap : gaps) {
    length += test::paper_length(view.camera, gap, 0, static_cast<double>(gap.segment_count()));
    for (const Vec3& p : gap.points) {
      EXPECT_NEAR(view.camera.to_paper(p).y, joint.y, 0.02);
    }
  }
  EXPECT_NEAR(length, 6.7, 0.8);  // lines are taken away in pieces of 0.7 mm
}

}  // namespace
}  // namespace burin
