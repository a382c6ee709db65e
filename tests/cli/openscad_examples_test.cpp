#include "models.h"

#include <cstdlib>

namespace burin::test {
namespace {

/// Every example of the Debian package that OpenSCAD makes a solid of within some 10 s. The others
/// take up to 75 s: tests/bench/openscad_examples.sh draws all.
constexpr const char* kExamples[] = {"Advanced/GEB",
                                     "Advanced/animation",
                                     "Advanced/assert",
                                     "Advanced/offset",
                                     "Advanced/children_indexed",
                                     "Basics/CSG",
                                     "Basics/LetterBlock",
                                     "Basics/linear_extrude",
                                     "Basics/projection",
                                     "Basics/text_on_cube",
                                     "Functions/functions",
                                     "Old/example001",
                                     "Old/example002",
                                     "Old/example003",
                                     "Old/example004",
                                     "Old/example005",
                                     "Old/example007",
                                     "Old/example008",
                                     "Old/example009",
                                     "Old/example010",
                                     "Old/example011",
                                     "Old/example012",
                                     "Old/example013",
                                     "Old/example014",
                                     "Old/example016",
                                     "Old/example017",
                                     "Old/example018",
                                     "Old/example020",
                                     "Old/example021",
                                     "Old/example022",
                                     "Old/example023",
                                     "Parametric/sign"};

class OpenscadExamples : public CliTest, public ::testing::WithParamInterface<const char*> {};

TEST_P(OpenscadExamples, Draws) {
  const std::string path = std::string("/usr/share/openscad/examples/") + GetParam() + ".scad";
  if (std::system("command -v openscad >/dev/null") != 0 || !std::filesystem::exists(path)) {
    GTEST_SKIP() << "openscad with its examples is not installed";
  }
  ASSERT_EQ(run("draw " + path + " -o @/e.svg"), 0) << err_;
  const std::string svg = slurp(folder_ / "e.svg");
  std::size_t paths = 0;
  for (std::size_t at = svg.find("<path"); at != std::string::npos;
       at = svg.find("<path", at + 1)) {
    ++paths;
  }
  EXPECT_GE(paths, 5U);
}

INSTANTIATE_TEST_SUITE_P(Debian, OpenscadExamples, ::testing::ValuesIn(kExamples),
                         [](const auto& row) {
                           std::string name = row.param;
                           for (char& c : name) {
                             if (c == '/') c = '_';
                           }
                           return name;
                         });

class OpenscadSamples : public CliTest, public ::testing::WithParamInterface<const char*> {};

TEST_P(OpenscadSamples, AreHealed) {
  if (std::system("command -v openscad >/dev/null") != 0) GTEST_SKIP() << "openscad is missing";
  const std::string file = std::string(BURIN_SOURCE_DIR) + "/samples/" + GetParam() + ".scad";
  ASSERT_EQ(run("draw " + file + " -o @/e.svg -v"), 0) << err_;
  EXPECT_NE(err_.find("approximate: "), std::string::npos) << err_;
  ASSERT_EQ(run("draw " + file + " -o @/f.svg -v --no-heal"), 0) << err_;
  EXPECT_EQ(err_.find("approximate: "), std::string::npos) << err_;
  EXPECT_NE(slurp(folder_ / "e.svg"), slurp(folder_ / "f.svg"));
}

INSTANTIATE_TEST_SUITE_P(Scad, OpenscadSamples, ::testing::Values("flange", "knob", "carafe"));

TEST(OpenscadExample, FlatOnesSayWhatTheyAre) {
  const std::string folder = "/usr/share/openscad/examples/Advanced/";
  if (!std::filesystem::exists(folder + "module_recursion.scad")) {
    GTEST_SKIP() << "openscad with its examples is not installed";
  }
  const Folder out;
  Command command(out, {"draw", folder + "module_recursion.scad", "-o", out / "e.svg"});
  EXPECT_EQ(command.wait(), 3);
  EXPECT_NE(command.std_err.find("2-D object"), std::string::npos) << command.std_err;
}

}  // namespace
}  // namespace burin::test
