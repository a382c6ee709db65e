#include "csg_worked.h"

#include <gtest/gtest.h>

namespace burin::csg::test {
namespace {

// Of the volume: OpenSCAD writes six digits of each coordinate.
constexpr double kCsgAgrees = 1e-5;

struct CsgCase {
  const char* name;
  const char* program;
};

class SolidAgreement : public ::testing::TestWithParam<CsgCase> {};

TEST_P(SolidAgreement, VolumeIsThatOfOpenScad) {
  if (!has_program("openscad")) GTEST_SKIP() << "openscad is not installed";
  const Folder folder;
  const auto tree = tree_of(folder.write("case.scad", GetParam().program));
  ASSERT_TRUE(tree);
  const Worked ours = work_out(*tree, 0, folder.path());
  EXPECT_EQ(open_edges(ours.solid), 0u);
  const double theirs = openscad_volume(folder.write("case.csg", *tree));
  EXPECT_GT(theirs, 0);
  EXPECT_NEAR(volume(ours.solid), theirs, kCsgAgrees * theirs);
}

const CsgCase kCsgCases[] = {
    {"drilled_ball",
     "difference() { sphere(10, $fn=40); for (a=[0,90]) rotate([a,0,0]) cylinder(h=40, r=3, "
     "center=true, $fn=30); }"},
    {"turned_boxes", "for (i=[0:7]) rotate([10*i, 20*i, 30*i]) cube([8,3,2]);"},
    {"crossing_tubes",
     "difference() { union() { cylinder(h=20,r=5,center=true); rotate([90,0,0]) "
     "cylinder(h=20,r=4,center=true); } cylinder(h=30,r=3,center=true); rotate([90,0,0]) "
     "cylinder(h=30,r=2,center=true); }"},
    {"cones",
     "intersection() { cylinder(h=10,r1=8,r2=0,$fn=50); translate([2,1,-1]) "
     "cylinder(h=10,r1=0,r2=9,$fn=40); }"},
    {"hull_of_balls",
     "hull() { sphere(3); translate([10,0,0]) sphere(2); translate([0,8,3]) cube(2); }"},
    {"rounded_plate",
     "minkowski() { difference() { cube([20,10,2]); translate([5,5,-1]) cylinder(h=4,r=3,$fn=12); "
     "} sphere(1,$fn=10); }"},
    {"sum_of_two_with_notches",
     "minkowski() { difference() { cube(6); translate([2,2,-1]) cube([2,5,9]); } difference() { "
     "cube(2); translate([1,-1,-1]) cube([3,2,4]); } }"},
    {"resized_cut",
     "resize([30,0,0], auto=true) difference() { sphere(5,$fn=30); translate([1,1,1]) cube(9); }"},
    {"extrusions",
     "difference() { linear_extrude(5, twist=60, slices=12) square(10, center=true); "
     "translate([0,0,-1]) rotate_extrude($fn=40) translate([3,0]) circle(1); }"},
    {"pattern",
     "difference() { cube([5,5,1]); for (x=[1:4], y=[1:4]) translate([x,y,-1]) "
     "cylinder(h=3,r=0.3,$fn=12); }"},
    {"stack", "for (i=[0:9]) translate([0,0,i*0.3]) rotate(i*9) cube([4,4,0.3], center=true);"},
    {"projected",
     "linear_extrude(2) projection(cut=true) translate([0,0,1]) difference() { sphere(6,$fn=30); "
     "cylinder(h=20,r=2,center=true,$fn=20); }"},
};

INSTANTIATE_TEST_SUITE_P(Csg, SolidAgreement, ::testing::ValuesIn(kCsgCases),
                         [](const auto& i) { return std::string(i.param.name); });

}  // namespace
}  // namespace burin::csg::test
