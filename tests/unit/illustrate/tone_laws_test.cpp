/// The laws of tone against their formulas.

#include <burin/base/error.h>
#include <burin/tone/catalogue.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace burin {
namespace {

/// Looks along -z, the light from the right and above.
Camera camera() {
  Box3 box;
  box.add({-10, -10, -10});
  box.add({10, 10, 10});
  return Camera::fit([&](const Mat3&) { return box; }, {.direction = {0, 0, 1}, .up = {0, 1, 0}});
}

tone::ToneOptions options(const std::string& law) {
  return {.law = law,
          .light = {3, 0, 4},
          .ambient = 0.2,
          .diffuse = 0.5,
          .specular = 0.25,
          .shininess = 10,
          .highlight = 1,
          .rim = 0};
}

double at(const std::string& law, Vec3 normal) {
  return tone::make(camera(), options(law))({}, glm::normalize(normal));
}

TEST(ToneCatalogue, EachRowHasANameOfItsOwnAndStaysWithinPaperAndInk) {
  std::set<std::string_view> names;
  for (const tone::Law& law : tone::catalogue()) {
    SCOPED_TRACE(law.name);
    EXPECT_TRUE(names.insert(law.name).second);
    EXPECT_FALSE(law.meaning.empty());
    EXPECT_EQ(&tone::find(law.name), &law);
    tone::ToneOptions loud = options(std::string(law.name));
    loud.diffuse = loud.specular = 2;
    loud.rim = 1;
    const Tone tone = tone::make(camera(), loud);
    for (int i = 0; i < 64; ++i) {
      const double a = 0.1 * i;
      const double value =
          tone({}, {std::cos(a) * std::sin(3 * a), std::sin(a) * std::sin(3 * a), std::cos(3 * a)});
      EXPECT_GE(value, 0);
      EXPECT_LE(value, 1);
    }
  }
  EXPECT_THROW(tone::find("lambertian"), UsageError);
  EXPECT_THROW(tone::make(camera(), {.law = "lambertian"}), UsageError);
}

TEST(Lambert, LightThrownBackLightensTheShadeOnTheOtherSide) {
  tone::ToneOptions o = options("lambert");
  const Tone without = tone::make(camera(), o);
  o.reflected = 0.2;
  const Tone with = tone::make(camera(), o);
  // The light comes from (3, 0, 4) / 5, and back from (-3, 0, 4) / 5.
  const Vec3 shade(-0.96, 0, 0.28), lit(0.6, 0, 0.8), below(0, 0, -1);
  EXPECT_NEAR(with({}, shade) - without({}, shade), 0.2 * (0.96 * 0.6 + 0.28 * 0.8), 1e-9);
  EXPECT_EQ(with({}, lit), without({}, lit));
  EXPECT_EQ(with({}, below), without({}, below));
}

TEST(Rim, DarkensInkAndNeverBeginsIt) {
  tone::ToneOptions o = options("constant");
  o.rim = 0.4;
  const Vec3 edge(1, 0, 0);
  o.ambient = 1;
  EXPECT_EQ(tone::make(camera(), o)({}, edge), 1);
  o.ambient = 0.7;
  EXPECT_NEAR(tone::make(camera(), o)({}, edge), 0.3, 1e-9);
  EXPECT_NEAR(tone::make(camera(), o)({}, {0, 0, 1}), 0.7, 1e-9);
}

TEST(Lights, OfASceneStandInForThatOfTheStyle) {
  for (const char* law : {"lambert", "phong"}) {
    tone::ToneOptions one = options(law), same = one;
    same.lights = {{tone::Light::Kind::Ambient, {}, one.ambient},
                   {tone::Light::Kind::From, one.light, one.diffuse}};
    same.ambient = same.diffuse = 0;
    same.light = {-1, 0, 0};
    for (const Vec3 n : {Vec3(0, 0, 1), Vec3(0.6, 0, 0.8), Vec3(-0.6, 0, 0.8), Vec3(0, 0.8, 0.6)}) {
      EXPECT_NEAR(tone::make(camera(), one)({}, n), tone::make(camera(), same)({}, n), 1e-12)
          << law;
    }
  }
}

TEST(ToneInk, MayStandForLight) {
  for (const tone::Law& law : tone::catalogue()) {
    tone::ToneOptions shade = options(std::string(law.name)), light = shade;
    light.ink = tone::ToneOptions::Ink::Light;
    for (const Vec3 n : {Vec3(0, 0, 1), Vec3(0.6, 0, 0.8), Vec3(-0.8, 0, 0.6)}) {
      EXPECT_NEAR(tone::make(camera(), shade)({}, n) + tone::make(camera(), light)({}, n), 1, 1e-12)
          << law.name;
    }
  }
}

TEST(Lights, AddUpAndThoseOfAPlaceShineFromIt) {
  tone::ToneOptions o = options("lambert");
  o.lights = {{tone::Light::Kind::Ambient, {}, 0.1},
              {tone::Light::Kind::From, {0, 0, 2}, 0.4},
              {tone::Light::Kind::At, {0, 0, 5}, 0.3}};
  const Tone tone = tone::make(camera(), o);
  EXPECT_NEAR(tone({0, 0, 0}, {0, 0, 1}), 0.8, 1e-12);
  // From (3, 0, 1) the lamp stands in direction (-3, 0, 4) / 5.
  EXPECT_NEAR(tone({3, 0, 1}, {0, 0, 1}), 0.1 + 0.4 + 0.3 * 0.8, 1e-12);
  // In the place of the lamp itself there is no direction to it.
  EXPECT_NEAR(tone({0, 0, 5}, {0, 0, 1}), 0.5, 1e-12);
}

TEST(ToneCatalogue, RowsThatLookAtTheLightAreThoseThatItChanges) {
  for (const tone::Law& law : tone::catalogue()) {
    SCOPED_TRACE(law.name);
    const tone::ToneOptions usual = options(std::string(law.name));
    tone::ToneOptions turned = usual;
    turned.light = {-3, 0, 4};
    const Vec3 normal = glm::normalize(Vec3(1, 0, 1));
    const double before = tone::make(camera(), usual)({}, normal);
    EXPECT_EQ(before != tone::make(camera(), turned)({}, normal), law.uses_light);
  }
}

TEST(ToneLaws, LambertIsTheCosineToTheLight) {
  EXPECT_NEAR(at("lambert", {3, 0, 4}), 0.7, 1e-12);
  EXPECT_NEAR(at("lambert", {0, 0, 1}), 0.2 + 0.5 * 0.8, 1e-12);
  EXPECT_NEAR(at("lambert", {-4, 0, 3}), 0.2, 1e-12);
  EXPECT_NEAR(at("lambert", {-1, 0, 0}), 0.2, 1e-12);
}

TEST(ToneLaws, PhongAddsTheMirroredLight) {
  // Halfway between light and viewer the mirror shows the light.
  const Vec3 halfway = glm::normalize(Vec3(0.6, 0, 0.8)) + Vec3(0, 0, 1);
  EXPECT_NEAR(at("phong", halfway) - at("lambert", halfway), 0.25, 1e-12);
  EXPECT_NEAR(at("phong", {0, 0, 1}) - at("lambert", {0, 0, 1}), 0.25 * std::pow(0.8, 10), 1e-12);
  EXPECT_EQ(at("phong", {-4, 0, 2}), at("lambert", {-4, 0, 2}));
}

TEST(ToneLaws, FacingIsTheCosineToTheViewer) {
  EXPECT_NEAR(at("facing", {0, 0, 1}), 0.7, 1e-12);
  EXPECT_NEAR(at("facing", {3, 0, 4}), 0.2 + 0.5 * 0.8, 1e-12);
  EXPECT_NEAR(at("facing", {-3, 0, 4}), 0.2 + 0.5 * 0.8, 1e-12);
}

TEST(ToneLaws, ConstantIsTheAmbientLight) {
  EXPECT_NEAR(at("constant", {0, 0, 1}), 0.2, 1e-12);
  EXPECT_NEAR(at("constant", {-1, 2, 0.1}), 0.2, 1e-12);
}

TEST(ToneLaws, SilhouetteFallsOffFromWhereTheSurfaceTurnsAway) {
  EXPECT_NEAR(at("silhouette", {1, 0, 0}), 0, 1e-12);
  EXPECT_NEAR(at("silhouette", {4, 0, 3}), 1 - std::pow(0.4, 3), 1e-12);
  EXPECT_NEAR(at("silhouette", {0, 0, 1}), 1, 1e-12);
  tone::ToneOptions o = options("silhouette");
  o.decay = 1;
  EXPECT_NEAR(tone::make(camera(), o)({}, glm::normalize(Vec3(3, 0, 4))), 0.8, 1e-12);
}

TEST(ToneLaws, RimAndHighlightAreOfEveryLaw) {
  tone::ToneOptions o = options("constant");
  o.highlight = 0.5;
  EXPECT_NEAR(tone::make(camera(), o)({}, {0, 0, 1}), 0.4, 1e-12);
  o.rim = 0.2;
  EXPECT_NEAR(tone::make(camera(), o)({}, {0.8, 0, 0.6}), (0.2 - 0.2 * std::pow(0.4, 3)) / 0.5,
              1e-12);
}

}  // namespace
}  // namespace burin
