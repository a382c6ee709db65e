// Directions told in u and v, against surfaces whose parameters are known.
#include <burin/base/error.h>
#include <burin/field/field.h>
#include <burin/forms/charted/nurbs.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/forms/patches/parametric_form.h>

#include <burin_test/fields.h>
#include <burin_test/nurbs_shapes.h>
#include <burin_test/shapes.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace burin {
namespace {

using test::Probe;

std::shared_ptr<const Surface> exact_surface(const NurbsData& nurbs) {
  RunContext context;
  return ParametricForm({make_nurbs_chart(nurbs)}).realise({.tolerance = 0.01}, context);
}

// A sheet of 40 x 20 mm.
NurbsData sheet() { return bezier_patch(1, 1, {{0, 0, 0}, {0, 20, 0}, {40, 0, 0}, {40, 20, 0}}); }

// Light by f(u, v).
template <class F>
std::shared_ptr<const Image> image(int width, int height, F f) {
  auto image = std::make_shared<Image>(Image{width, height, {}});
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image->values.push_back(static_cast<float>(f((x + 0.5) / width, (y + 0.5) / height)));
    }
  }
  return image;
}

// Places all over a surface of few triangles.
std::vector<Probe> many(const Surface& s) {
  std::vector<Probe> probes;
  const Rng rng(3);
  for (std::uint32_t i = 0; i < 200; ++i) {
    const double a = rng.uniform(2 * i), b = rng.uniform(2 * i + 1);
    const auto face = i % static_cast<std::uint32_t>(s.proxy().mesh.triangles.size());
    probes.emplace_back(
        s, ProxyPoint{face, a + b < 1 ? Vec3(1 - a - b, a, b) : Vec3(a + b - 1, 1 - a, 1 - b)});
  }
  return probes;
}

constexpr double kTurn = 2 * std::numbers::pi;

TEST(TextureImage, RunsAcrossTheGradientOfThePicture) {
  const auto s = exact_surface(sheet());
  const std::vector<const Surface*> surfaces{s.get()};
  const auto waves = image(200, 100, [](double u, double v) {
    return 0.5 + 0.2 * std::sin(kTurn * u) + 0.2 * std::cos(kTurn * 2 * v);
  });
  for (const double blur : {0.0, 0.01}) {
    const Field field = field::texture_image(surfaces, waves, blur);
    int count = 0;
    for (const Probe& p : many(*s)) {
      const double u = p.point.position.x / 40, v = p.point.position.y / 20;
      const Vec3 gradient(std::cos(kTurn * u) / 40, -2 * std::sin(kTurn * 2 * v) / 20, 0);
      if (glm::length(gradient) < 0.01) continue;
      const auto d = test::direction(field, p.query());
      ASSERT_TRUE(d);
      ++count;
      EXPECT_NEAR(glm::dot(*d, glm::normalize(gradient)), 0, 0.03);
    }
    EXPECT_GT(count, 100);
  }
}

TEST(TextureImage, HasNoDirectionWhereThePictureIsEvenOrThereIsNoUv) {
  const auto s = exact_surface(sheet());
  const auto even = image(20, 20, [](double, double) { return 0.4; });
  const Field field = field::texture_image({s.get()}, even, 0.01);
  for (const Probe& p : test::probes(*s)) EXPECT_FALSE(test::direction(field, p.query()));
  RunContext context;
  const auto mesh = MeshForm(test::box({0, 0, 0}, {1, 2, 3})).realise({.tolerance = 0.01}, context);
  const auto steep = image(20, 20, [](double u, double) { return u; });
  const std::vector<const Surface*> meshes{mesh.get()};
  const Field none = field::texture_image(meshes, steep, 0.01);
  for (const Probe& p : test::probes(*mesh)) EXPECT_FALSE(test::direction(none, p.query()));
  EXPECT_THROW(field::texture_image({s.get()}, nullptr, 0.01), UsageError);
}

TEST(TextureImage, BlurTakesGrainAway) {
  // StrokeDirections of single pixels on a slope along u.
  const auto grainy = image(200, 200, [i = std::uint32_t{0}](double u, double) mutable {
    i = i * 1103515245u + 12345u;
    return 0.3 * std::sin(kTurn * u) + 0.1 * ((i >> 16) % 100) / 100.0 + 0.4;
  });
  const auto s = exact_surface(sheet());
  const auto off = [&](double blur) {
    const Field field = field::texture_image({s.get()}, grainy, blur);
    double sum = 0;
    int count = 0;
    for (const Probe& p : many(*s)) {
      if (std::abs(std::cos(kTurn * p.point.position.x / 40)) < 0.5) continue;
      const auto d = test::direction(field, p.query());
      sum += d ? std::abs(d->x) : 1;
      ++count;
    }
    return sum / count;
  };
  EXPECT_GT(off(0), 0.5);
  EXPECT_LT(off(0.03), 0.15);
}

TEST(TextureVector, IsTheParameterLineWhereOneOfThemStands) {
  const auto s = exact_surface(test::torus_nurbs(10, 4));
  for (const bool u : {true, false}) {
    const Field field = field::texture_vector({s.get()}, u ? "1" : "0", u ? "0" : "1");
    for (const Probe& p : test::probes(*s)) {
      const auto d = test::direction(field, p.query());
      ASSERT_TRUE(d);
      const Vec3 along = glm::normalize(u ? p.frame.du : p.frame.dv);
      EXPECT_NEAR(glm::dot(*d, along), 1, 1e-4);
    }
  }
}

TEST(TextureVector, TurnsAsItsFormulasSay) {
  const auto s = exact_surface(sheet());
  // Circles about the middle of the sheet, as u and v see them.
  const Field field = field::texture_vector({s.get()}, "0.5 - v", "u - 0.5");
  for (const Probe& p : many(*s)) {
    const Vec3 x = p.point.position;
    const Vec2 way((0.5 - x.y / 20) * 40, (x.x / 40 - 0.5) * 20);
    if (glm::length(way) < 0.5) continue;
    const auto d = test::direction(field, p.query());
    ASSERT_TRUE(d);
    EXPECT_NEAR(glm::dot(Vec2(*d), glm::normalize(way)), 1, 1e-6);
  }
  try {
    field::texture_vector({s.get()}, "1 +", "0");
    FAIL() << "it was read";
  } catch (const UsageError& e) {
    EXPECT_TRUE(std::string(e.what()).starts_with("style key 'hatch.along_u': column "));
  }
}

}  // namespace
}  // namespace burin
