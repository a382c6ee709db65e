#pragma once
/// Reading bytes as a file, and the errors that come of it.

#include <burin/base/error.h>
#include <burin/converters/mesh_reader.h>

#include <burin_test/folder.h>
#include <burin_test/mesh_checks.h>
#include <burin_test/mesh_files.h>
#include <burin_test/shapes.h>
#include <gtest/gtest.h>
#include <zip.h>

#include <map>
#include <string>

namespace burin::test {

inline MeshFile read_bytes(const std::string& bytes, const std::string& name) {
  const TempFile file(name, bytes);
  const RunContext context;
  return read_mesh_file(file.path(), context);
}

inline Scene read_scene(const std::string& bytes, const std::string& name) {
  const TempFile file(name, bytes);
  const RunContext context;
  return read_mesh(file.path(), context);
}

/// The bytes are refused, at this line (0: none), with a message of one line that holds `part`.
inline void expect_error(const std::string& bytes, const std::string& name, std::int64_t line,
                         const std::string& part) {
  const TempFile file(name, bytes);
  const RunContext context;
  try {
    read_mesh(file.path(), context);
    ADD_FAILURE() << name << " was read; expected: " << part;
  } catch (const InputError& e) {
    const std::string what = e.what();
    EXPECT_EQ(e.file(), file.path().string());
    EXPECT_EQ(e.line(), line) << what;
    EXPECT_NE(what.find(part), std::string::npos) << what;
    EXPECT_EQ(what.find('\n'), std::string::npos) << what;
  }
}

/// The one object of the file holds these positions and triangles, exactly.
inline void expect_mesh(const MeshFile& file, const TriMesh& mesh) {
  ASSERT_EQ(file.objects.size(), 1u);
  const PolygonSoup& soup = file.objects[0];
  const PolygonSoup expected = soup_of(mesh);
  EXPECT_EQ(soup.positions, expected.positions);
  EXPECT_EQ(soup.indices, expected.indices);
  EXPECT_EQ(soup.offsets, expected.offsets);
}

/// A box whose coordinates no float holds.
inline TriMesh precise_box() {
  return box({0.1, 1.0 / 3, -1e-7}, {1.1, 2.0 / 3, 123456.789012345});
}

/// The bytes of a zip archive with these members.
inline std::string zipped(const std::map<std::string, std::string>& members) {
  const TempFile file("archive.zip", "");
  int error = 0;
  zip_t* archive = zip_open(file.path().c_str(), ZIP_CREATE | ZIP_TRUNCATE, &error);
  for (const auto& [name, bytes] : members) {
    zip_file_add(archive, name.c_str(), zip_source_buffer(archive, bytes.data(), bytes.size(), 0),
                 0);
  }
  zip_close(archive);
  std::ifstream in(file.path(), std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace burin::test
