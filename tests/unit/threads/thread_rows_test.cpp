// What rows of threads ask and what is said of them.
#include "threads.h"

namespace burin::test {
namespace {

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
  EXPECT_NE(told(row("part", "M8"), bolt_shape(), "threads.no_face")
                .find("no shaft of 8 mm and no hole of 6.547 to 7.662 or 8 mm"),
            std::string::npos);
  ThreadRow numbered = row("part", "M10");
  numbered.face = 77;
  EXPECT_NE(
      told(numbered, bolt_shape(), "threads.no_face").find("it has no face 77; they are 0 to"),
      std::string::npos);
  // Neither the drill of M3.5 nor a hole that lets an M3.5 through.
  EXPECT_NE(told(row("part", "M3.5"), plate_with_hole_shape(), "threads.no_face"), "");
}

TEST(Threads, OfHolesAsWideAsTheyAreHaveThinLinesBesideThem) {
  Illustration asked = seen_from(kZ, kY, {row("part", "M4")});
  const auto arcs =
      paths_of(drawn(scene_of({{"part", plate_with_hole_shape()}}), asked), LineClass::Thread);
  ASSERT_EQ(arcs.size(), 1U);
  for (const Vec3& p : arcs[0].points3) {
    EXPECT_NEAR(glm::distance(Vec2(p), Vec2(5, 4)), 2 + 0.7 / 2, 1e-6);
  }
}

TEST(Threads, ThatCannotBeAsAskedAreToldOf) {
  ThreadRow longer = row("part", "M10");
  longer.length = 60;
  EXPECT_NE(told(longer, bolt_shape(), "threads.shorter").find("its cylinder ends after 39.81 mm"),
            std::string::npos);
  longer.length = 20;
  EXPECT_EQ(told(longer, bolt_shape(), "threads.shorter"), "");
  const Drawing d = drawn(scene_of({{"bolt", bolt_shape()}}),
                          seen_from(-kY, kZ, {row("bolt", "M10"), row("bolt", "M10x1")}));
  EXPECT_TRUE(std::ranges::any_of(d.diagnostics.entries(), [](const Diagnostic& one) {
    return one.code == "threads.replaced" &&
           one.message.find("'bolt': M10x1 instead of M10") != std::string::npos;
  }));
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
}  // namespace burin::test
