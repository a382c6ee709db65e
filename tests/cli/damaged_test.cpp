// Good files with a few bytes changed: each is drawn, or refused in one line, within bounded work.
#include "models.h"

#include <algorithm>

namespace burin::test {
namespace {

class DamagedFiles : public CliTest {
 protected:
  void draw(const std::string& path) {
    Command command(folder_, {"draw", path, "-o", folder_ / "o.svg", "--quiet", "--threads", "1"});
    const int status = command.wait();
    err_ = command.std_err;
    EXPECT_TRUE(status == 0 || status == 3) << path << ": status " << status << " " << err_;
    if (status != 0) expect_error("");
    EXPECT_EQ(std::filesystem::exists(folder_ / "o.svg"), status == 0) << path;
    EXPECT_LT(command.peak_megabytes, 1000) << path;
    std::filesystem::remove(folder_ / "o.svg");
  }
};

TEST_F(DamagedFiles, AreDrawnOrRefusedInBoundedMemory) {
  const std::string folder = std::string(BURIN_TEST_DATA) + "/broken/mutated";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no folder " << folder;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    // Binary STL files that lost their place are drawn, but still take half a minute.
    if (entry.path().extension() != ".stl") draw(entry.path().string());
  }
}

TEST_F(DamagedFiles, AHugeWeightIsRefused) {
  EXPECT_EQ(run("draw " +
                folder_.write("w.bez", "BEZ114\n0 0 1 4294967295  1 0 1 1  0 1 1 1  1 1 1 1\n") +
                " -o @/o.svg"),
            3);
  expect_error("weights of control points");
}

/// One facet, and no line that ends the solid.
std::string stl_without_end() {
  return "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
         "endloop\nendfacet\n";
}

TEST_F(DamagedFiles, WarningsNameTheirFile) {
  folder_.write("cut.stl", stl_without_end());
  ASSERT_EQ(run("draw @/cut.stl @/box.off -o @/o.json"), 0) << err_;
  EXPECT_NE(err_.find("burin: warning: cut.stl: "), std::string::npos) << err_;
  EXPECT_EQ(err_.find("box.off"), std::string::npos) << err_;
  // A drawing file does not depend on the folder of its model.
  EXPECT_NE(test::slurp(folder_ / "o.json").find("\"cut.stl: "), std::string::npos);
}

TEST_F(DamagedFiles, WarningsAboutFilesOfOneNameHaveTheFolder) {
  std::filesystem::create_directory(folder_ / "old");
  folder_.write("cut.stl", stl_without_end());
  folder_.write("old/cut.stl", stl_without_end());
  ASSERT_EQ(run("draw @/cut.stl @/old/cut.stl -o @/o.svg"), 0) << err_;
  for (const std::string name : {"/cut.stl: ", "/old/cut.stl: "}) {
    EXPECT_NE(err_.find("burin: warning: " + std::string(folder_.path()) + name), std::string::npos)
        << err_;
  }
  ASSERT_EQ(run("draw - -o @/o.svg", "cut.stl"), 0) << err_;
  EXPECT_NE(err_.find("burin: warning: standard input: "), std::string::npos) << err_;
}

}  // namespace
}  // namespace burin::test
