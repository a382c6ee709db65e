#include "reading.h"

namespace burin {
namespace {

using test::expect_error;

void expect_missing(const std::filesystem::path& path, const std::string& part) {
  const RunContext context;
  try {
    read_mesh_file(path, context);
    ADD_FAILURE() << path;
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find(part), std::string::npos) << e.what();
    EXPECT_EQ(e.file(), path.string());
  }
}

TEST(Detect, WhatIsNoFileIsNamed) {
  expect_missing("/no/such/file.stl", "no such file");
  expect_missing(std::filesystem::temp_directory_path(), "is a folder");
  expect_missing("/dev/null", "not a regular file");
}

TEST(Detect, EmptyFiles) {
  for (const char* name : {"a.stl", "a.obj", "a.off", "a.ply", "a.3mf", "a"}) {
    expect_error("", name, 0, "is empty");
  }
}

TEST(Detect, OtherFilesUnderAMeshName) {
  expect_error("version https://git-lfs.github.com/spec/v1\noid sha256:0\n", "a.stl", 0,
               "Git LFS pointer");
  // The bytes of "v 1" in both orders, behind their marks.
  const std::string zero(1, '\0');
  expect_error("\xfe\xff" + zero + "v" + zero + " " + zero + "1", "a.obj", 0, "UTF-16");
  expect_error("\xff\xfev" + zero + " " + zero + "1" + zero, "a.obj", 0, "UTF-16");
  expect_error("{\"burin\": \"illustration\"}", "a.burin.json", 0, "burin draw draws it");
  std::string unmarked;
  for (const char c : std::string("v 0 0 0\nv 1 0 0\n")) unmarked += zero + c;
  expect_error(unmarked, "a.obj", 0, "UTF-16");
  expect_error(unmarked.substr(1) + zero, "a.obj", 0, "UTF-16");
  expect_error("ISO-10303-21;\nHEADER;\n", "a.stl", 0, "is a STEP file");
  expect_error("DBRep_DrawableShape\n", "a.stl", 0, "BREP");
  expect_error("\x1f\x8b\x08", "a.stl", 0, "compressed data: it ends too early");
  expect_error("<!DOCTYPE html><html>", "a.stl", 0, "web page");
  expect_error("\x89PNG\r\n", "a.ply", 0, "PNG");
  expect_error(std::string("abc\0def", 7) + std::string(100, '\1'), "a.obj", 0, "is binary data");
  expect_error("what is this\n", "a.xyz", 0, "suffix '.xyz'");
  expect_error("what is this\n", "a.stl", 1, "no ASCII STL");
}

TEST(Detect, ContentGoesBeforeTheSuffix) {
  const TriMesh box = test::precise_box();
  EXPECT_EQ(test::read_bytes(test::stl_ascii(box), "a.obj").format, "STL (ASCII)");
  EXPECT_EQ(test::read_bytes(test::off(box), "a.stl").format, "OFF");
  EXPECT_EQ(test::read_bytes(test::ply_ascii(box), "a.off").format, "PLY (ASCII)");
  EXPECT_EQ(test::read_bytes("# by hand\n" + test::obj(box), "a.stl").format, "OBJ");
  EXPECT_EQ(test::read_bytes(test::obj(box), "noname").format, "OBJ");
}

TEST(Detect, SuffixesInAnyCase) {
  for (const char* name : {"a.STL", "b/c.Obj", "a.off", "x.y.ply", "a.3MF"})
    EXPECT_TRUE(is_mesh_suffix(name)) << name;
  for (const char* name : {"a.step", "stl", "a", ".stl.txt"})
    EXPECT_FALSE(is_mesh_suffix(name)) << name;
}

TEST(Detect, CancelledReadingStops) {
  const test::TempFile file("a.obj", test::obj(test::torus(5, 2, 60, 40)));
  RunContext context;
  context.cancel();
  EXPECT_THROW(read_mesh_file(file.path(), context), Cancelled);
}

}  // namespace
}  // namespace burin
