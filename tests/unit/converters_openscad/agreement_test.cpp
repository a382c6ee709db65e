#include "flat/origins.h"
#include "flat_trees.h"

#include <gtest/gtest.h>

#include <array>
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

void expect_agreement(const Folder& folder, const std::string& program) {
  const auto tree = tree_of(folder.write("case.scad", program));
  ASSERT_TRUE(tree);
  Evaluated ours(*tree, folder.path());
  const Solid solid = ours.solid();
  EXPECT_EQ(flaw(solid), "");
  const double theirs = openscad_volume(folder.write("case.csg", *tree));
  EXPECT_NEAR(volume(solid), theirs, kAgree * theirs);
  EXPECT_GT(theirs, 0);
}

class Agreement : public ::testing::TestWithParam<Case> {};

TEST_P(Agreement, VolumeIsThatOfOpenScad) {
  if (!has_program("openscad")) GTEST_SKIP() << "openscad is not installed";
  const std::string program = GetParam().program;
  expect_agreement(Folder(), GetParam().flat ? "linear_extrude(1) { " + program + "\n}" : program);
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

/// A DXF file of lines, x0 y0 x1 y1 each, and of other entities.
std::string dxf_of_lines(const std::vector<std::array<int, 4>>& lines,
                         const std::string& more = {}) {
  std::string out = "0\nSECTION\n2\nENTITIES\n";
  for (const auto& [a, b, c, d] : lines) {
    out += "0\nLINE\n8\n0\n10\n" + std::to_string(a) + "\n20\n" + std::to_string(b) + "\n11\n" +
           std::to_string(c) + "\n21\n" + std::to_string(d) + "\n";
  }
  return out + more + "0\nENDSEC\n0\nEOF\n";
}

TEST(FileAgreement, DxfLinesThatCrossGoTogetherAsInOpenScad) {
  if (!has_program("openscad")) GTEST_SKIP() << "openscad is not installed";
  const Folder folder;
  folder.write("mesh.dxf", dxf_of_lines({{50, 140, 0, 140},
                                         {140, 0, 0, 0},
                                         {0, 0, 0, 140},
                                         {50, 140, 0, 0},
                                         {50, 140, 45, 100},
                                         {45, 100, 60, 80},
                                         {0, 0, 45, 100},
                                         {45, 50, 140, 0},
                                         {60, 80, 45, 50},
                                         {45, 50, 0, 0},
                                         {45, 100, 45, 50}}));
  expect_agreement(folder, "linear_extrude(1) import(\"mesh.dxf\");");
  folder.write(
      "open.dxf",
      dxf_of_lines({{0, 0, 9, 0}, {9, 0, 9, 9}, {9, 9, 0, 0}, {9, 9, 12, 14}, {12, 14, 3, 12}}));
  expect_agreement(folder, "linear_extrude(1) import(\"open.dxf\");");
}

TEST(FileAgreement, DxfCurvesAndBlocks) {
  if (!has_program("openscad")) GTEST_SKIP() << "openscad is not installed";
  const Folder folder;
  folder.write(
      "curves.dxf",
      dxf_of_lines(
          {{20, 0, 20, 10}},
          "0\nARC\n8\na\n10\n20\n20\n5\n40\n5\n50\n90\n51\n270\n"
          "0\nCIRCLE\n8\na\n10\n40\n20\n5\n40\n7.5\n"
          "0\nELLIPSE\n8\nb\n10\n6\n20\n25\n11\n4\n21\n3\n40\n0.5\n41\n0\n42\n6.2831853\n"
          "0\nLWPOLYLINE\n8\nb\n90\n3\n70\n1\n10\n12\n20\n20\n10\n27\n20\n22\n10\n17\n20\n29\n"));
  const std::string blocks =
      "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nb\n0\nLWPOLYLINE\n8\n0\n90\n3\n70\n1\n10\n0\n20\n0\n10\n"
      "5\n20\n"
      "0\n10\n1\n20\n4\n0\nENDBLK\n0\nENDSEC\n";
  folder.write(
      "blocks.dxf",
      blocks + dxf_of_lines({}, "0\nINSERT\n8\n0\n2\nb\n10\n3\n20\n4\n41\n2\n42\n1.5\n50\n30\n"));
  expect_agreement(folder, "linear_extrude(1) import(\"curves.dxf\", $fn = 30);");
  expect_agreement(
      folder,
      "linear_extrude(1) import(\"curves.dxf\", layer = \"b\", scale = 2, origin = [3, 1]);");
  expect_agreement(folder, "linear_extrude(1) import(\"blocks.dxf\");");
}

TEST(FileAgreement, SvgShapesPathsAndStrokes) {
  if (!has_program("openscad")) GTEST_SKIP() << "openscad is not installed";
  const Folder folder;
  folder.write("all.svg", R"svg(<?xml version="1.0"?>
<svg xmlns="http://www.w3.org/2000/svg" width="80mm" height="60mm" viewBox="10 20 400 200" preserveAspectRatio="xMaxYMid slice">
<g transform="translate(30,40) rotate(10 5 5) scale(1.5)"><rect width="40" height="20" rx="5"/></g>
<circle cx="200" cy="80" r="30"/><ellipse cx="300" cy="80" rx="40" ry="10" transform="skewX(20)"/>
<path d="M50,150 c10-20 40-20 50,0 s 40,20 50 0 l0,50 h-100z m10,10 q 5 20 10 0 t 10 0 z"/>
<path d="M200,200 A 30 20 30 1 1 240 210 L 220 230 Z"/>
<polyline points="20,30 60,35 80,60" style="stroke-width:6;stroke-linejoin:round;stroke-linecap:butt"/>
<line x1="320" y1="120" x2="380" y2="200" stroke-width="8" stroke-linecap="round"/>
<polygon points="300,200 350,220 310,240" transform="matrix(1 0.2 0 1 5 -60)"/></svg>)svg");
  for (const char* how : {"", ", center = true", ", dpi = 96"}) {
    expect_agreement(folder, "linear_extrude(1) import(\"all.svg\"" + std::string(how) + ");");
  }
}

TEST(FileAgreement, HeightsOfTextAndPictures) {
  if (!has_program("openscad")) GTEST_SKIP() << "openscad is not installed";
  const Folder folder;
  folder.write("h.dat", "1 2 3.5\n# a comment\n-2 4 1\n0 0 2\n");
  expect_agreement(folder, "surface(\"h.dat\", center = true);");
}

}  // namespace
}  // namespace burin::csg::test
