// Parts cut open, from the command line and from illustration files.
#include "models.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace burin {
namespace {

using Json = nlohmann::json;

class Sections : public test::CliTest {
 protected:
  Json drawing() { return Json::parse(test::slurp(folder_ / "a.json")); }

  std::size_t paths_of(const Json& drawing, const std::string& layer) {
    for (const Json& l : drawing.at("layers")) {
      if (l.at("name") == layer) return l.at("paths").size();
    }
    return 0;
  }
};

TEST_F(Sections, AreHatchedAndOutlined) {
  ASSERT_EQ(run("draw @/box.off --section y --style outline -o @/a.json"), 0) << err_;
  const Json d = drawing();
  EXPECT_GT(paths_of(d, "pattern"), 3U);
  EXPECT_GT(paths_of(d, "section"), 0U);
  // The half towards the viewer goes, from either side.
  ASSERT_EQ(run("draw @/box.off --section y --view back --style outline -o @/a.json"), 0) << err_;
  EXPECT_GT(paths_of(drawing(), "pattern"), 3U);
  ASSERT_EQ(run("draw @/box.off --section +y --view front --style outline -o @/a.json"), 0);
  EXPECT_EQ(paths_of(drawing(), "pattern"), 0U);
}

TEST_F(Sections, ThatCutNothingSaySo) {
  ASSERT_EQ(run("draw @/box.off --section -y=-1e3 -o @/a.json"), 0) << err_;
  EXPECT_NE(err_.find("cuts nothing"), std::string::npos) << err_;
  ASSERT_EQ(run("draw @/box.off --section +y=-1e3 -o @/a.json"), 2);
  EXPECT_NE(err_.find("takes all of it away"), std::string::npos) << err_;
  EXPECT_EQ(std::ranges::count(err_, '\n'), 1) << err_;
}

TEST_F(Sections, OneAfterTheOtherHaveTheirWholeOutlineWhereOneIsSeenFromItsEdge) {
  for (const char* order : {"--section z=5 --section y=12", "--section y=12 --section z=5"}) {
    ASSERT_EQ(run(std::string("draw @/box.off --view front --style outline --verify -o @/a.json ") +
                  order),
              0)
        << err_;
    EXPECT_NE(err_.find("verify: 0.0 of"), std::string::npos) << order << err_;
    double length = 0;
    const Json d = drawing();
    for (const Json& l : d.at("layers")) {
      if (l.at("name") != "outline") continue;
      for (const Json& path : l.at("paths")) {
        const Json& p = path.at("points3");
        for (std::size_t i = 1; i < p.size(); ++i) {
          length += std::hypot(p[i][0].get<double>() - p[i - 1][0].get<double>(),
                               p[i][2].get<double>() - p[i - 1][2].get<double>());
        }
        if (path.at("closed")) {
          length += std::hypot(p[0][0].get<double>() - p.back()[0].get<double>(),
                               p[0][2].get<double>() - p.back()[2].get<double>());
        }
      }
    }
    EXPECT_NEAR(length, 2 * (40 + 5), 1e-3) << order;
  }
  // Steps of one section lie in one plane as they are seen: no line where they change.
  ASSERT_EQ(run("draw @/box.off --view front --section y=5,x=20,y=9 --style outline --verify -o "
                "@/a.json"),
            0);
  const Json d = drawing();
  for (const Json& l : d.at("layers")) {
    if (l.at("name") == "pattern") continue;
    for (const Json& path : l.at("paths")) {
      const Json& p = path.at("points3");
      for (std::size_t i = 1; i < p.size(); ++i) {
        const bool along = p[i - 1][0].get<double>() == 20 && p[i][0].get<double>() == 20;
        EXPECT_FALSE(along) << l.at("name");
      }
    }
  }
}

TEST_F(Sections, HaveViewsOfTheirOwn) {
  ASSERT_EQ(run("draw @/box.off --paper A5 --views front,top --section-view y=1 --section-view x "
                "--style outline "
                "--verify -o @/a.json"),
            0)
      << err_;
  const auto names = [&] {
    const Json d = drawing();
    std::vector<std::string> names;
    for (const Json& view : d.at("views")) names.push_back(view.at("name"));
    return names;
  };
  EXPECT_EQ(names(), (std::vector<std::string>{"front", "top", "A-A", "B-B"}));
  EXPECT_NE(err_.find("verify: 0.0 of"), std::string::npos) << err_;
  EXPECT_EQ(paths_of(drawing(), "section-plane"), 2U);
  EXPECT_GT(paths_of(drawing(), "pattern"), 3U);
  std::map<std::string, int> texts;
  const Json d = drawing();
  for (const Json& l : d.at("layers")) {
    if (l.at("name") != "section-marks") continue;
    for (const Json& text : l.at("texts")) ++texts[text.at("text")];
  }
  EXPECT_EQ(texts, (std::map<std::string, int>{{"A", 2}, {"A-A", 1}, {"B", 2}, {"B-B", 1}}));
  // A file of it says the same.
  ASSERT_EQ(run("illustrate @/box.off --paper A5 --section-view y=1 --section-view x --views "
                "front,top --style "
                "outline -o @/i.burin.json"),
            0)
      << err_;
  const std::string once = test::slurp(folder_ / "a.json");
  ASSERT_EQ(run("draw @/i.burin.json -o @/a.json"), 0) << err_;
  EXPECT_EQ(names(), (std::vector<std::string>{"front", "top", "A-A", "B-B"}));
  EXPECT_EQ(Json::parse(once).at("layers"), drawing().at("layers"));
}

TEST_F(Sections, WithViewsOfTheirOwnSayWhatIsWrong) {
  for (const char* bad : {"quarter", "w", "x,y", "y=1,x=2", ""}) {
    ASSERT_EQ(run(std::string("draw @/box.off -o @/a.json --section-view=") + bad), 2) << bad;
    EXPECT_NE(err_.find("--section-view"), std::string::npos) << err_;
    EXPECT_EQ(std::ranges::count(err_, '\n'), 1) << err_;
  }
  ASSERT_EQ(run("draw @/box.off --section-view y --paper fit -o @/a.json"), 2);
  EXPECT_NE(err_.find("fixed size"), std::string::npos) << err_;
  ASSERT_EQ(run("draw @/box.off --section-view y --perspective 30 -o @/a.json"), 2);
  EXPECT_NE(err_.find("--perspective"), std::string::npos) << err_;
  folder_.write("a.burin.json",
                R"({"burin": "illustration", "version": 1, "parts": [{"file": "box.off"}],
    "section": [{"box": [[0, 0, 0], [1, 1, 1]], "view": true}]})");
  ASSERT_EQ(run("draw @/a.burin.json -o @/a.json"), 2) << err_;
  EXPECT_NE(err_.find("one plane or in steps"), std::string::npos) << err_;
}

TEST_F(Sections, OfBadValuesAreOneLine) {
  for (const char* bad : {"w", "", "x=", "x=a", "0,0,0", "1,2", "xy", "x=nan", "--"}) {
    ASSERT_EQ(run(std::string("draw @/box.off -o @/a.json --section=") + bad), 2) << bad;
    EXPECT_NE(err_.find("--section"), std::string::npos) << err_;
    EXPECT_EQ(std::ranges::count(err_, '\n'), 1) << err_;
  }
}

TEST_F(Sections, LeaveNamedPartsWhole) {
  const std::string both = R"(, "parts": [{"file": "box.off", "name": "a"},
    {"file": "box.off", "name": "b", "place": {"translate": [200, 0, 0]}}], "style": "outline"})";
  const auto draw = [&](const std::string& section) {
    folder_.write("a.burin.json", "{\"burin\": \"illustration\", \"section\": " + section + both);
    return run("draw @/a.burin.json -o @/a.json");
  };
  ASSERT_EQ(draw(R"("y")"), 0) << err_;
  const std::size_t all = paths_of(drawing(), "pattern");
  ASSERT_EQ(draw(R"([{"plane": "y", "exclude": ["b"]}])"), 0) << err_;
  EXPECT_LT(paths_of(drawing(), "pattern"), all);
  const Json cut = drawing();
  for (const Json& layer : cut.at("layers")) {
    if (layer.at("name") != "pattern") continue;
    for (const Json& path : layer.at("paths")) EXPECT_EQ(path.at("part"), 0);
  }
  ASSERT_EQ(run("draw @/a.burin.json --section-exclude a -o @/b.svg"), 0) << err_;
  ASSERT_EQ(draw(R"({"plane": {"normal": [0, -1, 0], "offset": -5}, "exclude": "a"})"), 0) << err_;
  ASSERT_EQ(draw(R"({"plane": {"normal": [0, 0, 0]}})"), 2);
  EXPECT_NE(err_.find("a.burin.json:1:"), std::string::npos) << err_;
  ASSERT_EQ(draw(R"({"plane": "q"})"), 2);
  ASSERT_EQ(draw(R"({"exclude": "a"})"), 2);
  ASSERT_EQ(draw(R"({"plane": "y", "exclude": "nobody"})"), 2);
  EXPECT_NE(err_.find("nobody"), std::string::npos) << err_;
}

TEST_F(Sections, StandInAFirstIllustration) {
  ASSERT_EQ(run("illustrate @/box.off --section -x=3 --section z --section-exclude box "
                "-o @/a.burin.json"),
            0)
      << err_;
  const Json file = Json::parse(test::slurp(folder_ / "a.burin.json"));
  ASSERT_EQ(file.at("section").size(), 2U);
  EXPECT_EQ(file.at("section")[0].at("plane"), "-x=3");
  EXPECT_EQ(file.at("section")[0].at("exclude"), Json({"box"}));
  EXPECT_EQ(run("draw @/a.burin.json -o @/a.svg"), 0) << err_;
}

/// Model mm that the lines of a layer reach from and to along an axis.
std::pair<double, double> reach(const Json& drawing, const std::string& layer, std::size_t axis) {
  std::pair<double, double> out{1e300, -1e300};
  for (const Json& l : drawing.at("layers")) {
    if (l.at("name") != layer) continue;
    for (const Json& path : l.at("paths")) {
      for (const Json& p : path.at("points3")) {
        const double x = p.at(axis);
        out = {std::min(out.first, x), std::max(out.second, x)};
      }
    }
  }
  return out;
}

TEST_F(Sections, OfSeveralPlanesTakeAQuarterStepsOrABox) {
  folder_.write("a.off", test::off_text(test::box({-10, -10, -10}, {10, 10, 10})));
  const auto draw = [&](const std::string& section) {
    EXPECT_EQ(run("draw @/a.off --style outline " + section + " -o @/a.json"), 0) << err_;
    return drawing();
  };
  // Towards the viewer is x > 0, y < 0, z > 0.
  const Json quarter = draw("--section quarter");
  EXPECT_NEAR(reach(quarter, "pattern", 0).first, 0, 1e-6);
  EXPECT_NEAR(reach(quarter, "pattern", 0).second, 10, 1e-6);
  EXPECT_NEAR(reach(quarter, "pattern", 1).first, -10, 1e-6);
  EXPECT_NEAR(reach(quarter, "pattern", 1).second, 0, 1e-6);
  EXPECT_EQ(draw("--section x,y").at("layers"), quarter.at("layers"));
  const Json other = draw("--section x=4,+y=-3");
  EXPECT_NEAR(reach(other, "pattern", 0).first, 4, 1e-6);
  // At y = -6 until x = 2, then at y = 5.
  const Json steps = draw("--section y=-6,x=2,y=5");
  EXPECT_NEAR(reach(steps, "pattern", 1).first, -6, 1e-6);
  EXPECT_NEAR(reach(steps, "pattern", 1).second, 5, 1e-6);
  // Seen along the cuts they are as one: no line where one goes over into the other.
  const auto along = [](const Json& drawing, double x) {
    std::size_t lines = 0;
    for (const Json& layer : drawing.at("layers")) {
      for (const Json& path : layer.at("paths")) {
        lines += std::ranges::all_of(
                     path.at("points3"),
                     [&](const Json& p) { return std::abs(p.at(0).get<double>() - x) < 1e-6; })
                     ? 1
                     : 0;
      }
    }
    return lines;
  };
  EXPECT_EQ(along(draw("--section y=-6,x=2,y=5 --view front"), 2), 0U);
  EXPECT_GT(along(draw("--section y=-6,x=2,y=5 --view front"), 10), 0U);
  EXPECT_GT(along(steps, 2), 0U);
  const Json box = draw("--section-box 0,-11,4,5,-2,11");
  EXPECT_NEAR(reach(box, "pattern", 0).first, 0, 1e-6);
  EXPECT_NEAR(reach(box, "section", 0).second, 5, 1e-6);
  EXPECT_NEAR(reach(box, "pattern", 2).first, 4, 1e-6);
  // In an orthographic view of its direction the walls of an opening have no lines.
  const Json around = draw("--section-around 0,0,0,3 --view front");
  EXPECT_NEAR(reach(around, "pattern", 1).first, 0, 1e-6);
  EXPECT_NEAR(reach(around, "pattern", 1).second, 0, 1e-6);
  EXPECT_LT(reach(around, "pattern", 0).second, 3.1);
}

TEST_F(Sections, OfSeveralPlanesMayMiss) {
  ASSERT_EQ(run("draw @/box.off --section-box 900,900,900,901,901,901 -o @/a.json"), 0) << err_;
  EXPECT_NE(err_.find("cuts nothing"), std::string::npos) << err_;
  ASSERT_EQ(run("draw @/box.off --section x,-y=-1e3 -o @/a.json"), 0) << err_;
  EXPECT_NE(err_.find("cuts nothing"), std::string::npos) << err_;
  ASSERT_EQ(run("draw @/box.off --section-box=-900,-900,-900,900,900,900 -o @/a.json"), 2);
  EXPECT_NE(err_.find("takes all of it away"), std::string::npos) << err_;
  for (const char* bad :
       {"--section x,x", "--section y,x,y", "--section y,x=1,y,x=3",
        "--section y,x=3,y,x=1,y,x=2,y", "--section x,1,2", "--section x,", "--section-box 1,2,3",
        "--section-box 1,1,1,0,0,0", "--section-around 1,2,3", "--section-around 1,2,3,0",
        "--section-around 1,2,3,-4"}) {
    ASSERT_EQ(run(std::string("draw @/box.off ") + bad + " -o @/a.svg"), 2) << bad << err_;
    EXPECT_EQ(std::ranges::count(err_, '\n'), 1) << bad << err_;
  }
}

TEST_F(Sections, OfSeveralPlanesStandInAFile) {
  folder_.write("a.off", test::off_text(test::box({-10, -10, -10}, {10, 10, 10})));
  const auto draw = [&](const std::string& section) {
    folder_.write("a.burin.json",
                  "{\"burin\": \"illustration\",\n\"section\": " + section +
                      ",\n\"parts\": [{\"file\": \"a.off\"}], \"style\": \"outline\"}");
    return run("draw @/a.burin.json -o @/a.json");
  };
  const auto same_as = [&](const std::string& section, const std::string& options) {
    EXPECT_EQ(draw(section), 0) << err_;
    const Json file = drawing();
    EXPECT_EQ(run("draw @/a.off --style outline " + options + " -o @/a.json"), 0) << err_;
    EXPECT_EQ(file.at("layers"), drawing().at("layers")) << section;
  };
  same_as(R"("x,y")", "--section quarter");
  same_as(R"({"planes": ["x=3", {"normal": [0, -1, 0], "offset": 2}]})", "--section x=3,-y=-2");
  same_as(R"({"steps": ["y=-6", "x=2", "y=5"]})", "--section y=-6,x=2,y=5");
  same_as(R"({"box": [[0, -11, 4], [5, -2, 11]]})", "--section-box 0,-11,4,5,-2,11");
  same_as(R"({"around": {"center": [0, 1, 0], "radius": 3}})", "--section-around 0,1,0,3");
  for (const char* bad :
       {R"({"plane": "x", "box": [[0,0,0],[1,1,1]]})", R"({"planes": []})", R"({"planes": "x"})",
        R"({"planes": ["x,y"]})", R"({"steps": ["y", "x=1"]})", R"({"steps": ["y", "x", "y"]})",
        R"({"box": [[0,0,0],[1,1,0]]})", R"({"box": [0,0,0]})",
        R"({"around": {"center": [0,0,0]}})", R"({"around": {"center": [0,0,0], "radius": 0}})"}) {
    ASSERT_EQ(draw(bad), 2) << bad;
    EXPECT_NE(err_.find("a.burin.json:2: "), std::string::npos) << err_;
    EXPECT_EQ(std::ranges::count(err_, '\n'), 1) << err_;
  }
  // And in a first one.
  ASSERT_EQ(run("illustrate @/a.off --section x,y --section-box 0,-11,4,5,-2,11 "
                "--section-around 0,1,0,3 --section-exclude none -o @/b.burin.json"),
            0)
      << err_;
  const Json file = Json::parse(test::slurp(folder_ / "b.burin.json"));
  ASSERT_EQ(file.at("section").size(), 3U);
  EXPECT_EQ(file.at("section")[1].at("box"), Json::parse("[[0, -11, 4], [5, -2, 11]]"));
  EXPECT_EQ(file.at("section")[2].at("around").at("radius"), 3);
  EXPECT_EQ(file.at("section")[0].at("exclude"), Json::array());
  EXPECT_EQ(run("draw @/b.burin.json -o @/a.svg"), 0) << err_;
}

/// A part of the illustration below.
std::string part(const std::string& name, const std::string& function) {
  return "{\"name\": \"" + name + "\", \"function\": \"" + function + "\"}";
}

TEST_F(Sections, LeaveWholeWhatIsNotCutAlong) {
  folder_.write("pin.off", test::off_text(test::box({-3, -3, -10}, {3, 3, 10})));
  // A plate, and beside it a pin for each name: how many are said to be left whole, and whether
  // each is hatched.
  const auto draw = [&](const std::vector<std::string>& names, const std::string& options = "") {
    std::string parts =
        R"({"name": "plate", "file": "box.off", "place": {"translate": [-60, -15, -10]}})";
    for (std::size_t i = 0; i < names.size(); ++i) {
      parts += fmt::format(
          R"(, {{"name": "{}", "file": "pin.off", "place": {{"translate": [{}, 0, 0]}}}})",
          names[i], 10 * i);
    }
    folder_.write("a.burin.json",
                  R"({"burin": "illustration", "section": "y", "style": "outline", "parts": [)" +
                      parts + "]}");
    EXPECT_EQ(run("draw @/a.burin.json " + options + " -o @/a.json"), 0) << err_;
    const Json d = drawing();
    std::vector<bool> hatched(names.size(), false);
    for (const Json& layer : d.at("layers")) {
      if (layer.at("name") != "pattern") continue;
      for (const Json& path : layer.at("paths")) {
        if (path.at("part") > 0) hatched[path.at("part").get<std::size_t>() - 1] = true;
      }
    }
    std::size_t said = 0;
    for (const Json& one : d.at("diagnostics")) {
      if (one.at("code") == "section.left_whole") said += one.at("count").get<std::size_t>();
    }
    return std::pair(said, hatched);
  };
  const std::vector<std::string> whole{"bolt",
                                       "Bolt001",
                                       "HexBolt",
                                       "M6x20-Screw",
                                       "screws",
                                       "drive shaft",
                                       "DIN 912",
                                       "DIN912-M6",
                                       "DIN EN ISO 4762 M8x30",
                                       "ISO4017",
                                       "Sechskantschraube",
                                       "Unterlegscheibe",
                                       "Passfeder A6",
                                       "boulon 3",
                                       "dowel 1",
                                       "Pin_2"};
  const std::vector<std::string> cut_open{"housing", "shaft seal", "ball valve", "screw plate",
                                          "monkey",  "DIN 4711",   "ISO 9001",   "Riemenscheibe",
                                          "pinion",  "keyboard",   "washerless"};
  std::vector<std::string> all = whole;
  all.insert(all.end(), cut_open.begin(), cut_open.end());
  const auto [said, hatched] = draw(all);
  EXPECT_EQ(said, whole.size());
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(hatched[i], i >= whole.size()) << all[i];
  const std::pair<std::size_t, std::vector<bool>> nothing(0, {true});
  EXPECT_EQ(draw({"bolt"}, "--section-exclude none"), nothing);
  EXPECT_EQ(draw({"bolt"}, "--section-exclude plate").second, std::vector<bool>{true});
  // Alone it is what is wanted cut.
  EXPECT_EQ(draw({"bolt"}, "--hide plate"), nothing);
  // What lies beyond goes; what is cut across is cut.
  folder_.write(
      "a.burin.json",
      "{\"burin\": \"illustration\", \"section\": \"x,y\", \"style\": \"outline\", \"parts\": [" +
          part("plate", "box(30, 30, 6)") + ", " +
          part("pin", "translate(cylinder(1, 9), 8, -8, 0)") + ", " +
          part("rod", "translate(rotate(cylinder(2, 20), 0, 90, 0), 0, -8, 0)") + "]}");
  ASSERT_EQ(run("draw @/a.burin.json -o @/a.json"), 0) << err_;
  const Json d = drawing();
  std::size_t pin = 0, cut = 0;
  for (const Json& layer : d.at("layers")) {
    for (const Json& path : layer.at("paths")) {
      pin += path.at("part") == 1 ? 1 : 0;
      // It lies within the plate, whose hatching goes over it.
      cut += path.at("part") == 2 && layer.at("name") == "section" ? 1 : 0;
    }
  }
  EXPECT_EQ(pin, 0U);
  EXPECT_GT(cut, 0U);
}

}  // namespace
}  // namespace burin
