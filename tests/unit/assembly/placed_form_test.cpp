/// A placed form is the form, elsewhere: against meshes that were moved themselves.

#include <burin/base/error.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/illustrate/illustrate.h>
#include <burin/surface/placed_form.h>

#include <burin_test/shapes.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace burin {
namespace {

// Turned about x, y and z, three times as large, away from the origin.
Placement away() {
  const double a = 0.4, b = -1.1;
  const Mat3 x(1, 0, 0, 0, std::cos(a), std::sin(a), 0, -std::sin(a), std::cos(a));
  const Mat3 z(std::cos(b), std::sin(b), 0, -std::sin(b), std::cos(b), 0, 0, 0, 1);
  return {z * x * 3.0, {20, -7, 4}};
}

std::shared_ptr<const Form> torus() {
  return std::make_shared<MeshForm>(test::torus(3, 1, 60, 30));
}

std::shared_ptr<const Form> moved_torus(const Placement& by) {
  TriMesh mesh = test::torus(3, 1, 60, 30);
  for (Vec3& p : mesh.positions) p = by.point(p);
  return std::make_shared<MeshForm>(std::move(mesh));
}

TEST(PlacedForm, BoundsAreThoseOfTheMovedMesh) {
  const Placement by = away();
  const Mat3 axes(0.6, 0.8, 0, -0.8, 0.6, 0, 0, 0, 1);
  const Box3 placed_box = placed(torus(), by)->bounds(axes), box = moved_torus(by)->bounds(axes);
  EXPECT_LT(glm::length(placed_box.min - box.min), 1e-9);
  EXPECT_LT(glm::length(placed_box.max - box.max), 1e-9);
}

TEST(PlacedForm, FramesAreTurnedAndTheirCurvaturesScaled) {
  RunContext context;
  const Placement by = away();
  const auto here = torus()->realise({}, context);
  const auto there = placed(torus(), by)->realise({.tolerance = 0.03}, context);
  for (std::uint32_t face = 0; face < 200; face += 7) {
    const SurfacePoint p = here->lift({face, Vec3(1.0 / 3)}),
                       q = there->lift({face, Vec3(1.0 / 3)});
    EXPECT_LT(glm::distance(by.point(p.position), q.position), 1e-12);
    const Frame f = here->frame(p), g = there->frame(q);
    EXPECT_NEAR(f.k1, 3 * g.k1, 1e-12);
    EXPECT_NEAR(f.k2, 3 * g.k2, 1e-12);
    EXPECT_LT(glm::distance(by.vector(f.normal) / 3.0, g.normal), 1e-12);
    const MarchStep a = here->march(p, f.d1, 0.2), b = there->march(q, g.d1, 0.6);
    EXPECT_LT(glm::distance(by.point(a.end.position), b.end.position), 1e-9);
    EXPECT_NEAR(3 * a.length, b.length, 1e-9);
  }
}

// Lines of both drawings: as many, each as long.
TEST(PlacedForm, DrawsAsTheMovedMeshDoes) {
  RunContext context;
  const Placement by = away();
  const auto drawn = [&](const std::shared_ptr<const Form>& form) {
    Scene scene;
    scene.parts.push_back({"torus", "", form});
    const Camera camera =
        Camera::fit([&](const Mat3& axes) { return scene.bounds(axes); }, ViewOptions{});
    return illustrate(scene, camera, builtin_style("outline"), {}, context);
  };
  const Drawing a = drawn(placed(torus(), by)), b = drawn(moved_torus(by));
  ASSERT_EQ(a.layers.size(), b.layers.size());
  const auto length = [](const Path& path) {
    double sum = 0;
    for (std::size_t i = 1; i < path.points.size(); ++i) {
      sum += glm::distance(path.points[i - 1], path.points[i]);
    }
    return sum;
  };
  for (std::size_t l = 0; l < a.layers.size(); ++l) {
    ASSERT_EQ(a.layers[l].paths.size(), b.layers[l].paths.size());
    for (std::size_t i = 0; i < a.layers[l].paths.size(); ++i) {
      EXPECT_NEAR(length(a.layers[l].paths[i]), length(b.layers[l].paths[i]), 1e-3);
    }
  }
}

/// A torus that counts how often it is realised.
class Counted final : public Form {
 public:
  Box3 bounds(const Mat3& axes) const override { return form_->bounds(axes); }
  std::shared_ptr<const Surface> realise(const RealiseOptions& options,
                                         RunContext& context) const override {
    ++times;
    options.diagnostics->add(Severity::Warning, "torus", 1, "is one");
    return form_->realise(options, context);
  }
  mutable int times = 0;

 private:
  std::shared_ptr<const Form> form_ = torus();
};

TEST(PlacedForm, CopiesThatAreOnlyMovedAreRealisedOnce) {
  const auto form = std::make_shared<Counted>();
  const Placer placer(form);
  const Placement here = away();
  Placement there = here, turned = here;
  there.offset += Vec3(100, 0, 0);
  turned.linear = Mat3(0, 1, 0, -1, 0, 0, 0, 0, 1) * turned.linear;
  RunContext context;
  Diagnostics said;
  const auto extent = [&](const Mat3& axes) { return form->bounds(axes); };
  const Camera flat = Camera::fit(extent, {}), close = Camera::fit(extent, {.perspective = 40});
  RealiseOptions options;
  options.view = &flat;
  options.diagnostics = &said;
  {
    const auto a = placer.at(here)->realise(options, context);
    const auto b = placer.at(there)->realise(options, context);
    EXPECT_EQ(form->times, 1);
    ASSERT_EQ(said.entries().size(), 2U) << "each says what is to be said of it";
    const Vec3 p = a->proxy().mesh.positions[7], q = b->proxy().mesh.positions[7];
    EXPECT_LT(glm::distance(p + Vec3(100, 0, 0), q), 1e-9);
    const auto c = placer.at(turned)->realise(options, context);
    EXPECT_EQ(form->times, 2) << "a turned copy shows other contours";
    options.tolerance *= 2;
    const auto d = placer.at(there)->realise(options, context);
    EXPECT_EQ(form->times, 3);
    options.view = &close;
    const auto e = placer.at(here)->realise(options, context);
    const auto f = placer.at(there)->realise(options, context);
    EXPECT_EQ(form->times, 5) << "in perspective each shows contours of its own";
  }
  options.view = &flat;
  (void)placer.at(here)->realise(options, context);
  EXPECT_EQ(form->times, 6) << "nothing is kept of surfaces that are gone";
}

// As the parts of an exploded view are.
TEST(PlacedForm, WhatIsPlacedAlreadyIsMovedOnNotWrapped) {
  const auto form = std::make_shared<Counted>();
  const auto here = Placer(form).at(away());
  const Placement by{Mat3(1), {5, 6, 7}};
  const auto there = placed(here, by);
  EXPECT_EQ(placed(here, {}), here);
  RunContext context;
  Diagnostics said;
  RealiseOptions options;
  options.diagnostics = &said;
  const auto a = here->realise(options, context), b = there->realise(options, context);
  EXPECT_EQ(form->times, 1) << "both are copies of one form";
  const Vec3 p = a->proxy().mesh.positions[11], q = b->proxy().mesh.positions[11];
  EXPECT_LT(glm::distance(by.point(p), q), 1e-9);
}

TEST(PlacedForm, WhatIsNoPlacementIsRefused) {
  const auto form = torus();
  EXPECT_EQ(placed(form, {}), form);
  EXPECT_THROW(placed(form, {Mat3(0), Vec3(0)}), UsageError);
  EXPECT_THROW(placed(form, {Mat3(1, 0, 0, 0, 2, 0, 0, 0, 0), Vec3(0)}), UsageError);
  EXPECT_THROW(placed(form, {Mat3(1, 2, 3, 2, 4, 6, 0, 0, 1), Vec3(0)}), UsageError);
  EXPECT_THROW(placed(form, {Mat3(1), Vec3(0, std::nan(""), 0)}), UsageError);
  EXPECT_THROW(placed(form, {Mat3(std::nan("")), Vec3(0)}), UsageError);
}

}  // namespace
}  // namespace burin
