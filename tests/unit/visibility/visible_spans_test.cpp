#include <burin/base/parallel.h>
#include <burin/mesh/chord_error.h>

#include <burin_test/view.h>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace burin {
namespace {

using test::View;

// Length in space of what is seen of the features.
double visible_length(const View& view) {
  double length = 0;
  for (std::size_t c = 0; c < view.features.size(); ++c) {
    for (const Span& s : view.spans[c]) {
      if (!s.visible) continue;
      const Curve3 part = slice(view.features[c], s.begin, s.end);
      for (std::size_t i = 0; i < part.segment_count(); ++i) {
        length += glm::length(part.points[part.next(i)] - part.points[i]);
      }
    }
  }
  return length;
}

double shortest_visible(const View& view) {
  double shortest = 1e9;
  for (std::size_t c = 0; c < view.features.size(); ++c) {
    for (const Span& s : view.spans[c]) {
      if (!s.visible) continue;
      shortest =
          std::min(shortest, test::paper_length(view.camera, view.features[c], s.begin, s.end));
    }
  }
  return shortest;
}

double outer_length(const View& view) {
  double length = 0;
  for (std::size_t c = 0; c < view.features.size(); ++c) {
    for (const Span& s : view.spans[c]) {
      EXPECT_TRUE(s.visible || !s.outer);
      if (s.outer) length += test::paper_length(view.camera, view.features[c], s.begin, s.end);
    }
  }
  return length;
}

TEST(VisibleSpans, ShowsNineEdgesOfABox) {
  for (const bool perspective : {false, true}) {
    ViewOptions options;
    if (perspective) options.perspective = 30;
    const View view({test::box({0, 0, 0}, {1, 1, 1})}, options);
    EXPECT_NEAR(visible_length(view), 9, 1e-9);
  }
}

// So many lines to and fro in front of a box, drawn with it.
struct Crowd {
  explicit Crowd(int count) {
    ViewOptions options;
    options.direction = {0, 0, 1};
    options.up = {0, 1, 0};
    view.emplace(std::vector{test::box({-1, -1, -2}, {1, 1, -1})}, options);
    for (int i = 0; i < count; ++i) {
      const double at = -1 + 2 * (i + 0.5) / count;
      Curve3 across, up;
      across.points = {{-1, at, 0}, {1, at, 0}};
      up.points = {{at, -1, 0}, {at, 1, 0}};
      for (Curve3* line : {&across, &up}) {
        line->kind = LineClass::Boundary;
        line->occluding = true;
        line->source = {0, 0, -1};
        lines.push_back(*line);
      }
    }
    map.emplace(*view->occluder, view->pointers, view->camera, lines, view->context);
  }
  void expect_all_seen() const {
    for (const auto& spans : map->classify(lines, {}, view->context)) {
      ASSERT_EQ(spans.size(), 1U);  // all of it is in front of the box
      EXPECT_TRUE(spans[0].visible);
    }
  }
  std::optional<View> view;
  std::vector<Curve3> lines;
  std::optional<VisibilityMap> map;
};

// What a damaged file makes: lines that cross each other more than two million times. Each crossing
// may change what is seen and would want rays of its own.
TEST(VisibleSpans, MergesCutsWhereLinesCrossEachOtherMillionsOfTimes) {
  EXPECT_EQ(Crowd(1).map->merged_cuts(), 0);
  const Crowd crowd(1100);
  EXPECT_GT(crowd.map->merged_cuts(), 0.05);  // 2200 lines of 190 mm in half a million pieces
  EXPECT_LT(crowd.map->merged_cuts(), 1);
  crowd.expect_all_seen();
}

// Of more than a hundred million pairs of lines none is looked for.
TEST(VisibleSpans, CutsEvenlyWhereCrossingsCannotBeCounted) {
  const Crowd crowd(8000);
  EXPECT_GT(crowd.map->merged_cuts(), 20);  // 16,000 lines of 190 mm in a hundred thousand pieces
  EXPECT_LT(crowd.map->merged_cuts(), 40);
  crowd.expect_all_seen();
}

// Two boxes along x, looked at from +x and a little from above: the far one rises behind the near
// one.
TEST(VisibleSpans, CutsTheFarBoxExactlyAtTheNearOne) {
  ViewOptions options;
  options.direction = {1, 0.3, 0.5};
  const View view({test::box({0, -1, 0}, {1, 1, 2}), test::box({3, -0.4, 0}, {4, 0.3, 1.5})},
                  options);
  // Against dense rays along every edge.
  for (std::size_t c = 0; c < view.features.size(); ++c) {
    const Curve3& curve = view.features[c];
    for (const Span& s : view.spans[c]) {
      for (const double end : {s.begin, s.end}) {
        if (end == std::floor(end)) continue;
        // A cut inside a segment lies on a segment of the near box in the picture.
        const Vec2 p = view.camera.to_paper(test::point_at(curve, end));
        double nearest = 1e9;
        for (const Curve3& other : view.features) {
          if (other.source.part != 1) continue;
          for (std::size_t i = 0; i < other.segment_count(); ++i) {
            const Vec2 a = view.camera.to_paper(other.points[i]);
            const Vec2 b = view.camera.to_paper(other.points[other.next(i)]);
            const double t = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
            nearest = std::min(nearest, glm::length(glm::mix(a, b, t) - p));
          }
        }
        EXPECT_LT(nearest, 1e-9);
      }
    }
  }
}

// A line behind a box: hidden exactly where the box's faces cover it.
TEST(VisibleSpans, HidesALineBehindABoxExactly) {
  for (const bool perspective : {false, true}) {
    ViewOptions options;
    options.direction = {0, 0, 1};
    options.up = {0, 1, 0};
    if (perspective) options.perspective = 40;
    const View view({test::box({-1, -1, 0}, {1, 1, 1}), test::box({-4, -4, -3}, {4, 4, -2.5})},
                    options);
    const Curve3 across = test::line({-3, 0.25, -2}, {3, 0.25, -2}, 7);
    const auto spans = view.classify(across);
    ASSERT_EQ(spans.size(), 3u);
    EXPECT_TRUE(spans[0].visible);
    EXPECT_FALSE(spans[1].visible);
    EXPECT_TRUE(spans[2].visible);
    double half = 1;
    if (perspective) {
      const double eye = view.camera.eye().z;
      half = (eye + 2) / (eye - 1);  // the near rim of the box as seen in the plane z = -2
    }
    EXPECT_NEAR(test::point_at(across, spans[0].end).x, -half, 1e-9);
    EXPECT_NEAR(test::point_at(across, spans[1].end).x, half, 1e-9);
  }
}

TEST(VisibleSpans, CutsAtTheContourOfASphere) {
  for (const bool perspective : {false, true}) {
    ViewOptions options;
    options.direction = {0, 0, 1};
    options.up = {0, 1, 0};
    if (perspective) options.perspective = 40;
    const std::uint32_t n = 160;
    const View view({test::ellipsoid({1, 1, 1}, n, n / 2), test::box({-2, -2, -3}, {2, 2, -2.5})},
                    options);
    const double sagitta = test::kPi * test::kPi / (2.0 * n * n) * 4;
    double wanted = 1;
    if (perspective) {
      const double eye = view.camera.eye().z;  // tangent cone of the ball at the depth of the line
      wanted = (eye + 2) * std::tan(std::asin(1 / eye));
    }
    const Curve3 across = test::line({-1.9, 0.0, -2}, {1.9, 0.0, -2}, 11);
    const auto spans = view.classify(across);
    ASSERT_EQ(spans.size(), 3u);
    EXPECT_FALSE(spans[1].visible);
    EXPECT_NEAR(test::point_at(across, spans[0].end).x, -wanted, 2 * sagitta * wanted);
    EXPECT_NEAR(test::point_at(across, spans[1].end).x, wanted, 2 * sagitta * wanted);
  }
}

TEST(VisibleSpans, ShowsTheWholeContourOfABall) {
  const View view({test::ellipsoid({1, 1, 1}, 60, 30)}, {});
  ASSERT_EQ(view.features.size(), 1u);
  ASSERT_EQ(view.spans[0].size(), 1u);
  EXPECT_TRUE(view.spans[0][0].visible);
}

// --- parts that touch
// ------------------------------------------------------------------------------------------

TEST(VisibleSpans, DrawsABoxOnAPlateWithoutSpecks) {
  const View view({test::box({-2, -2, -1}, {2, 2, 0}), test::box({-0.5, -0.5, 0}, {0.5, 0.5, 0.5})},
                  {});
  EXPECT_NEAR(visible_length(view), 27 + 7.5, 1e-9);
  EXPECT_GT(shortest_visible(view), 5);
}

TEST(VisibleSpans, DrawsTwoBoxesWithACommonFace) {
  const View view({test::box({0, 0, 0}, {1, 1, 1}), test::box({1, 0, 0}, {2, 1, 1})}, {});
  EXPECT_NEAR(visible_length(view), 7 + 9, 1e-9);
  EXPECT_GT(shortest_visible(view), 5);
}

TEST(VisibleSpans, DrawsABoxSunkFlushIntoAnother) {
  const View view({test::box({-2, -2, -2}, {2, 2, 0}), test::box({-1, -1, -1}, {1, 1, 0})}, {});
  EXPECT_NEAR(visible_length(view), 30 + 8, 1e-9);
  EXPECT_GT(shortest_visible(view), 5);
}

TEST(VisibleSpans, DrawsABoxOnTheSideOfAnother) {
  const View view({test::box({-2, -2, -2}, {2, 2, 0}), test::box({2, -1, -2}, {3, 1, -1})}, {});
  EXPECT_NEAR(visible_length(view), 27 + 12, 1e-9);
  EXPECT_GT(shortest_visible(view), 5);
}

// From every named side, with faces seen edge on and lines behind lines.
TEST(VisibleSpans, NeverSpecklesOnTouchingBoxes) {
  for (const char* name :
       {"front", "back", "left", "right", "top", "bottom", "iso", "dimetric", "trimetric"}) {
    const NamedView named = named_view(name);
    const View view({test::box({-2, -2, -1}, {2, 2, 0}), test::box({-1, -2, 0}, {1, 0, 1}),
                     test::box({1, -2, 0}, {2, 0, 1}), test::box({-1, -1.5, 1}, {0.5, -0.5, 2})},
                    {.direction = named.direction, .up = named.up});
    EXPECT_GT(shortest_visible(view), 4) << name;
  }
}

// A pin in a hole of its own radius, tessellated differently: the rims are whole.
TEST(VisibleSpans, DrawsAPinInItsHole) {
  const std::uint32_t n = 64;
  TriMesh washer = test::grid(n, 4, true, true, [&](std::uint32_t i, std::uint32_t j) {
    const double u = 2 * test::kPi * i / n, r = j == 0 || j == 3 ? 3 : 1, z = j < 2 ? 0 : 1;
    return Vec3(r * std::cos(u), r * std::sin(u), z);
  });
  for (Triangle& t : washer.triangles) std::swap(t[1], t[2]);
  const TriMesh pin =
      test::mapped(test::cylinder(1, 3, 50), [](Vec3 p) { return p - Vec3(0, 0, 1); });
  const View view({washer, pin}, {.direction = {0, -1, 1}});
  double rim = 0;
  int pieces = 0;
  for (std::size_t c = 0; c < view.features.size(); ++c) {
    const Curve3& curve = view.features[c];
    const Vec3 p = curve.points[0];
    if (curve.source.part != 0 || std::abs(p.z - 1) > 1e-9 || std::hypot(p.x, p.y) > 1.1) continue;
    for (const Span& s : view.spans[c]) {
      if (!s.visible) continue;
      ++pieces;
      rim += test::paper_length(view.camera, curve, s.begin, s.end);
    }
  }
  // The pin stands 1 high before the far half of the rim and hides all of it that lies behind its
  // outline.
  EXPECT_LE(pieces, 3);
  EXPECT_GT(rim / view.camera.scale(), 2.2);
  EXPECT_LT(rim / view.camera.scale(), 3.2);
}

// --- the outer outline
// -----------------------------------------------------------------------------------------

TEST(VisibleSpans, FindsTheOutlineOfABox) {
  const View view({test::box({0, 0, 0}, {1, 1, 1})}, {}, {.classify_outer = true});
  EXPECT_NEAR(outer_length(view), 6 * std::sqrt(2.0 / 3.0) * view.camera.scale(), 1e-9);
}

TEST(VisibleSpans, CutsTheOutlineWhereAFarPartBegins) {
  const View view({test::box({-1, -1, 0}, {1, 1, 1}), test::box({0, -0.5, -3}, {3, 0.5, -2})},
                  {.direction = {0, 0, 1}, .up = {0, 1, 0}}, {.classify_outer = true});
  EXPECT_NEAR(outer_length(view) / view.camera.scale(), 12, 1e-9);
}

// A sheet that stands out by less than what is looked at beside a line is no paper.
TEST(VisibleSpans, TakesNoLineForTheOutlineThatANarrowStripLiesBeside) {
  const View narrow({test::box({-1, -1, 0}, {1, 1, 1}), test::box({-1, -1, -2}, {1.001, 1, -1})},
                    {.direction = {0, 0, 1}, .up = {0, 1, 0}}, {.classify_outer = true});
  const double strip = 0.001 * narrow.camera.scale();
  ASSERT_GT(strip, 0.05);
  ASSERT_LT(strip, 0.15);
  // The right side is that of the far box alone; of the others both lie on each other.
  EXPECT_NEAR(outer_length(narrow) / narrow.camera.scale(), 8.002, 1e-3);
}

// Behind its fold the far rim of an open tube is hidden at once. Triangles as long as the tube are
// few around the fold, and those before the rim passed for its own.
TEST(VisibleSpans, HidesTheRimOfATubeRightBehindItsFold) {
  for (const std::uint32_t sides : {120U, 300U}) {
    const TriMesh tube = test::grid(sides, 2, true, false, [&](std::uint32_t i, std::uint32_t j) {
      const double a = 2 * test::kPi * i / sides;
      return Vec3(std::cos(a), std::sin(a), 3 * (j - 0.5));
    });
    const View view({tube}, {.direction = {-0.4, -1, 0.55}});
    const Vec3 v = view.camera.direction();
    double behind = 0, before = 0;
    for (std::size_t c = 0; c < view.features.size(); ++c) {
      for (const Span& s : view.spans[c]) {
        if (!s.visible || view.features[c].kind != LineClass::Boundary) continue;
        const Curve3 part = slice(view.features[c], s.begin, s.end);
        for (std::size_t i = 0; i < part.segment_count(); ++i) {
          const Vec3 a = part.points[i], b = part.points[part.next(i)], middle = 0.5 * (a + b);
          if (middle.z > 0) continue;
          const double length = glm::distance(view.camera.to_paper(a), view.camera.to_paper(b));
          (glm::dot(Vec3(middle.x, middle.y, 0), v) < 0 ? behind : before) += length;
        }
      }
    }
    EXPECT_GT(before, 60) << sides;
    EXPECT_LT(behind, 0.4) << sides;
  }
}

// A knotted bar with eight flat sides. Where a quadrangle that cannot be seen is taken out of it,
// it is an open sheet, and has the same outline.
TEST(VisibleSpans, OutlinesAnOpenSheetAsTheClosedOne) {
  constexpr std::uint32_t kAlong = 40, kSides = 8;
  const TriMesh closed =
      test::grid(kAlong, kSides, true, true, [](std::uint32_t i, std::uint32_t j) {
        const double t = 2 * test::kPi * i / kAlong, v = 2 * test::kPi * j / kSides;
        const Vec3 tangent(std::cos(t) + 4 * std::cos(2 * t), -std::sin(t) + 4 * std::sin(2 * t),
                           -3 * std::cos(3 * t));
        const Vec3 side = glm::normalize(glm::cross(tangent, Vec3(0, 0, 1)));
        const Vec3 up = glm::normalize(glm::cross(side, tangent));
        return Vec3(std::sin(t) + 2 * std::sin(2 * t), std::cos(t) - 2 * std::cos(2 * t),
                    -std::sin(3 * t)) +
               0.8 * (std::cos(v) * up - std::sin(v) * side);
      });
  for (const Vec3 direction : {Vec3(1, -1, 1), Vec3(0, -1, 0.1), Vec3(0, 0, 1), Vec3(1, -1, -1),
                               Vec3(-2, 1, 0.5), Vec3(0.3, -1, 0.45)}) {
    const View whole({closed}, {.direction = direction}, {.classify_outer = true});
    std::size_t unseen = 0;
    for (; unseen < closed.triangles.size(); unseen += 2) {
      const Triangle& t = closed.triangles[unseen];
      const Vec3 middle = 0.5 * (closed.positions[t[0]] + closed.positions[t[2]]);
      const Vec3 normal = closed.normal(static_cast<std::uint32_t>(unseen));
      if (glm::dot(normal, whole.camera.to_viewer(middle)) < -0.5) break;
    }
    TriMesh open = closed;
    const auto first = open.triangles.begin() + static_cast<std::ptrdiff_t>(unseen);
    open.triangles.erase(first, first + 2);
    const double seen = outer_length(whole);
    EXPECT_NEAR(outer_length(View({open}, {.direction = direction}, {.classify_outer = true})),
                seen, 0.02 * seen);
  }
}

// A ring of coarse beads: where one lies before the contour of the next, few triangles are between
// both, but it does not end beside that contour as its own fold does.
TEST(VisibleSpans, HidesAContourBehindABulgeOfFewFacets) {
  double hidden = 0, seen = 0;
  for (const std::uint32_t rings : {6U, 7U, 8U}) {
    const std::uint32_t around = 10 * rings, sides = 16;
    const TriMesh mesh =
        test::grid(around, sides, true, true, [&](std::uint32_t i, std::uint32_t j) {
          const double u = 2 * test::kPi * i / around, v = 2 * test::kPi * (j + 0.5) / sides;
          const double r = 1 - 0.35 * std::cos(10 * u), out = 3 + r * std::cos(v);
          return Vec3(out * std::cos(u), out * std::sin(u), r * std::sin(v));
        });
    for (const double up : {0.7, 0.9}) {
      const View view({mesh}, {.direction = {1, 0.1, up}});
      const double off = 0.25 / view.camera.scale();
      for (std::size_t c = 0; c < view.features.size(); ++c) {
        const Curve3& curve = view.features[c];
        if (curve.kind != LineClass::Contour) continue;
        for (const Span& span : view.spans[c]) {
          if (!span.visible) continue;
          for (double at = span.begin; at < span.end; at += 0.1) {
            const auto segment = static_cast<std::size_t>(at);
            const Vec3 p = test::point_at(curve, at), n = curve.normals[segment];
            const double length =
                0.1 * test::paper_length(view.camera, curve, static_cast<double>(segment),
                                         static_cast<double>(segment + 1));
            const bool covered = view.occluder->occluded(p + off * n, view.camera.to_viewer(p), 0,
                                                         2 * view.occluder->diagonal());
            (covered ? hidden : seen) += length;
          }
        }
      }
    }
  }
  EXPECT_GT(seen, 9000);
  EXPECT_LT(hidden, 0.021 * seen);  // what is left are coarse facets; 0.03 without looking beside
}

// A contour that zigzags across long narrow triangles runs along the outline a little inside,
// behind its own fold. Alone it is the outline; beside one that is nearer to the paper it is none.
TEST(VisibleSpans, HidesAContourRightInsideTheOutline) {
  constexpr std::uint32_t kSides = 128;
  const View view({test::cylinder(1, 1.5, kSides)}, {.direction = {0, -1, 0}});
  const double inside = 0.16 / view.camera.scale(), step = 2 * test::kPi / kSides;
  const auto contour = [&](double angle) {
    Curve3 curve = test::line({std::cos(angle), std::sin(angle), 0.2},
                              {std::cos(angle), std::sin(angle), 1.3}, 10);
    curve.kind = LineClass::Contour;
    curve.occluding = true;
    curve.source = {0, 0, -1};
    curve.normals.assign(curve.points.size(), Vec3(std::cos(angle), std::sin(angle), 0));
    curve.faces.assign(curve.segment_count(),
                       static_cast<std::int32_t>(4 * (angle / step)) / 4 * 4);
    return curve;
  };
  const Curve3 outline = contour(0), behind = contour(std::acos(1 - inside));
  const auto seen = [&](const std::vector<Curve3>& lines) {
    const VisibilityMap map(*view.occluder, view.pointers, view.camera, lines, view.context);
    std::vector<bool> out;
    for (const auto& spans : map.classify(lines, {}, view.context)) {
      EXPECT_EQ(spans.size(), 1U);
      out.push_back(spans.front().visible);
    }
    return out;
  };
  EXPECT_EQ(seen({behind}), std::vector{true});
  EXPECT_EQ(seen({behind, outline}), (std::vector{false, true}));
}

// --- smooth surfaces
// -------------------------------------------------------------------------------------------

constexpr double kMajor = 3, kMinor = 1;

double torus_distance(Vec3 p) { return std::hypot(std::hypot(p.x, p.y) - kMajor, p.z) - kMinor; }

// How near the line of sight from `p` comes to the inside of the torus beyond the point's own
// neighbourhood: sphere tracing of the exact distance; negative where it is hidden.
double clearance(Vec3 p, Vec3 view) {
  double nearest = 1e9;
  for (double t = 0.4; t < 12;) {
    const double d = torus_distance(p + view * t);
    nearest = std::min(nearest, d);
    if (d < 0) return d;
    t += std::max(d, 0.002);
  }
  return nearest;
}

// Share of the length of the curves whose answer is that of the exact surface; where it is nearly
// touched none is asked for.
double torus_agreement(const View& view, std::span<const Curve3> curves,
                       const std::vector<std::vector<Span>>& spans) {
  double right = 0, all = 0;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const Curve3& curve = curves[c];
    for (const Span& s : spans[c]) {
      const double length = test::paper_length(view.camera, curve, s.begin, s.end);
      const int count = static_cast<int>(length / 0.5) + 1;
      for (int i = 0; i < count; ++i) {
        const double at = s.begin + (s.end - s.begin) * (i + 0.5) / count;
        if (!curve.self_hidden.empty() && curve.self_hidden[static_cast<std::size_t>(at)]) continue;
        const Vec3 p = test::point_at(curve, at);
        const double clear = clearance(p, view.camera.to_viewer(p));
        if (std::abs(clear) < 0.02) continue;
        all += length / count;
        if (s.visible == (clear > 0)) right += length / count;
      }
    }
  }
  EXPECT_GT(all, 100);
  return right / all;
}

TEST(VisibleSpans, AgreesWithTheExactTorusAlongItsContours) {
  for (const Vec3 direction : {Vec3(1, 0, 0.25), Vec3(1, 0.2, 0.6), Vec3(1, 1, 1)}) {
    for (const bool perspective : {false, true}) {
      ViewOptions options{.direction = direction};
      if (perspective) options.perspective = 35;
      const View view({test::torus(kMajor, kMinor, 240, 100)}, options);
      EXPECT_GT(torus_agreement(view, view.features, view.spans), 0.995) << direction.z;
      EXPECT_GT(shortest_visible(view), 0.5);
    }
  }
}

TEST(VisibleSpans, AgreesWithTheExactTorusAlongStrokes) {
  const std::uint32_t nu = 240, nv = 100;
  const View view({test::torus(kMajor, kMinor, nu, nv)}, {.direction = {1, 0.2, 0.6}});
  std::vector<Curve3> strokes(60);
  for (std::size_t s = 0; s < strokes.size(); ++s) {
    Curve3& stroke = strokes[s];
    stroke.source.part = 0;
    const double row = 240.0 * static_cast<double>(s) / 60 + 0.4;
    for (std::uint32_t i = 0; i <= 4 * nv / 5; ++i) {  // points on the edges of the quads' rows
      const double u = 2 * test::kPi * row / nu, v = 2 * test::kPi * i / nv;
      const Vec3 out{std::cos(u), std::sin(u), 0};
      const Vec3 n = out * std::cos(v) + Vec3(0, 0, std::sin(v));
      stroke.points.push_back(kMajor * out + kMinor * n);
      stroke.normals.push_back(n);
      if (i > 0)
        stroke.faces.push_back(
            static_cast<std::int32_t>(2 * (static_cast<std::uint32_t>(row) * nv + i - 1)));
    }
  }
  const auto spans = view.map->classify(strokes, {}, view.context);
  double right = 0, all = 0;
  for (std::size_t s = 0; s < strokes.size(); ++s) {
    for (const Span& span : spans[s]) {
      for (double at = span.begin; at < span.end; at += 0.1) {
        const Vec3 p = test::point_at(strokes[s], at), v = view.camera.to_viewer(p);
        const Vec3 n = strokes[s].normals[static_cast<std::size_t>(at)];
        const double facing = glm::dot(n, v), clear = clearance(p, v);
        if (std::abs(facing) < 0.1 || std::abs(clear) < 0.02) continue;
        all += 1;
        right += span.visible == (facing > 0 && clear > 0);
      }
      EXPECT_GT(test::paper_length(view.camera, strokes[s], span.begin, span.end), 0.05);
    }
  }
  EXPECT_GT(all, 1000);
  EXPECT_GT(right / all, 0.998);
}

// --- size, place, threads, closed curves
// -------------------------------------------------------------------------

TEST(VisibleSpans, AnswersAlikeAtEverySizeAndPlace) {
  const auto make = [](double scale, Vec3 shift) {
    const auto place = [&](TriMesh m) {
      return test::mapped(std::move(m), [&](Vec3 p) { return p * scale + shift; });
    };
    return View({place(test::box({-2.1, -2.05, -1.02}, {2.04, 2.2, 0.03})),
                 place(test::mapped(test::torus(3, 1, 90, 40),
                                    [](Vec3 p) { return p + Vec3(0.03, 0.02, 0.0123); })),
                 place(test::mapped(test::ellipsoid({1, 1, 2}, 60, 40),
                                    [](Vec3 p) { return p + Vec3(1, 0, 3); }))},
                {}, {.classify_outer = true});
  };
  const View plain = make(1, Vec3(0));
  for (const auto& [scale, shift] : {std::pair{1e-3, Vec3(0)},
                                     {1e4, Vec3(0)},
                                     {1.0, Vec3(1e5, -1e5, 5e4)},
                                     {1e-3, Vec3(30, 20, -50)}}) {
    const View other = make(scale, shift);
    ASSERT_EQ(other.features.size(), plain.features.size());
    for (std::size_t c = 0; c < plain.features.size(); ++c) {
      ASSERT_EQ(other.spans[c].size(), plain.spans[c].size()) << scale << ' ' << c;
      for (std::size_t i = 0; i < plain.spans[c].size(); ++i) {
        const Span &a = plain.spans[c][i], &b = other.spans[c][i];
        EXPECT_EQ(a.visible, b.visible);
        EXPECT_EQ(a.outer, b.outer);
        for (const auto& [x, y] : {std::pair{a.begin, b.begin}, {a.end, b.end}}) {
          const Vec2 p = plain.camera.to_paper(test::point_at(plain.features[c], x));
          const Vec2 q = other.camera.to_paper(test::point_at(other.features[c], y));
          EXPECT_LT(glm::length(p - q), 1e-3);
        }
      }
    }
  }
}

TEST(VisibleSpans, AnswersAlikeForAnyNumberOfThreads) {
  const auto make = [] {
    return View(
        {test::torus(3, 1, 150, 60), test::box({-4, -4, -2}, {4, 4, -1}),
         test::mapped(test::torus(1, 0.4, 90, 40), [](Vec3 p) { return p + Vec3(2, -2, 1.5); })},
        {}, {.classify_outer = true});
  };
  const View many = make();
  const ThreadLimit limit(1);
  const View one = make();
  ASSERT_EQ(one.spans.size(), many.spans.size());
  for (std::size_t c = 0; c < one.spans.size(); ++c) {
    ASSERT_EQ(one.spans[c].size(), many.spans[c].size());
    for (std::size_t i = 0; i < one.spans[c].size(); ++i) {
      const Span &a = one.spans[c][i], &b = many.spans[c][i];
      EXPECT_TRUE(a.begin == b.begin && a.end == b.end && a.visible == b.visible &&
                  a.outer == b.outer);
    }
  }
}

TEST(VisibleSpans, CutsAClosedCurveOverItsStart) {
  const View view({test::box({-1, -1, 0}, {1, 1, 1}), test::box({-4, -4, -3}, {4, 4, -2.5})},
                  {.direction = {0, 0, 1}, .up = {0, 1, 0}});
  // A square round (1, 0) below the box, from a corner that is hidden or seen.
  const std::vector<Vec3> square{{0.5, -0.5, -1}, {1.5, -0.5, -1}, {1.5, 0.5, -1}, {0.5, 0.5, -1}};
  for (std::size_t turn = 0; turn < 4; ++turn) {
    Curve3 c;
    c.closed = true;
    for (std::size_t i = 0; i < 4; ++i) c.points.push_back(square[(i + turn) % 4]);
    const auto spans = view.classify(c);
    ASSERT_EQ(spans.size(), 3u);
    EXPECT_EQ(spans.front().begin, 0);
    EXPECT_EQ(spans.back().end, 4);
    double seen = 0;
    for (std::size_t i = 0; i < spans.size(); ++i) {
      if (i > 0) {
        EXPECT_EQ(spans[i].begin, spans[i - 1].end);
        EXPECT_NEAR(test::point_at(c, spans[i].begin).x, 1, 1e-12);
      }
      if (spans[i].visible) seen += spans[i].end - spans[i].begin;
    }
    EXPECT_NEAR(seen, 2, 1e-12);
    EXPECT_EQ(spans.front().visible, spans.back().visible);
  }
}

// A rod through a plate without any intersection curve: the cut lies where it pierces the plate.
TEST(VisibleSpans, FindsWhereALineEntersASurface) {
  View view({test::box({-2, -2, -1}, {2, 2, 0})}, {.direction = {0.3, 0.2, 1}});
  const Curve3 rod = test::line({0.1, 0.2, -0.7}, {0.2, 0.1, 0.7}, 3);
  const auto spans = view.classify(rod);
  ASSERT_EQ(spans.size(), 2u);
  EXPECT_FALSE(spans[0].visible);
  EXPECT_NEAR(test::point_at(rod, spans[1].begin).z, 0, 1e-3);
}

// A line on a ball of facets that runs a little lower along its middle, as edges of a CAD file may
// lie off its faces: within a few chord errors that is its own surface, farther in it is hidden.
TEST(VisibleSpans, IsNotHiddenByWhatItNeverGetsClearOf) {
  const View view({test::ellipsoid({1, 1, 1}, 64, 32)}, {.direction = {0, 0, 1}, .up = {0, 1, 0}});
  const auto seen = [&](double chord_errors) {
    constexpr int kSegments = 60;
    Curve3 line;
    line.kind = LineClass::Crease;
    line.source.part = 0;
    for (int i = 0; i <= kSegments; ++i) {
      const double angle = -0.6 + 1.2 * i / kSegments;
      const Vec3 out = glm::normalize(Vec3(std::sin(angle), 0.15, std::cos(angle)));
      const auto hit = view.occluder->first_hit(out * 2.0, -out, 0, 2);
      if (!hit) return -1.0;
      const auto face = static_cast<std::int32_t>(hit->where.face);
      const double error = chord_error(view.proxies[0], hit->where.face);
      const bool low = std::abs(angle) < 0.2;
      line.points.push_back(view.proxies[0].position(hit->where.face, hit->bary) -
                            (low ? chord_errors * error : 0) * out);
      line.normals.push_back(out);
      if (i < kSegments) line.faces.push_back(face);
    }
    double length = 0;
    for (const Span& s : view.classify(line)) {
      if (s.visible) length += test::paper_length(view.camera, line, s.begin, s.end);
    }
    return length / test::paper_length(view.camera, line, 0, kSegments);
  };
  EXPECT_NEAR(seen(0), 1, 1e-9);
  EXPECT_NEAR(seen(4), 1, 1e-9);
  EXPECT_NEAR(seen(40), 1 - std::sin(0.2) / std::sin(0.6), 0.1);
}

// The share of an edge that is seen from straight above, as it is drawn: `drawn` over the polyline
// of triangles `faces`.
double seen_share(const View& view, std::vector<Vec3> drawn, std::vector<std::int32_t> faces) {
  Curve3 edge;
  edge.kind = LineClass::Smooth;
  edge.source.part = 0;
  edge.normals.assign(drawn.size(), Vec3(0, 0, 1));
  edge.points = std::move(drawn);
  edge.faces = std::move(faces);
  double length = 0;
  for (const Span& s : view.classify(edge)) {
    if (s.visible) length += test::paper_length(view.camera, edge, s.begin, s.end);
  }
  return length / test::paper_length(view.camera, edge, 0, double(edge.segment_count()));
}

// An edge that sags by 0.03 mm of paper under the chord that its own flat triangle has there.
TEST(VisibleSpans, ShowsAnEdgeThatBendsWhereItsFaceDoesNot) {
  TriMesh sheet;
  sheet.positions = {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}, {0, -10, 0}, {10, -10, 0}};
  sheet.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 1}, {4, 1, 0}};
  const View view({sheet}, {.direction = {0, 0, 1}, .up = {0, 1, 0}});
  const auto seen = [&](double paper) {
    constexpr int kSegments = 20;
    std::vector<Vec3> points;
    for (int i = 0; i <= kSegments; ++i) {
      const double t = double(i) / kSegments;
      points.emplace_back(10 * t, -1e-3, -4 * t * (1 - t) * paper / view.camera.scale());
    }
    return seen_share(view, points, std::vector<std::int32_t>(kSegments, 0));
  };
  EXPECT_NEAR(seen(0.03), 1, 1e-9);
  EXPECT_LT(seen(0.5), 0.2);  // far under it, it is hidden
}

// A coarse ball with a plate through it, under a skin nearer than the chord error of both: where
// ball and plate pass through each other lies on the facets and is hidden, however coarse they are.
TEST(VisibleSpans, HidesAnIntersectionRightUnderAnotherSheet) {
  const View view({test::ellipsoid({10, 10, 10}, 16, 8), test::box({-12, -12, -1}, {12, 12, 1}),
                   test::ellipsoid({10.1, 10.1, 10.1}, 16, 8)},
                  {.direction = {1, -1, 1}});
  double under = 0, over = 0;
  for (std::size_t c = 0; c < view.features.size(); ++c) {
    const Curve3& curve = view.features[c];
    if (curve.kind != LineClass::Intersection) continue;
    for (const Span& s : view.spans[c]) {
      if (!s.visible) continue;
      (curve.source.part == 0 ? under : over) +=
          test::paper_length(view.camera, curve, s.begin, s.end);
    }
  }
  EXPECT_EQ(under, 0);  // of the ball and the plate
  EXPECT_GT(over, 50);  // of the plate and the skin
}

// A stroke goes round an open tube and a mm and more of paper on beyond its fold, as the tracer
// lets it: it never crosses the contour in the picture, yet it ends there.
TEST(VisibleSpans, AStrokeOnAnOpenSheetEndsAtItsFold) {
  constexpr std::uint32_t kAround = 96, kUp = 40;
  const View view({test::grid(kAround, kUp, true, false,
                              [](std::uint32_t i, std::uint32_t j) {
                                const double u = 2 * test::kPi * i / kAround;
                                return Vec3(50 * std::cos(u), 50 * std::sin(u), 2.5 * j);
                              })},
                  {.direction = {0, -1, 0.2}, .scale = 1});
  Curve3 stroke;
  stroke.kind = LineClass::Stroke;
  stroke.source.part = 0;
  constexpr int kSegments = 60;
  constexpr double kBeyond = 0.25;  // radians: 1.5 mm of paper
  for (int i = 0; i <= kSegments; ++i) {
    const double u = -0.6 + (0.6 + kBeyond) * i / kSegments;
    const Vec3 out(std::cos(u), std::sin(u), 0);
    stroke.points.push_back(50.0 * out + Vec3(0, 0, 50));
    stroke.normals.push_back(out);
    const auto hit = view.occluder->first_hit(stroke.points.back() + 5.0 * out, -out, 0, 10);
    ASSERT_TRUE(hit);
    if (i < kSegments) stroke.faces.push_back(static_cast<std::int32_t>(hit->where.face));
  }
  const auto spans = view.classify(stroke);
  ASSERT_EQ(spans.size(), 2u);
  EXPECT_TRUE(spans[0].visible);
  EXPECT_FALSE(spans[1].visible);
  EXPECT_LT(std::abs(test::point_at(stroke, spans[0].end).x - 50), 0.1);
  EXPECT_LT(
      test::paper_length(view.camera, stroke, spans[0].end, kSegments * 0.6 / (0.6 + kBeyond)),
      0.1);
}

// Fairing left a stroke 1 um under a hollow wall of strips that are narrower than its steps: the
// strips that it runs over lie before it, and hide nothing.
TEST(VisibleSpans, StripsUnderAFairedStrokeDoNotHideIt) {
  constexpr double kRadius = 50;
  const auto wall = [](double x) { return 0.5 * x * x / kRadius; };
  const View view({test::grid(201, 2, false, false,
                              [&](std::uint32_t i, std::uint32_t j) {
                                const double x = 0.1 * i - 10;
                                return Vec3(x, 20.0 * j, wall(x));
                              })},
                  {.direction = {0, -0.5, 1}, .up = {0, 1, 0}, .scale = 1});
  const auto seen = [&](double under) {
    Curve3 stroke;
    stroke.kind = LineClass::Stroke;
    stroke.source.part = 0;
    for (int i = 0; i <= 40; ++i) {
      const double x = 0.4 * i - 7.95;
      stroke.points.emplace_back(x, 9, wall(x) - under);
      stroke.normals.push_back(glm::normalize(Vec3(-x / kRadius, 0, 1)));
      const auto hit = view.occluder->first_hit({x, 9, 5}, {0, 0, -1}, 0, 10);
      if (i < 40) stroke.faces.push_back(static_cast<std::int32_t>(hit->where.face));
    }
    double length = 0;
    for (const Span& s : view.classify(stroke)) length += s.visible ? s.end - s.begin : 0;
    return length / 40;
  };
  EXPECT_EQ(seen(0), 1);
  EXPECT_EQ(seen(0.001), 1);
}

// --- slices
// ----------------------------------------------------------------------------------------------------

TEST(VisibleSpans, SlicesOpenCurves) {
  Curve3 c = test::line({0, 0, 0}, {4, 0, 0}, 4);
  c.widths = {0, 1, 2, 3, 4};
  c.faces = {10, 11, 12, 13};
  c.self_hidden = {0, 1, 0, 1};
  c.normals.assign(5, Vec3(0, 0, 1));
  const Curve3 part = slice(c, 0.5, 2.25);
  ASSERT_EQ(part.points.size(), 4u);
  EXPECT_EQ(part.points[0].x, 0.5);
  EXPECT_EQ(part.points[1].x, 1);
  EXPECT_EQ(part.points[3].x, 2.25);
  EXPECT_EQ(part.widths[3], 2.25);
  EXPECT_EQ(part.faces, (std::vector<std::int32_t>{10, 11, 12}));
  EXPECT_EQ(part.self_hidden, (std::vector<std::uint8_t>{0, 1, 0}));
  EXPECT_EQ(part.normals.size(), 4u);
  const Curve3 whole = slice(c, 0, 4);
  EXPECT_EQ(whole.points.size(), 5u);
  EXPECT_EQ(whole.faces.size(), 4u);
  const Curve3 one = slice(c, 2, 3);
  ASSERT_EQ(one.points.size(), 2u);
  EXPECT_EQ(one.points[0].x, 2);
  EXPECT_EQ(one.points[1].x, 3);
  EXPECT_EQ(one.faces, (std::vector<std::int32_t>{12}));
}

TEST(VisibleSpans, SlicesClosedCurvesOverTheirStart) {
  Curve3 c;
  c.closed = true;
  c.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  c.faces = {1, 2, 3, 4};
  const Curve3 part = slice(c, 3.5, 5.5);
  ASSERT_EQ(part.points.size(), 4u);
  EXPECT_FALSE(part.closed);
  EXPECT_EQ(part.points[0], Vec3(0, 0.5, 0));
  EXPECT_EQ(part.points[1], Vec3(0, 0, 0));
  EXPECT_EQ(part.points[2], Vec3(1, 0, 0));
  EXPECT_EQ(part.points[3], Vec3(1, 0.5, 0));
  EXPECT_EQ(part.faces, (std::vector<std::int32_t>{4, 1, 2}));
  const Curve3 turn = slice(c, 2, 6);
  EXPECT_TRUE(turn.closed);
  EXPECT_EQ(turn.points[0], Vec3(1, 1, 0));
  EXPECT_EQ(turn.faces, (std::vector<std::int32_t>{3, 4, 1, 2}));
  EXPECT_TRUE(slice(c, 0, 4).closed);
}

}  // namespace
}  // namespace burin
