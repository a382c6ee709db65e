// The proof of areas: that it finds each kind of wrong one, where it is, and nothing else.
#include <burin/base/parallel.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/forms/recognised/recognised_form.h>
#include <burin/illustrate/illustrate.h>
#include <burin/tone/catalogue.h>
#include <burin/verify/areas.h>
#include <burin/verify/verify.h>

#include <burin_test/shapes.h>
#include <burin_test/turned.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <utility>

namespace burin {
namespace {

constexpr double kRadius = 12;

/// A box (part 0) of 40 x 30 x 20 and a ball (part 1) before it, from the front, in two tones.
struct Shown {
  Scene scene;
  Style style = builtin_style("outline");
  IllustrateOptions options{.face_areas = true};
  Vec2 paper{150, 100};

  Shown() {
    const auto add = [&](const char* name, TriMesh mesh) {
      scene.parts.push_back({name, name, std::make_shared<MeshForm>(std::move(mesh))});
    };
    add("box", test::box({-20, 0, -10}, {20, 30, 10}));
    TriMesh ball = test::ellipsoid(Vec3(kRadius), 96, 48);
    for (Vec3& p : ball.positions) p += Vec3(15, -20, 0);
    add("ball", std::move(ball));
    style.fill.color = "part";
    style.fill.steps = 2;
  }
  Camera camera() const {
    const NamedView v = named_view("front");
    return Camera::fit([&](const Mat3& axes) { return scene.bounds(axes); },
                       {.direction = v.direction, .up = v.up, .paper = {paper.x, paper.y}});
  }
  Drawing draw() const {
    RunContext context;
    return illustrate(scene, camera(), style, options, context);
  }
  struct Verdict {
    Verification result;
    Diagnostics diagnostics;
  };
  /// Of areas alone.
  Verdict judge(const std::vector<Area>& areas, std::vector<PartOpacity> parts = {},
                std::vector<double> ranks = {}) const {
    const Camera at = camera();
    const Isophotes light{tone::to_light(at, style.tone),
                          even_levels(static_cast<std::size_t>(style.fill.steps))};
    Drawing drawing;
    drawing.paper_width = paper.x, drawing.paper_height = paper.y;
    RunContext context;
    Verdict v;
    v.result = verify(drawing, {}, scene, at,
                      {.tolerance = 0.05 / at.scale(),
                       .parts = std::move(parts),
                       .outline = false,
                       .ranks = std::move(ranks),
                       .areas = AreaRule{areas, {light, light}}},
                      v.diagnostics, context);
    return v;
  }
  /// mm^2 of paper.
  double ball() const {
    return std::numbers::pi * kRadius * kRadius * camera().scale() * camera().scale();
  }
};

TEST(VerifyAreas, ThoseOfADrawingHold) {
  Shown s;
  for (const int steps : {0, 2, 5}) {
    s.style.fill.steps = steps;
    for (const bool faces : {false, true}) {
      s.options = {.verify = true, .face_areas = faces};
      const Drawing d = s.draw();
      ASSERT_TRUE(d.stats.verify);
      EXPECT_EQ(d.stats.verify->wrong_patches, 0) << steps << ' ' << faces;
      EXPECT_EQ(d.stats.verify->wrong_area, 0);
      EXPECT_GT(d.stats.verify->area, s.ball());
      EXPECT_LT(d.stats.verify->area, 150 * 100);
    }
  }
  s.style.fill.color = "none";
  s.options = {.verify = true};
  EXPECT_EQ(s.draw().stats.verify->area, 0) << "there are none";
}

TEST(VerifyAreas, ThoseOfANoisyMeshHold) {
  Shown s;
  s.scene.parts.clear();
  TriMesh ring = test::torus(12, 5, 40, 16);  // coarse: rays meet finer triangles than are drawn
  std::mt19937 random(7);
  std::uniform_real_distribution<double> off(-0.2, 0.2);
  for (Vec3& p : ring.positions) p += Vec3(off(random), off(random), off(random));
  s.scene.parts.push_back({"ring", "ring", std::make_shared<MeshForm>(std::move(ring))});
  s.style.fill.steps = 3;
  s.options = {.verify = true};
  const Drawing d = s.draw();
  ASSERT_TRUE(d.stats.verify);
  EXPECT_EQ(d.stats.verify->wrong_patches, 0) << d.stats.verify->wrong_area;
}

// A cone of narrow triangles from rim to rim, seen large: between their corners what is linear in
// its parameters lies some tenths of a mm of paper beside what is seen.
struct ShownCone : Shown {
  ShownCone() {
    scene.parts.clear();
    const TriMesh mesh = test::turned({{10, 0}, {2, 24}}, 96);
    const auto form = std::make_shared<RecognisedForm>(mesh, RunContext());
    EXPECT_EQ(form->faces().cones, 1);
    scene.parts.push_back({"cone", "cone", form});
    style.fill.steps = 3;
    options = {.verify = true};
    paper = {225, 300};
  }
};

TEST(VerifyAreas, TheStepsOfAConeAreThoseOfItsOwnNormals) {
  const Drawing d = ShownCone().draw();
  ASSERT_TRUE(d.stats.verify);
  EXPECT_GT(d.stats.verify->area, 2e4);
  EXPECT_EQ(d.stats.verify->wrong_patches, 0) << d.stats.verify->wrong_area;
}

TEST(VerifyAreas, AStepOfAConeThatIsHalfAMmAsideIsWrong) {
  const ShownCone s;
  std::vector<Area> areas = s.draw().areas;
  for (Area& area : areas) {
    if (area.tone == 2) continue;  // the lightest lies below the others
    for (auto& ring : area.rings) {
      for (Vec2& p : ring) p.x -= 0.5;
    }
  }
  const Verification v = s.judge(areas).result;
  const auto wrong_tone = [](const Contradiction& c) { return c.what == "wrong_tone"; };
  EXPECT_TRUE(std::ranges::any_of(v.contradictions, wrong_tone));
  EXPECT_GT(v.wrong_area, 30) << "half a mm along borders of 250 mm";
}

TEST(VerifyAreas, AnAreaOfAnotherPartIsWrong) {
  const Shown s;
  std::vector<Area> areas = s.draw().areas;
  for (Area& area : areas) area.part = 0, area.face = -1, area.tone = -1;
  const auto v = s.judge(areas);
  EXPECT_EQ(v.result.wrong_patches, 1);
  EXPECT_NEAR(v.result.wrong_area, s.ball(), 0.05 * s.ball());
  ASSERT_EQ(v.result.contradictions.size(), 1u);
  const Contradiction& c = v.result.contradictions[0];
  EXPECT_EQ(c.what, "wrong_part");
  EXPECT_EQ(c.source.part, 0);
  EXPECT_EQ(c.size, v.result.wrong_area);
  EXPECT_LT(glm::distance(c.at, s.camera().to_paper({15, -20, 0})), 2) << "in the middle";
  ASSERT_EQ(v.diagnostics.entries().size(), 1u);
  EXPECT_EQ(v.diagnostics.entries()[0].code, "verify.wrong_part");
  const std::string& message = v.diagnostics.entries()[0].message;
  EXPECT_NE(message.find("of part 'box'"), std::string::npos) << message;
  EXPECT_NE(message.find("of part 'ball' is seen"), std::string::npos) << message;
}

TEST(VerifyAreas, AnAreaThatIsMissingAndOneWhereNothingIsAreWrong) {
  const Shown s;
  std::vector<Area> areas = s.draw().areas;
  std::erase_if(areas, [](const Area& area) { return area.part == 1; });
  areas.push_back({.part = 1, .rings = {{{1, 1}, {3, 1}, {3, 3}, {1, 3}}}});
  const auto v = s.judge(areas);
  ASSERT_EQ(v.result.contradictions.size(), 2u);
  EXPECT_EQ(v.result.contradictions[0].source.part, -1) << "the ball, which no area has";
  EXPECT_EQ(v.result.contradictions[1].source.part, 1);
  EXPECT_NEAR(v.result.contradictions[1].size, 4, 1.2);
  EXPECT_NE(v.diagnostics.entries()[1].message.find("nothing is seen"), std::string::npos);
}

TEST(VerifyAreas, AnAreaOfAnotherFaceAndOneOfAnotherToneAreWrong) {
  const Shown s;
  const std::vector<Area> areas = s.draw().areas;
  std::vector<Area> faces = areas, tones = areas;
  for (Area& area : faces) area.face += area.part == 0 ? 1 : 0;
  for (Area& area : tones) area.tone = 1 - area.tone;
  const auto face = s.judge(faces);
  ASSERT_EQ(face.result.contradictions.size(), 1u);
  EXPECT_EQ(face.result.contradictions[0].what, "wrong_face");
  const auto tone = s.judge(tones);
  ASSERT_GE(tone.result.contradictions.size(), 1u);
  for (const Contradiction& c : tone.result.contradictions) EXPECT_EQ(c.what, "wrong_tone");
  EXPECT_NE(tone.diagnostics.entries()[0].message.find("have tone"), std::string::npos);
}

TEST(VerifyAreas, WhatIsSmallerThanAQuarterOfAMm2IsNoContradiction) {
  const Shown s;
  const Vec2 middle = s.camera().to_paper({-15, 0, 0});
  const auto with_square = [&](double side) {
    std::vector<Area> areas = s.draw().areas;
    const Vec2 a = middle - side / 2, b = middle + side / 2;
    areas.push_back({.part = 1, .rings = {{a, {b.x, a.y}, b, {a.x, b.y}}}});
    return s.judge(areas).result.wrong_patches;
  };
  EXPECT_EQ(with_square(0.5), 0);
  EXPECT_EQ(with_square(1.5), 1);
}

TEST(VerifyAreas, GlassLiesOverWhatIsSeenThroughIt) {
  Shown s;
  s.options = {.verify = true};
  s.options.part_styles.resize(2);
  s.options.part_styles[1].transparent = true;
  const Drawing d = s.draw();
  EXPECT_EQ(d.stats.verify->wrong_patches, 0);
  EXPECT_GT(d.stats.verify->area, 0);
  std::vector<Area> areas = d.areas;
  std::erase_if(areas, [](const Area& area) { return area.part == 1; });
  const std::vector<PartOpacity> parts = {PartOpacity::Solid, PartOpacity::Transparent};
  areas.push_back({.part = 1, .rings = {{{1, 1}, {3, 1}, {3, 3}, {1, 3}}}});
  areas.push_back({.part = -1, .rings = {{{1, 1}, {149, 1}, {149, 99}, {1, 99}}}});  // the sheet
  const auto v = s.judge(areas, parts);
  ASSERT_EQ(v.result.contradictions.size(), 2u);
  EXPECT_NEAR(v.result.contradictions[0].size, s.ball(), 0.05 * s.ball());
  EXPECT_EQ(v.result.contradictions[1].source.part, 1);
}

// A block that is flush in the box: the ranks say which of both is seen.
TEST(VerifyAreas, OfPartsThatLieOnEachOtherOneIsRight) {
  Shown s;
  s.scene.parts[1].form = std::make_shared<MeshForm>(test::box({-8, 0, -6}, {8, 20, 6}));
  s.style.fill.steps = 0;
  const std::vector<Area> areas = s.draw().areas;
  const double scale = s.camera().scale();
  EXPECT_EQ(s.judge(areas, {}, {0, 1}).result.wrong_patches, 0);
  EXPECT_EQ(s.judge(areas).result.wrong_patches, 1) << "the first of equal ones";
  const auto v = s.judge(areas, {}, {1, 0});
  ASSERT_EQ(v.result.wrong_patches, 1);
  EXPECT_NEAR(v.result.wrong_area, 16 * 12 * scale * scale, 0.05 * 16 * 12 * scale * scale);
}

TEST(VerifyAreas, AreJudgedAlikeByAnyNumberOfThreads) {
  const Shown s;
  std::vector<Area> areas = s.draw().areas;
  for (Area& area : areas) area.part = 0;
  const auto a = s.judge(areas);
  const ThreadLimit one(1);
  const auto b = s.judge(areas);
  EXPECT_EQ(a.result.wrong_area, b.result.wrong_area);
  EXPECT_EQ(a.result.contradictions[0].at, b.result.contradictions[0].at);
}

}  // namespace
}  // namespace burin
