// Functions and volumes draw the same wherever they are, however large, and however they are turned
// together with the view.
#include <burin/forms/implicit/expression.h>
#include <burin/forms/implicit/implicit_form.h>
#include <burin/forms/implicit/volume_function.h>
#include <burin/illustrate/illustrate.h>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace burin {
namespace {

struct Place {
  const char* name;
  double scale;
  Vec3 move;
  bool turned;
};

// 1e5 away a part of 0.04 mm has doubles of 1e-11 mm: of it that shows.
const std::vector<Place> kPlaces = {{"small", 1e-3, Vec3(0), false},
                                    {"large", 1e3, Vec3(0), false},
                                    {"far", 1, {1e5, -2e4, 7e4}, false},
                                    {"turned", 1, Vec3(0), true},
                                    {"all", 1e-2, {300, -200, 100}, true}};

// Degrees about x, then y, then z, as `implicit::rotate` takes them.
const Vec3 kTurn(25, -40, 70);

Mat3 turn_of(const Place& place) {
  glm::dmat4 m(1);
  if (place.turned) {
    m = glm::rotate(m, glm::radians(kTurn.z), Vec3(0, 0, 1));
    m = glm::rotate(m, glm::radians(kTurn.y), Vec3(0, 1, 0));
    m = glm::rotate(m, glm::radians(kTurn.x), Vec3(1, 0, 0));
  }
  return Mat3(m);
}

// A ring with a bore across it, 40 mm wide: creases and contours.
std::shared_ptr<const ImplicitFunction> formula(const Place& place) {
  using namespace implicit;
  const Expression ring = subtract(torus(14, 6), rotate(cylinder(3, 60), {90, 0, 0}));
  Expression e = scale(ring, place.scale);
  if (place.turned) e = rotate(e, kTurn);
  return make_function(translate(e, place.move));
}

// Samples of the distance to a ring; smooth.
std::shared_ptr<const ImplicitFunction> volume(const Place& place) {
  constexpr std::int32_t kSide = 24;
  VolumeGrid grid;
  grid.size = {kSide, kSide, kSide};
  const Mat3 to_model = turn_of(place) * (2 * place.scale);
  const Vec3 middle(0.5 * (kSide - 1));
  grid.origin = place.move - to_model * middle;
  grid.steps = to_model;
  for (std::int32_t k = 0; k < kSide; ++k) {
    for (std::int32_t j = 0; j < kSide; ++j) {
      for (std::int32_t i = 0; i < kSide; ++i) {
        const Vec3 p = Vec3(i, j, k) - middle;
        const double r = std::hypot(std::hypot(p.x, p.y) - 6, p.z);
        grid.samples.push_back(static_cast<float>(10 - r));
      }
    }
  }
  RunContext context;
  return make_volume_function(std::move(grid), {.level = 7}, context);
}

Drawing draw_placed(std::shared_ptr<const ImplicitFunction> function, const Place& place,
                    const char* style) {
  RunContext context;
  Scene scene;
  scene.parts.push_back(
      {"part", "part", std::make_shared<ImplicitForm>(std::move(function), std::nullopt, context)});
  const Mat3 turn = turn_of(place);
  ViewOptions view;
  view.direction = turn * Vec3(1, -2, 1.5);
  view.up = turn * Vec3(0, 0, 1);
  view.paper = {100, 80};
  view.scale = 1.5 / place.scale;
  view.center = place.move;
  const Camera camera = Camera::fit([&](const Mat3& axes) { return scene.bounds(axes); }, view);
  return illustrate(scene, camera, builtin_style(style), {}, context);
}

struct PlacedInk {
  double features = 0, strokes = 0;  // mm of paper
  std::vector<Vec2> points;          // of features
};

PlacedInk placed_ink(const Drawing& drawing) {
  PlacedInk ink;
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      const bool stroke = path.kind == LineClass::Stroke;
      const std::size_t n = path.points.size();
      for (std::size_t i = 0; i + (path.closed ? 0 : 1) < n; ++i) {
        const Vec2 a = path.points[i], b = path.points[(i + 1) % n];
        (stroke ? ink.strokes : ink.features) += glm::distance(a, b);
        for (double t = 0; !stroke && t < 1; t += 0.05) ink.points.push_back(glm::mix(a, b, t));
      }
    }
  }
  return ink;
}

// Largest distance of a point of `a` from the points of `b`, but for a fiftieth of them: where two
// lines nearly touch one of them may end a little sooner.
double gap(const PlacedInk& a, const PlacedInk& b) {
  std::vector<double> gaps;
  for (std::size_t i = 0; i < a.points.size(); i += 7) {
    double least = 1e9;
    for (const Vec2& q : b.points) least = std::min(least, glm::distance(a.points[i], q));
    gaps.push_back(least);
  }
  std::ranges::sort(gaps);
  return gaps[gaps.size() * 49 / 50];
}

template <class Make>
void draws_the_same(Make&& make) {
  const Place home{"home", 1, Vec3(0), false};
  const PlacedInk at_home = placed_ink(draw_placed(make(home), home, "technical"));
  ASSERT_GT(at_home.features, 150);
  ASSERT_GT(at_home.strokes, 300);
  for (const Place& place : kPlaces) {
    SCOPED_TRACE(place.name);
    const PlacedInk there = placed_ink(draw_placed(make(place), place, "technical"));
    EXPECT_NEAR(there.features, at_home.features, 0.01 * at_home.features);
    // Which half of the lines fades out in the light is chance.
    EXPECT_NEAR(there.strokes, at_home.strokes, 0.06 * at_home.strokes);
    EXPECT_LT(gap(there, at_home), 0.1);
    EXPECT_LT(gap(at_home, there), 0.1);
  }
}

TEST(Placement, FormulasDrawTheSameMovedScaledAndTurned) { draws_the_same(formula); }
TEST(Placement, VolumesDrawTheSameMovedScaledAndTurned) { draws_the_same(volume); }

}  // namespace
}  // namespace burin
