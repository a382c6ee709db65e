// Strokes tell nothing of the parameters of the surface that they stand on. @cite Elber1998 (figure
// 4)
#include <burin/forms/charted/nurbs.h>
#include <burin/forms/patches/parametric_form.h>
#include <burin/illustrate/illustrate.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <numbers>
#include <vector>

namespace burin {
namespace {

constexpr double kRadiusOfDisc = 20;

// A disc, its parameters about the middle, where du and dv turn and vanish.
Vec3 polar(Vec2 uv) { return kRadiusOfDisc * uv.x * Vec3(std::cos(uv.y), std::sin(uv.y), 0); }
// The same disc as a square pressed into it: area gathers in the middle of the square.
Vec3 square(Vec2 uv) {
  return kRadiusOfDisc *
         Vec3(uv.x * std::sqrt(1 - uv.y * uv.y / 2), uv.y * std::sqrt(1 - uv.x * uv.x / 2), 0);
}

// What is seen of strokes: where their middles are, how long, how wide, and which way they run.
struct Strokes {
  std::vector<Vec2> middle;
  std::vector<double> length, width, angle;
};

Strokes strokes_on(const std::shared_ptr<const Chart>& chart, std::uint64_t seed) {
  Scene scene;
  scene.parts.push_back(
      {"disc", "",
       std::make_shared<ParametricForm>(std::vector<std::shared_ptr<const Chart>>{chart})});
  Style style = builtin_style("engraving");
  style.hatch.placing = "points";
  style.hatch.cross_from = 2;
  style.hatch.field.name = "planes";
  style.hatch.field.direction = {1, 2, 0};
  style.hatch.length = 1.5;
  style.hatch.length_min = 0;
  style.hatch.width_law = "0.4 + random";
  style.hatch.length_law = "0.5 + random";
  style.hatch.presence_law = "0.7";
  style.tone = {.law = "constant", .ambient = 0.75, .highlight = 1, .rim = 0};
  RunContext context;
  const NamedView v = named_view("top");
  const Camera camera = Camera::fit([&](const Mat3& axes) { return scene.bounds(axes); },
                                    {.direction = v.direction, .up = v.up, .paper = {100, 100}});
  const Drawing drawing = illustrate(scene, camera, style, {.seed = seed}, context);
  Strokes out;
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      if (path.kind != LineClass::Stroke) continue;
      const Vec3 a = path.points3.front(), b = path.points3.back();
      const Vec3 middle = 0.5 * (a + b);
      if (std::hypot(middle.x, middle.y) > 0.95 * kRadiusOfDisc) continue;  // cut at the border
      out.middle.emplace_back(middle.x, middle.y);
      out.length.push_back(glm::distance(a, b));
      out.width.push_back(*std::ranges::max_element(path.width));
      const double angle = std::atan2(b.y - a.y, b.x - a.x);
      out.angle.push_back(std::remainder(angle, std::numbers::pi));
    }
  }
  return out;
}

// Rings and sectors of one area.
constexpr std::size_t kRings = 8, kSectors = 12;
std::array<double, kRings * kSectors> counted_in_sectors(const std::vector<Vec2>& points) {
  std::array<double, kRings * kSectors> count{};
  for (const Vec2& p : points) {
    const double share = glm::dot(p, p) / (0.95 * 0.95 * kRadiusOfDisc * kRadiusOfDisc);
    const double turn = (std::atan2(p.y, p.x) + std::numbers::pi) / (2 * std::numbers::pi);
    const auto ring = std::min(kRings - 1, static_cast<std::size_t>(kRings * share));
    const auto sector = std::min(kSectors - 1, static_cast<std::size_t>(kSectors * turn));
    ++count[ring * kSectors + sector];
  }
  return count;
}

// The largest distance of two empirical distributions, in units of what chance gives
// (Kolmogorov and Smirnov): over 1.95 in one of 1,000 pairs that are the same.
double apart(std::vector<double> a, std::vector<double> b) {
  std::ranges::sort(a);
  std::ranges::sort(b);
  const auto n = static_cast<double>(a.size()), m = static_cast<double>(b.size());
  double most = 0;
  for (const double x : a) {
    const auto upto = [x](const std::vector<double>& s) {
      return static_cast<double>(std::ranges::upper_bound(s, x + 1e-9) - s.begin());
    };
    most = std::max(most, std::abs(upto(a) / n - upto(b) / m));
  }
  return most * std::sqrt(n * m / (n + m));
}

TEST(Parameters, OfADiscDoNotShowInItsStrokes) {
  const FunctionChartOptions round{{{0, 0}, {1, 2 * std::numbers::pi}}, {0, 2 * std::numbers::pi}};
  const FunctionChartOptions pressed{{{-1, -1}, {1, 1}}, {0, 0}};
  const Strokes a = strokes_on(make_function_chart(std::function<Vec3(Vec2)>(polar), round), 7);
  const Strokes b = strokes_on(make_function_chart(std::function<Vec3(Vec2)>(square), pressed), 8);
  const auto n = static_cast<double>(a.length.size()), m = static_cast<double>(b.length.size());
  ASSERT_GT(n, 1000);
  EXPECT_NEAR(n, m, 4 * std::sqrt(n + m));
  // Densities: chi-square of two samples, within four standard deviations of its mean.
  const auto of_a = counted_in_sectors(a.middle), of_b = counted_in_sectors(b.middle);
  double chi = 0;
  for (std::size_t i = 0; i < of_a.size(); ++i) {
    const double off = std::sqrt(m / n) * of_a[i] - std::sqrt(n / m) * of_b[i];
    chi += off * off / std::max(1.0, of_a[i] + of_b[i]);
  }
  const double freedom = kRings * kSectors - 1;
  EXPECT_LT(chi, freedom + 4 * std::sqrt(2 * freedom));
  EXPECT_LT(apart(a.length, b.length), 1.95);
  EXPECT_LT(apart(a.width, b.width), 1.95);
  // Directions: those of the planes.
  const double along = std::remainder(std::atan2(-1.0, 2.0), std::numbers::pi);
  for (const Strokes* s : {&a, &b}) {
    for (const double angle : s->angle) EXPECT_NEAR(angle, along, 0.002);
  }
  ::testing::Test::RecordProperty("chi_square", std::to_string(chi));
  ::testing::Test::RecordProperty("strokes", std::to_string(a.length.size()));
}

}  // namespace
}  // namespace burin
