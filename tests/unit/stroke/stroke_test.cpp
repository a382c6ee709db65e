#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/base/rng.h>
#include <burin/converters/mesh_reader.h>
#include <burin/stroke/stroke.h>

#include "burin_test/shapes.h"
#include "burin_test/stroke_stage.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

namespace burin {
namespace {

using Stage = test::StrokeStage;

const HatchOptions kOneFamily{.spacing_min = 0.8,
                              .spacing_max = 1.6,
                              .width_min = 0.1,
                              .width_max = 0.5,
                              .tone_min = 0.05,
                              .cross_from = 2,
                              .length_max = 300};

TEST(Strokes, AreEvenlySpacedAndAsWideAsTheToneAsksOnAPlane) {
  // The front of a box of 60 x 40 mm, hatched upright with 30 % of ink.
  Stage stage(test::box({0, 0, 0}, {60, 5, 40}), "front", 1);
  const StrokeResult r = stage.strokes(field::fixed({0, 0, 1}), 0.7, kOneFamily);
  std::vector<double> at, widths;
  for (const Curve3& c : r.strokes) {
    EXPECT_EQ(c.kind, LineClass::Stroke);
    EXPECT_EQ(c.widths.size(), c.points.size());
    EXPECT_EQ(c.normals.size(), c.points.size());
    EXPECT_EQ(c.faces.size(), c.segment_count());
    const Vec3 middle = c.points[c.points.size() / 2];
    widths.push_back(c.widths[c.widths.size() / 2]);
    for (const Vec3& p : c.points) {
      EXPECT_NEAR(p.x, c.points[0].x, 1e-9);
      EXPECT_NEAR(p.y, 0, 1e-9);
    }
    // From edge to edge: no stroke ends before the border of the face.
    EXPECT_NEAR(std::abs(c.points.back().z - c.points.front().z), 40, 1e-9);
    at.push_back(middle.x);
  }
  std::sort(widths.begin(), widths.end());
  EXPECT_NEAR(widths[widths.size() / 2], 0.3 * 0.8, 0.3 * 0.8 * 0.05);
  // Beside the border a line makes up for the strip that is left over, or shares it.
  EXPECT_GT(widths.front(), 0.3 * 0.8 * 0.65);
  EXPECT_LT(widths.back(), 0.3 * 0.8 * 1.35);
  std::sort(at.begin(), at.end());
  ASSERT_GE(at.size(), 73u);  // 60 / 0.8 = 75
  for (std::size_t i = 1; i < at.size(); ++i) {
    EXPECT_GE(at[i] - at[i - 1], 0.8 * 0.9);
    EXPECT_LE(at[i] - at[i - 1], 0.8 * 2.01);
  }
}

// A damaged file is a crowd of sheets over each other: what is seen of them is hatched once.
TEST(Strokes, FollowWhatIsSeenOfManySheetsOverEachOther) {
  Stage stage(test::stacked_sheets(400), "front", 1);
  const StrokeResult r = stage.strokes(field::fixed({0, 0, 1}), 0.7, kOneFamily);
  EXPECT_EQ(r.thinned_parts, 0);
  EXPECT_GT(r.strokes.size(), 30U);
  EXPECT_LT(r.strokes.size(), 400U);
}

TEST(Strokes, CircleAroundATurnedPart) {
  Stage stage(test::cylinder(20, 40, 128), "front", 1);
  const StrokeResult r = stage.strokes(field::principal(), 0.6, kOneFamily);
  int around = 0;
  for (const Curve3& c : r.strokes) {
    const double z = c.points[0].z;
    // The facets only estimate the field: a line leaves it by less than the way to the next one.
    bool level = true;
    for (const Vec3& p : c.points) {
      level = level && std::abs(p.z - z) < 0.5 * 0.8;
      EXPECT_LE(std::hypot(p.x, p.y), 20 + 0.03);  // fairing goes round the corners of facets
    }
    around += level;
  }
  EXPECT_GE(around, 45);  // 40 / 0.8 = 50
  EXPECT_GE(around, static_cast<int>(0.95 * static_cast<double>(r.strokes.size())));
}

// Creases of this part run a degree or three off the strokes: those that come near pass in and out
// of the cells at the border, and are no rows of dashes.
TEST(Strokes, AlongABorderAreWhole) {
  const std::string file = std::string(BURIN_TEST_DATA) + "/mesh/cgal/fandisk.off";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file;
  RunContext context;
  const Scene scene = read_mesh(file, context);
  // Its triangles are those of its proxy.
  Stage stage(scene.parts[0].form->realise({}, context)->proxy().mesh, "iso", {});
  HatchOptions options = kOneFamily;
  options.spacing_min = 0.54;
  const StrokeResult r =
      stage.strokes(field::smoothed(stage.surfaces, {}, stage.context), 0.5, options);
  EXPECT_GT(r.strokes.size(), 200U);
  std::size_t shorter = 0;
  for (const Curve3& c : r.strokes) {
    double length = 0;
    for (std::size_t i = 1; i < c.points.size(); ++i) {
      length +=
          glm::distance(stage.camera.to_paper(c.points[i]), stage.camera.to_paper(c.points[i - 1]));
    }
    shorter += length < 8 ? 1 : 0;
  }
  // 146 on its narrow faces, of which 46 on the sickle beside its crease that fades; the dashes
  // were 55 more.
  EXPECT_LE(shorter, 160U);
}

// A bar that is lit up to a narrow strip along its contours, which its rings run into nearly along
// them: strokes there would be hairs on the outline.
TEST(Strokes, AreNoHairsOnAContour) {
  constexpr double kRadius = 20;
  Stage stage(test::cylinder(kRadius, 40, 128), "0,-1,0.9", 2);
  const Field field = field::smoothed(stage.surfaces, {}, stage.context);
  const auto count = [&](double strip) {  // mm of paper
    const Tone tone = [&](Vec3 at, Vec3) { return std::abs(at.x) > kRadius - strip / 2 ? 0.5 : 1; };
    return stage.strokes(field, tone, kOneFamily).strokes.size();
  };
  EXPECT_LT(count(0.8), 4U);  // 120 before, and two where the contours end
  EXPECT_GT(count(8), 60U);
}

// Those that run into it squarely are no such hairs, however straight they are.
TEST(Strokes, FromAContourIntoTheLightStay) {
  constexpr double kRadius = 20;
  Stage stage(test::cylinder(kRadius, 40, 128), "front", 2);
  const Tone tone = [](Vec3 at, Vec3) { return std::abs(at.x) > kRadius - 2 ? 0.5 : 1; };
  const StrokeResult r = stage.strokes(field::planes({0, 0, 1}), tone, kOneFamily);
  EXPECT_GT(r.strokes.size(), 180U);  // 80 mm / 0.8 mm on each side
}

TEST(Strokes, LeaveThePaperWhiteWhereNoInkIsAsked) {
  Stage stage(test::box({0, 0, 0}, {60, 5, 40}), "front", 1);
  EXPECT_TRUE(stage.strokes(field::fixed({0, 0, 1}), 0.97, kOneFamily).strokes.empty());
}

TEST(Strokes, CrossOnlyWhereItIsDark) {
  Stage stage(test::box({0, 0, 0}, {60, 5, 40}), "front", 1);
  HatchOptions options = kOneFamily;
  options.cross_from = 0.5;
  const auto count = [&](double tone) {
    const StrokeResult r =
        stage.strokes(field::smoothed(stage.surfaces, {}, stage.context), tone, options);
    return std::count_if(r.strokes.begin(), r.strokes.end(),
                         [](const Curve3& c) { return c.family == 2; });
  };
  EXPECT_EQ(count(0.7), 0);
  EXPECT_GT(count(0.2), 30);
}

TEST(Strokes, EndOnFacesSeenSquareOnFromAnyDirection) {
  // The cosine between view and normal rounds to a little more than 1 there; strokes were once
  // placed on each other for ever.
  const Rng rng(3);
  for (std::uint64_t i = 0; i < 12; ++i) {
    const Vec3 n = glm::normalize(
        Vec3(rng.uniform(3 * i), rng.uniform(3 * i + 1), rng.uniform(3 * i + 2)) - 0.4);
    const Vec3 u = any_orthogonal(n), v = glm::cross(n, u);
    const TriMesh box = test::mapped(test::box({-20, -15, -2}, {20, 15, 2}),
                                     [&](Vec3 p) { return p.x * u + p.y * v + p.z * n; });
    const std::string view = fmt::format("{:.17g},{:.17g},{:.17g}", n.x, n.y, n.z);
    Stage stage(box, view.c_str(), 1);
    const StrokeResult r = stage.strokes(field::fixed(u), 0.7, kOneFamily);
    EXPECT_GE(r.strokes.size(), 30u);  // 30 mm / 0.8 mm, less what the border leaves
    EXPECT_LE(r.strokes.size(), 45u);
  }
}

// What the phase is for: neighbours at even distances, which no line ends between, the first ones
// half a distance from the edges that they run along.
TEST(Strokes, KeepARhythmOnATurnedPartSeenFromAbove) {
  constexpr double kRadius = 20, kHeight = 40;
  Stage stage(test::cylinder(kRadius, kHeight, 128), "0,-1,0.5", 1);
  const StrokeResult r = stage.strokes(field::planes({0, 0, 1}), 0.6, kOneFamily);
  std::vector<double> heights;
  for (const Curve3& c : r.strokes) {
    const Vec3 middle = c.points[c.points.size() / 2];
    if (std::hypot(middle.x, middle.y) < 0.9 * kRadius) continue;  // on the upper face
    if (glm::distance(c.points.front(), c.points.back()) < 1.9 * kRadius) {
      ADD_FAILURE() << "a stroke ends inside, at the height of " << middle.z;
    }
    heights.push_back(middle.z);
  }
  std::sort(heights.begin(), heights.end());
  // Seen at the slant of 0.5 heights shrink on paper.
  const double gap = 0.8 * std::sqrt(1.25);
  ASSERT_GT(heights.size(), 35U);
  EXPECT_NEAR(heights.front(), 0.5 * gap, 0.15 * gap);
  EXPECT_NEAR(kHeight - heights.back(), 0.5 * gap, 0.15 * gap);
  for (std::size_t i = 1; i < heights.size(); ++i) {
    EXPECT_NEAR(heights[i] - heights[i - 1], gap, 0.15 * gap) << "at " << heights[i];
  }
}

TEST(Strokes, CrossAtTheAngleThatIsAskedFor) {
  Stage stage(test::box({0, 0, 0}, {60, 5, 40}), "front", 1);
  HatchOptions options = kOneFamily;
  options.cross_from = 0.3;
  for (const double angle : {40.0, 60.0, 90.0}) {
    options.cross_angle = angle;
    const StrokeResult r = stage.strokes(field::fixed({0, 0, 1}), 0.3, options);
    int second = 0;
    for (const Curve3& c : r.strokes) {
      const Vec3 along = glm::normalize(c.points.back() - c.points.front());
      const double turned = glm::degrees(std::acos(std::min(1.0, std::abs(along.z))));
      EXPECT_NEAR(turned, c.family == 1 ? 0 : angle, 0.1);
      second += c.family == 2;
    }
    EXPECT_GT(second, 30);
  }
}

// Into the light every second line fades out before the others, and those take its ink.
TEST(Strokes, FadeOutOneAfterTheOther) {
  Stage stage(test::box({0, 0, 0}, {60, 5, 40}), "front", 1);
  const Tone lighter = [](Vec3 position, Vec3) { return 0.65 + 0.35 * position.z / 40; };
  const StrokeResult r = stage.strokes(field::fixed({0, 0, 1}), lighter, kOneFamily);
  std::vector<double> ends;
  for (const Curve3& c : r.strokes) {
    ends.push_back(std::max(c.points.front().z, c.points.back().z));
    EXPECT_NEAR(std::min(c.points.front().z, c.points.back().z), 0, 1e-9);
  }
  std::sort(ends.begin(), ends.end());
  ASSERT_GT(ends.size(), 70U);
  // The thinnest pen, 0.1 mm, covers 0.125 at 0.8 mm; ink is 0.05, the least, at 34.3 mm.
  const double half = ends[ends.size() / 4], rest = ends[3 * ends.size() / 4];
  EXPECT_GT(half, 22);
  EXPECT_LT(half, 30);
  EXPECT_NEAR(rest, 34.3, 1);
}

const HatchOptions kOnePen{.spacing_min = 0.6,
                           .spacing_max = 2.4,
                           .width_min = 0.3,
                           .width_max = 0.3,
                           .tone_min = 0.08,
                           .cross_from = 0.4,
                           .length_max = 300};

// Where lines of one width begin to cross others they are few, and become more few by few: their
// ends are no edge.
TEST(Strokes, OfOnePenThatCrossOthersEndOneAfterTheOther) {
  Stage stage(test::box({0, 0, 0}, {60, 5, 40}), "front", 1);
  const Tone lighter = [](Vec3 position, Vec3) { return 0.525 + 0.08 * position.z / 40; };
  const StrokeResult r = stage.strokes(field::fixed({1, 0, 0}), lighter, kOnePen);
  std::vector<double> ends;
  for (const Curve3& c : r.strokes) {
    if (c.family == 2) ends.push_back(std::max(c.points.front().z, c.points.back().z));
  }
  std::sort(ends.begin(), ends.end());
  ASSERT_GE(ends.size(), 20U);  // 60 / 2.4 = 25, but for some too short ones
  // The ink of the second family falls from all that lines 2.4 mm apart have at the bottom to none
  // at 37.5 mm. Every second line ends at about 0.75 of it, of the others every second at 0.45.
  const auto height = [](double share) { return 37.5 * (1 - share); };
  // Of each eight lines four, two and two; from the longest one on.
  std::reverse(ends.begin(), ends.end());
  EXPECT_NEAR(ends[0], height(0.25 * 0.75), 3);
  EXPECT_NEAR(ends[3], height(0.25), 3);
  EXPECT_NEAR(ends[9], height(0.45), 3);
  EXPECT_NEAR(ends[18], height(0.75), 3);
  EXPECT_GT(height(0.45) - ends[14], 3);
}

// Where the tone is even they are as far apart as each other, as many as it asks for.
TEST(Strokes, OfOnePenThatCrossOthersKeepARhythm) {
  Stage stage(test::box({0, 0, 0}, {60, 5, 40}), "front", 1);
  for (const auto& [ink, gap] : {std::pair{0.425, 9.6}, {0.44, 4.8}, {0.47, 2.4}}) {
    const StrokeResult r = stage.strokes(field::fixed({1, 0, 0}), 1 - ink, kOnePen);
    std::vector<double> at;  // along the normal of the lines, which need not be upright
    for (const Curve3& c : r.strokes) {
      if (c.family != 2) continue;
      const Vec3 along = glm::normalize(c.points.back() - c.points.front());
      const double way = along.z < 0 ? -1 : 1;
      at.push_back(way * (along.z * c.points[0].x - along.x * c.points[0].z));
    }
    std::sort(at.begin(), at.end());
    ASSERT_GE(at.size(), 5U) << ink;
    for (std::size_t i = 1; i < at.size(); ++i) {
      EXPECT_NEAR(at[i] - at[i - 1], gap, 0.15 * gap) << ink;
    }
  }
}

// The ink of the three sides of a cube, seen along its diagonal: what strokes cover of each.
std::array<double, 3> ink_of_sides(const tone::ToneOptions& balance, std::array<double, 3> asked,
                                   double* gamma = nullptr) {
  Stage stage(test::box({0, 0, 0}, {40, 40, 40}), "1,1,1", 1);
  const Tone tone = [&](Vec3, Vec3 n) {
    return 1 - (n.x > 0.5 ? asked[0] : n.y > 0.5 ? asked[1] : asked[2]);
  };
  const StrokeResult r = stage.strokes(field::smoothed(stage.surfaces, {}, stage.context), tone,
                                       kOneFamily, 1, balance);
  if (gamma) *gamma = r.tone_gamma;
  std::array<double, 3> area{};
  for (const Curve3& c : r.strokes) {
    const Vec3 n = c.normals[c.normals.size() / 2];
    for (std::size_t i = 1; i < c.points.size(); ++i) {
      const double length =
          glm::distance(stage.camera.to_paper(c.points[i]), stage.camera.to_paper(c.points[i - 1]));
      area[n.x > 0.5 ? 0 : n.y > 0.5 ? 1 : 2] += length * 0.5 * (c.widths[i] + c.widths[i - 1]);
    }
  }
  for (double& a : area) a /= 40 * 40 / std::sqrt(3.0);
  return area;
}

// On the left of a slanted seam lines of family 1 are upright, on its right they are level.
TEST(Strokes, OfFamiliesThatMeetEndAtTheirSeam) {
  Stage stage(test::box({0, 0, 0}, {60, 5, 40}), "front", 1);
  const auto right_of_seam = [](Vec3 p) { return p.x - 10 - 0.8 * p.z; };
  const Field field{"seam", [&](const FieldQuery& q) -> std::optional<Cross> {
                      Cross cross{.first = {0, 0, 1}, .second = {1, 0, 0}, .certainty = 1};
                      if (right_of_seam(q.point.position) > 0) std::swap(cross.first, cross.second);
                      return cross;
                    }};
  const StrokeResult r = stage.strokes(field, 0.7, kOneFamily);
  int ends = 0;
  for (const Curve3& c : r.strokes) {
    const double middle = c.widths[c.widths.size() / 2];
    for (const std::size_t at : {std::size_t{0}, c.points.size() - 1}) {
      const Vec3 p = c.points[at];
      const bool border = p.x < 0.01 || p.x > 59.99 || p.z < 0.01 || p.z > 39.99;
      if (border) continue;
      ++ends;
      // mm across the seam; strokes may leave so much white as the shortest step
      EXPECT_NEAR(right_of_seam(p) / std::hypot(1, 0.8), 0, 0.06);
      EXPECT_GT(c.widths[at], 0.7 * middle);
    }
  }
  EXPECT_GT(ends, 60);  // 32 mm of the seam's width and 40 of its height, at 0.8 mm
}

TEST(ToneBalance, OneExponentBringsTheMedianIntoItsRange) {
  double gamma = 0;
  // The median is that of the side of 0.2: ln 0.3 / ln 0.2.
  const auto lifted = ink_of_sides({.median_min = 0.3, .median_max = 0.4}, {0.2, 0.1, 0.5}, &gamma);
  EXPECT_NEAR(gamma, std::log(0.3) / std::log(0.2), 1e-6);
  EXPECT_NEAR(lifted[0], 0.3, 0.02);
  EXPECT_NEAR(lifted[2], std::pow(0.5, gamma), 0.02);
  ink_of_sides({.median_min = 0.1, .median_max = 0.4}, {0.2, 0.1, 0.5}, &gamma);
  EXPECT_EQ(gamma, 1);
  ink_of_sides({.median_min = 0.9, .median_max = 1}, {0.2, 0.1, 0.5}, &gamma);
  EXPECT_EQ(gamma, 0.5);
}

TEST(ToneBalance, PlanesThatMeetStandApart) {
  const auto alike = ink_of_sides({}, {0.4, 0.42, 0.25});
  EXPECT_LT(std::abs(alike[0] - alike[1]), 0.04);
  // 0.08 more for the one in shade, 0.02 less for the other.
  const auto apart = ink_of_sides({.contrast = 0.12}, {0.4, 0.42, 0.25});
  EXPECT_NEAR(apart[1], 0.5, 0.02);
  EXPECT_NEAR(apart[0], 0.38, 0.02);
  EXPECT_NEAR(apart[2], 0.25, 0.02);
  // White sides stay white, and what stands apart as it is.
  const auto light = ink_of_sides({.contrast = 0.12}, {0.04, 0.02, 0.4});
  EXPECT_NEAR(light[2], 0.4, 0.02);
  EXPECT_EQ(light[0], 0);
  EXPECT_EQ(light[1], 0);
}

TEST(ToneBalance, SlantedPlanesAreDarkerWhereTheyAreNear) {
  Stage stage(test::box({0, 0, 0}, {40, 40, 40}), "1,1,1", 1);
  const StrokeResult r = stage.strokes(field::fixed({0, 0, 1}), [](Vec3, Vec3) { return 0.6; },
                                       kOneFamily, 1, {.gradient = 0.1});
  // Of upright strokes on the side x = 40, whose nearest corner is y = z = 40: the mean ink about a
  // place. The ink is 0.4 and up to 0.05 more or less.
  const auto ink = [&](Vec3 place) {
    double sum = 0, count = 0;
    for (const Curve3& c : r.strokes) {
      for (std::size_t i = 0; i < c.points.size(); ++i) {
        if (c.normals[i].x < 0.5 || glm::distance(c.points[i], place) > 5) continue;
        sum += c.widths[i] / kOneFamily.spacing_min;
        count += 1;
      }
    }
    return sum / count;
  };
  EXPECT_NEAR(ink({40, 20, 20}), 0.4, 0.02);
  EXPECT_NEAR(ink({40, 33, 33}), 0.4 + 0.1 * 13 / 40, 0.015);
  EXPECT_NEAR(ink({40, 7, 7}), 0.4 - 0.1 * 13 / 40, 0.015);
}

TEST(Strokes, CoverageIsMeasured) {
  Stage stage(test::box({0, 0, 0}, {60, 5, 40}), "front", 1);
  const StrokeResult r = stage.strokes(field::fixed({0, 0, 1}), 0.6, kOneFamily);
  // A point at each cell of the picture: squares of 0.4 mm.
  EXPECT_NEAR(static_cast<double>(r.coverage_points), 60 * 40 / 0.16, 0.02 * 60 * 40 / 0.16);
  EXPECT_NEAR(r.coverage_delta, 0.4 / std::sqrt(2.0), 1e-9);
}

TEST(Strokes, AreTheSameForAnyNumberOfThreads) {
  const auto run = [](int threads) {
    const ThreadLimit limit(threads);
    Stage stage(test::torus(20, 8, 64, 32), "iso", 1);
    HatchOptions options = kOneFamily;
    options.cross_from = 0.3;
    return stage.strokes(field::principal(), 0.5, options);
  };
  const StrokeResult one = run(1), many = run(0);
  ASSERT_EQ(one.strokes.size(), many.strokes.size());
  for (std::size_t i = 0; i < one.strokes.size(); ++i) {
    EXPECT_EQ(one.strokes[i].points, many.strokes[i].points);
    EXPECT_EQ(one.strokes[i].widths, many.strokes[i].widths);
  }
}

TEST(Strokes, StopWhenCancelledAndRefuseNonsense) {
  Stage stage(test::box({0, 0, 0}, {60, 5, 40}), "front", 1);
  HatchOptions options = kOneFamily;
  options.spacing_min = 3;
  EXPECT_THROW(stage.strokes(field::fixed({0, 0, 1}), 0.5, options), UsageError);
  stage.context.cancel();
  EXPECT_THROW(stage.strokes(field::fixed({0, 0, 1}), 0.5, kOneFamily), Cancelled);
}

}  // namespace
}  // namespace burin
