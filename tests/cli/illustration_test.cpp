// Illustration files, and parts chosen on the command line.
#include "models.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <set>

namespace burin {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

class Illustrations : public test::CliTest {
 protected:
  /// Writes an illustration of these members and draws it with these options.
  int draw(const std::string& members, const std::string& options = "") {
    folder_.write("a.burin.json", "{\"burin\": \"illustration\"" + members + "}");
    return run("draw @/a.burin.json -o @/a.json " + options);
  }
  Json drawing() { return Json::parse(test::slurp(folder_ / "a.json")); }

  const std::string box_part_ = R"(, "parts": [{"file": "box.off"}])";
};

TEST_F(Illustrations, DrawWhatTheSameOptionsDraw) {
  ASSERT_EQ(run("draw @/box.off -o @/b.svg --style engraving --set hatch.taper=1 --view 1,2,3 "
                "--paper 150x100 --margin 5,6,7,8 --seed 9 --hidden dashed --light 1,0,1"),
            0)
      << err_;
  folder_.write("a.burin.json", R"({
    "burin": "illustration", "version": 1,  // with a comment
    "parts": [{"file": "box.off"}],
    "view": {"from": [1, 2, 3]}, "paper": {"size": [150, 100], "margin": [5, 6, 7, 8]},
    "hidden": "dashed", "seed": 9,
    "style": {"base": "engraving", "hatch.taper": 1, "tone": {"light": [1, 0, 1]}}})");
  ASSERT_EQ(run("draw @/a.burin.json -o @/a.svg"), 0) << err_;
  EXPECT_EQ(test::slurp(folder_ / "a.svg"), test::slurp(folder_ / "b.svg"));
  // What the command line says holds.
  ASSERT_EQ(run("draw @/a.burin.json -o @/a.json --view top --style outline --hidden none"), 0);
  const Json top = drawing();
  EXPECT_EQ(top["view"]["direction"], Json({0.0, 0.0, 1.0}));
  EXPECT_EQ(top["style"], "outline");
  EXPECT_EQ(top["seed"], 9);
}

// A ball of 10 mm, stretched threefold and mirrored, is 60 wide; sheared along x by its height it
// is sqrt(2) times as wide as it was.
TEST_F(Illustrations, StretchMirrorAndShear) {
  const std::string rest = R"x(}], "view": {"from": "front", "scale": 1}, "style": "outline")x";
  const std::string part = R"x(, "parts": [{"function": "sphere(10)", "place": )x";
  const auto width = [&](const std::string& place) {
    EXPECT_EQ(draw(part + place + rest), 0) << err_;
    double low = 1e9, high = -1e9;
    const Json drawn = drawing();
    for (const Json& layer : drawn["layers"]) {
      for (const Json& path : layer["paths"]) {
        for (const Json& p : path["points"]) {
          low = std::min(low, p[0].get<double>()), high = std::max(high, p[0].get<double>());
        }
      }
    }
    return high - low;
  };
  EXPECT_NEAR(width(R"({"scale": [-3, 1, 1]})"), 60, 0.05);
  EXPECT_NEAR(width(R"({"scale": [1, 1, 3], "rotate": [0, 90, 0]})"), 60, 0.05);
  EXPECT_NEAR(width(R"({"matrix": [[1, 0, 1, 5], [0, 1, 0, 0], [0, 0, 1, 0]]})"),
              20 * std::sqrt(2.0), 0.05);
}

TEST_F(Illustrations, PlaceAndNameTheirParts) {
  ASSERT_EQ(draw(R"x(, "title": "Two boxes & a ball", "parts": [
    {"file": "box.off", "name": "low"},
    {"file": "box.off", "name": "high", "place": {"translate": [0, 0, 100], "rotate": [0, 0, 90], "scale": 2}},
    {"function": "sphere(7)", "name": "ball", "place": {"translate": [-60, 0, 0]}}],
    "view": {"from": "front", "scale": 1}, "paper": "A3", "style": "outline")x"),
            0)
      << err_;
  const Json d = drawing();
  EXPECT_EQ(d["title"], "Two boxes & a ball");
  ASSERT_EQ(d["parts"].size(), 3U);
  EXPECT_EQ(d["parts"][0]["name"], "low");
  EXPECT_EQ(d["parts"][1]["name"], "high");
  EXPECT_EQ(d["parts"][2]["name"], "ball");
  // Boxes of 40 x 30 x 20 from the origin; the second turned about z, doubled and lifted: it spans
  // -60 to 0 by 100 to 140; the ball -67 to -53 by -7 to 7. In all -67 to 40 by -7 to 140.
  double low_x = 1e9, high_x = -1e9, low_y = 1e9, high_y = -1e9;
  for (const Json& layer : d["layers"]) {
    for (const Json& path : layer["paths"]) {
      for (const Json& p : path["points"]) {
        low_x = std::min(low_x, p[0].get<double>()), high_x = std::max(high_x, p[0].get<double>());
        low_y = std::min(low_y, p[1].get<double>()), high_y = std::max(high_y, p[1].get<double>());
      }
    }
  }
  EXPECT_NEAR(high_x - low_x, 107, 0.1);
  EXPECT_NEAR(high_y - low_y, 147, 0.1);
  ASSERT_EQ(run("draw @/a.burin.json -o @/a.svg"), 0);
  EXPECT_NE(test::slurp(folder_ / "a.svg").find("<title>Two boxes &amp; a ball</title>"),
            std::string::npos);
  ASSERT_EQ(run("convert @/a.json -o @/b.json"), 0) << err_;
  EXPECT_EQ(Json::parse(test::slurp(folder_ / "b.json"))["title"], "Two boxes & a ball");
}

TEST_F(Illustrations, LooksAreForThePartsThatTheyName) {
  const std::string parts = R"(, "style": "outline", "parts": [
    {"file": "box.off", "name": "near"},
    {"file": "box.off", "name": "far", "place": {"translate": [0, 100, 0]}}])";
  const auto strokes = [&](int part) {
    std::size_t count = 0;
    const Json d = drawing();
    for (const Json& layer : d["layers"]) {
      if (!layer["name"].get<std::string>().starts_with("stroke")) continue;
      for (const Json& path : layer["paths"]) count += path["part"] == part;
    }
    return count;
  };
  ASSERT_EQ(draw(parts), 0) << err_;
  EXPECT_EQ(strokes(0) + strokes(1), 0U);
  ASSERT_EQ(draw(parts + R"(, "looks": [{"select": "far", "style": "engraving"}])"), 0) << err_;
  EXPECT_EQ(strokes(0), 0U);
  EXPECT_GT(strokes(1), 20U);
  // Without "base" the changes are to the drawing's own style; a later look holds.
  ASSERT_EQ(
      draw(parts + R"(, "looks": [{"select": ["near", "far"], "style": {"hatch.enabled": true}},
                                        {"select": "near", "hatched": false}])"),
      0)
      << err_;
  EXPECT_EQ(strokes(0), 0U);
  EXPECT_GT(strokes(1), 20U);
  ASSERT_EQ(draw(parts, "--look far=engraving"), 0) << err_;
  EXPECT_GT(strokes(1), 20U);
}

TEST_F(Illustrations, KindsOfStrokesAreSaidByListAndByKey) {
  ASSERT_EQ(draw(R"x(, "parts": [
    {"function": "sphere(7)", "name": "ball"},
    {"function": "sphere(7)", "name": "other", "place": {"translate": [20, 0, 0]}}],
    "paper": [120, 80], "style": {"base": "engraving", "strokes": [
      {"width_law": "0.5"}, {"kind": "dots", "select": "other"}]})x"),
            0)
      << err_;
  std::set<int> dotted;
  const Json d = drawing();
  for (const Json& layer : d["layers"]) {
    for (const Json& path : layer["paths"]) {
      if (path.value("stroke_kind", 1) == 2) dotted.insert(path["part"].get<int>());
    }
  }
  EXPECT_EQ(dotted, std::set<int>{1});
  ASSERT_EQ(draw(R"x(, "parts": [{"file": "box.off"}], "style": {
    "strokes": [{}, {"plcing": "dots"}]})x"),
            2);
  EXPECT_NE(err_.find("strokes.2.placing"), std::string::npos) << err_;
  // A first file of single keys draws what they draw.
  const std::string keys =
      " --set strokes.2.width_max=0.5 --set strokes.2.kind=dots --set strokes.2.select=box "
      "--set hatch.width_law=0.5+t";
  ASSERT_EQ(run("illustrate @/box.off --paper A6 -o @/first.burin.json" + keys), 0) << err_;
  ASSERT_EQ(run("draw @/first.burin.json -o @/a.svg"), 0) << err_;
  ASSERT_EQ(run("draw @/box.off -o @/b.svg" + keys), 0) << err_;
  EXPECT_EQ(test::slurp(folder_ / "a.svg"), test::slurp(folder_ / "b.svg"));
}

TEST_F(Illustrations, PartsAreChosenOnTheCommandLine) {
  const auto parts_drawn = [&] {
    std::set<int> parts;
    const Json d = drawing();
    for (const Json& layer : d["layers"]) {
      for (const Json& path : layer["paths"]) parts.insert(path["part"].get<int>());
    }
    return parts;
  };
  folder_.write("lid.off", test::box_off());
  const std::string both = "draw @/box.off @/lid.off -o @/a.json --style outline ";
  ASSERT_EQ(run(both + "--hide lid"), 0) << err_;
  EXPECT_EQ(parts_drawn(), (std::set<int>{0}));
  ASSERT_EQ(run(both + "--part lid"), 0) << err_;
  EXPECT_EQ(parts_drawn(), (std::set<int>{1}));
  EXPECT_EQ(run(both + "--hide lit"), 2);
  expect_error("no part is named 'lit'; names of parts and assemblies: 'lid', 'box'");
  EXPECT_EQ(run(both + "--hide *"), 2);
  expect_error("nothing is left to draw");
  EXPECT_EQ(run(both + "--look lid"), 2);
  expect_error("option --look takes NAME=STYLE, not 'lid'");
  EXPECT_EQ(run(both + "--look lid=engravng"), 2);
  expect_error("the nearest is 'engraving'");
  // The sheet shows what is drawn: a part that is left out takes no room.
  folder_.write("far.off", test::off_text(test::box({500, 0, 0}, {540, 30, 20})));
  ASSERT_EQ(run("draw @/box.off @/far.off -o @/a.json --hide far"), 0) << err_;
  const double scale = drawing()["view"]["scale"];
  ASSERT_EQ(run("draw @/box.off -o @/a.json"), 0) << err_;
  EXPECT_EQ(drawing()["view"]["scale"], scale);
  // Nor does it make the drawing of the others coarser, as if they were a detail of it.
  folder_.write("ball.off", test::off_text(test::ellipsoid(Vec3(10), 24, 12)));
  folder_.write("away.off", test::off_text(test::box({90000, 0, 0}, {90040, 30, 20})));
  ASSERT_EQ(run("draw @/ball.off @/away.off -o @/a.svg --style outline --hide away"), 0) << err_;
  EXPECT_EQ(err_.find("times as large as the sheet"), std::string::npos) << err_;
  ASSERT_EQ(run("draw @/ball.off -o @/b.svg --style outline"), 0) << err_;
  const auto outline = [&](const char* name) {
    const std::string svg = test::slurp(folder_ / name);
    const std::size_t at = svg.find("<path");
    return svg.substr(svg.find(" d=", at), 200);
  };
  EXPECT_EQ(outline("a.svg"), outline("b.svg"));
}

TEST_F(Illustrations, HouseFilesHoldWhereAFileHasNothing) {
  fs::create_directory(folder_ / "house");
  folder_.write("house/style.json", R"({"base": "engraving", "line.outer": 0.9})");
  folder_.write("house/house.burin.json",
                R"({"burin": "illustration", "view": {"from": "top"}, "paper": "A5",
                    "style": "style.json"})");
  ASSERT_EQ(draw(box_part_ + R"(, "extends": "house/house.burin.json", "paper": "A6")"), 0) << err_;
  const Json d = drawing();
  EXPECT_EQ(d["style"], "style");
  EXPECT_EQ(d["view"]["direction"], Json({0.0, 0.0, 1.0}));
  EXPECT_EQ(d["paper"]["width"], 148);
  // An error there names that file.
  folder_.write("house/house.burin.json", "{\"burin\": \"illustration\",\n \"vew\": 1}");
  EXPECT_EQ(run("draw @/a.burin.json -o @/a.json"), 2);
  expect_error("house/house.burin.json:2: unknown key 'vew'; did you mean 'view'?");
}

TEST_F(Illustrations, ErrorsNameFileLineAndTheNearestKey) {
  struct Wrong {
    std::string members, said;
    int status;
  };
  const std::string b = box_part_;
  const std::vector<Wrong> all = {
      {",\n\"parts\": [{\"fil\": \"box.off\"}]", ":2: unknown key 'fil'; did you mean 'file'?", 2},
      {", \"parts\": [\n{\"file\": \"none.off\"}]", ":2: ", 3},
      {", \"parts\": []", "has no parts", 2},
      {", \"parts\": {}", "\"parts\" takes a list", 2},
      {", \"parts\": [{\"file\": \"box.off\", \"function\": \"x\"}]", "either \"file\" or", 2},
      {", \"parts\": [{\"function\": \"spere(3)\"}]", "'spere'", 3},
      {", \"parts\": [{\"file\": \"box.off\",\n \"iso\": \"much\"}]", ":2: \"iso\" takes a number",
       2},
      {b + ",\n\n\"style\": {\"base\": \"outline\",\n\"line.outr\": 1}", ":4: unknown style key",
       2},
      {b + ",\n\"style\": \"outlin\"", ":2: unknown style 'outlin'; the nearest is 'outline'", 2},
      {b + ",\n\"style\": \"no.json\"", ":2: there is no style file", 2},
      {b + ", \"view\": {\n\"from\": \"isso\"}", ":2: unknown view 'isso'", 2},
      {b + ", \"view\": {\n\"perspective\": 200}", ":2: \"view.perspective\" takes 1 to 120", 2},
      {b + ", \"view\": {\n\"form\": 1}", ":2: unknown key 'form'; did you mean 'from'?", 2},
      {b + ", \"view\": 3", "\"view\" takes an object", 2},
      {b + ",\n\"paper\": [0, 3]", ":2: ", 2},
      {b + ", \"looks\": [\n{\"select\": \"bax\"}]", ":2: no part is named 'bax'", 2},
      {b + ", \"looks\": [{\"select\": \"box\",\n\"drawn\": 1}]",
       ":2: \"drawn\" takes true or false", 2},
      {b + ", \"looks\": [{\"drawn\": true}]", "a look has \"select\"", 2},
      {b + ", \"lights\": [{\"from\": [0, 0, 0]}]", "takes a direction but 0,0,0", 2},
      {b + ", \"lights\": [{\"ambient\": -1}]", "a strength of 0 to 10", 2},
      {b + ", \"extends\": \"a.burin.json\"", "a chain of more than 16 files, or a ring", 2},
      {b + ", \"version\": 2", "reads version 1", 2},
      {b + ", \"title\": 5", "\"title\" takes text", 2},
      {", \"parts\": [{\"file\": \"box.off\", \"place\": {\"scale\": 0}}]", "\"scale\" takes", 2},
      {", \"parts\": [{\"file\": \"box.off\", \"place\": {\"scale\": [1, 0, 1]}}]",
       "\"scale\" takes", 2},
      {", \"parts\": [{\"file\": \"box.off\", \"place\": {\"matrix\": [[1, 0, 0, 0], [2, 0, 0, 0], "
       "[0, 0, 1, 0]]}}]",
       "\"matrix\" flattens the part", 2},
      {", \"parts\": [{\"file\": \"box.off\", \"place\": {\"matrix\": [[1, 0, 0], [0, 1, 0], "
       "[0, 0, 1]]}}]",
       "takes three rows of four numbers", 2},
      {", \"parts\": [{\"file\": \"box.off\", \"place\": {\"scale\": 2, \"matrix\": [[1, 0, 0, 0], "
       "[0, 1, 0, 0], [0, 0, 1, 0]]}}]",
       "\"matrix\" takes no other keys", 2},
      {", \"parts\": [{\"file\": \"box.off\", \"place\": {\"rotate\": [1, 2]}}]", "takes [x, y, z]",
       2},
      {b + ",\n\"seed\": 1e999", ":2: a number is too large here", 3},
      {",\n,", "not valid JSON here; mend the illustration file", 3},
  };
  for (const Wrong& wrong : all) {
    SCOPED_TRACE(wrong.members);
    EXPECT_EQ(draw(wrong.members), wrong.status) << err_;
    expect_error(wrong.said);
    expect_error("a.burin.json");
    EXPECT_FALSE(fs::exists(folder_ / "a.json"));
  }
  folder_.write("list.json", "[1]");
  EXPECT_EQ(run("draw @/list.json -o @/a.svg"), 3);
  expect_error("one JSON object");
  ASSERT_EQ(run("draw @/box.off -o @/drawn.json -q"), 0);
  EXPECT_EQ(run("draw @/drawn.json -o @/a.svg"), 3);
  expect_error("is a drawing, which is drawn already");
  ASSERT_EQ(draw(b), 0);
  EXPECT_EQ(run("draw @/a.burin.json @/box.off -o @/a.svg"), 2);
  expect_error("is drawn alone");
  EXPECT_EQ(run("draw @/a.burin.json -o @/a.svg --iso 3"), 2);
  expect_error("option --iso is about reading");
  EXPECT_EQ(run("draw @/a.burin.json -o @/box.off --format svg"), 2);
  expect_error("box.off");
}

TEST_F(Illustrations, AFirstFileIsWrittenThatDrawsTheSame) {
  const std::string options =
      " --style engraving --set hatch.taper=1 --view 1,2,3 --scale 1:2 "
      "--light 1,0,1 --hidden dashed --margin 5";
  ASSERT_EQ(run("draw @/box.off -o @/b.svg" + options), 0) << err_;
  fs::create_directory(folder_ / "deep");
  ASSERT_EQ(run("illustrate @/box.off -o @/deep/a.burin.json" + options), 0) << err_;
  EXPECT_EQ(Json::parse(test::slurp(folder_ / "deep/a.burin.json"))["parts"][0]["file"],
            "../box.off");
  ASSERT_EQ(run("draw @/deep/a.burin.json -o @/a.svg"), 0) << err_;
  EXPECT_EQ(test::slurp(folder_ / "a.svg"), test::slurp(folder_ / "b.svg"));
  // What was edited stays.
  EXPECT_EQ(run("illustrate @/box.off -o @/deep/a.burin.json"), 4);
  expect_error("is there already");
  EXPECT_EQ(run("illustrate @/box.off -o @/a.svg"), 2);
  expect_error("end in .json");
  EXPECT_EQ(run("illustrate -o @/c.burin.json"), 2);
  EXPECT_EQ(run("illustrate @/none.off -o @/c.burin.json"), 3);
  ASSERT_EQ(run("illustrate @/box.off --hide lid --look box=outline -o -"), 0) << err_;
  EXPECT_EQ(
      Json::parse(out_)["looks"],
      Json::parse(R"([{"select": "lid", "drawn": false}, {"select": "box", "style": "outline"}])"));
}

// A first file draws as the command does, and warns of nothing that nobody asked for.
TEST_F(Illustrations, AFirstFileOfAnyKindOfInputWarnsOfNothing) {
  const std::string samples = std::string(BURIN_SOURCE_DIR) + "/samples/";
  const std::vector<std::string> inputs = {"@/box.off", samples + "coupling.step",
                                           samples + "teapot.itd", samples + "pump_cover.implicit"};
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    SCOPED_TRACE(inputs[i]);
    const std::string file = "@/first" + std::to_string(i) + ".burin.json";
    ASSERT_EQ(run("illustrate " + inputs[i] + " -o " + file + " --style outline --paper A6"), 0)
        << err_;
    EXPECT_EQ(err_, "");
    ASSERT_EQ(run("draw " + inputs[i] + " --style outline --paper A6 -o @/a.svg"), 0) << err_;
    const std::string said = err_;
    ASSERT_EQ(run("draw " + file + " -o @/b.svg"), 0) << err_;
    EXPECT_EQ(err_, said);
    EXPECT_EQ(test::slurp(folder_ / "b.svg"), test::slurp(folder_ / "a.svg"));
  }
}

// An option about reading goes with the inputs that it concerns.
TEST_F(Illustrations, AFirstFileHasOptionsWhereTheyHaveAnEffect) {
  folder_.write("ball.implicit", "sphere(5)");
  ASSERT_EQ(run("illustrate @/box.off @/ball.implicit --mesher nets -o @/two.burin.json "
                "--style outline"),
            0)
      << err_;
  ASSERT_EQ(run("draw @/two.burin.json -o @/a.svg"), 0) << err_;
  EXPECT_EQ(err_, "");
  // What concerns none of them is still told.
  ASSERT_EQ(run("illustrate @/box.off --iso 5 -o @/one.burin.json --style outline"), 0) << err_;
  ASSERT_EQ(run("draw @/one.burin.json -o @/a.svg"), 0) << err_;
  EXPECT_NE(err_.find("has no effect"), std::string::npos) << err_;
}

// What the schema refuses, the reader refuses, and the line is named; whole numbers may be 1.0.
TEST_F(Illustrations, TakeTheTypesThatTheSchemaNames) {
  const auto refused = [&](const std::string& members, const std::string& words) {
    EXPECT_EQ(draw(box_part_ + members), 2) << members;
    EXPECT_NE(err_.find(words), std::string::npos) << err_;
  };
  refused(",\n\"callouts\": 1", "a.burin.json:2: \"callouts\" takes true or false");
  refused(",\n\"tolerance\": \"0.1\"", ":2: \"tolerance\" takes a number");
  refused(",\n\"seed\": 1.5", ":2: \"seed\" takes a whole number");
  refused(",\n\"view\": {\"up\": 5}", "\"up\" takes [x, y, z]");
  refused(",\n\"views\": true", "\"views\" takes text, a number or a list");
  refused(",\n\"items\": {\"01\": \"lid\"}", "an item has a number from 1 to");
  refused(",\n\"seed\": 1,\n\"seed\": 2", ":3: the key 'seed' is here a second time");
  EXPECT_EQ(draw(box_part_ + ", \"seed\": 3.0, \"hidden\": \"dashed\""), 0) << err_;
  EXPECT_EQ(drawing()["seed"], 3);
  // The same key of two objects is none that is there twice.
  EXPECT_EQ(draw(box_part_ + R"(, "lights": [{"ambient": 0.1}, {"ambient": 0.2}])"), 0) << err_;
}

// As a shell of Windows writes what a command prints.
TEST_F(Illustrations, InUtf16AreNamedSo) {
  std::string text = "\xff\xfe";
  for (const char c : std::string(R"({"burin": "illustration"})")) (text += c) += '\0';
  folder_.write("a.burin.json", text);
  EXPECT_EQ(run("draw @/a.burin.json -o @/b.svg"), 3);
  EXPECT_NE(err_.find("a.burin.json: is text in UTF-16; save it as UTF-8"), std::string::npos)
      << err_;
}

}  // namespace
}  // namespace burin
