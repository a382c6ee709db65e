/// How exactly visible strokes end where surfaces pass through each other: against the truth of
/// quadrics, looked at along the line of sight.

#include <burin/feature/feature.h>
#include <burin/field/field.h>
#include <burin/forms/implicit/expression.h>
#include <burin/forms/implicit/implicit_form.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/forms/patches/parametric_form.h>
#include <burin/illustrate/view_probe.h>
#include <burin/stroke/stroke.h>
#include <burin/visibility/visible_spans.h>

#include <burin_test/charts.h>
#include <burin_test/shapes.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace burin {
namespace {

using Forms = std::vector<std::shared_ptr<const Form>>;

// A sphere, a round tube or a disc of which `holds` says what there is.
struct Shape {
  Vec3 center{0}, axis{0};  // axis zero: a sphere; else a unit vector
  double radius = 1;
  std::function<bool(Vec3)> holds = {};
  bool flat = false;  // a disc about the axis

  // Where a line meets it, holes filled in; nothing where it passes.
  std::vector<double> meets(Vec3 p, Vec3 d) const {
    if (flat) {
      const double f = glm::dot(d, axis);
      if (std::abs(f) < 1e-12) return {};
      return {glm::dot(center - p, axis) / f};
    }
    const Vec3 q = reject(p - center, axis), e = reject(d, axis);
    const double a = glm::dot(e, e), b = glm::dot(e, q), c = glm::dot(q, q) - radius * radius;
    const double root = b * b - a * c;
    if (!(root > 0) || !(a > 1e-12)) return {};
    return {(-b - std::sqrt(root)) / a, (-b + std::sqrt(root)) / a};
  }
  bool has(Vec3 p) const {
    return (!holds || holds(p)) && (!flat || glm::distance(p, center) < radius);
  }
  Vec3 normal(Vec3 p) const { return flat ? axis : glm::normalize(reject(p - center, axis)); }
  double off(Vec3 p) const {
    return flat ? std::abs(glm::dot(p - center, axis))
                : std::abs(glm::length(reject(p - center, axis)) - radius);
  }
};

// What really is there.
struct Truth {
  std::vector<Shape> shapes;

  // The place on the sheet that a point of a line stands for: chords and facets are off it, which
  // near contours is a long way along the line of sight and nothing on paper.
  struct Place {
    int shape = -1;
    double along = 0;
  };
  Place place(Vec3 p, Vec3 normal, Vec3 view) const {
    Place best;
    double least = 0.4;  // model mm; drawings here have a scale of 1
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      if (glm::length(glm::cross(shapes[i].normal(p), normal)) > 0.3) continue;
      if (!(shapes[i].off(p) < least)) continue;
      for (const double t : shapes[i].meets(p, view)) {
        if (best.shape != static_cast<int>(i)) best = {static_cast<int>(i), t};
        if (std::abs(t) < std::abs(best.along)) best.along = t;
      }
      least = shapes[i].off(p);
    }
    return best;
  }
  // Nothing where the line is off the sheet or the sheet is seen nearly edge-on.
  std::optional<bool> hidden(Vec3 p, Vec3 normal, Vec3 view) const {
    constexpr double kEdgeOn = 0.2;
    if (std::abs(glm::dot(normal, view)) < kEdgeOn) return std::nullopt;
    const Place at = place(p, normal, view);
    if (at.shape < 0) return std::nullopt;
    const Vec3 q = p + at.along * view;
    const Shape& own = shapes[static_cast<std::size_t>(at.shape)];
    if (std::abs(glm::dot(own.normal(q), view)) < kEdgeOn) return std::nullopt;
    for (const Shape& s : shapes) {
      for (const double t : s.meets(p, view)) {
        if (t > at.along + 1e-6 && s.has(p + t * view)) return true;
      }
    }
    return false;
  }
  // Whether something hides all of the surface within a distance, too: strokes cross the border of
  // what is seen at any angle.
  bool well_hidden(Vec3 p, Vec3 normal, Vec3 view, double within) const {
    constexpr int kAround = 12;
    const auto at = [&](Vec3 q) {
      const auto h = hidden(q, normal, view);
      return h && *h;
    };
    if (!at(p)) return false;
    const Vec3 u = any_orthogonal(normal), v = glm::cross(normal, u);
    for (int i = 0; i < kAround; ++i) {
      const double a = 2 * test::kPi * i / kAround;
      if (!at(p + within * (std::cos(a) * u + std::sin(a) * v))) return false;
    }
    return true;
  }
};

// The longest stretch, in paper mm, that is shown though something hides it and what is around it.
struct Wrong {
  double shown = 0, strokes = 0;
};

struct EndScene {
  explicit EndScene(const Forms& forms, Vec3 direction, std::optional<double> perspective = {})
      : camera(Camera::fit(
            [&](const Mat3& axes) {
              Box3 box;
              for (const auto& f : forms) box.add(f->bounds(axes));
              return box;
            },
            {.direction = direction,
             .perspective = perspective,
             .scale = 1,
             .center = perspective ? std::optional(Vec3(0)) : std::nullopt,
             .paper = {200, 200}})) {
    for (const auto& f : forms) {
      owned.push_back(f->realise({.tolerance = 0.05, .view = &camera}, context));
      surfaces.push_back(owned.back().get());
      proxies.push_back(&owned.back()->proxy());
    }
    occluder = std::make_unique<Occluder>(proxies, context);
    Diagnostics diagnostics;
    features = extract_features(proxies, camera, {}, diagnostics, context);
    map = std::make_unique<VisibilityMap>(*occluder, proxies, camera, features, context);
  }

  std::vector<Curve3> strokes(Vec3 along) {
    const ViewProbe probe = view_probe(*occluder, camera);
    const HatchOptions options{.spacing_min = 0.7,
                               .spacing_max = 1.4,
                               .width_max = 0.5,
                               .tone_min = 0.05,
                               .cross_from = 0.3,
                               .length_max = 300};
    return trace_strokes(
               surfaces, camera, field::fixed(along), [](Vec3, Vec3) { return 0.5; }, probe,
               options, 1, context)
        .strokes;
  }

  // All strokes in two directions against the truth.
  Wrong compare(const Truth& truth) {
    Wrong wrong;
    for (const Vec3 along : {Vec3(0.2, 0.3, 1), Vec3(1, -0.4, 0.1)}) {
      const std::vector<Curve3> curves = strokes(along);
      wrong.strokes += static_cast<double>(curves.size());
      const auto spans = map->classify(curves, {}, context);
      for (std::size_t c = 0; c < curves.size(); ++c) measure(curves[c], spans[c], truth, wrong);
    }
    return wrong;
  }

  void measure(const Curve3& curve, const std::vector<Span>& spans, const Truth& truth,
               Wrong& wrong) const {
    constexpr double kEvery = 0.01;  // paper mm between samples
    constexpr double kBorder = 0.1;  // model mm that two proxies, each 0.05 off, may be off
    for (const Span& s : spans) {
      if (!s.visible) continue;
      const Curve3 piece = slice(curve, s.begin, s.end);
      double run = 0;
      for (std::size_t i = 0; i < piece.segment_count(); ++i) {
        const Vec3 a = piece.points[i], b = piece.points[piece.next(i)];
        const double length = glm::distance(camera.to_paper(a), camera.to_paper(b));
        const int n = static_cast<int>(length / kEvery) + 1;
        for (int k = 0; k < n; ++k) {
          const Vec3 p = glm::mix(a, b, (k + 0.5) / n);
          const Vec3 normal = glm::normalize(
              glm::mix(piece.normals[i], piece.normals[piece.next(i)], (k + 0.5) / n));
          const bool hidden = truth.well_hidden(p, normal, camera.to_viewer(p), kBorder);
          run = hidden ? run + length / n : 0;
          wrong.shown = std::max(wrong.shown, run);
        }
      }
    }
  }

  RunContext context;
  Camera camera;
  std::vector<std::shared_ptr<const Surface>> owned;
  std::vector<const Surface*> surfaces;
  std::vector<const ProxyMesh*> proxies;
  std::unique_ptr<Occluder> occluder;
  std::vector<Curve3> features;
  std::unique_ptr<VisibilityMap> map;
};

std::shared_ptr<const Form> mesh(TriMesh m) { return std::make_shared<MeshForm>(std::move(m)); }
std::shared_ptr<const Form> parametric(std::vector<std::shared_ptr<const Chart>> charts) {
  return std::make_shared<ParametricForm>(std::move(charts));
}
std::shared_ptr<const Form> implicit_form(const Expression& f) {
  return std::make_shared<ImplicitForm>(make_function(f), std::nullopt, RunContext{}, 0,
                                        ImplicitProxyOptions{});
}

// A chart moved by a rotation of the axes and an offset.
std::shared_ptr<const Chart> moved(const std::shared_ptr<const Chart>& chart, Placement by) {
  const ParameterBox box = chart->domain();
  const Vec2 period = chart->period();
  return test::chart_of([=](Vec2 uv) { return placed(by, chart->derivatives(uv)); }, box.min,
                        box.max, period);
}

TriMesh moved(TriMesh m, Placement by) {
  for (Vec3& p : m.positions) p = by.point(p);
  return m;
}

const Mat3 kAlongX{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}};  // z becomes x

// A ball of 18 mm with a smaller one that comes out of it.
constexpr double kBig = 18, kSmall = 12;
const Vec3 kAside(9, -10, 7);

Truth balls() { return {{{Vec3(0), Vec3(0), kBig}, {kAside, Vec3(0), kSmall}}}; }

// A tube of 12 mm about z and one of 9 mm through it along x, with flat ends.
Truth tubes() {
  Truth t;
  t.shapes.push_back({Vec3(0), {0, 0, 1}, 12, [](Vec3 p) { return std::abs(p.z) < 30; }});
  t.shapes.push_back({Vec3(0), {1, 0, 0}, 9, [](Vec3 p) { return std::abs(p.x) < 30; }});
  for (const double s : {-1.0, 1.0}) {
    t.shapes.push_back({{0, 0, 30 * s}, {0, 0, 1}, 12, {}, true});
    t.shapes.push_back({{30 * s, 0, 0}, {1, 0, 0}, 9, {}, true});
  }
  return t;
}

// `most`: paper mm. The proxies of exact forms are up to 0.05 mm off each, so that surfaces which
// meet at 30 degrees may cut each other that much farther.
void expect_exact(const std::string& name, const Forms& forms, const Truth& truth, double most) {
  for (const auto& perspective : {std::optional<double>(), std::optional<double>(35)}) {
    EndScene scene(forms, {1, -1, 1}, perspective);
    const Wrong wrong = scene.compare(truth);
    const std::string where = name + (perspective ? " in perspective" : "");
    EXPECT_GT(wrong.strokes, 300) << where;
    EXPECT_LT(wrong.shown, most) << where;
  }
}

TEST(StrokeEnds, WhereBallsPassThroughEachOther) {
  const TriMesh big = test::ellipsoid(Vec3(kBig), 240, 120),
                small = moved(test::ellipsoid(Vec3(kSmall), 180, 90), {Mat3(1), kAside});
  const auto chart = [](double r, Vec3 at) {
    return moved(test::ellipsoid_chart(Vec3(r)), {Mat3(1), at});
  };
  expect_exact("two meshes", {mesh(big), mesh(small)}, balls(), 0.05);
  expect_exact("one mesh", {mesh(test::joined(big, small))}, balls(), 0.05);
  // One stroke goes in so nearly along the line of intersection that it is 0.14 mm deep at its end.
  expect_exact("two charts",
               {parametric({chart(kBig, Vec3(0))}), parametric({chart(kSmall, kAside)})}, balls(),
               0.45);
  expect_exact("one part of two charts",
               {parametric({chart(kBig, Vec3(0)), chart(kSmall, kAside)})}, balls(), 0.45);
  expect_exact("two functions",
               {implicit_form(implicit::sphere(kBig)),
                implicit_form(implicit::translate(implicit::sphere(kSmall), kAside))},
               balls(), 0.05);
}

TEST(StrokeEnds, WhereTubesPassThroughEachOther) {
  const TriMesh a = moved(test::cylinder(12, 60, 200), {Mat3(1), {0, 0, -30}}),
                b = moved(test::cylinder(9, 60, 160), {kAlongX, {-30, 0, 0}});
  expect_exact("two meshes", {mesh(a), mesh(b)}, tubes(), 0.1);
  expect_exact("one mesh", {mesh(test::joined(a, b))}, tubes(), 0.1);
  expect_exact("two functions",
               {implicit_form(implicit::cylinder(12, 60)),
                implicit_form(implicit::rotate(implicit::cylinder(9, 60), {0, 90, 0}))},
               tubes(), 0.12);  // up to 0.05 mm off each
}

// A closed tube about a curve that comes near itself: one surface that passes through itself.
TEST(StrokeEnds, WhereASurfacePassesThroughItself) {
  constexpr double kTube = 5;
  const auto centre = [](double s) {
    return Vec3(24 * std::sin(s), 14 * std::sin(2 * s), 3 * std::cos(s));
  };
  const TriMesh tube = test::grid(400, 64, true, true, [&](std::uint32_t i, std::uint32_t j) {
    const double s = 2 * test::kPi * i / 400, a = -2 * test::kPi * j / 64;
    const Vec3 t = glm::normalize(centre(s + 1e-4) - centre(s - 1e-4));
    const Vec3 x = glm::normalize(glm::cross(t, Vec3(0, 0, 1))), y = glm::cross(t, x);
    return centre(s) + kTube * (std::cos(a) * x + std::sin(a) * y);
  });
  EndScene scene({mesh(tube)}, {1, -1, 1});
  std::vector<Vec3> middle;
  for (int m = 0; m < 400; ++m) middle.push_back(centre(2 * test::kPi * m / 400));
  double worst = 0;
  for (const Vec3 along : {Vec3(0.2, 0.3, 1), Vec3(1, -0.4, 0.1)}) {
    const std::vector<Curve3> curves = scene.strokes(along);
    const auto spans = scene.map->classify(curves, {}, scene.context);
    for (std::size_t c = 0; c < curves.size(); ++c) {
      for (const Span& s : spans[c]) {
        if (!s.visible) continue;
        const Curve3 piece = slice(curves[c], s.begin, s.end);
        double run = 0;
        for (std::size_t i = 0; i < piece.segment_count(); ++i) {
          const Vec3 a = piece.points[i], b = piece.points[piece.next(i)];
          for (int k = 0; k < 4; ++k) {
            const Vec3 p = glm::mix(a, b, (k + 0.5) / 4);
            double nearest = 1e300;
            for (int m = 0; m < 400; ++m) {
              nearest = std::min(nearest, glm::distance(p, middle[static_cast<std::size_t>(m)]));
            }
            const double step =
                glm::distance(scene.camera.to_paper(a), scene.camera.to_paper(b)) / 4;
            run = nearest < kTube - 0.05 ? run + step : 0;
            worst = std::max(worst, run);
          }
        }
      }
    }
  }
  // What is left is where both sheets meet at a small angle.
  EXPECT_LT(worst, 0.8) << "inside the tube, whose facets lie within 0.01 mm";
}

// Tubes without ends: their far inside goes behind the near rim, and the outside ends at it.
TEST(StrokeEnds, BehindOpenRims) {
  Truth open;
  open.shapes.push_back({Vec3(0), {0, 0, 1}, 12, [](Vec3 p) { return std::abs(p.z) < 30; }});
  const TriMesh tube = test::grid(200, 61, true, false, [](std::uint32_t i, std::uint32_t j) {
    const double u = 2 * test::kPi * i / 200;
    return Vec3(12 * std::cos(u), 12 * std::sin(u), -30.0 + j);
  });
  const auto chart = moved(test::cylinder_chart(12, 60, 2 * test::kPi), {Mat3(1), {0, 0, -30}});
  for (const double up : {1.0, 0.5, 0.25, 0.1, 0.05}) {
    for (const bool exact : {false, true}) {
      EndScene scene({exact ? parametric({chart}) : mesh(tube)}, {1, -1, up});
      const Wrong wrong = scene.compare(open);
      // The chart's rim, seen as a strip narrower than a mm: both its facets' errors deep.
      const double most = exact && up < 0.2 ? 0.5 : 0.1;
      EXPECT_LT(wrong.shown, most) << (exact ? "chart" : "mesh") << " from " << up;
    }
  }
}

}  // namespace
}  // namespace burin
