/// Axes of faces of revolution, and the centre lines and marks that stand for them.

#include <burin/centre_lines/centre_lines.h>
#include <burin/surface/turned_faces.h>

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <burin_test/brep_shapes.h>
#include <gp_Trsf.hxx>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace burin {
namespace {

const Vec3 kAlong = glm::normalize(Vec3(1, 2, -0.5));
const Vec3 kThrough(3, -4, 7);

/// Takes the z axis to `kAlong` through `kThrough`.
TopoDS_Shape askew(const TopoDS_Shape& shape) {
  gp_Trsf by;
  by.SetTransformation(
      gp_Ax3(gp_Pnt(kThrough.x, kThrough.y, kThrough.z), gp_Dir(kAlong.x, kAlong.y, kAlong.z)),
      gp_Ax3());
  return BRepBuilderAPI_Transform(shape, by, true).Shape();
}

std::shared_ptr<const Surface> realised(const TopoDS_Shape& shape) {
  RunContext context;
  return test::brep_form(shape)->realise({.tolerance = 0.02}, context);
}

std::vector<TurnedFace> faces_of(const TopoDS_Shape& shape) {
  RunContext context;
  return turned_faces(*realised(shape), context);
}

double off(Vec3 point, const Axis& axis) {
  const Vec3 p = point - axis.point;
  return glm::length(p - glm::dot(p, axis.along) * axis.along);
}

class TurnedFaces : public testing::TestWithParam<std::string> {
 protected:
  static TopoDS_Shape shape(const std::string& name) {
    if (name == "cylinder") return BRepPrimAPI_MakeCylinder(2, 5).Shape();
    if (name == "quarter") return BRepPrimAPI_MakeCylinder(2, 5, 1.5707963267948966).Shape();
    if (name == "cone") return BRepPrimAPI_MakeCone(3, 1, 4).Shape();
    return BRepPrimAPI_MakeTorus(5, 1).Shape();
  }
};

TEST_P(TurnedFaces, KnowTheirAxis) {
  const auto faces = faces_of(askew(shape(GetParam())));
  ASSERT_EQ(faces.size(), 1U) << "plane faces have no axis";
  EXPECT_FALSE(faces[0].sphere);
  EXPECT_FALSE(faces[0].hollow);
  EXPECT_NEAR(std::abs(glm::dot(faces[0].axis.along, kAlong)), 1, 1e-12);
  EXPECT_LT(off(kThrough, faces[0].axis), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Kinds, TurnedFaces,
                         testing::Values("cylinder", "quarter", "cone", "torus"));

TEST(TurnedFace, OfAPointedConeIsNoBall) {
  for (const double height : {1.0, 3.0, 6.0, 12.0}) {
    const auto faces = faces_of(askew(BRepPrimAPI_MakeCone(3, 0, height).Shape()));
    ASSERT_EQ(faces.size(), 1U);
    EXPECT_FALSE(faces[0].sphere) << height;
    EXPECT_LT(off(kThrough, faces[0].axis), 1e-9);
  }
}

TEST(TurnedFace, OfABallIsItsCentre) {
  const auto faces = faces_of(askew(BRepPrimAPI_MakeSphere(3).Shape()));
  ASSERT_EQ(faces.size(), 1U);
  EXPECT_TRUE(faces[0].sphere);
  EXPECT_LT(glm::distance(faces[0].axis.point, kThrough), 1e-9);
}

TEST(TurnedFace, OfAHoleIsHollow) {
  const auto faces = faces_of(test::plate_with_hole_shape());
  ASSERT_EQ(faces.size(), 1U);
  EXPECT_TRUE(faces[0].hollow);
}

TEST(TurnedFace, GoesRoundAsFarAsItsAngle) {
  const auto surface = realised(BRepPrimAPI_MakeCylinder(2, 5, 1.5707963267948966).Shape());
  RunContext context;
  const auto faces = turned_faces(*surface, context);
  ASSERT_EQ(faces.size(), 1U);
  const TurnedExtent extent = extent_about(faces[0].axis, surface->proxy(), faces[0].triangles);
  EXPECT_NEAR(static_cast<double>(extent.turn.count()), 90, 2);
  EXPECT_NEAR(extent.high - extent.low, 5, 1e-9);
  EXPECT_NEAR(extent.radius, 2, 1e-9);
}

/// What is drawn of shapes that are parts.
struct Drawn {
  std::vector<Curve3> lines;
  Camera camera;
  Diagnostics said;
};

Drawn drawn(const std::vector<TopoDS_Shape>& shapes, Vec3 direction, Vec3 up, bool hidden = false) {
  std::vector<std::shared_ptr<const Surface>> surfaces;
  std::vector<const ProxyMesh*> proxies;
  Box3 box;
  RunContext context;
  CentreLineOptions options{.over = {}, .hidden = hidden};
  for (const TopoDS_Shape& shape : shapes) {
    const auto form = test::brep_form(shape);
    surfaces.push_back(form->realise({.tolerance = 0.005}, context));
    proxies.push_back(&surfaces.back()->proxy());
    box.add(form->bounds(Mat3(1)));
    options.over.emplace_back(2.5);
  }
  const Camera camera = Camera::fit(
      [&](const Mat3& axes) {
        Box3 all;
        for (const TopoDS_Shape& shape : shapes) all.add(test::brep_form(shape)->bounds(axes));
        return all;
      },
      {.direction = direction, .up = up});
  const Occluder occluder(proxies, context);
  Drawn out{{}, camera, {}};
  out.lines = centre_lines(surfaces, camera, occluder, options, out.said, context);
  return out;
}

const Vec3 kX(1, 0, 0), kY(0, 1, 0), kZ(0, 0, 1);

TEST(CentreLines, AHoleSeenAlongItsAxisHasTwoLinesThatCross) {
  const Drawn d = drawn({test::plate_with_hole_shape()}, kZ, kY);
  ASSERT_EQ(d.lines.size(), 2U);
  for (const Curve3& line : d.lines) {
    EXPECT_EQ(line.kind, LineClass::Centre);
    EXPECT_EQ(line.source.part, 0);
    EXPECT_GE(line.source.face, 0);
    const Vec3 middle = 0.5 * (line.points[0] + line.points[1]);
    EXPECT_NEAR(middle.x, 5, 1e-9);
    EXPECT_NEAR(middle.y, 4, 1e-9);
    const double length =
        glm::distance(d.camera.to_paper(line.points[0]), d.camera.to_paper(line.points[1]));
    EXPECT_NEAR(length, 2 * (2 * d.camera.scale() + 2.5), 0.01);
  }
}

// Two flats take the round off on two sides, as those of a nut do.
TEST(CentreLines, MarksGoOverTheOutlineWhereItsCircleIsCutAway) {
  const TopoDS_Shape pin = BRepPrimAPI_MakeCylinder(10, 4).Shape();
  const TopoDS_Shape flats = BRepPrimAPI_MakeBox(gp_Pnt(-20, -8, -1), gp_Pnt(20, 8, 5)).Shape();
  const Drawn d = drawn({BRepAlgoAPI_Common(pin, flats).Shape()}, kZ, kY);
  ASSERT_EQ(d.lines.size(), 2U);
  for (const Curve3& line : d.lines) {
    const Vec2 way = d.camera.to_paper(line.points[1]) - d.camera.to_paper(line.points[0]);
    const double reach = std::abs(way.x) > std::abs(way.y) ? 10 : 8;
    EXPECT_NEAR(glm::length(way), 2 * (reach * d.camera.scale() + 2.5), 0.01);
  }
}

TEST(CentreLines, AHiddenHoleHasOneWhereHiddenLinesAreDrawn) {
  EXPECT_TRUE(drawn({test::plate_with_hole_shape()}, -kY, kZ).lines.empty());
  const Drawn d = drawn({test::plate_with_hole_shape()}, -kY, kZ, true);
  ASSERT_EQ(d.lines.size(), 1U);
  for (const Vec3& p : d.lines[0].points) {
    EXPECT_NEAR(p.x, 5, 1e-9);
    EXPECT_NEAR(p.y, 4, 1e-9);
  }
  EXPECT_NEAR(std::abs(d.lines[0].points[1].z - d.lines[0].points[0].z),
              1 + 2 * 2.5 / d.camera.scale(), 1e-9);
}

TEST(CentreLines, ADeepNarrowHoleHasOneWhereItsRimIsSeen) {
  const TopoDS_Shape drill =
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(20, 15, 5), gp_Dir(0, 0, 1)), 1.5, 30);
  const TopoDS_Shape block = BRepAlgoAPI_Cut(test::box_shape(40, 30, 30), drill).Shape();
  const Drawn d = drawn({block}, glm::normalize(Vec3(1, -1, 1)), kZ);
  ASSERT_EQ(d.lines.size(), 1U);
  for (const Vec3& p : d.lines[0].points) EXPECT_LT(std::hypot(p.x - 20, p.y - 15), 1e-9);
}

TEST(CentreLines, ALineRunsAlongTheAxisInAnyView) {
  const Drawn d = drawn({askew(test::cylinder_shape(4, 30))}, glm::normalize(Vec3(1, -1, 1)), kZ);
  ASSERT_EQ(d.lines.size(), 1U);
  const Axis axis{kThrough, kAlong};
  for (const Vec3& p : d.lines[0].points) EXPECT_LT(off(p, axis), 1e-9);
}

TEST(CentreLines, FilletsHaveNone) {
  EXPECT_TRUE(drawn({test::filleted_box_shape(0.5)}, kZ, kY, true).lines.empty());
  EXPECT_TRUE(drawn({test::filleted_box_shape(0.5)}, Vec3(1, -1, 1), kZ, true).lines.empty());
}

TEST(CentreLines, CoaxialFacesOfSeveralPartsShareOne) {
  const TopoDS_Shape shaft =
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, -20), gp_Dir(0, 0, 1)), 2, 60);
  const TopoDS_Shape ring =
      BRepAlgoAPI_Cut(test::cylinder_shape(6, 10), test::cylinder_shape(2, 10)).Shape();
  const Drawn side = drawn({ring, shaft}, kX, kZ);
  ASSERT_EQ(side.lines.size(), 1U);
  EXPECT_EQ(side.lines[0].source.part, 0) << "the ring is larger";
  EXPECT_NEAR(std::abs(side.lines[0].points[1].z - side.lines[0].points[0].z),
              60 + 2 * 2.5 / side.camera.scale(), 1e-6);
  EXPECT_EQ(drawn({ring, shaft}, kZ, kY).lines.size(), 2U);
}

TEST(CentreLines, WhatStandsBeforeAnAxisHidesIt) {
  const TopoDS_Shape wall = BRepPrimAPI_MakeBox(gp_Pnt(10, -5, 8), gp_Pnt(12, 5, 14));
  const Drawn d = drawn({test::cylinder_shape(2, 30), wall}, kX, kZ);
  ASSERT_EQ(d.lines.size(), 2U);
  for (const Curve3& line : d.lines) {
    const auto [low, high] = std::minmax(line.points[0].z, line.points[1].z);
    EXPECT_TRUE(high <= 8.5 || low >= 13.5) << low << " to " << high;
  }
}

TEST(CentreLines, SmallFacesHaveNoneAndAreCounted) {
  const TopoDS_Shape plate = test::box_shape(400, 300, 2);
  const TopoDS_Shape drill =
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(20, 20, -1), gp_Dir(0, 0, 1)), 0.5, 4);
  const Drawn d = drawn({BRepAlgoAPI_Cut(plate, drill).Shape()}, kZ, kY);
  EXPECT_TRUE(d.lines.empty());
  ASSERT_EQ(d.said.entries().size(), 1U);
  EXPECT_EQ(d.said.entries()[0].code, "centre_lines.small");
  EXPECT_EQ(d.said.entries()[0].count, 1);
}

}  // namespace
}  // namespace burin
