/// Meshes of two parts that lie on each other: one of them is seen.
#include <burin/drawing/areas_at.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/illustrate/illustrate.h>

#include "burin_test/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>

namespace burin {
namespace {

constexpr double kPi = std::numbers::pi;

struct Pair {
  Scene scene;
  Camera camera;
  Drawing drawing;

  Pair(TriMesh first, TriMesh second, Vec3 direction)
      : scene(scene_of(std::move(first), std::move(second))),
        camera(Camera::fit([&](const Mat3& axes) { return scene.bounds(axes); },
                           {.direction = direction, .scale = 4, .paper = {200, 200}})) {
    Style style = builtin_style("outline");
    style.fill.color = "part";
    style.shadow.cast = true;
    RunContext context;
    drawing = illustrate(scene, camera, style, {}, context);
  }

  static Scene scene_of(TriMesh first, TriMesh second) {
    Scene scene;
    scene.parts.push_back({"first", "", std::make_shared<MeshForm>(std::move(first))});
    scene.parts.push_back({"second", "", std::make_shared<MeshForm>(std::move(second))});
    return scene;
  }

  /// What is seen at a place of the model, away from borders; -1: nothing.
  std::int32_t part_at(const AreasAt& areas, Vec3 place) const {
    const Vec2 at = camera.to_paper(place);
    const auto found = areas.at(at);
    return found.empty() || areas.beside_border(at) ? -1 : drawing.areas[found.back()].part;
  }
};

/// How many places of the side of a cylinder show the wrong part.
std::size_t wrong_on_side(const Pair& pair, double radius,
                          const std::function<std::int32_t(double up)>& right, double top) {
  const AreasAt areas(pair.drawing.areas, 0.05);
  std::size_t wrong = 0, looked = 0;
  for (double angle = 0; angle < 2 * kPi; angle += 0.02) {
    const Vec3 normal(std::cos(angle), std::sin(angle), 0);
    if (glm::dot(normal, pair.camera.direction()) < 0.25) continue;
    for (double up = 0.3; up < top; up += 0.37) {
      const std::int32_t part = pair.part_at(areas, radius * normal + Vec3(0, 0, up));
      if (part < 0) continue;
      ++looked;
      wrong += part != right(up) ? 1 : 0;
    }
  }
  EXPECT_GT(looked, 1000u);
  return wrong;
}

TriMesh tube(double radius, double from, double to, std::uint32_t n, double turn) {
  return test::mapped(test::cylinder(radius, to - from, n), [&](Vec3 p) {
    const double c = std::cos(turn), s = std::sin(turn);
    return Vec3(c * p.x - s * p.y, s * p.x + c * p.y, p.z + from);
  });
}

TEST(FlushMeshes, RoundOnesHaveTheFirstColourWhateverFacetsTheyHave) {
  for (const std::uint32_t facets : {24u, 40u, 96u}) {
    for (const Vec3 direction : {Vec3(1, 0.3, 0.4), Vec3(0.2, -1, 0.1)}) {
      const Pair pair(tube(5, 0, 10, 40, 0), tube(5, 5, 15, facets, kPi / 40), direction);
      const auto right = [](double up) { return up < 10 ? 0 : 1; };
      EXPECT_EQ(wrong_on_side(pair, 5, right, 15), 0u) << facets;
    }
  }
}

/// Nearer than facets are off, and yet before it: a coat of paint on a rod.
TEST(FlushMeshes, AThinSleeveHidesTheRodInIt) {
  for (const double thick : {0.02, 0.05}) {
    const Pair pair(tube(5, 0, 10, 40, 0), tube(5 + thick, 5, 15, 40, kPi / 40), Vec3(1, 0.3, 0.4));
    const auto right = [](double up) { return up < 5 ? 0 : 1; };
    EXPECT_EQ(wrong_on_side(pair, 5, right, 15), 0u) << thick;
  }
}

/// Slanted faces whose corners files have rounded.
TEST(FlushMeshes, PlaneOnesHaveTheColourOfTheSmaller) {
  const auto slanted = [](Vec3 p) {
    const Vec3 turned(0.8 * p.x + 0.6 * p.z, p.y, 0.8 * p.z - 0.6 * p.x);
    const auto stored = [](double x) { return static_cast<double>(static_cast<float>(x)); };
    return Vec3(stored(turned.x + 0.1), stored(turned.y + 0.1), stored(turned.z + 0.1));
  };
  const TriMesh plate = test::mapped(test::box({0, 0, 0}, {20, 20, 3}), slanted);
  const TriMesh inlay = test::mapped(test::box({5.1, 5.1, 0}, {14.9, 14.9, 3}), slanted);
  for (const bool turned : {false, true}) {
    const Pair pair(turned ? inlay : plate, turned ? plate : inlay, Vec3(0.3, -0.2, 1));
    const AreasAt areas(pair.drawing.areas, 0.05);
    std::size_t looked = 0, wrong = 0;
    for (double x = 5.3; x < 14.8; x += 0.31) {
      for (double y = 5.3; y < 14.8; y += 0.29) {
        const std::int32_t part = pair.part_at(areas, slanted({x, y, 3}));
        if (part < 0) continue;
        ++looked;
        wrong += part != (turned ? 0 : 1) ? 1 : 0;
      }
    }
    EXPECT_EQ(wrong, 0u) << turned << " of " << looked;
    EXPECT_GT(looked, 500u);
  }
}

}  // namespace
}  // namespace burin
