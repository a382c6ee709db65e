#include "flat_trees.h"
#include "origins.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace burin::csg::test {
namespace {

// Of the volume; OpenSCAD rounds to a grid of 2^-16 mm and writes six digits.
constexpr double kAgree = 1e-5;

/// A program of 2-D shapes, extruded by 1 mm; or of solids.
struct Case {
  const char* name;
  const char* program;
  bool flat = true;
};

class Agreement : public ::testing::TestWithParam<Case> {};

TEST_P(Agreement, VolumeIsThatOfOpenScad) {
  if (!has_program("openscad")) GTEST_SKIP() << "openscad is not installed";
  const Folder folder;
  const std::string program = GetParam().program;
  const std::string file = folder.write(
      "case.scad", GetParam().flat ? "linear_extrude(1) { " + program + "\n}" : program);
  const auto tree = tree_of(file);
  ASSERT_TRUE(tree);
  Evaluated ours(*tree, folder.path());
  const Solid solid = ours.solid();
  EXPECT_EQ(flaw(solid), "");
  const double theirs = openscad_volume(folder.write("case.csg", *tree));
  EXPECT_NEAR(volume(solid), theirs, kAgree * theirs);
  EXPECT_GT(theirs, 0);
}

const Case kCases[] = {
    {"circle", "circle(7.3);"},
    {"fine_circle", "circle(r = 3, $fa = 1, $fs = 0.1);"},
    {"tiny_circle", "circle(r = 0.05);"},
    {"star", "polygon([[0,0],[10,0],[2,7],[5,-4],[8,7]]);"},
    {"paths", "polygon([[0,0],[9,0],[9,9],[0,9],[2,2],[7,2],[7,7]], [[0,1,2,3],[4,5,6]]);"},
    {"mixed",
     "difference() { union() { square(10); translate([5,5]) circle(6); } "
     "rotate(30) square([20,3], center=true); }"},
    {"intersection_of_three",
     "intersection() { circle(10); translate([4,0]) circle(10); translate([0,4]) square(20); }"},
    {"mirrored", "mirror([1,2]) polygon([[0,0],[10,0],[3,7]]);"},
    {"sheared", "multmatrix([[1,0.3,0,2],[0.1,1,0,1]]) circle(5);"},
    {"offset_round", "offset(r=1.5) polygon([[0,0],[10,0],[3,7]]);"},
    {"offset_round_fine", "offset(r=3, $fn=90) polygon([[0,0],[10,0],[2,3],[3,9]]);"},
    {"offset_in", "offset(r=-1) difference() { square(12); translate([4,4]) circle(2); }"},
    {"offset_sharp", "offset(delta=2) polygon([[0,0],[10,0],[2,3],[3,9]]);"},
    {"offset_chamfer", "offset(delta=2, chamfer=true) polygon([[0,0],[10,0],[2,3],[3,9]]);"},
    {"offset_in_chamfer", "offset(delta=-1, chamfer=true) polygon([[0,0],[10,0],[2,3],[3,9]]);"},
    {"hull", "hull() { circle(3); translate([10,4]) square(3); translate([5,-8]) circle(1); }"},
    {"minkowski",
     "minkowski() { difference() { square(20); translate([5,5]) square(8); } circle(2); }"},
    {"minkowski_of_three", "minkowski() { square(5); circle(1); polygon([[0,0],[3,1],[1,4]]); }"},
    {"resize", "resize([20,0], auto=true) polygon([[0,0],[10,0],[3,7]]);"},
    {"resize_both", "resize([20,3]) circle(4);"},
    {"text", "text(\"Burin 0.3\");"},
    {"text_fine", "text(\"Se&8%\", size=7, $fn=64);"},
    {"text_spaced", "text(\"Wave\", size=20, spacing=1.3, halign=\"center\", valign=\"center\");"},
    {"text_right_top", "text(\"gypsy\", halign=\"right\", valign=\"top\");"},
    {"text_bottom", "text(\"gypsy\", valign=\"bottom\");"},
    {"text_down", "text(\"down\", direction=\"ttb\");"},
    {"text_leftwards", "text(\"left\", direction=\"rtl\");"},
    {"text_bold", "text(\"Bold\", font=\"Liberation Sans:style=Bold Italic\");"},
    {"text_serif", "text(\"Serif\", font=\"DejaVu Serif\");"},
    {"text_of_a_missing_font", "text(\"Ersatz\", font=\"No Such Font\");"},
    {"text_tight", "text(\"overlap\", spacing=0.5);"},
    {"text_greek", "text(\"\u03b1\u03b2\u03b3 \u0416\");"},
    {"scaled", "linear_extrude(5, scale=[2,0.5]) circle(4);", false},
    {"scaled_evenly", "linear_extrude(5, scale=0.3, center=true) translate([3,1]) circle(4);",
     false},
    {"pyramid", "linear_extrude(5, scale=0) square(6, center=true);", false},
    {"pyramid_aside", "linear_extrude(5, scale=0) translate([2,3]) circle(3);", false},
    {"roof", "linear_extrude(5, scale=[1,0]) square(6, center=true);", false},
    {"roof_of_a_circle", "linear_extrude(5, scale=[0,1], $fn=12) circle(4, $fn=16);", false},
    {"twisted", "linear_extrude(10, twist=75) square([8,3]);", false},
    {"twisted_back", "linear_extrude(10, twist=-300, slices=17) square([8,3], center=true);",
     false},
    {"twisted_fine", "linear_extrude(10, twist=120, $fn=40) translate([2,0]) circle(3);", false},
    {"twisted_and_scaled", "linear_extrude(10, twist=120, scale=2) translate([2,0]) circle(3);",
     false},
    {"twisted_to_a_point", "linear_extrude(10, twist=90, scale=0) square(4, center=true);", false},
    {"twisted_ring",
     "linear_extrude(10, twist=90, scale=[1,2]) difference() { circle(5); translate([1,0]) "
     "square(2); }",
     false},
    {"turned", "rotate_extrude() translate([5,0]) circle(2);", false},
    {"turned_part", "rotate_extrude(angle=110) translate([5,0]) circle(2);", false},
    {"turned_back", "rotate_extrude(angle=-70, $fn=50) translate([5,1]) square([2,3]);", false},
    {"turned_from_the_left", "rotate_extrude($fn=7) translate([-5,1]) square([2,3]);", false},
    {"turned_part_from_the_left", "rotate_extrude(angle=200) translate([-5,1]) square([2,3]);",
     false},
    {"turned_at_the_axis", "rotate_extrude() polygon([[0,0],[4,1],[2,3],[0,5]]);", false},
    {"shadow",
     "projection() rotate([40,20,0]) linear_extrude(8) difference() { circle(5); circle(3); }"},
    {"cut",
     "projection(cut=true) rotate([40,20,0]) linear_extrude(8, center=true) difference() { "
     "square(10, center=true); circle(3); }"},
    {"cut_in_a_face", "projection(cut=true) linear_extrude(8) square(4);"},
};

INSTANTIATE_TEST_SUITE_P(Programs, Agreement, ::testing::ValuesIn(kCases),
                         [](const auto& of) { return std::string(of.param.name); });

}  // namespace
}  // namespace burin::csg::test
