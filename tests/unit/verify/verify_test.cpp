// The drawing's own proof: that it finds each kind of wrong line, where it is, and nothing else.
#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/drawing/writers.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/forms/recognised/recognised_form.h>
#include <burin/illustrate/illustrate.h>
#include <burin/verify/verify.h>

#include <burin_test/hulls.h>
#include <burin_test/shapes.h>
#include <burin_test/turned.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <sstream>

namespace burin {
namespace {

// A box (part 0) of 40 x 30 x 20 and a ball (part 1) of radius 12 before it, from the front.
Scene box_and_ball() {
  Scene scene;
  const auto add = [&](const char* name, TriMesh mesh) {
    scene.parts.push_back({name, name, std::make_shared<MeshForm>(std::move(mesh))});
  };
  add("box", test::box({-20, 0, -10}, {20, 30, 10}));
  TriMesh ball = test::ellipsoid({12, 12, 12}, 96, 48);
  for (Vec3& p : ball.positions) p += Vec3(15, -20, 0);
  add("ball", std::move(ball));
  return scene;
}

Camera camera_of(const Scene& scene, const char* view = "front",
                 std::optional<double> perspective = {}) {
  const NamedView v = named_view(view);
  return Camera::fit(
      [&](const Mat3& axes) { return scene.bounds(axes); },
      {.direction = v.direction, .up = v.up, .perspective = perspective, .paper = {150, 100}});
}

Drawing drawn(const Scene& scene, const Camera& camera, const Style& style,
              IllustrateOptions options = {}) {
  RunContext context;
  options.verify = true;
  return illustrate(scene, camera, style, options, context);
}

Path line(Vec3 a, Vec3 b, bool visible, std::int32_t part = 0) {
  Path path;
  path.kind = LineClass::Crease;
  path.visible = visible;
  path.source.part = part;
  path.points3 = {a, b};
  return path;
}

struct Verdict {
  Verification result;
  Diagnostics diagnostics;
};
Verdict judge(const std::vector<Path>& lines, std::vector<PartOpacity> parts = {}) {
  const Scene scene = box_and_ball();
  const Camera camera = camera_of(scene);
  RunContext context;
  Verdict v;
  v.result =
      verify({}, lines, scene, camera,
             {.tolerance = 0.05 / camera.scale(), .parts = std::move(parts), .outline = false},
             v.diagnostics, context);
  return v;
}
double scale() { return camera_of(box_and_ball()).scale(); }

TEST(Verify, LinesThatAreWhatTheySayHold) {
  const Verdict v = judge({line({-20, 0, -10}, {-20, 0, 10}, true),     // an edge before the eye
                           line({-20, 30, -10}, {-20, 30, 10}, false),  // one right behind it
                           line({-19, 30, -10}, {-19, 30, 10}, false),
                           line({15, 0, -10}, {15, 0, 10}, false)});  // behind the ball
  EXPECT_EQ(v.result.spans, 4);
  EXPECT_NEAR(v.result.length, 80 * scale(), 1e-6);
  EXPECT_EQ(v.result.count, 0);
  EXPECT_EQ(v.result.contradicted, 0);
  EXPECT_TRUE(v.diagnostics.empty());
}

TEST(Verify, TellsALineThatSomethingCovers) {
  // Along the front face, from the open into the ball's shade: that begins 12 mm beside its middle.
  const Verdict v = judge({line({-10, 0, 0}, {13, 0, 0}, true)});
  ASSERT_EQ(v.result.count, 1);
  const Contradiction& c = v.result.contradictions.front();
  EXPECT_EQ(c.what, "covered");
  EXPECT_EQ(c.source.part, 0);
  EXPECT_NEAR(c.length, 10 * scale(), 0.4);
  EXPECT_NEAR(c.model.x, 8, 0.3 / scale());
  EXPECT_NEAR(v.result.contradicted, c.length, 1e-9);
  EXPECT_NEAR(v.result.share(), c.length / (23 * scale()), 1e-9);
  ASSERT_EQ(v.diagnostics.entries().size(), 1u);
  EXPECT_EQ(v.diagnostics.entries()[0].code, "verify.covered");
  const std::string& message = v.diagnostics.entries()[0].message;
  EXPECT_NE(message.find("part 'box'"), std::string::npos) << message;
  EXPECT_NE(message.find("mm of the sheet"), std::string::npos) << message;
}

TEST(Verify, TellsALineThatIsTakenForHiddenInTheOpen) {
  const Verdict v = judge({line({-10, 0, 0}, {13, 0, 0}, false)});
  ASSERT_EQ(v.result.count, 1);
  EXPECT_EQ(v.result.contradictions.front().what, "open");
  EXPECT_NEAR(v.result.contradictions.front().length, 13 * scale(), 0.4);
  // An edge of its own part, and a contour, where one side of the line is deeper.
  EXPECT_EQ(judge({line({-20, 0, -10}, {20, 0, -10}, false)}).result.count, 1);
  EXPECT_EQ(judge({line({-20, 0, -10}, {-20, 0, 10}, false)}).result.count, 1);
}

// The sheet shows the same with it and without: which of both is in front, 0.001 mm apart, rays do
// not know.
TEST(Verify, ALineThatIsLeftOutBesideOneThatIsDrawnIsNotMissing) {
  const auto beside = [&](double paper_mm, bool drawn) {
    const double x = -10 + paper_mm / scale();
    return judge({line({-10, 0, -10}, {-10, 0, 10}, drawn), line({x, 0, -9}, {x, 0, 9}, false)})
        .result.count;
  };
  EXPECT_EQ(beside(0.03, true), 0);
  EXPECT_EQ(beside(0.1, true), 1);
  EXPECT_EQ(beside(0.03, false), 2);
}

// A plate 0.14 mm thick on the sheet: its far lower edges lie 0.1 mm beside the upper ones on paper
// and 0.24 mm behind the upper face, which is not their own.
TEST(Verify, AnEdgeRightBehindAThinWallIsHidden) {
  const Vec3 low(-20, -20, 0);
  const auto plate = [&](Vec3 high) {
    Scene made;
    made.parts.push_back({"plate", "plate", std::make_shared<MeshForm>(test::box(low, high))});
    return made;
  };
  const double thickness = 0.14 / camera_of(plate({20, 20, 0.1}), "iso").scale();
  const Scene scene = plate({20, 20, thickness});
  const Camera camera = camera_of(scene, "iso");
  const auto contradicted = [&](double z, bool flipped) {
    std::vector<Path> lines;
    for (int i = 0; i < 4; ++i) {
      const Vec3 out(std::array{1, 0, -1, 0}[static_cast<std::size_t>(i)],
                     std::array{0, 1, 0, -1}[static_cast<std::size_t>(i)], 0);
      const Vec3 along(-out.y, out.x, 0), middle = (z > 0 ? 19.0 : 20.0) * out + Vec3(0, 0, z);
      const bool seen = z > 0 || glm::dot(out, camera.direction()) > 0;
      lines.push_back(line(middle - 19.0 * along, middle + 19.0 * along, seen != flipped));
    }
    RunContext context;
    Diagnostics diagnostics;
    return verify({}, lines, scene, camera, {.tolerance = 0.05 / camera.scale(), .outline = false},
                  diagnostics, context)
        .count;
  };
  EXPECT_EQ(contradicted(0, false), 0);
  EXPECT_EQ(contradicted(thickness, false), 0);
  EXPECT_EQ(contradicted(thickness, true), 4);  // lines on the upper face
}

TEST(Verify, TellsALineWhereNoSurfaceIs) {
  const Verdict v = judge({line({-22, 0, -10}, {-22, 0, 10}, true),    // beside the box
                           line({-10, -5, -5}, {-10, -5, 5}, true)});  // before it
  ASSERT_EQ(v.result.count, 2);
  for (const Contradiction& c : v.result.contradictions) EXPECT_EQ(c.what, "adrift");
}

// A flat sheet that is seen from its edge meets no ray of the viewer.
TEST(Verify, ALineOfASheetSeenFromItsEdgeHolds) {
  Scene scene;
  scene.parts.push_back({"sheet", "sheet",
                         std::make_shared<MeshForm>(
                             test::grid(5, 5, false, false, [](std::uint32_t i, std::uint32_t j) {
                               return Vec3(10.0 * i - 20, 10.0 * j, 0);
                             }))});
  scene.parts.push_back(
      {"box", "box", std::make_shared<MeshForm>(test::box({-20, 0, 5}, {20, 40, 20}))});
  const Camera camera = camera_of(scene);
  const auto count = [&](double z) {
    RunContext context;
    Diagnostics diagnostics;
    // Its border, as much off it as lines are that are drawn round, and within it.
    const double off = 0.02 / camera.scale();
    const std::vector<Path> lines{line({-19, -off, z}, {19, -off, z}, true),
                                  line({-19, 20, z}, {19, 20, z}, true)};
    return verify({}, lines, scene, camera, {.tolerance = 0.05 / camera.scale(), .outline = false},
                  diagnostics, context)
        .count;
  };
  EXPECT_EQ(count(0), 0);
  EXPECT_EQ(count(-0.5 / camera.scale()), 2);  // beside the sheet is nothing
}

TEST(Verify, WhatIsShorterThanHalfAMillimetreIsNoContradiction) {
  const double s = scale();
  const auto into_the_shade = [&](double paper_mm) {
    return judge({line({-10, 0, 0}, {3 + paper_mm / s, 0, 0}, true)}).result.count;
  };
  EXPECT_EQ(into_the_shade(0.3), 0);
  EXPECT_EQ(into_the_shade(1.0), 1);
  EXPECT_EQ(judge({line({3.5, 0, 0}, {3.5 + 0.4 / s, 0, 0}, true)}).result.spans, 0);
}

TEST(Verify, ATransparentPartHidesItselfAlone) {
  const std::vector<Path> behind{line({15, 0, -10}, {15, 0, 10}, true)};
  EXPECT_EQ(judge(behind).result.count, 1);
  EXPECT_EQ(judge(behind, {PartOpacity::Solid, PartOpacity::Transparent}).result.count, 0);
  EXPECT_EQ(judge(behind, {PartOpacity::Solid, PartOpacity::Absent}).result.count, 0);
  // The far side of the transparent ball.
  const std::vector<Path> own{line({15, -8, 0}, {15.5, -8.02, 2}, true, 1)};
  EXPECT_EQ(judge(own, {PartOpacity::Solid, PartOpacity::Transparent}).result.count, 1);
}

TEST(Verify, OurOwnDrawingsHold) {
  const Scene scene = box_and_ball();
  for (const char* view : {"iso", "front"}) {
    for (const std::optional<double> perspective : {std::optional<double>(), {40.0}}) {
      for (const char* style : {"outline", "haloed", "engraving"}) {
        const bool dashed = std::string(style) == "outline";
        const Drawing d = drawn(scene, camera_of(scene, view, perspective), builtin_style(style),
                                {.hidden = dashed ? HiddenLines::Dashed : HiddenLines::None});
        ASSERT_TRUE(d.stats.verify);
        EXPECT_GE(d.stats.verify->spans, 6);
        EXPECT_GT(d.stats.verify->length, 300);
        EXPECT_EQ(d.stats.verify->count, 0) << view << ' ' << style;
        EXPECT_EQ(d.stats.verify->loose_ends, 0) << view << ' ' << style;
      }
    }
  }
}

// Its contour is drawn round, up to 0.6 mm outside of facets that know how far they lie inside.
TEST(Verify, TheRoundOutlineOfACoarseBallHolds) {
  for (std::uint32_t n = 12; n <= 32; n += 2) {
    Scene scene;
    scene.parts.push_back(
        {"ball", "ball", std::make_shared<MeshForm>(test::ellipsoid({10, 10, 10}, 2 * n, n))});
    const Camera camera = camera_of(scene, "iso");
    const Drawing drawing = drawn(scene, camera, builtin_style("outline"));
    EXPECT_EQ(drawing.stats.verify->count, 0) << n << ": " << drawing.stats.verify->contradicted;
  }
}

// Whose edges are all creases, so that it is drawn, and judged, as flat facets.
TEST(Verify, TheFacetsOfACoarseBallHold) {
  Scene scene;
  scene.parts.push_back(
      {"ball", "ball", std::make_shared<MeshForm>(test::ellipsoid({10, 10, 10}, 24, 12))});
  const Camera camera = camera_of(scene, "iso");
  Style style = builtin_style("outline");
  style.feature.crease_angle = 5;
  const Drawing drawing = drawn(scene, camera, style);
  EXPECT_GT(drawing.stats.verify->spans, 100);
  EXPECT_EQ(drawing.stats.verify->count, 0) << drawing.stats.verify->contradicted;
}

// Seen almost along its axis normals that are off by 2 degrees move a contour by 20 mm along it.
TEST(Verify, TheRoundOutlineOfALongCoarseBallHolds) {
  Scene scene;
  scene.parts.push_back(
      {"ball", "ball", std::make_shared<MeshForm>(test::ellipsoid({10, 10, 40}, 16, 12))});
  for (const Vec3 view : {Vec3(1, -2, 9), Vec3(1, 0.3, 4), Vec3(2, -1, 1)}) {
    const Camera camera = Camera::fit([&](const Mat3& axes) { return scene.bounds(axes); },
                                      {.direction = view, .paper = {400, 280}});
    const Drawing drawing = drawn(scene, camera, builtin_style("outline"));
    EXPECT_EQ(drawing.stats.verify->count, 0)
        << view.z << ": " << drawing.stats.verify->contradicted;
  }
}

TEST(Verify, TellsWhereTheOuterOutlineIsMissing) {
  const Scene scene = box_and_ball();
  for (const std::optional<double> perspective : {std::optional<double>(), {40.0}}) {
    const Camera camera = camera_of(scene, "iso", perspective);
    Drawing d = drawn(scene, camera, builtin_style("outline"));
    ASSERT_EQ(d.stats.verify->count, 0);
    // The longest path of the outline is cut short by 4 mm at its end.
    Path* longest = nullptr;
    for (Layer& layer : d.layers) {
      for (Path& path : layer.paths) {
        if (layer.name != "outline" || path.closed) continue;
        if (!longest || glm::distance(path.points.front(), path.points.back()) >
                            glm::distance(longest->points.front(), longest->points.back())) {
          longest = &path;
        }
      }
    }
    ASSERT_TRUE(longest);
    const Vec2 end = longest->points.back(), before = *(longest->points.end() - 2);
    ASSERT_GT(glm::distance(end, before), 5);
    longest->points.back() = end + 4.0 * glm::normalize(before - end);
    RunContext context;
    Diagnostics diagnostics;
    const Verification v =
        verify(d, {}, scene, camera, {.tolerance = 0.05 / camera.scale()}, diagnostics, context);
    ASSERT_EQ(v.count, 1);
    EXPECT_EQ(v.contradictions[0].what, "missing");
    // Up to 0.25 mm of either end a line is near.
    EXPECT_NEAR(v.contradictions[0].length, 3.5, 0.6);
    EXPECT_LT(glm::distance(v.contradictions[0].at, end), 4.1);
    EXPECT_EQ(v.loose_ends, 2);  // it, and what it met
    EXPECT_EQ(diagnostics.entries()[0].code, "verify.missing");
  }
}

std::string json(const Drawing& drawing) {
  RunContext context;
  std::ostringstream out;
  write_json(drawing, {}, out, context);
  return out.str();
}

TEST(Verify, ChangesNothingAndIsTheSameForAnyNumberOfThreads) {
  const Scene scene = box_and_ball();
  const Camera camera = camera_of(scene, "iso");
  const Style style = builtin_style("engraving");
  Drawing with = drawn(scene, camera, style);
  {
    const ThreadLimit limit(1);
    EXPECT_EQ(json(with), json(drawn(scene, camera, style)));
  }
  RunContext context;
  const Drawing without = illustrate(scene, camera, style, {}, context);
  EXPECT_FALSE(without.stats.verify);
  with.stats.verify.reset();
  EXPECT_EQ(json(with), json(without));
}

TEST(Verify, CanBeCancelled) {
  RunContext context;
  context.cancel();
  Diagnostics diagnostics;
  const Scene scene = box_and_ball();
  const Camera camera = camera_of(scene);
  EXPECT_THROW(verify({}, {}, scene, camera, {}, diagnostics, context), Cancelled);
}

Drawing outline_of(std::vector<std::vector<Vec2>> paths, bool closed = false) {
  Drawing d;
  d.paper_width = d.paper_height = 100;
  Layer layer{"outline", {}};
  for (auto& points : paths) {
    Path path;
    path.closed = closed;
    for (const Vec2& p : points) path.points3.emplace_back(p, 0);
    path.points = std::move(points);
    layer.paths.push_back(std::move(path));
  }
  d.layers = {layer};
  return d;
}

TEST(LooseEnds, AreEndsOfTheOuterOutlineThatNothingGoesOnFrom) {
  EXPECT_EQ(loose_ends(outline_of({{{10, 10}, {50, 10}, {50, 50}}})).size(), 2u);
  // Closed as such, or by its ends alone, or by another path.
  EXPECT_TRUE(loose_ends(outline_of({{{10, 10}, {50, 10}, {50, 50}}}, true)).empty());
  EXPECT_TRUE(loose_ends(outline_of({{{10, 10}, {50, 10}, {50, 50}, {10, 10.2}}})).empty());
  EXPECT_TRUE(
      loose_ends(outline_of({{{10, 10}, {50, 10}}, {{50.2, 10}, {50, 50}, {10, 10}}})).empty());
  // A gap of 1 mm, told by its place.
  const auto ends = loose_ends(outline_of({{{10, 10}, {50, 10}}, {{51, 10}, {50, 50}, {10, 10}}}));
  ASSERT_EQ(ends.size(), 2u);
  EXPECT_EQ(ends[0].at, Vec2(50, 10));
  EXPECT_EQ(ends[1].at, Vec2(51, 10));
  // Where the sheet ends, the line may.
  EXPECT_TRUE(loose_ends(outline_of({{{0, 10}, {100, 10}}})).empty());
  // A crease that is met; a hidden line is none.
  Drawing met = outline_of({{{10, 10}, {50, 10}}});
  Path crease = met.layers[0].paths[0];
  crease.points = {{10, 0}, {10, 20}, {50, 20}, {50, 0}};
  met.layers.push_back({"crease", {crease}});
  EXPECT_TRUE(loose_ends(met).empty());
  met.layers[1].paths[0].visible = false;
  EXPECT_EQ(loose_ends(met).size(), 2u);
}

// Nothing crosses the sides of a pin where they come out of a hole of their size; they are short,
// but longer than a pen is wide.
TEST(Verify, ShortSidesOfAPinThatStandsOutAreDrawn) {
  Scene scene;
  const auto add = [&](const char* name, TriMesh mesh) {
    scene.parts.push_back(
        {name, name, std::make_shared<RecognisedForm>(std::move(mesh), RunContext())});
  };
  add("plate", test::turned({{5, 0}, {60, 0}, {60, 40}, {5, 40}}, 48, true));
  add("pin", test::turned({{5, -2}, {5, 30}}, 48));
  const NamedView v = named_view("1,-1,-1");
  const Camera camera = Camera::fit([&](const Mat3& axes) { return scene.bounds(axes); },
                                    {.direction = v.direction, .up = v.up, .paper = {80, 60}});
  const Drawing drawing = drawn(scene, camera, builtin_style("outline"));
  ASSERT_TRUE(drawing.stats.verify);
  EXPECT_TRUE(drawing.stats.verify->contradictions.empty());
  double sides = 0;
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      if (path.source.part != 1 || path.kind != LineClass::Contour) continue;
      for (std::size_t i = 1; i < path.points3.size(); ++i) {
        sides += std::abs(path.points3[i].z - path.points3[i - 1].z);
      }
    }
  }
  EXPECT_NEAR(sides, 4, 0.3);  // 2 mm of the model on both sides
}

// Its contours run along the rulings of the fans, and its flat faces are wholly seen or not.
void expect_hull_holds(std::shared_ptr<const Form> form,
                       const std::vector<const char*>& views = {
                           "iso", "0.3,-1,0.45", "-0.4,-1,0.55", "0.3,1,0.5", "1,-2,1", "front"}) {
  Scene scene;
  scene.parts.push_back({"hull", "hull", std::move(form)});
  for (const char* view : views) {
    SCOPED_TRACE(view);
    const Drawing drawing = drawn(scene, camera_of(scene, view), builtin_style("outline"));
    EXPECT_EQ(drawing.stats.verify->count, 0) << drawing.stats.verify->contradicted;
    EXPECT_EQ(drawing.stats.verify->loose_ends, 0);
  }
}

TEST(Verify, TheHullOfAPlateAndADiscHolds) {
  for (const std::uint32_t sides : {16u, 24u, 64u}) {
    SCOPED_TRACE(sides);
    expect_hull_holds(std::make_shared<MeshForm>(test::hull({.sides = sides})));
  }
}

// Of eight sides, whose wide faces bend by less than an edge has to.
TEST(Verify, TheHullOfAPlateAndAPrismHolds) {
  const TriMesh mesh = test::hull({.radius = 10, .sides = 8});
  expect_hull_holds(std::make_shared<RecognisedForm>(mesh, RunContext()),
                    {"iso", "0.3,1,0.5", "-0.4,-1,0.55"});
}

// Beside a pin that is known to be round.
TEST(Verify, TheHullOfAPlateAndADiscHoldsBesideAKnownCylinder) {
  TriMesh mesh = test::hull({});
  const TriMesh pin = test::turned({{5, 0}, {5, 30}}, 48);
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const Vec3& p : pin.positions) mesh.positions.push_back(p + Vec3(-20, 20, 0));
  for (const auto& [a, b, c] : pin.triangles) {
    mesh.triangles.push_back({first + a, first + b, first + c});
  }
  const auto form = std::make_shared<RecognisedForm>(std::move(mesh), RunContext());
  EXPECT_EQ(form->faces().cylinders, 1);
  expect_hull_holds(form);
}

}  // namespace
}  // namespace burin
