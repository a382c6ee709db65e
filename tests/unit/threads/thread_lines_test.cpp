#include "threads.h"

namespace burin::test {
namespace {

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

TEST(Threads, SeenFromTheEndHaveNoCircleOfTheirChamfer) {
  const auto circles = [](std::vector<ThreadRow> rows) {
    const Drawing d =
        drawn(scene_of({{"bolt", bolt_shape()}}), seen_from(-kZ, kY, std::move(rows)));
    std::size_t count = 0;
    for (const Path& path : paths_of(d, LineClass::Crease)) {
      count += std::ranges::all_of(
          path.points3, [](Vec3 p) { return std::abs(glm::length(Vec2(p)) - 4) < 0.01; });
    }
    return count;
  };
  EXPECT_EQ(circles({}), 1U);
  EXPECT_EQ(circles({row("bolt", "M10")}), 0U);
  // From the side the chamfer has its line.
  const Drawing side =
      drawn(scene_of({{"bolt", bolt_shape()}}), seen_from(-kY, kZ, {row("bolt", "M10")}));
  EXPECT_TRUE(std::ranges::any_of(paths_of(side, LineClass::Crease), [](const Path& path) {
    return std::ranges::all_of(path.points3, [](Vec3 p) { return std::abs(p.z + 39) < 1e-6; });
  }));
}

// The quarter that is open stays open where hidden lines are drawn.
TEST(Threads, SeenFromTheEndDoNotShowWhereTheyEnd) {
  ThreadRow thread = row("plate", "M10");
  thread.length = 10;
  Illustration asked = seen_from(kZ, kY, {thread});
  asked.illustrate.hidden = HiddenLines::Dashed;
  const Drawing d = drawn(scene_of({{"plate", plate_shape()}}), asked);
  EXPECT_EQ(paths_of(d, LineClass::Thread).size(), 1U);
  EXPECT_TRUE(paths_of(d, LineClass::ThreadEnd, false).empty());
  EXPECT_TRUE(paths_of(d, LineClass::ThreadEnd).empty());
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
  const auto lines =
      paths_of(drawn(scene_of({{"bolt", bolt_shape()}, {"block", box_shape(30, 30, 30)}}), asked),
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
    return one.code == "threads.small" && one.severity == Severity::Warning && one.count == 1 &&
           one.message.find("(M10)") != std::string::npos &&
           one.message.find("from a scale of 1:2 on it has some") != std::string::npos;
  }));
  asked.view.scale = 0.5;
  EXPECT_EQ(paths_of(drawn(scene_of({{"bolt", bolt_shape()}}), asked), LineClass::Thread).size(),
            2U);
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

// A drill that leaves a plate at a slant: its thread goes to where the last of it leaves.
TEST(Threads, OfObliqueHolesEndAtTheFaces) {
  const gp_Ax2 slanted(gp_Pnt(30 - 20, 20, 10 - 20 * std::sqrt(3)), gp_Dir(1, 0, std::sqrt(3)));
  const TopoDS_Shape drill = BRepPrimAPI_MakeCylinder(slanted, 4.25, 80).Shape();
  const TopoDS_Shape plate = BRepAlgoAPI_Cut(box_shape(60, 40, 20), drill).Shape();
  Illustration asked = seen_from(-kY, kZ, {row("plate", "M10")});
  asked.illustrate.hidden = HiddenLines::Dashed;
  const Drawing d = drawn(scene_of({{"plate", plate}}), asked);
  EXPECT_TRUE(paths_of(d, LineClass::ThreadEnd).empty());
  EXPECT_TRUE(paths_of(d, LineClass::ThreadEnd, false).empty());
  const auto lines = paths_of(d, LineClass::Thread, false);
  ASSERT_EQ(lines.size(), 2U);
  for (const Path& line : lines) {
    double low = 1e300, high = -1e300;
    for (const Vec3& p : line.points3) low = std::min(low, p.z), high = std::max(high, p.z);
    // The gap on paper sets them off from where the last of the hole leaves.
    EXPECT_GE(low, 0);
    EXPECT_LE(high, 20);
    EXPECT_GT(high - low, 19.7);
  }
}

TEST(Threads, CanBeTurnedOff) {
  Illustration asked = seen_from(-kY, kZ, {row("bolt", "M10")});
  asked.style.feature.threads = false;
  EXPECT_TRUE(
      paths_of(drawn(scene_of({{"bolt", bolt_shape()}}), asked), LineClass::Thread).empty());
}

}  // namespace
}  // namespace burin::test
