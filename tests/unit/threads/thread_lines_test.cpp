/// Threads of a bolt and of a plate, as a drawing shows them.

#include <burin/arrange/arrange.h>
#include <burin/base/error.h>
#include <burin/surface/placed_form.h>
#include <burin/threads/metric.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <burin_test/brep_shapes.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace burin {
namespace {

const double kMinorM10 = minor_diameter(10, 1.5), kMinorM6 = minor_diameter(6, 1);

gp_Ax2 up_from(double x, double y, double z) { return {gp_Pnt(x, y, z), gp_Dir(0, 0, 1)}; }

/// M10: a head from z = 0 to 6, a shaft down to z = -39, a chamfer of 1 mm to z = -40.
TopoDS_Shape bolt_shape() {
  const TopoDS_Shape head = BRepPrimAPI_MakeCylinder(up_from(0, 0, 0), 9, 6).Shape();
  const TopoDS_Shape shaft = BRepPrimAPI_MakeCylinder(up_from(0, 0, -39), 5, 39).Shape();
  const TopoDS_Shape tip = BRepPrimAPI_MakeCone(up_from(0, 0, -40), 4, 5, 1).Shape();
  return BRepAlgoAPI_Fuse(BRepAlgoAPI_Fuse(head, shaft).Shape(), tip).Shape();
}

/// 60 x 40 x 20 with a drill of 5 mm all through at 15, 20 and one of 8.5 mm, 14 deep, at 42, 20.
TopoDS_Shape plate_shape() {
  const TopoDS_Shape plate = test::box_shape(60, 40, 20);
  const TopoDS_Shape through = BRepPrimAPI_MakeCylinder(up_from(15, 20, -5), 2.5, 30).Shape();
  const TopoDS_Shape blind = BRepPrimAPI_MakeCylinder(up_from(42, 20, 6), 4.25, 20).Shape();
  return BRepAlgoAPI_Cut(BRepAlgoAPI_Cut(plate, through).Shape(), blind).Shape();
}

Scene scene_of(const std::vector<std::pair<std::string, TopoDS_Shape>>& parts) {
  Scene scene;
  for (const auto& [name, shape] : parts) {
    scene.parts.push_back({.name = name, .source = "", .form = test::brep_form(shape)});
  }
  return scene;
}

ThreadRow row(const std::string& select, const std::string& size) {
  ThreadRow out;
  out.select = {select};
  out.size = size;
  return out;
}

Illustration seen_from(Vec3 direction, Vec3 up, std::vector<ThreadRow> threads) {
  Illustration out;
  out.style = builtin_style("outline");
  out.view.direction = direction;
  out.view.up = up;
  out.view.scale = 2;
  out.thread_rows = std::move(threads);
  return out;
}

const Vec3 kY(0, 1, 0), kZ(0, 0, 1);

/// The paths of threads, of one kind, seen or hidden.
std::vector<Path> paths_of(const Drawing& drawing, LineClass kind, bool visible = true) {
  std::vector<Path> out;
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      if (path.kind == kind && path.visible == visible) out.push_back(path);
    }
  }
  return out;
}

Drawing drawn(Scene scene, Illustration illustration) {
  RunContext context;
  return illustrate(std::move(scene), std::move(illustration), context);
}

double length(const Path& path) {
  double sum = 0;
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    sum += glm::distance(path.points[i - 1], path.points[i]);
  }
  return sum;
}

/// Paper mm from the vertical line through the middle of the sheet, where the axis is.
struct Extent {
  double low, high;
};
Extent across(const Path& path, int coordinate) {
  Extent out{1e300, -1e300};
  for (const Vec2& p : path.points) {
    out.low = std::min(out.low, p[coordinate]);
    out.high = std::max(out.high, p[coordinate]);
  }
  return out;
}

TEST(Threads, OfABoltSeenFromTheSideAreTwoLinesAtTheMinorDiameter) {
  const Drawing d =
      drawn(scene_of({{"bolt", bolt_shape()}}), seen_from(-kY, kZ, {row("bolt", "M10")}));
  const auto lines = paths_of(d, LineClass::Thread);
  ASSERT_EQ(lines.size(), 2U);
  const double axis = 0.5 * (across(lines[0], 0).low + across(lines[1], 0).low);
  for (const Path& line : lines) {
    // 1e-6 of the model, at two to one.
    EXPECT_NEAR(std::abs(across(line, 0).low - axis), kMinorM10, 2e-6);
    EXPECT_NEAR(std::abs(across(line, 0).high - axis), kMinorM10, 2e-6);
    // From the head to where the chamfer is as narrow as the thread.
    EXPECT_NEAR(length(line), 2 * (40 - (0.5 * kMinorM10 - 4)), 1e-3);
    EXPECT_EQ(line.width, std::vector<double>{0.18});
    EXPECT_EQ(line.source.part, 0);
    EXPECT_GE(line.source.face, 0);
    for (const Vec3& p : line.points3) EXPECT_NEAR(std::abs(p.x), 0.5 * kMinorM10, 1e-6);
  }
  EXPECT_TRUE(paths_of(d, LineClass::ThreadEnd).empty()) << "it ends at the head and in the air";
}

TEST(Threads, SeenFromTheEndAreThreeQuartersOfACircle) {
  const Drawing d =
      drawn(scene_of({{"bolt", bolt_shape()}}), seen_from(-kZ, kY, {row("bolt", "M10")}));
  const auto lines = paths_of(d, LineClass::Thread);
  ASSERT_EQ(lines.size(), 1U);
  const Path& arc = lines[0];
  double turned = 0;
  for (std::size_t i = 0; i < arc.points3.size(); ++i) {
    const Vec2 from(arc.points3[i]);
    EXPECT_NEAR(glm::length(from), 0.5 * kMinorM10, 1e-6);
    // From below the right is where x is negative.
    EXPECT_FALSE(from.x < -1e-6 && from.y > 1e-6) << "the quarter up and right is open";
    if (i == 0) continue;
    const Vec2 before(arc.points3[i - 1]);
    turned += std::atan2(cross2(before, from), glm::dot(before, from));
  }
  EXPECT_NEAR(std::abs(turned) * 180 / std::numbers::pi, 270, 1e-6);
}

TEST(Threads, ThatEndOnAShaftHaveAWideLineThere) {
  ThreadRow thread = row("bolt", "M10");
  thread.length = 26;
  const Drawing d = drawn(scene_of({{"bolt", bolt_shape()}}), seen_from(-kY, kZ, {thread}));
  const auto ends = paths_of(d, LineClass::ThreadEnd);
  ASSERT_EQ(ends.size(), 1U);
  EXPECT_NEAR(length(ends[0]), 2 * 10, 1e-3) << "as wide as the bolt";
  for (const Vec3& p : ends[0].points3) EXPECT_NEAR(p.z, -40 + (0.5 * kMinorM10 - 4) + 26, 1e-9);
  EXPECT_EQ(ends[0].width, std::vector<double>{builtin_style("outline").line.contour});
  for (const Path& line : paths_of(d, LineClass::Thread)) EXPECT_NEAR(length(line), 52, 1e-3);
}

TEST(Threads, AreHiddenBehindAnotherPart) {
  // A wall before the lower half of the shaft.
  TopoDS_Shape wall = BRepPrimAPI_MakeBox(gp_Pnt(-20, -20, -60), gp_Pnt(20, -15, -20)).Shape();
  Illustration asked = seen_from(-kY, kZ, {row("bolt", "M10")});
  const Scene scene = scene_of({{"bolt", bolt_shape()}, {"wall", wall}});
  const auto seen = paths_of(drawn(scene, asked), LineClass::Thread);
  ASSERT_EQ(seen.size(), 2U);
  for (const Path& line : seen) EXPECT_NEAR(length(line), 2 * 20, 2e-3);
  asked.illustrate.hidden = HiddenLines::Dashed;
  const auto hidden = paths_of(drawn(scene, asked), LineClass::Thread, false);
  // The rest of both lines, and the circle at the tip, which is seen from its edge.
  double longest = 0;
  for (const Path& line : hidden) longest = std::max(longest, length(line));
  EXPECT_NEAR(longest, 2 * (20 - (0.5 * kMinorM10 - 4)), 2e-3);
}

TEST(Threads, OfHolesAreHiddenUntilTheyAreCut) {
  Illustration asked = seen_from(-kY, kZ, {row("plate", "M6"), row("plate", "M10")});
  EXPECT_TRUE(
      paths_of(drawn(scene_of({{"plate", plate_shape()}}), asked), LineClass::Thread).empty());
  asked.illustrate.hidden = HiddenLines::Dashed;
  const auto hidden =
      paths_of(drawn(scene_of({{"plate", plate_shape()}}), asked), LineClass::Thread, false);
  int at_major = 0;
  for (const Path& line : hidden) {
    for (const double x : {12.0, 18.0, 37.0, 47.0}) {
      at_major +=
          std::abs(line.points3.front().x - x) < 1e-6 && std::abs(line.points3.back().x - x) < 1e-6
              ? 1
              : 0;
    }
  }
  EXPECT_EQ(at_major, 4);
  asked.illustrate.hidden = HiddenLines::None;
  asked.sections.push_back({.planes = {{.axis = kY, .side = -1, .offset = 20.0}}});
  const auto cut = paths_of(drawn(scene_of({{"plate", plate_shape()}}), asked), LineClass::Thread);
  ASSERT_EQ(cut.size(), 4U);
  for (const Path& line : cut) {
    const double x = line.points3.front().x;
    const double major = std::abs(x - 15) < 5 ? 3 : 5, middle = major == 3 ? 15 : 42;
    EXPECT_NEAR(std::abs(x - middle), major, 1e-6);
    EXPECT_NEAR(length(line), 2 * (major == 3 ? 20 : 14), 1e-6);
  }
}

TEST(Threads, OfHolesSeenFromTheEndAreArcsAtTheMajorDiameter) {
  const Drawing d = drawn(scene_of({{"plate", plate_shape()}}),
                          seen_from(kZ, kY, {row("plate", "M6"), row("plate", "M10")}));
  const auto arcs = paths_of(d, LineClass::Thread);
  ASSERT_EQ(arcs.size(), 2U);
  for (const Path& arc : arcs) {
    const double major = arc.points3.front().x < 30 ? 3 : 5, x = major == 3 ? 15 : 42;
    for (const Vec3& p : arc.points3) {
      EXPECT_NEAR(std::hypot(p.x - x, p.y - 20), major, 1e-6);
      EXPECT_NEAR(p.z, 20, 1e-9);
    }
  }
}

TEST(Threads, InACutTheirEndGoesAcrossToTheThinLines) {
  ThreadRow thread = row("plate", "M10");
  thread.length = 10;
  Illustration asked = seen_from(-kY, kZ, {thread});
  asked.sections.push_back({.planes = {{.axis = kY, .side = -1, .offset = 20.0}}});
  const auto ends =
      paths_of(drawn(scene_of({{"plate", plate_shape()}}), asked), LineClass::ThreadEnd);
  double low = 1e300, high = -1e300;
  for (const Path& end : ends) {
    for (const Vec3& p : end.points3) {
      EXPECT_NEAR(p.z, 10, 1e-6);
      low = std::min(low, p.x);
      high = std::max(high, p.x);
    }
  }
  EXPECT_NEAR(low, 37, 1e-6);
  EXPECT_NEAR(high, 47, 1e-6);
}

TEST(Threads, StayOnPartsThatAreMirroredOrMoved) {
  Scene scene = scene_of({{"bolt", bolt_shape()}});
  const Placement mirrored{Mat3(-1, 0, 0, 0, 1, 0, 0, 0, 1), {7, -3, 2}};
  scene.parts[0].form = placed(scene.parts[0].form, mirrored);
  const auto lines =
      paths_of(drawn(scene, seen_from(-kY, kZ, {row("bolt", "M10")})), LineClass::Thread);
  ASSERT_EQ(lines.size(), 2U);
  for (const Path& line : lines) {
    for (const Vec3& p : line.points3) EXPECT_NEAR(std::abs(p.x - 7), 0.5 * kMinorM10, 1e-6);
  }
}

TEST(Threads, GoWithPartsThatComeApart) {
  Illustration asked = seen_from(-kY, kZ, {row("bolt", "M10")});
  asked.explode.wanted = true;
  asked.explode.steps = {{.move = {"bolt"}, .along = kZ, .by = 50}};
  const auto lines = paths_of(
      drawn(scene_of({{"bolt", bolt_shape()}, {"block", test::box_shape(30, 30, 30)}}), asked),
      LineClass::Thread);
  ASSERT_EQ(lines.size(), 2U);
  for (const Path& line : lines) {
    double top = -1e300;
    for (const Vec3& p : line.points3) top = std::max(top, p.z);
    EXPECT_NEAR(top, 50, 1e-6);
  }
}

TEST(Threads, HaveTheSameWidthsAtAnyScale) {
  Illustration asked = seen_from(-kY, kZ, {row("bolt", "M10")});
  const auto at = [&](double scale) {
    asked.view.scale = scale;
    return paths_of(drawn(scene_of({{"bolt", bolt_shape()}}), asked), LineClass::Thread);
  };
  const auto small = at(1), large = at(4);
  ASSERT_EQ(small.size(), 2U);
  ASSERT_EQ(large.size(), 2U);
  EXPECT_EQ(small[0].width, large[0].width);
  EXPECT_NEAR(4 * length(small[0]), length(large[0]), 1e-3);
}

TEST(Threads, KeepADistanceOnSmallDrawings) {
  Illustration asked = seen_from(-kY, kZ, {row("bolt", "M10")});
  asked.view.scale = 0.5;
  const auto lines = paths_of(drawn(scene_of({{"bolt", bolt_shape()}}), asked), LineClass::Thread);
  ASSERT_EQ(lines.size(), 2U);
  for (const Path& line : lines) {
    // 0.7 mm on paper, where the roots are 0.4 mm from the outline.
    for (const Vec3& p : line.points3) EXPECT_NEAR(std::abs(p.x), 5 - 0.7 / 0.5, 1e-6);
  }
  asked.style.line.thread_gap = 0;
  for (const Path& line :
       paths_of(drawn(scene_of({{"bolt", bolt_shape()}}), asked), LineClass::Thread)) {
    for (const Vec3& p : line.points3) EXPECT_NEAR(std::abs(p.x), 0.5 * kMinorM10, 1e-6);
  }
  asked.style.line.thread_gap = 0.7;
  asked.view.scale = 0.25;
  const Drawing tiny = drawn(scene_of({{"bolt", bolt_shape()}}), asked);
  EXPECT_TRUE(paths_of(tiny, LineClass::Thread).empty());
  EXPECT_TRUE(std::ranges::any_of(tiny.diagnostics.entries(), [](const Diagnostic& one) {
    return one.code == "threads.small" && one.count == 1;
  }));
}

TEST(Threads, ObliqueLinesLieOnThePartAndTheProofHolds) {
  Illustration asked = seen_from({1, -1, 1}, kZ, {row("bolt", "M10")});
  asked.illustrate.verify = true;
  asked.illustrate.hidden = HiddenLines::Dashed;
  const Drawing d = drawn(scene_of({{"bolt", bolt_shape()}}), asked);
  for (const Path& line : paths_of(d, LineClass::Thread)) {
    for (const Vec3& p : line.points3) EXPECT_LT(std::hypot(p.x, p.y), 5 + 1e-9);
  }
  ASSERT_TRUE(d.stats.verify);
  EXPECT_EQ(d.stats.verify->contradicted, 0);
}

TEST(Threads, OfPerspectiveViewsTouchTheCylinderOfTheRoots) {
  Illustration asked = seen_from({1, -1, 0.3}, kZ, {row("bolt", "M10")});
  asked.view.scale.reset();
  asked.view.perspective = 30;
  Scene scene = scene_of({{"bolt", bolt_shape()}});
  RunContext context;
  arrange_parts(scene, asked, context);
  const SheetOfViews sheet = plan_sheet(scene, asked);
  const Drawing d = illustrate(scene, sheet, asked, context);
  int straight = 0;
  for (const Path& line : paths_of(d, LineClass::Thread)) {
    if (length(line) < 20) continue;
    ++straight;
    for (const Vec3& p : line.points3) {
      // From the axis to the line of sight through the point.
      const Vec3 to = glm::cross(sheet.camera().to_viewer(p), kZ);
      EXPECT_NEAR(std::abs(glm::dot(p, to)) / glm::length(to), 0.5 * kMinorM10, 1e-6);
    }
  }
  EXPECT_GE(straight, 2);
}

TEST(Threads, CanBeTurnedOff) {
  Illustration asked = seen_from(-kY, kZ, {row("bolt", "M10")});
  asked.style.feature.threads = false;
  EXPECT_TRUE(
      paths_of(drawn(scene_of({{"bolt", bolt_shape()}}), asked), LineClass::Thread).empty());
}

std::string refused(const ThreadRow& thread) {
  try {
    drawn(scene_of({{"bolt", bolt_shape()}}), seen_from(-kY, kZ, {thread}));
  } catch (const UsageError& e) {
    return e.what();
  }
  return {};
}

TEST(Threads, ThatSayNothingAreRefusedInOneLine) {
  EXPECT_NE(refused(row("blot", "M10")).find("'bolt'"), std::string::npos)
      << refused(row("blot", "M10"));
  EXPECT_NE(refused(row("bolt", "6 mm")).find("'6 mm' is no size"), std::string::npos);
  EXPECT_NE(refused(row("bolt", "M10x40")).find("too long"), std::string::npos);
  EXPECT_NE(refused(row("bolt", "")).find("a thread has a size"), std::string::npos);
  ThreadRow short_one = row("bolt", "M10");
  short_one.length = -1;
  EXPECT_NE(refused(short_one).find("length takes"), std::string::npos);
  ThreadRow odd = row("bolt", "M10");
  odd.minor = 11;
  EXPECT_NE(refused(odd).find("minor diameter"), std::string::npos);
}

std::string told(const ThreadRow& thread, const TopoDS_Shape& shape, const std::string& id) {
  const Drawing d = drawn(scene_of({{"part", shape}}), seen_from(-kY, kZ, {thread}));
  for (const Diagnostic& one : d.diagnostics.entries()) {
    if (one.code == id) return one.message;
  }
  return {};
}

TEST(Threads, WithoutACylinderOfTheirSizeAreToldOf) {
  EXPECT_NE(told(row("part", "M8"), bolt_shape(), "threads.no_face").find("no shaft of 8 mm"),
            std::string::npos);
  // A hole as wide as the thread itself is not drilled for it.
  EXPECT_NE(told(row("part", "M4"), test::plate_with_hole_shape(), "threads.no_face")
                .find("as wide as the thread"),
            std::string::npos);
}

TEST(Threads, AreOnTheCylinderNextToAPoint) {
  ThreadRow near = row("part", "M6");
  near.at = Vec3(15, 20, 20);
  near.length = 5;
  Illustration asked = seen_from(-kY, kZ, {near});
  asked.sections.push_back({.planes = {{.axis = kY, .side = -1, .offset = 20.0}}});
  const auto lines = paths_of(drawn(scene_of({{"part", plate_shape()}}), asked), LineClass::Thread);
  ASSERT_EQ(lines.size(), 2U);
  for (const Path& line : lines) {
    for (const Vec3& p : line.points3) EXPECT_GE(p.z, 15 - 1e-6) << "from the end near the point";
  }
  near.at = Vec3(15, 20, 60);
  EXPECT_NE(told(near, plate_shape(), "threads.no_face").find("40 mm from its point"),
            std::string::npos);
  near.at.reset();
  near.start = 25;
  EXPECT_NE(told(near, plate_shape(), "threads.no_face").find("20 mm long"), std::string::npos);
}

TEST(Threads, WithoutARowOfTheTableSayWhatTheyAreDrawnAs) {
  ThreadRow thread = row("part", "");
  thread.diameter = 9.95;  // of a shaft of 10
  EXPECT_NE(told(thread, bolt_shape(), "threads.no_table").find("0.85"), std::string::npos);
  thread.pitch = 1.5;
  EXPECT_EQ(told(thread, bolt_shape(), "threads.no_table"), "");
}

}  // namespace
}  // namespace burin
