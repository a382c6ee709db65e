// How many things an OpenSCAD program makes: what loops, modules and blocks give a parts list.

#include "models.h"

#include <nlohmann/json.hpp>

#include <map>

namespace burin::test {
namespace {

using Json = nlohmann::json;

class OpenscadInstances : public CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    if (std::system("command -v openscad >/dev/null") != 0) {
      GTEST_SKIP() << "openscad is not installed";
    }
    std::filesystem::copy(std::string(BURIN_SOURCE_DIR) + "/samples/openscad/burin.scad",
                          folder_ / "burin.scad");
  }
  Json drawing(const std::string& model) {
    folder_.write("m.scad", model);
    EXPECT_EQ(run("draw @/m.scad -o @/m.json --callouts --style outline --no-progress -v"), 0)
        << err_;
    return Json::parse(slurp(folder_ / "m.json"));
  }
  /// Names of items, and how many there are of each.
  std::map<std::string, int> items(const std::string& model) {
    std::map<std::string, int> out;
    const Json drawn = drawing(model);
    for (const Json& item : drawn["items"]) out[item["name"]] = item["quantity"];
    return out;
  }
  double volume(const std::string& model) {
    folder_.write("m.scad", model);
    EXPECT_EQ(run("info @/m.scad --json"), 0) << err_;
    double sum = 0;
    const Json told = Json::parse(out_);
    for (const Json& part : told["files"][0]["parts"]) {
      sum += part["volume"].get<double>();
    }
    return sum;
  }
};

using ItemCounts = std::map<std::string, int>;

const std::string kBolt =
    "module bolt(d = 6) { cylinder(d = d, h = 20, $fn = 32); translate([0, 0, 20]) cylinder(d = "
    "11, h = 6, $fn = 6); }\n";
const std::string kPlate =
    "module plate() difference() { translate([-40, -25, 0]) cube([80, 50, 8]); for (x = [-30, 0, "
    "30], y = [-15, 15]) translate([x, y, -1]) cylinder(d = 6.4, h = 10, $fn = 32); }\n";
const std::string kEach = "for (x = [-30, 0, 30], y = [-15, 15]) translate([x, y, -10]) ";

TEST_F(OpenscadInstances, AChainOfModulesIsCalledByTheOneThatMakesIt) {
  const std::string modules =
      "module base() { cube(20, center = true); translate([0, 0, 10]) children(); }\n"
      "module knob() cylinder(r = 5, h = 5);\n"
      "module box(h) linear_extrude(h) children();\n"
      "module outline() circle(5);\n"
      "module row() for (i = [0:2]) translate([20 * i, 0, 0]) children();\n"
      "module drilled() difference() { children(0); cylinder(r = 1, h = 99, center = true); }\n";
  EXPECT_EQ(items(modules + "base() knob();"), (ItemCounts{{"base", 1}}));
  EXPECT_EQ(items(modules + "base() translate([1, 0, 0]) knob(); translate([50, 0, 0]) knob();"),
            (ItemCounts{{"base", 1}, {"knob", 1}}));
  EXPECT_EQ(items(modules + "box(3) outline(); translate([50, 0, 0]) knob();"),
            (ItemCounts{{"box", 1}, {"knob", 1}}));
  EXPECT_EQ(items(modules + "row() base() knob();"), (ItemCounts{{"base", 3}}));
  EXPECT_EQ(items(modules + "drilled() base() knob(); translate([50, 0, 0]) knob();"),
            (ItemCounts{{"base", 1}, {"knob", 1}}));
  EXPECT_EQ(items(modules + "drilled() knob();"), (ItemCounts{{"knob", 1}}));
}

TEST_F(OpenscadInstances, TurnsWithinTurnsLoseNoCopies) {
  // Each matrix of the tree has six digits; their product strays from a turn by more.
  const std::string bit =
      "module bit() linear_extrude(3, scale = 0.5) square([2, 5]);\n"
      "for (k = [0:11]) translate([60 * k, 0, 0]) rotate([0, 37.377368, 60]) "
      "rotate([0, 37.377368, 72 * k]) rotate([11.1, 3, 23.3]) rotate([10, 79.18, 41.9 + k]) "
      "rotate([0, 37.3, 60]) translate([20, 0, 0]) ";
  EXPECT_EQ(items(bit + "bit();"), (ItemCounts{{"bit", 12}}));
  EXPECT_EQ(items(bit + "scale(1.00003 + 0.00004 * k) bit();").size(), 12U);
}

TEST_F(OpenscadInstances, ALoopMakesAsManyAsItTurns) {
  const ItemCounts right{{"plate", 1}, {"bolt", 6}};
  EXPECT_EQ(items(kBolt + kPlate + "plate();\n" + kEach + "bolt();"), right);
  EXPECT_EQ(items("use <burin.scad>\n" + kBolt + kPlate + "part(\"plate\") plate();\n" + kEach +
                  "part(\"bolt\") bolt();"),
            right);
  const Json parts = Json::parse(slurp(folder_ / "m.json"))["parts"];
  ASSERT_EQ(parts.size(), 7U);
  EXPECT_EQ(parts[6]["name"], "bolt #6");
}

TEST_F(OpenscadInstances, ModulesThatPlaceOthersAreSeenThrough) {
  const ItemCounts right{{"plate", 1}, {"bolt", 6}};
  // A module of calls alone, one that loops over others, and one that places its children.
  EXPECT_EQ(items(kBolt + kPlate + "module all() { plate(); " + kEach + "bolt(); }\nall();"),
            right);
  EXPECT_EQ(items(kBolt + kPlate + "module bolts() { " + kEach + "bolt(); }\nplate(); bolts();"),
            right);
  EXPECT_EQ(items(kBolt + kPlate + "module spots() { " + kEach +
                  "children(); }\nplate(); spots() bolt();"),
            right);
  folder_.write("places.scad", "module spots() { " + kEach + "children(); }");
  EXPECT_EQ(items("use <places.scad>\n" + kBolt + kPlate + "plate(); spots() bolt();"), right);
  EXPECT_EQ(
      items("include <places.scad>\n" + kBolt + kPlate + "plate(); if (true) { spots() bolt(); }"),
      right);
}

TEST_F(OpenscadInstances, OfSeveralColoursAreOneThingEach) {
  const std::string motor =
      "module motor() { color(\"silver\") cylinder(d = 20, h = 30, $fn = 48); color(\"gold\") "
      "translate([0, 0, 30]) cylinder(d = 4, h = 12, $fn = 24); }\n";
  const std::string loop = "for (x = [0, 30, 60]) translate([x, 0, 0]) ";
  const ItemCounts three{{"motor", 3}};
  EXPECT_EQ(items(motor + loop + "motor();"), three);
  EXPECT_EQ(items(motor + "motor(); translate([30, 0, 0]) motor(); translate([60, 0, 0]) motor();"),
            three);
  EXPECT_EQ(items("use <burin.scad>\n" + motor + loop + "part(\"motor\") motor();"), three);
  const Json item = Json::parse(slurp(folder_ / "m.json"))["items"][0];
  EXPECT_EQ(item["parts"].size(), 6U);
  EXPECT_EQ(item["selectors"][5], "/motor #3");
  // Its path means all of it.
  ASSERT_EQ(run("draw @/m.scad -o @/m.json --no-progress --hide /motor --parts-list @/m.csv"), 0)
      << err_;
  EXPECT_NE(slurp(folder_ / "m.csv").find("1,motor,2,,"), std::string::npos);
  EXPECT_NE(slurp(folder_ / "m.csv").find("/motor #2;/motor #3\r\n"), std::string::npos);
  // Shafts that stand elsewhere make another motor.
  EXPECT_EQ(items("module motor(x) { color(\"silver\") cylinder(d = 20, h = 30, $fn = 48); "
                  "color(\"gold\") translate([x, 0, 30]) cylinder(d = 4, h = 12, $fn = 24); }\n"
                  "motor(0); translate([30, 0, 0]) motor(5); translate([60, 0, 0]) rotate(70) "
                  "motor(5);"),
            (ItemCounts{{"motor", 1}, {"motor (2)", 2}}));
  // A program of one call is what that holds.
  EXPECT_EQ(items(motor + "motor();"), (ItemCounts{{"motor", 1}, {"motor (2)", 1}}));
}

TEST_F(OpenscadInstances, AreFoundWhateverIsSaidOfThem) {
  const std::string use = "use <burin.scad>\n";
  const std::string row = "for (x = [0, 30, 60]) translate([x, 0, 0]) ";
  const ItemCounts three{{"bolt", 3}};
  EXPECT_EQ(items(use + kBolt + "ink(\"engraving\") " + row + "bolt();"), three);
  EXPECT_EQ(items(use + kBolt + "explode([0, 0, 20]) " + row + "bolt();"), three);
  EXPECT_EQ(items(kBolt + row + "if (x == 30) #bolt(); else bolt();"), three);
  EXPECT_EQ(items(kBolt + row + "if (x == 30) %bolt(); else bolt();"), (ItemCounts{{"bolt", 2}}));
  EXPECT_EQ(items(kBolt + "#bolt(); translate([30, 0, 0]) bolt();"), (ItemCounts{{"bolt", 2}}));
  // Beside what part() names, too.
  EXPECT_EQ(items(use + kBolt + kPlate + "module all() { part(\"base\") plate(); " + kEach +
                  "bolt(); }\nall();"),
            (ItemCounts{{"base", 1}, {"bolt", 6}}));
}

TEST_F(OpenscadInstances, HaveTheNumberThatALoopGivesThem) {
  const Json drawn = drawing("use <burin.scad>\n" + kBolt + kPlate + kEach +
                             "callout(3) part(\"bolt\") bolt();\ncallout(1) plate();");
  std::map<int, std::string> numbers;
  for (const Json& item : drawn["items"]) numbers[item["number"]] = item["name"];
  EXPECT_EQ(numbers, (std::map<int, std::string>{{1, "plate"}, {3, "bolt"}}));
  // Two items of one name have a number each.
  const Json two = drawing("use <burin.scad>\n" + kBolt +
                           "callout(5) bolt(4);\ncallout(2) "
                           "translate([30, 0, 0]) bolt(6);");
  numbers.clear();
  for (const Json& item : two["items"]) numbers[item["number"]] = item["name"];
  EXPECT_EQ(numbers, (std::map<int, std::string>{{2, "bolt (2)"}, {5, "bolt"}}));
}

TEST_F(OpenscadInstances, WhatIsFlatBesideSolidsIsTold) {
  drawing("cube([50, 20, 5]); translate([3, 3, 5]) text(\"Hello\");");
  EXPECT_NE(err_.find("warning: m.scad: 2-D objects beside solids are left out; extrude them"),
            std::string::npos)
      << err_;
}

TEST_F(OpenscadInstances, ArgumentsThatMakeOtherShapesMakeOtherItems) {
  EXPECT_EQ(items(kBolt + "for (i = [0:3]) translate([20 * i, 0, 0]) bolt(i < 2 ? 6 : 4);"),
            (ItemCounts{{"bolt", 2}, {"bolt (2)", 2}}));
  EXPECT_EQ(items(kBolt + "module nut() cylinder(d = 11, h = 5, $fn = 6);\nfor (i = [0:4]) "
                          "translate([20 * i, 0, 0]) if (i < 2) bolt(); else nut();"),
            (ItemCounts{{"bolt", 2}, {"nut", 3}}));
}

TEST_F(OpenscadInstances, BlocksOfCallsAreSeveralThings) {
  EXPECT_EQ(items(kBolt + "module washer() cylinder(d = 12, h = 1, $fn = 32);\nfor (x = [0, 30]) "
                          "translate([x, 0, 0]) { bolt(); translate([0, 0, 26]) washer(); }"),
            (ItemCounts{{"bolt", 2}, {"washer", 2}}));
}

TEST_F(OpenscadInstances, WhatIsOneBodyStaysOnePart) {
  const auto one = [&](const std::string& model) {
    const Json parts = drawing(model)["parts"];
    EXPECT_EQ(parts.size(), 1U) << model << parts;
    return parts.empty() ? std::string() : parts[0]["name"].get<std::string>();
  };
  // Features that touch within a module, teeth that run into each other, what is united by name,
  // what stands beside solids of no module, what calls itself.
  EXPECT_EQ(one("module shaft() cylinder(d = 4, h = 9); module head() translate([0, 0, 9]) cube(6, "
                "center = true);\nmodule pin() { shaft(); head(); }\npin();"),
            "pin");
  EXPECT_NE(err_.find("2 calls of head, shaft stay one part: they touch"), std::string::npos)
      << err_;
  EXPECT_EQ(one("module tooth() translate([0, -1, 0]) cube([12, 2, 4]);\nfor (a = [0:30:359]) "
                "rotate(a) tooth();"),
            "tooth");
  one("module a() cube(3); union() { a(); translate([9, 0, 0]) a(); }");
  EXPECT_EQ(one("module leg() cube([2, 2, 9]); module table() { translate([0, 0, 9]) cube([20, 20, "
                "1]); for (x = [0, 18]) translate([x, 0, 0]) leg(); }\ntable();"),
            "table");
  EXPECT_EQ(
      one("module dust(n) if (n == 0) cube(1); else for (x = [0, 2]) translate([x * pow(3, n), "
          "0, 0]) dust(n - 1);\ndust(3);"),
      "dust");
}

TEST_F(OpenscadInstances, OfSeveralSolidsAreOneItemWhicheverWayTheyAreTurned) {
  const std::string block = "module block() { cube(4); translate([1, 1, 4]) cube(2); }\n";
  const std::string turned = "translate([40 * i, 0, 0]) rotate([7 * i, 3 * i, 11 * i]) ";
  EXPECT_EQ(items(block + "for (i = [0:20]) " + turned + "block();"), (ItemCounts{{"block", 21}}));
  EXPECT_EQ(items(block + "for (i = [0:20]) " + turned + "scale(2.5) block();"),
            (ItemCounts{{"block", 21}}));
}

// for (a = [0:60:360]) ends where it began.
TEST_F(OpenscadInstances, WhatStandsTwiceInOnePlaceCountsOnce) {
  const std::string pin = "module pin() cylinder(d = 3, h = 9);\n";
  EXPECT_EQ(items(pin + "for (a = [0:60:360]) rotate(a) translate([20, 0, 0]) pin();"),
            (ItemCounts{{"pin", 6}}));
  EXPECT_NE(err_.find("warning: m.scad: a call of pin left out: an equal one is in the same place"),
            std::string::npos)
      << err_;
  EXPECT_EQ(items(pin + "pin(); pin(); pin(); translate([9, 0, 0]) pin();"),
            (ItemCounts{{"pin", 2}}));
  EXPECT_NE(err_.find("2 calls of pin left out"), std::string::npos) << err_;
  EXPECT_EQ(items(pin + "color(\"red\") pin(); color(\"blue\") pin();"), (ItemCounts{{"pin", 2}}));
  EXPECT_EQ(err_.find("left out"), std::string::npos) << err_;
}

TEST_F(OpenscadInstances, MoreThanAListHoldsStayOnePart) {
  const Json parts = drawing(
      "module grain() cube(1);\nfor (x = [0:33], y = [0:33]) translate([2 * x, 2 * y, 0]) "
      "grain();")["parts"];
  EXPECT_EQ(parts.size(), 1U);
  EXPECT_NE(err_.find("1156 calls of grain stay one part"), std::string::npos) << err_;
}

TEST_F(OpenscadInstances, WhatIsHighlightedOrAsideAndNothingIsNoPart) {
  EXPECT_EQ(
      drawing("difference() { cube([20, 14, 8]); #translate([2, 2, 8]) cylinder(d = 6, h = 0); "
              "}\ntranslate([30, 0, 0]) cube([10, 14, 8]);")["parts"]
          .size(),
      2U);
  EXPECT_EQ(drawing("%cube(0); #sphere(0); *cube(9); cube(3);")["parts"].size(), 1U);
}

TEST_F(OpenscadInstances, AlphaLetsThroughWhatIsBehind) {
  const auto inner = [&](const std::string& alpha) {
    // What is drawn of the orange box, which stands in the blue one below the lid.
    const Json all = drawing(
        "color(\"SteelBlue\") difference() { cube([40, 30, 20]); translate([2, 2, 2]) cube([36, "
        "26, "
        "20]); }\ncolor(\"Orange\") translate([12, 10, 2]) cube([16, 10, 10]);\n"
        "color([0.8, 0.9, 1, " +
        alpha + "]) translate([0, 0, 20]) cube([40, 30, 2]);");
    int paths = 0;
    for (const Json& layer : all["layers"]) {
      for (const Json& path : layer.value("paths", Json::array())) {
        paths += path.value("part", -1) == 1 && path.value("visible", false) ? 1 : 0;
      }
    }
    return paths;
  };
  EXPECT_GT(inner("0.25"), 0);
  EXPECT_EQ(inner("1"), 0);
}

TEST_F(OpenscadInstances, MirroredOnesAreItemsOfTheirOwn) {
  const std::string model =
      "module bracket() { cube([20, 4, 12]); cube([4, 16, 12]); translate([14, -3, 6]) "
      "rotate([-90, 0, "
      "0]) cylinder(d = 5, h = 3, $fn = 24); }\nmodule left() bracket();\nmodule right() "
      "mirror([1, "
      "0, 0]) bracket();\ntranslate([30, 0, 0]) left();\ntranslate([-30, 0, 0]) right();\n"
      "translate([30, 40, 0]) rotate([0, 0, 180]) mirror([1, 0, 0]) mirror([1, 0, 0]) left();\n"
      "translate([-30, 40, 0]) rotate([0, 0, 180]) right();";
  EXPECT_EQ(items(model), (ItemCounts{{"left", 2}, {"right", 2}}));
}

TEST_F(OpenscadInstances, WhateverMovesThemTheVolumeStays) {
  const double one = 3 * 4 * 5;
  EXPECT_NEAR(volume("mirror([1, 0, 0]) cube([3, 4, 5]); mirror([1, 1, 0]) rotate(20) "
                     "translate([9, 0, 0]) cube([3, 4, 5]);"),
              2 * one, 1e-4);
  EXPECT_NEAR(volume("scale([2, 1, 0.5]) cube([3, 4, 5]); resize([6, 0, 0]) translate([20, 0, 0]) "
                     "cube([3, 4, 5]);"),
              3 * one, 1e-6);
  EXPECT_NEAR(volume("multmatrix([[1, 0.5, 0, 0], [0, 1, 0, 0], [0, 0.25, 1, 0], [0, 0, 0, 1]]) "
                     "cube([3, 4, 5]);"),
              one, 1e-6);
}

TEST_F(OpenscadInstances, WarningsOfAMarkedProgramNameItsFileAndLine) {
  folder_.write("m.scad", kBolt + "\nbolt();\nnothing_of_that_name();\n");
  EXPECT_EQ(run("draw @/m.scad -o @/m.json --style outline --no-progress"), 0) << err_;
  EXPECT_NE(err_.find("m.scad:4"), std::string::npos) << err_;
  EXPECT_EQ(err_.find("stdin"), std::string::npos) << err_;
  folder_.write("m.scad", kBolt + "bolt(;\n");
  EXPECT_EQ(run("draw @/m.scad -o @/m.json --style outline --no-progress"), 3);
  EXPECT_NE(err_.find("m.scad:2"), std::string::npos) << err_;
}

}  // namespace
}  // namespace burin::test
