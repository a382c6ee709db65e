// The same part drawn at another size, place and turn has the same features.

#include "feature_support.h"

#include <gtest/gtest.h>

namespace burin::test {
namespace {

std::vector<TriMesh> parts() {
  return {torus(3, 1, 120, 60),
          mapped(cylinder(1.5, 6, 60), [](Vec3 p) { return p + Vec3(2.9, 0.3, -3.1); }),
          mapped(box({0, 0, 0}, {2, 2, 2}), [](Vec3 p) { return p + Vec3(-4.3, -4.1, -1.2); })};
}

std::vector<TriMesh> moved(const std::function<Vec3(Vec3)>& f) {
  std::vector<TriMesh> out = parts();
  for (TriMesh& m : out) m = mapped(std::move(m), f);
  return out;
}

/// Equal on paper within rounding of the coordinates.
void expect_same(const Looked& a, const Looked& b, double tolerance) {
  ASSERT_EQ(a.curves.size(), b.curves.size());
  for (std::size_t i = 0; i < a.curves.size(); ++i) {
    const Curve3 &c = a.curves[i], &d = b.curves[i];
    EXPECT_EQ(c.kind, d.kind);
    EXPECT_EQ(c.source, d.source);
    EXPECT_EQ(c.closed, d.closed);
    EXPECT_EQ(c.self_hidden, d.self_hidden);
    ASSERT_EQ(c.points.size(), d.points.size());
    for (std::size_t k = 0; k < c.points.size(); ++k) {
      EXPECT_LT(glm::length(a.camera.to_paper(c.points[k]) - b.camera.to_paper(d.points[k])),
                tolerance);
    }
  }
}

const Vec3 kView(0.9, -1.1, 0.8);

TEST(Invariance, Scale) {
  const Looked plain(parts(), {.direction = kView});
  EXPECT_GE(plain.of(LineClass::Intersection).size(), 1u);
  for (const double s : {1e-3, 1e4}) {
    expect_same(plain, Looked(moved([s](Vec3 p) { return s * p; }), {.direction = kView}), 1e-6);
  }
}

TEST(Invariance, Translation) {
  const Looked plain(parts(), {.direction = kView});
  const Vec3 far(1e5, -1e5, 1e5);
  expect_same(plain, Looked(moved([far](Vec3 p) { return p + far; }), {.direction = kView}), 1e-4);
}

TEST(Invariance, RotationOfModelAndCamera) {
  const Vec3 a = glm::normalize(Vec3(1, 2, 0.5));
  const Vec3 b = glm::normalize(reject(Vec3(0.3, -1, 2), a));
  const Mat3 turn(a, b, glm::cross(a, b));
  const Looked plain(parts(), {.direction = kView});
  expect_same(plain,
              Looked(moved([&](Vec3 p) { return turn * p; }),
                     {.direction = turn * kView, .up = turn * Vec3(0, 0, 1)}),
              1e-6);
}

TEST(Invariance, PerspectiveToo) {
  const Looked plain(parts(), {.direction = kView, .perspective = 45});
  expect_same(
      plain, Looked(moved([](Vec3 p) { return 1e4 * p; }), {.direction = kView, .perspective = 45}),
      1e-6);
}

}  // namespace
}  // namespace burin::test
