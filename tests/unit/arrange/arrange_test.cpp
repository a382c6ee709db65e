// What the kernel makes of an illustration, without a file or an option.
#include <burin/annotate/legend_box.h>
#include <burin/arrange/arrange.h>
#include <burin/base/error.h>
#include <burin/drawing/font.h>
#include <burin/forms/mesh/mesh_form.h>

#include <burin_test/mesh_checks.h>
#include <burin_test/shapes.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <string>

namespace burin {
namespace {

Part part(const std::string& name, Vec3 low, Vec3 high) {
  return {name, "a.step", std::make_shared<MeshForm>(test::box(low, high))};
}

/// A plate, a block on it, and a bolt beside that.
Scene stack() {
  Scene scene;
  scene.parts = {part("plate", {0, 0, 0}, {40, 40, 4}), part("block", {5, 5, 4}, {20, 20, 24}),
                 part("bolt", {26, 12, 4}, {30, 16, 14})};
  return scene;
}

Box3 box_of(const Part& part) { return part.form->bounds(Mat3(1)); }

bool tells(const Diagnostics& diagnostics, const std::string& code) {
  return test::count_of(diagnostics, code) > 0;
}

TEST(Arrange, LaterLooksHold) {
  Scene scene = stack();
  Illustration illustration;
  illustration.looks = {{.select = {"*"}, .drawn = false},
                        {.select = {"b*"}, .drawn = true, .hatched = false},
                        {.select = {"bolt"}, .style = builtin_style("outline")}};
  select_parts(scene, illustration);
  const auto& styles = illustration.illustrate.part_styles;
  ASSERT_EQ(styles.size(), 3U);
  EXPECT_FALSE(styles[0].drawn);
  EXPECT_TRUE(styles[1].drawn);
  EXPECT_FALSE(styles[1].hatched);
  EXPECT_FALSE(styles[1].style);
  EXPECT_EQ(styles[2].style->name, "outline");
}

TEST(Arrange, ErrorsNameThePlaceOfTheLook) {
  Scene scene = stack();
  Illustration illustration;
  illustration.looks = {{.select = {"blok"}, .drawn = false, .place = "a.json:3: "}};
  try {
    select_parts(scene, illustration);
    FAIL() << "a part that is not there was selected";
  } catch (const UsageError& e) {
    EXPECT_TRUE(std::string(e.what()).starts_with("a.json:3: ")) << e.what();
    EXPECT_NE(std::string(e.what()).find("block"), std::string::npos) << e.what();
  }
}

TEST(Arrange, ASectionWithoutAnOffsetCutsTheMiddleAndTakesTheSideOfTheViewer) {
  Scene scene = stack();
  Illustration illustration;
  illustration.view.direction = {0, -1, 0};
  illustration.sections = {{.planes = {{.axis = {0, 1, 0}}}}};
  RunContext context;
  arrange_parts(scene, illustration, context);
  const auto plate = scene.parts[0].form->realise({}, context);
  Box3 left;
  for (const Vec3& p : plate->proxy().mesh.positions) left.add(p);
  EXPECT_NEAR(left.min.y, 20, 1e-9);
  EXPECT_NEAR(left.max.y, 40, 1e-9);
  EXPECT_FALSE(tells(scene.diagnostics, "section.missed"));
}

TEST(Arrange, ABoltStaysWholeByCustomUnlessAllIsToBeCut) {
  for (const bool all : {false, true}) {
    Scene scene = stack();
    Illustration illustration;
    illustration.view.direction = {0, -1, 0};
    illustration.sections = {{.planes = {{.axis = {0, 1, 0}, .offset = 14}}}};
    if (all) illustration.uncut = std::vector<std::string>{};
    const auto bolt = scene.parts[2].form;
    RunContext context;
    arrange_parts(scene, illustration, context);
    EXPECT_EQ(scene.parts[2].form == bolt, !all);
    EXPECT_EQ(tells(scene.diagnostics, "section.left_whole"), !all);
  }
}

TEST(Arrange, GivenStepsMoveTheirPartsByTheirFactor) {
  Scene scene = stack();
  Illustration illustration;
  illustration.explode.wanted = true;
  illustration.explode.steps = {{.move = {"block", "bolt"}, .by = 10}, {.move = {"bolt"}, .by = 6}};
  illustration.explode.factor = 0.5;
  RunContext context;
  arrange_parts(scene, illustration, context);
  EXPECT_NEAR(box_of(scene.parts[0]).min.z, 0, 1e-12);
  EXPECT_NEAR(box_of(scene.parts[1]).min.z, 4 + 5, 1e-12);
  EXPECT_NEAR(box_of(scene.parts[2]).min.z, 4 + 8, 1e-12);
  EXPECT_FALSE(illustration.illustrate.trails.empty());
}

TEST(Arrange, StepsThatAreFoundNameTheirParts) {
  Scene scene = stack();
  Illustration illustration;
  illustration.explode.wanted = true;
  RunContext context;
  select_parts(scene, illustration);
  const std::vector<ExplodeStep> steps = explode_steps(scene, illustration, context);
  std::vector<std::string> moved;
  for (const ExplodeStep& step : steps) {
    EXPECT_NEAR(step.along.z, 1, 1e-9);
    moved.insert(moved.end(), step.move.begin(), step.move.end());
  }
  std::ranges::sort(moved);
  EXPECT_EQ(moved, (std::vector<std::string>{"/block", "/bolt"}));
}

TEST(Arrange, ItemsAreNumberedWhereTheyAreAskedFor) {
  Scene scene = stack();
  scene.parts.push_back(part("bolt #2", {32, 12, 4}, {36, 16, 14}));
  Illustration illustration;
  RunContext context;
  arrange_parts(scene, illustration, context);
  EXPECT_FALSE(illustration.illustrate.annotations);
  illustration.callouts = true;
  arrange_parts(scene, illustration, context);
  const auto& items = illustration.illustrate.annotations->items;
  ASSERT_EQ(items.size(), 3U);
  EXPECT_EQ(items[2].name, "bolt");
  EXPECT_EQ(items[2].parts, (std::vector<std::int32_t>{2, 3}));
}

TEST(Arrange, ViewsStandAtOneScale) {
  Scene scene = stack();
  Illustration illustration;
  illustration.views = {"front", "top", "iso"};
  illustration.details = {{.select = {"bolt"}, .scale = 5}};
  RunContext context;
  arrange_parts(scene, illustration, context);
  const SheetOfViews sheet = plan_sheet(scene, illustration);
  ASSERT_EQ(sheet.views.size(), 4U);
  EXPECT_DOUBLE_EQ(sheet.views[0].camera.scale(), sheet.views[1].camera.scale());
  EXPECT_DOUBLE_EQ(sheet.views[3].camera.scale(), 5);
  ASSERT_EQ(sheet.details.size(), 1U);
  EXPECT_EQ(sheet.details[0].letter, "A");
  illustration.sheet.fits = true;
  EXPECT_THROW(plan_sheet(scene, illustration), UsageError);
}

/// Whether a disc lies in a box.
bool holds(const Box2& box, const Disc& disc) {
  const double radius = disc.radius - 1e-6;
  return box.contains(disc.center - radius) && box.contains(disc.center + radius);
}

TEST(Arrange, TheCircleOfADetailStaysInItsView) {
  for (const bool legend : {false, true}) {
    for (const bool list : {false, true}) {
      Scene scene = stack();
      Illustration illustration;
      illustration.style = builtin_style("flat");
      illustration.legend = legend;
      illustration.parts_list = list;
      // A corner of the plate, and more than all of it.
      illustration.details = {{.at = {40, 0, 0}, .radius = 8},
                              {.at = {0, 0, 0}, .radius = 30, .scale = 1}};
      RunContext context;
      arrange_parts(scene, illustration, context);
      const SheetOfViews sheet = plan_sheet(scene, illustration);
      ASSERT_EQ(sheet.details.size(), 2U);
      const Box2 paper = inside(illustration.view.paper, illustration.sheet.margin);
      for (const DetailMark& mark : sheet.details) {
        EXPECT_TRUE(holds(sheet.views[0].box, mark.from)) << legend << list;
        EXPECT_TRUE(holds(paper, mark.to)) << legend << list;
      }
    }
  }
}

TEST(Arrange, ADetailAboveTheListKeepsClearOfTheLegend) {
  Scene scene = stack();
  Illustration illustration;
  illustration.style = builtin_style("flat");
  illustration.legend = illustration.parts_list = true;
  illustration.style.callout.list_height = 8;
  illustration.details = {{.select = {"bolt"}, .scale = 5}};
  for (const Corner corner : {Corner::BottomRight, Corner::TopRight}) {
    illustration.style.callout.legend = corner;
    RunContext context;
    Scene one = scene;
    Illustration plan = illustration;
    arrange_parts(one, plan, context);
    const SheetOfViews sheet = plan_sheet(one, plan);
    const Annotations& over = *plan.illustrate.annotations;
    const auto list = parts_list_box(over, plan.style.callout, plan.view.paper),
               legend = legend_box(over, plan.style.callout, plan.view.paper);
    ASSERT_TRUE(list && legend);
    const Disc disc = sheet.details.at(0).to;
    const Box2 box{disc.center - disc.radius, disc.center + disc.radius};
    EXPECT_FALSE(legend->overlaps(box));
    EXPECT_FALSE(list->overlaps(box));
  }
}

/// A case that hides twenty parts.
Scene full_case() {
  Scene scene;
  scene.parts = {part("case", {0, 0, 0}, {120, 40, 15})};
  for (int i = 0; i < 20; ++i) {
    scene.parts.push_back(part("inner " + std::string(1, static_cast<char>('a' + i)),
                               {5 + 5.0 * i, 10, 2}, {8 + 5.0 * i, 20, 10}));
  }
  return scene;
}

/// In colours with a legend, seen from above.
Illustration flat_from_above(const Paper& paper) {
  Illustration illustration;
  illustration.style = builtin_style("flat");
  illustration.legend = true;
  illustration.view.paper = paper;
  illustration.view.direction = {0, 0, 1};
  illustration.view.up = {0, 1, 0};
  return illustration;
}

TEST(Arrange, ASheetThatFitsHasRoomForTheRowsOfTheLegendThatAreSeenAlone) {
  Illustration illustration;
  illustration.style = builtin_style("flat");
  illustration.sheet.fits = true;
  illustration.legend = true;
  illustration.view.direction = {0, -1, 0};
  RunContext context;
  const Drawing drawing = illustrate(full_case(), illustration, context);
  Scene alone = full_case();
  alone.parts.resize(1);
  const Drawing wanted = illustrate(alone, illustration, context);
  EXPECT_DOUBLE_EQ(drawing.paper_width, wanted.paper_width);
  EXPECT_DOUBLE_EQ(drawing.paper_height, wanted.paper_height);
  const auto squares = [](const Drawing& d) {
    return std::ranges::count(d.areas, std::string("legend"), &Area::role);
  };
  EXPECT_EQ(squares(drawing), 1);
  EXPECT_EQ(squares(wanted), 1);
}

TEST(Arrange, ASheetThatIsLaidOutAgainHasARowForEachColourThatIsSeenThen) {
  Illustration illustration;
  illustration.style = builtin_style("flat");
  illustration.sheet.fits = true;
  illustration.legend = true;
  illustration.view.direction = {0, -1, 0};
  RunContext context;
  Scene scene = full_case();
  scene.parts.push_back(part("sliver", {40, 10, 10}, {60, 20, 15.6}));
  arrange_parts(scene, illustration, context);
  Illustration small = illustration;
  small.view.scale = 0.05;  // the sliver is too thin to be seen
  const Drawing drawing = illustrate(scene, plan_sheet(scene, small), illustration, context);
  std::set<std::int32_t> areas, rows;
  for (const Area& area : drawing.areas) (area.role.empty() ? areas : rows).insert(area.part);
  EXPECT_EQ(areas, (std::set<std::int32_t>{0, 21}));
  EXPECT_EQ(rows, areas);
}

/// Whether there is a legend, and no box about its squares and names overlaps that of the parts.
bool legend_is_clear(const Drawing& drawing) {
  Box2 legend, parts;
  for (const Area& area : drawing.areas) {
    for (const auto& ring : area.rings) {
      for (const Vec2& p : ring) (area.role.empty() ? parts : legend).add(p);
    }
  }
  for (const Layer& layer : drawing.layers) {
    if (layer.name != "legend") continue;
    for (const Text& text : layer.texts) {
      legend.add(text.at + Vec2(text_width(text.text, text.height), 0));
    }
  }
  return !legend.empty() && !legend.overlaps(parts);
}

TEST(Arrange, PartsOfOneNameAndSeveralShapesHaveSeveralColours) {
  Scene scene;
  scene.parts = {part("plates", {0, 0, 0}, {10, 10, 2}), part("plates #2", {20, 0, 0}, {30, 10, 2}),
                 part("plates #3", {0, 20, 0}, {10, 30, 8}), part("rod", {20, 20, 0}, {21, 21, 9})};
  Illustration illustration;
  illustration.style = builtin_style("flat");
  for (const bool legend : {false, true}) {
    illustration.legend = legend;
    RunContext context;
    const Drawing drawing = illustrate(scene, illustration, context);
    std::map<std::int32_t, std::string> fill;
    for (const Area& area : drawing.areas) {
      if (area.role.empty()) fill[area.part] = area.fill;
    }
    EXPECT_EQ(fill.at(0), fill.at(1)) << "copies";
    const std::set<std::string> all{fill.at(0), fill.at(2), fill.at(3)};
    EXPECT_EQ(all.size(), 3u);
  }
}

TEST(Arrange, ALegendThatTellsNothingApartIsTold) {
  Illustration illustration;
  illustration.legend = true;
  RunContext context;
  const auto told = [&](const char* style) {
    Scene scene = full_case();
    illustration.style = builtin_style(style);
    number_parts(scene, illustration, context);
    return std::ranges::count(scene.diagnostics.entries(), "legend.alike", &Diagnostic::code);
  };
  EXPECT_EQ(told("flat"), 0);
  EXPECT_EQ(told("duotone"), 1);
  // Where the input has one colour for all, no style tells them apart.
  Scene grey = full_case();
  for (Part& part : grey.parts) part.color = "#808080";
  number_parts(grey, illustration, context);
  EXPECT_NE(grey.diagnostics.entries().back().message.find("by `highlight`"), std::string::npos);
  // All the others look otherwise, and have no row.
  PartStyle pale;
  pale.style = builtin_style("flat");
  pale.style->fill.legend = false;
  illustration.illustrate.part_styles = {pale};
  EXPECT_EQ(told("duotone"), 0);
}

TEST(Arrange, ALegendOfSomeOfTheColoursStandsWhereRoomIsKeptForAll) {
  const Illustration illustration = flat_from_above({148, 105});
  RunContext context;
  for (std::size_t hidden = 1; hidden <= 8; ++hidden) {
    for (std::size_t shown = 1; shown <= 11; ++shown) {
      Scene scene = full_case();
      scene.parts.resize(1 + hidden + shown);
      for (std::size_t i = 0; i < shown; ++i) {  // these stand upon the case
        const double x = 10.0 * static_cast<double>(i);
        scene.parts[1 + hidden + i] =
            part("knob " + std::string(1, static_cast<char>('a' + i)), {x, 5, 15}, {x + 8, 20, 20});
      }
      const Drawing drawing = illustrate(std::move(scene), illustration, context);
      EXPECT_TRUE(legend_is_clear(drawing)) << hidden << " hidden, " << shown << " shown";
    }
  }
}

TEST(Arrange, ALegendOfFewRowsThatAreSeenLeavesTheSheetToTheDrawing) {
  const Illustration illustration = flat_from_above({105, 74});
  const auto scale = [&](const Scene& scene) {
    RunContext context;
    const Drawing drawing = illustrate(scene, illustration, context);
    EXPECT_TRUE(legend_is_clear(drawing));
    return drawing.view.scale;
  };
  Scene alone = full_case();
  alone.parts.resize(1);
  EXPECT_EQ(scale(full_case()), scale(alone)) << "colours that are not seen take no space";
}

TEST(Arrange, ALegendThatHasRoomForWhatIsSeenKeepsClearOfTheDrawing) {
  Illustration illustration = flat_from_above({});
  illustration.style.callout.list_height = 12;  // twenty rows have none
  RunContext context;
  const Drawing drawing = illustrate(full_case(), illustration, context);
  EXPECT_TRUE(legend_is_clear(drawing));
  EXPECT_FALSE(tells(drawing.diagnostics, "legend.no_room"));
}

TEST(Arrange, ViewsStandInLineThoughPartsCastAShadowOnTheGround) {
  Scene scene = stack();
  Illustration illustration;
  illustration.style = builtin_style("shaded");
  illustration.views = {"front", "top", "left"};
  RunContext context;
  const SheetOfViews sheet = plan_sheet(scene, illustration);
  const Vec3 p(3, 4, 5);
  EXPECT_NEAR(sheet.views[0].camera.to_paper(p).x, sheet.views[1].camera.to_paper(p).x, 1e-9);
  EXPECT_NEAR(sheet.views[0].camera.to_paper(p).y, sheet.views[2].camera.to_paper(p).y, 1e-9);
  const auto shadows = [](const Drawing& drawing) {
    return std::ranges::count(drawing.areas, -1, &Area::part);
  };
  EXPECT_EQ(shadows(illustrate(scene, sheet, illustration, context)), 0);
  illustration.views.push_back("iso");
  EXPECT_EQ(shadows(illustrate(scene, plan_sheet(scene, illustration), illustration, context)), 1);
}

TEST(Arrange, OneCallDrawsWhatTheThreeDo) {
  Illustration illustration;
  illustration.style = builtin_style("outline");
  illustration.explode = {.wanted = true, .along = Vec3(0, 0, 1)};
  illustration.callouts = true;
  illustration.title = "stack";
  RunContext context;
  const Drawing at_once = illustrate(stack(), illustration, context);
  Scene scene = stack();
  arrange_parts(scene, illustration, context);
  const Drawing drawing = illustrate(scene, plan_sheet(scene, illustration), illustration, context);
  EXPECT_EQ(at_once.title, "stack");
  EXPECT_EQ(at_once.items.size(), 3U);
  ASSERT_EQ(at_once.layers.size(), drawing.layers.size());
  for (std::size_t i = 0; i < drawing.layers.size(); ++i) {
    ASSERT_EQ(at_once.layers[i].paths.size(), drawing.layers[i].paths.size());
    for (std::size_t k = 0; k < drawing.layers[i].paths.size(); ++k) {
      EXPECT_EQ(at_once.layers[i].paths[k].points, drawing.layers[i].paths[k].points);
    }
  }
}

TEST(Arrange, ASheetThatIsMostlyEmptyIsTold) {
  Illustration illustration;
  illustration.view.scale = 0.1;
  RunContext context;
  EXPECT_TRUE(tells(illustrate(stack(), illustration, context).diagnostics, "sheet.mostly_empty"));
  illustration.view.scale.reset();
  EXPECT_FALSE(tells(illustrate(stack(), illustration, context).diagnostics, "sheet.mostly_empty"));
}

}  // namespace
}  // namespace burin
