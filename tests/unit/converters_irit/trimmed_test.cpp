// TRIMSRF: exact faces within their trimming loops.
#include <burin/surface/surface.h>

#include "reading.h"

#include <cmath>
#include <numbers>

namespace burin {
namespace {

using std::numbers::pi;
using test::expect_error;

/// Of `burin info`, as kernel/docs/spline_files.md says.
constexpr double kArea = 1e-6;

PartInfo info_of_part(const std::string& bytes, std::size_t part = 0, std::size_t parts = 1) {
  const test::TempFile file("a.itd", bytes);
  RunContext context;
  const FileInfo info = inspect_irit(file.path(), context);
  EXPECT_EQ(info.parts.size(), parts);
  return info.parts.at(part);
}

std::string trimmed_object(const std::string& name, const std::string& inside) {
  return "[OBJECT " + name + "\n" + inside + "]\n";
}
std::string trimmed(const std::string& surface, const std::string& loops) {
  return "[TRIMSRF " + surface + "\n" + loops + "]";
}
std::string loop(const std::string& curves) { return "[TRIMCRV " + curves + "]\n"; }
std::string segment(const std::string& curve) { return "[TRIMCRVSEG " + curve + "]"; }

/// The square from (0, 0) to (10, 10) in z = 0; its parameters are a tenth of x and y.
const std::string kSquare = "[SURFACE BEZIER 2 2 E3 [0 0 0] [10 0 0] [0 10 0] [10 10 0]]";

/// A rational circle in the parameters; `turn` -1: clockwise.
std::string circle(double u, double v, double r, int turn = 1) {
  std::string text = "[CURVE BSPLINE 9 3 P2 [KV 0 0 0 1 1 2 2 3 3 4 4 4]";
  for (int i = 0; i <= 8; ++i) {
    const double w = i % 2 == 0 ? 1 : std::sqrt(0.5), a = turn * i * pi / 4;
    text += fmt::format(" [{} {} {}]", w, w * u + r * std::cos(a), w * v + r * std::sin(a));
  }
  return loop(segment(text + "]"));
}

std::string polygon(const std::vector<Vec2>& corners) {
  std::string knots = "0", points;
  for (std::size_t i = 0; i <= corners.size(); ++i) {
    knots += fmt::format(" {}", i);
    points += fmt::format(" [{} {}]", corners[i % corners.size()].x, corners[i % corners.size()].y);
  }
  return loop(segment(fmt::format("[CURVE BSPLINE {} 2 E2 [KV {} {}]{}]", corners.size() + 1, knots,
                                  corners.size(), points)));
}

std::string line(Vec2 a, Vec2 b) {
  return segment(fmt::format("[CURVE BEZIER 2 E2 [{} {}] [{} {}]]", a.x, a.y, b.x, b.y));
}

/// An arc of the cylinder of radius 1 about z, up to 1, in quarters.
std::string trimmed_cylinder(int from, int quarters) {
  std::string knots, points;
  for (int k = 0; k <= quarters; ++k) knots += fmt::format(" {0} {0}", k);
  for (int z = 0; z < 2; ++z) {
    for (int i = 0; i <= 2 * quarters; ++i) {
      const double w = i % 2 == 0 ? 1 : std::sqrt(0.5), a = (from + 0.5 * i) * pi / 2;
      points += fmt::format(" [{} {} {} {}]", w, std::cos(a), std::sin(a), w * z);
    }
  }
  return fmt::format("[SURFACE BSPLINE {} 2 3 2 P3 [KV 0{} {}] [KV 0 0 1 1]{}]", 2 * quarters + 1,
                     knots, quarters, points);
}

TEST(IritTrimmed, ACircleOfAPlane) {
  const std::string bytes = trimmed_object("DISC", trimmed(kSquare, circle(0.5, 0.5, 0.3)));
  const PartInfo info = info_of_part(bytes);
  EXPECT_EQ(info.name, "DISC");
  EXPECT_EQ(info.faces, 1);
  EXPECT_EQ(info.edges, 1);
  EXPECT_EQ(info.boundary_edges, 1);
  EXPECT_NEAR(info.area / (9 * pi), 1, kArea);
  test::expect_near(info.bounds.min, {2, 2, 0}, 1e-4);
  test::expect_near(info.bounds.max, {8, 8, 0}, 1e-4);

  const Scene scene = test::scene_of(bytes);
  EXPECT_TRUE(scene.diagnostics.empty());
  RealiseOptions options;
  options.tolerance = 1e-3;
  RunContext context;
  const auto surface = scene.parts.at(0).form->realise(options, context);
  const ProxyMesh& proxy = surface->proxy();
  std::size_t on_border = 0;
  for (std::size_t h = 0; h < proxy.topology.opposite.size(); ++h) {
    const Vec3 p = proxy.mesh.positions[proxy.mesh.triangles[h / 3][h % 3]];
    EXPECT_LE(glm::distance(p, Vec3(5, 5, 0)), 3 + 1e-6);
    if (proxy.topology.opposite[h] != kNoHalfEdge) continue;
    EXPECT_NEAR(glm::distance(p, Vec3(5, 5, 0)), 3, 1e-6);
    ++on_border;
  }
  EXPECT_GT(on_border, 16u);
}

TEST(IritTrimmed, HolesAndIslandsWhicheverWayTheyTurn) {
  const std::string border = polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  for (const int turn : {1, -1}) {
    const PartInfo hole =
        info_of_part(trimmed_object("H", trimmed(kSquare, border + circle(.5, .5, .4, turn))));
    EXPECT_EQ(hole.faces, 1);
    EXPECT_EQ(hole.edges, 5);
    EXPECT_NEAR(hole.area / (100 - 16 * pi), 1, kArea);
  }
  // The hole before the border, an island in the hole, a hole in the island.
  const std::string loops =
      circle(.5, .5, .4) + border + circle(.5, .5, .1, -1) + circle(.5, .5, .3);
  const PartInfo island = info_of_part(trimmed_object("I", trimmed(kSquare, loops)), 0, 1);
  EXPECT_EQ(island.faces, 2);
  EXPECT_NEAR(island.area / (100 - 16 * pi + 9 * pi - pi), 1, kArea);
}

TEST(IritTrimmed, APeriodicCurve) {
  // Four parabolas about half the square of the control points: 5/6 of it.
  const std::string curve =
      "[CURVE BSPLINE 4 3 E3 [KVP 0 1 2 3 4 5 6 7 8] [.2 .2 0] [.8 .2 0] [.8 .8 0] [.2 .8 0]]";
  const PartInfo info = info_of_part(trimmed_object("P", trimmed(kSquare, loop(segment(curve)))));
  EXPECT_EQ(info.edges, 1);
  EXPECT_NEAR(info.area / 30, 1, kArea);
}

TEST(IritTrimmed, ThePatchWithoutALoop) {
  const PartInfo square = info_of_part(trimmed_object("S", trimmed(kSquare, "")));
  EXPECT_EQ(square.edges, 4);
  EXPECT_NEAR(square.area, 100, 100 * kArea);
  // Its two sides are one edge.
  const PartInfo round = info_of_part(trimmed_object("C", trimmed(trimmed_cylinder(0, 4), "")));
  EXPECT_EQ(round.edges, 3);
  EXPECT_EQ(round.boundary_edges, 2);
  EXPECT_NEAR(round.area / (2 * pi), 1, kArea);
}

TEST(IritTrimmed, ALoopAroundAClosedSurface) {
  const PartInfo info = info_of_part(trimmed_object(
      "C", trimmed(trimmed_cylinder(0, 4), polygon({{0, 0}, {4, 0}, {4, 0.5}, {0, 0.5}}))));
  EXPECT_EQ(info.edges, 3);
  EXPECT_EQ(info.boundary_edges, 2);
  EXPECT_NEAR(info.area / pi, 1, kArea);
}

TEST(IritTrimmed, APeriodicSurface) {
  // Three parabolas of the triangle of the control points: 2/3 of it, times the height.
  const std::string surface =
      "[SURFACE BSPLINE 3 2 3 2 E3 [KVP 0 1 2 3 4 5 6 7] [KV 0 0 1 1] [0 0 0] [6 0 0] [0 6 0] "
      "[0 0 1] [6 0 1] [0 6 1]]";
  const PartInfo whole = info_of_part(trimmed_object("S", "[TRIMSRF " + surface + "]"));
  const PartInfo half = info_of_part(
      trimmed_object("S", trimmed(surface, polygon({{2, 0.5}, {5, 0.5}, {5, 1}, {2, 1}}))));
  EXPECT_EQ(whole.edges, 3);
  EXPECT_EQ(half.edges, 3);
  EXPECT_GT(whole.area, 8);
  EXPECT_NEAR(half.area / whole.area, 0.5, kArea);
}

TEST(IritTrimmed, FacesOfOneObjectShareTheirBorders) {
  const std::string loops = polygon({{0, 0}, {2, 0}, {2, 1}, {0, 1}});
  const std::string halves =
      trimmed(trimmed_cylinder(0, 2), loops) + trimmed(trimmed_cylinder(2, 2), loops);
  const PartInfo info = info_of_part(trimmed_object("C", halves));
  EXPECT_EQ(info.faces, 2);
  EXPECT_EQ(info.edges, 6);
  EXPECT_EQ(info.boundary_edges, 4);
  EXPECT_NEAR(info.area / (2 * pi), 1, kArea);
  // A whole patch beside a trimmed one is a face like it.
  const PartInfo mixed = info_of_part(
      trimmed_object("C", trimmed(trimmed_cylinder(0, 2), loops) + trimmed_cylinder(2, 2)));
  EXPECT_EQ(mixed.faces, 2);
  EXPECT_EQ(mixed.boundary_edges, 4);
  // Objects without names are one part.
  const PartInfo list = info_of_part(
      trimmed_object("L", trimmed_object("[COLOR 4]", trimmed(trimmed_cylinder(0, 2), loops)) +
                              trimmed_object("[COLOR 4]", trimmed(trimmed_cylinder(2, 2), loops))));
  EXPECT_EQ(list.name, "L");
  EXPECT_EQ(list.edges, 6);
}

TEST(IritTrimmed, BordersThatNearlyFitAreOneEdge) {
  // The second square begins so much beside the end of the first.
  const auto edges = [](double gap) {
    const std::string other =
        fmt::format("[SURFACE BEZIER 2 2 E3 [{0} 0 0] [20 0 5] [{0} 10 0] [20 10 5]]", 10 + gap);
    return info_of_part(trimmed_object("S", trimmed(kSquare, "") + trimmed(other, ""))).edges;
  };
  EXPECT_EQ(edges(0), 7);
  EXPECT_EQ(edges(1e-4), 7);
  EXPECT_EQ(edges(1e-2), 8);
}

TEST(IritTrimmed, HolesThatLieClose) {
  // 900 holes, and 50 rings as wide as what lies between them.
  std::string holes = polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}), rings;
  for (int row = 0; row < 30; ++row) {
    for (int column = 0; column < 30; ++column) {
      holes += circle((row + 0.5) / 30, (column + 0.5) / 30, 0.012);
    }
  }
  double area = 0;
  for (int i = 0; i < 100; ++i) {
    const double r = 0.49 - 5e-4 * i;
    rings += circle(0.5, 0.5, r);
    area += (i % 2 == 0 ? 100 : -100) * pi * r * r;
  }
  const PartInfo plate = info_of_part(trimmed_object("P", trimmed(kSquare, holes)));
  EXPECT_EQ(plate.edges, 904);
  EXPECT_NEAR(plate.area, 100 - 900 * pi * 0.0144, 100 * kArea);
  const PartInfo ringed = info_of_part(trimmed_object("R", trimmed(kSquare, rings)));
  EXPECT_EQ(ringed.faces, 50);
  EXPECT_NEAR(ringed.area / area, 1, 1e-5);
}

TEST(IritTrimmed, CurvesThatTurnAndThatNearlyMeet) {
  // The second runs against the loop; ends lie as far apart as six digits leave them.
  const std::string loops = loop(line({0.1, 0.1}, {0.9, 0.1}) + line({0.9, 0.5}, {0.900001, 0.1}) +
                                 line({0.9, 0.500001}, {0.1, 0.1}));
  const PartInfo info = info_of_part(trimmed_object("T", trimmed(kSquare, loops)));
  EXPECT_EQ(info.edges, 3);
  EXPECT_NEAR(info.area, 16, 1e-4);
}

TEST(IritTrimmed, CurvesInSpaceAreNotNeeded) {
  const std::string space = "[CURVE BEZIER 2 E3 [1 1 0] [7 7 7]]";
  const std::string with = loop("[TRIMCRVSEG [CURVE BEZIER 2 E2 [.1 .1] [.9 .1]] " + space + "]" +
                                line({.9, .1}, {.9, .9}) + line({.9, .9}, {.1, .1}));
  EXPECT_NEAR(info_of_part(trimmed_object("T", trimmed(kSquare, with))).area, 32, 32 * kArea);
}

TEST(IritTrimmed, SidesThatArePoints) {
  // A triangle whose fourth side is a point.
  const std::string cone = "[SURFACE BEZIER 2 2 E3 [0 0 0] [4 0 0] [0 3 0] [0 3 0]]";
  const PartInfo info =
      info_of_part(trimmed_object("T", trimmed(cone, polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}))));
  EXPECT_NEAR(info.area, 6, 6 * kArea);
  EXPECT_EQ(info.boundary_edges, 3);
}

TEST(IritTrimmed, InstancesMove) {
  const std::string bytes =
      trimmed_object("A", trimmed(kSquare, circle(0.5, 0.5, 0.3))) +
      trimmed_object("B", "[INSTANCE A 2 0 0 0  0 2 0 0  0 0 2 0  100 0 7 1]");
  const PartInfo moved = info_of_part(bytes, 1, 2);
  EXPECT_EQ(moved.name, "B");
  EXPECT_NEAR(moved.area / (36 * pi), 1, kArea);
  test::expect_near(moved.bounds.min, {104, 4, 7}, 1e-4);
}

TEST(IritTrimmedErrors, InTheText) {
  expect_error("[OBJECT A\n [TRIMSRF x]]", 2, "column 11: 'x' is not the [SURFACE");
  expect_error("[OBJECT A\n[TRIMSRF [CURVE BEZIER 2 E2 [0 0] [1 1]]]]", 2, "is not the [SURFACE");
  expect_error(trimmed_object("A", trimmed(kSquare, "[TRIMCRV]")), 3,
               "column 9: ']' is not the [TRIMCRVSEG");
  expect_error(trimmed_object("A", trimmed(kSquare, "[TRIMCRV [TRIMCRVSEG]]")), 3,
               "is not the [CURVE");
  expect_error(trimmed_object("A", trimmed(kSquare, "[CURVE BEZIER 2 E2 [0 0] [1 1]]")), 3,
               "column 2: 'CURVE' is not the [TRIMCRV ");
  expect_error(trimmed_object("A", trimmed(kSquare, circle(.5, .5, .3))).substr(0, 150), 3,
               "cannot fit");
}

TEST(IritTrimmedErrors, OfLoops) {
  const auto bad = [](const std::string& loops, std::int64_t line, const std::string& part) {
    expect_error(trimmed_object("A", trimmed(kSquare, loops)), line, part);
  };
  bad(loop(line({.1, .1}, {.9, .1}) + line({.9, .1}, {.9, .9})), 3,
      "column 2: this trimming loop cannot be read: it does not close: curve 2 ends at (0.9, 0.9), "
      "the next begins at (0.1, 0.1)");
  bad(circle(.5, .5, .6), 3,
      "it leaves the domain of its surface, u from 0 to 1 and v from 0 to 1");
  bad(circle(.5, .5, .3) + loop(line({.1, .1}, {.9, .1}) + line({.9, .1}, {.1, .1})), 4,
      "it encloses nothing");
  bad(circle(.4, .5, .3) + circle(.6, .5, .3), 3, "crosses the one of line 4");
  bad(loop(segment("[CURVE BSPLINE 4 2 E2 [KV 0 0 1 1 2 2] [0 0] [1 0] [0 1] [0 0]]")), 3,
      "the knot 1 occurs 2 times");
}

TEST(IritTrimmedErrors, Limits) {
  std::string many;
  for (int i = 0; i < 1001; ++i) many += circle(.5, .5, .3);
  expect_error(trimmed_object("A", trimmed(kSquare, many)), 2, "1001 trimming loops; at most 1000");
  std::string high = "[CURVE BEZIER 27 E2";
  for (int i = 0; i < 27; ++i)
    high += fmt::format(" [{} {}]", .1 + (i % 26) * .02, .1 + i % 2 * .1);
  expect_error(trimmed_object("A", trimmed(kSquare, loop(segment(high + "]")))), 3,
               "its degree is 26");
  std::vector<Vec2> teeth;
  for (int i = 0; i < 3000; ++i) {
    teeth.push_back({.1 + .8 * i / 3000, .1});
    teeth.push_back({.1 + .8 * (i + .5) / 3000, .2});
  }
  teeth.push_back({.9, .9});
  expect_error(trimmed_object("A", trimmed(kSquare, polygon(teeth))), 3, "too many points");
}

TEST(IritTrimmed, OtherBasesAreTold) {
  const Scene scene = test::scene_of(
      trimmed_object("A", test::square({0, 0, 0})) +
      trimmed_object("B", trimmed(kSquare, loop(segment("[CURVE POWER 2 E2 [0 0] [1 1]]")))));
  EXPECT_EQ(scene.parts.size(), 1u);
  ASSERT_EQ(scene.diagnostics.entries().size(), 1u);
  EXPECT_EQ(scene.diagnostics.entries()[0].code, "irit.unread");
  EXPECT_NE(scene.diagnostics.entries()[0].message.find("TRIMSRF of CURVE POWER"),
            std::string::npos);
}

}  // namespace
}  // namespace burin
