#include "reading.h"

namespace burin {
namespace {

using test::expect_error;
using test::raw;
using test::read_bytes;

const std::string kBody = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n3 0 1 2\n";

void expect_body(const std::string& bytes) {
  const MeshFile file = read_bytes(bytes, "a.off");
  ASSERT_EQ(file.objects.size(), 1u);
  EXPECT_EQ(file.objects[0].positions,
            (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}))
      << bytes;
  EXPECT_EQ(file.objects[0].indices, (std::vector<std::uint32_t>{0, 1, 2, 3, 0, 1, 2})) << bytes;
}

TEST(Off, ReadsDoubles) {
  const TriMesh box = test::precise_box();
  const MeshFile file = read_bytes(test::off(box), "a.off");
  EXPECT_EQ(file.format, "OFF");
  test::expect_mesh(file, box);
}

TEST(Off, HeadersOfAllForms) {
  expect_body("OFF\n4 2 0\n" + kBody);
  expect_body("OFF 4 2 5\n" + kBody);
  expect_body("OFF4 2 0\n" + kBody);
  expect_body("# first\n\nOFF # second\n# third\n4 2 0 # fourth\n#\n\n" + kBody);
  expect_body("4 2 0\n" + kBody);
  expect_body("OFF\n4 2\n" + kBody);
  expect_body("OFF\n4\n2\n0\n" + kBody);
  expect_body("OFF\r\n4 2 0\r\n" + kBody);
  expect_body("nOFF 3\n4 2 0\n" + kBody);
}

TEST(Off, ColoursNormalsAndTextureCoordinates) {
  const std::string faces = "4 0 1 2 3 255 0 0\n3 0 1 2 0.5 0.5 0.5 1 # red\n";
  expect_body("COFF\n4 2 0\n0 0 0 255 0 0 255\n1 0 0 1 1 1 1\n1 1 0 0 0 0 0\n0 1 0 1 1 1 1\n" +
              faces);
  expect_body("NOFF\n4 2 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n1 1 0 0 0 1\n0 1 0 0 0 1\n" + faces);
  expect_body("STCNOFF\n4 2 0\n0 0 0 1 2 3 4 5 6\n1 0 0 1\n1 1 0 1\n0 1 0 1\n" + faces);
  expect_body("OFF\n4 2 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n1 1 0 0 0 1\n0 1 0 0 0 1\n" + faces);
  expect_body("4OFF\n4 2 0\n0 0 0 1\n2 0 0 2\n1 1 0 1\n0 3 0 3\n" + faces);
}

TEST(Off, SeveralVerticesOnALine) {
  expect_body("OFF 4 2 0\n0 0 0 1 0 0 1 1 0\n0 1 0\n4 0 1 2 3\n3 0 1 2\n");
}

TEST(Off, ShortFacesAreLeftOutAndTold) {
  const MeshFile file =
      read_bytes("OFF\n3 3 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n3 0 1 2\n1 0\n", "a.off");
  EXPECT_EQ(file.objects.at(0).polygon_count(), 1u);
  EXPECT_EQ(test::count_of(file.diagnostics, "off.short_faces"), 2);
}

TEST(Off, BinaryOfBothByteOrders) {
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    for (const bool colours : {false, true}) {
      std::string bytes = "OFF BINARY\n";
      for (const std::uint32_t n : {3u, 1u, 0u}) bytes += raw(n, order);
      for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.5f}) bytes += raw(x, order);
      for (const std::uint32_t n : {3u, 0u, 1u, 2u}) bytes += raw(n, order);
      if (colours) bytes += raw(0u, order);
      const MeshFile file = read_bytes(bytes, "a.off");
      EXPECT_EQ(file.format, "OFF (binary)");
      EXPECT_EQ(file.objects.at(0).positions,
                (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5}}));
      EXPECT_EQ(file.objects.at(0).indices, (std::vector<std::uint32_t>{0, 1, 2}));
      if (!colours) expect_error(bytes.substr(0, bytes.size() - 3), "a.off", 0, "at byte 11");
    }
  }
}

TEST(Off, ErrorsNameTheLine) {
  expect_error("OFF\n353535235358 6 0\n0 0 0\n", "a.off", 2, "353535235358, cannot fit");
  expect_error("OFF\n3 99999999 0\n0 0 0\n", "a.off", 2, "99999999, cannot fit");
  expect_error("OFF\n-3 1 0\n0 0 0\n", "a.off", 2, "-3, cannot fit");
  expect_error("OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 4\n3 0 1 2\n", "a.off", 7,
               "vertex 4, the file holds 0 to 3");
  expect_error("OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n-4 0 1 2 3\n3 0 1 2\n", "a.off", 7,
               "-4, cannot fit");
  expect_error("OFF\n4 2 0\n0 0 0\n1 0 zero\n1 1 0\n0 1 0\n4 0 1 2 3\n3 0 1 2\n", "a.off", 4,
               "'zero' is not a coordinate");
  expect_error("OFF\n4 3 0\n" + kBody, "a.off", 9, "the file ends where");
  expect_error("OFF\n3 0 0\n0 0 0\n1 0 0\n1 1 0\n", "a.off", 0, "no face of three corners");
  expect_error("FOO\n1 2 3\n", "a.off", 1, "begins with OFF, this one with 'FOO'");
  expect_error("nOFF 4\n1 1 0\n", "a.off", 1, "three-dimensional");
}

}  // namespace
}  // namespace burin
