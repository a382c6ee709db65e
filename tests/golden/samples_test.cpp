// The samples are what samples/README.md says: clean meshes, closed where they are solids, with
// their parts.
#include <burin/converters/mesh_reader.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <set>

namespace burin {
namespace {

Scene sample(const char* file) {
  const RunContext context;
  return read_mesh(std::filesystem::path(BURIN_SOURCE_DIR) / "samples" / file, context);
}

std::set<std::string> part_names(const Scene& scene) {
  std::set<std::string> names;
  for (const Part& part : scene.parts) names.insert(part.name);
  return names;
}

TEST(Samples, AreReadWithoutAnyDefect) {
  for (const char* file :
       {"spindle.stl", "bracket.off", "gear.ply", "bolt.3mf", "bearing_stand.obj", "spring.stl",
        "knot.ply", "vase.ply", "blob.off", "teapot.ply", "gyroid.ply"}) {
    const Scene scene = sample(file);
    EXPECT_FALSE(scene.parts.empty()) << file;
    for (const auto& entry : scene.diagnostics.entries()) {
      ADD_FAILURE() << file << ": " << entry.code << " " << entry.message;
    }
  }
}

TEST(Samples, AssembliesKeepTheNamesOfTheirParts) {
  EXPECT_EQ(part_names(sample("bolt.3mf")), (std::set<std::string>{"bolt", "nut", "washer"}));
  const Scene stand = sample("bearing_stand.obj");
  EXPECT_EQ(stand.parts.size(), 15u);
  const auto names = part_names(stand);
  for (const char* name :
       {"base_plate", "pillow_block_front", "bearing_rear_balls", "shaft", "pulley"}) {
    EXPECT_TRUE(names.contains(name)) << name;
  }
}

TEST(Samples, PartsOfTheStandTouchExactly) {
  // The screws stand on the feet of the pillow blocks, these on the base plate.
  const Scene stand = sample("bearing_stand.obj");
  std::map<std::string, Box3> boxes;
  for (const Part& part : stand.parts) boxes[part.name] = part.form->bounds(Mat3(1));
  EXPECT_EQ(boxes.at("base_plate").max.z, 0);
  EXPECT_EQ(boxes.at("pillow_block_front").min.z, 0);
  EXPECT_EQ(boxes.at("screw_front_left").min.z, 11);
}

}  // namespace
}  // namespace burin
