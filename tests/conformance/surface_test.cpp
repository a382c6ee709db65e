/// What every surface form has to keep of the Surface contract, whatever it is made of.

#include <burin/base/error.h>
#include <burin/base/parallel.h>

#include "forms.h"

#include <burin_test/exact.h>
#include <gtest/gtest.h>

namespace burin {
namespace {

using test::FormCase;
using test::line_angle;

class SurfaceContract : public testing::TestWithParam<FormCase> {
 protected:
  void SetUp() override {
    form_ = test::realised(GetParam()).form;
    surface_ = test::realised(GetParam()).surface;
    const Box3 b = surface_->proxy().mesh.bounds();
    size_ = b.diagonal();
    rounding_ = 1e-13 * size_ + 1e-15 * (glm::length(b.min) + glm::length(b.max));
    points_ = surface_->cover({.count = 500, .seed = 3}, context_);
  }
  double near() const { return surface_->proxy().tolerance + GetParam().slip + rounding_; }
  /// The box of a mesh is that of its vertices, beyond which coarse facets bulge by up to 0.12 of
  /// an edge.
  double most_rounding() {
    if (!GetParam().name.starts_with("Mesh")) return 0;
    const auto facets = form_->realise({.tolerance = 1e30, .curvature = false}, context_);
    const TriMesh& mesh = facets->proxy().mesh;
    double longest = 0;
    for (const Triangle& t : mesh.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        longest =
            std::max(longest, glm::distance(mesh.positions[t[k]], mesh.positions[t[(k + 1) % 3]]));
      }
    }
    return 0.12 * longest;
  }
  Vec3 proxy_position(const SurfacePoint& p) const {
    const ProxyPoint at = surface_->to_proxy(p);
    return surface_->proxy().position(at.face, at.bary);
  }
  /// Some tangent at a point, another one for each `i`.
  static Vec3 tangent(const Frame& f, int i) {
    const double a = 0.7 + 1.9 * i;
    return std::cos(a) * f.d1 + std::sin(a) * f.d2;
  }

  RunContext context_;
  std::shared_ptr<const Form> form_;
  std::shared_ptr<const Surface> surface_;
  double size_ = 0;
  /// Of positions: some ulps of the largest coordinate.
  double rounding_ = 0;
  std::vector<SurfacePoint> points_;
};

TEST_P(SurfaceContract, BoundsHoldTheProxy) {
  for (const Mat3& axes : {Mat3(1), Mat3(0, 1, 0, 0, 0, 1, 1, 0, 0)}) {
    const Box3 b = form_->bounds(axes);
    const double slack = near() + most_rounding();
    for (const Vec3& p : surface_->proxy().mesh.positions) {
      const Vec3 q = axes * p;
      for (int i = 0; i < 3; ++i) {
        EXPECT_GE(q[i], b.min[i] - slack);
        EXPECT_LE(q[i], b.max[i] + slack);
      }
    }
  }
}

TEST_P(SurfaceContract, CoverGivesAsManyPointsAsAskedOnTheSurface) {
  ASSERT_EQ(points_.size(), 500u);
  for (const SurfacePoint& p : points_) {
    EXPECT_LE(glm::distance(p.position, proxy_position(p)), near());
  }
}

TEST_P(SurfaceContract, CoverIsUniformByArea) {
  // The share of points in the lower half of the box against the share of the area, within four
  // deviations.
  const ProxyMesh& proxy = surface_->proxy();
  const Box3 b = proxy.mesh.bounds();
  const Vec3 axis(0.3, 0.5, 0.8);
  const double middle = glm::dot(b.center(), axis);
  double below = 0, total = 0;
  for (std::uint32_t f = 0; f < proxy.wedges.size(); ++f) {
    const double area = proxy.mesh.area(f);
    total += area;
    // A triangle across the middle counts by a grid of its points.
    int inside = 0;
    for (int i = 0; i < 20; ++i) {
      for (int j = 0; j < 20; ++j) {
        const double r = std::sqrt((i + 0.5) / 20), s = (j + 0.5) / 20;
        inside += glm::dot(proxy.position(f, {1 - r, r * (1 - s), r * s}), axis) < middle;
      }
    }
    below += area * inside / 400;
  }
  const auto points = surface_->cover({.count = 20000, .seed = 5}, context_);
  double count = 0;
  for (const SurfacePoint& p : points) count += glm::dot(p.position, axis) < middle;
  const double share = below / total;
  EXPECT_NEAR(count / 20000, share, 4 * std::sqrt(share * (1 - share) / 20000));
}

TEST_P(SurfaceContract, CoverKeepsToItsWeightAndItsSeed) {
  CoverRequest request{.count = 300, .seed = 9, .part = 2};
  const double middle = surface_->proxy().mesh.bounds().center().x;
  request.weight = [&](Vec3 p, Vec3) { return p.x < middle ? 1.0 : 0.0; };
  const auto a = surface_->cover(request, context_), b = surface_->cover(request, context_);
  ASSERT_EQ(a.size(), 300u);
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_LT(a[i].position.x, middle + near());
    EXPECT_EQ(a[i].position, b[i].position);
  }
  request.weight = [](Vec3, Vec3) { return 0.0; };
  EXPECT_TRUE(surface_->cover(request, context_).empty());
}

TEST_P(SurfaceContract, FramesAreOrthonormalAndOrdered) {
  for (const SurfacePoint& p : points_) {
    const Frame f = surface_->frame(p);
    EXPECT_EQ(f.position, p.position);
    EXPECT_NEAR(glm::length(f.normal), 1, 1e-12);
    EXPECT_NEAR(glm::length(f.d1), 1, 1e-9);
    EXPECT_NEAR(glm::dot(f.d1, f.normal), 0, 1e-9);
    EXPECT_LT(glm::distance(glm::cross(f.normal, f.d1), f.d2), 1e-9);
    EXPECT_GE(f.k1, f.k2);
    EXPECT_GE(f.confidence, 0);
    EXPECT_LE(f.confidence, 1 + 1e-12);
    const Vec3 n = surface_->proxy().mesh.normal(surface_->to_proxy(p).face);
    EXPECT_GT(glm::dot(f.normal, n), std::cos(GetParam().normal_tolerance * test::kPi / 180));
  }
}

TEST_P(SurfaceContract, NormalsOfClosedSurfacesPointOutwards) {
  if (!GetParam().closed) GTEST_SKIP() << "an open surface";
  // The volume by the divergence theorem, over the wedges' frames, is positive and near that of the
  // proxy.
  const ProxyMesh& proxy = surface_->proxy();
  const Vec3 center = proxy.mesh.bounds().center();
  const std::vector<Frame> frames = surface_->wedge_frames(context_);
  double exact = 0, volume = 0;
  for (std::uint32_t f = 0; f < proxy.wedges.size(); ++f) {
    const double area = proxy.mesh.area(f);
    exact += area * glm::dot(proxy.mesh.normal(f), proxy.position(f, Vec3(1.0 / 3)) - center) / 3;
    for (const std::uint32_t w : proxy.wedges[f]) {
      volume += area / 9 * glm::dot(frames[w].normal, frames[w].position - center);
    }
  }
  EXPECT_GT(exact, 0);
  EXPECT_NEAR(volume / exact, 1, 0.1);
}

TEST_P(SurfaceContract, WedgeFramesAreTheFramesAtTheWedges) {
  const ProxyMesh& proxy = surface_->proxy();
  const std::vector<Frame> frames = surface_->wedge_frames(context_);
  ASSERT_EQ(frames.size(), proxy.wedge_vertex.size());
  for (std::uint32_t f = 0; f < proxy.wedges.size(); f += 3) {
    for (int k = 0; k < 3; ++k) {
      Vec3 bary(0);
      bary[k] = 1;
      const Frame& w = frames[proxy.wedges[f][static_cast<std::size_t>(k)]];
      const Frame at = surface_->frame(surface_->lift({f, bary}));
      EXPECT_LE(glm::distance(w.position, at.position), near());
      EXPECT_LT(glm::distance(w.normal, at.normal), GetParam().joint);
      if (GetParam().curvature_jumps) continue;
      EXPECT_NEAR(w.k1, at.k1, 1e-9 * (std::abs(w.k1) + std::abs(w.k2)) + 1e-12 / size_);
      if (!w.umbilic && w.k1 - w.k2 > 1e-6 * std::abs(w.k1)) {
        EXPECT_LT(line_angle(w.d1, at.d1), 1e-3);
      }
    }
  }
}

TEST_P(SurfaceContract, ProxyAndSurfacePointsGoBackAndForth) {
  for (const SurfacePoint& p : points_) {
    const ProxyPoint at = surface_->to_proxy(p);
    EXPECT_LT(at.face, surface_->proxy().wedges.size());
    EXPECT_NEAR(at.bary.x + at.bary.y + at.bary.z, 1, 1e-9);
    EXPECT_GE(std::min({at.bary.x, at.bary.y, at.bary.z}), -1e-9);
    EXPECT_LE(glm::distance(surface_->lift(at).position, p.position), near());
  }
}

TEST_P(SurfaceContract, MarchesTellTheTruth) {
  int completed = 0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const SurfacePoint& p = points_[i];
    const Vec3 t = tangent(surface_->frame(p), static_cast<int>(i));
    const double length = size_ * (i % 3 == 0 ? 0.001 : i % 3 == 1 ? 0.05 : 0.4);
    const MarchStep step = surface_->march(p, t, length);
    EXPECT_LE(step.length, length * (1 + 1e-9));
    EXPECT_LE(glm::distance(step.end.position, p.position), step.length * (1 + 1e-6) + 2 * near());
    EXPECT_LE(glm::distance(step.end.position, proxy_position(step.end)), near());
    if (step.stop == MarchStop::Completed) {
      ++completed;
      EXPECT_NEAR(step.length, length, 1e-9 * length);
      EXPECT_NEAR(glm::length(step.direction), 1, 1e-6);
      const Vec3 n = surface_->proxy().mesh.normal(surface_->to_proxy(step.end).face);
      // Exact directions are tangent to the surface, which turns under its triangles.
      const double turned = GetParam().normal_tolerance > 20
                                ? std::sin(GetParam().normal_tolerance * test::kPi / 180)
                                : 0.2;
      EXPECT_LT(std::abs(glm::dot(step.direction, n)), turned);
    } else {
      EXPECT_LT(step.length, length);
    }
  }
  EXPECT_GT(completed, 250);
}

TEST_P(SurfaceContract, ShortMarchesAreStraight) {
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Frame f = surface_->frame(points_[i]);
    const Vec3 t = tangent(f, static_cast<int>(i));
    const MarchStep step = surface_->march(points_[i], t, 1e-5 * size_);
    if (step.stop != MarchStop::Completed) continue;
    const Vec3 gone = reject(step.end.position - points_[i].position, f.normal);
    // The tangent is projected to the triangle, whose normal differs from the frame's.
    EXPECT_LT(line_angle(gone, t), 0.2 * GetParam().normal_tolerance + 1e8 * rounding_ / size_);
  }
}

TEST_P(SurfaceContract, ALongMarchIsManyShortOnes) {
  for (std::size_t i = 0; i < points_.size(); i += 10) {
    const Vec3 t = tangent(surface_->frame(points_[i]), static_cast<int>(i));
    const MarchStep whole = surface_->march(points_[i], t, 0.1 * size_);
    MarchStep step;
    step.end = points_[i];
    step.direction = t;
    double gone = 0;
    for (int k = 0; k < 8 && step.stop == MarchStop::Completed; ++k) {
      step = surface_->march(step.end, step.direction, 0.1 * size_ / 8);
      gone += step.length;
    }
    EXPECT_EQ(step.stop, whole.stop);
    EXPECT_NEAR(gone, whole.length, 1e-6 * size_);
    EXPECT_LT(glm::distance(step.end.position, whole.end.position), 1e-6 * size_ + 100 * near());
  }
}

TEST_P(SurfaceContract, MarchingBackReturns) {
  for (std::size_t i = 0; i < points_.size(); i += 3) {
    const Vec3 t = tangent(surface_->frame(points_[i]), static_cast<int>(i));
    const MarchStep there = surface_->march(points_[i], t, 0.05 * size_);
    if (there.stop != MarchStop::Completed) continue;
    const MarchStep back = surface_->march(there.end, -there.direction, there.length);
    EXPECT_LT(glm::distance(back.end.position, points_[i].position), 1e-5 * size_ + 100 * near());
  }
}

TEST_P(SurfaceContract, AMarchOfNoLengthStays) {
  for (std::size_t i = 0; i < points_.size(); i += 10) {
    const MarchStep step = surface_->march(points_[i], surface_->frame(points_[i]).d1, 0);
    EXPECT_EQ(step.length, 0);
    EXPECT_LE(glm::distance(step.end.position, points_[i].position), near());
  }
}

TEST_P(SurfaceContract, MarchesEndWhereTheTangentVanishes) {
  for (std::size_t i = 0; i < points_.size(); i += 25) {
    const MarchStep step = surface_->march(points_[i], Vec3(0), size_);
    EXPECT_EQ(step.stop, MarchStop::Singular);
    EXPECT_EQ(step.length, 0);
  }
}

TEST_P(SurfaceContract, ClosedSurfacesHaveNoBoundary) {
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Vec3 t = tangent(surface_->frame(points_[i]), static_cast<int>(i));
    const MarchStop stop = surface_->march(points_[i], t, 3 * size_).stop;
    if (GetParam().closed) {
      EXPECT_NE(stop, MarchStop::Boundary);
    } else {
      EXPECT_NE(stop, MarchStop::Completed) << "an open piece this small ends everywhere";
    }
  }
}

TEST_P(SurfaceContract, ManyThreadsSeeTheSame) {
  std::vector<MarchStep> together(points_.size());
  const auto walk = [&](std::size_t i) {
    return surface_->march(points_[i], surface_->frame(points_[i]).d1, 0.3 * size_);
  };
  parallel_for(points_.size(), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) together[i] = walk(i);
  });
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const MarchStep alone = walk(i);
    EXPECT_EQ(alone.end.position, together[i].end.position);
    EXPECT_EQ(alone.length, together[i].length);
    EXPECT_EQ(alone.stop, together[i].stop);
  }
}

TEST_P(SurfaceContract, RealisingTwiceGivesTheSameSurface) {
  const auto again = form_->realise({.tolerance = 0.01}, context_);
  EXPECT_EQ(again->proxy().mesh.positions, surface_->proxy().mesh.positions);
  EXPECT_EQ(again->proxy().mesh.triangles, surface_->proxy().mesh.triangles);
  for (const SurfacePoint& p : points_) {
    const Frame a = surface_->frame(p), b = again->frame(p);
    EXPECT_EQ(a.normal, b.normal);
    EXPECT_EQ(a.d1, b.d1);
    EXPECT_EQ(a.k1, b.k1);
  }
}

TEST_P(SurfaceContract, ACancelledRealiseThrows) {
  RunContext cancelled;
  cancelled.cancel();
  EXPECT_THROW(form_->realise({}, cancelled), Cancelled);
}

INSTANTIATE_TEST_SUITE_P(Forms, SurfaceContract, testing::ValuesIn(test::form_cases()),
                         [](const auto& form) { return form.param.name; });

}  // namespace
}  // namespace burin
