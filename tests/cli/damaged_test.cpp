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

}  // namespace
}  // namespace burin::test
