/// Strokes that run along planes, or upright on the sheet, do so on every form: as they are drawn.

#include <burin/field/field.h>
#include <burin/illustrate/view_probe.h>
#include <burin/stroke/stroke.h>
#include <burin/visibility/occluder.h>

#include "forms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

namespace burin {
namespace {

using test::FormCase;

// One part of any form on a sheet, usually of 100 x 100 mm, and the strokes of a field on what is
// seen.
struct Hatched {
  Hatched(const Form& form, std::optional<double> perspective, Paper paper = {100, 100})
      : camera(Camera::fit(
            [&](const Mat3& axes) { return form.bounds(axes); },
            {.direction = {0.7, -1, 0.6}, .perspective = perspective, .paper = paper})) {
    surface = form.realise({.tolerance = 0.05 / camera.scale(), .view = &camera}, context);
  }

  std::vector<Curve3> strokes(const Field& field, const char* placing = "even") {
    return strokes(field, {.placing = placing,
                           .spacing_min = 1.2,
                           .spacing_max = 2.4,
                           .width_max = 0.5,
                           .tone_min = 0.05,
                           .cross_from = 2,
                           .length_max = 300});
  }

  std::vector<Curve3> strokes(const Field& field, const HatchOptions& options) {
    const std::vector<const ProxyMesh*> proxies{&surface->proxy()};
    const Occluder occluder(proxies, context);
    const ViewProbe probe = view_probe(occluder, camera);
    // By a name: g++ 12 warns of the temporary of a default argument.
    const InkOptions ink;
    return trace_strokes(
               std::vector<const Surface*>{surface.get()}, camera, field,
               [](Vec3, Vec3) { return 0.6; }, probe, options, 1, context, ink)
        .strokes;
  }

  RunContext context;
  Camera camera;
  std::shared_ptr<const Surface> surface;
};

// On a face narrower than strokes are long they run along it, across the field: those keep nothing.
bool across(const Curve3& c, Vec3 gradient) {
  const std::size_t i = c.points.size() / 2;
  const Vec3 tangent = normalize_or(c.points[i] - c.points[i - 1], Vec3(0));
  const Vec3 steepest = normalize_or(reject(gradient, c.normals[i]), Vec3(0));
  return std::abs(glm::dot(tangent, steepest)) > 0.7;
}

class HeldStrokes : public testing::TestWithParam<FormCase> {
 protected:
  static Hatched& hatched_form(std::optional<double> perspective) {
    static test::OfOneForm<Hatched> parallel, central;
    return (perspective ? central : parallel).get(GetParam().name, [&] {
      return std::make_unique<Hatched>(*GetParam().make(), perspective);
    });
  }
};

/// How far strokes are off the planes that they keep to, in mm of paper.
double off_planes(Hatched& hatched, const char* placing) {
  const Vec3 normal = glm::normalize(Vec3(1, 0.4, 1.7));
  double worst = 0;
  std::size_t held = 0;
  const auto strokes = hatched.strokes(field::planes(normal), placing);
  for (const Curve3& c : strokes) {
    if (across(c, normal)) continue;
    ++held;
    double low = 1e300, high = -1e300;
    for (const Vec3& p : c.points) {
      low = std::min(low, glm::dot(p, normal));
      high = std::max(high, glm::dot(p, normal));
    }
    worst = std::max(worst, hatched.camera.scale() * (high - low));
  }
  EXPECT_GE(held, 10U);
  EXPECT_GE(static_cast<double>(held), 0.9 * static_cast<double>(strokes.size()));
  return worst;
}

TEST_P(HeldStrokes, OfPlanesStayInTheirPlane) {
  Hatched& hatched = hatched_form({});
  EXPECT_LT(off_planes(hatched, "even"), 0.02);
}

TEST_P(HeldStrokes, OnPointsDoSo) {
  Hatched& hatched = hatched_form({});
  EXPECT_LT(off_planes(hatched, "points"), 0.02);
  EXPECT_LT(off_planes(hatched, "discs"), 0.02);
}

// ... and are as long as asked for, but where the surface bends away within a step.
TEST_P(HeldStrokes, OnPointsAreShort) {
  Hatched& hatched = hatched_form({});
  const auto strokes = hatched.strokes(field::fixed({0.3, 0.2, 1}), "discs");
  EXPECT_GE(strokes.size(), 100U);
  for (const Curve3& c : strokes) {
    double length = 0;
    for (std::size_t i = 1; i < c.points.size(); ++i) {
      length += glm::distance(hatched.camera.to_paper(c.points[i]),
                              hatched.camera.to_paper(c.points[i - 1]));
    }
    EXPECT_LE(length, 1.1 * 4.0 / 3 * HatchOptions().length);
  }
}

TEST_P(HeldStrokes, AlongTheSilhouettesKeepTheirDistanceToTheViewer) {
  for (const auto& perspective : {std::optional<double>(), std::optional<double>(45)}) {
    Hatched& hatched = hatched_form(perspective);
    const Camera& camera = hatched.camera;
    const auto distance = [&](Vec3 p) {
      return perspective ? -camera.distance_to_viewer(p) : camera.depth(p);
    };
    double worst = 0;
    std::size_t held = 0;
    const auto strokes = hatched.strokes(field::silhouette(camera));
    for (const Curve3& c : strokes) {
      const Vec3 middle = c.points[c.points.size() / 2];
      if (across(c, camera.to_viewer(middle))) continue;
      ++held;
      double low = 1e300, high = -1e300;
      for (const Vec3& p : c.points) {
        low = std::min(low, distance(p));
        high = std::max(high, distance(p));
      }
      worst = std::max(worst, camera.scale_at(middle) * (high - low));
    }
    EXPECT_GE(held, 10U);
    EXPECT_GE(static_cast<double>(held), 0.9 * static_cast<double>(strokes.size()));
    EXPECT_LT(worst, 0.02) << "mm of paper, " << perspective.value_or(0);
  }
}

TEST_P(HeldStrokes, UprightOnTheSheetAreUpright) {
  for (const auto& perspective : {std::optional<double>(), std::optional<double>(45)}) {
    Hatched& hatched = hatched_form(perspective);
    const Camera& camera = hatched.camera;
    double worst = 0, off = 0;
    std::size_t held = 0;
    const auto strokes = hatched.strokes(field::screen_vertical(camera));
    for (const Curve3& c : strokes) {
      const Vec3 middle = c.points[c.points.size() / 2];
      if (across(c, glm::cross(camera.up(), camera.to_viewer(middle)))) continue;
      ++held;
      Vec2 from = camera.to_paper(c.points.front());
      for (const Vec3& p : c.points) {
        const Vec2 at = camera.to_paper(p);
        off = std::max(off, std::abs(at.x - camera.to_paper(c.points.front()).x));
        if (glm::distance(at, from) < 0.2) continue;  // what is drawn of an angle is length
        worst = std::max(worst, std::atan2(std::abs(at.x - from.x), std::abs(at.y - from.y)));
        from = at;
      }
    }
    EXPECT_GE(held, 10U);
    EXPECT_GE(static_cast<double>(held), 0.9 * static_cast<double>(strokes.size()));
    EXPECT_LT(worst * 180 / std::numbers::pi, 0.5) << "degrees, " << perspective.value_or(0);
    EXPECT_LT(off, 0.02) << "mm of paper, " << perspective.value_or(0);
  }
}

// As near to each other as in an engraving.
const HatchOptions kFine{.spacing_min = 0.5,
                         .spacing_max = 1,
                         .width_max = 0.3,
                         .tone_min = 0.05,
                         .cross_from = 2,
                         .length_max = 300};

// Degrees up to which strokes of the usual field are off the circles round the tube of a torus
// about z, over 95 % of their length.
double off_circles(Hatched& hatched) {
  const std::vector<const Surface*> surfaces{hatched.surface.get()};
  const Field field = field::smoothed(surfaces, {}, hatched.context);
  std::vector<std::pair<double, double>> pieces;  // degrees, mm
  double length = 0;
  for (const Curve3& c : hatched.strokes(field, kFine)) {
    for (std::size_t i = 1; i < c.points.size(); ++i) {
      const Vec3 step = c.points[i] - c.points[i - 1], at = c.points[i] + c.points[i - 1];
      const double n = glm::length(step);
      if (!(n > 0)) continue;
      const Vec3 round = glm::normalize(Vec3(-at.y, at.x, 0));
      pieces.emplace_back(glm::degrees(std::asin(std::abs(glm::dot(step, round)) / n)), n);
      length += n;
    }
  }
  EXPECT_GT(length, 1000);
  std::ranges::sort(pieces);
  double sum = 0;
  for (const auto& [angle, n] : pieces) {
    sum += n;
    if (sum > 0.95 * length) return angle;
  }
  return 90;
}

// A torus about z, by what knows its shape.
std::vector<std::pair<const char*, std::shared_ptr<const Form>>> tori() {
  return {{"function", test::implicit_form(implicit::torus(20, 8))},
          {"mesh", test::mesh_form(test::torus(20, 8, 320, 128))},
          {"exact", test::brep_form(BRepPrimAPI_MakeTorus(20, 8).Shape())}};
}

TEST(PrincipalStrokes, OnATorusRunRoundItsTube) {
  for (const auto& [name, torus] : tori()) {
    Hatched hatched(*torus, {});
    EXPECT_LT(off_circles(hatched), 2) << name;
  }
}

// Places of strokes, in degrees round the axis of a torus about z, where they pass so high on its
// tube (radians from its outermost circle), on the side that is turned to the viewer.
std::vector<double> crossings(const std::vector<Curve3>& strokes, double height, double middle) {
  std::vector<double> out;
  const auto above = [&](Vec3 p) { return std::atan2(p.z, std::hypot(p.x, p.y) - 20) - height; };
  for (const Curve3& c : strokes) {
    for (std::size_t i = 1; i < c.points.size(); ++i) {
      const double a = above(c.points[i - 1]), b = above(c.points[i]);
      if ((a < 0) == (b < 0) || std::abs(a - b) > 1) continue;
      const Vec3 p = glm::mix(c.points[i - 1], c.points[i], a / (a - b));
      const double degrees = std::remainder(glm::degrees(std::atan2(p.y, p.x)) - middle, 360);
      if (std::abs(degrees) < 50) out.push_back(degrees);
    }
  }
  std::ranges::sort(out);
  return out;
}

// Where a line ends between two others they close its place: else a white streak goes on from
// there.
TEST(PrincipalStrokes, OfATorusCloseThePlaceOfOneThatEnded) {
  const auto torus = test::brep_form(BRepPrimAPI_MakeTorus(20, 8).Shape());
  Hatched hatched(*torus, {}, {300, 300});
  const std::vector<const Surface*> surfaces{hatched.surface.get()};
  const auto strokes = hatched.strokes(field::smoothed(surfaces, {}, hatched.context), kFine);
  const Vec3 viewer = hatched.camera.to_viewer(Vec3(0));
  const double middle = glm::degrees(std::atan2(viewer.y, viewer.x));
  std::size_t wide = 0, all = 0;
  for (double height = -0.5; height < 0.6; height += 0.05) {
    const std::vector<double> at = crossings(strokes, height, middle);
    ASSERT_GT(at.size(), 100U);
    for (std::size_t i = 3; i + 2 < at.size(); ++i, ++all) {
      const double around = 0.25 * (at[i + 2] - at[i] + at[i - 1] - at[i - 3]);
      wide += at[i] - at[i - 1] > 1.25 * around;
    }
  }
  EXPECT_LT(wide, all / 1000);
}

// The share of the strokes that run into a contour which reach it. `normal` is that of a point.
double share_at_contour(Hatched& hatched, const std::function<Vec3(Vec3)>& normal) {
  const std::vector<const Surface*> surfaces{hatched.surface.get()};
  const Field field = field::smoothed(surfaces, {}, hatched.context);
  const auto facing = [&](Vec3 at) { return glm::dot(normal(at), hatched.camera.to_viewer(at)); };
  std::size_t reach = 0, all = 0;
  for (const Curve3& c : hatched.strokes(field, kFine)) {
    const std::size_t n = c.points.size(), inside = std::min<std::size_t>(3, n - 1);
    for (const auto& [end, before] : {std::pair(0UL, inside), std::pair(n - 1, n - 1 - inside)}) {
      const double at_end = facing(c.points[end]);
      // Lines that end for another reason do so in the middle of the picture.
      if (c.closed || at_end > 0.35 || at_end > facing(c.points[before])) continue;
      ++all;
      reach += at_end < 0.12;
    }
  }
  EXPECT_GT(all, 40U);
  return static_cast<double>(reach) / static_cast<double>(std::max<std::size_t>(all, 1));
}

// Those that run into it at a grazing angle, too: else a row of teeth stands along it.
TEST(PrincipalStrokes, ReachTheContourOfATorus) {
  for (const auto& [name, torus] : tori()) {
    Hatched hatched(*torus, {});
    const double share = share_at_contour(hatched, [](Vec3 at) {
      return glm::normalize(at - 20.0 * glm::normalize(Vec3(at.x, at.y, 0)));
    });
    EXPECT_GT(share, 0.8) << name;
  }
}

// Else chips of white stand along it.
TEST(PrincipalStrokes, ReachTheContourOfACylinder) {
  const auto cylinder = test::brep_form(BRepPrimAPI_MakeCylinder(10, 15).Shape());
  Hatched hatched(*cylinder, {});
  const double share =
      share_at_contour(hatched, [](Vec3 at) { return glm::normalize(Vec3(at.x, at.y, 0)); });
  EXPECT_GT(share, 0.94);
}

// Lines across a washer and over its round edge are the same ones: were they placed apart, those of
// the one would end, or crowd, between those of the other all along the border.
TEST(PrincipalStrokes, OfAWasherGoOnOverItsRoundEdges) {
  constexpr double kInner = 16, kOuter = 40, kRound = 4;
  std::vector<Vec2> profile{{kInner, 0}, {kOuter, 0}};
  for (int i = 0; i <= 8; ++i) {
    const double a = 0.5 * std::numbers::pi * i / 8;
    profile.push_back(Vec2(kOuter - kRound, 8) + kRound * Vec2(std::cos(a), std::sin(a)));
  }
  for (int i = 8; i >= 0; --i) {
    const double a = 0.5 * std::numbers::pi * i / 8;
    profile.push_back(Vec2(kInner + kRound, 8) + kRound * Vec2(-std::cos(a), std::sin(a)));
  }
  const auto washer = test::recognised_form(test::turned(profile, 96, true));
  Hatched hatched(*washer, {});
  const Field radial{"radial", [](const FieldQuery& query) -> std::optional<Cross> {
                       const Vec3 at = query.point.position;
                       const Vec3 round = glm::normalize(Vec3(-at.y, at.x, 0));
                       const Vec3 across = glm::cross(round, query.frame.normal);
                       return Cross{glm::normalize(across), round};
                     }};
  std::vector<double> at;  // of strokes, degrees round the axis, a little beyond the border
  for (const Curve3& c : hatched.strokes(radial, kFine)) {
    for (std::size_t i = 1; i < c.points.size(); ++i) {
      const Vec3 a = c.points[i - 1], b = c.points[i];
      const double ra = std::hypot(a.x, a.y), rb = std::hypot(b.x, b.y), r = kOuter - kRound + 1;
      if ((ra < r) == (rb < r) || a.z < 8) continue;
      const Vec3 p = glm::mix(a, b, (r - ra) / (rb - ra));
      // From the side that is turned to the viewer.
      const double degrees = glm::degrees(std::atan2(p.y, p.x)) + 55;
      if (std::abs(degrees) < 60) at.push_back(degrees);
    }
  }
  std::ranges::sort(at);
  ASSERT_GT(at.size(), 60U);
  // From one gap to the next one; 0.05, and 0.19 when both were placed apart.
  double jumps = 0;
  for (std::size_t i = 2; i < at.size(); ++i) {
    const double jump = std::log((at[i] - at[i - 1]) / (at[i - 1] - at[i - 2]));
    jumps += jump * jump / static_cast<double>(at.size() - 2);
  }
  EXPECT_LT(std::sqrt(jumps), 0.1);
}

INSTANTIATE_TEST_SUITE_P(Forms, HeldStrokes, testing::ValuesIn(test::form_cases()),
                         [](const auto& which) { return which.param.name; });

}  // namespace
}  // namespace burin
