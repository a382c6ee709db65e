#include <burin/base/parallel.h>
#include <burin/base/rng.h>
#include <burin/repair/weld.h>

#include <gtest/gtest.h>

#include <map>
#include <tuple>

namespace burin {
namespace {

TEST(Weld, NumbersVerticesByFirstAppearance) {
  const RunContext context;
  const std::vector<Vec3> points = {{1, 2, 3}, {0, 0, 0}, {1, 2, 3}, {5, 5, 5}, {-0.0, 0, -0.0}};
  const Weld w = weld(points, context);
  EXPECT_EQ(w.vertex, (std::vector<std::uint32_t>{0, 1, 0, 2, 1}));
  EXPECT_EQ(w.first, (std::vector<std::uint32_t>{0, 1, 3}));
}

TEST(Weld, JoinsOnlyExactlyEqualPoints) {
  const RunContext context;
  const double next = std::nextafter(1.0, 2.0);
  const std::vector<Vec3> points = {{1, 0, 0}, {next, 0, 0}, {1, 0, 1e-300}};
  EXPECT_EQ(weld(points, context).first.size(), 3u);
}

TEST(Weld, HandlesNothing) {
  const RunContext context;
  const Weld w = weld(std::vector<Vec3>{}, context);
  EXPECT_TRUE(w.vertex.empty());
  EXPECT_TRUE(w.first.empty());
}

TEST(Weld, AgreesWithAMapOnManyPointsForAnyNumberOfThreads) {
  constexpr std::size_t kPoints = 300'000;
  const Rng rng(7);
  std::vector<std::array<float, 3>> points(kPoints);
  for (std::size_t i = 0; i < kPoints; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      points[i][k] = static_cast<float>(static_cast<int>(rng.uniform(3 * i + k) * 40) - 20);
    }
  }
  std::map<std::array<float, 3>, std::uint32_t> expected;
  std::vector<std::uint32_t> vertex;
  for (const auto& p : points) {
    vertex.push_back(
        expected.try_emplace(p, static_cast<std::uint32_t>(expected.size())).first->second);
  }
  const RunContext context;
  for (const int threads : {1, 2}) {
    const ThreadLimit limit(threads);
    const Weld w = weld(points, context);
    EXPECT_EQ(w.vertex, vertex);
    ASSERT_EQ(w.first.size(), expected.size());
    for (std::uint32_t v = 0; v < w.first.size(); ++v) EXPECT_EQ(vertex[w.first[v]], v);
  }
}

}  // namespace
}  // namespace burin
