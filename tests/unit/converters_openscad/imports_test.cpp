#include <burin/base/error.h>

#include "flat/origins.h"
#include "flat_trees.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <string>

namespace burin::csg::test {
namespace {

std::string import_of(const std::string& file,
                      const std::string& more = "layer = \"\", scale = 1") {
  return "import(file = \"" + file + "\", origin = [0, 0], " + more +
         ", $fn = 0, $fa = 12, $fs = 2);";
}

/// The message of the InputError that `evaluate` throws; empty where it throws none.
template <typename Evaluate>
std::string refusal(Evaluate&& evaluate) {
  try {
    evaluate();
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

std::string dxf(const std::string& entities) {
  return "0\nSECTION\n2\nENTITIES\n" + entities + "0\nENDSEC\n0\nEOF\n";
}

TEST(Imports, DxfCirclesAndJoinedLines) {
  const Folder folder;
  folder.write(
      "plate.dxf",
      dxf("0\nLINE\n8\nouter\n10\n0\n20\n0\n11\n10\n21\n0\n"
          "0\nLINE\n8\nouter\n10\n10\n20\n8\n11\n10.0003\n21\n0\n"
          "0\nLWPOLYLINE\n8\nouter\n90\n3\n70\n0\n10\n10\n20\n8\n10\n0\n20\n8\n10\n0\n20\n0\n"
          "0\nCIRCLE\n8\ninner\n10\n5\n20\n4\n40\n2\n"));
  const double hole = 0.5 * 7 * 4 * std::sin(2 * M_PI / 7);
  EXPECT_NEAR(area(Evaluated(import_of("plate.dxf"), folder.path()).region()), 80 - hole, 2e-2);
  Evaluated outer(import_of("plate.dxf", "layer = \"outer\", scale = 2"), folder.path());
  EXPECT_NEAR(area(outer.region()), 320, 2e-2);
  EXPECT_TRUE(Evaluated(import_of("plate.dxf", "layer = \"none\", scale = 1"), folder.path())
                  .region()
                  .empty());
}

TEST(Imports, DxfEntitiesThatOpenScadLeavesOutAreTold) {
  const Folder folder;
  folder.write("spline.dxf", dxf("0\nSPLINE\n8\n0\n10\n0\n20\n0\n"));
  Evaluated tree(import_of("spline.dxf"), folder.path());
  EXPECT_TRUE(tree.region().empty());
  EXPECT_TRUE(tree.reported("openscad.dxf_entity"));
  // The end of the file is no entity.
  folder.write("circle.dxf", dxf("0\nCIRCLE\n8\n0\n10\n5\n20\n4\n40\n2\n"));
  Evaluated circle(import_of("circle.dxf"), folder.path());
  EXPECT_FALSE(circle.region().empty());
  EXPECT_FALSE(circle.reported("openscad.dxf_entity"));
}

TEST(Imports, SvgShapesStandUprightInMillimetres) {
  const Folder folder;
  folder.write("a.svg", R"svg(<svg width="100mm" height="50mm" viewBox="0 0 200 100">
<g transform="translate(20 10)"><rect x="0" y="0" width="40" height="20"/></g>
<defs><rect width="500" height="500"/></defs></svg>)svg");
  const Region region =
      Evaluated(import_of("a.svg", "center = false, dpi = 72, scale = 1"), folder.path()).region();
  EXPECT_NEAR(area(region), 200, 1e-3);
  ASSERT_EQ(region.outlines.size(), 1u);
  Vec2 low(1e9), high(-1e9);
  for (const Vec2& p : region.outlines[0].points) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  EXPECT_NEAR(glm::length(low - Vec2(10, 35)), 0, 1e-4);
  EXPECT_NEAR(glm::length(high - Vec2(30, 45)), 0, 1e-4);
}

TEST(Imports, CirclesAndArcsOfFilesAreKnown) {
  const Folder folder;
  folder.write("round.dxf", dxf("0\nLINE\n8\n0\n10\n5\n20\n0\n11\n5\n21\n10\n"
                                "0\nARC\n8\n0\n10\n5\n20\n5\n40\n5\n50\n90\n51\n270\n"
                                "0\nCIRCLE\n8\n0\n10\n30\n20\n4\n40\n9\n"));
  const Region dxf = Evaluated(import_of("round.dxf"), folder.path()).region();
  EXPECT_EQ(dxf.arcs.size(), 2u);
  // Half of 16 pieces, and 29; the grid of the file's points is 2^-10 mm.
  EXPECT_EQ(tagged_edges(dxf), 8u + 29u);
  EXPECT_LT(farthest_from_arcs(dxf), 1.0 / 1024);
  folder.write("round.svg", R"svg(<svg width="100mm" height="50mm" viewBox="0 0 200 100">
<g transform="rotate(20)"><circle cx="80" cy="0" r="20"/></g>
<rect x="100" y="20" width="40" height="30" rx="8"/><ellipse cx="170" cy="50" rx="10" ry="4"/></svg>)svg");
  const Region svg =
      Evaluated(import_of("round.svg", "center = false, dpi = 72, scale = 1"), folder.path())
          .region();
  EXPECT_EQ(svg.arcs.size(), 5u);
  EXPECT_EQ(tagged_edges(svg), 40u + 4 * 9u);
  EXPECT_LT(farthest_from_arcs(svg), 1e-9);
}

TEST(Imports, HeightsOfTextAreABlockAboveALevelBelowTheLowest) {
  const Folder folder;
  folder.write("h.dat", "# heights\n1 2 3\n1 2 3\n\n1 2 3\n");
  for (const char* center : {"true", "false"}) {
    const Solid solid = Evaluated("surface(file = \"h.dat\", center = " + std::string(center) +
                                      ", invert = false);",
                                  folder.path())
                            .solid();
    EXPECT_EQ(flaw(solid), "");
    EXPECT_NEAR(volume(solid), 4 * 2, 1e-9);
  }
  folder.write("deep.dat", "-4 -4\n-4 -4\n");
  EXPECT_NEAR(volume(Evaluated("surface(file = \"deep.dat\");", folder.path()).solid()), 1, 1e-9);
}

TEST(Imports, MeshesAndAmfAreClosedSolids) {
  const Folder folder;
  folder.write("t.off",
               "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n");
  const Solid off = Evaluated(import_of("t.off"), folder.path()).solid();
  EXPECT_EQ(flaw(off), "");
  EXPECT_NEAR(volume(off), 1.0 / 6, 1e-12);
  std::string amf = "<?xml version=\"1.0\"?><amf unit=\"inch\"><object id=\"0\"><mesh><vertices>";
  for (const char* v : {"<x>0</x><y>0</y><z>0</z>", "<x>2</x><y>0</y><z>0</z>",
                        "<x>0</x><y>2</y><z>0</z>", "<x>0</x><y>0</y><z> 2 </z>"}) {
    amf += "<vertex><coordinates>" + std::string(v) + "</coordinates></vertex>";
  }
  amf += "</vertices><volume>";
  for (const char* t : {"<v1>0</v1><v2>2</v2><v3>1</v3>", "<v1>0</v1><v2>1</v2><v3>3</v3>",
                        "<v1>1</v1><v2>2</v2><v3>3</v3>", "<v1>0</v1><v2>3</v2><v3>2</v3>"}) {
    amf += "<triangle>" + std::string(t) + "</triangle>";
  }
  folder.write("t.amf", amf + "</volume></mesh></object></amf>");
  EXPECT_NEAR(volume(Evaluated(import_of("t.amf"), folder.path()).solid()), 8.0 / 6, 1e-12);
}

TEST(Imports, AMissingFileIsToldAndLeftOut) {
  for (const char* file : {"none.dxf", "none.svg"}) {
    Evaluated tree(import_of(file));
    EXPECT_TRUE(tree.region().empty()) << file;
    EXPECT_TRUE(tree.reported("openscad.no_file")) << file;
  }
  for (const char* file : {"none.stl", "none.amf", "none.3mf"}) {
    Evaluated tree(import_of(file));
    EXPECT_TRUE(tree.solid().empty()) << file;
    EXPECT_TRUE(tree.reported("openscad.no_file")) << file;
  }
  Evaluated surface("surface(file = \"none.png\", center = false, invert = false);");
  EXPECT_TRUE(surface.solid().empty());
  EXPECT_TRUE(surface.reported("openscad.no_file"));
}

TEST(Imports, EndlessAndSpecialFilesAreRefused) {
  const Folder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe.dxf").c_str(), 0600), 0);
  ASSERT_EQ(::symlink("/dev/zero", (folder / "zero.svg").c_str()), 0);
  ASSERT_EQ(::symlink("/dev/zero", (folder / "zero.stl").c_str()), 0);
  for (const char* file : {"pipe.dxf", "zero.svg"}) {
    EXPECT_NE(refusal([&] { Evaluated(import_of(file), folder.path()).region(); }), "") << file;
  }
  EXPECT_NE(refusal([&] { Evaluated(import_of("zero.stl"), folder.path()).solid(); }), "");
  EXPECT_NE(refusal([&] { Evaluated("surface(file = \"zero.svg\");", folder.path()).solid(); }),
            "");
}

TEST(Imports, BrokenFilesAreRefusedWithOneLine) {
  const Folder folder;
  folder.write("b.dxf", "0\nSECTION\nfoo\nbar\n");
  folder.write("b.svg", "<svg><g></svg>");
  folder.write("b.amf",
               "<amf><object><mesh><vertices/><volume><triangle><v1>7</v1><v2>1</v2><v3>2</"
               "v3></triangle></volume></mesh></object></amf>");
  folder.write("b.dat", "1 2\nx y\n");
  for (const char* file : {"b.dxf", "b.svg"}) {
    const std::string said = refusal([&] { Evaluated(import_of(file), folder.path()).region(); });
    EXPECT_NE(said, "") << file;
    EXPECT_EQ(said.find('\n'), std::string::npos) << file;
  }
  EXPECT_NE(refusal([&] { Evaluated(import_of("b.amf"), folder.path()).solid(); }), "");
  EXPECT_NE(refusal([&] { Evaluated("surface(file = \"b.dat\");", folder.path()).solid(); }), "");
}

TEST(BadInput, AbsurdNumbersAreRefusedWithTheirLine) {
  const std::string square = "{ square(size = [2, 2], center = false); }";
  std::string zigzag = "polygon(paths = undef, points = [[40,-99]";
  for (int i = 0; i < 40; ++i) {
    zigzag += ",[" + std::to_string(i) + "," + (i % 2 == 0 ? "0" : "50") + "]";
  }
  zigzag += "]);";
  for (const std::string& text : {
           std::string("circle($fn = 1e9, r = 1);"),
           "linear_extrude(height = 1, twist = 90, slices = 1000000000) " + square,
           "rotate_extrude(angle = 360, $fn = 1e9) " + square,
           "offset(r = 1, $fn = 1e9) " + square,
           "offset(r = 1, $fn = 1000000) { " + zigzag + " }",
           std::string("text(text = \"a\", size = 10, $fn = 1e9);"),
           std::string("linear_extrude(height = 1) { polygon(points = [[0,0],[1e300,0],[0,1]], "
                       "paths = undef); }"),
       }) {
    try {
      Evaluated tree("\n\n" + text);
      tree.is_flat() ? void(tree.region()) : void(tree.solid());
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_EQ(error.line(), 3) << text;
      EXPECT_EQ(error.file(), "test.csg") << text;
    }
  }
}

TEST(BadInput, WhatIsNoNumberDrawsNothing) {
  for (const char* text :
       {"square(size = [nan, 2], center = false);", "square(size = [inf, 2], center = true);",
        "circle($fn = 10, r = nan);", "circle($fn = 10, r = -3);",
        "polygon(points = [[0,0],[nan,1],[2,2]], paths = undef);",
        "polygon(points = [[0,0],[inf,1],[2,2]], paths = undef);",
        "polygon(points = [[0,0],[1,1]], paths = undef);",
        "multmatrix([[nan,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) { circle($fn = 9, r = 1); }",
        "multmatrix([[0,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) { circle($fn = 9, r = 1); }"}) {
    EXPECT_TRUE(Evaluated(text).region().empty()) << text;
  }
}

TEST(BadInput, ShapesAcrossTheAxisAreToldAndLeftOut) {
  Evaluated tree("rotate_extrude(angle = 360, $fn = 20) { circle($fn = 20, r = 2); }");
  EXPECT_TRUE(tree.solid().empty());
  EXPECT_TRUE(tree.reported("openscad.across_axis"));
}

TEST(BadInput, TextWithoutGlyphsOrFont) {
  EXPECT_TRUE(Evaluated("text(text = \"\", size = 10);").region().empty());
  EXPECT_TRUE(Evaluated("text(text = \"   \", size = 10);").region().empty());
  Evaluated missing("text(text = \"a\", size = 10, font = \"No Such Font At All\");");
  if (missing.region().empty()) GTEST_SKIP() << "no font is installed";
  EXPECT_TRUE(missing.reported("openscad.font_replaced"));
}

}  // namespace
}  // namespace burin::csg::test
