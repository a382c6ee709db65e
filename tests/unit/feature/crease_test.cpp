// Creases and the contours that run on them.

#include "feature_support.h"

#include <gtest/gtest.h>

#include <map>
#include <tuple>

namespace burin::test {
namespace {

TriMesh unit_box() { return box({0, 0, 0}, {1, 2, 3}); }

TEST(Crease, BoxFromACorner) {
  const Looked s({unit_box()}, {.direction = {1, -1, 1}});
  ASSERT_EQ(s.curves.size(), 12u);
  std::map<std::tuple<double, double, double>, int> hexagon;
  int front = 0, back = 0;
  std::vector<std::int32_t> numbers;
  for (const Curve3& c : s.curves) {
    EXPECT_EQ(c.crease_sign, 1);
    EXPECT_FALSE(c.closed);
    EXPECT_EQ(c.segment_count(), 1u);
    numbers.push_back(c.source.edge);
    for (std::size_t i = 0; i < 2; ++i) {  // outside the box
      const Vec3 centre(0.5, 1, 1.5);
      EXPECT_NEAR(glm::length(c.normals[i]), 1, 1e-12);
      EXPECT_GT(glm::dot(c.normals[i], c.points[i] - centre), 0);
    }
    if (c.kind == LineClass::Contour) {
      EXPECT_TRUE(c.occluding);
      EXPECT_TRUE(none_hidden(c));
      for (const Vec3& p : c.points) ++hexagon[{p.x, p.y, p.z}];
      // The named face is the one turned to the viewer.
      const Vec3 n = s.proxies[0].mesh.normal(static_cast<std::uint32_t>(c.faces[0]));
      EXPECT_GT(glm::dot(n, s.camera.direction()), 0);
      EXPECT_EQ(c.source.face, s.proxies[0].face_region[static_cast<std::size_t>(c.faces[0])]);
    } else {
      EXPECT_EQ(c.kind, LineClass::Crease);
      EXPECT_FALSE(c.occluding);
      (all_hidden(c) ? back : front) += 1;
    }
  }
  EXPECT_EQ(front, 3);
  EXPECT_EQ(back, 3);
  EXPECT_EQ(hexagon.size(), 6u);
  for (const auto& [point, count] : hexagon) EXPECT_EQ(count, 2);
  std::ranges::sort(numbers);
  for (std::int32_t i = 0; i < 12; ++i) EXPECT_EQ(numbers[static_cast<std::size_t>(i)], i);
}

TEST(Crease, EdgeNumbersAreTheSameInEveryView) {
  const auto number_of = [](const Looked& s, Vec3 a, Vec3 b) {
    for (const Curve3& c : s.curves) {
      if ((c.points.front() == a && c.points.back() == b) ||
          (c.points.front() == b && c.points.back() == a)) {
        return c.source.edge;
      }
    }
    return -2;
  };
  const Looked one({unit_box()}, {.direction = {1, -1, 1}});
  const Looked other({unit_box()}, {.direction = {-0.2, 0.7, -1}});
  for (const auto& [a, b] :
       {std::pair(Vec3(0, 0, 0), Vec3(1, 0, 0)), std::pair(Vec3(1, 2, 0), Vec3(1, 2, 3))}) {
    EXPECT_GE(number_of(one, a, b), 0);
    EXPECT_EQ(number_of(one, a, b), number_of(other, a, b));
  }
}

TEST(Crease, BoxFromTheFrontIsOneRectangle) {
  for (const auto& perspective : {std::optional<double>(), std::optional<double>(40)}) {
    const Looked s({unit_box()}, {.direction = {0, -1, 0}, .perspective = perspective});
    double drawn = 0;
    for (const Curve3& c : s.curves) {
      if (c.kind != LineClass::Contour) {
        EXPECT_TRUE(all_hidden(c));
        continue;
      }
      for (const Vec3& p : c.points) EXPECT_EQ(p.y, 0);
      drawn += open_length(s.camera, c);
    }
    EXPECT_EQ(s.of(LineClass::Contour).size(), 4u);
    EXPECT_NEAR(drawn, 2 * (1 + 3) * s.camera.scale_at({0.5, 0, 1.5}), 1e-9 * drawn);
  }
}

TEST(Crease, CylinderFromACorner) {
  const std::uint32_t n = 48;
  const double r = 10, h = 30;
  const Looked s({cylinder(r, h, n)}, {.direction = {1, -1, 1}});
  std::vector<Curve3> straight, rims;
  for (const Curve3& c : s.curves) (c.source.edge < 0 ? straight : rims).push_back(c);
  ASSERT_EQ(straight.size(), 2u);
  const double sagitta = r * (1 - std::cos(kPi / n));
  for (const Curve3& c : straight) {
    EXPECT_EQ(c.kind, LineClass::Contour);
    EXPECT_TRUE(none_hidden(c));
    EXPECT_NEAR(length(c), h, 1e-6 * h);
    for (const Vec3& p : c.points) {  // where the normal is at a right angle to the view
      EXPECT_NEAR(p.x * 1 + p.y * -1, 0, 0.02 * r);
      EXPECT_NEAR(std::hypot(p.x, p.y), r, 2 * sagitta);
      EXPECT_NEAR(p.x, c.points.front().x, 1e-9 * r);
    }
    // Either end lies on a rim and is the end of exactly one contour and one crease there.
    for (const Vec3& p : {c.points.front(), c.points.back()}) {
      EXPECT_EQ(ends_at(s.of(LineClass::Contour), p), 2);
      EXPECT_EQ(ends_at(s.of(LineClass::Crease), p), 1);
    }
  }
  ASSERT_EQ(rims.size(), 4u);
  for (const Curve3& c : rims) {
    const bool top = c.points.front().z > h / 2;
    EXPECT_EQ(all_hidden(c), !top && c.kind == LineClass::Crease);
    EXPECT_NEAR(length(c), kPi * r, 0.01 * r);
    for (const Vec3& p : c.points) {
      const double toward = glm::dot(p, Vec3(1, -1, 0));
      const bool near =
          (top && c.kind == LineClass::Crease) || (!top && c.kind == LineClass::Contour);
      EXPECT_GE(near ? toward : -toward, -0.02 * r);
    }
  }
}

TEST(Crease, CylinderAlongItsAxisIsOneCircle) {
  for (const auto& perspective : {std::optional<double>(), std::optional<double>(40)}) {
    const Looked s({cylinder(10, 30, 48)}, {.direction = {0, 0, 1}, .perspective = perspective});
    const auto contours = s.of(LineClass::Contour);
    ASSERT_EQ(contours.size(), 1u);
    EXPECT_TRUE(contours[0].closed);
    EXPECT_EQ(contours[0].points.size(), 48u);
    for (const Vec3& p : contours[0].points) EXPECT_EQ(p.z, 30);
    for (const Curve3& c : s.of(LineClass::Crease)) EXPECT_TRUE(all_hidden(c));
  }
}

TEST(Crease, CylinderFromTheFrontIsOneRectangle) {
  const Looked s({cylinder(10, 30, 48)}, {.direction = {0, -1, 0}, .up = {0, 0, 1}});
  double drawn = 0;
  for (const Curve3& c : s.curves) {
    if (c.kind == LineClass::Contour) {
      drawn += open_length(s.camera, c);
    } else {
      EXPECT_TRUE(all_hidden(c));
    }
  }
  EXPECT_NEAR(drawn, 2 * (20 + 30) * s.camera.scale(), 0.01 * drawn);
}

TEST(Crease, HollowIsConcaveAndHidesItsFolds) {
  // A step: floor and wall meet in a hollow at x = 0, z = 0.
  TriMesh step = joined({}, {});
  const std::vector<Vec2> profile{{-2, -1}, {2, -1}, {2, 0}, {0, 0}, {0, 2}, {-2, 2}};
  for (const Vec2& p : profile) {
    step.positions.push_back({p.x, 0, p.y});
    step.positions.push_back({p.x, 5, p.y});
  }
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t a = 2 * i, b = 2 * ((i + 1) % 6);
    step.triangles.push_back({a, b, b + 1});
    step.triangles.push_back({a, b + 1, a + 1});
  }
  // Caps: the L as a fan about its inner corner (index 3), which sees all of it.
  for (const std::uint32_t i : {4u, 5u, 0u, 1u}) {
    const std::uint32_t j = (i + 1) % 6;
    step.triangles.push_back({6, 2 * j, 2 * i});
    step.triangles.push_back({7, 2 * i + 1, 2 * j + 1});
  }
  for (Triangle& t : step.triangles) std::swap(t[1], t[2]);
  const auto hollow = [](const Looked& s) {
    for (const Curve3& c : s.curves) {
      if (c.crease_sign == -1) return c;
    }
    return Curve3{};
  };
  const Curve3 seen = hollow(Looked({step}, {.direction = {1, -1, 1}}));
  ASSERT_EQ(seen.points.size(), 2u);
  EXPECT_EQ(seen.kind, LineClass::Crease);
  EXPECT_TRUE(none_hidden(seen));
  EXPECT_NEAR(glm::length(seen.normals[0] - glm::normalize(Vec3(1, 0, 1))), 0, 1e-12);
  // From behind the wall the floor is turned to the viewer and the wall away: it covers the hollow.
  const Curve3 fold = hollow(Looked({step}, {.direction = {-1, -0.2, 1}}));
  EXPECT_EQ(fold.kind, LineClass::Contour);
  EXPECT_TRUE(all_hidden(fold));
  // From straight above the wall is edge-on: its upper edge is the line, not the hollow below it.
  EXPECT_TRUE(all_hidden(hollow(Looked({step}, {.direction = {0, 0, 1}}))));
}

TEST(Crease, FilletedWallSeenEdgeOnIsOneLine) {
  // A bar with rounded long edges, seen along the direction in which two of its walls lie edge-on:
  // the wall's normals lean to the fillets, but the outline is one closed line.
  std::vector<Vec2> profile;
  const std::uint32_t arc = 8;
  for (std::uint32_t corner = 0; corner < 4; ++corner) {
    const Vec2 centre((corner == 0 || corner == 3) ? 8 : -8, corner < 2 ? 4 : -4);
    for (std::uint32_t k = 0; k <= arc; ++k) {
      const double a = kPi / 2 * (corner + static_cast<double>(k) / arc);
      profile.push_back(centre + 2.0 * Vec2(std::cos(a), std::sin(a)));
    }
  }
  const auto n = static_cast<std::uint32_t>(profile.size());
  TriMesh bar;
  for (const Vec2& p : profile) {
    bar.positions.push_back({p.x, p.y, 0});
    bar.positions.push_back({p.x, p.y, 40});
  }
  bar.positions.push_back({0, 0, 0});
  bar.positions.push_back({0, 0, 40});
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t a = 2 * i, b = 2 * ((i + 1) % n);
    bar.triangles.push_back({a, b, b + 1});
    bar.triangles.push_back({a, b + 1, a + 1});
    bar.triangles.push_back({2 * n, b, a});
    bar.triangles.push_back({2 * n + 1, a + 1, b + 1});
  }
  const Looked s({bar}, {.direction = {0, -1, 0}});
  double drawn = 0;
  for (const Curve3& c : s.curves) drawn += open_length(s.camera, c);
  EXPECT_NEAR(drawn, 2 * (20 + 40) * s.camera.scale(), 0.001 * drawn);
}

}  // namespace
}  // namespace burin::test
