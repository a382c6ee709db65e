// CAD files through the command: what it reports, draws and refuses.
#include "models.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>

namespace burin {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class CliCad : public test::CliTest {
 protected:
  static std::string sample(const std::string& name) {
    return (fs::path(BURIN_SOURCE_DIR) / "samples" / name).string();
  }
  json drawing(const std::string& line) {
    EXPECT_EQ(run("draw " + line + " -o @/a.json --style outline"), 0) << err_;
    return json::parse(test::slurp(folder_ / "a.json"));
  }
};

TEST_F(CliCad, AListCountsPartsWhateverBodiesOfThemAreDrawn) {
  const fs::path file = fs::path(BURIN_TEST_DATA) / "outside/product_of_solids.step";
  if (!fs::exists(file)) GTEST_SKIP() << "no " << file;
  for (const auto& [parts, rows] :
       {std::pair("--part */solid* --hide */solid?1", "2,chip,4,"),
        std::pair("--part */solid*", "2,chip,4,"), std::pair("--part chip/solid?2", "2,chip,1,")}) {
    ASSERT_EQ(run("draw " + file.string() + " " + parts +
                  " --style outline --paper A6 -o @/a.json --parts-list @/a.csv"),
              0)
        << err_;
    const std::string list = test::slurp(folder_ / "a.csv");
    EXPECT_NE(list.find(rows), list.npos) << list;
    EXPECT_EQ(std::ranges::count(list, '\n'), 2) << list;
  }
}

TEST_F(CliCad, StrokesOfAPlaneStayStraightAroundABoss) {
  // From above, beside a fillet about whose axis strokes run.
  ASSERT_EQ(run("draw " + sample("gear_pump.step") +
                " --part *cover --view top --style engraving --paper A5 -o @/a.json"),
            0)
      << err_;
  const json drawing = json::parse(test::slurp(folder_ / "a.json"));
  double top = 0;
  std::size_t strokes = 0, bent = 0;
  const auto on_plane = [&](const json& path) {
    for (const json& p : path.at("points3")) {
      if (std::abs(p[2].get<double>() - top) > 1e-6) return false;
    }
    return true;
  };
  // The plane is where the most strokes are.
  std::map<long, std::size_t> heights;
  for (const json& layer : drawing.at("layers")) {
    for (const json& path : layer.at("paths")) {
      if (path.at("kind") == "stroke")
        ++heights[std::lround(1e3 * path["points3"][0][2].get<double>())];
    }
  }
  top = 1e-3 * static_cast<double>(std::ranges::max_element(
                                       heights, {}, &std::pair<const long, std::size_t>::second)
                                       ->first);
  for (const json& layer : drawing.at("layers")) {
    for (const json& path : layer.at("paths")) {
      if (path.at("kind") != "stroke" || !on_plane(path)) continue;
      ++strokes;
      double low = 1e9, high = -1e9;
      for (const json& p : path.at("points")) {
        low = std::min(low, p[1].get<double>()), high = std::max(high, p[1].get<double>());
      }
      bent += high - low > 0.35;
    }
  }
  EXPECT_GT(strokes, 100U);
  EXPECT_LE(bent, strokes / 100);
}

TEST_F(CliCad, InfoTellsOfPartsShapesAndMeasures) {
  ASSERT_EQ(run("info --json " + sample("coupling.step") + " @/box.off"), 0) << err_;
  const json files = json::parse(out_).at("files");
  const json& cad = files.at(0);
  EXPECT_EQ(cad.at("format"), "STEP (AP214)");
  EXPECT_TRUE(cad.at("schema").get<std::string>().starts_with("AUTOMOTIVE_DESIGN"));
  EXPECT_EQ(cad.at("parts").size(), 30u);
  EXPECT_EQ(cad.at("solids"), 30);
  EXPECT_EQ(cad.at("faces"), 278);
  EXPECT_EQ(cad.at("closed"), true);
  EXPECT_FALSE(cad.contains("triangles"));
  EXPECT_NEAR(cad.at("bounds").at("size").at(0), 240, 1e-6);
  const json& nut = cad.at("parts").at(13);
  EXPECT_EQ(nut.at("name"), "nut");
  EXPECT_EQ(nut.at("assembly"), json::parse(R"(["flange coupling", "bolt set 2"])"));
  EXPECT_EQ(nut.at("color"), "#b89e4c");
  EXPECT_EQ(nut.at("same_shape_as"), 9);
  EXPECT_NEAR(nut.at("volume"), 1331.54, 0.01);
  // Beside a mesh, in one answer.
  EXPECT_EQ(files.at(1).at("triangles"), 12);
  EXPECT_FALSE(files.at(1).contains("solids"));
  ASSERT_EQ(run("info " + sample("pedestal.step")), 0);
  EXPECT_NE(out_.find("faces       126\n"), std::string::npos) << out_;
  EXPECT_NE(out_.find("volume      365347 mm3"), std::string::npos) << out_;
}

TEST_F(CliCad, DrawingsNameThePartsAndFacesOfTheFile) {
  const json j = drawing(sample("coupling.step") + " @/box.off");
  ASSERT_EQ(j.at("parts").size(), 31u);
  const json& bolt = j.at("parts").at(6);
  EXPECT_EQ(bolt.at("name"), "bolt");
  EXPECT_EQ(bolt.at("assembly"), json::parse(R"(["flange coupling", "bolt set 1"])"));
  EXPECT_EQ(bolt.at("color"), "#404047");
  EXPECT_EQ(bolt.at("faces"), 12);
  EXPECT_FALSE(j.at("parts").at(30).contains("assembly"));
  std::set<int> drawn;
  for (const json& layer : j.at("layers")) {
    for (const json& path : layer.at("paths")) {
      drawn.insert(path.at("part").get<int>());
      const json& part = j.at("parts").at(path.at("part").get<std::size_t>());
      EXPECT_LT(path.at("face"), part.at("faces"));
    }
  }
  EXPECT_GT(drawn.size(), 15u);
}

TEST_F(CliCad, BadFilesAreOneLine) {
  folder_.write("empty.step", "");
  folder_.write("rubbish.step", "nothing of the kind\n");
  folder_.write("syntax.stp",
                "ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('X'));\nENDSEC;\nDATA;\n"
                "#1=CARTESIAN_POINT('',(1.;\nENDSEC;\nEND-ISO-10303-21;\n");
  folder_.write("rubbish.brep", "DBRep_DrawableShape\n\nCASCADE Topology V1\nLocations x\n");
  folder_.write("rubbish.igs", "rubbish\n");
  fs::create_directory(folder_ / "folder.step");
  for (const char* name :
       {"empty.step", "rubbish.step", "syntax.stp", "rubbish.brep", "rubbish.igs", "folder.step"}) {
    SCOPED_TRACE(name);
    for (const std::string verb : {"info @/", "draw -o @/a.svg @/"}) {
      EXPECT_EQ(run(verb + name), 3);
      expect_error(name);
      EXPECT_EQ(out_, "");
      EXPECT_FALSE(fs::exists(folder_ / "a.svg"));
    }
  }
  EXPECT_EQ(run("info @/syntax.stp"), 3);
  EXPECT_NE(err_.find("syntax.stp:6: "), std::string::npos) << err_;
}

TEST_F(CliCad, ACutFileIsDrawnWithAWarning) {
  const std::string text = test::slurp(sample("coupling.step"));
  folder_.write("cut.step", text.substr(0, text.size() * 7 / 10));
  EXPECT_EQ(run("draw @/cut.step -o @/a.svg --style outline"), 0) << err_;
  EXPECT_NE(err_.find("burin: warning: cut.step: the file ends early, in line "), std::string::npos)
      << err_;
}

TEST_F(CliCad, StopsWhileReading) {
  test::Command command(folder_, {"draw", sample("coupling.step"), "-o", folder_ / "a.svg",
                                  "--progress", "--style", "outline"});
  ASSERT_TRUE(command.wait_for("progress read"));
  command.signal(SIGINT);
  EXPECT_EQ(command.wait(), 5) << command.std_err;
  EXPECT_FALSE(fs::exists(folder_ / "a.svg"));
}

TEST_F(CliCad, MeshesNeedNoLibraryOfCadFiles) {
  // A copy of libburin without the other library beside it.
  const fs::path build = fs::path(BURIN_COMMAND).parent_path().parent_path();
  fs::copy_file(build / "lib" / "libburin.so.0", folder_ / "libburin.so.0");
  ASSERT_EQ(::setenv("LD_LIBRARY_PATH", folder_.path().c_str(), 1), 0);
  const int mesh = run("draw @/box.off -o @/a.svg");
  const int cad = run("info " + sample("pedestal.step"));
  ::unsetenv("LD_LIBRARY_PATH");
  EXPECT_EQ(mesh, 0);
  EXPECT_EQ(cad, 1);
  expect_error("libburin_cad.so");
  expect_error("pedestal.step: the library that reads CAD files");
}

// The base of the pedestal is rounded by 2 mm, two gaps of strokes on A5, towards its white top. At
// its side x = 74 lines across would be a fringe of stubs.
TEST_F(CliCad, StrokesRunAlongANarrowFillet) {
  ASSERT_EQ(run("draw " + sample("pedestal.step") + " -o @/a.json --style engraving --paper A5"), 0)
      << err_;
  const json drawn = json::parse(test::slurp(folder_ / "a.json"));
  double along = 0, across = 0;
  for (const json& layer : drawn.at("layers")) {
    for (const json& path : layer.at("paths")) {
      if (path.at("kind") != "stroke") continue;
      const json& points = path.at("points3");
      for (std::size_t i = 1; i < points.size(); ++i) {
        std::array<double, 3> middle{}, step{};
        for (std::size_t c = 0; c < 3; ++c) {
          const double a = points[i - 1][c], b = points[i][c];
          middle[c] = 0.5 * (a + b);
          step[c] = b - a;
        }
        const bool on_fillet = middle[0] > 72.2 && middle[2] > 14.2 && std::abs(middle[1]) < 25;
        if (!on_fillet) continue;
        const double length = std::hypot(step[0], step[1], step[2]);
        (std::abs(step[1]) > 0.7 * length ? along : across) += length;
      }
    }
  }
  EXPECT_GT(along, 2 * 40);  // two lines from end to end
  EXPECT_LT(across, 1);
}

}  // namespace
}  // namespace burin
