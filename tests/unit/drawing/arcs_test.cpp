// Circles, ellipses and their arcs in polylines: found where they are, and nowhere else.
#include <burin/drawing/arcs.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace burin {
namespace {

constexpr double kPi = std::numbers::pi;

std::vector<Vec2> sampled(const std::function<Vec2(double)>& curve, double from, double to, int n) {
  std::vector<Vec2> points;
  for (int i = 0; i <= n; ++i) points.push_back(curve(from + (to - from) * i / n));
  return points;
}

std::function<Vec2(double)> circle(Vec2 c, double r) {
  return [=](double t) { return c + r * Vec2(std::cos(t), std::sin(t)); };
}

std::function<Vec2(double)> ellipse(Vec2 c, double a, double b, double turned) {
  return [=](double t) {
    const Vec2 along(std::cos(turned), std::sin(turned));
    return c + a * std::cos(t) * along + b * std::sin(t) * Vec2(-along.y, along.x);
  };
}

void append(std::vector<Vec2>& to, const std::vector<Vec2>& more) {
  to.insert(to.end(), more.begin(), more.end());
}

const ArcOptions kAll{0.002, 0.02, true};
const ArcOptions kNear{0.002, 0.02, true, true};

/// Pieces follow each other and arcs end on their first and last point.
void expect_chain(const std::vector<CurvePiece>& pieces, const ArcOptions& options) {
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (i > 0) {
      EXPECT_EQ(pieces[i].points.front(), pieces[i - 1].points.back());
    }
    if (!pieces[i].arc) continue;
    const ConicArc& arc = *pieces[i].arc;
    const double near = arc.is_whole() ? options.points : 1e-7;
    EXPECT_LT(glm::distance(arc.at(arc.begin), pieces[i].points.front()), near);
    EXPECT_LT(glm::distance(arc.at(arc.begin + arc.turn), pieces[i].points.back()), near);
  }
}

TEST(Arcs, AWholeCircleIsOne) {
  std::vector<Vec2> points = sampled(circle({100, 80}, 12), 0.3, 0.3 + 2 * kPi, 150);
  for (const bool closed : {true, false}) {
    if (closed) points.pop_back();
    const auto pieces = fit_arcs(points, closed, kAll);
    if (closed) points.push_back(points.front());
    ASSERT_EQ(pieces.size(), 1u);
    ASSERT_TRUE(pieces[0].arc);
    EXPECT_TRUE(pieces[0].arc->is_circle());
    EXPECT_TRUE(pieces[0].arc->is_whole());
    EXPECT_NEAR(pieces[0].arc->radius(), 12, 1e-6);
    EXPECT_LT(glm::distance(pieces[0].arc->center, Vec2(100, 80)), 1e-6);
    EXPECT_GT(pieces[0].arc->turn, 0);
    expect_chain(pieces, kAll);
  }
}

TEST(Arcs, AnObliqueCircleIsAnEllipseWhole) {
  std::vector<Vec2> points = sampled(ellipse({50, 40}, 20, 8, 0.7), 0, -2 * kPi, 200);
  points.pop_back();
  const auto pieces = fit_arcs(points, true, kAll);
  ASSERT_EQ(pieces.size(), 1u);
  ASSERT_TRUE(pieces[0].arc);
  const ConicArc& arc = *pieces[0].arc;
  EXPECT_TRUE(arc.is_whole());
  EXPECT_NEAR(arc.ratio, 0.4, 1e-6);
  EXPECT_NEAR(arc.radius(), 20, 1e-5);
  EXPECT_NEAR(std::abs(cross2(arc.major, Vec2(std::cos(0.7), std::sin(0.7)))), 0, 1e-4);
  EXPECT_LT(arc.turn, 0);
  // Without ellipses it is no circle.
  ArcOptions circles = kAll;
  circles.ellipses = false;
  for (const CurvePiece& piece : fit_arcs(points, true, circles)) {
    if (piece.arc) {
      EXPECT_FALSE(piece.arc->is_whole());
    }
  }
}

TEST(Arcs, PartsOfEllipsesAreFound) {
  for (const double turn : {1.4, 2.0, -4.0}) {
    const auto points = sampled(ellipse({-30, 40}, 25, 10, 2), 1, 1 + turn, 60);
    const auto pieces = fit_arcs(points, false, kAll);
    ASSERT_EQ(pieces.size(), 1u) << turn;
    ASSERT_TRUE(pieces[0].arc);
    EXPECT_NEAR(pieces[0].arc->ratio, 0.4, 1e-3);
    EXPECT_NEAR(std::abs(pieces[0].arc->turn), std::abs(turn), 1e-3);
    expect_chain(pieces, kAll);
  }
}

TEST(Arcs, ARoundedRectangleIsItsLinesAndItsArcs) {
  // Begun within an arc, so that it has to be turned.
  std::vector<Vec2> points;
  append(points, sampled(circle({55, 35}, 5), 0.5 * kPi, 0, 20));
  append(points, sampled(circle({55, 15}, 5), 0, -0.5 * kPi, 20));
  append(points, sampled(circle({15, 15}, 5), -0.5 * kPi, -kPi, 20));
  append(points, sampled(circle({15, 35}, 5), kPi, 0.5 * kPi, 20));
  std::rotate(points.begin(), points.begin() + 10, points.end());
  const auto pieces = fit_arcs(points, true, kAll);
  expect_chain(pieces, kAll);
  ASSERT_EQ(pieces.size(), 8u);
  int arcs = 0;
  for (const CurvePiece& piece : pieces) {
    if (!piece.arc) {
      EXPECT_EQ(piece.points.size(), 2u);
      continue;
    }
    ++arcs;
    EXPECT_TRUE(piece.arc->is_circle());
    EXPECT_NEAR(piece.arc->radius(), 5, 1e-6);
    EXPECT_NEAR(piece.arc->turn, -0.5 * kPi, 1e-6);
  }
  EXPECT_EQ(arcs, 4);
}

TEST(Arcs, AnArcThatMeetsAnotherEndsThere) {
  std::vector<Vec2> points = sampled(circle({0, 0}, 10), kPi, 0.5 * kPi, 40);
  append(points, sampled(circle({0, 7}, 3), 0.5 * kPi, 0, 12));
  const auto pieces = fit_arcs(points, false, kAll);
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_NEAR(pieces[0].arc.value().radius(), 10, 0.05);
  EXPECT_NEAR(pieces[1].arc.value().radius(), 3, 0.05);
  expect_chain(pieces, kAll);
}

TEST(Arcs, PolygonsAndLinesAreNone) {
  // 24 facets that show; a square; a straight line of many points; a zigzag; nothing.
  std::vector<Vec2> facets = sampled(circle({0, 0}, 20), 0, 2 * kPi, 24);
  facets.pop_back();
  std::vector<Vec2> straight, zigzag;
  for (int i = 0; i < 500; ++i) {
    straight.emplace_back(0.1 * i, 0.0005 * std::sin(0.7 * i));
    zigzag.emplace_back(0.1 * i, 0.3 * (i % 2));
  }
  for (const auto& [points, closed] : {std::pair(facets, true),
                                       {std::vector<Vec2>{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, true},
                                       {straight, false},
                                       {zigzag, false},
                                       {std::vector<Vec2>{{1, 1}}, false},
                                       {std::vector<Vec2>{{1, 1}, {1, 1}, {2, 2}}, true}}) {
    const auto pieces = fit_arcs(points, closed, kAll);
    ASSERT_EQ(pieces.size(), 1u);
    EXPECT_FALSE(pieces[0].arc);
  }
  EXPECT_TRUE(fit_arcs({}, false, kAll).empty());
}

TEST(Arcs, AnInvoluteIsNoneUnlessNearIsEnough) {
  const auto involute = [](double t) {
    return 10.0 * Vec2(std::cos(t) + t * std::sin(t), std::sin(t) - t * std::cos(t));
  };
  const auto points = sampled(involute, 0.3, 1.2, 20);
  const auto pieces = fit_arcs(points, false, kAll);
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_FALSE(pieces[0].arc);
  EXPECT_EQ(pieces[0].points, points);
  const auto near = fit_arcs(points, false, kNear);
  EXPECT_GT(near.size(), 1u);
  EXPECT_TRUE(near[0].arc);
}

TEST(Arcs, OfAnyCurveStayNearIt) {
  const auto wave = [](double t) { return Vec2(10 * t, 3 * std::sin(t) + std::cos(2.3 * t)); };
  const auto points = sampled(wave, 0, 12, 600);
  std::size_t total = 0;
  const auto pieces = fit_arcs(points, false, kNear);
  expect_chain(pieces, kNear);
  for (const CurvePiece& piece : pieces) {
    total += piece.points.size() - 1;
    if (!piece.arc) continue;
    for (int i = 0; i <= 50; ++i) {
      const Vec2 p = piece.arc->at(piece.arc->begin + piece.arc->turn * i / 50);
      double nearest = 1e9;
      for (double t = 0; t < 12; t += 0.001) nearest = std::min(nearest, glm::distance(p, wave(t)));
      EXPECT_LT(nearest, 0.02);
    }
  }
  EXPECT_EQ(total, points.size() - 1);
}

}  // namespace
}  // namespace burin
