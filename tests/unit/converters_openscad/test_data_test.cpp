#include "flat/origins.h"
#include "flat_trees.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

namespace burin::csg::test {
namespace {

namespace fs = std::filesystem;

/// Programs of OpenSCAD's own tests (Debian: openscad-testing-data). What is thin differs more, as
/// OpenSCAD rounds its corners to the grid.
struct Programs {
  const char* name;
  const char* folder;
  double agree;
  int fewest;
};

class OpenScadTestData : public ::testing::TestWithParam<Programs> {};

/// With absolute names of files, so that a copy of the tree elsewhere finds them.
std::string with_absolute_names(const std::string& tree, const fs::path& folder) {
  static const std::regex name("file = \"([^\"]+)\"");
  std::string out;
  auto from = tree.cbegin();
  for (std::sregex_iterator it(tree.begin(), tree.end(), name), end; it != end; ++it) {
    out.append(from, (*it)[0].first);
    out += "file = \"" + fs::weakly_canonical(folder / (*it)[1].str()).string() + "\"";
    from = (*it)[0].second;
  }
  return out.append(from, tree.cend());
}

std::vector<fs::path> programs_in(const fs::path& folder) {
  std::vector<fs::path> out;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    // Projections have solids below them, which are another's work.
    const bool flat = entry.path().filename().string().find("projection") == std::string::npos;
    if (entry.path().extension() == ".scad" && flat) out.push_back(entry.path());
  }
  std::sort(out.begin(), out.end());
  return out;
}

TEST_P(OpenScadTestData, VolumesAgree) {
  if (!has_program("openscad")) GTEST_SKIP() << "openscad is not installed";
  const std::vector<fs::path> programs =
      programs_in(fs::path("/usr/share/openscad/testdata/scad") / GetParam().folder);
  if (programs.empty()) GTEST_SKIP() << "openscad-testing-data is not installed";
  int compared = 0;
  for (const fs::path& program : programs) {
    const auto tree = tree_of(program);
    if (!tree || tree->find_first_not_of(" \t\r\n") == std::string::npos) continue;
    const Folder folder;
    const std::string whole =
        "linear_extrude(height = 1, center = false, convexity = 1, scale = [1, "
        "1], $fn = 0, $fa = 12, $fs = 2) {\n" +
        with_absolute_names(*tree, program.parent_path()) + "}\n";
    const double theirs = openscad_volume(folder.write("case.csg", whole));
    Evaluated ours(whole, folder.path());
    const Solid solid = ours.solid();
    EXPECT_EQ(flaw(solid), "") << program;
    EXPECT_NEAR(volume(solid), theirs, GetParam().agree * theirs) << program;
    ++compared;
  }
  EXPECT_GE(compared, GetParam().fewest);
}

const Programs kPrograms[] = {{"Dxf", "dxf", 1e-5, 28},
                              {"Svg", "svg/svg-spec", 2e-5, 12},
                              {"Features", "2D/features", 2e-5, 24},
                              {"Issues", "2D/issues", 3e-4, 4}};

INSTANTIATE_TEST_SUITE_P(Folders, OpenScadTestData, ::testing::ValuesIn(kPrograms),
                         [](const auto& of) { return std::string(of.param.name); });

}  // namespace
}  // namespace burin::csg::test
