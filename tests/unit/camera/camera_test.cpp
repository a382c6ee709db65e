#include <burin/base/error.h>
#include <burin/camera/camera.h>
#include <burin/camera/standards.h>

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace burin {
namespace {

Camera::ExtentFn extent_of(const std::vector<Vec3>& points) {
  return [points](const Mat3& axes) {
    Box3 box;
    for (const Vec3& p : points) box.add(axes * p);
    return box;
  };
}

std::vector<Vec3> cube(double side, Vec3 at = Vec3(0)) {
  std::vector<Vec3> out;
  for (int i = 0; i < 8; ++i) out.push_back(at + side * Vec3(i & 1, (i >> 1) & 1, i >> 2));
  return out;
}

ViewOptions view(std::string_view name) {
  const NamedView v = named_view(name);
  return {.direction = v.direction, .up = v.up};
}

TEST(Camera, InsideAPlacementItShowsTheSame) {
  const Mat3 turn(0.6, 0.8, 0, -0.8, 0.6, 0, 0, 0, 1);
  const Placement place{turn * 2.5, {3, -8, 5}};
  for (const auto& perspective : {std::optional<double>(), std::optional<double>(40)}) {
    ViewOptions options = view("iso");
    options.perspective = perspective;
    const Camera camera = Camera::fit(extent_of(cube(50)), options);
    const Camera inside = camera.inside(place);
    for (const Vec3& p : cube(12, {-4, 1, 2})) {
      const Vec3 q = place.point(p);
      EXPECT_LT(glm::distance(inside.to_paper(p), camera.to_paper(q)), 1e-9);
      EXPECT_LT(glm::distance(turn * inside.to_viewer(p), camera.to_viewer(q)), 1e-12);
      EXPECT_NEAR(inside.scale_at(p), 2.5 * camera.scale_at(q), 1e-9);
      const Vec2 v = inside.velocity(p, {1, 2, 3});
      EXPECT_LT(glm::distance(v, camera.velocity(q, place.vector({1, 2, 3}))), 1e-9);
    }
    const ViewRay ray = inside.ray({100, 80}), same = camera.ray({100, 80});
    EXPECT_LT(glm::length(glm::cross(place.point(ray.origin) - same.origin, same.direction)), 1e-9);
    EXPECT_LT(glm::distance(turn * ray.direction, same.direction), 1e-12);
  }
}

TEST(Paper, KnowsIsoSheetsPortraitLetterAndSizes) {
  EXPECT_EQ(Paper::named("A4").width, 297);
  EXPECT_EQ(Paper::named("A4").height, 210);
  EXPECT_EQ(Paper::named("A4p").width, 210);
  EXPECT_EQ(Paper::named("A0").width, 1189);
  EXPECT_EQ(Paper::named("letter").height, 215.9);
  EXPECT_EQ(Paper::named("200x150.5").height, 150.5);
  for (const char* bad :
       {"A7", "A4q", "", "200", "200x", "x150", "0x100", "-5x100", "1e9x10", "nanx10", "B7"}) {
    EXPECT_THROW(Paper::named(bad), UsageError) << bad;
  }
}

TEST(Paper, StandardSheetsAreFoundByTheirNamesInAnyCase) {
  for (const StandardPaper& sheet : standard_papers()) {
    const Paper across = Paper::named(sheet.name),
                upright = Paper::named(std::string(sheet.name) + "P");
    EXPECT_EQ(across.width, sheet.longer) << sheet.name;
    EXPECT_EQ(across.height, sheet.shorter) << sheet.name;
    EXPECT_EQ(upright.width, sheet.shorter) << sheet.name;
    EXPECT_GT(sheet.longer, sheet.shorter) << sheet.name;
  }
}

TEST(NamedView, StandardViewsAreFoundByTheirNamesAndToldToWhoeverMistypesOne) {
  std::string said;
  try {
    named_view("frnt");
  } catch (const UsageError& e) {
    said = e.what();
  }
  for (const StandardView& known : standard_views()) {
    EXPECT_EQ(named_view(known.name).direction, known.view.direction) << known.name;
    EXPECT_NE(said.find(std::string(known.name) + ","), std::string::npos) << said;
  }
  EXPECT_NE(said.find("or X,Y,Z"), std::string::npos) << said;
}

TEST(NamedView, ParsesVectorsAndRefusesNonsense) {
  EXPECT_EQ(named_view("1,-2.5,3e1").direction, Vec3(1, -2.5, 30));
  EXPECT_EQ(named_view("top").up, Vec3(0, 1, 0));
  for (const char* bad : {"", "frnt", "1,2", "1,2,3,4", "0,0,0", "1,2,x", "nan,0,1", "inf,0,0"}) {
    EXPECT_THROW(named_view(bad), UsageError) << bad;
  }
}

TEST(Camera, FrontViewFitsInsideTheMarginInTheMiddle) {
  const Camera c = Camera::fit(extent_of(cube(10)), view("front"));
  EXPECT_NEAR(c.scale(), 19, 1e-12);  // 210 - 2 * 10 mm for 10 mm
  EXPECT_EQ(c.right(), Vec3(1, 0, 0));
  EXPECT_EQ(c.up(), Vec3(0, 0, 1));
  const Vec2 low = c.to_paper({0, 0, 0}), high = c.to_paper({10, 10, 10});
  EXPECT_NEAR(low.x, 297 / 2.0 - 95, 1e-12);
  EXPECT_NEAR(low.y, 10, 1e-12);
  EXPECT_NEAR(high.y, 200, 1e-12);
}

TEST(Camera, AxesAreRightHandedForEveryNamedView) {
  for (const char* name :
       {"front", "back", "left", "right", "top", "bottom", "iso", "dimetric", "trimetric"}) {
    const Camera c = Camera::fit(extent_of(cube(1)), view(name));
    EXPECT_LT(glm::length(glm::cross(c.right(), c.up()) - c.direction()), 1e-15) << name;
  }
  const Camera top = Camera::fit(extent_of(cube(1)), view("top"));
  EXPECT_EQ(top.right(), Vec3(1, 0, 0));
  EXPECT_EQ(top.up(), Vec3(0, 1, 0));
}

TEST(Camera, IsometricShortensAllAxesAlikeAndDimetricOneByHalf) {
  const auto lengths = [](const char* name) {
    const Camera c = Camera::fit(extent_of(cube(1)), view(name));
    Vec3 l;
    for (int i = 0; i < 3; ++i) {
      Vec3 e(0);
      e[i] = 1;
      l[i] = glm::length(c.velocity({0, 0, 0}, e)) / c.scale();
    }
    return l;
  };
  const Vec3 iso = lengths("iso");
  EXPECT_NEAR(iso.x, std::sqrt(2.0 / 3), 1e-12);
  EXPECT_NEAR(iso.y, iso.x, 1e-12);
  EXPECT_NEAR(iso.z, iso.x, 1e-12);
  const Vec3 di = lengths("dimetric");
  EXPECT_NEAR(di.x, di.z, 1e-4);
  EXPECT_NEAR(di.y / di.x, 0.5, 1e-3);
}

TEST(Camera, UpAlongTheViewTakesAnotherAxis) {
  const Camera c = Camera::fit(extent_of(cube(1)), {.direction = {0, 0, 1}, .up = {0, 0, 5}});
  EXPECT_EQ(c.up(), Vec3(0, 1, 0));
}

TEST(Camera, PerspectiveKeepsTheAngleAndStaysOnTheSheet) {
  const auto points = cube(10, {100, 200, -50});
  ViewOptions options = view("iso");
  options.perspective = 40;
  const Camera c = Camera::fit(extent_of(points), options);
  Box2 box;
  for (const Vec3& p : points) box.add(c.to_paper(p));
  EXPECT_GE(box.min.x, 10 - 1e-9);
  EXPECT_GE(box.min.y, 10 - 1e-9);
  EXPECT_LE(box.max.x, 287 + 1e-9);
  EXPECT_LE(box.max.y, 200 + 1e-9);
  EXPECT_NEAR(std::max(box.size().x / 277, box.size().y / 190), 1, 1e-9);  // and touches it
  // The inner height, 190 mm in the plane of the centre, is seen under the angle asked for.
  const double distance = glm::length(c.eye() - c.center());
  EXPECT_NEAR(2 * std::atan(95 / c.scale() / distance) * 180 / M_PI, 40, 1e-9);
}

TEST(Camera, VelocityIsTheDerivativeOfTheProjection) {
  for (const bool perspective : {false, true}) {
    ViewOptions options = view("1,-2,0.7");
    if (perspective) options.perspective = 50;
    const Camera c = Camera::fit(extent_of(cube(10)), options);
    const Vec3 p(2, 7, 4), t = glm::normalize(Vec3(1, 0.3, -2));
    const double h = 1e-5;
    const Vec2 numeric = (c.to_paper(p + h * t) - c.to_paper(p - h * t)) / (2 * h);
    EXPECT_LT(glm::length(c.velocity(p, t) - numeric), 1e-6 * c.scale());
    EXPECT_NEAR(glm::length(c.to_viewer(p)), 1, 1e-15);
    const ViewRay ray = c.ray(c.to_paper(p));
    EXPECT_LT(glm::length(glm::cross(p - ray.origin, ray.direction)), 1e-9);
  }
}

TEST(Camera, FollowsAMovedScaledAndTurnedModel) {
  const auto points = cube(10);
  const Camera a = Camera::fit(extent_of(points), view("iso"));
  for (const double scale : {1e-3, 1.0, 1e4}) {
    const Vec3 move(1e5, -2e5, 3e5);
    std::vector<Vec3> moved;
    for (const Vec3& p : points) moved.push_back(scale * p + move);
    const Camera b = Camera::fit(extent_of(moved), view("iso"));
    for (std::size_t i = 0; i < points.size(); ++i) {
      // Doubles 3e5 away from the origin leave 6e-11 of a model mm; on paper that is times the
      // scale.
      EXPECT_LT(glm::length(a.to_paper(points[i]) - b.to_paper(moved[i])), 1e-9 + 1e-9 * b.scale());
    }
  }
}

TEST(Camera, RefusesWhatCannotBeDrawn) {
  EXPECT_THROW(Camera::fit(extent_of({}), {}), GeometryError);
  EXPECT_THROW(Camera::fit(extent_of({{0, 0, 0}, {1, INFINITY, 0}}), {}), GeometryError);
  EXPECT_THROW(Camera::fit(extent_of(cube(1)), {.direction = {0, 0, 0}}), UsageError);
  EXPECT_THROW(Camera::fit(extent_of(cube(1)), {.margin = 200}), UsageError);
  EXPECT_THROW(Camera::fit(extent_of(cube(1)), {.perspective = 0}), UsageError);
  EXPECT_THROW(Camera::fit(extent_of(cube(1)), {.scale = -1}), UsageError);
  EXPECT_THROW(Camera::fit(extent_of(cube(1)), {.perspective = 90, .scale = 1000}), UsageError);
  EXPECT_EQ(Camera::fit(extent_of({{5, 5, 5}}), {}).scale(), 1);
}

}  // namespace
}  // namespace burin
