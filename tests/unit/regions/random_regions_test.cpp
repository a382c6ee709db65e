/// Areas of random scenes of primitives: what holds of all of them.

#include <burin/base/parallel.h>
#include <burin/base/rng.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/illustrate/illustrate.h>
#include <burin/illustrate/view_probe.h>
#include <burin/tone/catalogue.h>
#include <burin/verify/areas.h>
#include <burin/verify/wrong_areas.h>

#include "burin_test/rings.h"
#include "burin_test/shapes.h"
#include "burin_test/turned.h"
#include "burin_test/view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

namespace burin {
namespace {

/// Scenes of each test; BURIN_TEST_SCENES=2000 tries more.
std::uint64_t scenes() {
  constexpr std::uint64_t kFew = 200;
  const char* wanted = std::getenv("BURIN_TEST_SCENES");
  return wanted ? std::strtoull(wanted, nullptr, 10) : kFew;
}

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : random_(seed) {}
  double between(double a, double b) { return a + (b - a) * random_.uniform(n_++); }
  int below(int n) { return static_cast<int>(between(0, n)); }
  bool one_in(double n) { return between(0, n) < 1; }
  Vec3 direction() {
    const double z = between(-1, 1), a = between(0, 2 * kPi), r = std::sqrt(1 - z * z);
    return {r * std::cos(a), r * std::sin(a), z};
  }

 private:
  static constexpr double kPi = test::kPi;
  Rng random_;
  std::uint64_t n_ = 0;
};

/// About the origin or on the plane z = 0, with sizes of whole steps of 5 mm half of the time.
TriMesh primitive(Dice& dice) {
  const bool whole = dice.one_in(2);
  const auto size = [&] { return whole ? 5.0 * (1 + dice.below(4)) : dice.between(3, 20); };
  constexpr int kSides = 64;
  switch (dice.below(5)) {
    case 0:
      return test::box(Vec3(0), {size(), size(), size()});
    case 1:
      return test::ellipsoid(Vec3(0.6 * size()), kSides, kSides / 2);
    case 2:
      return test::cylinder(0.5 * size(), size(), kSides);
    case 3:
      return test::turned({{0.6 * size(), 0}, {0.2 * size(), size()}}, kSides);
    default: {
      const double tube = 0.2 * size();
      return test::torus(tube + 0.5 * size(), tube, kSides, kSides / 2);
    }
  }
}

Mat3 some_turn(Dice& dice) {
  const int kind = dice.below(3);
  if (kind == 0) return Mat3(1);
  const Vec3 x = kind == 1 ? Vec3(0, 1, 0) : dice.direction();
  const Vec3 y = kind == 1 ? Vec3(0, 0, 1) : glm::normalize(glm::cross(dice.direction(), x));
  return {x, y, glm::cross(x, y)};
}

Box3 bounds_of(const TriMesh& mesh) {
  Box3 box;
  for (const Vec3& p : mesh.positions) box.add(p);
  return box;
}

/// One to five primitives: flush with each other on a grid of 5 mm, touching, or piercing.
std::vector<TriMesh> random_meshes(Dice& dice) {
  std::vector<TriMesh> out;
  const int count = 1 + dice.below(5);
  for (int i = 0; i < count; ++i) {
    TriMesh mesh = test::moved(primitive(dice), some_turn(dice), Vec3(0));
    Vec3 by(dice.between(-12, 12), dice.between(-12, 12), dice.between(-12, 12));
    const int kind = dice.below(3);
    if (kind == 0) by = 5.0 * glm::round(by / 5.0);
    if (kind == 1 && !out.empty()) {  // on the one before
      by.z = bounds_of(out.back()).max.z - bounds_of(mesh).min.z;
    }
    for (Vec3& p : mesh.positions) p += by;
    out.push_back(std::move(mesh));
  }
  return out;
}

ViewOptions random_view(Dice& dice) {
  static constexpr std::array kViews = {"front", "top", "iso", "left"};
  ViewOptions view{.paper = {90, 70}};
  if (dice.one_in(2.5)) {
    const NamedView named = named_view(kViews[static_cast<std::size_t>(dice.below(4))]);
    view.direction = named.direction;
    view.up = named.up;
  } else {
    view.direction = dice.direction();
  }
  if (dice.one_in(2.5)) view.perspective = dice.between(15, 60);
  return view;
}

/// A scene of its number alone.
struct Random {
  Scene scene;
  std::vector<TriMesh> meshes;
  ViewOptions view;
  Style style = builtin_style("outline");
  IllustrateOptions options{};

  explicit Random(std::uint64_t seed) {
    Dice dice(seed);
    meshes = random_meshes(dice);
    for (const TriMesh& mesh : meshes) {
      const std::string name = "part" + std::to_string(scene.parts.size());
      scene.parts.push_back({name, name, std::make_shared<MeshForm>(mesh)});
    }
    view = random_view(dice);
    style.fill.color = "part";
    style.fill.steps = dice.below(6);
    style.fill.opacity = dice.one_in(3) ? 0.5 : 1;  // nested or not
    style.tone.light = dice.direction();
    options.face_areas = dice.one_in(3);
  }
  Camera camera() const {
    return Camera::fit([&](const Mat3& axes) { return scene.bounds(axes); }, view);
  }
  Drawing draw() const {
    RunContext context;
    return illustrate(scene, camera(), style, options, context);
  }
};

/// Whether rays against finer surfaces see what areas state.
void expect_true(const Random& random, const Drawing& drawing, std::uint64_t seed) {
  RunContext context;
  const Camera camera = random.camera();
  const FineSurfaces fine = fine_surfaces(random.scene, 0.0125 / camera.scale(), {}, {}, context);
  const Referee referee(fine, camera, {}, context);
  const auto steps = static_cast<std::size_t>(std::max(random.style.fill.steps, 1));
  const Isophotes light{tone::to_light(camera, random.style.tone), even_levels(steps)};
  AreaRule rule{drawing.areas, std::vector<Isophotes>(random.scene.parts.size(), light)};
  rule.pen = random.style.line.crease;
  // Normals of coarse facets are those of the surface as it is drawn.
  const FineSurfaces drawn = fine_surfaces(random.scene, 0.05 / camera.scale(), {}, {}, context);
  const Referee toned(drawn, camera, {}, context);
  const AreaWitnesses witnesses{referee, referee, {}, &toned};
  const AreaJudge judge(rule, witnesses, context);
  const Box2 sheet{Vec2(0), Vec2(drawing.paper_width, drawing.paper_height)};
  for (const WrongArea& wrong : wrong_areas(judge, sheet, seed, context).wrong) {
    const AreaAnswer& a = wrong.answer;
    ADD_FAILURE() << "scene " << seed << ": " << wrong.size << " mm2 " << to_string(a.finding)
                  << " at " << wrong.at.x << "," << wrong.at.y << ", stated " << a.stated.part
                  << "/" << a.stated.face << "/" << a.stated.tone << ", seen " << a.seen.part << "/"
                  << a.seen.face << "/" << a.seen.tone;
  }
}

TEST(RandomRegions, StateWhatRaysSee) {
  for (std::uint64_t seed = 0; seed < scenes(); ++seed) {
    const Random random(seed);
    expect_true(random, random.draw(), seed);
  }
}

TEST(RandomRegions, HaveRingsThatRunRoundThemOnceAndDoNotCrossThemselves) {
  for (std::uint64_t seed = 0; seed < scenes(); ++seed) {
    const Drawing drawing = Random(seed).draw();
    EXPECT_FALSE(drawing.areas.empty()) << seed;
    Dice dice(seed);
    std::vector<Vec2> places;
    for (int i = 0; i < 200; ++i) places.emplace_back(dice.between(0, 90), dice.between(0, 70));
    for (const Area& area : drawing.areas) {
      for (const std::vector<Vec2>& ring : area.rings) {
        EXPECT_GE(ring.size(), 3u) << seed;
        const std::vector<Vec2> crossings = test::self_crossings(ring);
        if (!crossings.empty()) {
          ADD_FAILURE() << "scene " << seed << ": " << crossings.size() << " crossings, at "
                        << crossings[0].x << "," << crossings[0].y;
        }
      }
      for (const Vec2 p : places) {
        const int n = test::winding(area.rings, p);
        EXPECT_TRUE(n == 0 || n == 1)
            << "scene " << seed << ": " << n << " at " << p.x << "," << p.y;
      }
    }
  }
}

TEST(RandomRegions, CoverTheSheetOnce) {
  for (std::uint64_t seed = 0; seed < scenes(); ++seed) {
    const Random random(seed);
    const test::View view(random.meshes, random.view);
    std::vector<std::vector<Vec2>> lines;
    for (std::size_t i = 0; i < view.features.size(); ++i) {
      const Curve3& curve = view.features[i];
      const auto count = static_cast<double>(curve.segment_count());
      for (const Span& span : merged(view.spans[i], curve.closed, count)) {
        if (!span.visible) continue;
        std::vector<Vec2>& line = lines.emplace_back();
        for (const Vec3& p : slice(curve, span.begin, span.end).points) {
          line.push_back(view.camera.to_paper(p));
        }
      }
    }
    std::vector<BorderLine> borders;
    for (const auto& line : lines) {
      borders.push_back({line, false, static_cast<std::int32_t>(borders.size())});
    }
    const auto label_at = [probe = view_probe(*view.occluder, view.camera)](Vec2 at) {
      const auto hit = probe(at);
      return AreaLabel{.part = hit ? hit->part : -1};
    };
    const Box2 sheet{Vec2(0), Vec2(90, 70)};
    SCOPED_TRACE(seed);
    test::expect_sound(partition(sheet, borders, label_at, {.slack = 0.04}, RunContext()), sheet);
  }
}

TEST(RandomRegions, AreTheSameForAnyNumberOfThreads) {
  const std::uint64_t count = (scenes() + 4) / 5;
  for (std::uint64_t seed = 0; seed < count; ++seed) {
    const Random random(seed);
    const Drawing all = random.draw();
    for (const int threads : {1, 2, 3}) {
      const ThreadLimit limit(threads);
      const Drawing other = random.draw();
      ASSERT_EQ(all.areas.size(), other.areas.size()) << seed;
      for (std::size_t i = 0; i < all.areas.size(); ++i) {
        EXPECT_EQ(all.areas[i].rings, other.areas[i].rings) << "scene " << seed;
        EXPECT_EQ(all.areas[i].fill, other.areas[i].fill) << "scene " << seed;
      }
    }
  }
}

}  // namespace
}  // namespace burin
