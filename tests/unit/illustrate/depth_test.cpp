// Haloes and depth cues, drawn of all forms.
#include <burin/drawing/writers.h>
#include <burin/forms/charted/nurbs.h>
#include <burin/forms/implicit/expression.h>
#include <burin/forms/implicit/implicit_form.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/forms/patches/parametric_form.h>
#include <burin/illustrate/illustrate.h>

#include <burin_test/nurbs_shapes.h>
#include <burin_test/shapes.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <memory>
#include <sstream>

namespace burin {
namespace {

Scene scene_of_forms(std::vector<std::shared_ptr<const Form>> forms) {
  Scene scene;
  for (auto& f : forms) scene.parts.push_back({"part", "part", std::move(f)});
  return scene;
}

std::shared_ptr<const Form> box(Vec3 low, Vec3 high) {
  return std::make_shared<MeshForm>(test::box(low, high));
}

Camera camera_along(const Scene& scene, Vec3 direction, std::optional<double> perspective = {}) {
  return Camera::fit([&](const Mat3& axes) { return scene.bounds(axes); },
                     {.direction = direction, .perspective = perspective, .paper = {100, 80}});
}

Drawing draw_depth(const Scene& scene, const Camera& camera, const Style& style,
                   HiddenLines hidden = HiddenLines::None) {
  RunContext context;
  return illustrate(scene, camera, style, {.hidden = hidden}, context);
}

double drawn_length(const Path& path) {
  double sum = 0;
  const std::size_t n = path.points.size();
  for (std::size_t i = 0; i + (path.closed ? 0 : 1) < n; ++i) {
    sum += glm::length(path.points[(i + 1) % n] - path.points[i]);
  }
  return sum;
}

// Length of the lines of a part, on paper.
double drawn_length(const Drawing& drawing, int part) {
  double sum = 0;
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) sum += path.source.part == part ? drawn_length(path) : 0;
  }
  return sum;
}

TEST(Haloes, ABarBehindAPostEndsTheGapBeforeIt) {
  // Seen from the front: a bar of 100 x 10 mm, 40 mm behind a post of 10 x 100 mm.
  const Scene scene =
      scene_of_forms({box({-50, 40, -5}, {50, 41, 5}), box({-5, 0, -50}, {5, 1, 50})});
  const Camera camera = camera_along(scene, {0, -1, 0});
  Style style = builtin_style("outline");
  style.line.outer = 0.4;
  const double edge = 10 * camera.scale();
  const double before = drawn_length(draw_depth(scene, camera, style), 0);
  EXPECT_NEAR(before, 2 * (100 + 10) * camera.scale() - 2 * edge, 1e-6);
  for (const double gap : {0.3, 0.8}) {
    style.halo.gap = gap;
    const Drawing d = draw_depth(scene, camera, style);
    // Four ends, each clear of the ink by the gap: half the post's width and the bar's round cap.
    EXPECT_NEAR(drawn_length(d, 0), before - 4 * (gap + 0.2 + 0.2), 1e-6);
    EXPECT_NEAR(drawn_length(d, 1), 2 * (100 + 10) * camera.scale(), 1e-6);
  }
}

TEST(Haloes, WhatTouchesIsNotSetApart) {
  // Edges that meet at corners, lines on a face, a box that stands on another: the same drawing.
  const Scene scene =
      scene_of_forms({box({-20, -20, 0}, {20, 20, 10}), box({-5, -5, 10}, {5, 5, 12})});
  const Camera camera = camera_along(scene, {1, -1.2, 3});
  Style style = builtin_style("outline");
  const double before = drawn_length(draw_depth(scene, camera, style), 0);
  style.halo.gap = 0.5;
  EXPECT_NEAR(drawn_length(draw_depth(scene, camera, style), 0), before, 2 * 0.9)
      << "only where the small box stands before the edge of its foot";
  const Scene sphere = scene_of_forms({std::make_shared<ParametricForm>(
      std::vector<std::shared_ptr<const Chart>>{make_nurbs_chart(test::sphere_nurbs(20))})});
  const Camera eye = camera_along(sphere, {1, -1, 1});
  Style engraving = builtin_style("engraving");
  const double strokes = drawn_length(draw_depth(sphere, eye, engraving), 0);
  engraving.halo.gap = 0.5;
  EXPECT_NEAR(drawn_length(draw_depth(sphere, eye, engraving), 0), strokes, 1e-3 * strokes)
      << "strokes run into the contour of their own sheet";
}

// A torus and, behind it, a larger one, in every form.
std::vector<std::pair<const char*, Scene>> tori() {
  const auto moved = [](const TriMesh& m) {
    return std::make_shared<MeshForm>(test::mapped(m, [](Vec3 p) { return p + Vec3(0, 0, -30); }));
  };
  const auto chart = [](double r, double z) {
    NurbsData n = test::torus_nurbs(r, 4);
    for (Vec3& p : n.points) p.z += z;
    return std::make_shared<ParametricForm>(
        std::vector<std::shared_ptr<const Chart>>{make_nurbs_chart(n)});
  };
  const auto implicit = [](double r, double z) {
    return std::make_shared<ImplicitForm>(
        make_function(implicit::translate(implicit::torus(r, 4), {0, 0, z})), std::nullopt,
        RunContext{});
  };
  return {{"mesh", scene_of_forms({std::make_shared<MeshForm>(test::torus(16, 4, 160, 80)),
                                   moved(test::torus(26, 4, 240, 80))})},
          {"nurbs", scene_of_forms({chart(16, 0), chart(26, -30)})},
          {"implicit", scene_of_forms({implicit(16, 0), implicit(26, -30)})}};
}

TEST(Haloes, NoInkStandsWithinTheGapOfANearerContourInAnyForm) {
  for (const auto& [name, scene] : tori()) {
    const Camera camera = camera_along(scene, {0.5, -0.4, 1});
    Style style = builtin_style("engraving");
    style.halo.gap = 0.6;
    const Drawing d = draw_depth(scene, camera, style);
    std::vector<const Path*> near;
    for (const Layer& layer : d.layers) {
      for (const Path& p : layer.paths) {
        if (p.source.part == 0 && p.kind == LineClass::Contour) near.push_back(&p);
      }
    }
    ASSERT_FALSE(near.empty()) << name;
    int ends = 0, inside = 0, at_edge = 0;
    for (const Layer& layer : d.layers) {
      for (const Path& p : layer.paths) {
        if (p.source.part != 1) continue;
        for (const Vec2& q : p.points) {
          double distance = 1e9;
          for (const Path* c : near) {
            const std::size_t n = c->points.size();
            for (std::size_t i = 0; i + (c->closed ? 0 : 1) < n; ++i) {
              const Vec2 a = c->points[i], e = c->points[(i + 1) % n] - a;
              const double t = std::clamp(glm::dot(q - a, e) / glm::dot(e, e), 0.0, 1.0);
              distance = std::min(distance, glm::length(q - a - t * e) - 0.5 * c->width.front());
            }
          }
          ++ends;
          if (distance < 0.6 - 0.03) ++inside;  // lines are simplified by 0.005 mm
          if (std::abs(distance - 0.6) < 0.03) ++at_edge;
        }
      }
    }
    EXPECT_GT(ends, 1000) << name;
    // Where the farther sheet is steep and only just behind, it cannot be told from the nearer one.
    EXPECT_LE(inside, ends / 1000) << name;
    EXPECT_GT(at_edge, 20) << name;
  }
}

TEST(Haloes, HiddenLinesInFullAreInterruptedByNearerOnes) {
  const Scene scene = scene_of_forms({box({0, 0, 0}, {10, 10, 10})});
  const Camera camera = camera_along(scene, {1, -1.4, 0.7});
  Style style = builtin_style("wireframe");
  style.depth.near = style.depth.far = 1;
  style.halo.gap = 0;
  const double edges = drawn_length(draw_depth(scene, camera, style), 0);
  double all = 0;
  for (const Vec3 e : {Vec3(10, 0, 0), Vec3(0, 10, 0), Vec3(0, 0, 10)}) {
    all += 4 * glm::length(camera.to_paper(e) - camera.to_paper(Vec3(0)));
  }
  EXPECT_NEAR(edges, all, 1e-6) << "nothing is removed";
  style.halo.gap = 0.7;
  const Drawing d = draw_depth(scene, camera, style);
  std::map<std::string, int> layers;
  for (const Layer& layer : d.layers) layers[layer.name] = static_cast<int>(layer.paths.size());
  EXPECT_EQ(layers.count("hidden"), 0u);
  // Each of the two crossings of this view cuts one hidden edge in two.
  EXPECT_EQ(layers["behind"], 5);
  EXPECT_LT(drawn_length(d, 0), all - 2 * 1.4);
  std::ostringstream svg;
  RunContext context;
  write_svg(d, {}, svg, context);
  EXPECT_EQ(svg.str().find("stroke-dasharray"), std::string::npos);
}

TEST(DepthCues, WidthsAreLinearInDepth) {
  constexpr double kTolerance = 0.01;  // coarse facets are rounded by it
  const Scene scene = scene_of_forms(
      {std::make_shared<MeshForm>(test::torus(20, 8, 64, 32)), box({-30, -4, -60}, {30, 4, -40})});
  for (const auto& perspective : {std::optional<double>(), std::optional<double>(35)}) {
    const Camera camera = camera_along(scene, {1, -1, 1.5}, perspective);
    double front = -1e9, back = 1e9;
    for (const Part& part : scene.parts) {
      RunContext context;
      const auto s = part.form->realise({.tolerance = kTolerance}, context);
      for (const Vec3& p : s->proxy().mesh.positions) {
        front = std::max(front, camera.depth(p));
        back = std::min(back, camera.depth(p));
      }
    }
    Style style = builtin_style("outline");
    style.line.outer = style.line.contour = style.line.crease = style.line.intersection = 0.4;
    style.depth.near = 1.5;
    style.depth.far = 0.25;
    int points = 0;
    RunContext context;
    const Drawing drawing = illustrate(scene, camera, style, {.tolerance = kTolerance}, context);
    for (const Layer& layer : drawing.layers) {
      for (const Path& p : layer.paths) {
        ASSERT_EQ(p.width.size(), p.points.size());
        for (std::size_t i = 0; i < p.points.size(); ++i, ++points) {
          const double t = (front - camera.depth(p.points3[i])) / (front - back);
          EXPECT_NEAR(p.width[i], 0.4 * (1.5 + t * (0.25 - 1.5)), 1e-9);
        }
      }
    }
    EXPECT_GT(points, 100);
  }
}

TEST(DepthCues, StrokesKeepTheirFactorAndPale) {
  const Scene scene = scene_of_forms({std::make_shared<MeshForm>(test::torus(20, 8, 64, 32))});
  const Camera camera = camera_along(scene, {1, -1, 1});
  Style style = builtin_style("engraving");
  const Drawing plain = draw_depth(scene, camera, style);
  style.depth.near = style.depth.far = 0.5;
  const Drawing thin = draw_depth(scene, camera, style);
  const auto ink = [](const Drawing& d, const char* layer) {
    double sum = 0;
    for (const Layer& l : d.layers) {
      if (l.name != layer) continue;
      for (const Path& p : l.paths) {
        for (std::size_t i = 1; i < p.points.size(); ++i) {
          sum += 0.5 * (p.width[i] + p.width[i - 1]) * glm::length(p.points[i] - p.points[i - 1]);
        }
      }
    }
    return sum;
  };
  EXPECT_NEAR(ink(thin, "stroke-1") / ink(plain, "stroke-1"), 0.5, 1e-3);
  style.depth.near = style.depth.far = 1;
  style.depth.ink = 0.2;
  const double pale = ink(draw_depth(scene, camera, style), "stroke-1");
  EXPECT_LT(pale, 0.85 * ink(plain, "stroke-1"));
  EXPECT_GT(pale, 0.3 * ink(plain, "stroke-1"));
}

TEST(Isophotes, StrokesKeepTheirAngleInEveryForm) {
  for (const auto& [name, scene] : tori()) {
    const Camera camera = camera_along(scene, {0.5, -0.4, 1});
    Style style = builtin_style("engraving");
    style.hatch.field.name = "isophote";
    style.hatch.cross_from = 2;
    const Drawing d = draw_depth(scene, camera, style);
    const double radius[2] = {16, 26}, z[2] = {0, -30};
    double worst = 0, sum = 0, count = 0;
    for (const Layer& layer : d.layers) {
      for (const Path& p : layer.paths) {
        if (p.kind != LineClass::Stroke) continue;
        EXPECT_EQ(p.field, "isophote");
        double low = 2, high = -2;
        for (const Vec3& q : p.points3) {
          const int k = p.source.part;
          const Vec3 c(q.x, q.y, q.z - z[k]);
          const Vec3 spine = radius[k] * glm::normalize(Vec3(c.x, c.y, 0));
          const double f = glm::dot(glm::normalize(c - spine), camera.direction());
          low = std::min(low, f);
          high = std::max(high, f);
        }
        worst = std::max(worst, high - low);
        sum += high - low;
        ++count;
      }
    }
    ASSERT_GT(count, 40) << name;
    RecordProperty(std::string(name) + "_mean", std::to_string(sum / count));
    RecordProperty(std::string(name) + "_worst", std::to_string(worst));
    const bool is_mesh = std::string(name) == "mesh";
    EXPECT_LT(sum / count, is_mesh ? 2e-3 : 1e-3) << name;
    EXPECT_LT(worst, 5e-3) << name;
  }
}

}  // namespace
}  // namespace burin
