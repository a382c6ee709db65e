#include <burin/base/curve.h>
#include <burin/base/error.h>
#include <burin/base/groups.h>
#include <burin/base/parallel.h>
#include <burin/base/rng.h>
#include <burin/base/run_context.h>
#include <burin/base/short_list.h>
#include <burin/base/vec.h>

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <set>
#include <string>
#include <thread>
#include <vector>

namespace burin {
namespace {

TEST(Vec, OrthogonalIsUnitAndPerpendicularForEveryDirection) {
  const Rng rng(7);
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const Vec3 n = normalize_or(
        Vec3(rng.uniform(3 * i), rng.uniform(3 * i + 1), rng.uniform(3 * i + 2)) - 0.5, {0, 0, -1});
    const Vec3 t = any_orthogonal(n);
    EXPECT_NEAR(glm::dot(n, t), 0, 1e-14);
    EXPECT_NEAR(glm::length(t), 1, 1e-14);
  }
  EXPECT_NEAR(glm::length(any_orthogonal({0, 0, -1})), 1, 1e-15);
}

TEST(Vec, TransportKeepsLengthAndTangency) {
  const Vec3 from(0, 0, 1), to = glm::normalize(Vec3(1, 2, 3));
  const Vec3 v(0.3, -2, 0), w = transport(v, from, to);
  EXPECT_NEAR(glm::length(w), glm::length(v), 1e-14);
  EXPECT_NEAR(glm::dot(w, to), 0, 1e-14);
  EXPECT_EQ(transport(v, from, from), v);
  EXPECT_EQ(transport(v, from, -from), v);
}

TEST(Vec, NormalizeFallsBackOnlyForZeroAndInfinity) {
  EXPECT_EQ(normalize_or(Vec3(0), {1, 0, 0}), Vec3(1, 0, 0));
  EXPECT_EQ(normalize_or(Vec3(0, 1e-200, 0), {1, 0, 0}), Vec3(1, 0, 0));  // its square underflows
  EXPECT_EQ(normalize_or(Vec3(0, 1e-100, 0), {1, 0, 0}), Vec3(0, 1, 0));
  EXPECT_EQ(normalize_or(Vec3(INFINITY, 0, 0), {1, 0, 0}), Vec3(1, 0, 0));
}

TEST(Rng, IsAFunctionOfItsKeyAndCounter) {
  EXPECT_EQ(Rng(1, 2, 3).bits(4), Rng(1, 2, 3).bits(4));
  std::set<std::uint64_t> seen;
  for (std::uint64_t part = 0; part < 10; ++part) {
    for (std::uint64_t face = 0; face < 10; ++face) seen.insert(Rng(1, part, face).bits(0));
  }
  EXPECT_EQ(seen.size(), 100u);
}

TEST(Rng, IsUniformByChiSquare) {
  const Rng rng(42);
  constexpr int kBins = 100, kDraws = 100000;
  std::vector<int> bins(kBins, 0);
  for (int i = 0; i < kDraws; ++i)
    ++bins[static_cast<std::size_t>(rng.uniform(static_cast<std::uint64_t>(i)) * kBins)];
  constexpr double kMean = kDraws / static_cast<double>(kBins);
  double chi = 0;
  for (const int b : bins) chi += std::pow(b - kMean, 2) / kMean;
  // 99 degrees of freedom: 99.9 % of uniform samples lie below 148.
  EXPECT_LT(chi, 148);
}

TEST(RunContext, CountsStagesAndCancels) {
  std::vector<std::string> reports;
  RunContext context([&](const std::string& stage, double) { reports.push_back(stage); });
  context.begin_stage(RunStage::Read);
  context.begin_stage(RunStage::Build);
  context.begin_stage(RunStage::Read);
  context.end_stage();
  ASSERT_EQ(context.stages().size(), 2u);
  EXPECT_EQ(context.stages()[0].stage, RunStage::Read);
  EXPECT_EQ(reports, (std::vector<std::string>{"read", "build", "read"}));
  EXPECT_NO_THROW(context.check());
  context.cancel();
  EXPECT_THROW(context.check(), Cancelled);
  EXPECT_THROW(context.begin_stage(RunStage::Write), Cancelled);
}

TEST(Parallel, RangesDependOnGrainAloneAndCoverAll) {
  for (const int threads : {1, 2, 0}) {
    const ThreadLimit limit(threads);
    std::vector<std::size_t> range(1003, 0);
    parallel_for(range.size(), 100, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) range[i] = begin;
    });
    for (std::size_t i = 0; i < range.size(); ++i) EXPECT_EQ(range[i], i / 100 * 100);
  }
}

TEST(Parallel, PassesExceptionsAndCancellation) {
  EXPECT_THROW(parallel_for(10, 1, [](std::size_t, std::size_t) { throw UsageError("x"); }),
               UsageError);
  RunContext context;
  context.cancel();
  int calls = 0;
  EXPECT_THROW(parallel_for(
                   1, 1, [&](std::size_t, std::size_t) { ++calls; }, &context),
               Cancelled);
  EXPECT_EQ(calls, 0);
}

TEST(Parallel, ALoopBesideOneThatThrowsEndsWhole) {
  for (int repeat = 0; repeat < 20; ++repeat) {
    std::atomic<bool> begun{false};
    std::atomic<std::size_t> ranges{0};
    std::size_t reported = 0;  // when the loop came back as if it were done
    const auto throws = [&] {
      for (int i = 0; i < 1000 && !begun; ++i) {
        std::this_thread::sleep_for(std::chrono::microseconds(100));
      }
      throw UsageError("x");
    };
    const auto counts = [&] {
      parallel_for(200, 1, [&](std::size_t, std::size_t) {
        begun = true;
        std::this_thread::sleep_for(std::chrono::microseconds(20));
        ++ranges;
      });
      reported = ranges;
    };
    EXPECT_THROW(parallel_invoke(throws, counts), UsageError);
    EXPECT_TRUE(reported == 0 || reported == 200) << reported;
  }
}

TEST(Groups, HoldItemsInTheirOrderOnceForEachKey) {
  // Edges of two triangles over the vertices 0 to 3; vertex 4 has none.
  const std::vector<std::array<std::uint32_t, 2>> edges{{2, 0}, {0, 1}, {1, 2}, {2, 3}, {3, 0}};
  const auto at = grouped(
      5, edges.size(), [&](std::size_t e) { return edges[e]; },
      [](std::size_t e) {
        return std::array{10 * static_cast<int>(e), 10 * static_cast<int>(e) + 1};
      });
  ASSERT_EQ(at.size(), 5u);
  const auto list = [&](std::size_t g) { return std::vector<int>(at[g].begin(), at[g].end()); };
  EXPECT_EQ(list(0), (std::vector{1, 10, 41}));
  EXPECT_EQ(list(1), (std::vector{11, 20}));
  EXPECT_EQ(list(2), (std::vector{0, 21, 30}));
  EXPECT_EQ(list(3), (std::vector{31, 40}));
  EXPECT_TRUE(at[4].empty());
  EXPECT_EQ(Groups<int>{}.size(), 0u);
}

TEST(ShortList, NamesTheFirstAndCountsTheRest) {
  const std::vector<std::string> names{"a", "b", "c"};
  EXPECT_EQ(short_list(std::vector<std::string>{}, 2), "");
  EXPECT_EQ(short_list(names, 3), "a, b, c");
  EXPECT_EQ(short_list(names, 2), "a, b and 1 more");
  EXPECT_EQ(short_list(std::set{7, 9}, 1, [](int i) { return std::to_string(i); }), "7 and 1 more");
}

TEST(Curve3, CountsSegments) {
  Curve3 c;
  c.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
  EXPECT_EQ(c.segment_count(), 2u);
  c.closed = true;
  EXPECT_EQ(c.segment_count(), 3u);
  EXPECT_EQ(c.next(2), 0u);
  EXPECT_STREQ(to_string(LineClass::Suggestive), "suggestive");
}

}  // namespace
}  // namespace burin
