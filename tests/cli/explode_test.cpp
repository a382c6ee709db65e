// Exploded views, from the command line and from illustration files.
#include "models.h"

#include <burin_test/turned.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <string>

namespace burin {
namespace {

using Json = nlohmann::json;

class Exploded : public test::CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    folder_.write("plate.off",
                  test::off_text(test::turned({{5, 0}, {30, 0}, {30, 10}, {5, 10}}, 48, true)));
    folder_.write("bolt.off",
                  test::off_text(test::turned({{5, 0}, {5, 10}, {9, 10}, {9, 16}}, 48)));
  }
  /// Draws the plate and the bolt with more members.
  int draw(const std::string& members, const std::string& options = "") {
    folder_.write("a.burin.json",
                  "{\"burin\": \"illustration\",\n\"parts\": [{\"file\": \"plate.off\"}, "
                  "{\"file\": \"bolt.off\"}], \"style\": \"outline\",\n" +
                      members + "}");
    return run("draw @/a.burin.json -o @/a.json " + options);
  }
  Json drawing() { return Json::parse(test::slurp(folder_ / "a.json")); }
  static const Json* layer(const Json& drawing, const std::string& name) {
    for (const Json& l : drawing.at("layers")) {
      if (l.at("name") == name) return &l;
    }
    return nullptr;
  }
  /// The highest point of a part in model mm.
  static double top_of(const Json& drawing, int part) {
    double top = -1e9;
    for (const Json& l : drawing.at("layers")) {
      for (const Json& path : l.at("paths")) {
        if (path.at("part") != part || l.at("name") == "trail") continue;
        for (const Json& p : path.at("points3")) top = std::max(top, p[2].get<double>());
      }
    }
    return top;
  }
};

TEST_F(Exploded, ShowTheWayWithALine) {
  ASSERT_EQ(run("draw @/plate.off @/bolt.off --style outline -o @/a.json --explode auto"), 0)
      << err_;
  EXPECT_EQ(err_, "");
  const Json d = drawing();
  EXPECT_GT(top_of(d, 1), 16 + 10);
  EXPECT_NEAR(top_of(d, 0), 10, 1e-6);
  ASSERT_NE(layer(d, "trail"), nullptr);
  for (const Json& path : layer(d, "trail")->at("paths")) {
    EXPECT_EQ(path.at("kind"), "trail");
    EXPECT_EQ(path.at("width")[0], 0.18);
    for (const Json& p : path.at("points3")) {
      EXPECT_LT(std::hypot(p[0].get<double>(), p[1].get<double>()), 0.05);
    }
  }
  const std::string apart = "draw @/plate.off @/bolt.off --style outline -o @/a.json --explode z ";
  ASSERT_EQ(run(apart + "--set feature.trails=false"), 0) << err_;
  EXPECT_EQ(layer(drawing(), "trail"), nullptr);
  ASSERT_EQ(run(apart + "--set line.trail=0.3 --verify"), 0) << err_;
  EXPECT_EQ(layer(drawing(), "trail")->at("paths")[0].at("width")[0], 0.3);
  EXPECT_EQ(drawing().at("stats").at("verify").at("contradicted"), 0);
  // Together again.
  ASSERT_EQ(run(apart + "--explode-factor 0"), 0) << err_;
  EXPECT_NEAR(top_of(drawing(), 1), 16, 1e-6);
  EXPECT_EQ(layer(drawing(), "trail"), nullptr);
}

TEST_F(Exploded, HaveDashDotLinesInAllFormats) {
  ASSERT_EQ(
      run("draw @/plate.off @/bolt.off --style outline --explode auto -o @/a.svg -o @/a.eps "
          "-o @/a.dxf -o @/a.pdf -o @/a.png -o @/a.json --set line.dash=3 --set line.gap=1.5"),
      0)
      << err_;
  EXPECT_NE(test::slurp(folder_ / "a.svg").find("stroke-dasharray=\"6 1.5 0.01 1.5\""),
            std::string::npos);
  EXPECT_NE(test::slurp(folder_ / "a.eps").find("[6000 1500 10 1500] 0 setdash"),
            std::string::npos);
  const std::string dxf = test::slurp(folder_ / "a.dxf");
  EXPECT_NE(dxf.find("\ntrail\n70\n0\n62\n7\n6\nACAD_ISO10W100\n"), std::string::npos);
  EXPECT_NE(dxf.find("\n73\n4\n40\n9.01\n49\n6.0\n74\n0\n49\n-1.5\n"), std::string::npos);
  // What was drawn can be converted.
  ASSERT_EQ(run("convert @/a.json -o @/b.svg --set line.dash=3 --set line.gap=1.5"), 0) << err_;
  EXPECT_NE(test::slurp(folder_ / "b.svg").find("stroke-dasharray=\"6 1.5 0.01 1.5\""),
            std::string::npos);
}

TEST_F(Exploded, AreWrittenForTheAuthorToEdit) {
  ASSERT_EQ(run("illustrate @/plate.off @/bolt.off -o @/b.burin.json --explode auto "
                "--explode-factor 0.5"),
            0)
      << err_;
  const Json written = Json::parse(test::slurp(folder_ / "b.burin.json"));
  ASSERT_EQ(written["explode"]["steps"].size(), 1U);
  const Json& step = written["explode"]["steps"][0];
  EXPECT_EQ(step["move"], Json({"/bolt"}));
  EXPECT_EQ(step["along"], Json({0.0, 0.0, 1.0}));
  EXPECT_GT(step["by"], 10);
  EXPECT_EQ(step["trail"], true);
  EXPECT_EQ(written["explode"]["factor"], 0.5);
  // The file draws what the command does.
  ASSERT_EQ(run("draw @/b.burin.json -o @/a.json --explode-factor 1 --style outline"), 0) << err_;
  const double from_file = top_of(drawing(), 1);
  ASSERT_EQ(run("draw @/plate.off @/bolt.off --explode auto -o @/a.json --style outline"), 0);
  EXPECT_NEAR(from_file, top_of(drawing(), 1), 1e-3);
}

// Of a large assembly, a step of six digits would end tenths of a millimetre elsewhere.
TEST_F(Exploded, StepsAreWrittenAsFarAsTheyMatter) {
  constexpr double kSize = 1234.5678;
  const auto write = [&](const char* name, std::vector<Vec2> outline, bool closed) {
    for (Vec2& p : outline) p *= kSize;
    folder_.write(name, test::off_text(test::turned(outline, 48, closed)));
  };
  write("plate.off", {{5, 0}, {30, 0}, {30, 10}, {5, 10}}, true);
  write("bolt.off", {{5, 0}, {5, 10}, {9, 10}, {9, 16}}, false);
  ASSERT_EQ(run("illustrate @/plate.off @/bolt.off -o @/b.burin.json --explode auto"), 0) << err_;
  ASSERT_EQ(run("draw @/b.burin.json -o @/a.json --style outline"), 0) << err_;
  const double from_file = top_of(drawing(), 1);
  ASSERT_EQ(run("draw @/plate.off @/bolt.off --explode auto -o @/a.json --style outline"), 0);
  EXPECT_NEAR(from_file, top_of(drawing(), 1), 1e-3);
}

// Where an illustration says which parts there are, another one extends it.
TEST_F(Exploded, ExtendAnIllustration) {
  ASSERT_EQ(draw(R"("hidden": "none")"), 0) << err_;
  ASSERT_EQ(run("illustrate @/a.burin.json -o @/b.burin.json --explode auto"), 0) << err_;
  const Json written = Json::parse(test::slurp(folder_ / "b.burin.json"));
  EXPECT_EQ(written["extends"], "a.burin.json");
  EXPECT_EQ(written["explode"]["steps"].size(), 1U);
  ASSERT_EQ(run("draw @/b.burin.json -o @/a.json"), 0) << err_;
  EXPECT_GT(top_of(drawing(), 1), 26);
  EXPECT_EQ(run("illustrate @/a.burin.json -o @/c.burin.json"), 2);
  expect_error("is an illustration file already");
  EXPECT_EQ(run("illustrate @/a.burin.json @/box.off -o @/c.burin.json --explode auto"), 2);
  expect_error("is an illustration file already");
  EXPECT_EQ(run("illustrate @/a.burin.json -o @/c.burin.json --explode auto --seed 2"), 2);
  expect_error("option --seed is for a first file");
}

TEST_F(Exploded, FollowTheStepsOfTheFile) {
  const std::string steps =
      R"("explode": {"steps": [{"move": "bolt", "along": [0, 0, 2], "by": 40}], "factor": 0.5})";
  ASSERT_EQ(draw(steps), 0) << err_;
  EXPECT_NEAR(top_of(drawing(), 1), 16 + 20, 1e-6);
  ASSERT_EQ(draw(steps, "--explode-factor 1"), 0) << err_;
  EXPECT_NEAR(top_of(drawing(), 1), 16 + 40, 1e-6);
  ASSERT_EQ(draw(steps, "--explode none"), 0) << err_;
  EXPECT_NEAR(top_of(drawing(), 1), 16, 1e-6);
  // By words, with the part that stays.
  ASSERT_EQ(draw(R"("explode": "auto")"), 0) << err_;
  EXPECT_GT(top_of(drawing(), 1), 26);
  ASSERT_EQ(draw(R"("explode": {"along": "z", "base": "bolt"})"), 0) << err_;
  EXPECT_NEAR(top_of(drawing(), 1), 16, 1e-6);
  EXPECT_LT(top_of(drawing(), 0), 0);
  // The halves of a section stay one.
  ASSERT_EQ(draw(R"("explode": "auto", "section": "y")"), 0) << err_;
  EXPECT_GT(top_of(drawing(), 1), 26);
  EXPECT_NE(layer(drawing(), "pattern"), nullptr);
}

TEST_F(Exploded, ThatAskForNonsenseAreOneLine) {
  const auto step = [](const std::string& members) {
    return "\"explode\": {\"steps\": [\n{" + members + "}]}";
  };
  const struct {
    std::string members, says;
  } bad[] = {
      {step(R"("move": "nut", "along": [0,0,1], "by": 3)"), ":4: no part is named 'nut'"},
      {step(R"("move": [], "along": [0,0,1], "by": 3)"), ":4: \"move\" names no parts"},
      {step(R"("move": "bolt", "along": [0,0,0], "by": 3)"), ":4: \"along\" takes a direction"},
      {step(R"("move": "bolt", "along": "up", "by": 3)"), ":4: \"along\" takes [x, y, z]"},
      {step(R"("move": "bolt", "along": [0,0,1], "by": 0)"), ":4: \"by\" takes mm over 0, not 0"},
      {step(R"("move": "bolt", "along": [0,0,1], "by": -3)"), ":4: \"by\" takes mm over 0"},
      {step(R"("move": "bolt", "along": [0,0,1], "by": "3")"), ":4: \"by\" takes a number"},
      {step(R"("move": "bolt", "along": [0,0,1])"), "\"by\" is missing"},
      {step(R"("move": "bolt", "along": [0,0,1], "by": 3, "trail": 1)"), "true or false"},
      {step(R"("move": "bolt", "along": [0,0,1], "by": 3, "way": 1)"), "unknown key 'way'"},
      {R"("explode": {"steps": []})", "\"steps\" has none"},
      {R"("explode": {"steps": 3})", "\"steps\" takes a list"},
      {R"("explode": {"factor": 11})", "\"factor\" takes 0 to 10, not 11"},
      {R"("explode": {"fit": -1})", "\"fit\" takes mm from 0, not -1"},
      {R"("explode": {"base": "nut"})", ":3: no part is named 'nut'"},
      {R"("explode": {"along": "w"})", "\"along\" takes auto, none"},
      {R"("explode": "w")", "\"explode\" takes auto, none"},
      {R"("explode": 3)", "\"explode\" takes text"},
  };
  for (const auto& one : bad) {
    EXPECT_EQ(draw(one.members), 2) << one.members;
    expect_error(one.says);
  }
  for (const char* way : {"w", "x=3", "0,0,0", "1,2", "-"}) {
    EXPECT_EQ(run(std::string("draw @/bolt.off @/plate.off -o @/a.json --explode=") + way), 2);
    expect_error("option --explode takes auto, none");
  }
  for (const char* factor : {"-1", "11", "nan", "a"}) {
    EXPECT_EQ(run(std::string("draw @/bolt.off -o @/a.json --explode-factor=") + factor), 2);
    expect_error("option --explode-factor takes 0 to 10");
  }
}

TEST_F(Exploded, ThatMoveNothingSaySo) {
  ASSERT_EQ(draw(R"("explode": {"steps": [{"move": "*", "along": [0,0,1], "by": 3}]})"), 0);
  EXPECT_NE(err_.find("a step moves all parts that are drawn"), std::string::npos) << err_;
  ASSERT_EQ(
      draw(R"("explode": {"steps": [{"move": "bolt", "along": [0,0,1], "by": 3}]})", "--hide bolt"),
      0);
  EXPECT_NE(err_.find("a step moves no part that is drawn"), std::string::npos) << err_;
  ASSERT_EQ(run("draw @/box.off -o @/a.json --explode auto"), 0);
  EXPECT_NE(err_.find("there is one part; nothing comes apart"), std::string::npos) << err_;
  ASSERT_EQ(run("draw @/box.off -o @/a.json --explode-factor 0.5"), 0);
  EXPECT_NE(err_.find("--explode-factor has no effect"), std::string::npos) << err_;
  folder_.write("ring.off", test::off_text(test::torus(10, 2, 48, 24)));
  folder_.write("b.burin.json", R"({"burin": "illustration", "explode": "auto", "parts": [
    {"file": "ring.off", "name": "left"},
    {"file": "ring.off", "name": "right", "place": {"rotate": [90, 0, 0], "translate": [10, 0, 0]}}]})");
  ASSERT_EQ(run("draw @/b.burin.json -o @/a.json"), 0);
  EXPECT_NE(err_.find("'left', 'right' hold each other"), std::string::npos) << err_;
}

/// A thick plate with nuts below it: none of them is seen from above.
class ExplodedBelow : public Exploded {
 protected:
  void SetUp() override {
    Exploded::SetUp();
    folder_.write("deck.off", test::off_text(test::box({-60, -60, 0}, {60, 60, 40})));
    for (const int i : {0, 1, 2, 3}) {
      const double x = i % 2 == 0 ? -20 : 20, y = i < 2 ? -20 : 20;
      folder_.write("nut" + std::to_string(i) + ".off",
                    test::off_text(test::box({x - 5, y - 5, -8}, {x + 5, y + 5, 0})));
      parts_ += " @/nut" + std::to_string(i) + ".off";
    }
  }
  Json view_of(const std::string& options) {
    EXPECT_EQ(run("draw" + parts_ + " --style outline -o @/a.json " + options), 0) << err_;
    EXPECT_EQ(err_, "");
    return drawing().at("view").at("direction");
  }
  std::string parts_ = " @/deck.off";
};

TEST_F(ExplodedBelow, AreSeenFromWhereMostPartsAre) {
  const Json view = view_of("--explode auto");
  EXPECT_LT(view[2].get<double>(), 0);
  EXPECT_GT(view[0].get<double>(), 0);  // the nearest corner of iso
  EXPECT_LT(view[1].get<double>(), 0);
  const Json d = drawing();
  const auto& told = d.at("diagnostics");
  const auto chosen =
      std::ranges::find_if(told, [](const Json& one) { return one.at("code") == "explode.view"; });
  ASSERT_NE(chosen, told.end()) << told;
  EXPECT_NE(chosen->at("message").get<std::string>().find("1,-1,-1: 5 of 5 parts are seen"),
            std::string::npos)
      << *chosen;
  std::set<int> seen;
  for (const Json& l : d.at("layers")) {
    for (const Json& path : l.at("paths")) seen.insert(path.at("part").get<int>());
  }
  EXPECT_EQ(seen.size(), 5U);
  // The same for any number of threads.
  const std::string bytes = test::slurp(folder_ / "a.json");
  view_of("--explode auto --threads 1");
  EXPECT_EQ(test::slurp(folder_ / "a.json"), bytes);
}

TEST_F(ExplodedBelow, AreSeenAsTheUserSays) {
  EXPECT_GT(view_of("--explode auto --view iso")[2].get<double>(), 0);
  EXPECT_EQ(view_of("--explode auto --view front")[2].get<double>(), 0);
  EXPECT_GT(view_of("")[2].get<double>(), 0);
  folder_.write("v.burin.json",
                R"({"burin": "illustration", "parts": [{"file": "deck.off"}, {"file": "nut0.off"}],
                    "style": "outline", "view": {"from": "iso"}, "explode": "auto"})");
  ASSERT_EQ(run("draw @/v.burin.json -o @/a.json"), 0) << err_;
  EXPECT_GT(drawing().at("view").at("direction")[2].get<double>(), 0);
}

// Where all parts are seen from iso it stays.
TEST_F(Exploded, KeepTheUsualViewWhereItShowsAll) {
  ASSERT_EQ(run("draw @/plate.off @/bolt.off --style outline -o @/a.json --explode auto"), 0);
  const Json view = drawing().at("view").at("direction");
  EXPECT_NEAR(view[0].get<double>(), std::sqrt(1.0 / 3), 1e-12);
  EXPECT_NEAR(view[2].get<double>(), std::sqrt(1.0 / 3), 1e-12);
  EXPECT_TRUE(drawing().at("diagnostics").empty()) << drawing().at("diagnostics");
}

}  // namespace
}  // namespace burin
