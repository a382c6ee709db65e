// What a drawing may cost is bounded by its sheet and its input: peak memory of whole runs.
#include "models.h"

#include <burin_test/sanitized.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>

namespace burin {
namespace {

namespace fs = std::filesystem;

/// A cubic in one direction of a patch as Bezier segments end to end, whose common knots are of
/// full multiplicity: points in the plane (distance from the axis, height).
struct Profile {
  std::vector<Vec2> points;
  std::vector<double> knots;  // of the segments' ends
};

std::string knot_vector(const std::vector<double>& ends) {
  std::string text = "[KV";
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const bool end = i == 0 || i + 1 == ends.size();
    for (int k = 0; k < (end ? 4 : 3); ++k) text += fmt::format(" {}", ends[i]);
  }
  return text + "]\n";
}

/// The profile turned about z, in four cubic quarters: the surface is smooth where the profile is,
/// its parametrisation breaks at every third knot.
std::string turned(const Profile& profile, const std::string& name) {
  constexpr double kArc = 0.5522847498;
  const std::vector<Vec2> circle = {{1, 0},     {1, kArc},  {kArc, 1},   {0, 1},      {-kArc, 1},
                                    {-1, kArc}, {-1, 0},    {-1, -kArc}, {-kArc, -1}, {0, -1},
                                    {kArc, -1}, {1, -kArc}, {1, 0}};
  std::string text =
      fmt::format("[OBJECT {}\n[SURFACE BSPLINE {} 13 4 4 E3\n", name, profile.points.size());
  text += knot_vector(profile.knots) + knot_vector({0, 1, 5, 6, 10});
  for (const Vec2 c : circle) {
    for (const Vec2 p : profile.points) {
      text += fmt::format("[{} {} {}]\n", p.x * c.x, p.x * c.y, p.y);
    }
  }
  return text + "]]\n";
}

class Memory : public test::CliTest {
 protected:
  /// Draws on A4 with two threads and returns the MB that it took at the most.
  double draw(const std::string& file, const std::string& options) {
    const std::string sheet = options.find("--paper") == options.npos ? " --paper A4" : "";
    EXPECT_EQ(run("draw " + file + " -o @/a.svg --threads 2 " + options + sheet), 0) << err_;
    // An empty drawing costs nothing.
    EXPECT_NE(test::slurp(folder_ / "a.svg").find("<path"), std::string::npos) << file;
    return peak_mb_;
  }
  void SetUp() override {
    CliTest::SetUp();
    if (test::kSanitized) GTEST_SKIP() << "sanitizers take memory of their own";
  }
};

TEST_F(Memory, KinksAndPolesOfSplinesTakeNoMoreThanTheirSheetShows) {
  // A pot: smooth wall of uneven parameters, a sharp rim, a lid that ends in a pole.
  const Profile wall{{{10, 0},
                      {14, 3},
                      {16, 8},
                      {16, 12},
                      {16, 30},
                      {9, 34},
                      {9, 40},
                      {9, 41},
                      {10, 41},
                      {10, 40}},
                     {0, 1, 9, 10}};
  const Profile lid{{{9, 40}, {8, 44}, {3, 44}, {2, 46}, {1.5, 47}, {3, 50}, {0, 50}}, {0, 1, 4}};
  folder_.write("pot.itd", "[OBJECT POT\n" + turned(wall, "WALL") + turned(lid, "LID") + "]\n");
  EXPECT_LT(draw("@/pot.itd", "--style outline"), 150);
  EXPECT_LT(draw("@/pot.itd", "--style outline --view top"), 150);
  EXPECT_LT(draw("@/pot.itd", "--style engraving"), 300);
}

TEST_F(Memory, RoughSplinesAreBoundedBySheetAndSaid) {
  // 60 x 60 control points, each at a height of its own: bends of the sheet's finest lines.
  constexpr int kCount = 60;
  std::string text = fmt::format("[OBJECT ROUGH\n[SURFACE BSPLINE {0} {0} 4 4 E3\n", kCount);
  std::string knots = "[KV 0 0 0";
  for (int i = 0; i <= kCount - 3; ++i) knots += fmt::format(" {}", i);
  knots += fmt::format(" {0} {0} {0}]\n", kCount - 3);
  text += knots + knots;
  for (int j = 0; j < kCount; ++j) {
    for (int i = 0; i < kCount; ++i) {
      text += fmt::format("[{} {} {}]\n", i, j, 40 * std::sin(12.9898 * i + 78.233 * j));
    }
  }
  folder_.write("rough.itd", text + "]]\n");
  EXPECT_LT(draw("@/rough.itd", "--style outline --paper A6 --tolerance 0.00001"), 1200);
  EXPECT_NE(err_.find("triangles are the most that this part gets"), std::string::npos) << err_;
}

// The work for a detail is that of its sheet, whatever the scale is, and none of the sheet stays
// white.
TEST_F(Memory, MagnifiedDetailsTakeWhatTheirSheetTakes) {
  const fs::path part = fs::path(BURIN_SOURCE_DIR) / "samples" / "propeller.step";
  for (const char* scale : {"1000"}) {
    SCOPED_TRACE(scale);
    ASSERT_EQ(
        run("draw " + part.string() + " -o @/a.json --style engraving --paper A6 --scale " + scale),
        0)
        << err_;
    EXPECT_LT(peak_mb_, 400);
    EXPECT_NE(err_.find("times as large as the sheet"), std::string::npos) << err_;
    const auto stats = nlohmann::json::parse(test::slurp(folder_ / "a.json"))["stats"];
    EXPECT_LT(stats["coverage_delta"], 5);
    EXPECT_GT(stats["strokes"], 100);
  }
}

struct RealFile {
  const char* path;
  const char* options;
  double outline_mb, engraving_mb;
};

class RealMemory : public Memory, public ::testing::WithParamInterface<RealFile> {};

TEST_P(RealMemory, IsBounded) {
  const RealFile& file = GetParam();
  const fs::path path = fs::path(BURIN_TEST_DATA) / file.path;
  if (!fs::exists(path)) GTEST_SKIP() << path << " is not here";
  const std::string options = file.options;
  EXPECT_LT(draw(path.string(), "--style outline " + options), file.outline_mb);
  if (file.engraving_mb > 0) {
    EXPECT_LT(draw(path.string(), "--style engraving " + options), file.engraving_mb);
  }
}

// The goal for every file of the folder is 500 MB in outline and 1,000 in engraving.
INSTANTIATE_TEST_SUITE_P(
    Files, RealMemory,
    ::testing::Values(RealFile{"step/gmsh/periodic_u_cst.step", "", 250, 500},
                      RealFile{"step/gmsh/periodic_u_cst.step", "--view 0.3,-1,0.45", 250, 0},
                      RealFile{"nurbs/occt/terrain.brep", "", 500, 0},
                      RealFile{"step/occt/linkrods.step", "", 500, 0},
                      RealFile{"nurbs/geomview/teapot.bez", "", 250, 500},
                      RealFile{"step/build123d/M6-1x12-countersunk-screw.step", "", 300, 0},
                      RealFile{"mesh/common3d/stanford-bunny.obj", "", 250, 0},
                      RealFile{"volume/volpack/engine-8bit.nrrd", "--iso 80", 500, 0}),
    [](const auto& file) {
      std::string name = file.param.path;
      for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
      return fmt::format("{}_{}", name, file.index);
    });

}  // namespace
}  // namespace burin
