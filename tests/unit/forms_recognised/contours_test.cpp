// Contours of healed forms are those of the round surfaces, not of their facets.

#include <burin/camera/facing.h>
#include <burin/feature/feature.h>
#include <burin/forms/recognised/recognised_form.h>

#include <burin_test/shapes.h>
#include <burin_test/turned.h>
#include <gtest/gtest.h>

#include <cmath>

namespace burin {
namespace {

using test::sphere_profile, test::turned;

struct Drawn {
  RunContext context;
  Camera camera;
  std::shared_ptr<const Surface> surface;
  std::vector<Curve3> contours;

  Drawn(TriMesh mesh, const ViewOptions& view)
      : camera(Camera::fit(
            [&](const Mat3& axes) {
              Box3 box;
              for (const Vec3& p : mesh.positions) box.add(axes * p);
              return box;
            },
            view)) {
    const RecognisedForm form(std::move(mesh), context);
    // 0.05 mm of paper, as drawings ask for.
    surface =
        form.realise({.tolerance = 0.05 / camera.scale_at(Vec3(0)), .view = &camera}, context);
    const ProxyMesh* proxy = &surface->proxy();
    Diagnostics diagnostics;
    for (Curve3& c : extract_features({&proxy, 1}, camera, {}, diagnostics, context)) {
      if (c.kind == LineClass::Contour && c.source.edge < 0) contours.push_back(std::move(c));
    }
  }

  /// The largest of `off` (mm of paper) over points of the contours and the middles of their
  /// chords.
  template <class Off>
  double farthest(const Off& off) const {
    double most = 0;
    for (const Curve3& c : contours) {
      for (std::size_t i = 0; i < c.points.size(); ++i) {
        most = std::max(most, off(c.points[i]));
        if (i + 1 < c.points.size() || c.closed) {
          most = std::max(most, off(0.5 * (c.points[i] + c.points[c.next(i)])));
        }
      }
    }
    return most;
  }
  double length() const {
    double sum = 0;
    for (const Curve3& c : contours) {
      for (std::size_t i = 0; i + (c.closed ? 0 : 1) < c.points.size(); ++i) {
        sum += glm::distance(c.points[i], c.points[c.next(i)]);
      }
    }
    return sum;
  }
  int triangles_that_face_both_ways() const {
    const ProxyMesh& proxy = surface->proxy();
    const FacingFunction g(camera);
    int count = 0;
    for (const Triangle& wedges : proxy.wedges) {
      int front = 0, back = 0;
      for (const std::uint32_t w : wedges) {
        if (proxy.on_contour[w]) continue;
        const double value = g(proxy.wedge_position(w), proxy.wedge_normal[w]);
        front += value > 0;
        back += value < 0;
      }
      count += front > 0 && back > 0;
    }
    return count;
  }
};

const ViewOptions kViews[] = {{.direction = {1, -1, 0.8}},
                              {.direction = {0.3, -1, 0.45}},
                              {.direction = {0, -1, 0.02}},
                              {.direction = {-0.4, -1, 0.55}, .perspective = 30}};
// mm of paper: the chord of the cut, and what single precision moved the corners by.
constexpr double kOff = 0.006;

TEST(RecognisedContours, OfBallsAreCircles) {
  for (const int sides : {12, 24, 100}) {
    for (const ViewOptions& view : kViews) {
      const Drawn d(turned(sphere_profile(10, sides), sides), view);
      ASSERT_FALSE(d.contours.empty());
      // On the ball, and where its normal lies across the way to the viewer.
      const FacingFunction g(d.camera);
      const double off = d.farthest([&](Vec3 p) {
        const double scale = d.camera.scale_at(p);
        return std::max(std::abs(glm::length(p) - 10),
                        10 * g(p, glm::normalize(p)) * g(p, glm::normalize(p)) / 2) *
               scale;
      });
      EXPECT_LE(off, kOff) << sides;
      EXPECT_EQ(d.triangles_that_face_both_ways(), 0) << sides;
      if (!view.perspective) {
        EXPECT_NEAR(d.length(), 2 * test::kPi * 10, 0.01) << sides;
      }
    }
  }
}

TEST(RecognisedContours, OfCylindersAndConesAreStraight) {
  for (const double top : {10.0, 6.0}) {
    for (const int sides : {12, 30}) {
      for (const ViewOptions& view : kViews) {
        const Drawn d(turned({{10, 0}, {top, 30}}, sides), view);
        const FacingFunction g(d.camera);
        const Vec2 normal = glm::normalize(Vec2(30, 10 - top));
        const double off = d.farthest([&](Vec3 p) {
          const Vec3 out = glm::normalize(Vec3(p.x, p.y, 0));
          const double value = g(p, normal.x * out + Vec3(0, 0, normal.y));
          const double radius = std::hypot(p.x, p.y), exact = 10 + (top - 10) * p.z / 30;
          return std::max(std::abs(radius - exact), radius * value * value / 2) *
                 d.camera.scale_at(p);
        });
        EXPECT_LE(off, kOff) << top << " " << sides;
        EXPECT_EQ(d.triangles_that_face_both_ways(), 0) << top << " " << sides;
        EXPECT_EQ(d.contours.size(), 2U) << top << " " << sides;
      }
    }
  }
}

TEST(RecognisedContours, OfToriLieOnThem) {
  std::vector<Vec2> profile;
  for (int i = 0; i < 24; ++i) {
    const double a = -2 * test::kPi * i / 24;
    profile.push_back(Vec2(20 + 6 * std::cos(a), -6 * std::sin(a)));
  }
  for (const ViewOptions& view : kViews) {
    TriMesh mesh = turned(profile, 48, true);
    const Drawn d(std::move(mesh), view);
    ASSERT_FALSE(d.contours.empty());
    const FacingFunction g(d.camera);
    double on = 0, facing = 0;
    for (const Curve3& c : d.contours) {
      for (const Vec3& p : c.points) {
        const Vec3 ring = 20.0 * glm::normalize(Vec3(p.x, p.y, 0));
        on = std::max(on, std::abs(glm::distance(p, ring) - 6));
        facing = std::max(facing, std::abs(g(p, glm::normalize(p - ring))));
      }
    }
    EXPECT_LE(on, 1e-4);
    EXPECT_LE(facing, 1e-3);  // on paper a contour moves by the square of it
    EXPECT_EQ(d.triangles_that_face_both_ways(), 0);
  }
}

TEST(RecognisedContours, RimsMeetThem) {
  // The contours of a cylinder end on its rims: on both the wall and the cap.
  const Drawn d(turned({{10, 0}, {10, 30}}, 24), {.direction = {0.3, -1, 0.45}});
  ASSERT_EQ(d.contours.size(), 2U);
  for (const Curve3& c : d.contours) {
    const auto [low, high] = std::minmax(c.points.front().z, c.points.back().z);
    EXPECT_NEAR(low, 0, 1e-9);
    EXPECT_NEAR(high, 30, 1e-9);
    EXPECT_NEAR(std::hypot(c.points.front().x, c.points.front().y), 10, 1e-5);
  }
}

TEST(RecognisedContours, FacetsWithoutASurfaceKeepTheirOwn) {
  // A cylinder on an egg, whose facets stand for nothing that is known.
  TriMesh mesh = turned({{10, 0}, {10, 5}}, 24);
  const TriMesh egg = test::ellipsoid({4, 5, 7}, 16, 12);
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const Vec3& p : egg.positions) mesh.positions.push_back(p + Vec3(30, 0, 0));
  for (const Triangle& t : egg.triangles) {
    mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  const Drawn d(std::move(mesh), {.direction = {0.3, -1, 0.45}});
  EXPECT_TRUE(d.surface->proxy().on_contour.empty());
  EXPECT_FALSE(d.contours.empty());
}

}  // namespace
}  // namespace burin
