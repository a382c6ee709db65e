/// What faces and edges are, and the lengths and angles between them.
#include <burin/base/error.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/measure/measure.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <burin_test/brep_shapes.h>
#include <burin_test/shapes.h>
#include <gp_Trsf.hxx>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

namespace burin {
namespace {

/// Of lengths: what is asked of values.
constexpr double kExact = 1e-9;

std::shared_ptr<const Surface> realised(const TopoDS_Shape& shape) {
  RunContext context;
  return test::brep_form(shape)->realise({.tolerance = 0.02}, context);
}

Feature face_at(const Surface& surface, Vec3 at) {
  const NearFeature near = nearest_face(surface, at);
  EXPECT_LT(near.distance, 0.1);
  return *face_feature(surface, near.number, RunContext());
}

Feature edge_at(const Surface& surface, Vec3 at) {
  const NearFeature near = nearest_edge(surface, at);
  EXPECT_LT(near.distance, 0.1);
  return *edge_feature(surface, near.number);
}

gp_Trsf askew() {
  gp_Trsf by;
  by.SetTransformation(gp_Ax3(gp_Pnt(3, -4, 7), gp_Dir(1, 2, -0.5)), gp_Ax3());
  return by;
}

TopoDS_Shape placed(const TopoDS_Shape& shape, const gp_Trsf& by) {
  return BRepBuilderAPI_Transform(shape, by, true).Shape();
}

Vec3 moved(const gp_Trsf& by, Vec3 p) {
  gp_Pnt q(p.x, p.y, p.z);
  q.Transform(by);
  return {q.X(), q.Y(), q.Z()};
}

/// A block of 80 x 50 x 12 with a hole of 17 through it at (20, 15) and one of 6.5, 8 deep.
TopoDS_Shape block() {
  TopoDS_Shape out = BRepPrimAPI_MakeBox(80, 50, 12).Shape();
  out = BRepAlgoAPI_Cut(
      out, BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(20, 15, -1), gp_Dir(0, 0, 1)), 8.5, 20).Shape());
  return BRepAlgoAPI_Cut(
      out, BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(60, 40, 4), gp_Dir(0, 0, 1)), 3.25, 20).Shape());
}

TEST(Features, OfExactFacesAreTheirEquations) {
  const gp_Trsf by = askew();
  const auto cylinder = realised(placed(BRepPrimAPI_MakeCylinder(2.5, 7, 1.2).Shape(), by));
  const Feature wall = face_at(*cylinder, moved(by, {2.5 * std::cos(0.6), 2.5 * std::sin(0.6), 3}));
  EXPECT_EQ(wall.kind, FeatureKind::Cylinder);
  EXPECT_NEAR(wall.radius, 2.5, 2.5 * kExact);
  EXPECT_NEAR(wall.high - wall.low, 7, 7 * kExact);
  EXPECT_FALSE(wall.hollow);
  const auto cone = realised(placed(BRepPrimAPI_MakeCone(3, 1, 4).Shape(), by));
  const Feature side = face_at(*cone, moved(by, {2, 0, 2}));
  EXPECT_EQ(side.kind, FeatureKind::Cone);
  EXPECT_NEAR(side.opening, 2 * glm::degrees(std::atan(0.5)), 1e-7);
  EXPECT_NEAR(side.radius, 3, 1e-8);
  const auto sphere = realised(placed(BRepPrimAPI_MakeSphere(4.2).Shape(), by));
  const Feature ball = face_at(*sphere, moved(by, {4.2, 0, 0}));
  EXPECT_EQ(ball.kind, FeatureKind::Sphere);
  EXPECT_NEAR(ball.radius, 4.2, 4.2 * kExact);
  const auto torus = realised(placed(BRepPrimAPI_MakeTorus(5, 1.25).Shape(), by));
  const Feature tube = face_at(*torus, moved(by, {6.25, 0, 0}));
  EXPECT_EQ(tube.kind, FeatureKind::Torus);
  EXPECT_NEAR(tube.radius, 1.25, 1e-8);
  EXPECT_NEAR(tube.ring, 5, 1e-8);
}

TEST(Features, OfEdgesAreLinesAndCircles) {
  const auto surface = realised(block());
  const Feature rim = edge_at(*surface, {28.5, 15, 12});
  EXPECT_EQ(rim.kind, FeatureKind::Circle);
  EXPECT_NEAR(rim.radius, 8.5, 8.5 * kExact);
  const Feature side = edge_at(*surface, {40, 0, 0});
  EXPECT_EQ(side.kind, FeatureKind::Line);
  EXPECT_NEAR(side.size, 80, 80 * kExact);
}

TEST(Features, OfAMeshAreFoundByItsCorners) {
  RunContext context;
  const auto surface = MeshForm(test::box({0, 0, 0}, {80, 50, 12})).realise({}, context);
  const Feature top = face_at(*surface, {40, 25, 12}), foot = face_at(*surface, {40, 25, 0});
  EXPECT_EQ(top.kind, FeatureKind::Plane);
  EXPECT_NEAR(distance_between(top, foot).length, 12, 12 * kExact);
}

TEST(Measured, DistancesAreThoseOfTheModel) {
  const gp_Trsf by = askew();
  const auto surface = realised(placed(block(), by));
  const auto face = [&](Vec3 p) { return face_at(*surface, moved(by, p)); };
  const Feature left = face({0, 25, 6}), right = face({80, 25, 6}), front = face({40, 0, 6});
  const Feature hole = face({28.5, 15, 6}), small = face({63.25, 40, 8});
  EXPECT_NEAR(distance_between(left, right).length, 80, 80 * kExact);
  EXPECT_NEAR(distance_between(left, hole).length, 20, 20 * kExact);
  EXPECT_NEAR(distance_between(hole, front).length, 15, 15 * kExact);
  EXPECT_NEAR(distance_between(hole, small).length, std::hypot(40, 25), 50 * kExact);
  EXPECT_TRUE(hole.hollow);
  EXPECT_NEAR(small.high - small.low, 8, 8 * kExact);
  const MeasuredDistance along = distance_between(hole, small, right.along);
  EXPECT_NEAR(along.length, 40, 40 * kExact);
  EXPECT_NEAR(glm::dot(along.to - along.from, along.along), 40, 40 * kExact);
  EXPECT_NEAR(
      distance_between(point_feature(moved(by, {1, 2, 3})), point_feature(moved(by, {4, 6, 15})))
          .length,
      13, 1e-12 * 13 * 100);
}

TEST(Measured, AnglesAreThoseOfTheSidesOnWhichFeaturesLie) {
  const gp_Trsf by = askew();
  const auto box = realised(placed(block(), by));
  const auto face = [&](Vec3 p) { return face_at(*box, moved(by, p)); };
  EXPECT_NEAR(angle_between(face({0, 25, 6}), face({40, 0, 6})).degrees, 90, 1e-9);
  EXPECT_NEAR(angle_between(face({28.5, 15, 6}), face({40, 25, 12})).degrees, 90, 1e-9);
  Feature slope, ground;
  slope.kind = ground.kind = FeatureKind::Plane;
  slope.along = glm::normalize(Vec3(-1, 0, 1));
  slope.points = {{0, 0, 0}, {5, 0, 5}, {5, 3, 5}};
  ground.along = {0, 0, -1};
  ground.points = {{0, 0, 0}, {9, 0, 0}, {9, 3, 0}};
  EXPECT_NEAR(angle_between(slope, ground).degrees, 45, 1e-9);
}

/// What a call throws.
template <class Call>
std::string thrown(const Call& call) {
  try {
    call();
  } catch (const UsageError& e) {
    return e.what();
  }
  return "nothing";
}

TEST(Measured, SaysWhatHasNoDistanceOrAngle) {
  const auto surface = realised(block());
  const Feature left = face_at(*surface, {0, 25, 6}), right = face_at(*surface, {80, 25, 6}),
                front = face_at(*surface, {40, 0, 6}), hole = face_at(*surface, {28.5, 15, 6});
  EXPECT_EQ(thrown([&] { distance_between(left, front); }),
            "a plane and a plane are not parallel (by 90 degrees): they have an angle and no "
            "distance");
  EXPECT_EQ(thrown([&] { angle_between(left, right); }),
            "a plane and a plane are parallel: they have a distance and no angle");
  EXPECT_EQ(thrown([&] { distance_between(left, left); }),
            "both are at one place: their distance is 0");
  EXPECT_EQ(
      thrown([&] { distance_between(left, hole, Vec3(0, 0, 1)); }),
      "a plane is not at one place along the direction of the distance: leave `along` out, or "
      "give one square to it");
  EXPECT_EQ(thrown([&] {
              angle_between(left, point_feature({1, 2, 3}));
            }),
            "a point has no direction to measure an angle from");
}

}  // namespace
}  // namespace burin
