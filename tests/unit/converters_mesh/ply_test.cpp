#include "reading.h"

namespace burin {
namespace {

using test::expect_error;
using test::raw;
using test::read_bytes;

std::string header(const std::string& format, const std::string& body) {
  return "ply\nformat " + format + " 1.0\ncomment made by a test\n" + body + "end_header\n";
}

const std::string kPlain =
    "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_index\n";

TEST(Ply, ReadsDoublesInEachFormat) {
  const TriMesh box = test::precise_box();
  const MeshFile ascii = read_bytes(test::ply_ascii(box), "a.ply");
  EXPECT_EQ(ascii.format, "PLY (ASCII)");
  test::expect_mesh(ascii, box);
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    const MeshFile binary = read_bytes(test::ply_binary(box, order), "a.ply");
    EXPECT_EQ(binary.format, "PLY (binary)");
    test::expect_mesh(binary, box);
  }
}

/// All scalar types as coordinates and indices, in an odd order, among elements and properties of
/// no use.
std::string odd_binary(std::endian order) {
  std::string b =
      header(order == std::endian::little ? "binary_little_endian" : "binary_big_endian",
             "obj_info nothing\nelement camera 1\nproperty list ushort double view\n"
             "element vertex 4\nproperty uchar red\nproperty int16 z\nproperty list char float w\n"
             "property double x\nproperty uint8 Y\n"
             "element face 2\nproperty float area\nproperty list uint32 ushort vertex_indices\n"
             "property char flag\nelement edge 1\nproperty int a\n");
  b += raw(std::uint16_t{2}, order) + raw(1.0, order) + raw(2.0, order);
  for (int i = 0; i < 4; ++i) {
    b += raw(std::uint8_t{7}, order) + raw(static_cast<std::int16_t>(-i), order);
    b += raw(std::int8_t{1}, order) + raw(0.5f, order);
    b += raw(0.1 * i, order) + raw(static_cast<std::uint8_t>(i * i), order);
  }
  b += raw(1.0f, order) + raw(std::uint32_t{4}, order);
  for (const std::uint16_t v : {0, 1, 2, 3}) b += raw(v, order);
  b += raw(std::int8_t{0}, order) + raw(1.0f, order) + raw(std::uint32_t{3}, order);
  for (const std::uint16_t v : {3, 1, 0}) b += raw(v, order);
  return b + raw(std::int8_t{0}, order) + raw(std::int32_t{9}, order);
}

TEST(Ply, AnyTypesAndStrangersAreRead) {
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    const MeshFile file = read_bytes(odd_binary(order), "a.ply");
    ASSERT_EQ(file.objects.size(), 1u);
    EXPECT_EQ(file.objects[0].positions[3], Vec3(0.1 * 3, 9, -3));
    EXPECT_EQ(file.objects[0].offsets, (std::vector<std::size_t>{0, 4, 7}));
    EXPECT_EQ(test::count_of(file.diagnostics, "ply.no_faces"), 1);
    EXPECT_EQ(file.objects[0].indices, (std::vector<std::uint32_t>{0, 1, 2, 3, 3, 1, 0}));
  }
}

TEST(Ply, EveryTruncationIsRefused) {
  const std::string bytes = odd_binary(std::endian::little);
  for (std::size_t n = 3; n < bytes.size(); ++n) {
    const test::TempFile file("a.ply", bytes.substr(0, n));
    const RunContext context;
    EXPECT_THROW(read_mesh_file(file.path(), context), InputError) << n;
  }
}

TEST(Ply, TriangleStrips) {
  const MeshFile file =
      read_bytes(header("ascii",
                        "element vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
                        "element tristrips 1\nproperty list int int vertex_indices\n") +
                     "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n8 0 1 2 3 -1 2 3 4\n",
                 "a.ply");
  EXPECT_EQ(file.objects.at(0).indices, (std::vector<std::uint32_t>{0, 1, 2, 2, 1, 3, 2, 3, 4}));
}

TEST(Ply, HeadersWithOtherLineEnds) {
  const TriMesh box = test::box({0, 0, 0}, {10, 10, 10});  // 10.0 begins with the byte \n nowhere
  for (const std::string ends : {"\r\n", "\r"}) {
    const std::string plain = test::ply_binary(box);
    const std::size_t data = plain.find("end_header\n") + 11;
    std::string changed;
    for (const char c : plain.substr(0, data)) c == '\n' ? changed += ends : changed += c;
    test::expect_mesh(read_bytes(changed + plain.substr(data), "a.ply"), box);
  }
}

// Blender 2.4 wrote "Created by" without "comment" before it.
TEST(Ply, RemarksInHeadersAreNoErrorsAndSlipsAre) {
  const std::string data = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n";
  const MeshFile file = read_bytes(
      "ply\nformat ascii 1.0\nCreated by Blender3D\n" + kPlain + "end_header\n" + data, "a.ply");
  EXPECT_EQ(file.objects.at(0).polygon_count(), 1u);
  expect_error("ply\nformat ascii 1.0\n" + kPlain + "elemnt edge 0\nend_header\n" + data, "a.ply",
               9, "'elemnt' is no word of a PLY header");
}

TEST(Ply, FalseCountsAreRefused) {
  std::string many = kPlain;
  many.replace(many.find("vertex 4"), 8, "vertex 4000000000");
  const std::string data = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";
  expect_error(header("ascii", many) + data, "a.ply", 11, "claims 4000000000 elements 'vertex'");
  expect_error(header("binary_little_endian", many) + std::string(100, '\0'), "a.ply", 0,
               "claims 4000000000");
  std::string faces = kPlain;
  faces.replace(faces.find("face 1"), 6, "face 9223372036854775807");
  expect_error(header("binary_big_endian", faces) + std::string(100, '\0'), "a.ply", 0,
               "elements 'face'");
  expect_error(header("ascii", kPlain) + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n400000000 0 1 2 3\n", "a.ply",
               15, "cannot fit");
}

TEST(Ply, ErrorsSayWhere) {
  const std::string data = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  expect_error(header("ascii", kPlain) + data + "4 0 1 2 4\n", "a.ply", 15,
               "vertex 4, the file holds 0 to 3");
  expect_error(header("ascii", kPlain) + data + "4 0 1 2 -1\n", "a.ply", 15, "vertex -1");
  expect_error(header("ascii", kPlain) + "0 0 0\n1 0 q\n1 1 0\n0 1 0\n4 0 1 2 3\n", "a.ply", 12,
               "'q' is not a number");
  expect_error(header("ascii", kPlain) + data, "a.ply", 15,
               "the file ends where the length of a list should be");
  expect_error("ply\nformat ascii 1.0\nelement vertex 3\n", "a.ply", 4, "without 'end_header'");
  expect_error("ply\nformat asci 1.0\nend_header\n", "a.ply", 2, "'asci' is no PLY format");
  expect_error("ply\nelement vertex 3\nproperty real x\nend_header\n", "a.ply", 3,
               "'real' is no type");
  expect_error("ply\nfromat ascii 1.0\nend_header\n", "a.ply", 2, "'fromat' is no word");
  expect_error("ply\nelement vertex 0\nend_header\n", "a.ply", 3, "states no format");
  expect_error(header("ascii", "element vertex 1\nproperty float x\n") + "0\n", "a.ply", 7,
               "no coordinates x, y and z");
  expect_error(
      header("ascii", "element vertex 1\nproperty float x\nproperty float y\nproperty float z\n") +
          "0 0 0\n",
      "a.ply", 0, "a point cloud");
  expect_error("PLY\n", "a.ply", 0, "begins with the line 'ply'");
}

}  // namespace
}  // namespace burin
