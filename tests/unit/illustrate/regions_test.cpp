/// Areas of parts, faces and steps of tone against their formulas.

#include <burin/base/parallel.h>
#include <burin/drawing/areas_at.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/forms/patches/parametric_form.h>
#include <burin/illustrate/illustrate.h>
#include <burin/section/section.h>

#include "burin_test/charts.h"
#include "burin_test/ring_size.h"
#include "burin_test/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace burin {
namespace {

constexpr double kPi = std::numbers::pi;

struct Shown {
  Scene scene;
  Vec3 direction{0, -1, 0}, up{0, 0, 1};
  Style style = builtin_style("outline");
  IllustrateOptions options{};

  void add(std::shared_ptr<const Form> form) {
    const std::string name = "part" + std::to_string(scene.parts.size());
    scene.parts.push_back({name, name, std::move(form)});
  }
  void add(TriMesh mesh) { add(std::make_shared<MeshForm>(std::move(mesh))); }
  /// `steps` of one colour on every part.
  void fill(int steps) {
    style.fill.color = "part";
    style.fill.steps = steps;
  }
  Camera camera() const {
    return Camera::fit([&](const Mat3& axes) { return scene.bounds(axes); },
                       {.direction = direction, .up = up, .scale = 2, .paper = {200, 150}});
  }
  Drawing draw() const {
    RunContext context;
    return illustrate(scene, camera(), style, options, context);
  }
};

/// mm^2 of the model's size; rings within rings are holes.
double size_of(const Area& area) { return test::signed_area(area) / 4; }

TriMesh moved(TriMesh mesh, Vec3 by) {
  for (Vec3& p : mesh.positions) p += by;
  return mesh;
}

TEST(Regions, OfABoxAreItsThreeFaces) {
  Shown s;
  s.add(test::box(Vec3(0), {20, 30, 10}));
  s.direction = {1, -1, 1};
  s.options.face_areas = true;
  const Drawing d = s.draw();
  ASSERT_EQ(d.areas.size(), 3u);
  std::vector<double> sizes;
  std::set<std::int32_t> faces;
  for (const Area& area : d.areas) {
    EXPECT_EQ(area.part, 0);
    EXPECT_EQ(area.tone, -1);
    EXPECT_EQ(area.rings.size(), 1u);
    EXPECT_EQ(area.rings[0].size(), 4u);
    faces.insert(area.face);
    sizes.push_back(size_of(area) * std::sqrt(3.0));
  }
  EXPECT_EQ(faces.size(), 3u);
  std::ranges::sort(sizes);
  EXPECT_NEAR(sizes[0], 200, 1e-6);
  EXPECT_NEAR(sizes[1], 300, 1e-6);
  EXPECT_NEAR(sizes[2], 600, 1e-6);
}

TEST(Regions, AreThoseOfFacesWhereTheStyleOfAPartSaysSo) {
  Shown s;
  s.add(test::box(Vec3(0), {20, 30, 10}));
  s.add(moved(test::box(Vec3(0), {20, 30, 10}), {40, 0, 0}));
  s.direction = {1, -1, 1};
  s.style.fill.steps = 2;
  Style by_face = s.style;
  by_face.fill.faces = true;
  s.options.part_styles.resize(2);
  s.options.part_styles[1].style = by_face;
  std::set<std::int32_t> faces;
  std::map<std::int32_t, double> size;
  const Drawing d = s.draw();
  for (const Area& area : d.areas) {
    EXPECT_EQ(area.part == 0, area.face < 0);
    // The lightest area of a part or face comes first and holds the darker ones.
    const bool first = area.face < 0 ? size.count(0) == 0 : faces.insert(area.face).second;
    if (first) size[area.part] += size_of(area);
  }
  EXPECT_EQ(faces.size(), 3u) << "the seen ones";
  EXPECT_NEAR(size[0], size[1], 0.01);
  by_face.fill.color = "none";
  s.style.fill.color = "none";
  s.options.part_styles[1].style = by_face;
  s.options.verify = true;
  const Drawing bare = s.draw();
  EXPECT_EQ(std::ranges::count_if(bare.areas, [](const Area& a) { return a.face >= 0; }), 3);
  EXPECT_TRUE(std::ranges::all_of(bare.areas, [](const Area& a) { return a.fill.empty(); }));
  EXPECT_EQ(bare.stats.verify->wrong_patches, 0);
}

TEST(Regions, OfABallAreTheRingsOfItsTones) {
  Shown s;
  constexpr double kRadius = 25;
  s.add(test::ellipsoid(Vec3(kRadius), 160, 80));
  s.style.tone.light = {0, 0, 1};
  for (const int steps : {2, 3, 5}) {
    s.fill(steps);
    for (const double opacity : {1.0, 0.5}) {
      s.style.fill.opacity = opacity;
      const Drawing d = s.draw();
      ASSERT_EQ(d.areas.size(), static_cast<std::size_t>(steps));
      for (int i = 0; i < steps; ++i) {
        const Area& area = d.areas[static_cast<std::size_t>(i)];
        EXPECT_EQ(area.tone, steps - 1 - i) << "the darkest last";
        // The disc less the cap that is lit more; painted flat less what is darker, too.
        const auto outside = [&](int step) {
          return kPi * kRadius * kRadius * std::pow(static_cast<double>(step) / steps, 2);
        };
        const double exact = outside(area.tone + 1) - (opacity < 1 ? outside(area.tone) : 0);
        EXPECT_NEAR(size_of(area), exact, 1e-3 * exact) << steps << ' ' << area.tone;
      }
    }
  }
}

TEST(Regions, OfATorusHaveItsHole) {
  Shown s;
  s.add(test::torus(20, 6, 200, 100));
  s.direction = {0, 0, 1}, s.up = {0, 1, 0};
  s.fill(0);
  const Drawing d = s.draw();
  ASSERT_EQ(d.areas.size(), 1u);
  EXPECT_EQ(d.areas[0].rings.size(), 2u);
  const double exact = 4 * kPi * 20 * 6;
  EXPECT_NEAR(size_of(d.areas[0]), exact, 1e-3 * exact);
}

TEST(Regions, OfFlushBoxesEndWhereTheyMeet) {
  Shown s;
  s.add(test::box({0, 0, 0}, {20, 10, 30}));
  s.add(test::box({20, 0, 0}, {50, 10, 30}));
  // Its front lies in those of both, which are larger.
  s.add(test::box({10, 0, 10}, {40, 5, 20}));
  s.fill(0);
  const Drawing d = s.draw();
  ASSERT_EQ(d.areas.size(), 3u);
  EXPECT_NEAR(size_of(d.areas[0]), 500, 1e-6);
  EXPECT_NEAR(size_of(d.areas[1]), 700, 1e-6);
  EXPECT_NEAR(size_of(d.areas[2]), 300, 1e-6);
}

TEST(Regions, OfASlottedPartLeaveTheSlotOpen) {
  Shown s;
  s.add(test::slotted());
  s.fill(3);
  const Drawing d = s.draw();
  ASSERT_EQ(d.areas.size(), 1u);
  EXPECT_NEAR(size_of(d.areas[0]), 480, 1e-6);
}

TEST(Regions, OfCutsAreAreasOfTheirPart) {
  Shown s;
  constexpr double kRadius = 25;
  s.add(cut_form(std::make_shared<MeshForm>(test::ellipsoid(Vec3(kRadius), 160, 80)),
                 CutPlane{{0, -1, 0}, 15}, 0, "ball"));
  s.fill(2);
  s.style.tone.light = {0, 0, -1};  // from behind
  const Drawing d = s.draw();
  ASSERT_EQ(d.areas.size(), 2u);
  const double face = kPi * (kRadius * kRadius - 15 * 15);
  double all = 0;
  for (const Area& area : d.areas) {
    EXPECT_EQ(area.part, 0);
    all += size_of(area);
    if (area.face >= 0) {
      EXPECT_NEAR(size_of(area), face, 1e-3 * face);
      EXPECT_EQ(area.tone, 1) << "hatching is read on it";
    }
  }
  EXPECT_NEAR(all, kPi * kRadius * kRadius, 2);
  EXPECT_NE(d.areas[0].face >= 0, d.areas[1].face >= 0);
}

TEST(Regions, AreMadeWhereTheyAreAskedFor) {
  Shown s;
  s.add(test::ellipsoid(Vec3(10), 60, 30));
  s.add(moved(test::torus(10, 3, 80, 40), {5, -8, 4}));
  const Drawing without = s.draw();
  EXPECT_TRUE(without.areas.empty());
  s.fill(4);
  const Drawing with = s.draw();
  EXPECT_EQ(with.areas.size(), 8u);
  ASSERT_EQ(with.layers.size(), without.layers.size()) << "lines are the same";
  for (std::size_t i = 0; i < with.layers.size(); ++i) {
    ASSERT_EQ(with.layers[i].paths.size(), without.layers[i].paths.size());
    for (std::size_t k = 0; k < with.layers[i].paths.size(); ++k) {
      EXPECT_EQ(with.layers[i].paths[k].points, without.layers[i].paths[k].points);
    }
  }
}

TEST(Regions, AreTheSameForAnyNumberOfThreads) {
  Shown s;
  s.add(test::ellipsoid(Vec3(10), 60, 30));
  s.add(moved(test::torus(10, 3, 80, 40), {5, -8, 4}));
  s.fill(5);
  const Drawing many = s.draw();
  const ThreadLimit one(1);
  const Drawing alone = s.draw();
  ASSERT_EQ(many.areas.size(), alone.areas.size());
  for (std::size_t i = 0; i < many.areas.size(); ++i) {
    EXPECT_EQ(many.areas[i].rings, alone.areas[i].rings);
  }
}

std::size_t isophotes(const Drawing& d) {
  std::size_t count = 0;
  for (const Layer& layer : d.layers) {
    for (const Path& path : layer.paths) {
      if (path.kind != LineClass::Isophote) continue;
      EXPECT_EQ(layer.name, "isophote");
      EXPECT_TRUE(path.visible);
      ++count;
    }
  }
  return count;
}

TEST(Regions, IsophotesAreDrawnWhereTheStyleWantsThem) {
  Shown s;
  s.add(test::ellipsoid(Vec3(20), 60, 30));
  EXPECT_EQ(isophotes(s.draw()), 0u);
  s.style.tone.light = {0, 0, 1};
  s.style.feature.isophotes = 3;
  const Drawing d = s.draw();
  EXPECT_EQ(isophotes(d), 3u);
  for (const Layer& layer : d.layers) {
    for (const Path& path : layer.paths) {
      if (path.kind != LineClass::Isophote) continue;
      EXPECT_TRUE(path.closed);
      const Vec2 middle(100, 75);
      const double r = glm::distance(path.points[0], middle) / 40;
      double off = 1;
      for (int i = 1; i <= 3; ++i) off = std::min(off, std::abs(std::sqrt(1 - i * i / 16.0) - r));
      EXPECT_LT(off, 1e-3);
    }
  }
}

// Each vertex of a ring is moved by up to a tenth of an edge: what is drawn is the ring.
TEST(Regions, IsophotesOfAScanAreThoseOfItsShape) {
  TriMesh ring = test::torus(12, 5, 240, 100);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> off(-0.03, 0.03);
  for (Vec3& p : ring.positions) p += Vec3(off(random), off(random), off(random));
  Shown s;
  s.add(std::move(ring));
  s.direction = {0, 0, 1};
  s.up = {0, 1, 0};
  s.style.tone.light = {0, 0, 1};
  s.style.feature.isophotes = 3;
  EXPECT_EQ(isophotes(s.draw()), 6U) << "a circle inside and one outside of the crest for each";
}

/// A ball that closes a pipe of its radius touches it in a circle. Beside that it lies within the
/// pipe by less than facets are off, and these stand before each other in turn.
TEST(Regions, OfSurfacesThatTouchGoByTheSurfacesThemselves) {
  constexpr double kRadius = 5;
  Shown s;
  s.add(std::make_shared<ParametricForm>(
      std::vector<std::shared_ptr<const Chart>>{test::cylinder_chart(kRadius, 25)}));
  s.add(std::make_shared<ParametricForm>(test::six_patches(Vec3(kRadius))));
  s.fill(2);
  s.style.shadow.cast = true;
  std::size_t looked = 0;
  for (const Vec3 direction : {Vec3(1, 0.3, -0.4), Vec3(1, -0.7, -0.6), Vec3(0, -1, -0.1)}) {
    s.direction = direction;
    const Camera camera = s.camera();
    const Drawing d = s.draw();
    const AreasAt areas(d.areas, 0.03);
    for (double angle = 0; angle < 2 * kPi; angle += 0.01) {
      const Vec3 normal(std::cos(angle), std::sin(angle), 0);
      if (glm::dot(normal, camera.direction()) < 0.25) continue;
      const auto area = [&](double up) -> const Area* {
        const Vec2 at = camera.to_paper(kRadius * normal + Vec3(0, 0, up));
        const auto found = areas.at(at);
        return found.empty() || areas.beside_border(at) ? nullptr : &d.areas[found.back()];
      };
      const Area* plain = area(5);
      // Nearer, where seen at a flat angle, they are taken for one surface.
      for (double up = 0.18; up < 0.5 && plain != nullptr; up += 0.03) {
        const Area* near = area(up);
        if (near == nullptr) continue;
        ++looked;
        ASSERT_EQ(near->part, 0) << up << " beside it, at " << angle;
        ASSERT_EQ(near->tone, plain->tone) << up << " beside it, at " << angle;
      }
    }
  }
  EXPECT_GT(looked, 5000u);
}

/// Two pipes of one radius and axis lie on each other along half their length, whatever facets they
/// have: there the first is seen alone.
TEST(Regions, OfRoundSurfacesThatLieOnEachOtherAreThoseOfOnePart) {
  constexpr double kRadius = 5;
  Shown s;
  constexpr double kSlit = 5.9;  // so that facets of the first are others
  const auto pipe = [&](double height, double angle) {
    return std::make_shared<ParametricForm>(
        std::vector<std::shared_ptr<const Chart>>{test::cylinder_chart(kRadius, height, angle)});
  };
  s.add(pipe(12, kSlit));
  s.add(pipe(25, 2 * kPi));
  s.fill(2);
  s.style.shadow.cast = true;
  std::size_t looked = 0;
  for (const Vec3 direction : {Vec3(1, 0.3, -0.4), Vec3(1, -0.7, 0.6), Vec3(0, -1, -0.1)}) {
    s.direction = direction;
    const Camera camera = s.camera();
    const Drawing d = s.draw();
    const AreasAt areas(d.areas, 0.03);
    for (double angle = 0.05; angle < kSlit - 0.05; angle += 0.01) {
      const Vec3 normal(std::cos(angle), std::sin(angle), 0);
      if (glm::dot(normal, camera.direction()) < 0.1) continue;
      for (double up = 1; up < 24; up += 0.7) {
        const Vec2 at = camera.to_paper(kRadius * normal + Vec3(0, 0, up));
        const auto found = areas.at(at);
        if (std::abs(up - 12) < 0.5 || found.empty() || areas.beside_border(at)) continue;
        ++looked;
        ASSERT_EQ(d.areas[found.back()].part, up < 12 ? 0 : 1) << up << " up, at " << angle;
      }
    }
  }
  EXPECT_GT(looked, 5000u);
}

}  // namespace
}  // namespace burin
