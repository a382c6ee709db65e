#include <burin/base/error.h>
#include <burin/base/rng.h>
#include <burin/visibility/occluder.h>

#include <burin_test/shapes.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace burin {
namespace {

ProxyMesh bare(TriMesh mesh) {
  ProxyMesh proxy;
  proxy.mesh = std::move(mesh);
  return proxy;
}

struct Scene {
  explicit Scene(std::vector<TriMesh> meshes) {
    for (TriMesh& m : meshes) proxies.push_back(bare(std::move(m)));
    for (const ProxyMesh& p : proxies) pointers.push_back(&p);
    occluder = std::make_unique<Occluder>(pointers, context);
  }
  RunContext context;
  std::vector<ProxyMesh> proxies;
  std::vector<const ProxyMesh*> pointers;
  std::unique_ptr<Occluder> occluder;
};

constexpr double kFar = std::numeric_limits<double>::infinity();

TEST(Occluder, FindsTheFirstOfTwoBoxes) {
  const Scene s({test::box({0, 0, 0}, {1, 1, 1}), test::box({0, 0, 3}, {1, 1, 4})});
  const auto hit = s.occluder->first_hit({0.3, 0.2, 10}, {0, 0, -1}, 0, kFar);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->where.part, 1);
  EXPECT_NEAR(hit->distance, 6, 1e-14);
  const Triangle& t = s.proxies[1].mesh.triangles[hit->where.face];
  Vec3 p(0);
  for (int k = 0; k < 3; ++k) p += hit->bary[k] * s.proxies[1].mesh.positions[t[k]];
  EXPECT_NEAR(glm::length(p - Vec3(0.3, 0.2, 4)), 0, 1e-14);
}

TEST(Occluder, KeepsNearAndFarExactly) {
  const Scene s({test::box({0, 0, 0}, {1, 1, 1})});
  const Vec3 o{0.3, 0.2, 5}, d{0, 0, -1};
  EXPECT_TRUE(s.occluder->occluded(o, d, 0, 4));
  EXPECT_FALSE(s.occluder->occluded(o, d, 0, 4 - 1e-12));
  EXPECT_FALSE(s.occluder->occluded(o, d, 5 + 1e-12, kFar));
  EXPECT_TRUE(s.occluder->occluded(o, d, 4 + 1e-12, kFar));
  EXPECT_FALSE(s.occluder->occluded(o, -d, 0, kFar));
  EXPECT_FALSE(s.occluder->occluded({1.5, 0.2, 5}, d, 0, kFar));
}

TEST(Occluder, PassesThroughIgnoredTriangles) {
  const Scene s({test::box({0, 0, 0}, {1, 1, 1}), test::box({0, 0, 3}, {1, 1, 4})});
  const Vec3 o{0.3, 0.2, 10}, d{0, 0, -1};
  EXPECT_FALSE(s.occluder->occluded(o, d, 0, kFar, [](FaceRef) { return true; }));
  EXPECT_TRUE(s.occluder->occluded(o, d, 0, 8, [](FaceRef) { return false; }));
  EXPECT_FALSE(s.occluder->occluded(o, d, 0, 8, [](FaceRef f) { return f.part == 1; }));
  EXPECT_TRUE(s.occluder->occluded(o, d, 0, kFar, [](FaceRef f) { return f.part == 1; }));
  std::vector<double> seen;
  EXPECT_FALSE(s.occluder->occluded_by(o, d, 0, kFar, [&](const Hit& h) {
    seen.push_back(h.distance);
    return false;
  }));
  EXPECT_EQ(seen.size(), 4u);
}

TEST(Occluder, AnswersAlikeAtEverySizeAndPlace) {
  const TriMesh ball = test::ellipsoid({1, 1, 1}, 40, 20);
  for (const auto& [scale, shift] : {std::pair{1.0, 0.0}, {1e-3, 0.0}, {1e4, 0.0}, {1.0, 1e5}}) {
    const Vec3 at(shift, -shift, 0.5 * shift);
    const Scene s({test::mapped(ball, [scale = scale, at](Vec3 p) { return p * scale + at; })});
    const Rng rng(7);
    int wrong = 0;
    for (std::uint64_t i = 0; i < 2000; ++i) {
      const double x = 3 * rng.uniform(2 * i) - 1.5, y = 3 * rng.uniform(2 * i + 1) - 1.5;
      const double r = std::hypot(x, y);
      if (std::abs(r - 1) < 0.02) continue;  // between the ball and its 40-gon
      const auto hit = s.occluder->first_hit(Vec3(x, y, 1e3) * scale + at, {0, 0, -1}, 0, kFar);
      const bool occluded = s.occluder->occluded(Vec3(x, y, 1e3) * scale + at, {0, 0, -1}, 0, kFar);
      wrong += occluded != (r < 1) || hit.has_value() != (r < 1);
    }
    EXPECT_EQ(wrong, 0) << scale << ' ' << shift;
  }
}

TEST(Occluder, SeesNoHoleBetweenTriangles) {
  const Scene s({test::torus(3, 1, 90, 45)});
  for (const Vec3& v : s.proxies[0].mesh.positions) {
    const double r = std::hypot(v.x, v.y);
    if (r < 2.2 || r > 3.8) continue;
    EXPECT_TRUE(s.occluder->occluded({v.x, v.y, 5}, {0, 0, -1}, 0, kFar)) << v.x << ' ' << v.y;
  }
}

TEST(Occluder, OwnsNothingInAnEmptyScene) {
  const Scene none({}), bare({TriMesh{}});
  for (const Scene* s : {&none, &bare}) {
    EXPECT_FALSE(s->occluder->occluded({0, 0, 5}, {0, 0, -1}, 0, kFar));
    EXPECT_FALSE(s->occluder->first_hit({0, 0, 5}, {0, 0, -1}, 0, kFar));
    EXPECT_EQ(s->occluder->diagonal(), 0);
  }
}

TEST(Occluder, StopsWhenCancelled) {
  const ProxyMesh ball = bare(test::ellipsoid({1, 1, 1}, 40, 20));
  const ProxyMesh* pointer = &ball;
  RunContext context;
  context.cancel();
  EXPECT_THROW(Occluder(std::span(&pointer, 1), context), Cancelled);
}

TEST(Occluder, ReportsItsSize) {
  const Scene s({test::box({0, 0, 0}, {3, 4, 12})});
  EXPECT_NEAR(s.occluder->diagonal(), 13, 1e-12);
  EXPECT_GT(s.occluder->resolution(), 1e-7);
  EXPECT_LT(s.occluder->resolution(), 1e-5);
}

}  // namespace
}  // namespace burin
