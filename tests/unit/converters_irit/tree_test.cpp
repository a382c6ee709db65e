// What an IRIT data file holds, as it stands there.
#include "reading.h"

#include <numbers>

namespace burin {
namespace {

TEST(IritTree, BezierSurfaceHasUFastest) {
  const IritObject root = test::tree_of(
      "[OBJECT [COLOR 11] [RGB \"55, 255, 255\"] [WIDTH 0.05] SADDLE\n"
      "  [SURFACE BEZIER 3 2 E3\n"
      "    [0 0 0] [1 0 5] [2 0 0]\n\n"
      "    [0 1 0] [1 1 7] [2 1 0]\n  ]\n]\n");
  ASSERT_EQ(root.objects.size(), 1u);
  const IritObject& object = root.objects[0];
  EXPECT_EQ(object.name, "SADDLE");
  EXPECT_EQ(object.line, 1);
  ASSERT_NE(object.attribute("rgb"), nullptr);
  EXPECT_EQ(*object.attribute("rgb"), "55, 255, 255");
  EXPECT_EQ(*object.attribute("width"), "0.05");
  EXPECT_EQ(object.attribute("height"), nullptr);
  ASSERT_EQ(object.items.size(), 1u);
  const auto& surface = std::get<IritSurface>(object.items[0]);
  EXPECT_EQ(surface.line, 2);
  const NurbsData& d = surface.data;
  EXPECT_EQ(d.degree_u, 2);
  EXPECT_EQ(d.degree_v, 1);
  EXPECT_EQ(d.count_u, 3);
  EXPECT_EQ(d.count_v, 2);
  EXPECT_EQ(d.knots_u, (std::vector<double>{0, 0, 0, 1, 1, 1}));
  EXPECT_EQ(d.knots_v, (std::vector<double>{0, 0, 1, 1}));
  EXPECT_TRUE(d.weights.empty());
  // Index i * count_v + j: x is i, y is j.
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      EXPECT_EQ(d.points[i * 2 + j].x, static_cast<double>(i));
      EXPECT_EQ(d.points[i * 2 + j].y, static_cast<double>(j));
    }
  }
  EXPECT_EQ(d.points[1 * 2 + 0].z, 5);
  EXPECT_EQ(d.points[1 * 2 + 1].z, 7);
}

TEST(IritTree, WeightsComeFirstAndPointsAreMultipliedByThem) {
  // A quarter of a cylinder of radius 2 about z, height 3.
  const double h = std::numbers::sqrt2 / 2;
  const IritObject root = test::tree_of(
      fmt::format("[OBJECT NONE [SURFACE BSPLINE 3 2 3 2 P3 [KV 0 0 0 1 1 1] [KV 0 0 3 3]\n"
                  "[1 2 0 0] [{0} {1} {1} 0] [1 0 2 0]\n[1 2 0 3] [{0} {1} {1} {2}] [1 0 2 3]]]",
                  h, 2 * h, 3 * h));
  const NurbsData& d = std::get<IritSurface>(root.objects[0].items[0]).data;
  EXPECT_EQ(d.weights, (std::vector<double>{1, 1, h, h, 1, 1}));
  test::expect_near(d.points[2], {2, 2, 0}, 1e-15);
  const auto chart = make_nurbs_chart(d);
  EXPECT_EQ(chart->domain().max.y, 3);
  for (double u = 0; u <= 1; u += 0.125) {
    const Vec3 p = chart->position({u, 1.5});
    EXPECT_NEAR(std::hypot(p.x, p.y), 2, 1e-14);
    EXPECT_NEAR(p.z, 1.5, 1e-14);
  }
}

TEST(IritTree, PeriodicDirectionsAreWrapped) {
  // A closed cubic of 4 points: 4 + 4 + 3 knots, its period is 4.
  std::string text = "[SURFACE BSPLINE 4 2 4 2 E3 [KVP 0 1 2 3 4 5 6 7 8 9 10] [KV 0 0 1 1]";
  for (const int z : {0, 1}) {
    for (const char* p : {"1 0", "0 1", "-1 0", "0 -1"}) text += fmt::format(" [{} {}]", p, z);
  }
  const IritObject root = test::tree_of(text + "]");
  const NurbsData& d = std::get<IritSurface>(root.items[0]).data;
  EXPECT_TRUE(d.periodic_u);
  EXPECT_FALSE(d.periodic_v);
  ASSERT_EQ(d.count_u, 7);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(d.points[2 * i], d.points[2 * (i + 4)]);
  const auto chart = make_nurbs_chart(d);
  EXPECT_EQ(chart->domain().min.x, 3);
  EXPECT_EQ(chart->domain().max.x, 7);
  EXPECT_EQ(chart->period().x, 4);
  test::expect_near(chart->position({3, 0.5}), chart->position({7, 0.5}), 1e-15);
  // At a knot a uniform cubic is (a + 4 b + c) / 6.
  test::expect_near(chart->position({3, 0}), {0, 4.0 / 6, 0}, 1e-15);
}

TEST(IritTree, OtherPointTypes) {
  const IritObject root = test::tree_of(
      "[OBJECT A [SURFACE BEZIER 2 2 E2 [0 0] [1 0] [0 1] [1 1]]]\n"
      "[OBJECT B [SURFACE BEZIER 2 2 P5 [2 0 0 0 9 9] [2 2 0 4 9 9] [2 0 2 0 9 9] [2 2 2 0 9 9]]]\n"
      "[OBJECT C [SURFACE BEZIER 2 2 E1 [0] [1] [0] [1]]]\n");
  EXPECT_EQ(std::get<IritSurface>(root.objects[0].items[0]).data.points[3], Vec3(1, 1, 0));
  EXPECT_EQ(std::get<IritSurface>(root.objects[1].items[0]).data.points[2], Vec3(1, 0, 2));
  const auto& unread = std::get<IritUnread>(root.objects[2].items[0]);
  EXPECT_EQ(unread.line, 3);
  EXPECT_NE(unread.what.find("one coordinate"), std::string::npos);
}

TEST(IritTree, AllElse) {
  const IritObject root = test::tree_of(
      "Made by hand, see page 3.\n# a [comment] with [brackets\n"
      "[OBJECT [TRANSP 0.3] [texture \"a \\\"b\\\" c\"] [deep [x [y 1] z] 2] \"two words\"\n"
      "  some words\n"
      "  [OBJECT n [NUMBER 2.5]] [object NONE [point 1 2 3]] [OBJECT v [VECTOR 4 5 6]]\n"
      "  [OBJECT m [MATRIX 1 0 0 0  0 1 0 0  0 0 1 0  7 8 9 1]] [OBJECT s [STRING \"a text\"]]\n"
      "  [OBJECT c [CURVE BSPLINE 3 2 P2 [KV 0 0 1 2 2] [1 0 0] [2 2 0] [1 1 1]]]\n"
      "  [OBJECT p [POLYGON [PLANE 0 0 1 0] 3 [[NORMAL 0 0 1] 0 0 0] [1 0 0] [0 1 0]]\n"
      "            [POLYLINE 2 [0 0 0] [1 1 1]]]\n]\n");
  ASSERT_EQ(root.objects.size(), 1u);
  const IritObject& list = root.objects[0];
  EXPECT_EQ(list.name, "two words");
  EXPECT_EQ(list.line, 3);
  EXPECT_EQ(*list.attribute("texture"), "a \"b\" c");
  EXPECT_EQ(*list.attribute("deep"), "2");
  ASSERT_EQ(list.objects.size(), 7u);
  EXPECT_EQ(std::get<IritNumbers>(list.objects[0].items[0]).values, std::vector<double>{2.5});
  EXPECT_EQ(list.objects[1].name, "");
  EXPECT_EQ(std::get<IritNumbers>(list.objects[1].items[0]).kind, "POINT");
  EXPECT_EQ(std::get<IritNumbers>(list.objects[3].items[0]).values[13], 8);
  EXPECT_EQ(std::get<std::string>(list.objects[4].items[0]), "a text");
  const auto& curve = std::get<IritCurve>(list.objects[5].items[0]);
  EXPECT_EQ(curve.degree, 1);
  EXPECT_EQ(curve.points[1], Vec3(1, 0, 0));
  EXPECT_EQ(curve.weights[1], 2);
  ASSERT_EQ(list.objects[6].items.size(), 2u);
  const auto& polygon = std::get<IritPolygon>(list.objects[6].items[0]);
  EXPECT_EQ(polygon.points[1], Vec3(1, 0, 0));
  EXPECT_EQ(polygon.attributes[0].value, "0 0 1 0");
  EXPECT_EQ(std::get<IritPolygon>(list.objects[6].items[1]).kind, IritPolygon::Kind::Polyline);
}

}  // namespace
}  // namespace burin
