#include <burin/base/error.h>
#include <burin/camera/view_grid.h>

#include <gtest/gtest.h>

#include <cmath>

namespace burin {
namespace {

const Box2 kFrame{{10, 10}, {410, 287}};

/// A block of 60 x 40 x 20 mm.
std::vector<GridView> block_of(std::vector<std::string> names) {
  std::vector<GridView> views;
  for (std::string& name : names) {
    const Vec2 size = name == "front" || name == "back"   ? Vec2(60, 20)
                      : name == "top" || name == "bottom" ? Vec2(60, 40)
                      : name == "left" || name == "right" ? Vec2(40, 20)
                                                          : Vec2(70, 60);
    views.push_back({std::move(name), size});
  }
  return views;
}

TEST(ViewGrid, FirstAnglePutsTheViewFromTheLeftToTheRightAndThatFromAboveBelow) {
  const auto views = block_of({"front", "top", "left", "right", "bottom", "back"});
  const ViewGrid g = arrange_views(views, ProjectionMethod::FirstAngle, kFrame, 12, {});
  const auto at = [&](std::size_t i) { return g.boxes[i].center(); };
  EXPECT_LT(at(1).y, at(0).y);
  EXPECT_GT(at(2).x, at(0).x);
  EXPECT_LT(at(3).x, at(0).x);
  EXPECT_GT(at(4).y, at(0).y);
  EXPECT_GT(at(5).x, at(2).x);
  const ViewGrid t = arrange_views(views, ProjectionMethod::ThirdAngle, kFrame, 12, {});
  EXPECT_GT(t.boxes[1].center().y, t.boxes[0].center().y);
  EXPECT_LT(t.boxes[2].center().x, t.boxes[0].center().x);
  EXPECT_GT(t.boxes[3].center().x, t.boxes[0].center().x);
}

TEST(ViewGrid, RowsAndColumnsHaveOneMiddleAndNothingOverlaps) {
  const auto views = block_of({"front", "top", "left", "iso", "dimetric"});
  for (const auto method : {ProjectionMethod::FirstAngle, ProjectionMethod::ThirdAngle}) {
    const ViewGrid g = arrange_views(views, method, kFrame, 12, {});
    EXPECT_DOUBLE_EQ(g.boxes[0].center().x, g.boxes[1].center().x);
    EXPECT_DOUBLE_EQ(g.boxes[0].center().y, g.boxes[2].center().y);
    EXPECT_DOUBLE_EQ(g.boxes[1].center().y, g.boxes[3].center().y);
    for (std::size_t i = 0; i < views.size(); ++i) {
      const Vec2 size = g.boxes[i].size();
      EXPECT_GE(size.x, g.scale * views[i].size.x - 1e-9);
      EXPECT_GE(size.y, g.scale * views[i].size.y - 1e-9);
      for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(g.boxes[i].overlaps(g.boxes[j]));
    }
  }
}

TEST(ViewGrid, FillsTheFrameAndNoMore) {
  auto views = block_of({"front", "top", "left", "iso"});
  views[3].room = {5, 25, 5, 25};
  const ViewGrid g = arrange_views(views, ProjectionMethod::FirstAngle, kFrame, 12, {});
  const Vec2 left = kFrame.size() - g.box.size();
  EXPECT_GE(std::min(left.x, left.y), -1e-9);
  EXPECT_NEAR(std::min(left.x, left.y), 0, 1e-6);
  EXPECT_NEAR(g.boxes[3].size().x, std::max(g.scale * 70 + 50, g.scale * 40), 1e-9);
  const ViewGrid given = arrange_views(views, ProjectionMethod::FirstAngle, kFrame, 12, 0.5);
  EXPECT_DOUBLE_EQ(given.scale, 0.5);
  EXPECT_LT(glm::distance(given.box.center(), kFrame.center()), 1e-9);
}

TEST(ViewGrid, RoomOfOneSideIsTakenThereAndMiddlesStayInLine) {
  auto views = block_of({"front", "top", "left"});
  views[0].room = Margin(0, 0, 20, 0);  // below
  views[1].room = Margin(0, 0, 0, 15);  // at the left
  const ViewGrid g = arrange_views(views, ProjectionMethod::FirstAngle, kFrame, 12, 1);
  EXPECT_NEAR(g.middles[0].y - g.boxes[0].min.y, 0.5 * views[0].size.y + 20, 1e-9);
  EXPECT_NEAR(g.boxes[0].max.y - g.middles[0].y, 0.5 * views[0].size.y, 1e-9);
  EXPECT_NEAR(g.middles[1].x - g.boxes[1].min.x, 0.5 * views[1].size.x + 15, 1e-9);
  EXPECT_DOUBLE_EQ(g.middles[0].y, g.middles[2].y);
  EXPECT_DOUBLE_EQ(g.middles[0].x, g.middles[1].x);
}

TEST(ViewGrid, EmptyLanesTakeNoRoom) {
  const ViewGrid one =
      arrange_views(block_of({"iso"}), ProjectionMethod::FirstAngle, kFrame, 12, {});
  EXPECT_LT(glm::distance(one.boxes[0].center(), kFrame.center()), 1e-9);
  EXPECT_NEAR(one.scale, std::min(400.0 / 70, 277.0 / 60), 1e-9);
}

TEST(ViewGrid, WithoutAViewFromAbovePictorialOnesStandBesideTheFront) {
  for (const auto method : {ProjectionMethod::FirstAngle, ProjectionMethod::ThirdAngle}) {
    const ViewGrid g = arrange_views(block_of({"iso", "front", "left"}), method, kFrame, 12, {});
    EXPECT_DOUBLE_EQ(g.boxes[0].center().y, g.boxes[1].center().y);
    EXPECT_GT(g.boxes[0].min.x, std::max(g.boxes[1].max.x, g.boxes[2].max.x));
  }
}

TEST(ViewGrid, RefusesWhatHasNoRoomOrNoExtent) {
  const Box2 tiny{{0, 0}, {20, 20}};
  EXPECT_THROW(arrange_views(block_of({"front", "left", "right"}), ProjectionMethod::FirstAngle,
                             tiny, 12, {}),
               UsageError);
  const std::vector<GridView> point{{"front", Vec2(0)}};
  EXPECT_THROW(arrange_views(point, ProjectionMethod::FirstAngle, kFrame, 12, {}), GeometryError);
}

TEST(ViewGrid, FromBelowTheFrontIsAtTheTop) {
  const NamedView below = view_in_grid("bottom"), front = view_in_grid("front");
  const auto right = [](const NamedView& v) { return glm::cross(v.up, v.direction); };
  EXPECT_LT(glm::distance(right(below), right(front)), 1e-12);
  EXPECT_GT(glm::dot(below.up, front.direction), 0.9);
}

TEST(Scales, AreThoseOfTheStandard) {
  EXPECT_DOUBLE_EQ(standard_scale(7.3), 5);
  EXPECT_DOUBLE_EQ(standard_scale(10), 10);
  EXPECT_DOUBLE_EQ(standard_scale(1.99), 1);
  EXPECT_DOUBLE_EQ(standard_scale(0.3), 0.2);
  EXPECT_EQ(scale_text(5), "5:1");
  EXPECT_EQ(scale_text(0.2), "1:5");
  EXPECT_EQ(scale_text(1), "1:1");
}

TEST(Camera, MagnifiedShowsTheSameFromTheSamePlace) {
  for (const std::optional<double> angle : {std::optional<double>(), std::optional(40.0)}) {
    ViewOptions options;
    options.perspective = angle;
    const Camera whole = Camera::fit(
        [](const Mat3& axes) {
          Box3 box;
          for (int i = 0; i < 8; ++i) {
            box.add(axes * Vec3(i & 1 ? 30 : -30, i & 2 ? 20 : -20, i & 4 ? 10 : -10));
          }
          return box;
        },
        options);
    const Vec3 p(12, -7, 5), q(14, -6, 9);
    const Camera large = whole.magnified(4, whole.to_paper(p), {250, 40});
    EXPECT_LT(glm::distance(large.to_paper(p), Vec2(250, 40)), 1e-9);
    EXPECT_LT(glm::distance(large.to_paper(q) - large.to_paper(p),
                            4.0 * (whole.to_paper(q) - whole.to_paper(p))),
              1e-9);
    EXPECT_LT(glm::distance(large.to_viewer(q), whole.to_viewer(q)), 1e-12);
    const ViewRay ray = large.ray(large.to_paper(q));
    EXPECT_LT(glm::length(glm::cross(ray.direction, q - ray.origin)), 1e-9);
  }
}

}  // namespace
}  // namespace burin
