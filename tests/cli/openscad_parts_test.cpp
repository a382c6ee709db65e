// Parts of OpenSCAD programs, evaluated by Burin, and what burin.scad says of them.

#include "models.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

namespace burin::test {
namespace {

using Json = nlohmann::json;

class OpenscadParts : public CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    if (std::system("command -v openscad >/dev/null") != 0) {
      GTEST_SKIP() << "openscad is not installed";
    }
    std::filesystem::copy(std::string(BURIN_SOURCE_DIR) + "/samples/openscad/burin.scad",
                          folder_ / "burin.scad");
  }
  Json parts_of(const std::string& model, const std::string& options = "") {
    folder_.write("m.scad", model);
    EXPECT_EQ(run("info @/m.scad --json " + options), 0) << err_;
    return Json::parse(out_)["files"][0]["parts"];
  }
  static std::vector<std::string> names(const Json& parts) {
    std::vector<std::string> out;
    for (const Json& part : parts) out.push_back(part["name"]);
    return out;
  }
  std::string drawn(const std::string& options) {
    EXPECT_EQ(run("draw @/m.scad -o @/m.svg --no-progress " + options), 0) << err_;
    return slurp(folder_ / "m.svg");
  }
  Json drawing(const std::string& options) {
    EXPECT_EQ(run("draw @/m.scad -o @/m.json --no-progress " + options), 0) << err_;
    return Json::parse(slurp(folder_ / "m.json"));
  }
};

using Names = std::vector<std::string>;

TEST_F(OpenscadParts, ObjectsAtTheTopByTheirModules) {
  const Json parts = parts_of(
      "module arm() { cube([10, 2, 2]); translate([0, 0, 2]) cylinder(r = 1, h = 3, $fn = 24); }\n"
      "arm();\ntranslate([0, 20, 0]) rotate(30) color(\"red\") arm();\nsphere(2);");
  EXPECT_EQ(names(parts), (Names{"arm", "arm #2", "m"}));
  EXPECT_EQ(parts[1]["color"], "#ff0000");
  EXPECT_NEAR(parts[1]["volume"].get<double>(), parts[0]["volume"].get<double>(), 1e-4);
}

TEST_F(OpenscadParts, WhoeverMakesTheSolidsTheVolumeIsTheSame) {
  const std::string model =
      "difference() { cube(20, center = true); rotate([30, 10, 0]) cylinder(r = 6, h = 40, $fn = "
      "48, "
      "center = true); sphere(9, $fn = 40); }";
  const double here = parts_of(model, "--csg burin")[0]["volume"];
  const double there = parts_of(model, "--csg openscad")[0]["volume"];
  EXPECT_NEAR(here, there, 1e-5 * there);
}

TEST_F(OpenscadParts, FacesKnowTheirPrimitives) {
  // A prism of eight sides stays one, and so does a polygon of twelve that is called by nobody.
  parts_of(
      "difference() { cylinder(r = 10, h = 9, $fn = 64); translate([0, 0, -1]) cylinder(r = 4, h = "
      "20, $fn = 8); "
      "translate([6, 0, 9]) sphere(2, $fn = 40); }");
  drawn("-v");
  EXPECT_NE(err_.find("approximate: 1 cylinder, 1 sphere\n"), std::string::npos) << err_;
  EXPECT_EQ(err_.find("by_openscad"), std::string::npos) << err_;
}

TEST_F(OpenscadParts, MarksOfSeveralModelsHoldTogether) {
  folder_.write("a.scad",
                "use <burin.scad>\nexplode([0, 0, 30]) part(\"a1\") cube(10);\ncallout(7) "
                "part(\"a2\") translate([0, 0, -9]) cube(9);\n");
  folder_.write("b.scad",
                "use <burin.scad>\nexplode([0, 0, -20]) part(\"b1\") translate([40, 0, 0]) "
                "cube(8);\ncallout(8) part(\"b2\") translate([40, 0, 9]) cube(7);\ncallout(7) "
                "part(\"b3\") translate([60, 0, 9]) cube(6);\n");
  ASSERT_EQ(run("draw @/a.scad @/b.scad -o @/o.json --explode auto --view front --scale 1"), 0)
      << err_;
  EXPECT_NE(err_.find("'/b3' gets another number than 7, which '/a2' has"), std::string::npos)
      << err_;
  const Json drawing = Json::parse(slurp(folder_ / "o.json"));
  std::map<std::string, int> numbers;
  for (const Json& item : drawing["items"]) numbers[item["name"]] = item["number"];
  EXPECT_EQ(numbers["a2"], 7);
  EXPECT_EQ(numbers["b2"], 8);
  EXPECT_EQ(numbers.size(), 5U);
  // Steps of both: a1 has gone up by 30, b1 down by 20.
  std::map<int, std::pair<double, double>> heights;
  for (const Json& layer : drawing["layers"]) {
    if (layer["name"] == "trail" || layer["name"] == "callouts") continue;
    for (const Json& path : layer["paths"]) {
      auto& [low, high] = heights.try_emplace(path["part"], 1e9, -1e9).first->second;
      for (const Json& point : path["points"]) {
        low = std::min(low, point[1].get<double>());
        high = std::max(high, point[1].get<double>());
      }
    }
  }
  EXPECT_NEAR(heights[0].second - heights[1].second, 40, 0.01);
  EXPECT_NEAR(heights[1].first - heights[2].first, 11, 0.01);
}

TEST_F(OpenscadParts, AViewThatIsAskedForHasItsOwnWayUp) {
  parts_of("use <burin.scad>\nview(\"top\", up = [1, 0, 0]);\ncube([30, 20, 10]);\n");
  EXPECT_EQ(drawn("--view iso"), drawn("--view iso --up 0,0,1"));
  EXPECT_NE(drawn(""), drawn("--view top"));
}

TEST_F(OpenscadParts, ModelsSayHowTheyAreDrawn) {
  const std::string model =
      "use <burin.scad>\nview(\"front\");\nexplode([0, 0, 30]) part(\"lid\") cube([10, 10, 2]);\n"
      "callout(7) part(\"pot\") translate([0, 0, -9]) cube([10, 10, 9]);\n";
  EXPECT_EQ(names(parts_of(model)), (Names{"lid", "pot"}));
  const std::string front = drawn("");
  EXPECT_EQ(front, drawn("--view front"));
  EXPECT_NE(front, drawn("--view iso"));
  const Json items = drawing("")["items"];
  ASSERT_EQ(items.size(), 2U);
  EXPECT_TRUE(items[0]["number"] == 7 || items[1]["number"] == 7) << items;
  // Apart only where that is asked for, and then as the model says.
  const auto height = [&](const std::string& options) {
    double low = 1e9, high = -1e9;
    const Json all = drawing("--scale 1 " + options);
    for (const Json& layer : all["layers"]) {
      if (layer["name"] == "callouts" || layer["name"] == "trail") continue;
      for (const Json& path : layer["paths"]) {
        for (const Json& point : path["points"]) {
          low = std::min(low, point[1].get<double>());
          high = std::max(high, point[1].get<double>());
        }
      }
    }
    return high - low;
  };
  EXPECT_NEAR(height(""), 11, 1e-3);
  EXPECT_NEAR(height("--explode auto"), 41, 1e-3);
}

TEST_F(OpenscadParts, ListsHoldWhatIsMade) {
  folder_.write("m.scad",
                "module bolt() cylinder(r = 2, h = 9);\ncube([20, 20, 5]);\n#translate([5, 5, 5]) "
                "bolt();\ntranslate([10, 5, 5]) bolt();\n%translate([15, 5, 5]) bolt();\n"
                "translate([40, 0, 0]) difference() { cube(9); #sphere(4); }");
  ASSERT_EQ(run("draw @/m.scad -o @/m.svg --no-progress --parts-list @/m.csv"), 0) << err_;
  const std::string list = slurp(folder_ / "m.csv");
  EXPECT_EQ(std::ranges::count(list, '\n'), 4) << list;
  EXPECT_NE(list.find(",bolt,2,"), std::string::npos) << list;
  EXPECT_EQ(list.find("background"), std::string::npos) << list;
}

TEST_F(OpenscadParts, GlassInGlassHasACallout) {
  folder_.write("m.scad",
                "use <burin.scad>\ncallout() part(\"case\") color(\"blue\", 0.3) cube(40);\n"
                "callout() part(\"inner\") color(\"red\", 0.3) translate([10, 10, 10]) cube(20);\n"
                "callout() part(\"core\") translate([20, 20, 20]) cube(4);");
  const Json all = drawing("--paper A5");
  EXPECT_EQ(err_.find("not seen"), std::string::npos) << err_;
  const auto callouts = std::ranges::find_if(
      all["layers"], [](const Json& layer) { return layer["name"] == "callouts"; });
  ASSERT_NE(callouts, all["layers"].end());
  EXPECT_EQ((*callouts)["texts"].size(), 3U);
}

TEST_F(OpenscadParts, WallsThatMeetGentlyMeetInAnEdge) {
  // 11 degrees from the wall, and no round surface anywhere.
  folder_.write("m.scad",
                "hull() { cube([20, 20, 1]); translate([1, 1, 5]) cube([18, 18, 0.1]); "
                "translate([2, 2, 6]) cube([16, 16, 0.1]); }");
  const Json all = drawing("--style outline --view front --scale 4");
  std::set<long> heights;
  for (const Json& layer : all["layers"]) {
    for (const Json& path : layer["paths"]) {
      const Json &from = path["points"].front(), &to = path["points"].back();
      const double rise = to[1].get<double>() - from[1].get<double>(),
                   run = to[0].get<double>() - from[0].get<double>();
      if (std::abs(rise) < 1e-6 && std::abs(run) > 60) {
        heights.insert(std::lround(10 * from[1].get<double>()));
      }
    }
  }
  EXPECT_EQ(heights.size(), 4U) << "the floor, two joints and the top";
}

TEST_F(OpenscadParts, CornersOfFewFacetsAreDrawnFacetByFacet) {
  folder_.write("m.scad", "linear_extrude(5) offset(r = 2) square(5);");
  const Json all = drawing("--style outline --view front --scale 4");
  std::set<long> upright;
  for (const Json& layer : all["layers"]) {
    for (const Json& path : layer["paths"]) {
      const Json &from = path["points"].front(), &to = path["points"].back();
      if (std::abs(to[0].get<double>() - from[0].get<double>()) > 1e-6) continue;
      if (std::abs(to[1].get<double>() - from[1].get<double>()) < 15) continue;
      upright.insert(std::lround(10 * from[0].get<double>()));
    }
  }
  EXPECT_EQ(upright.size(), 6U) << "the outline, a bend in each corner, both ends of the side";
}

TEST_F(OpenscadParts, AStretchedBallIsAnEllipsoid) {
  folder_.write("m.scad", "scale([3, 2, 1]) sphere(5);");
  const Json all = drawing("--style outline --view top --scale 2");
  // The outline lies on the ellipse of half axes 30 and 20 mm of paper, about its middle.
  double x0 = 1e9, x1 = -1e9, y0 = 1e9, y1 = -1e9;
  std::vector<std::pair<double, double>> points;
  for (const Json& layer : all["layers"]) {
    for (const Json& path : layer["paths"]) {
      for (const Json& p : path["points"]) {
        const double x = p[0], y = p[1];
        x0 = std::min(x0, x), x1 = std::max(x1, x);
        y0 = std::min(y0, y), y1 = std::max(y1, y);
        points.emplace_back(x, y);
      }
    }
  }
  EXPECT_NEAR(x1 - x0, 60, 0.1);
  EXPECT_NEAR(y1 - y0, 40, 0.1);
  for (const auto& [x, y] : points) {
    EXPECT_NEAR(std::hypot((x - (x0 + x1) / 2) / 30, (y - (y0 + y1) / 2) / 20), 1, 3e-3);
  }
  const Json parts = parts_of("scale([3, 2, 1]) sphere(5);");
  EXPECT_NEAR(parts[0]["volume"].get<double>() / parts_of("sphere(5);")[0]["volume"].get<double>(),
              6, 1e-6);
}

TEST_F(OpenscadParts, ThatManyCallsStayOnePartIsSaid) {
  folder_.write("m.scad",
                "module pin() cube(1);\nfor (i = [0:1000]) translate([2 * i, 0, 0]) pin();");
  drawn("--style outline");
  EXPECT_NE(err_.find("1001 calls of pin stay one part"), std::string::npos) << err_;
  folder_.write("m.scad", "module pin() cube(1);\nfor (i = [0:9]) translate([2 * i, 0, 0]) pin();");
  drawn("--style outline");
  EXPECT_EQ(err_, "");
}

TEST_F(OpenscadParts, InkIsThatOfItsParts) {
  folder_.write("m.scad",
                "use <burin.scad>\nink(\"outline\") sphere(5, $fn = 48);\ntranslate([20, 0, 0]) "
                "sphere(5, $fn = 48);");
  const std::string one = drawn("--style engraving");
  folder_.write("m.scad", "sphere(5, $fn = 48);\ntranslate([20, 0, 0]) sphere(5, $fn = 48);");
  EXPECT_GT(drawn("--style engraving").size(), 1.5 * static_cast<double>(one.size()));
}

TEST_F(OpenscadParts, BurinScadIsHarmless) {
  folder_.write("m.scad",
                "use <burin.scad>\nview(\"front\");\npart(\"a\") difference() { part(\"b\") "
                "cube(4); callout() cube(2); }");
  ASSERT_EQ(
      std::system(("cd " + folder_.path() + " && openscad -o m.off m.scad > said 2>&1").c_str()), 0)
      << slurp(folder_ / "said");
  EXPECT_EQ(slurp(folder_ / "said").find("WARNING"), std::string::npos) << slurp(folder_ / "said");
  ASSERT_EQ(run("info @/m.off --json"), 0);
  EXPECT_NEAR(Json::parse(out_)["files"][0]["parts"][0]["volume"].get<double>(), 56, 1e-9);
}

TEST_F(OpenscadParts, TreesAreImplicitFunctionsToo) {
  const Json parts = parts_of(
      "difference() { sphere(10); translate([0, 0, -20]) cylinder(r = 3, h = 40); }\n"
      "translate([30, 0, 0]) rotate([0, 90, 0]) cylinder(r1 = 8, r2 = 0, h = 9);",
      "--as implicit");
  constexpr double kPi = std::numbers::pi;
  const double cap = std::sqrt(91.);  // half the length of the hole
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_NEAR(parts[0]["volume"].get<double>(), 4 * kPi / 3 * cap * cap * cap, 2);
  EXPECT_NEAR(parts[1]["volume"].get<double>(), kPi * 64 * 9 / 3, 1);
  folder_.write("m.scad", "cube(1); hull() { cube(1); sphere(2, $fn = 32); }");
  EXPECT_EQ(run("draw @/m.scad -o @/m.svg --as implicit"), 3);
  expect_error("hull() has no implicit function; draw the file without --as");
}

TEST_F(OpenscadParts, SolidsAsFiles) {
  folder_.write("m.scad", "cube(10); translate([5, 5, 5]) cube(10);");
  ASSERT_EQ(run("convert @/m.scad -o @/m.off -o @/m.stl -o @/m.3mf"), 0) << err_;
  for (const char* name : {"m.off", "m.stl", "m.3mf"}) {
    ASSERT_EQ(run(std::string("info @/") + name + " --json"), 0) << err_;
    const Json part = Json::parse(out_)["files"][0]["parts"][0];
    EXPECT_NEAR(part["volume"].get<double>(), 2000 - 125, 1e-3) << name;
    EXPECT_EQ(part["boundary_edges"], 0) << name;
  }
  const std::string before = slurp(folder_ / "m.3mf");
  ASSERT_EQ(run("convert @/m.scad -o @/m.3mf"), 0) << err_;
  EXPECT_EQ(slurp(folder_ / "m.3mf"), before);
  EXPECT_EQ(run("convert @/m.scad -o @/m.svg"), 2);
  expect_error("are written as .stl, .off or .3mf; burin draw makes drawings");
}

TEST_F(OpenscadParts, NonsenseIsToldInOneLine) {
  const auto refused = [&](const std::string& model, const std::string& what) {
    folder_.write("m.scad", model);
    EXPECT_EQ(run("draw @/m.scad -o @/m.svg"), 3) << model;
    expect_error(what);
  };
  refused("hull();", "makes nothing of it");
  refused("difference() { cube(0); cube(2); }", "makes nothing of it");
  refused("cylinder(r = 1, h = 1, $fn = 1e9);", "corners");
  EXPECT_NE(err_.find("m.scad: in m: "), std::string::npos) << "the tree has lines, not the file";
  ASSERT_EQ(std::system(("gzip -kf " + (folder_ / "m.scad")).c_str()), 0);
  EXPECT_EQ(run("draw @/m.scad.gz -o @/m.svg"), 3);
  expect_error("unpack it");
  refused("", "is empty: there is no program in it");
  refused("\xff\xfe" + std::string("c\0u\0b\0e\0(\0)\0;\0", 14), "is text in UTF-16");
}

TEST_F(OpenscadParts, AModelNeedsNoCopyOfTheLibrary) {
  std::filesystem::remove(folder_ / "burin.scad");
  folder_.write("m.scad", "use <burin.scad>\nuse <users.scad>\npart(\"lid\") users();");
  // Where the user has libraries they are found first.
  std::filesystem::create_directory(folder_ / "libraries");
  folder_.write("libraries/users.scad", "module users() cube(9);");
  ::setenv("OPENSCADPATH", (folder_ / "libraries").c_str(), 1);
  EXPECT_EQ(run("draw @/m.scad -o @/m.json"), 0) << err_;
  ::unsetenv("OPENSCADPATH");
  EXPECT_NE(slurp(folder_ / "m.json").find("\"name\": \"lid\""), std::string::npos);
}

// Repair of what was worked out is nothing that its writer could do better.
TEST_F(OpenscadParts, SolidsThatTouchAlongAnEdgeAreDrawnWithoutAWord) {
  folder_.write("m.scad", "cube(5); translate([5, 5, 0]) cube(5);");
  drawn("");
  EXPECT_EQ(err_, "");
}

TEST_F(OpenscadParts, ACancelEndsTheEvaluation) {
  folder_.write("m.scad",
                "difference() { sphere(100, $fn = 400); for (i = [0:60], j = [0:60]) translate([3 "
                "* i - 90, 3 * j - 90, 0]) "
                "cylinder(r = 1.2, h = 300, $fn = 40, center = true); }");
  Command command(folder_, {"draw", folder_ / "m.scad", "-o", folder_ / "m.svg", "--no-progress"});
  std::this_thread::sleep_for(std::chrono::milliseconds(1500));
  command.signal(SIGINT);
  EXPECT_EQ(command.wait(), 5);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "m.svg"));
}

// Where marks are written into an illustration, it draws what the model draws.
TEST_F(OpenscadParts, IllustrationsHaveTheMarksOfTheModel) {
  folder_.write(
      "m.scad",
      "use <burin.scad>\nview(\"front\");\n"
      "callout(3) ink(\"engraving\") part(\"lid\") translate([0, 0, 10]) cube([9, 8, 2]);\n"
      "explode([0, 0, 30]) part(\"pin\") translate([2, 2, 15]) cube(3);\n"
      "part(\"base\") cube([9, 8, 10]);");
  ASSERT_EQ(run("illustrate @/m.scad --paper A6 -o @/m.burin.json"), 0) << err_;
  const Json file = Json::parse(slurp(folder_ / "m.burin.json"));
  EXPECT_EQ(file["view"]["from"], "front") << file;
  EXPECT_EQ(file["callouts"], true) << file;
  EXPECT_EQ(file["looks"][0]["style"], "engraving") << file;
  EXPECT_EQ(file["items"]["3"]["select"], "/lid") << file;
  const std::string by_model = drawn("");
  ASSERT_EQ(run("draw @/m.burin.json -o @/m.svg"), 0) << err_;
  EXPECT_EQ(slurp(folder_ / "m.svg"), by_model);
  ASSERT_EQ(run("illustrate @/m.scad -o @/e.burin.json --explode auto --view top"), 0) << err_;
  const Json apart = Json::parse(slurp(folder_ / "e.burin.json"));
  EXPECT_EQ(apart["view"]["from"], "top") << "what is asked for holds";
  EXPECT_NEAR(apart["explode"]["steps"][0]["by"].get<double>(), 30, 1e-9);
}

TEST_F(OpenscadParts, WrongMarksNameTheModelAndTheMark) {
  const auto told = [&](const std::string& mark, const std::string& words) {
    folder_.write("m.scad", "use <burin.scad>\n" + mark + " cube(3);");
    EXPECT_EQ(run("draw @/m.scad -o @/m.svg"), 2) << mark;
    EXPECT_NE(err_.find(words), std::string::npos) << err_;
    EXPECT_EQ(err_.find("m.scad:1:"), std::string::npos) << err_;
  };
  told("view(\"frnt\");", "m.scad: view(): unknown view 'frnt'");
  told("ink(\"engrving\")", "m.scad: ink(\"engrving\"): unknown style 'engrving'");
  told("callout(0)", "m.scad: callout(0): an item has a number from 1 to");
}

// A mark is no wish of the user's, so nothing is said of it where it has no effect.
TEST_F(OpenscadParts, ADifferenceSaysNothingOfCalloutsThatMarksAskFor) {
  folder_.write("m.scad", "use <burin.scad>\ncallout(1) part(\"lid\") cube(3);");
  folder_.write("n.scad", "use <burin.scad>\ncallout(1) part(\"lid\") cube(4);");
  EXPECT_EQ(run("diff @/m.scad @/n.scad -o @/d.svg"), 6) << err_;
  EXPECT_EQ(err_.find("no effect"), std::string::npos) << err_;
}

}  // namespace
}  // namespace burin::test
