#include "reading.h"

#include <cmath>
#include <utility>
#include <vector>

namespace burin {
namespace {

using test::expect_error;
using test::read_bytes;

const TriMesh kTorus = test::torus(5, 2, 24, 16);

TEST(StlBinary, WeldsCornersInTheOrderOfAppearance) {
  const MeshFile file = read_bytes(test::stl_binary(kTorus), "a.stl");
  EXPECT_EQ(file.format, "STL (binary)");
  ASSERT_EQ(file.objects.size(), 1u);
  const PolygonSoup& soup = file.objects[0];
  EXPECT_EQ(soup.positions.size(), kTorus.positions.size());
  EXPECT_EQ(soup.polygon_count(), kTorus.triangles.size());
  std::uint32_t next = 0;
  for (std::size_t i = 0; i < soup.indices.size(); ++i) {
    EXPECT_LE(soup.indices[i], next);
    next += soup.indices[i] == next;
    const Vec3& p = kTorus.positions[kTorus.triangles[i / 3][i % 3]];
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(soup.positions[soup.indices[i]][k], static_cast<double>(static_cast<float>(p[k])));
    }
  }
}

TEST(StlBinary, MayBeginWithSolid) {
  const MeshFile file = read_bytes(test::stl_binary(kTorus, "solid facet normal"), "a.stl");
  EXPECT_EQ(file.format, "STL (binary)");
  EXPECT_EQ(file.objects.at(0).polygon_count(), kTorus.triangles.size());
}

TEST(StlBinary, IsKnownUnderAnyName) {
  EXPECT_EQ(read_bytes(test::stl_binary(kTorus), "a.obj").format, "STL (binary)");
  EXPECT_EQ(read_bytes(test::stl_binary(kTorus), "a.bin").format, "STL (binary)");
}

TEST(StlBinary, TrailingBytesAreIgnoredAndTold) {
  const MeshFile file = read_bytes(test::stl_binary(kTorus) + "garbage", "a.stl");
  EXPECT_EQ(file.objects.at(0).polygon_count(), kTorus.triangles.size());
  EXPECT_EQ(test::count_of(file.diagnostics, "stl.trailing_bytes"), 7);
}

TEST(StlBinary, FalseCountsAreRefused) {
  std::string bytes = test::stl_binary(kTorus);
  bytes.replace(80, 4, test::raw(std::uint32_t{0xfffffff0u}));
  expect_error(bytes, "a.stl", 0,
               "at byte 80: the binary STL claims 4294967280 triangles, its bytes hold 768");
  bytes.replace(80, 4, test::raw(std::uint32_t{0}));
  expect_error(bytes.substr(0, 84), "a.stl", 0, "at byte 80: the binary STL holds no triangles");
}

TEST(StlBinary, ACountOfZeroIsThatOfTheBytes) {
  std::string bytes = test::stl_binary(kTorus);
  bytes.replace(80, 4, test::raw(std::uint32_t{0}));
  for (const char* name : {"a.stl", "noname"}) {
    const MeshFile file = read_bytes(bytes, name);
    EXPECT_EQ(file.format, "STL (binary)");
    EXPECT_EQ(file.objects.at(0).polygon_count(), kTorus.triangles.size());
    ASSERT_EQ(file.diagnostics.entries().size(), 1u);
    EXPECT_EQ(file.diagnostics.entries()[0].code, "stl.zero_count");
    EXPECT_EQ(file.diagnostics.entries()[0].severity, Severity::Warning);
  }
  EXPECT_EQ(read_bytes(bytes, "a.obj").format, "STL (binary)");
  EXPECT_EQ(read_bytes(bytes + "xy", "a.stl").objects.at(0).polygon_count(),
            kTorus.triangles.size());
}

TEST(StlBinary, TruncatedFilesAreRefused) {
  const std::string bytes = test::stl_binary(kTorus);
  expect_error(bytes.substr(0, bytes.size() - 1), "a.stl", 0, "at byte 80");
  expect_error(bytes.substr(0, 90), "a.stl", 0, "at byte 80");
  expect_error(std::string(40, '\0'), "a.stl", 0,
               "at byte 40: the file ends inside the 84-byte header");
}

TEST(StlBinary, NaNTrianglesAreLeftOut) {
  std::string bytes = test::stl_binary(kTorus);
  bytes.replace(84 + 12, 4, test::raw(std::nanf("")));
  const Scene scene = test::read_scene(bytes, "a.stl");
  EXPECT_EQ(test::count_of(scene.diagnostics, "mesh.bad_coordinates"), 1);
}

TEST(StlAscii, ReadsDoubles) {
  const TriMesh box = test::precise_box();
  const MeshFile file = read_bytes(test::stl_ascii(box), "a.stl");
  EXPECT_EQ(file.format, "STL (ASCII)");
  ASSERT_EQ(file.objects.size(), 1u);
  EXPECT_EQ(file.objects[0].name, "part");
  ASSERT_EQ(file.objects[0].positions.size(), 36u);
  for (std::size_t i = 0; i < 36; ++i) {
    EXPECT_EQ(file.objects[0].positions[i], box.positions[box.triangles[i / 3][i % 3]]);
  }
}

TEST(StlAscii, SolidsArePartsByName) {
  const std::string wheel = test::stl_ascii(kTorus, "the wheel"),
                    hub = test::stl_ascii(test::box({5, 5, 5}, {6, 6, 6}), "hub");
  // Closed ones of one name are copies; open ones are pieces of one solid.
  const Scene copies = test::read_scene(
      wheel + hub + test::stl_ascii(test::box({9, 9, 9}, {10, 10, 10}), "the wheel"), "a.stl");
  ASSERT_EQ(copies.parts.size(), 3u);
  EXPECT_EQ(copies.parts[0].name, "the wheel");
  EXPECT_EQ(copies.parts[1].name, "hub");
  EXPECT_EQ(copies.parts[2].name, "the wheel");
  TriMesh left = test::box({7, 7, 7}, {8, 8, 8}), right = test::box({9, 9, 9}, {10, 10, 10});
  left.triangles.pop_back();
  right.triangles.pop_back();
  const Scene pieces =
      test::read_scene(test::stl_ascii(left, "lid") + hub + test::stl_ascii(right, "lid"), "a.stl");
  ASSERT_EQ(pieces.parts.size(), 2u);
  EXPECT_EQ(pieces.parts[0].name, "lid");
  EXPECT_DOUBLE_EQ(pieces.parts[0].form->bounds(Mat3(1)).max.x, 10);
}

// Slicers call a mesh as the file that it came from.
TEST(Stl, NamesThatAreFilesOrMadeUpNumbersAreNone) {
  const auto name = [](const std::string& solid) {
    return test::read_scene(test::stl_ascii(kTorus, solid), "ring.stl").parts.at(0).name;
  };
  EXPECT_EQ(name("foot left.stl"), "foot left");
  EXPECT_EQ(name("C:\\parts\\foot.STL"), "foot");
  EXPECT_EQ(name("/home/a/foot.step"), "foot");
  EXPECT_EQ(name("4294f09b-1f2e-4b15-b14f-f6db5a48c747.stl"), "ring");
  EXPECT_EQ(name("bolt.001"), "bolt.001");
  EXPECT_EQ(name("1/4 inch"), "1/4 inch");
  EXPECT_EQ(name("Dr. Who"), "Dr. Who");
}

TEST(StlAscii, NamesThatProgramsMakeUpSayNothing) {
  for (const char* name : {"OpenSCAD_Model", "vcg", "Exported from Blender-3.6.2", "Default"}) {
    EXPECT_EQ(read_bytes(test::stl_ascii(kTorus, name), "a.stl").objects.at(0).name, "") << name;
  }
  EXPECT_EQ(test::read_scene(test::stl_ascii(kTorus, "vcg"), "foot.stl").parts.at(0).name, "foot");
  const std::string two =
      test::stl_ascii(kTorus, "Mesh") + test::stl_ascii(test::box({9, 9, 9}, {10, 10, 10}), "lid");
  EXPECT_EQ(read_bytes(two, "a.stl").objects.at(0).name, "Mesh");
}

TEST(StlAscii, PatchesOfOneSurfaceAreOnePart) {
  TriMesh lid = test::box({0, 0, 0}, {1, 1, 1}), rest = lid;
  rest.triangles.assign(lid.triangles.begin() + 2, lid.triangles.end());
  lid.triangles.resize(2);
  const MeshFile file =
      read_bytes(test::stl_ascii(lid, "inlet") + test::stl_ascii(rest, "wall"), "a.stl");
  ASSERT_EQ(file.objects.size(), 1u);
  EXPECT_EQ(test::count_of(file.diagnostics, "mesh.joined_groups"), 1);
}

TEST(StlAscii, TouchingSolidsStayParts) {
  const std::string bytes = test::stl_ascii(test::box({0, 0, 0}, {1, 1, 1}), "a") +
                            test::stl_ascii(test::box({1, 0, 0}, {2, 1, 1}), "b");
  EXPECT_EQ(read_bytes(bytes, "a.stl").objects.size(), 2u);
}

TEST(StlAscii, TakesCaseLineEndsAndLayoutAsTheyCome) {
  std::string bytes = test::stl_ascii(kTorus, "x");
  for (const char* ends : {"\r\n", "\r", "\n\n  \t"}) {
    std::string changed;
    for (const char c : bytes) c == '\n' ? changed += ends : changed += c;
    EXPECT_EQ(read_bytes(changed, "a.stl").objects.at(0).polygon_count(), kTorus.triangles.size());
  }
  const std::string loud =
      "SOLID\nFACET NORMAL nan nan nan OUTER LOOP VERTEX +1 0 0 VERTEX 0 1e0 0\nVERTEX 0 0 1. "
      "ENDLOOP ENDFACET\nfacet outer loop vertex 0 0 0 vertex 1 0 0 vertex 1 1 0 vertex 0 1 0 "
      "endloop "
      "endfacet ENDSOLID";
  const MeshFile file = read_bytes(loud, "a.stl");
  EXPECT_EQ(file.objects.at(0).offsets, (std::vector<std::size_t>{0, 3, 7}));
}

/// The text with every `from` as `to`.
std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at)) {
    text.replace(at, from.size(), to);
    at += to.size();
  }
  return text;
}

TEST(StlAscii, WordsMayBePartedOrGlued) {
  const std::string bytes = test::stl_ascii(kTorus, "ring") + test::stl_ascii(kTorus, "disc");
  const std::vector<std::pair<std::string, std::string>> dialects = {
      {"endsolid", "end solid"},       {"endloop", "end loop"},     {"endfacet", "END  Facet"},
      {"facet normal", "facetnormal"}, {"outer loop", "outerloop"}, {"vertex ", "vertex"},
      {"outer loop", "Outer\tLoop"}};
  for (const auto& [from, to] : dialects) {
    const MeshFile file = read_bytes(replaced(bytes, from, to), "a.stl");
    ASSERT_EQ(file.objects.size(), 2u) << to;
    EXPECT_EQ(file.objects[0].name, "ring") << to;
    EXPECT_EQ(file.objects[1].name, "disc") << to;
    EXPECT_EQ(file.objects[0].polygon_count(), kTorus.triangles.size()) << to;
    EXPECT_EQ(file.objects[1].polygon_count(), kTorus.triangles.size()) << to;
    EXPECT_TRUE(file.diagnostics.empty()) << to;
  }
  std::string glued = bytes;
  for (const auto& [from, to] : {dialects[3], dialects[4]}) glued = replaced(glued, from, to);
  EXPECT_EQ(read_bytes(glued, "noname").objects.size(), 2u);
}

TEST(StlAscii, MayStandOnOneLine) {
  const std::string both = test::stl_ascii(kTorus, "the ring") +
                           test::stl_ascii(test::box({9, 9, 9}, {10, 10, 10}), "solid disc");
  for (const char* between : {" ", "\t  "}) {
    const MeshFile file = read_bytes(replaced(both, "\n", between), "a.stl");
    ASSERT_EQ(file.objects.size(), 2u);
    EXPECT_EQ(file.objects[0].name, "the ring");
    EXPECT_EQ(file.objects[0].polygon_count(), kTorus.triangles.size());
    EXPECT_EQ(file.objects[1].polygon_count(), 12u);
    EXPECT_TRUE(file.diagnostics.empty());
  }
  const std::string bare =
      "solid facet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 "
      "1 0 endloop endfacet endsolid";
  EXPECT_EQ(read_bytes(bare, "a.stl").objects.at(0).name, "");
  // Line ends that were taken out, so that words and numbers touch.
  const std::string touching =
      "solid a\nfacet normal 0 0 1outer loopvertex 0 0 0vertex 1 0 0vertex 0 1 0endloopendfacet"
      "facet normal 0 0 1e0outer loopvertex 0 0 0vertex 0 1 0vertex 0 0 1endloopendfacetendsolid a";
  EXPECT_EQ(read_bytes(touching, "a.stl").objects.at(0).polygon_count(), 2u);
}

TEST(StlAscii, WordsMayBeGluedToTheNext) {
  const std::string bytes = test::stl_ascii(kTorus, "ring");
  for (const auto& [from, to] : {std::pair("endfacet\n  facet", "endfacetfacet"),
                                 std::pair("endfacet\nfacet", "endfacetfacet"),
                                 std::pair("endfacet\nendsolid", "endfacetendsolid")}) {
    const MeshFile file = read_bytes(replaced(bytes, from, to), "a.stl");
    EXPECT_EQ(file.objects.at(0).polygon_count(), kTorus.triangles.size()) << to;
  }
}

TEST(StlAscii, PaddingAtTheEndIsNoWord) {
  const std::string bytes = test::stl_ascii(test::box({0, 0, 0}, {1, 2, 3}), "box");
  for (const std::string& padding : {std::string("\x1a"), std::string(600, '\0'),
                                     std::string("\r\n\x1a\r\n"), std::string(70, '\x1a')}) {
    const MeshFile file = read_bytes(bytes + padding, "a.stl");
    EXPECT_EQ(file.format, "STL (ASCII)");
    EXPECT_EQ(file.objects.at(0).polygon_count(), 12u);
    EXPECT_TRUE(file.diagnostics.empty());
  }
  expect_error("solid a\n\x1a", "a.stl", 0, "holds no triangles");
}

TEST(StlAscii, CommasForPoints) {
  const std::string head = "solid a\nfacet normal 0,0 0,0 1,0\nouter loop\n";
  const std::string tail = "endloop\nendfacet\nendsolid a\n";
  const auto points = [&](const std::string& vertices) {
    return read_bytes(head + vertices + tail, "a.stl");
  };
  const std::vector<Vec3> expected = {{1.5, 2, -0.25}, {10, 0, 0}, {0, 1200, 0}};
  const MeshFile decimal =
      points("vertex 1,5 2,000 -0,25\nvertex 10 0,0 0\nvertex 0 1,2e+03 0,0e0\n");
  EXPECT_EQ(decimal.objects.at(0).positions, expected);
  EXPECT_EQ(test::count_of(decimal.diagnostics, "stl.decimal_commas"), 1);
  for (const char* between : {"vertex 1.5, 2, -0.25\nvertex 10, 0, 0\nvertex 0, 1.2e+03, 0\n",
                              "vertex 1.5,2,-0.25\nvertex 10,0,0\nvertex 0,1200,0\n"}) {
    const MeshFile file = points(between);
    EXPECT_EQ(file.objects.at(0).positions, expected) << between;
    EXPECT_TRUE(file.diagnostics.empty());
  }
  expect_error(head + "vertex 1,5,2 0 0\n" + tail, "a.stl", 4, "'0' is where");
}

TEST(StlAscii, AByteOrderMarkIsNoWord) {
  const std::string bytes = "\xef\xbb\xbf" + test::stl_ascii(kTorus, "ring");
  for (const char* name : {"a.stl", "noname"}) {
    EXPECT_EQ(read_bytes(bytes, name).objects.at(0).name, "ring");
  }
  expect_error("\xef\xbb\xbfsolid a\nfacets\n", "a.stl", 2, "'facets' is no word");
}

TEST(StlAscii, ErrorsNameTheLine) {
  const std::string head = "solid a\nfacet normal 0 0 1\nouter loop\n";
  expect_error(head + "vertex 0 0 0\nvertex 1 x 0\n", "a.stl", 5, "'x' is not a coordinate");
  expect_error(head + "vertex 0 0 0\nvertex 1 0.5.5 0\n", "a.stl", 5,
               "'0.5.5' is not a coordinate");
  expect_error(head + "vertex 0 0 0\nvertex 1", "a.stl", 5, "truncated");
  expect_error(head + "vertex 0 0 0\nvortex 1 0 0\n", "a.stl", 5, "'vortex' is where 'vertex'");
  expect_error("solid a\r\nfacet\r\nouter hoop\r\n", "a.stl", 3, "'loop' should follow");
  expect_error("solid a\nendsolid a\n", "a.stl", 0, "holds no triangles");
  expect_error("solid a\nfacets\n", "a.stl", 2, "'facets' is no word of an ASCII STL");
}

TEST(StlAscii, MissingEndsolidIsTold) {
  std::string bytes = test::stl_ascii(kTorus);
  bytes.resize(bytes.find("endsolid"));
  EXPECT_EQ(test::count_of(read_bytes(bytes, "a.stl").diagnostics, "stl.no_endsolid"), 1);
}

TEST(StlAscii, NumbersOfAnyForm) {
  const MeshFile file = read_bytes(
      "solid\nfacet outer loop vertex 1e-400 -1e999 inf vertex +0 .5 5. vertex 1E+2 -0.1e1 007 "
      "endloop "
      "endfacet endsolid",
      "a.stl");
  const std::vector<Vec3>& p = file.objects.at(0).positions;
  constexpr double kInf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(p, (std::vector<Vec3>{{0, -kInf, kInf}, {0, 0.5, 5}, {100, -1, 7}}));
}

}  // namespace
}  // namespace burin
