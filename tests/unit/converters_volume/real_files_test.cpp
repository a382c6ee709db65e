// Volumes that others made.
#include "volumes.h"

#include <burin_test/shapes.h>

namespace burin {
namespace {

struct Wanted {
  const char* file;
  const char* format;
  const char* type;
  std::array<std::int64_t, 3> size;
  Vec3 spacing;
  double min, max;
};

void check(const Wanted& w) {
  SCOPED_TRACE(w.file);
  const auto path = test::data(w.file);
  if (!std::filesystem::exists(path)) GTEST_SKIP() << w.file << " is not here";
  RunContext context;
  const Volume v = read_volume(path, {}, context);
  EXPECT_EQ(v.format, w.format);
  EXPECT_EQ(v.info.type, w.type);
  EXPECT_EQ(v.info.size, w.size);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(glm::length(v.info.steps[k]), w.spacing[k], 1e-6);
  EXPECT_EQ(v.info.min, w.min);
  EXPECT_EQ(v.info.max, w.max);
  EXPECT_TRUE(v.diagnostics.empty());
  EXPECT_GT(v.info.level, v.info.min);
  EXPECT_LT(v.info.level, v.info.max);
}

TEST(RealVolumes, Brain) {
  check({"volume/volpack/brain-8bit.nrrd", "NRRD", "u8", {256, 256, 109}, {1, 1, 1.54}, 0, 255});
}
TEST(RealVolumes, Engine) {
  check({"volume/volpack/engine-8bit.nrrd", "NRRD", "u8", {256, 256, 110}, Vec3(1), 0, 255});
}
TEST(RealVolumes, Fuel) {
  check({"volume/scivis/fuel.nii.gz", "NIfTI-1", "u8", {64, 33, 32}, Vec3(1), 0, 255});
}
TEST(RealVolumes, Head) {
  check({"volume/mricron/ch2bet.nii.gz", "NIfTI-1", "u8", {181, 217, 181}, Vec3(1), 0, 133});
}
TEST(RealVolumes, Heart) {
  check({"volume/mayavi/heart.vti", "VTK image data", "f32", {32, 32, 12}, {1, 1, 4}, 0, 255});
}

TEST(RealVolumes, TruncatedGzip) {
  const auto path = test::data("broken/derived/truncated.nii.gz");
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "not here";
  RunContext context;
  EXPECT_THROW(read_volume(path, {}, context), InputError);
}

}  // namespace
}  // namespace burin
