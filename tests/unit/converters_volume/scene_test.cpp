// Surfaces of volumes, and what is told of them.
#include "volumes.h"

#include <burin_test/shapes.h>

#include <cmath>
#include <numbers>

namespace burin {
namespace {

using test::Folder;

constexpr int kSide = 24;
constexpr double kRadius = 8;

/// 100 at the middle, falling by 10 a sample: a ball of radius 8 at level 20.
std::string ball(const std::string& placing) {
  std::string bytes = fmt::format(
      "NRRD0004\ntype: float\ndimension: 3\nsizes: {0} {0} {0}\nendian: little\nencoding: raw\n{1}"
      "\n\n",
      kSide, placing);
  for (int k = 0; k < kSide; ++k) {
    for (int j = 0; j < kSide; ++j) {
      for (int i = 0; i < kSide; ++i) {
        const double c = (kSide - 1) / 2.0;
        const double r = std::sqrt((i - c) * (i - c) + (j - c) * (j - c) + (k - c) * (k - c));
        bytes += test::raw(static_cast<float>(100 - 10 * r));
      }
    }
  }
  return bytes;
}

FileInfo inspected(const std::string& bytes, const VolumeReadOptions& options,
                   const std::optional<Box3>& bounds = {}, const std::string& name = "ball.nrrd") {
  const Folder folder;
  RunContext context;
  return inspect_volume(folder.write(name, bytes), options, bounds, context);
}

TEST(VolumeScene, NormalsPointOutwardsInMirroredGrids) {
  VolumeReadOptions options;
  options.level = 20;
  options.interpolate = true;
  const double volume = 4 * std::numbers::pi / 3 * kRadius * kRadius * kRadius;
  for (const char* placing : {"spacings: 1 1 1", "spacings: -1 1 1", "spacings: -1 -1 -1",
                              "space: 3D-left-handed\nspace directions: (1,0,0) (0,1,0) (0,0,1)",
                              "space: RAS\nspace directions: (0.6,0.8,0) (0.8,-0.6,0) (0,0,1)"}) {
    SCOPED_TRACE(placing);
    const FileInfo info = inspected(ball(placing), options);
    ASSERT_EQ(info.parts.size(), 1u);
    EXPECT_EQ(info.parts[0].components, 1);
    EXPECT_NEAR(info.parts[0].volume / volume, 1, 0.01);
  }
}

TEST(VolumeScene, SmallerValuesInside) {
  VolumeReadOptions options;
  options.level = 20;
  options.inside_above = false;
  const double side = kSide - 1;
  const double ball_volume = 4 * std::numbers::pi / 3 * kRadius * kRadius * kRadius;
  const FileInfo info = inspected(ball("spacings: 1 1 1"), options);
  ASSERT_EQ(info.parts.size(), 1u);
  EXPECT_NEAR(info.parts[0].volume / (side * side * side - ball_volume), 1, 0.01);
}

TEST(VolumeScene, BoundsClip) {
  VolumeReadOptions options;
  options.level = 20;
  const double middle = (kSide - 1) / 2.0;
  const Box3 half{Vec3(-100), {100, 100, middle}};
  const FileInfo info = inspected(ball("spacings: 1 1 1"), options, half);
  const double volume = 2 * std::numbers::pi / 3 * kRadius * kRadius * kRadius;
  EXPECT_NEAR(info.parts.at(0).volume / volume, 1, 0.02);
  EXPECT_NEAR(info.parts.at(0).bounds.max.z, middle, 1e-9);
  EXPECT_THROW(inspected(ball("spacings: 1 1 1"), options, Box3{Vec3(500), Vec3(600)}), InputError);
}

TEST(VolumeScene, LevelsAreChecked) {
  const Folder folder;
  const std::string path = folder.write("ball.nrrd", ball("spacings: 1 1 1"));
  const auto refused = [&](std::optional<double> level, const std::string& part) {
    RunContext context;
    VolumeReadOptions options;
    options.level = level;
    try {
      read_volume_scene(path, options, {}, context);
      ADD_FAILURE() << "was read; expected: " << part;
    } catch (const InputError& e) {
      EXPECT_NE(std::string(e.what()).find(part), std::string::npos) << e.what();
      EXPECT_EQ(e.file(), path);
    }
  };
  refused({}, "give the level of the surface to draw, e.g. `iso ");
  refused(101, "the level 101 is outside the values of the data, -99.1858 to 91.3397");
  refused(-500, "is outside the values");
}

TEST(VolumeScene, ConstantDataHasNoSurface) {
  const Folder folder;
  const std::string path = folder.write("flat.raw", std::string(64, 'a'));
  RunContext context;
  VolumeReadOptions options;
  options.raw = RawLayout{{4, 4, 4}};
  options.level = 97;
  EXPECT_THROW(read_volume_scene(path, options, {}, context), InputError);
  const FileInfo info = inspect_volume(path, {.raw = options.raw}, {}, context);
  EXPECT_EQ(info.volume->min, 97);
  EXPECT_EQ(info.volume->max, 97);
}

TEST(VolumeInfoText, TellsOfTheData) {
  // Two values, 3 of 10 samples the larger.
  std::string bytes;
  for (int i = 0; i < 1000; ++i) bytes += static_cast<char>(i % 10 < 3 ? 200 : 20);
  VolumeReadOptions options;
  options.raw = RawLayout{{10, 10, 10}, SampleType::U8, false, {1, 2, 3}, 0};
  const FileInfo info = inspected(bytes, options, {}, "two.raw");
  ASSERT_TRUE(info.volume.has_value());
  const VolumeInfo& v = *info.volume;
  EXPECT_EQ(v.type, "u8");
  EXPECT_EQ(v.min, 20);
  EXPECT_EQ(v.max, 200);
  EXPECT_EQ(v.percentiles[0], 20);
  EXPECT_EQ(v.percentiles[2], 20);
  EXPECT_EQ(v.percentiles[3], 200);
  // The middle of the gap between the two values, through no sample.
  EXPECT_NEAR(v.level, 110, 1);
  EXPECT_EQ(v.level, std::floor(v.level) + 0.5);
  EXPECT_EQ(v.bounds.max, Vec3(9, 18, 27));
  EXPECT_TRUE(info.parts.empty());
  const std::string text = to_text(info);
  EXPECT_NE(text.find("10 x 10 x 10 of u8"), std::string::npos) << text;
  EXPECT_NE(text.find("20 to 200"), std::string::npos) << text;
  EXPECT_EQ(text.find("parts"), std::string::npos) << text;
}

TEST(VolumeScene, CancelledWhileReading) {
  const Folder folder;
  const std::string path = folder.write("ball.nrrd", ball("spacings: 1 1 1"));
  RunContext context;
  context.cancel();
  EXPECT_THROW(read_volume(path, {}, context), Cancelled);
}

TEST(VolumeScene, NamesAndSuffixes) {
  EXPECT_TRUE(is_volume_suffix("a.NII.gz"));
  EXPECT_TRUE(is_volume_suffix("/x/a.vti"));
  EXPECT_TRUE(is_volume_suffix("a.raw"));
  EXPECT_FALSE(is_volume_suffix("a.stl.gz"));
  EXPECT_FALSE(is_volume_suffix("a.gz"));
  EXPECT_FALSE(is_volume_suffix("nii"));
  const Folder folder;
  RunContext context;
  VolumeReadOptions options;
  options.level = 20;
  const std::string path = folder.write("my.ball.nrrd.gz", test::deflated(ball("spacings: 1 1 1")));
  EXPECT_EQ(read_volume_scene(path, options, {}, context).parts.at(0).name, "my.ball");
}

}  // namespace
}  // namespace burin
