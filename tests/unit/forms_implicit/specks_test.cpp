/// Small components of implicit surfaces where drawings meet them: beside large ones, inside, cut,
/// at the border, many of them, and where the function tells too little to find them.

#include <burin/base/placement.h>
#include <burin/base/rng.h>
#include <burin/camera/camera.h>
#include <burin/illustrate/illustrate.h>
#include <burin/section/section.h>

#include "components.h"
#include "mapped_function.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

namespace burin {
namespace {

using namespace implicit;
using test::around;
using test::find;
using test::Found;

std::shared_ptr<const Form> form_of(const Expression& e) {
  return std::make_shared<ImplicitForm>(make_function(e), std::optional<Box3>(), RunContext());
}

/// Vertices, edges, triangles: 2 of a ball, 0 of a ring.
std::int64_t euler_number(const TriMesh& m) {
  std::set<std::uint32_t> vertices;
  for (const Triangle& t : m.triangles) vertices.insert(t.begin(), t.end());
  const auto triangles = static_cast<std::int64_t>(m.triangles.size());
  return static_cast<std::int64_t>(vertices.size()) - triangles / 2;
}

/// Values and derivatives of a function, and no more of it.
class OnlyValues final : public ImplicitFunction {
 public:
  explicit OnlyValues(const Expression& e) : f_(make_function(e)) {}
  void values(std::span<const Vec3> p, std::span<double> out) const override { f_->values(p, out); }
  void gradients(std::span<const Vec3> p, std::span<Gradient1> out) const override {
    f_->gradients(p, out);
  }
  void hessians(std::span<const Vec3> p, std::span<Gradient2> out) const override {
    f_->hessians(p, out);
  }
  Box3 bounds() const override { return f_->bounds(); }

 private:
  std::shared_ptr<const ImplicitFunction> f_;
};

TEST(ImplicitSpecks, ARingBesideALargeOneKeepsItsHole) {
  const Vec3 at(11.03, 10.07, 2.11);
  const Found found = find(unite(torus(10, 2), translate(torus(0.08, 0.03), at)));
  EXPECT_EQ(found.components, 2u);
  const TriMesh ring = around(found.mesh, at, 1);
  EXPECT_EQ(euler_number(ring), 0);
  const Box3 box = test::box_of(ring);
  ASSERT_FALSE(box.empty());
  EXPECT_NEAR(box.size().x, 0.22, 0.01);
  EXPECT_NEAR(box.size().y, 0.22, 0.01);
  EXPECT_NEAR(box.size().z, 0.06, 0.01);
}

// It cannot be seen, and is there nevertheless, closed.
TEST(ImplicitSpecks, OneInACavityIsDrawnOnlyWhereTheCavityIsCutOpen) {
  Scene scene;
  const Expression e = unite(subtract(sphere(10), sphere(8)), translate(sphere(0.05), {3, 2, 1}));
  scene.parts.push_back({"shell", "shell.implicit", form_of(e)});
  EXPECT_EQ(test::found_of(*scene.parts[0].form).components, 3u);
  const auto pieces = [&] {
    const auto bounds = [&](const Mat3& axes) { return scene.bounds(axes); };
    const Camera camera =
        Camera::fit(bounds, {.direction = Vec3(0, 0, 1), .up = Vec3(0, 1, 0), .paper = {400, 400}});
    RunContext context;
    std::size_t small = 0, all = 0;
    const Drawing d = illustrate(scene, camera, builtin_style("outline"), {}, context);
    const Vec2 there = camera.to_paper(Vec3(3, 2, 1));
    for (const Layer& layer : d.layers) {
      for (const Path& path : layer.paths) {
        ++all;
        small += std::ranges::all_of(
            path.points, [&](Vec2 p) { return glm::distance(p, there) < 0.1 * camera.scale(); });
      }
    }
    EXPECT_GT(all, small);
    return small;
  };
  EXPECT_EQ(pieces(), 0u);
  scene.parts[0].form = cut_form(scene.parts[0].form, {{0, 0, 1}, 3}, 0, "shell");
  EXPECT_GE(pieces(), 1u);
}

TEST(ImplicitSpecks, ACutThroughOneHasItsArea) {
  const Vec3 at(12.03, 0.07, 0.11);
  const auto form = form_of(unite(box(10, 10, 10), translate(sphere(0.05), at)));
  RunContext context;
  const auto cut = cut_form(form, {{0, 0, 1}, at.z}, 0, "")->realise({.tolerance = 0.01}, context);
  const ProxyMesh& proxy = cut->proxy();
  double speck = 0, all = 0;
  for (std::uint32_t f = 0; f < proxy.mesh.triangles.size(); ++f) {
    if (!proxy.is_cut(f)) continue;
    const double area = proxy.mesh.area(f);
    all += area;
    if (proxy.mesh.positions[proxy.mesh.triangles[f][0]].x > 11) speck += area;
  }
  EXPECT_NEAR(speck, std::numbers::pi * 0.05 * 0.05, 0.1 * std::numbers::pi * 0.05 * 0.05);
  EXPECT_NEAR(all - speck, 100, 1e-3);
}

TEST(ImplicitSpecks, AtTheBorderOfTheBoundsOneIsFoundWholeOrCut) {
  constexpr double kRadius = 0.04, kBorder = 12.5;
  const auto with = [&](double x) {
    const Expression e = unite(sphere(10), translate(sphere(kRadius), {x, 0.07, 0.11}));
    return find(e, Box3{Vec3(-10.5), Vec3(kBorder, 10.5, 10.5)});
  };
  const Found within = with(kBorder - kRadius - 0.005);
  EXPECT_EQ(within.components, 2u);
  EXPECT_FALSE(within.says("implicit.may_miss"));
  const Found cut = with(kBorder);
  EXPECT_EQ(cut.components, 2u);
  EXPECT_NEAR(test::box_of(cut.mesh).max.x, kBorder, 1e-9);
  EXPECT_EQ(with(kBorder + kRadius + 0.005).components, 1u);
}

/// One of radius 3, and small ones at random places, one in each cube of side 2.
Expression with_many(std::size_t number) {
  const Rng rng(11);
  std::vector<Expression> balls{sphere(3)};
  for (std::uint64_t i = 0; i < number; ++i) {
    const std::uint64_t column = i % 10, row = i / 10 % 10, layer = i / 100;
    const Vec3 cell(static_cast<double>(column), static_cast<double>(row),
                    static_cast<double>(layer));
    const Vec3 within(rng.uniform(3 * i), rng.uniform(3 * i + 1), rng.uniform(3 * i + 2));
    balls.push_back(translate(sphere(0.1), Vec3(4) + 2.0 * cell + within));
  }
  while (balls.size() > 1) {
    std::vector<Expression> halves;
    for (std::size_t i = 0; i < balls.size(); i += 2) {
      halves.push_back(i + 1 < balls.size() ? unite(balls[i], balls[i + 1]) : balls[i]);
    }
    balls = std::move(halves);
  }
  return balls[0];
}

// Turned, stretched and sheared: slopes hold the derivatives there, and tell of it.
TEST(ImplicitSpecks, PlacedFunctionsTellTheirSlopes) {
  const Placement placement{Mat3(2, 0.3, 0, -0.4, 1, 0.2, 0, 0.5, -1.5), Vec3(1, 2, 3)};
  const MappedFunction f(make_function(unite(sphere(3), box(4, 5, 1))), placement);
  ASSERT_TRUE(f.has_slopes());
  const Rng rng(2);
  const auto any = [&](std::uint64_t k) {
    return 2.0 * Vec3(rng.uniform(3 * k), rng.uniform(3 * k + 1), rng.uniform(3 * k + 2)) - 1.0;
  };
  for (std::uint64_t i = 0; i < 50; ++i) {
    const Vec3 center = 6.0 * any(3 * i), direction = any(3 * i + 1);
    const Interval slope = f.slope({center - 0.2, center + 0.2}, direction);
    EXPECT_LT(slope.max - slope.min, 100);
    for (std::uint64_t k = 0; k < 20; ++k) {
      const Vec3 p = center + 0.2 * any(1000 + k);
      const double s = glm::dot(f.gradient(p).gradient, direction);
      EXPECT_GE(s, slope.min - 1e-9);
      EXPECT_LE(s, slope.max + 1e-9);
    }
  }
}

TEST(ImplicitSpecks, OfManyAllAreFound) {
  const Found found = find(with_many(100));
  EXPECT_EQ(found.components, 101u);
  EXPECT_FALSE(found.says("implicit.may_miss"));
}

// Next to its rim one sample sees an eighth of a ball: that is not the ball, whatever the steps.
TEST(ImplicitSpecks, NoneIsSeenFromOneSideAlone) {
  constexpr double kRadius = 0.1;
  const Rng rng(5);
  for (std::uint64_t i = 0; i < 30; ++i) {
    const Vec3 at =
        Vec3(19) + Vec3(rng.uniform(3 * i), rng.uniform(3 * i + 1), rng.uniform(3 * i + 2));
    const auto form = form_of(unite(sphere(3), translate(sphere(kRadius), at)));
    for (const double tolerance : {0.0008, 0.002, 0.005}) {
      RunContext context;
      const auto surface = form->realise({.tolerance = tolerance}, context);
      const Vec3 size = test::box_of(around(surface->proxy().mesh, at, 1)).size();
      EXPECT_GT(std::min({size.x, size.y, size.z}), 0.8 * 2 * kRadius)
          << "ball " << i << ", tolerance " << tolerance;
      EXPECT_EQ(surface->proxy().topology.component_closed.size(), 2u) << "ball " << i;
    }
  }
}

// So many operations that the budgets end before.
TEST(ImplicitSpecks, OfAThousandSomeAreSaidToBeMissing) {
  const ImplicitForm form(make_function(with_many(1000)), {}, RunContext());
  const Found found = test::found_of(form);
  EXPECT_LT(found.components, 1001u);
  EXPECT_TRUE(found.says("implicit.may_miss"));
}

TEST(ImplicitSpecks, WhereAFunctionTellsNoSlopesThatIsSaidInSizesOfThePlace) {
  const Expression e = unite(sphere(10), translate(sphere(0.04), {11.03, 0.07, 0.11}));
  EXPECT_FALSE(find(e).says("implicit.may_miss"));
  const ImplicitForm form(std::make_shared<OnlyValues>(e), {}, RunContext());
  const auto below = [](const Form& f) {
    const Found found = test::found_of(f);
    for (const Diagnostic& d : found.diagnostics.entries()) {
      const std::size_t at = d.message.find("than ");
      if (d.code == "implicit.may_miss") return std::stod(d.message.substr(at + 5));
    }
    return 0.0;
  };
  EXPECT_NEAR(below(form), 2 * 21.47 / 128, 0.01);
  EXPECT_NEAR(below(*form.mapped({.linear = Mat3(10)})), 20 * 21.47 / 128, 0.1);
}

}  // namespace
}  // namespace burin
