// Colours of parts, highlights and legends, from the command line.
#include "models.h"

#include <nlohmann/json.hpp>

#include <map>
#include <set>

namespace burin {
namespace {

using Json = nlohmann::json;

class Colours : public test::CliTest {
 protected:
  void SetUp() override {
    test::CliTest::SetUp();
    folder_.write("rack.scad",
                  "module glass() color(\"#4080c0\", 0.3) cube([40, 30, 20]);\n"
                  "module core() color(\"#c04040\") translate([5, 5, 2]) cube([30, 20, 16]);\n"
                  "module side() color(\"#202020\") translate([60, 0, 0]) cube([20, 30, 20]);\n"
                  "glass(); core(); side();\n");
  }

  /// Draws the rack; words of a line split at blanks.
  Json drawn(const std::string& options) {
    EXPECT_EQ(run("draw @/rack.scad -o @/a.json " + options), 0) << err_;
    return Json::parse(test::slurp(folder_ / "a.json"));
  }

  /// By the names of parts.
  static std::map<std::string, std::set<std::string>> fills(const Json& drawing) {
    std::map<std::string, std::set<std::string>> out;
    for (const Json& area : drawing.at("areas")) {
      const int part = area.at("part");
      if (part >= 0 && area.contains("fill")) {
        out[drawing.at("parts").at(part).at("name")].insert(area.at("fill"));
      }
    }
    return out;
  }

  /// Lines of hatching: their colours by the names of parts, "" that of the drawing.
  static std::map<std::string, std::set<std::string>> hatches(const Json& drawing) {
    std::map<std::string, std::set<std::string>> out;
    for (const Json& layer : drawing.at("layers")) {
      if (layer.at("name") != "fill-hatch") continue;
      for (const Json& path : layer.at("paths")) {
        out[drawing.at("parts").at(path.at("part").get<std::size_t>()).at("name")].insert(
            path.value("color", ""));
      }
    }
    return out;
  }
};

using Strings = std::set<std::string>;

TEST_F(Colours, HighlightsLeaveTheOthersTheirHatchingInGrey) {
  const std::string hatch = "--style outline --hide glass --set fill.hatch=lines ";
  EXPECT_EQ(hatches(drawn(hatch + "--highlight core")),
            (std::map<std::string, Strings>{{"core", {""}}, {"side", {"#8c8c8c"}}}));
  // In the colour of the part: orange there, and not that of the pale others, on which it is not
  // seen.
  EXPECT_EQ(hatches(drawn(hatch + "--set fill.hatch_color=fill --highlight core")),
            (std::map<std::string, Strings>{{"core", {"#f28e2b"}}, {"side", {"#8c8c8c"}}}));
  // In the shade alone, of the others too.
  const auto lines = [&](const std::string& options) {
    std::size_t sum = 0;
    const Json drawing = drawn(options);
    for (const Json& layer : drawing.at("layers")) {
      if (layer.at("name") == "fill-hatch") sum += layer.at("paths").size();
    }
    return sum;
  };
  const std::string toned = hatch + "--set tone.steps=3 ";
  EXPECT_EQ(lines(toned + "--highlight core"), lines(toned));
}

// A name that matches an assembly too leaves it the parts that another highlight names closer.
TEST_F(Colours, AHighlightOfAPartHoldsBeforeThatOfItsAssembly) {
  const std::string model = std::string(BURIN_SOURCE_DIR) + "/samples/coupling.step";
  const auto hub = [&](const std::string& options) {  // in the assembly "driven side"
    EXPECT_EQ(run("draw " + model + " -o @/a.json --style flat " + options), 0) << err_;
    return fills(Json::parse(test::slurp(folder_ / "a.json"))).at("driven hub");
  };
  const Strings blue = hub("--highlight *hub=blue"), red = hub("--highlight *hub=red");
  EXPECT_NE(blue, red);
  EXPECT_EQ(hub("--highlight *hub=blue --highlight driven*=red"), blue);
  EXPECT_EQ(hub("--highlight driven*=red --highlight *hub=blue"), blue);
  EXPECT_EQ(hub("--highlight driven*=red"), red);
  EXPECT_EQ(hub("--highlight *hub=blue --highlight *ven?hub=red"), red) << "the last of equals";
}

TEST_F(Colours, HighlightsOfGlassAreSeenInSpotInksToo) {
  const auto tint = [&](const std::string& options) {
    const Json drawing = drawn("--style duotone " + options);
    for (const Json& area : drawing.at("areas")) {
      if (drawing.at("parts").at(area.at("part").get<std::size_t>()).at("name") != "glass")
        continue;
      return area.at("tint").get<double>() * area.at("opacity").get<double>();
    }
    return 0.0;
  };
  EXPECT_NEAR(tint(""), (0.15 + 1) / 2 * 0.3, 1e-9) << "the mean of its tones";
  EXPECT_NEAR(tint("--highlight glass"), (0.6 + 1) / 2 * 0.3, 1e-9);
}

TEST_F(Colours, OfGlassAreOpaqueWhereALookSaysSo) {
  folder_.write("solid.json", R"({"base": "flat", "fill.opacity": 1})");
  folder_.write("group.json", R"({"base": "flat", "fill": {"opacity": 1}})");
  folder_.write("flat.json", R"({"base": "flat"})");
  const auto opacity = [&](const std::string& options) {
    const Json drawing = drawn("--style flat " + options);
    for (const Json& area : drawing.at("areas")) {
      if (area.at("part") == 0) return area.value("opacity", 1.0);
    }
    return 0.0;
  };
  EXPECT_NEAR(opacity(""), 0.3, 1e-9);
  EXPECT_NEAR(opacity("--look glass=@/flat.json"), 0.3, 1e-9) << "nothing is said of opacity";
  EXPECT_NEAR(opacity("--look glass=flat"), 0.3, 1e-9);
  EXPECT_EQ(opacity("--look glass=@/solid.json"), 1);
  EXPECT_EQ(opacity("--look glass=@/group.json"), 1);
  EXPECT_EQ(opacity("--ghost glass --look glass=@/solid.json"), 1);
  const auto names = fills(drawn("--style flat --look glass=@/solid.json"));
  EXPECT_FALSE(names.contains("core")) << "it is hidden";
  // Strokes are back, too.
  folder_.write("pen.json", R"({"base": "engraving", "fill.opacity": 1})");
  const Json drawing = drawn("--style engraving --look glass=@/pen.json");
  bool any = false;
  for (const Json& layer : drawing.at("layers")) {
    for (const Json& path : layer.at("paths")) {
      any = any || (path.at("kind") == "stroke" && path.at("part") == 0);
    }
  }
  EXPECT_TRUE(any);
}

TEST_F(Colours, HighlightsLeaveTheOthersPaleOnAnyPaper) {
  const std::string core = "--style flat --hide glass --highlight core ";
  EXPECT_EQ(fills(drawn(core)).at("side"), Strings{"#f4f4f4"});
  EXPECT_EQ(fills(drawn(core + "--set sheet.paper=#101010 --set sheet.ink=#ffffff")).at("side"),
            Strings{"#1a1a1a"});
}

TEST_F(Colours, HighlightsHaveTonesOnWhichLinesAreSeen) {
  drawn("--style cel --highlight core=red");
  EXPECT_EQ(err_, "");
  drawn("--style shaded --highlight core");
  EXPECT_EQ(err_, "") << "pale shade on the others";
  drawn("--style shaded --highlight core --views front,top");
  EXPECT_EQ(err_, "") << "seen from above nothing has a shadow on the ground";
  drawn("--style flat --highlight core=black");
  EXPECT_EQ(err_,
            "burin: warning: lines can hardly be seen on 'core': #000000 on "
            "#000000 has a contrast of 1.0; choose another line.color or fill.color\n");
}

TEST_F(Colours, HighlightsOfWhichNothingIsSeenAreTold) {
  folder_.write("rack.scad",
                "module box() cube([40, 30, 20]);\n"
                "module core() translate([5, 5, 2]) cube([30, 20, 16]);\n"
                "box(); core();\n");
  const std::string solid = "--style flat --highlight core=red ";
  drawn(solid);
  EXPECT_EQ(err_,
            "burin: warning: --highlight 'core=red' shows nothing: other parts hide 'core'; draw "
            "from another --view, leave out (--hide) or ghost (--ghost) what is before it, cut "
            "(--section) or explode\n");
  drawn(solid + "--section y=15");
  EXPECT_EQ(err_, "");
  drawn(solid + "--hide box");
  EXPECT_EQ(err_, "");
  drawn(solid + "--hidden dashed");
  EXPECT_EQ(err_, "");
}

/// Two posts of one shape in two colours, and a longer one.
constexpr const char* kPosts =
    "color([1, 0, 0, 1]) { cube(size = [10, 10, 10]); }\n"
    "multmatrix([[1, 0, 0, 20], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) {\n"
    "  color([0, 0, 1, 1]) { cube(size = [10, 10, 10]); }\n}\n"
    "multmatrix([[1, 0, 0, 40], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) {\n"
    "  color([0, 1, 0, 1]) { cube(size = [10, 20, 10]); }\n}\n";

TEST_F(Colours, OfALegendHaveTheNamesOfThePartsList) {
  folder_.write("post.csg", kPosts);
  ASSERT_EQ(run("draw @/post.csg -o @/a.json --style flat --legend --parts-list sheet"), 0) << err_;
  std::map<std::string, std::multiset<std::string>> texts;
  const Json drawing = Json::parse(test::slurp(folder_ / "a.json"));
  for (const Json& layer : drawing.at("layers")) {
    if (!layer.contains("texts")) continue;
    for (const Json& text : layer.at("texts")) texts[layer.at("name")].insert(text.at("text"));
  }
  EXPECT_EQ(texts["legend"], (std::multiset<std::string>{"post", "post", "post (2)"}));
  EXPECT_TRUE(texts["parts_list"].contains("post (2)"));
  folder_.write("a.burin.json",
                R"j({"burin": "illustration", "parts": [{"file": "post.csg"}],
                     "looks": [{"select": "post (2)", "drawn": false}]})j");
  ASSERT_EQ(run("draw @/a.burin.json -o @/a.json --style flat"), 0) << err_;
  EXPECT_EQ(fills(Json::parse(test::slurp(folder_ / "a.json"))).size(), 2U) << "it selects";
}

TEST_F(Colours, AreChosenByTheNamesThatAnIllustrationGives) {
  folder_.write("post.csg", kPosts);
  for (const char* items :
       {R"({"1": "pillar", "2": "beam"})",
        R"({"1": {"name": "pillar"}, "2": {"name": "beam", "select": "post #3"}})"}) {
    folder_.write("a.burin.json", std::string(R"({"burin": "illustration", "style": "flat",
        "parts": [{"file": "post.csg"}], "items": )") +
                                      items + "}");
    const auto seen = [&](const std::string& options) {
      EXPECT_EQ(run("draw @/a.burin.json -o @/a.json " + options), 0) << err_;
      return fills(Json::parse(test::slurp(folder_ / "a.json")));
    };
    const auto hidden = seen("--hide beam");
    EXPECT_TRUE(hidden.contains("post") && hidden.contains("post #2")) << items;
    EXPECT_FALSE(hidden.contains("post #3")) << items;
    EXPECT_EQ(seen("--highlight be*=#123456").at("post #3").count("#123456"), 1U) << items;
    EXPECT_EQ(seen("--part beam").size(), 1U) << items;
    EXPECT_EQ(run("draw @/a.burin.json -o @/a.json --hide beem"), 2);
    EXPECT_EQ(run("draw @/post.csg -o @/a.json --hide beam"), 2) << "no illustration";
  }
}

TEST_F(Colours, OfALookAloneLeaveTheStyleOfTheDrawing) {
  folder_.write("red.json", R"({"fill.color": "#ff0000"})");
  const Json drawing = drawn("--style cel --hide glass --look core=@/red.json");
  const auto tones = fills(drawing);
  EXPECT_GT(tones.at("core").size(), 1U) << "as the others have";
  EXPECT_TRUE(tones.at("core").contains("#ff0000"));
  for (const Json& layer : drawing.at("layers")) {
    for (const Json& path : layer.at("paths")) EXPECT_NE(path.at("kind"), "stroke");
  }
}

}  // namespace
}  // namespace burin
