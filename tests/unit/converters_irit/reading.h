#pragma once
/// Reading bytes as a file of patches, and the errors that come of it.

#include <burin/base/error.h>
#include <burin/converters/irit_reader.h>
#include <burin/converters/irit_tree.h>
#include <burin/forms/patches/parametric_form.h>

#include <burin_test/folder.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

namespace burin::test {

inline IritObject tree_of(const std::string& bytes) {
  const TempFile file("a.itd", bytes);
  const RunContext context;
  return read_irit_tree(file.path(), context);
}

inline Scene scene_of(const std::string& bytes, const std::string& name = "a.itd") {
  const TempFile file(name, bytes);
  const RunContext context;
  return read_irit(file.path(), context);
}

/// The patches of a part.
inline const std::vector<std::shared_ptr<const Chart>>& patches_of(const Part& part) {
  return dynamic_cast<const ParametricForm&>(*part.form).patches();
}

/// The bytes are refused, at this line (0: none), with a message of one line that holds `part`.
inline void expect_error(const std::string& bytes, std::int64_t line, const std::string& part,
                         const std::string& name = "a.itd") {
  const TempFile file(name, bytes);
  const RunContext context;
  try {
    read_irit(file.path(), context);
    ADD_FAILURE() << "was read; expected: " << part;
  } catch (const InputError& e) {
    const std::string what = e.what();
    EXPECT_EQ(e.file(), file.path().string());
    EXPECT_EQ(e.line(), line) << what;
    EXPECT_NE(what.find(part), std::string::npos) << what;
    EXPECT_EQ(what.find('\n'), std::string::npos) << what;
  }
}

inline void expect_near(Vec3 a, Vec3 b, double tolerance) {
  EXPECT_LE(glm::distance(a, b), tolerance)
      << a.x << " " << a.y << " " << a.z << " and " << b.x << " " << b.y << " " << b.z;
}

/// A bilinear patch from `p` to `p` + (1, 1, 0), turned by `turn` quarters.
inline std::string square(Vec3 p) {
  return fmt::format(
      "[SURFACE BEZIER 2 2 E3 [{0} {1} {2}] [{3} {1} {2}] [{0} {4} {2}] [{3} {4} {2}]]\n", p.x, p.y,
      p.z, p.x + 1, p.y + 1);
}

}  // namespace burin::test
