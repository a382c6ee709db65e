#include <burin/base/error.h>
#include <burin/base/rng.h>
#include <burin/visibility/occluder.h>

#include <burin_test/shapes.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace burin {
namespace {

ProxyMesh bare(TriMesh mesh) {
  ProxyMesh proxy;
  proxy.mesh = std::move(mesh);
  return proxy;
}

struct OccludedScene {
  explicit OccludedScene(std::vector<TriMesh> meshes, const OccluderOptions& options = {}) {
    for (TriMesh& m : meshes) proxies.push_back(bare(std::move(m)));
    for (const ProxyMesh& p : proxies) pointers.push_back(&p);
    occluder = std::make_unique<Occluder>(pointers, context, options);
  }
  RunContext context;
  std::vector<ProxyMesh> proxies;
  std::vector<const ProxyMesh*> pointers;
  std::unique_ptr<Occluder> occluder;
};

constexpr double kFar = std::numeric_limits<double>::infinity();

TEST(Occluder, FindsTheFirstOfTwoBoxes) {
  const OccludedScene s({test::box({0, 0, 0}, {1, 1, 1}), test::box({0, 0, 3}, {1, 1, 4})});
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
  const OccludedScene s({test::box({0, 0, 0}, {1, 1, 1})});
  const Vec3 o{0.3, 0.2, 5}, d{0, 0, -1};
  EXPECT_TRUE(s.occluder->occluded(o, d, 0, 4));
  EXPECT_FALSE(s.occluder->occluded(o, d, 0, 4 - 1e-12));
  EXPECT_FALSE(s.occluder->occluded(o, d, 5 + 1e-12, kFar));
  EXPECT_TRUE(s.occluder->occluded(o, d, 4 + 1e-12, kFar));
  EXPECT_FALSE(s.occluder->occluded(o, -d, 0, kFar));
  EXPECT_FALSE(s.occluder->occluded({1.5, 0.2, 5}, d, 0, kFar));
}

TEST(Occluder, PassesThroughIgnoredTriangles) {
  const OccludedScene s({test::box({0, 0, 0}, {1, 1, 1}), test::box({0, 0, 3}, {1, 1, 4})});
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
    const OccludedScene s(
        {test::mapped(ball, [scale = scale, at](Vec3 p) { return p * scale + at; })});
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
  const OccludedScene s({test::torus(3, 1, 90, 45)});
  for (const Vec3& v : s.proxies[0].mesh.positions) {
    const double r = std::hypot(v.x, v.y);
    if (r < 2.2 || r > 3.8) continue;
    EXPECT_TRUE(s.occluder->occluded({v.x, v.y, 5}, {0, 0, -1}, 0, kFar)) << v.x << ' ' << v.y;
  }
}

// The kinds of Embree's code that run here; the plain one first.
std::vector<OccluderOptions> kinds() {
  std::vector<OccluderOptions> all{{"isa=sse2"}};
  if (__builtin_cpu_supports("sse4.2")) all.push_back({"isa=sse4.2"});
  if (__builtin_cpu_supports("avx")) all.push_back({"isa=avx"});
  if (__builtin_cpu_supports("avx2")) all.push_back({"isa=avx2"});
  if (__builtin_cpu_supports("avx512vl")) all.push_back({"isa=avx512"});
  return all;
}

using Name = std::pair<std::int32_t, std::uint32_t>;

Name name(const Hit& hit) { return {hit.where.part, hit.where.face}; }

// All that a ray meets.
std::map<Name, double> all_hits(const Occluder& occluder, Vec3 origin, Vec3 direction) {
  std::map<Name, double> all;
  occluder.occluded_by(origin, direction, 0, kFar, [&](const Hit& hit) {
    all[name(hit)] = hit.distance;
    return false;
  });
  return all;
}

Vec3 random_direction(const Rng& rng, std::uint64_t i) {
  const double z = 2 * rng.uniform(2 * i) - 1, angle = 2 * test::kPi * rng.uniform(2 * i + 1);
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

// Rays at corners, at edges and into triangles, some along an axis, from near and far.
struct Aim {
  Vec3 origin, direction, target;
  Name into{-1, 0};  // the triangle within whose inside it aims
};
std::vector<Aim> aims(const OccludedScene& s) {
  std::vector<Aim> all;
  const Rng rng(11);
  std::uint64_t i = 0;
  for (std::size_t part = 0; part < s.proxies.size(); ++part) {
    const TriMesh& mesh = s.proxies[part].mesh;
    for (std::uint32_t face = 0; face < mesh.triangles.size(); ++face, ++i) {
      const Triangle& t = mesh.triangles[face];
      const Vec3 a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
      Vec3 direction = random_direction(rng, 5 * i);
      if (i % 5 == 0) direction = {0, i % 2 == 0 ? 1 : -1, 0};
      const double far = s.occluder->diagonal() * std::pow(1e3, 2 * rng.uniform(10 * i + 3) - 1);
      const double u = rng.uniform(10 * i + 4), v = (1 - u) * rng.uniform(10 * i + 5);
      const Vec3 inside = a + u * (b - a) + v * (c - a);
      const bool well = std::min({u, v, 1 - u - v}) > 1e-4 &&
                        std::abs(glm::dot(mesh.normal(face), direction)) > 1e-4;
      for (const Vec3 at : {a, 0.5 * (a + b), inside}) {
        const bool in = well && at == inside;
        all.push_back({at - far * direction, direction, at,
                       in ? Name{static_cast<std::int32_t>(part), face} : Name{-1, 0}});
      }
    }
  }
  return all;
}

std::vector<TriMesh> crowd() {
  // The same ball twice, a box whose sides lie on another's, a torus through them.
  return {test::ellipsoid({1, 1, 1}, 40, 20), test::ellipsoid({1, 1, 1}, 40, 20),
          test::box({0, 0, 0}, {1, 1, 1}), test::box({1, 0, 0}, {2, 1, 1}),
          test::torus(2, 0.5, 60, 30)};
}

TEST(Occluder, AnswersAlikeWithEmbreesCodeForEveryProcessor) {
  std::vector<std::unique_ptr<OccludedScene>> scenes;
  for (const OccluderOptions& kind : kinds()) {
    scenes.push_back(std::make_unique<OccludedScene>(crowd(), kind));
  }
  for (const Aim& aim : aims(*scenes.front())) {
    const auto expected = all_hits(*scenes.front()->occluder, aim.origin, aim.direction);
    const auto first = scenes.front()->occluder->first_hit(aim.origin, aim.direction, 0, kFar);
    for (const auto& s : scenes) {
      ASSERT_EQ(all_hits(*s->occluder, aim.origin, aim.direction), expected);
      const auto hit = s->occluder->first_hit(aim.origin, aim.direction, 0, kFar);
      ASSERT_EQ(hit.has_value(), first.has_value());
      if (!hit) continue;
      ASSERT_EQ(name(*hit), name(*first));
      ASSERT_EQ(hit->distance, first->distance);
      ASSERT_EQ(hit->bary, first->bary);
    }
  }
}

TEST(Occluder, MissesNoTriangleThatARayAimsAt) {
  for (const OccluderOptions& kind : kinds()) {
    for (const double scale : {1.0, 1e-3, 1e4}) {
      std::vector<TriMesh> meshes = crowd();
      for (TriMesh& mesh : meshes) {
        mesh = test::mapped(mesh, [&](Vec3 p) { return p * scale + Vec3(30 * scale); });
      }
      const OccludedScene s(std::move(meshes), kind);
      int missed = 0, aimed = 0;
      for (const Aim& aim : aims(s)) {
        if (aim.into.first < 0) continue;
        ++aimed;
        const auto hits = all_hits(*s.occluder, aim.origin, aim.direction);
        const auto hit = hits.find(aim.into);
        missed +=
            hit == hits.end() || std::abs(hit->second - glm::distance(aim.origin, aim.target)) >
                                     1e-9 * s.occluder->diagonal();
      }
      EXPECT_GT(aimed, 3000);
      EXPECT_EQ(missed, 0) << kind.embree << ' ' << scale;
    }
  }
}

TEST(Occluder, GivesTiesToTheLowestPartAndTriangle) {
  for (const OccluderOptions& kind : kinds()) {
    const OccludedScene s(crowd(), kind);
    int ties = 0;
    for (const Aim& aim : aims(s)) {
      const auto hit = s.occluder->first_hit(aim.origin, aim.direction, 0, kFar);
      const auto all = all_hits(*s.occluder, aim.origin, aim.direction);
      ASSERT_EQ(hit.has_value(), !all.empty());
      if (!hit) continue;
      double nearest = kFar;
      for (const auto& [name, distance] : all) nearest = std::min(nearest, distance);
      const auto in_reach = [&](const auto& entry) {
        return entry.second <= nearest + 1e-10 * s.occluder->diagonal();
      };
      EXPECT_EQ(name(*hit), std::find_if(all.begin(), all.end(), in_reach)->first);
      ties += std::count_if(all.begin(), all.end(), in_reach) > 1;
    }
    EXPECT_GT(ties, 1000);
  }
}

TEST(Occluder, MeetsEdgesWithinTheToleranceAndNoWallThatIsSeenEdgeOn) {
  // An open sheet of two triangles; its wall stands along the view.
  TriMesh sheet;
  sheet.positions = {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}};
  sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
  const OccludedScene s({sheet});
  const auto meets = [&](Vec3 origin, Vec3 direction) {
    return s.occluder->occluded(origin, direction, 0, kFar);
  };
  const Vec3 across(0, 1, 0);
  EXPECT_TRUE(meets({1 + 1e-12, -2, 0.3}, across));  // but for rounding on its edge
  EXPECT_FALSE(meets({1 + 1e-8, -2, 0.3}, across));  // beside it
  EXPECT_TRUE(meets({0.4, -2, 0.4}, across));        // through the edge of both triangles
  EXPECT_FALSE(meets({0.4, 0, 5}, {0, 0, -1}));      // in its plane
  EXPECT_FALSE(meets({0.4, 1e-12, 5}, {0, 0, -1}));  // all but in it
  const auto hit = s.occluder->first_hit({0.4, -2, 0.4}, across, 0, kFar);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->where.face, 0u);
  const auto beside = s.occluder->first_hit({1 + 1e-12, -2, 0.3}, across, 0, kFar);
  ASSERT_TRUE(beside);
  EXPECT_GE(std::min({beside->bary.x, beside->bary.y, beside->bary.z}), 0);
}

TEST(Occluder, OfPartsThatLieOnEachOtherThatOfTheHighestRankComesFirst) {
  // Two plates flush in a third, two triangles of each on the line of sight.
  const TriMesh plate = test::box({-2, -2, 0}, {2, 2, 1}), in = test::box({-1, -1, 0.5}, {1, 1, 1});
  const auto seen = [&](std::vector<double> ranks, Vec2 at = {0, 0}) {
    const OccludedScene s({plate, in, in}, {.ranks = std::move(ranks)});
    const auto hit = s.occluder->first_hit({at, 5}, {0, 0, -1}, 0, kFar);
    const auto same = s.occluder->first_hit({at, 1}, {0, 0, -1}, 0, kFar);
    EXPECT_EQ(name(*hit), name(*same));
    return hit->where.part;
  };
  EXPECT_EQ(seen({}), 0);
  EXPECT_EQ(seen({1, 1, 1}), 0);
  EXPECT_EQ(seen({0, 1, 1}), 1);
  EXPECT_EQ(seen({0, 1, 2}), 2);
  EXPECT_EQ(seen({-1}), 1) << "others have 0";
  EXPECT_EQ(seen({0, 1, 2}, {1.5, 0}), 0) << "alone there";
  const OccludedScene s({plate, test::box({-1, -1, 0}, {1, 1, 1 - 1e-6})}, {.ranks = {0, 1}});
  EXPECT_EQ(s.occluder->first_hit({0, 0, 5}, {0, 0, -1}, 0, kFar)->where.part, 0)
      << "clearly behind";
}

TEST(Occluder, OwnsNothingInAnEmptyScene) {
  const OccludedScene none({}), bare({TriMesh{}});
  for (const OccludedScene* s : {&none, &bare}) {
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
  const OccludedScene s({test::box({0, 0, 0}, {3, 4, 12})});
  EXPECT_NEAR(s.occluder->diagonal(), 13, 1e-12);
  EXPECT_GT(s.occluder->resolution(), 1e-7);
  EXPECT_LT(s.occluder->resolution(), 1e-5);
}

}  // namespace
}  // namespace burin
