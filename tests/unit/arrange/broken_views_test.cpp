// Views of long parts with stretches left out.
#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/drawing/clip.h>
#include <burin/drawing/length.h>
#include <burin/drawing/writers.h>
#include <burin/forms/mesh/mesh_form.h>

#include "broken_bar.h"

#include <burin_test/mesh_checks.h>
#include <burin_test/ring_size.h>
#include <burin_test/shapes.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace burin {
namespace {

constexpr double kGap = 4;

class BrokenViews : public test::BrokenBar {
 protected:
  bool tells(const std::string& code) const { return test::count_of(scene_.diagnostics, code) > 0; }

  static bool is_laid_over(const Path& path) {
    return path.kind == LineClass::Frame || path.kind == LineClass::Leader;
  }
  /// The lines of the parts.
  std::vector<Path> lines() const {
    std::vector<Path> all;
    for (const Layer& layer : drawing_.layers) {
      for (const Path& path : layer.paths) {
        if (!is_laid_over(path)) all.push_back(path);
      }
    }
    return all;
  }
  Box2 extent() const {
    Box2 box;
    for (const Path& path : lines()) {
      for (const Vec2& p : path.points) box.add(p);
    }
    return box;
  }
  const Layer* layer(const std::string& name) const {
    const auto found = std::ranges::find(drawing_.layers, name, &Layer::name);
    return found == drawing_.layers.end() ? nullptr : &*found;
  }
  double length() const {
    double sum = 0;
    for (const Path& path : lines()) sum += length_of(path);
    return sum;
  }
  const PlacedView& view() const { return sheet_.views.front(); }
};

TEST_F(BrokenViews, AreAsLongAsWhatIsLeftAndTheGap) {
  plan_.view.scale = 1;
  draw();
  const Box2 box = extent();
  EXPECT_NEAR(box.size().y, 100 + kGap, 1e-9);
  EXPECT_NEAR(box.size().x, 20, 1e-9);
  // In the middle of the sheet.
  EXPECT_NEAR(box.center().y, 105, 1e-9);
  EXPECT_NEAR(box.center().x, 148.5, 1e-9);
}

TEST_F(BrokenViews, ShowBothEndsAsTheWholeViewDoes) {
  plan_.view.scale = 0.4;
  draw();
  const double broken = length();
  for (const Path& path : lines()) {
    EXPECT_EQ(path.source.part, 0);
    for (std::size_t i = 0; i < path.points.size(); ++i) {
      const Vec3 p = path.points3[i];
      EXPECT_TRUE(p.z <= 50 + 1e-9 || p.z >= 350 - 1e-9) << p.z;
      EXPECT_LT(glm::distance(view().at(p), path.points[i]), 1e-9) << p.z;
    }
  }
  plan_.breaks.clear();
  draw();
  const Vec2 up(0, 1);
  const Strip low{-1e9, view().at({0, 0, 50}).y, up}, high{view().at({0, 0, 350}).y, 1e9, up};
  double whole = 0;
  for (const Path& path : lines()) {
    for (const Strip& end : {low, high}) {
      for (const Path& piece : clipped(path, end)) whole += length_of(piece);
    }
  }
  EXPECT_NEAR(whole, broken, 1e-9);
  EXPECT_NEAR(broken, 0.4 * (4 * 50 + 2 * 20), 1e-9);
}

TEST_F(BrokenViews, HaveNothingButBreakLinesInTheGap) {
  plan_.view.scale = 1;
  plan_.illustrate.hidden = HiddenLines::Dashed;
  plan_.style.fill.color = "#ff0000";
  draw();
  const double low = view().at({0, 0, 50}).y, high = view().at({0, 0, 350}).y;
  EXPECT_NEAR(high - low, kGap, 1e-9);
  for (const Path& path : lines()) {
    for (const Vec2& p : path.points) EXPECT_TRUE(p.y <= low + 1e-9 || p.y >= high - 1e-9) << p.y;
  }
  double filled = 0;
  for (const Area& area : drawing_.areas) filled += std::abs(test::signed_area(area));
  EXPECT_NEAR(filled, 20 * 100, 1e-6);
  const Layer* breaks = layer("breaks");
  ASSERT_NE(breaks, nullptr);
  ASSERT_EQ(breaks->paths.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const Path& line = breaks->paths[i];
    EXPECT_EQ(line.width, std::vector<double>{0.18}) << "narrow";
    EXPECT_EQ(line.source, SourceId()) << "of no part";
    // Beyond the outline at both sides.
    const auto [left, right] = std::ranges::minmax_element(line.points, {}, &Vec2::x);
    EXPECT_LT(left->x, extent().min.x - 1);
    EXPECT_GT(right->x, extent().max.x + 1);
    EXPECT_NEAR(line.points.front().y, i == 0 ? low : high, 1e-9);
    EXPECT_NEAR(line.points.back().y, i == 0 ? low : high, 1e-9);
  }
}

TEST_F(BrokenViews, MayEndInAWave) {
  plan_.view.scale = 1;
  plan_.style.broken.line = BreakOptions::Line::Freehand;
  plan_.style.broken.gap = 6;
  draw();
  const Layer* breaks = layer("breaks");
  ASSERT_NE(breaks, nullptr);
  EXPECT_NEAR(view().at({0, 0, 350}).y - view().at({0, 0, 50}).y, 6, 1e-9);
  for (const Path& wave : breaks->paths) {
    EXPECT_GT(wave.points.size(), 20U);
    // No farther than the outline, whose lines end on it.
    for (const double x : {extent().min.x, extent().max.x}) {
      const Vec2 end =
          std::abs(wave.points.front().x - x) < 1e-6 ? wave.points.front() : wave.points.back();
      EXPECT_NEAR(end.x, x, 1e-6);
      double nearest = 1e9;
      for (const Path& path : lines()) {
        for (const Vec2& p : path.points) nearest = std::min(nearest, glm::distance(p, end));
      }
      EXPECT_LT(nearest, 1e-6);
    }
  }
}

TEST_F(BrokenViews, MeasureTheTrueLength) {
  plan_.overall_dimensions = true;
  DimensionRow row{.kind = DimensionRow::Kind::Distance, .along = Vec3(0, 0, 1)};
  for (const double z : {40.0, 400.0}) {
    row.of.push_back({.kind = FeatureRow::Kind::Point, .at = {0, 0, z}});
  }
  plan_.dimensions = {row};
  draw();
  EXPECT_EQ(dimensions(), (std::vector<std::string>{"360", "20", "400"}));
  const Layer* laid = layer("dimensions");
  // The arrows of the overall length stand at both ends, as drawn, and its line is one line.
  const double foot = view().at({0, 0, 0}).y, top = view().at({0, 0, 400}).y;
  std::vector<double> tips;
  bool one_line = false;
  for (const Path& path : laid->paths) {
    if (path.width.size() == 2) tips.push_back(path.points.back().y);
    const double low = std::min(path.points[0].y, path.points.back().y),
                 high = std::max(path.points[0].y, path.points.back().y);
    one_line = one_line || (low < foot + 5 && high > top - 5);
  }
  EXPECT_TRUE(one_line);
  for (const double at : {foot, top}) {
    EXPECT_TRUE(std::ranges::any_of(tips, [&](double y) { return std::abs(y - at) < 1e-9; })) << at;
  }
}

TEST_F(BrokenViews, TellOfDimensionsOfWhatIsLeftOut) {
  DimensionRow row{.kind = DimensionRow::Kind::Distance, .along = Vec3(0, 0, 1)};
  for (const double z : {100.0, 400.0}) {
    row.of.push_back({.kind = FeatureRow::Kind::Point, .at = {0, 0, z}});
  }
  plan_.dimensions = {row};
  draw();
  EXPECT_TRUE(dimensions().empty());
  EXPECT_TRUE(tells("dimensions.not_drawn"));
}

TEST_F(BrokenViews, AreDrawnLargerOnASheet) {
  draw();
  const double broken = sheet_.camera().scale();
  EXPECT_NEAR(broken, (190 - kGap) / 100, 1e-9);
  EXPECT_NEAR(extent().min.y, 10, 1e-9);
  EXPECT_NEAR(extent().max.y, 200, 1e-9);
  plan_.breaks.clear();
  draw();
  EXPECT_NEAR(sheet_.camera().scale(), 190.0 / 400, 1e-9);
}

TEST_F(BrokenViews, KeepTheStretchesBetweenSeveralBreaks) {
  plan_.view.scale = 1;
  plan_.breaks = {along_z(250, 380), along_z(20, 150)};
  draw();
  EXPECT_NEAR(extent().size().y, 140 + 2 * kGap, 1e-9);
  EXPECT_NEAR(view().at({0, 0, 250}).y - view().at({0, 0, 150}).y, 100, 1e-9);
  EXPECT_EQ(layer("breaks")->paths.size(), 4U);
}

TEST_F(BrokenViews, StandInLineOnASheetOfViews) {
  plan_.views = {"front", "left", "top", "iso"};
  draw();
  const auto named = [&](const std::string& name) -> const PlacedView& {
    return *std::ranges::find(sheet_.views, name, &PlacedView::name);
  };
  EXPECT_TRUE(named("top").breaks.empty()) << "it sees the axis from its end";
  for (const double z : {0.0, 50.0, 350.0, 400.0}) {
    EXPECT_NEAR(named("front").at({0, 0, z}).y, named("left").at({0, 0, z}).y, 1e-9) << z;
  }
  // At a slant what shows nothing but the stretch is left out.
  const PaperBreaks& slant = named("iso").breaks;
  ASSERT_EQ(slant.bands.size(), 1U);
  const double share = std::sqrt(2.0 / 3), scale = named("iso").camera.scale();
  const double removed = (slant.bands[0].high - slant.bands[0].low) / scale;
  EXPECT_LT(removed, 300 * share);
  EXPECT_NEAR(removed, 300 * share - 40 * std::sqrt(0.5) * std::sqrt(1.0 / 3), 1e-6);
  const Box2 sheet{{0, 0}, {297, 210}};
  for (const Path& path : lines()) {
    for (std::size_t i = 0; i < path.points.size(); ++i) {
      EXPECT_TRUE(sheet.contains(path.points[i]));
    }
  }
  EXPECT_FALSE(tells("sheet.clipped"));
  EXPECT_EQ(test::count_of(drawing_.diagnostics, "break.not_shown"), 0);
  for (const SheetView& one : drawing_.views) {
    const Box2 wide{one.box.min - 1e-6, one.box.max + 1e-6};
    for (const Path& path : lines()) {
      int inside = 0;
      for (const Vec2& p : path.points) inside += wide.contains(p) ? 1 : 0;
      EXPECT_TRUE(inside == 0 || inside == static_cast<int>(path.points.size())) << one.name;
    }
  }
}

TEST_F(BrokenViews, HaveNoBreakLinesWhereThereIsNothing) {
  // Two legs and a bridge.
  scene_.parts = {part("leg", {0, 0, 0}, {20, 20, 400}), part("leg", {60, 0, 0}, {80, 20, 400}),
                  part("bridge", {20, 0, 380}, {60, 20, 400})};
  plan_.view.scale = 1;
  draw();
  ASSERT_NE(layer("breaks"), nullptr);
  EXPECT_EQ(layer("breaks")->paths.size(), 4U);
  for (const Path& line : layer("breaks")->paths) {
    const auto [left, right] = std::ranges::minmax_element(line.points, {}, &Vec2::x);
    EXPECT_LT(right->x - left->x, 30);
  }
}

TEST_F(BrokenViews, FindTheStretchesThatKeepTheirSection) {
  const auto found = [&] {
    arrange_parts(scene_, plan_, context_);
    return plan_.left_out;
  };
  plan_.breaks = {{}};
  ModelBreaks bar = found();
  EXPECT_EQ(bar.axis, Vec3(0, 0, 1)) << "the longest";
  ASSERT_EQ(bar.stretches.size(), 1U);
  EXPECT_NEAR(bar.stretches[0].first, 30, 1e-9);  // one and a half of its width at each end
  EXPECT_NEAR(bar.stretches[0].second, 370, 1e-9);
  // A collar parts it.
  scene_.parts.push_back(part("collar", {-5, -5, 180}, {25, 25, 190}));
  bar = found();
  ASSERT_EQ(bar.stretches.size(), 2U);
  EXPECT_NEAR(bar.stretches[0].second, 150, 1e-9);
  EXPECT_NEAR(bar.stretches[1].first, 220, 1e-9);
  // What tapers is not uniform, however little.
  TriMesh tapered = test::box({0, 0, 0}, {20, 20, 400});
  for (Vec3& p : tapered.positions) p.x *= p.z > 200 ? 1.01 : 1;
  scene_.parts = {{"taper", "a.step", std::make_shared<MeshForm>(tapered)}};
  EXPECT_TRUE(found().empty());
  EXPECT_TRUE(tells("break.not_found"));
  plan_.breaks = {{.axis = Vec3(1, 0, 0)}};
  SetUp();
  plan_.breaks = {{.axis = Vec3(1, 0, 0)}};
  EXPECT_TRUE(found().empty()) << "it is not long that way";
}

TEST_F(BrokenViews, SayWhatHasNoEffect) {
  plan_.view.direction = {0, 0, 1};
  draw();
  EXPECT_TRUE(tells("break.not_shown"));
  EXPECT_EQ(layer("breaks"), nullptr);
  for (const auto& [low, high] :
       {std::pair(350.0, 500.0), {-20.0, 30.0}, {500.0, 600.0}, {0.0, 400.0}}) {
    SetUp();
    plan_.breaks = {along_z(low, high)};
    draw();
    EXPECT_TRUE(tells("break.outside")) << low;
    EXPECT_EQ(layer("breaks"), nullptr);
  }
  SetUp();
  plan_.view.perspective = 30;
  draw();
  EXPECT_TRUE(tells("break.not_shown"));
  SetUp();
  plan_.breaks = {along_z(100, 103)};
  plan_.view.scale = 0.4;
  draw();
  EXPECT_TRUE(tells("break.short"));
  EXPECT_NEAR(extent().size().y, 160, 1e-9) << "no longer than it is";
}

TEST_F(BrokenViews, RefuseBreaksThatOverlapOrCross) {
  plan_.breaks = {along_z(20, 180), along_z(180, 200)};
  EXPECT_THROW(draw(), UsageError);
  plan_.breaks = {along_z(20, 180), {.axis = Vec3(1, 0, 0), .stretch = std::pair(5.0, 10.0)}};
  EXPECT_THROW(draw(), UsageError);
  plan_.breaks = {along_z(20, 180)};
  plan_.details = {{.at = {10, 0, 100}, .radius = 10}};
  EXPECT_THROW(draw(), UsageError);
  // Against the axis is along it, too.
  plan_.details.clear();
  plan_.breaks = {along_z(20, 60), {.axis = Vec3(0, 0, -1), .stretch = std::pair(-180.0, -100.0)}};
  draw();
  ASSERT_EQ(plan_.left_out.stretches.size(), 2U);
  EXPECT_EQ(plan_.left_out.stretches[1], std::pair(100.0, 180.0));
}

TEST_F(BrokenViews, MarkDetailsAndSectionsWhereTheyAreDrawn) {
  plan_.details = {{.at = {10, 0, 390}, .radius = 10}};
  draw();
  ASSERT_EQ(sheet_.details.size(), 1U);
  EXPECT_LT(glm::distance(sheet_.details[0].from.center, view().at({10, 0, 390})), 1e-9);
  SetUp();
  plan_.views = {"front"};
  for (const double z : {380.0, 200.0}) {
    Section section;
    section.planes = {{.axis = {0, 0, 1}, .side = 1, .offset = z}};
    section.own_view = true;
    plan_.sections.push_back(section);
  }
  draw();
  ASSERT_EQ(sheet_.section_marks.size(), 1U) << "the other cuts what is left out";
  EXPECT_NEAR(sheet_.section_marks[0].course[0].y, view().at({0, 0, 380}).y, 1e-9);
  EXPECT_TRUE(tells("section.no_line"));
}

TEST_F(BrokenViews, AreTheSameForAnyNumberOfThreads) {
  plan_.views = {"front", "iso"};
  plan_.style = builtin_style("engraving");
  plan_.style.fill.color = "#ff8800";
  std::vector<std::string> written;
  for (const int threads : {1, 2, 3}) {
    const ThreadLimit limit(threads);
    draw();
    std::ostringstream text;
    write_json(drawing_, {}, text, context_);
    written.push_back(text.str());
  }
  EXPECT_GT(drawing_.stats.strokes, 50);
  EXPECT_EQ(written[0], written[1]);
  EXPECT_EQ(written[0], written[2]);
}

}  // namespace
}  // namespace burin
