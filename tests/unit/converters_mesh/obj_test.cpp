#include "reading.h"

namespace burin {
namespace {

using test::expect_error;
using test::read_bytes;

const std::string kCorners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

std::vector<std::uint32_t> indices(const std::string& bytes) {
  return read_bytes(bytes, "a.obj").objects.at(0).indices;
}

TEST(Obj, ReadsDoubles) {
  const TriMesh box = test::precise_box();
  const MeshFile file = read_bytes(test::obj(box), "a.obj");
  EXPECT_EQ(file.format, "OBJ");
  test::expect_mesh(file, box);
}

TEST(Obj, CornersOfAllForms) {
  using List = std::vector<std::uint32_t>;
  EXPECT_EQ(indices(kCorners + "f 1 2 3 4\n"), (List{0, 1, 2, 3}));
  EXPECT_EQ(indices(kCorners + "f 1/1 2/2 3/3\n"), (List{0, 1, 2}));
  EXPECT_EQ(indices(kCorners + "f 1//9 2//9 4//9\n"), (List{0, 1, 3}));
  EXPECT_EQ(indices(kCorners + "f 1/5/9 2/6/9 4/7/9 # end\n"), (List{0, 1, 3}));
  EXPECT_EQ(indices(kCorners + "f -4 -3/-1 -1/-2/-3\n"), (List{0, 1, 3}));
  EXPECT_EQ(indices("v 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\nv 0 1 0\nf -4 -2 -1\n"),
            (List{0, 1, 2, 0, 2, 3}));
  EXPECT_EQ(indices("f 1 2 3\n" + kCorners), (List{0, 1, 2}));  // vertices may follow
}

TEST(Obj, AnyLineEndsAndContinuedLines) {
  using List = std::vector<std::uint32_t>;
  std::string mac = kCorners + "f 1 2 3\nf 1 3 4";
  std::replace(mac.begin(), mac.end(), '\n', '\r');
  EXPECT_EQ(indices(mac), (List{0, 1, 2, 0, 2, 3}));
  EXPECT_EQ(indices(kCorners + "f 1 2 \\\n 3 \\\r\n4\n"), (List{0, 1, 2, 3}));
  EXPECT_EQ(indices(kCorners + "f 1 2\\\n 3\n"), (List{0, 1, 2}));
  EXPECT_EQ(indices("v 0 \\\n 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n# c:\\\nf 1 3 2\n"),
            (List{0, 1, 2, 0, 2, 1}));
  EXPECT_EQ(indices("\xef\xbb\xbf# mark\n" + kCorners + "f 1 2 3"), (List{0, 1, 2}));
}

// The last letter of a Japanese name may end in the byte of a backslash, a folder's name does.
TEST(Obj, NamesTakeTheirLineWhole) {
  for (const char* statement : {"o \x95\x5c\x8e\xa6\x94\xc2\x83\x5c", "g \x83\x5c",
                                "usemtl \x83\x5c", "mtllib C:\\parts\\"}) {
    EXPECT_EQ(indices(std::string(statement) + "\n" + kCorners + "f 1 2 3\n"),
              (std::vector<std::uint32_t>{0, 1, 2}))
        << statement;
  }
}

TEST(Obj, ObjectsAreParts) {
  const std::string bytes = "o left\n" + kCorners +
                            "f 1 2 3\no right side\ng ignored\nv 5 0 0\nv 6 0 0\nv 6 1 0\n" +
                            "f 5 6 7\no left\nf 1 3 4\n";
  const MeshFile file = read_bytes(bytes, "a.obj");
  ASSERT_EQ(file.objects.size(), 2u);
  EXPECT_EQ(file.objects[0].name, "left");
  EXPECT_EQ(file.objects[0].polygon_count(), 2u);
  EXPECT_EQ(file.objects[1].name, "right side");
  EXPECT_EQ(file.objects[1].positions, (std::vector<Vec3>{{5, 0, 0}, {6, 0, 0}, {6, 1, 0}}));
}

TEST(Obj, ClosedObjectsOfOneNameAreCopies) {
  const auto box = [](double x, int first, const std::string& statement) {
    const TriMesh m = test::box({x, 0, 0}, {x + 1, 1, 1});
    std::string points, faces;
    for (const Vec3& p : m.positions) points += fmt::format("v {} {} {}\n", p.x, p.y, p.z);
    for (const Triangle& t : m.triangles) {
      faces += fmt::format("f {} {} {}\n", t[0] + first, t[1] + first, t[2] + first);
    }
    return std::pair(points, statement + faces);
  };
  for (const std::string& word : {std::string("o a\n"), std::string("g a\n")}) {
    const auto [one, ones] = box(0, 1, word);
    const auto [other, others] = box(5, 9, word);
    const MeshFile two = read_bytes(one + ones + other + others, "a.obj");
    ASSERT_EQ(two.objects.size(), 2u) << word;
    EXPECT_EQ(two.objects[0].name, "a");
    EXPECT_EQ(two.objects[1].name, "a");
    EXPECT_EQ(two.objects[1].positions.at(0).x, 5);
    // In pieces, with another one between them.
    const std::size_t half = ones.find('\n', ones.size() / 2) + 1;
    const MeshFile pieces = read_bytes(one + other + ones.substr(0, half) + "o b\n" +
                                           others.substr(word.size()) + "o a\n" + ones.substr(half),
                                       "a.obj");
    if (word[0] == 'o') {
      ASSERT_EQ(pieces.objects.size(), 2u);
      EXPECT_EQ(pieces.objects[0].polygon_count(), 12u);
    }
  }
  // Groups divide an object, and make none of it.
  const auto [points, faces] = box(0, 1, "g left\n");
  const std::size_t half = faces.find('\n', faces.size() / 2) + 1;
  EXPECT_EQ(read_bytes(points + "o a\n" + faces.substr(0, half) + "g right\n" + faces.substr(half),
                       "a.obj")
                .objects.size(),
            1u);
}

TEST(Obj, GroupsArePartsUnlessTheyAreOneSurface) {
  const std::string apart = kCorners + "v 5 0 0\nv 6 0 0\nv 6 1 0\ng a\nf 1 2 3\ng b\nf 5 6 7\n";
  const MeshFile two = read_bytes(apart, "a.obj");
  ASSERT_EQ(two.objects.size(), 2u);
  EXPECT_EQ(two.objects[0].name, "a");
  EXPECT_EQ(two.objects[1].name, "b");
  const MeshFile one = read_bytes(kCorners + "g a\nf 1 2 3\ng b\nf 1 3 4\n", "a.obj");
  ASSERT_EQ(one.objects.size(), 1u);
  EXPECT_EQ(one.objects[0].polygon_count(), 2u);
  EXPECT_EQ(test::count_of(one.diagnostics, "mesh.joined_groups"), 1);
}

TEST(Obj, PartsWithoutNameHaveTheFiles) {
  const Scene scene = test::read_scene(kCorners + "f 1 2 3\n", "bracket.obj");
  ASSERT_EQ(scene.parts.size(), 1u);
  EXPECT_TRUE(scene.parts[0].name.ends_with("bracket")) << scene.parts[0].name;
}

TEST(Obj, NamesBecomeText) {
  const auto name = [](const std::string& bytes) {
    return read_bytes("o " + bytes + "\n" + kCorners + "f 1 2 3\n", "a.obj").objects.at(0).name;
  };
  EXPECT_EQ(name("K\xc3\xb6rper"), "K\xc3\xb6rper");
  EXPECT_EQ(name("K\xf6rper"), "K\xc3\xb6rper");  // Windows-1252
  EXPECT_EQ(name("a\x01"
                 "b\x7f"),
            "a b");
  EXPECT_EQ(name("\xed\xa0\x80"), "\xc3\xad\xc2\xa0\xe2\x82\xac");  // a surrogate is no UTF-8
  EXPECT_EQ(name("\x02"), "");
  EXPECT_EQ(name(std::string(5000, 'x')).size(), 200u);
  EXPECT_EQ(name("\xf0\x9f\x94\xa9"), "\xf0\x9f\x94\xa9");
}

TEST(Obj, WhatIsNotDrawnIsSkipped) {
  const MeshFile file = read_bytes("mtllib a.mtl\n" + kCorners +
                                       "vt 0 0\nvn 0 0 1\nusemtl x\ns off\nl 1 2\np 1\nf 1 2\n"
                                       "f 1 2 3\nfoo bar\ncstype bspline\nsurf 0 1 0 1 1 2\nend\n",
                                   "a.obj");
  EXPECT_EQ(file.objects.at(0).polygon_count(), 1u);
  EXPECT_EQ(test::count_of(file.diagnostics, "obj.short_faces"), 1);
  EXPECT_EQ(test::count_of(file.diagnostics, "obj.unknown_statements"), 1);
  EXPECT_EQ(test::count_of(file.diagnostics, "obj.free_form"), 1);
  EXPECT_EQ(test::count_of(file.diagnostics, "obj.no_faces"), 2);
}

TEST(Obj, ColoursAndWeightsAfterCoordinates) {
  const MeshFile file =
      read_bytes("v 0 0 0 1 0 0\nv 1 0 0 nan nan nan\nv 1 1 0 1.0\nf 1 2 3\n", "a.obj");
  EXPECT_EQ(file.objects.at(0).positions[2], Vec3(1, 1, 0));
}

TEST(Obj, ErrorsNameTheLine) {
  expect_error(kCorners + "f 1 2 9\n", "a.obj", 5, "vertex 9, the file holds 4");
  expect_error(kCorners + "\nf 0 1 2\n", "a.obj", 6, "vertex 0");
  expect_error(kCorners + "f -5 1 2\n", "a.obj", 5, "vertex -5");
  expect_error(kCorners + "f 1 2 x\n", "a.obj", 5, "'x' is not a corner");
  expect_error(kCorners + "f 1 2 99999999999999999999\n", "a.obj", 5, "");
  expect_error("v 0 0\n", "a.obj", 1, "the line ends where a coordinate should be");
  expect_error("v 0 0 0\r\nv 1 o 0\r\n", "a.obj", 2, "'o' is not a coordinate");
  expect_error("v 0 0 0\rv 1 o 0\r", "a.obj", 2, "'o' is not a coordinate");
  expect_error(kCorners, "a.obj", 0, "holds 4 vertices but no face");
  expect_error("hello\nworld\n", "a.obj", 1, "no OBJ statement");
}

}  // namespace
}  // namespace burin
