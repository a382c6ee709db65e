// Faces that end with curves: the triangles' sides are chords, the marches know the curves.

#include <burin_test/charts.h>
#include <gtest/gtest.h>

#include <cmath>

namespace burin {
namespace {

using test::kPi;

/// A disc of radius 1 in a square ring around it, both in the plane z = 0. Edge 0 is the circle
/// (coedge 0 of the disc, 1 of the ring), edge 1 the square's outline. t is an angle on the disc's
/// side; `shift` moves the (u,v) of the ring against the disc's.
class DiscAtlas final : public Atlas {
 public:
  explicit DiscAtlas(Vec2 shift) : shift_(shift) {
    charts_.push_back(test::plane_chart(Vec2(-3), Vec2(3)));
    charts_.push_back(test::chart_of(
        [shift](Vec2 p) {
          const Vec2 q = p - shift;
          return SurfaceDerivatives{{q.x, q.y, 0}, {1, 0, 0}, {0, 1, 0}, Vec3(0), Vec3(0), Vec3(0)};
        },
        Vec2(-3) + shift, Vec2(3) + shift));
  }
  std::size_t face_count() const override { return 2; }
  const Chart& chart(std::int32_t face) const override {
    return *charts_[static_cast<std::size_t>(face)];
  }
  bool reversed(std::int32_t) const override { return false; }
  Vec2 on_coedge(std::int32_t coedge, double t) const override {
    const Vec2 p(std::cos(t), std::sin(t));
    return coedge == 0 ? p : p + shift_;
  }

 private:
  Vec2 shift_;
  std::vector<std::shared_ptr<const Chart>> charts_;
};

std::shared_ptr<const Surface> disc_in_square(int n, ModelEdgeClass circle) {
  const Vec2 shift(10, -5);
  ChartMesh m;
  m.edge_class = {circle, ModelEdgeClass::Boundary};
  m.positions.push_back(Vec3(0));
  std::vector<double> angle;
  for (int i = 0; i < n; ++i) angle.push_back(2 * kPi * (i + 0.3) / n);
  angle.push_back(angle[0] + 2 * kPi);
  const auto add = [&](std::array<std::uint32_t, 3> t, std::int32_t face, std::int32_t edge,
                       double t0, double t1) {
    m.triangles.push_back(t);
    m.face.push_back(face);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 p = m.positions[t[k]];
      m.uv.push_back(Vec2(p.x, p.y) + (face == 1 ? shift : Vec2(0)));
      m.normal.emplace_back(0, 0, 1);
      m.on_contour.push_back(0);
      if (k != 0 || edge < 0) {
        m.border.push_back(-1);
        continue;
      }
      m.border.push_back(static_cast<std::int32_t>(m.borders.size()));
      m.borders.push_back({edge, edge == 0 ? face : -1, t0, t1});
    }
  };
  for (int ring = 0; ring < 2; ++ring) {
    for (int i = 0; i < n; ++i) {
      const Vec3 p(std::cos(angle[static_cast<std::size_t>(i)]),
                   std::sin(angle[static_cast<std::size_t>(i)]), 0);
      m.positions.push_back(ring == 0 ? p : 2.0 * p);
    }
  }
  for (int i = 0; i < n; ++i) {
    const auto a = static_cast<std::uint32_t>(1 + i),
               b = static_cast<std::uint32_t>(1 + (i + 1) % n);
    const auto c = a + static_cast<std::uint32_t>(n), d = b + static_cast<std::uint32_t>(n);
    const double t0 = angle[static_cast<std::size_t>(i)],
                 t1 = angle[static_cast<std::size_t>(i) + 1];
    add({a, b, 0}, 0, 0, t0, t1);
    add({b, a, c}, 1, 0, t1, t0);
    add({c, d, b}, 1, 1, 0, 1);
  }
  return make_charted_surface({std::make_shared<DiscAtlas>(shift), {}, 4}, std::move(m),
                              RunContext());
}

SurfacePoint in_disc(const Surface& s, Vec2 p) {
  return s.lift(s.to_proxy({0, Vec3(p, 0), Vec3(0)}));
}

TEST(CurvedBorder, MarchesStopAtTheCurveNotAtItsChord) {
  for (const int n : {5, 12, 60}) {
    const auto s = disc_in_square(n, ModelEdgeClass::Sharp);
    for (int i = 0; i < 200; ++i) {
      const Vec2 p = 0.7 * Vec2(std::cos(1.3 * i), std::sin(2.1 * i)) / 1.5;
      const Vec3 t(std::cos(0.37 * i), std::sin(0.37 * i), 0);
      const MarchStep m = s->march(in_disc(*s, p), t, 5);
      ASSERT_EQ(m.stop, MarchStop::Crease) << n << " " << i;
      EXPECT_NEAR(glm::length(m.end.position), 1, 1e-9) << n << " " << i;
      const double b = glm::dot(Vec3(p, 0), t);
      EXPECT_NEAR(m.length, -b + std::sqrt(b * b + 1 - glm::dot(p, p)), 1e-8) << n << " " << i;
      EXPECT_LT(glm::distance(s->proxy().position(s->to_proxy(m.end).face, s->to_proxy(m.end).bary),
                              m.end.position),
                1.1 * (1 - std::cos(kPi / n)));
    }
  }
}

// With fewer corners the circle would leave the ring's triangles beside it.
TEST(CurvedBorder, SmoothCurvesAreCrossedStraight) {
  for (const int n : {8, 12, 60}) {
    const auto s = disc_in_square(n, ModelEdgeClass::Smooth);
    for (int i = 0; i < 200; ++i) {
      const Vec2 p = 0.7 * Vec2(std::cos(1.3 * i), std::sin(2.1 * i)) / 1.5;
      const Vec3 t(std::cos(0.37 * i), std::sin(0.37 * i), 0);
      const MarchStep m = s->march(in_disc(*s, p), t, 5);
      ASSERT_EQ(m.stop, MarchStop::Boundary) << n << " " << i;
      EXPECT_EQ(m.end.chart, 1);
      EXPECT_LT(glm::distance(m.end.position, Vec3(p, 0) + m.length * t), 1e-9) << n << " " << i;
      // Back through the disc to the other side.
      const MarchStep back = s->march(m.end, -t, 10);
      ASSERT_EQ(back.stop, MarchStop::Boundary) << n << " " << i;
      EXPECT_LT(glm::distance(back.end.position, m.end.position - back.length * t), 1e-9);
      EXPECT_GT(back.length, 2);
      // In many steps, as strokes go.
      MarchStep step;
      step.end = m.end;
      step.direction = -t;
      double gone = 0;
      for (int k = 0; k < 2000 && (k == 0 || step.stop == MarchStop::Completed); ++k) {
        step = s->march(step.end, step.direction, 0.0137);
        gone += step.length;
      }
      EXPECT_NEAR(gone, back.length, 1e-8) << n << " " << i;
    }
  }
}

TEST(CurvedBorder, PathsThatGrazeTheCurveEnd) {
  for (const int n : {5, 12, 60}) {
    const auto s = disc_in_square(n, ModelEdgeClass::Smooth);
    for (int i = 0; i < 100; ++i) {
      for (const double off : {0.0, 1e-12, -1e-12, 1e-9, -1e-9, 1e-6, -1e-6, 1e-3, -1e-3}) {
        // A line that touches the circle, from the ring.
        const double a = 0.0628 * i;
        const Vec3 touch(std::cos(a), std::sin(a), 0), along(-touch.y, touch.x, 0);
        const Vec3 begin = (1 + off) * touch - 0.9 * along;
        const auto hint = static_cast<std::uint32_t>(n + n + i % 5);
        const SurfacePoint from =
            s->lift(s->to_proxy({1, Vec3(begin.x + 10, begin.y - 5, 0), Vec3(0), hint}));
        if (from.chart != 1 || glm::distance(from.position, begin) > 1e-6) continue;
        const MarchStep m = s->march(from, along, 1.8);
        ASSERT_TRUE(m.stop == MarchStop::Completed || m.stop == MarchStop::Boundary);
        EXPECT_LT(glm::distance(m.end.position, from.position + m.length * along), 1e-5)
            << n << " " << i << " " << off;
      }
    }
  }
}

}  // namespace
}  // namespace burin
