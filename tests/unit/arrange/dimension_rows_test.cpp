// Dimensions of faces, edges and points of parts.
#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/drawing/clip.h>
#include <burin/drawing/font.h>
#include <burin/surface/placed_form.h>

#include "measured_sheet.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <burin_test/brep_shapes.h>
#include <burin_test/mesh_checks.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace burin {
namespace {

using Kind = DimensionRow::Kind;
using Texts = std::map<std::string, std::vector<std::string>>;

struct Hole {
  double x = 0, y = 0, radius = 1, from = -1;
};

TopoDS_Shape plate(double length, const std::vector<Hole>& holes) {
  TopoDS_Shape out = BRepPrimAPI_MakeBox(length, 50, 12).Shape();
  for (const Hole& hole : holes) {
    const gp_Ax2 axis(gp_Pnt(hole.x, hole.y, hole.from), gp_Dir(0, 0, 1));
    out = BRepAlgoAPI_Cut(out, BRepPrimAPI_MakeCylinder(axis, hole.radius, 20).Shape());
  }
  return out;
}

const std::vector<Hole> kHoles{{20, 15, 8.5}, {60, 40, 3.25, 4}};

using test::at;

class DimensionRows : public test::MeasuredSheet {
 protected:
  void SetUp() override {
    begin({"plate", "a.step", test::brep_form(plate(80, kHoles))});
    plan_.views = {"front", "top", "left"};
  }

  void add_all() {
    add(Kind::Distance, {at({0, 25, 6}), at({80, 25, 6})});
    add(Kind::Distance, {at({0, 25, 6}), at({28.5, 15, 6})});
    add(Kind::Distance, {at({28.5, 15, 6}), at({63.25, 40, 8})}).along = Vec3(1, 0, 0);
    add(Kind::Distance, {at({28.5, 15, 6}), at({63.25, 40, 8})}).along = Vec3(0, 1, 0);
    add(Kind::Distance, {at({40, 25, 0}), at({40, 25, 12})}).tolerance = "±0.1";
    add(Kind::Diameter, {at({28.5, 15, 6})}).tolerance = "H7";
    add(Kind::Radius, {at({63.25, 40, 8})});
    add(Kind::Depth, {at({63.25, 40, 8})}).upper = "+0.2";
    plan_.dimensions.back().lower = "-0.1";
    add(Kind::Angle, {at({0, 25, 6}), at({40, 0, 6})});
  }

  /// What planning throws.
  std::string refused() {
    try {
      planned();
    } catch (const UsageError& e) {
      return e.what();
    }
    return "";
  }
};

TEST_F(DimensionRows, StandInTheViewThatShowsThemBest) {
  add_all();
  EXPECT_EQ(texts(), (Texts{{"front", {"80", "12 ±0.1"}},
                            {"top", {"20", "40", "25", "⌀17 H7", "R3.25", "⌀6.5 ↧ 8", "90°"}}}));
  EXPECT_EQ(told(), "");
}

TEST_F(DimensionRows, HaveTheValueOfTheModel) {
  add_all();
  planned();
  const std::array<double, 9> values{80, 20, 40, 25, 12, 17, 3.25, 8, 90};
  ASSERT_EQ(plan_.measured.size(), values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_NEAR(plan_.measured[i].value, values[i], 1e-9 * values[i]) << i;
  }
}

TEST_F(DimensionRows, AreTheSameInPlacedAndMirroredParts) {
  add_all();
  const Placement mirror{Mat3(Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)), Vec3(5, -7, 3)};
  scene_.parts[0].form = placed(scene_.parts[0].form, mirror);
  for (DimensionRow& row : plan_.dimensions) {
    for (FeatureRow& one : row.of) one.at = mirror.point(one.at);
  }
  planned();
  const std::array<double, 9> values{80, 20, 40, 25, 12, 17, 3.25, 8, 90};
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_NEAR(plan_.measured[i].value, values[i], 1e-9 * values[i]) << i;
  }
}

TEST_F(DimensionRows, AreWrittenAsTheRowSays) {
  add(Kind::Distance, {at({0, 25, 6}), at({80, 25, 6})}).unit = DimensionOptions::Unit::Inch;
  add(Kind::Diameter, {at({28.5, 15, 6})}).text = "4x ⌀{value}";
  DimensionRow& comma = add(Kind::Radius, {at({63.25, 40, 8})});
  comma.sign = DimensionOptions::Sign::Comma;
  comma.tolerance = "±0.05";
  add(Kind::Radius, {at({63.25, 40, 8})}).decimals = 0;
  add(Kind::Thread, {at({63.25, 40, 8})}).text = "M8 - 6H";
  EXPECT_EQ(texts(),
            (Texts{{"front", {"3.15 in"}}, {"top", {"4x ⌀17", "R3,25 ±0,05", "R3", "M8 - 6H"}}}));
}

TEST_F(DimensionRows, StandWhereTheRowSays) {
  add(Kind::Diameter, {at({28.5, 15, 6})}).view = "front";
  add(Kind::Distance, {at({40, 25, 0}), at({40, 25, 12})}).view = "left";
  EXPECT_EQ(texts(), (Texts{{"front", {"⌀17"}}, {"left", {"12"}}}));
  plan_.dimensions[0].view = "frnt";
  EXPECT_EQ(refused(),
            "dimension 1 (diameter): no view is called 'frnt': there is front, top, left");
  plan_.dimensions[0].view = "top";
  plan_.dimensions[1].view = "top";
  scene_.diagnostics = {};
  EXPECT_EQ(texts(), (Texts{{"top", {"⌀17"}}}));
  EXPECT_EQ(told(), "dimension 2 (distance) is not drawn: the view top does not show it as it is");
}

TEST_F(DimensionRows, ThatNoViewShowsSquareAreTold) {
  plan_.views = {};
  plan_.view.direction = {0, 0, 1};
  plan_.view.up = {0, 1, 0};
  add(Kind::Distance, {at({40, 25, 0}), at({40, 25, 12})});
  EXPECT_EQ(texts(), Texts{});
  EXPECT_EQ(told(),
            "dimension 1 (distance) is not drawn: no view of the sheet shows it as it is: add "
            "front to `views`");
  plan_.view.direction = {1, -1, 1};  // along the axes of space
  plan_.view.up = {0, 0, 1};
  EXPECT_EQ(texts(), (Texts{{"", {"12"}}}));
  plan_.view.direction = {1, -2, 0};  // neither
  EXPECT_EQ(texts(), (Texts{{"", {"12"}}}));
  plan_.dimensions.clear();
  add(Kind::Distance, {at({0, 25, 6}), at({80, 25, 6})});
  EXPECT_EQ(texts(), Texts{});
}

TEST_F(DimensionRows, SayWhatCannotBeMeasured) {
  const auto said = [&](Kind kind, std::vector<FeatureRow> of) {
    plan_.dimensions.clear();
    add(kind, std::move(of)).place = "a.json:3: ";
    return refused();
  };
  EXPECT_EQ(said(Kind::Distance, {at({0, 25, 6}), at({40, 0, 6})}),
            "a.json:3: dimension 1 (distance): a plane and a plane are not parallel (by 90 "
            "degrees): they have an angle and no distance");
  EXPECT_EQ(said(Kind::Diameter, {{.part = "plate", .number = 99}}),
            "a.json:3: dimension 1 (diameter): part 'plate' has no face 99: they are 0 to 8");
  EXPECT_NE(said(Kind::Diameter, {at({0, 25, 6})}).find("a plane (number "), std::string::npos);
  EXPECT_NE(said(Kind::Diameter, {at({0, 25, 6})})
                .find(" has no diameter: name a cylinder, a cone, a sphere or a round edge"),
            std::string::npos);
  EXPECT_EQ(said(Kind::Diameter, {at({40, 25, 30})}),
            "a.json:3: dimension 1 (diameter): no face is at 40,25,30: the nearest is 18 mm away");
  EXPECT_NE(said(Kind::Depth, {at({0, 25, 6})}).find("has no depth: name the wall of a hole"),
            std::string::npos);
  EXPECT_NE(said(Kind::Diameter, {{.part = "plat", .number = 0}}).find("plat"), std::string::npos);
}

/// The corners of what letters take up, in a bit from their border.
std::array<Vec2, 4> corners_of(const Text& text) {
  const double inset = 0.15 * text.height, width = text_width(text.text, text.height);
  const Vec2 along = way_of(text), up(-along.y, along.x);
  const Vec2 low = text.at - (text.anchor == TextAnchor::Middle ? 0.5 * width : 0) * along;
  const Vec2 a = low + inset * (along + up),
             b = low + (width - inset) * along + (text.height - inset) * up;
  const double w = glm::dot(b - a, along), h = glm::dot(b - a, up);
  return {a, a + w * along, b, a + h * up};
}

bool inside_of(const std::array<Vec2, 4>& quad, Vec2 p) {
  for (std::size_t i = 0; i < 4; ++i) {
    if (cross2(quad[(i + 1) % 4] - quad[i], p - quad[i]) < 0) return false;
  }
  return true;
}

/// The line of any layer, or the letters of another text, that run through the letters of a text.
std::string covered_by(const Text& text, const Drawing& drawing) {
  const std::array<Vec2, 4> quad = corners_of(text);
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      if (!path.visible) continue;
      for (std::size_t i = 0; i + 1 < path.points.size(); ++i) {
        const double length = glm::distance(path.points[i], path.points[i + 1]);
        const int steps = 1 + static_cast<int>(length / 0.2);
        for (int k = 0; k <= steps; ++k) {
          const double share = static_cast<double>(k) / steps;
          if (inside_of(quad, glm::mix(path.points[i], path.points[i + 1], share))) {
            return fmt::format("{} line {},{} to {},{} letters {},{} turn {}", layer.name,
                               path.points[i].x, path.points[i].y, path.points[i + 1].x,
                               path.points[i + 1].y, text.at.x, text.at.y, text.turn);
          }
        }
      }
    }
    for (const Text& other : layer.texts) {
      if (&other == &text) continue;
      for (const Vec2& corner : corners_of(other)) {
        if (inside_of(quad, corner)) return other.text;
      }
    }
  }
  return "";
}

TEST_F(DimensionRows, HaveNumbersOverNothingInManyViews) {
  int seen = 0;
  for (int k = 0; k < 24; ++k) {
    // Six square views, and others all round.
    const double turn = 0.7 * k, rise = k % 3 == 0 ? 1.0 : k % 3 == 1 ? -0.6 : 0.35;
    Vec3 direction(std::cos(turn), std::sin(turn), rise);
    if (k < 6) {
      direction = Vec3(0);
      direction[k % 3] = k < 3 ? 1 : -1;
    }
    for (const double width : {297.0, 148.0}) {
      SetUp();
      add_all();
      plan_.overall_dimensions = true;
      plan_.views = {};
      plan_.view.direction = direction;
      plan_.view.up = direction.x == 0 && direction.y == 0 ? Vec3(0, 1, 0) : Vec3(0, 0, 1);
      plan_.view.paper = {width, width / std::sqrt(2.0)};
      const Drawing drawing = illustrate(scene_, planned(), plan_, context_);
      const auto layer = std::ranges::find(drawing.layers, "dimensions", &Layer::name);
      ASSERT_NE(layer, drawing.layers.end());
      for (const Text& text : layer->texts) {
        ++seen;
        EXPECT_EQ(covered_by(text, drawing), "")
            << text.text << " from " << direction.x << "," << direction.y << "," << direction.z
            << " on " << width;
      }
      // A small sheet may have no room for all, and says so.
      if (width < 200) continue;
      EXPECT_EQ(test::count_of(drawing.diagnostics, "dimensions.off_sheet"), 0)
          << direction.x << "," << direction.y << "," << direction.z << " on " << width;
    }
  }
  EXPECT_GT(seen, 200);
}

TEST_F(DimensionRows, StandInStepsSmallOnesNearThePart) {
  plan_.views = {"top"};
  plan_.overall_dimensions = true;
  add(Kind::Distance, {at({0, 25, 6}), at({28.5, 15, 6})});
  add(Kind::Distance, {at({0, 25, 6}), {.kind = FeatureRow::Kind::Point, .at = {60, 0, 0}}});
  const SheetOfViews sheet = planned();
  const Drawing drawing = illustrate(scene_, sheet, plan_, context_);
  const auto layer = std::ranges::find(drawing.layers, "dimensions", &Layer::name);
  ASSERT_NE(layer, drawing.layers.end());
  std::map<std::string, double> heights;
  for (const Text& text : layer->texts) heights[text.text] = text.at.y;
  const double foot = sheet.camera().to_paper({0, 0, 12}).y;
  const double first = foot - 2.4 * 3.5 + 0.25 * 3.5;
  EXPECT_NEAR(heights["20"], first, 1e-9);
  EXPECT_NEAR(heights["60"], first - 7, 1e-9);
  EXPECT_NEAR(heights["80"], first - 14, 1e-9);
}

TEST_F(DimensionRows, AreTheSameForAnyNumberOfThreads) {
  add_all();
  const auto drawn = [&](int threads) {
    const ThreadLimit limit(threads);
    Scene scene = scene_;
    Illustration plan = plan_;
    const Drawing drawing = illustrate(std::move(scene), std::move(plan), context_);
    std::string all;
    const auto layer = std::ranges::find(drawing.layers, "dimensions", &Layer::name);
    for (const Path& path : layer->paths) {
      for (const Vec2& p : path.points) {
        all.append(reinterpret_cast<const char*>(&p), sizeof p);
      }
    }
    return all;
  };
  const std::string one = drawn(1);
  EXPECT_FALSE(one.empty());
  EXPECT_EQ(drawn(2), one);
  EXPECT_EQ(drawn(0), one);
}

TEST_F(DimensionRows, GoWithWhatIsCutOpenOrComesApart) {
  plan_.views = {"top"};
  plan_.sections = {{.planes = {{.axis = {0, 1, 0}, .side = -1, .offset = 40}}, .own_view = true}};
  add(Kind::Depth, {at({63.25, 40, 8})});
  EXPECT_EQ(texts(), (Texts{{"A-A", {"8"}}}));
  SetUp();
  plan_.sections = {{.planes = {{.axis = {0, 1, 0}, .side = -1, .offset = 30}}}};
  add(Kind::Diameter, {at({28.5, 15, 6})});
  add(Kind::Diameter, {at({63.25, 40, 8})});
  EXPECT_EQ(texts(), (Texts{{"top", {"⌀6.5"}}}));
  EXPECT_EQ(told(), "dimension 1 (diameter) is not drawn: a section takes what it measures away");
  SetUp();
  scene_.parts.push_back(
      {"lid", "a.step",
       test::brep_form(BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 12), gp_Pnt(80, 50, 15)).Shape())});
  plan_.explode.wanted = true;
  plan_.explode.steps = {{.move = {"lid"}, .by = 30}};
  add(Kind::Distance, {at({40, 25, 0}), at({40, 25, 15})});
  add(Kind::Distance, {{.part = "lid", .at = {0, 25, 14}}, {.part = "lid", .at = {80, 25, 14}}});
  EXPECT_EQ(texts(), (Texts{{"front", {"80"}}}));
  EXPECT_EQ(told(), "dimension 1 (distance) is not drawn: its parts have come apart");
  EXPECT_NEAR(plan_.measured[0].moved.z, 30, 1e-9);
}

/// A model that changes about what is measured.
TEST_F(DimensionRows, StayAtTheirFeaturesInAChangedModel) {
  add(Kind::Diameter, {at({28.5, 15, 6})});
  add(Kind::Distance, {at({0, 25, 6}), at({63.25, 40, 8})});
  select_parts(scene_, plan_);
  keep_features(scene_, plan_, context_);
  const std::vector<DimensionRow> kept = plan_.dimensions;
  ASSERT_TRUE(kept[0].of[0].number);
  const auto changed = [&](double length, const std::vector<Hole>& holes) {
    SetUp();
    plan_.dimensions = kept;
    scene_.parts[0].form = test::brep_form(plate(length, holes));
    return texts();
  };
  const std::vector<std::string> same{"⌀17", "60"};
  EXPECT_EQ(changed(80, kHoles), (Texts{{"top", same}}));
  // Faces have other numbers: holes in another order, and one more.
  EXPECT_EQ(changed(80, {{50, 25, 2}, kHoles[1], kHoles[0]}), (Texts{{"top", same}}));
  // Longer, and the holes moved and grew a bit.
  EXPECT_EQ(changed(90, {{22, 15, 9}, {60, 40, 3.25, 4}}), (Texts{{"top", {"⌀18", "60"}}}));
  EXPECT_EQ(told("dimensions.lost"), "");
  EXPECT_EQ(changed(80, {kHoles[1]}), (Texts{{"top", {"60"}}}));
  EXPECT_NE(told("dimensions.lost").find("dimension 1 (diameter) lost its place"),
            std::string::npos);
}

}  // namespace
}  // namespace burin
