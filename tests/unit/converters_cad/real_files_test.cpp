// The samples, and real models where the folder with them is present.
#include <burin/base/error.h>

#include "cad_files.h"

#include <burin_test/shapes.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

namespace burin {
namespace {

namespace fs = std::filesystem;

class RealCad : public test::CadTest {
 protected:
  static std::string sample(const std::string& name) {
    return (fs::path(BURIN_SOURCE_DIR) / "samples" / name).string();
  }
};

TEST_F(RealCad, SamplesAreClosedSolids) {
  for (const auto& [name, parts, faces] :
       {std::tuple("pedestal.step", 1, 126), std::tuple("propeller.step", 1, 25),
        std::tuple("coupling.step", 30, 278)}) {
    SCOPED_TRACE(name);
    const FileInfo info = inspect(sample(name));
    EXPECT_TRUE(info.diagnostics.empty());
    EXPECT_EQ(info.parts.size(), static_cast<std::size_t>(parts));
    EXPECT_EQ(info.total().faces, faces);
    EXPECT_EQ(info.total().solids, parts);
    for (const PartInfo& p : info.parts) {
      EXPECT_TRUE(p.closed()) << p.name;
      EXPECT_GT(p.volume, 0) << p.name;
      EXPECT_FALSE(p.color.empty()) << p.name;
    }
  }
}

TEST_F(RealCad, TheCouplingSharesItsBolts) {
  const FileInfo info = inspect(sample("coupling.step"));
  std::set<std::string> names;
  int own = 0;
  for (const PartInfo& p : info.parts) {
    own += p.same_shape_as < 0 ? 1 : 0;
    std::string path;
    for (const std::string& a : p.assembly) path += a + "/";
    names.insert(path + p.name);
    EXPECT_EQ(p.assembly.front(), "flange coupling");
  }
  EXPECT_EQ(own, 8);
  EXPECT_EQ(names.size(), info.parts.size());
  EXPECT_TRUE(names.contains("flange coupling/bolt set 3/lower washer"));
}

TEST_F(RealCad, EveryRealFileIsReadOrRefused) {
  std::vector<fs::path> files;
  for (const char* folder : {"step", "nurbs", "broken"}) {
    const fs::path root = fs::path(BURIN_TEST_DATA) / folder;
    if (!fs::exists(root)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
      if (entry.is_regular_file() && is_cad_suffix(entry.path())) files.push_back(entry.path());
    }
  }
  if (files.empty()) GTEST_SKIP() << "no real models";
  std::ranges::sort(files);
  for (const fs::path& file : files) {
    SCOPED_TRACE(file.filename().string());
    const Scene scene = read(file.string());
    EXPECT_FALSE(scene.parts.empty());
    for (const Part& part : scene.parts) {
      const Box3 box = part.form->bounds(Mat3(1));
      EXPECT_TRUE(std::isfinite(glm::length(box.size()))) << part.name;
      EXPECT_GT(glm::length(box.size()), 0) << part.name;
      EXPECT_FALSE(part.name.empty());
    }
  }
}

}  // namespace
}  // namespace burin
