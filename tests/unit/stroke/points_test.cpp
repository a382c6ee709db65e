// Strokes that stand on the points of a coverage, as in the paper.
#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/stroke/stroke.h>

#include "burin_test/shapes.h"
#include "burin_test/stroke_stage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>

namespace burin {
namespace {

/// A surface that notes the points that it was covered with.
class Noted final : public Surface {
 public:
  explicit Noted(std::shared_ptr<const Surface> inner) : inner_(std::move(inner)) {}
  std::vector<SurfacePoint> cover(const CoverRequest& request,
                                  const RunContext& context) const override {
    covered = inner_->cover(request, context);
    return covered;
  }
  MarchStep march(const SurfacePoint& from, Vec3 tangent, double length) const override {
    return inner_->march(from, tangent, length);
  }
  Frame frame(const SurfacePoint& point) const override { return inner_->frame(point); }
  const ProxyMesh& proxy() const override { return inner_->proxy(); }
  ProxyPoint to_proxy(const SurfacePoint& point) const override { return inner_->to_proxy(point); }
  SurfacePoint lift(const ProxyPoint& point) const override { return inner_->lift(point); }

  mutable std::vector<SurfacePoint> covered;

 private:
  std::shared_ptr<const Surface> inner_;
};

constexpr double kLength = 3;

struct PointStage : test::StrokeStage {
  explicit PointStage(TriMesh mesh, const char* view = "front")
      : StrokeStage(std::move(mesh), view, 1) {}
};

HatchOptions options_of(const std::string& placing) {
  HatchOptions o;
  o.placing = placing;
  o.length = kLength;
  o.taper = 0;
  o.width_min = o.width_max = 0.3;
  o.tone_min = 0.05;
  return o;
}

TriMesh plate() { return test::box({0, 0, 0}, {60, 5, 40}); }

class OnPoints : public ::testing::TestWithParam<const char*> {};

TEST_P(OnPoints, EachStrokeIsCentredOnAPointOfTheCoverage) {
  std::shared_ptr<const Noted> noted;
  test::StrokeStage stage(plate(), "front", 1, {}, [&](auto surface) {
    return noted = std::make_shared<const Noted>(std::move(surface));
  });
  const StrokeResult r = stage.strokes(field::fixed({0, 0, 1}), 0.7, options_of(GetParam()));
  ASSERT_GT(r.strokes.size(), 300U);
  EXPECT_EQ(r.coverage_points, static_cast<std::int64_t>(r.strokes.size()));
  std::size_t whole = 0;
  for (const Curve3& c : r.strokes) {
    const double low = std::min(c.points.front().z, c.points.back().z);
    const double high = std::max(c.points.front().z, c.points.back().z);
    // Those that reach the border of the face end there.
    if (low < 1e-9 || high > 40 - 1e-9) continue;
    ++whole;
    const Vec3 centre = 0.5 * (c.points.front() + c.points.back());
    EXPECT_TRUE(std::ranges::any_of(noted->covered, [&](const SurfacePoint& p) {
      return glm::distance(p.position, centre) < 1e-9;
    }));
    EXPECT_GE(high - low, 2.0 / 3 * kLength - 1e-9);
    EXPECT_LE(high - low, 4.0 / 3 * kLength + 1e-9);
  }
  EXPECT_GT(whole, r.strokes.size() / 2);
}

// Points follow the face whatever the direction of their strokes.
TEST_P(OnPoints, AsManyAsTheToneAsksForAreSpreadEvenly) {
  PointStage stage(plate());
  const double ink = 0.3;
  const StrokeResult r = stage.strokes(field::fixed({1, 0, 0}), 1 - ink, options_of(GetParam()));
  // Strokes by chance cover 1 - exp(-a - k a^2) where a = n length width (kernel/stroke/README.md).
  const double bare = -std::log(1 - ink);
  const double k = GetParam() == std::string("discs") ? 0.85 * std::sqrt(0.3 / kLength) : 0.04;
  const double wanted = (std::sqrt(1 + 4 * k * bare) - 1) / (2 * k) / (kLength * 0.3) * 60 * 40;
  EXPECT_NEAR(static_cast<double>(r.strokes.size()), wanted, 0.12 * wanted);
  double left = 0;
  for (const Curve3& c : r.strokes) {
    left += 0.5 * (c.points.front().x + c.points.back().x) < 30;
  }
  const auto n = static_cast<double>(r.strokes.size());
  EXPECT_NEAR(left, n / 2, 4 * std::sqrt(n) / 2);
}

TEST_P(OnPoints, ArePlacedAsDenselyWhereverPerspectivePutsThem) {
  // Two plates, one twice as far from the eye: as many strokes a paper mm2 on both.
  TriMesh mesh = test::box({-20, 0, 0}, {0, 2, 40});
  const TriMesh far = test::box({0, 30, 0}, {20, 32, 40});
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), far.positions.begin(), far.positions.end());
  for (Triangle t : far.triangles) {
    for (auto& v : t) v += first;
    mesh.triangles.push_back(t);
  }
  test::StrokeStage stage(std::move(mesh), "front", {}, 50);
  const StrokeResult r = stage.strokes(field::fixed({0, 0, 1}), 0.7, options_of(GetParam()));
  const auto area = [&](double x0, double x1, double y) {
    const Vec2 a = stage.camera.to_paper({x0, y, 0}), b = stage.camera.to_paper({x1, y, 40});
    return std::abs((b.x - a.x) * (b.y - a.y));
  };
  double near_count = 0, far_count = 0;
  for (const Curve3& c : r.strokes) {
    const double y = c.points[c.points.size() / 2].y;
    near_count += std::abs(y) < 1e-6;
    far_count += std::abs(y - 30) < 1e-6;
  }
  const double near_density = near_count / area(-20, 0, 0),
               far_density = far_count / area(0, 20, 30);
  ASSERT_GT(far_count, 50);
  EXPECT_LT(area(0, 20, 30), 0.9 * area(-20, 0, 0));  // else the test shows nothing
  EXPECT_NEAR(far_density / near_density, 1, 5 / std::sqrt(far_count));
}

TEST_P(OnPoints, AreTheSameForAnyNumberOfThreads) {
  const auto run = [](int threads) {
    const ThreadLimit limit(threads);
    PointStage stage(test::torus(20, 8, 64, 32), "iso");
    HatchOptions options = options_of(GetParam());
    options.cross_from = 0.3;
    return stage.strokes(field::principal(), 0.5, options);
  };
  const StrokeResult one = run(1), many = run(0);
  ASSERT_EQ(one.strokes.size(), many.strokes.size());
  int second = 0;
  for (std::size_t i = 0; i < one.strokes.size(); ++i) {
    EXPECT_EQ(one.strokes[i].points, many.strokes[i].points);
    EXPECT_EQ(one.strokes[i].widths, many.strokes[i].widths);
    second += one.strokes[i].family == 2;
  }
  EXPECT_GT(second, 20);
}

TEST_P(OnPoints, FollowTheSeed) {
  PointStage stage(plate());
  const auto field = field::fixed({0, 0, 1});
  const HatchOptions options = options_of(GetParam());
  EXPECT_NE(stage.strokes(field, 0.7, options, 1).strokes.front().points,
            stage.strokes(field, 0.7, options, 2).strokes.front().points);
}

TEST_P(OnPoints, LeaveThePaperWhiteWhereNoInkIsAsked) {
  PointStage stage(plate());
  EXPECT_TRUE(stage.strokes(field::fixed({0, 0, 1}), 0.97, options_of(GetParam())).strokes.empty());
}

TEST_P(OnPoints, RefuseMoreThanMemoryShouldHold) {
  PointStage stage(plate());
  HatchOptions options = options_of(GetParam());
  options.length = 0.1;
  options.width_min = options.width_max = 0.01;
  try {
    (void)stage.strokes(field::fixed({0, 0, 1}), 0.2, options);
    FAIL() << "the strokes were placed";
  } catch (const UsageError& e) {
    EXPECT_NE(std::string(e.what()).find("longer ones (hatch.length)"), std::string::npos)
        << e.what();
  }
}

INSTANTIATE_TEST_SUITE_P(Placings, OnPoints, ::testing::Values("points", "discs"),
                         [](const auto& row) { return std::string(row.param); });

double nearest_neighbour(const StrokeResult& r) {
  std::vector<Vec3> centres;
  for (const Curve3& c : r.strokes) centres.push_back(0.5 * (c.points.front() + c.points.back()));
  double least = 1e9;
  for (std::size_t i = 0; i < centres.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      least = std::min(least, glm::distance(centres[i], centres[j]));
    }
  }
  return least;
}

TEST(OnDiscs, NoTwoAreNearerThanTheToneAsks) {
  PointStage stage(plate());
  HatchOptions options = options_of("discs");
  options.length = 0.1;
  options.width_min = options.width_max = 0.5;
  const auto field = field::fixed({1, 0, 0});
  // Discs of 0.52 over the points a mm2; the borders shorten strokes by a little.
  const double diameter = std::sqrt(0.52 * 0.1 * 0.5 / -std::log(0.9));
  EXPECT_GE(nearest_neighbour(stage.strokes(field, 0.9, options)), 0.9 * diameter);
  options.placing = "points";
  EXPECT_LT(nearest_neighbour(stage.strokes(field, 0.9, options)), 0.3 * diameter);
}

HatchOptions dots() {
  HatchOptions o = options_of("dots");
  o.spacing_min = 0.4;
  o.width_min = 0.2;
  o.width_max = 0.4;
  o.length_min = 0;
  return o;
}

TEST(Dots, NoTwoAreNearerThanTheSpacingAndTheyStandEverywhere) {
  PointStage stage(plate());
  const auto nowhere = Field{"none", [](const FieldQuery&) { return std::optional<Cross>(); }};
  for (const double tone : {0.9, 0.5, 0.1}) {
    const StrokeResult r = stage.strokes(nowhere, tone, dots());
    EXPECT_GE(nearest_neighbour(r), 0.4 - 0.03) << tone;  // a dot is 0.02 long
    // On each square of 5 mm of the plate of 60 x 40 some.
    std::vector<int> count(12 * 8, 0);
    for (const Curve3& c : r.strokes) {
      ASSERT_EQ(c.points.size(), 2u);
      EXPECT_LT(glm::distance(c.points[0], c.points[1]), 0.025);
      EXPECT_EQ(c.widths[0], c.widths[1]);
      EXPECT_GE(c.widths[0], 0.2);
      EXPECT_LE(c.widths[0], 0.4);
      const auto x = static_cast<std::size_t>(std::clamp(c.points[0].x / 5, 0.0, 11.0));
      const auto z = static_cast<std::size_t>(std::clamp(c.points[0].z / 5, 0.0, 7.0));
      ++count[12 * z + x];
    }
    EXPECT_GT(*std::ranges::min_element(count), 10) << tone;
  }
}

// Of the largest dots at the least distance pi / 4 of what such points pack is covered, and less
// where they overlap: a tone that asks for more gets that.
TEST(Dots, AreAsManyAsTheToneAsks) {
  PointStage stage(plate());
  const auto nowhere = Field{"none", [](const FieldQuery&) { return std::optional<Cross>(); }};
  for (const double ink : {0.05, 0.2, 0.4}) {
    const StrokeResult r = stage.strokes(nowhere, 1 - ink, dots());
    double area = 0;
    for (const Curve3& c : r.strokes) area += 0.25 * 3.14159265 * c.widths[0] * c.widths[0];
    const double a = area / (60 * 40);  // overlaps count twice: see Picture::kClear
    EXPECT_NEAR(1 - std::exp(-a - 0.65 * a * a), ink, 0.1 * ink) << ink;
  }
}

TEST(Dots, TheSameForAnyNumberOfThreads) {
  PointStage stage(plate());
  const auto nowhere = Field{"none", [](const FieldQuery&) { return std::optional<Cross>(); }};
  std::vector<StrokeResult> results;
  for (const int threads : {1, 2, 3}) {
    const ThreadLimit limit(threads);
    results.push_back(stage.strokes(nowhere, 0.6, dots()));
  }
  for (const StrokeResult& r : results) {
    ASSERT_EQ(r.strokes.size(), results[0].strokes.size());
    for (std::size_t i = 0; i < r.strokes.size(); ++i) {
      ASSERT_EQ(r.strokes[i].points, results[0].strokes[i].points);
      ASSERT_EQ(r.strokes[i].widths, results[0].strokes[i].widths);
    }
  }
}

TEST(Placings, AnUnknownOneNamesThoseThereAre) {
  PointStage stage(plate());
  HatchOptions options = options_of("rows");
  try {
    (void)stage.strokes(field::fixed({0, 0, 1}), 0.7, options);
    FAIL() << "there is no such placing";
  } catch (const UsageError& e) {
    EXPECT_NE(std::string(e.what()).find("even, points"), std::string::npos) << e.what();
  }
}

}  // namespace
}  // namespace burin
