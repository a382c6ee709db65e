// Golden drawings: what the command draws of the samples must stay what it was. A wanted change is
// accepted by
//   BURIN_ACCEPT_GOLDEN=1 ./dev test -R Golden
// which rewrites tests/golden/drawings; look at the drawings before the new files are committed.
#include "compare.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace burin::golden {
namespace {

namespace fs = std::filesystem;

struct Case {
  const char* name;
  const char* input;
  const char* options;
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

// Small sheets keep the files small.
const Case kCases[] = {
    {"bracket_outline.json", "bracket.off", "--style outline --view 1,-1,0.8 --paper 100x80"},
    {"bracket_hidden.json", "bracket.off",
     "--style outline --hidden dashed --view 1,-1,0.8 --paper 60x50"},
    {"spindle_outline.json", "spindle.stl", "--style outline --view 1,-1.6,0.9 --paper 100x70"},
    {"stand_outline.svg", "bearing_stand.obj", "--style outline --view 1,-1.2,0.8 --paper 80x80"},
    {"knot_outline.json", "knot.ply",
     "--style outline --view 0.4,-0.5,1 --paper 80x80 --perspective 25"},
    {"pedestal_hidden.json", "pedestal.step",
     "--style outline --hidden dashed --view 1,-1.2,0.8 --paper 90x70"},
    {"coupling_outline.json", "coupling.step", "--style outline --view 1,-1.2,0.8 --paper 70x60"},
    {"lantern_outline.json", "lantern.glb", "--style outline --view 1,-1.6,0.7 --paper 60x80"},
    {"horn_engraving.json", "horn.itd", "--style engraving --view 1,-1.2,0.7 --paper 50x45"},
    {"blob_engraving.json", "blob.off", "--style engraving --view 1,-1.2,0.8 --paper 50x50"},
    {"knot_haloed.json", "knot.ply", "--style haloed --view 0.4,-0.5,1 --paper 60x50"},
    {"pedestal_wireframe.json", "pedestal.step",
     "--style wireframe --view 1,-1.2,0.8 --paper 90x70"},
    {"pedestal_plotter.json", "pedestal.step", "--style plotter --view 1,-1.2,0.8 --paper 60x50"},
    {"coupling_flat.json", "coupling.step", "--style flat --view 1,-1.2,0.8 --paper 50x40"},
    {"stand_highlight.svg", "bearing_stand.obj",
     "--style outline --highlight pulley --view 1,-1.2,0.8 --paper 60x60"},
    {"smooth_blend_isophotes.json", "smooth_blend.implicit",
     "--style engraving --set hatch.field=isophote --set hatch.cross_from=2 --set halo.gap=0.4 "
     "--view 1,-0.8,1 --paper 50x50"},
};

/// Of drawings that differ with a version of OCCT, one lies in a folder of that version.
fs::path golden_path(const char* name) {
  const fs::path drawings = fs::path(BURIN_SOURCE_DIR) / "tests/golden/drawings";
  const fs::path ours = drawings / BURIN_GOLDEN_VERSION / name;
  return fs::exists(ours) ? ours : drawings / name;
}

std::string read(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

std::string drawn(const Case& c) {
  const fs::path out =
      fs::temp_directory_path() / fmt::format("burin_golden_{}_{}", getpid(), c.name);
  const std::string points3 = out.extension() == ".json" ? "--set json.points3=false" : "";
  const std::string command =
      fmt::format("{} draw {}/samples/{} {} {} --quiet -o {}", BURIN_COMMAND, BURIN_SOURCE_DIR,
                  c.input, c.options, points3, out.string());
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  const std::string text = read(out);
  fs::remove(out);
  return out.extension() == ".json" ? canonical(text) : text;
}

class GoldenDrawing : public testing::TestWithParam<Case> {};

TEST_P(GoldenDrawing, IsUnchanged) {
  const fs::path golden = golden_path(GetParam().name);
  const std::string actual = drawn(GetParam());
  ASSERT_GT(actual.size(), 1000u);
  const char* accept = std::getenv("BURIN_ACCEPT_GOLDEN");
  if (accept != nullptr && std::string(accept) == "1") {
    fs::create_directories(golden.parent_path());
    std::ofstream(golden, std::ios::binary) << actual;
  }
  const std::string expected = read(golden);
  ASSERT_FALSE(expected.empty()) << golden << " is missing: accept it by BURIN_ACCEPT_GOLDEN=1";
  EXPECT_EQ(difference(expected, actual, 0.02), std::nullopt) << GetParam().name;
  EXPECT_LT(expected.size(), 300u * 1024);
}

TEST_P(GoldenDrawing, AChangeOfAnyLineIsFound) {
  const std::string expected = read(golden_path(GetParam().name));
  ASSERT_FALSE(expected.empty());
  // Without its last path, and with the first decimal digit of some coordinate in its middle
  // changed.
  std::string shorter = expected;
  const bool svg = expected.front() == '<';
  const auto last = svg ? expected.rfind("<path") : expected.rfind("\n{\"kind\"");
  ASSERT_NE(last, expected.npos);
  shorter.erase(last, expected.find('\n', last + 1) - last);
  EXPECT_NE(difference(expected, shorter, 0.02), std::nullopt);
  std::string moved = expected;
  const auto at = moved.find('.', moved.find(svg ? " d=\"" : "\"points\"", moved.size() / 3)) + 1;
  ASSERT_LT(at, moved.size());
  moved[at] = moved[at] == '5' ? '7' : '5';
  EXPECT_NE(difference(expected, moved, 0.02), std::nullopt);
}

INSTANTIATE_TEST_SUITE_P(Samples, GoldenDrawing, testing::ValuesIn(kCases), [](const auto& which) {
  std::string name = which.param.name;
  for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  return name;
});

}  // namespace
}  // namespace burin::golden
