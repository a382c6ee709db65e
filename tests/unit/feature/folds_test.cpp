// Contours of wide flat facets run along their edges.
#include "burin_test/hulls.h"
#include "feature_support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {
namespace {

/// The corners of the convex polygon around points, anticlockwise.
std::vector<Vec2> around(std::vector<Vec2> points) {
  std::ranges::sort(points, [](Vec2 a, Vec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  std::vector<Vec2> out;
  for (int side = 0; side < 2; ++side) {
    const std::size_t first = out.size();
    for (const Vec2& p : points) {
      while (out.size() >= first + 2 &&
             cross2(out.back() - out[out.size() - 2], p - out.back()) <= 0) {
        out.pop_back();
      }
      out.push_back(p);
    }
    out.pop_back();
    std::ranges::reverse(points);
  }
  return out;
}

/// How far inside the polygon a point lies; negative outside.
double depth(const std::vector<Vec2>& polygon, Vec2 p) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i], along = polygon[(i + 1) % polygon.size()] - a;
    least = std::min(least, cross2(along, p - a) / glm::length(along));
  }
  return least;
}

// The contour of a convex body is the border of its picture. The faces between plate and disc bend
// by less than the crease angle, over 20 mm and more.
TEST(Folds, TheContourOfAHullIsTheBorderOfItsPicture) {
  for (const std::uint32_t sides : {8u, 12u, 32u}) {
    for (const Vec3 view :
         {Vec3(1, -1, 0.8), Vec3(0.3, 1, 0.5), Vec3(1, -2, 1), Vec3(-4, -10, 5)}) {
      const test::Looked looked({test::hull({.radius = 10, .sides = sides})},
                                {.direction = view, .scale = 3});
      std::vector<Vec2> points;
      for (const Vec3& p : looked.proxies[0].mesh.positions) {
        points.push_back(looked.camera.to_paper(p));
      }
      const std::vector<Vec2> border = around(std::move(points));
      double least = 0, most = 0;
      for (const Curve3& c : looked.of(LineClass::Contour)) {
        for (const Vec3& p : c.points) {
          const double inside = depth(border, looked.camera.to_paper(p));
          least = std::min(least, inside), most = std::max(most, inside);
        }
      }
      EXPECT_LT(most, 0.2) << sides << " sides";    // mm of paper
      EXPECT_GT(least, -0.3) << sides << " sides";  // rims are round over their chords
    }
  }
}

}  // namespace
}  // namespace burin
