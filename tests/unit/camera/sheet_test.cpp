#include <burin/base/error.h>
#include <burin/camera/sheet.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace burin {
namespace {

using Points = std::vector<Vec3>;

Camera::ExtentFn extent_of_points(const Points& points) {
  return [points](const Mat3& axes) {
    Box3 box;
    for (const Vec3& p : points) box.add(axes * p);
    return box;
  };
}

Points block(Vec3 size, Vec3 at = Vec3(0)) {
  Points out;
  for (int i = 0; i < 8; ++i) out.push_back(at + size * Vec3(i & 1, (i >> 1) & 1, i >> 2));
  return out;
}

ViewOptions sheet_view(std::string_view name) {
  const NamedView v = named_view(name);
  return {.direction = v.direction, .up = v.up};
}

// The camera, and the box of the points on its paper.
struct Shown {
  Camera camera;
  Box2 box;
};
Shown shown(const Points& points, const ViewOptions& view, const SheetOptions& sheet) {
  const auto extent = extent_of_points(points);
  Shown out{Camera::fit(extent, settle(extent, view, sheet)), {}};
  for (const Vec3& p : points) out.box.add(out.camera.to_paper(p));
  return out;
}

TEST(Sheet, NamesAreTakenInAnyCase) {
  EXPECT_EQ(Paper::named("b4").width, 353);
  EXPECT_EQ(Paper::named("B0").height, 1000);
  EXPECT_EQ(Paper::named("a3P").width, 297);
  EXPECT_EQ(Paper::named("Legal").width, 355.6);
  EXPECT_EQ(Paper::named("legalp").height, 355.6);
  EXPECT_EQ(Paper::named("200X150").width, 200);
  EXPECT_EQ(named_view("ISO").direction, Vec3(1, -1, 1));
  EXPECT_EQ(named_view("Top").up, Vec3(0, 1, 0));
}

TEST(Sheet, AnEvenMarginAndAPaperChangeNothing) {
  const ViewOptions asked = sheet_view("iso");
  const ViewOptions settled =
      settle(extent_of_points(block(Vec3(10))), asked, {.margin = Margin(7)});
  EXPECT_EQ(settled.margin, 7);
  EXPECT_FALSE(settled.scale);
  EXPECT_FALSE(settled.center);
}

TEST(Sheet, EachSideKeepsItsMargin) {
  const SheetOptions sheet{.margin = Margin(30, 5, 20, 60)};
  const Shown wide = shown(block({100, 1, 10}), sheet_view("front"), sheet);
  EXPECT_NEAR(wide.box.min.x, 60, 1e-9);
  EXPECT_NEAR(wide.box.max.x, 297 - 5, 1e-9);
  EXPECT_NEAR(wide.box.center().y, (20 + 210 - 30) / 2.0, 1e-9);
  const Shown tall = shown(block({10, 1, 100}), sheet_view("front"), sheet);
  EXPECT_NEAR(tall.box.min.y, 20, 1e-9);
  EXPECT_NEAR(tall.box.max.y, 210 - 30, 1e-9);
  // With a scale of its own the drawing stands in the middle of what is left.
  ViewOptions scaled = sheet_view("front");
  scaled.scale = 0.5;
  const Shown small = shown(block({100, 1, 10}), scaled, sheet);
  EXPECT_NEAR(small.box.size().x, 50, 1e-9);
  EXPECT_NEAR(small.box.center().x, (60 + 297 - 5) / 2.0, 1e-9);
  ViewOptions deep = sheet_view("iso");
  deep.perspective = 30;
  EXPECT_THROW(shown(block(Vec3(10)), deep, sheet), UsageError);
}

TEST(Sheet, TakesTheLargestScaleOfIso5455ThatFits) {
  const auto scale_of = [](double length, const Margin& margin) {
    const SheetOptions sheet{.margin = margin, .iso_scale = true};
    const Shown s = shown(block({length, 1, 10}), sheet_view("front"), sheet);
    EXPECT_NEAR(s.box.center().x, (margin.left + 297 - margin.right) / 2, 1e-9);
    return s.camera.scale();
  };
  EXPECT_EQ(scale_of(100, Margin(10)), 2);  // 2.77 fits
  EXPECT_EQ(scale_of(277, Margin(10)), 1);  // exactly
  EXPECT_EQ(scale_of(277.001, Margin(10)), 0.5);
  EXPECT_EQ(scale_of(700, Margin(10)), 0.2);
  EXPECT_EQ(scale_of(100, Margin(10, 80, 10, 30)), 1);
  EXPECT_EQ(scale_of(0.1, Margin(10)), 10);  // by the height of the sheet
  ViewOptions asked = sheet_view("front");
  asked.scale = 0.7;  // of its own
  EXPECT_EQ(shown(block({100, 1, 10}), asked, {.iso_scale = true}).camera.scale(), 0.7);
  EXPECT_THROW(shown(block(Vec3(10)), sheet_view("front"), {.fits = true, .iso_scale = true}),
               UsageError);
  asked.perspective = 30;
  EXPECT_THROW(shown(block(Vec3(10)), asked, {.iso_scale = true}), UsageError);
}

TEST(Sheet, FitsTheDrawingAndItsMargin) {
  ViewOptions asked = sheet_view("front");
  asked.scale = 2;
  const Shown s =
      shown(block({100, 1, 30}, {5, 6, 7}), asked, {.margin = Margin(1, 2, 3, 4), .fits = true});
  EXPECT_NEAR(s.camera.paper().width, 200 + 2 + 4, 1e-9);
  EXPECT_NEAR(s.camera.paper().height, 60 + 1 + 3, 1e-9);
  EXPECT_NEAR(s.box.min.x, 4, 1e-9);
  EXPECT_NEAR(s.box.min.y, 3, 1e-9);
  asked.scale.reset();
  EXPECT_EQ(shown(block({100, 1, 30}), asked, {.fits = true}).camera.scale(), 1);
  // A point has a sheet too.
  EXPECT_EQ(shown({Vec3(1)}, asked, {.margin = Margin(0), .fits = true}).camera.paper().width, 5);
}

TEST(Sheet, FitsAPerspectiveDrawing) {
  ViewOptions asked = sheet_view("1,-2,0.7");
  asked.perspective = 50;
  for (const double scale : {1.0, 3.0}) {
    asked.scale = scale;
    const Shown s = shown(block({40, 10, 10}), asked, {.margin = Margin(5), .fits = true});
    const Vec2 sheet(s.camera.paper().width, s.camera.paper().height);
    EXPECT_NEAR(s.box.min.x, 5, 1e-4);
    EXPECT_NEAR(s.box.max.x, sheet.x - 5, 1e-4);
    EXPECT_GE(s.box.min.y, 5 - 1e-4);
    EXPECT_LE(s.box.max.y, sheet.y - 5 + 1e-4);
    EXPECT_LT(s.box.min.y, 5.01);  // the angle is that of the height, so it is filled
    EXPECT_NEAR(s.camera.field_of_view(), 50, 1e-12);
    EXPECT_NEAR(s.camera.scale(), scale, 1e-9);
  }
}

TEST(Sheet, SaysWhatScaleASheetThatFitsTakes) {
  try {
    shown(block(Vec3(30000)), sheet_view("front"), {.fits = true});
    FAIL();
  } catch (const UsageError& e) {
    EXPECT_NE(std::string(e.what()).find("30020 x 30020 mm"), std::string::npos) << e.what();
    EXPECT_NE(std::string(e.what()).find("0.32 or less"), std::string::npos) << e.what();
  }
}

}  // namespace
}  // namespace burin
