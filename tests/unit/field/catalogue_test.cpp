/// The rows of the catalogue keep what they promise.

#include <burin/base/error.h>
#include <burin/field/catalogue.h>

#include <burin_test/fields.h>
#include <burin_test/irregular.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <set>
#include <string>

namespace burin {
namespace {

using test::Probe;

const Vec3 kView{0, -1, 0.5};  // along faces of the box

Field make(const field::FieldKind& kind, const Surface& surface) {
  const RunContext context;
  ViewOptions view;
  view.direction = kView;
  const Camera camera =
      Camera::fit([&](const Mat3&) { return surface.proxy().mesh.bounds(); }, view);
  const std::vector<const Surface*> surfaces{&surface};
  const field::FieldOptions usual;
  const auto image = std::make_shared<const Image>(Image{2, 1, {0, 1}});
  return kind.make({.surfaces = surfaces,
                    .camera = camera,
                    .options = usual,
                    .context = context,
                    .image = image});
}

/// The share of places that have a cross, whose arms are unit tangents.
double share_of(const field::FieldKind& kind, const Surface& surface) {
  const Field field = make(kind, surface);
  EXPECT_EQ(field.name, kind.name);
  int all = 0, found = 0;
  for (const Probe& p : test::probes(surface)) {
    ++all;
    const auto cross = field.cross({0, p.point, p.frame});
    if (!cross) continue;
    ++found;
    for (const Vec3 arm : {cross->first, cross->second}) {
      EXPECT_NEAR(glm::length(arm), 1, 1e-9);
      EXPECT_NEAR(glm::dot(arm, p.frame.normal), 0, 1e-9);
    }
    EXPECT_GE(cross->certainty, 0);
    EXPECT_LE(cross->certainty, 2);
  }
  return static_cast<double>(found) / all;
}

TEST(FieldCatalogue, EachRowHasANameOfItsOwnAndMakesAFieldOfThatName) {
  std::set<std::string_view> names;
  for (const field::FieldKind& kind : field::catalogue()) {
    SCOPED_TRACE(kind.name);
    EXPECT_TRUE(names.insert(kind.name).second);
    EXPECT_FALSE(kind.meaning.empty());
    EXPECT_EQ(&field::find(kind.name), &kind);
  }
  EXPECT_THROW(field::find("smooth"), UsageError);
}

TEST(FieldCatalogue, WhatARowSaysToBeMissingIsMissingSomewhereAndNothingElse) {
  const auto torus = test::realised(test::torus(3, 1, 60, 30));
  const auto sphere = test::realised(test::icosphere(1, 8));
  const auto box = test::realised(test::box({0, 0, 0}, {1, 2, 3}));
  const Vec3 n = glm::normalize(kView), u(1, 0, 0), v = glm::cross(n, u);
  const auto square_on = test::realised(test::mapped(
      test::box({0, 0, 0}, {3, 2, 1}), [&](Vec3 p) { return p.x * u + p.y * v + p.z * n; }));
  for (const field::FieldKind& kind : field::catalogue()) {
    SCOPED_TRACE(kind.name);
    const double least = std::min({share_of(kind, *torus), share_of(kind, *sphere),
                                   share_of(kind, *box), share_of(kind, *square_on)});
    if (kind.missing.empty()) {
      EXPECT_GT(least, 0.97);
    } else {
      EXPECT_LT(least, 0.9);
    }
  }
}

TEST(FieldCatalogue, WithoutCurvatureOnlyRowsThatNeedItAreLost) {
  const auto with = test::realised(test::torus(3, 1, 60, 30));
  const auto without = test::realised(test::torus(3, 1, 60, 30), false);
  for (const field::FieldKind& kind : field::catalogue()) {
    if (kind.needs_curvature) continue;
    SCOPED_TRACE(kind.name);
    EXPECT_EQ(share_of(kind, *with), share_of(kind, *without));
  }
}

}  // namespace
}  // namespace burin
