// Keys of colours, tones and shadows change the drawing, or a warning says that they do not.
#include <burin/illustrate/style.h>

#include "models.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <map>

namespace burin {
namespace {

using Json = nlohmann::json;

/// Values that differ from those of any built-in style.
const std::map<std::string, std::string>& values() {
  static const std::map<std::string, std::string> all = {
      {"fill.color", "#a0b0c0"},   {"fill.opacity", "0.5"},      {"fill.ink", "Own"},
      {"fill.tint", "0.77"},       {"fill.legend", "false"},     {"fill.hatch", "cross"},
      {"fill.hatch_angle", "30"},  {"fill.hatch_distance", "2"}, {"fill.hatch_width", "0.3"},
      {"fill.hatch_tones", "2"},   {"fill.hatch_color", "fill"}, {"shadow.color", "#778899"},
      {"fill.faces", "true"},      {"fill.shadow", "false"},     {"tone.law", "silhouette"},
      {"tone.light", "1,0.2,0.4"}, {"tone.ambient", "0.02"},     {"tone.diffuse", "0.3"},
      {"tone.reflected", "0.6"},   {"tone.specular", "1.5"},     {"tone.shininess", "3"},
      {"tone.decay", "1.2"},       {"tone.shadow", "0.7"},       {"tone.shadow_width", "30"},
      {"tone.highlight", "1.7"},   {"tone.rim", "0.8"},          {"tone.ink", "light"},
      {"tone.median_min", "0.38"}, {"tone.median_max", "0.3"},   {"tone.contrast", "0.4"},
      {"tone.gradient", "0.4"},    {"tone.steps", "4"},          {"tone.darkest", "0.33"}};
  return all;
}

class KeyEffects : public test::CliTest {
 protected:
  void SetUp() override {
    test::CliTest::SetUp();
    folder_.write("two.scad",
                  "module ball() color(\"#c0d0e0\") translate([20, 15, 26]) sphere(8, $fn = 24);\n"
                  "module base() color(\"#e0c080\") cube([40, 30, 18]);\n"
                  "ball(); base();\n");
    // The same as meshes: there is no need to start OpenSCAD for each key.
    folder_.write("ball.off",
                  painted(test::ellipsoid(Vec3(8), 24, 12), {20, 15, 26}, "192 208 224"));
    folder_.write("base.off",
                  painted(test::box({0, 0, 0}, {40, 30, 18}), {0, 0, 0}, "224 192 128"));
  }

  /// A mesh whose faces have a colour.
  static std::string painted(const TriMesh& mesh, Vec3 at, const std::string& color) {
    std::string text = fmt::format("OFF\n{} {} 0\n", mesh.positions.size(), mesh.triangles.size());
    for (const Vec3& p : mesh.positions) {
      text += fmt::format("{} {} {}\n", p.x + at.x, p.y + at.y, p.z + at.z);
    }
    for (const Triangle& t : mesh.triangles) {
      text += fmt::format("3 {} {} {} {}\n", t[0], t[1], t[2], color);
    }
    return text;
  }

  std::string drawn(const std::string& options, const std::string& model = "two.scad") {
    EXPECT_EQ(run("draw @/" + model + " --paper 60x60 --margin 3 -o @/a.json " + options), 0)
        << err_;
    Json drawing = Json::parse(test::slurp(folder_ / "a.json"));
    drawing.erase("diagnostics");
    return drawing.dump();
  }
  std::string warnings(const std::string& options) {
    drawn(options);
    return err_;
  }
};

TEST_F(KeyEffects, EachKeyChangesTheDrawingOrIsTold) {
  const std::string models = "ball.off @/base.off";
  for (const std::string style :
       {"outline", "flat", "shaded", "cel", "manual", "duotone", "engraving"}) {
    const std::string plain = drawn("--style " + style, models);
    for (const StyleKey& key : style_keys(builtin_style(style))) {
      const std::string group = key.name.substr(0, key.name.find('.'));
      if (group != "fill" && group != "tone" && group != "shadow") continue;
      const auto own = values().find(key.name);
      const bool turns = key.name == "shadow.cast" || key.name == "shadow.ground";
      ASSERT_TRUE(turns || own != values().end()) << "a value for " << key.name;
      const std::string value = turns ? (key.value == "true" ? "false" : "true") : own->second;
      if (value == key.value) continue;
      const bool changes =
          drawn("--style " + style + " --set " + key.name + "=" + value, models) != plain;
      const bool says = err_.find("style key " + key.name + " has no effect") != err_.npos;
      EXPECT_NE(changes, says) << style << " " << key.name << "=" << value << ": " << err_;
    }
  }
}

TEST_F(KeyEffects, TheReasonSaysWhatToDo) {
  const auto of = [](const std::string& key, const std::string& why) {
    return "burin: warning: style key " + key + " has no effect" + why + "\n";
  };
  EXPECT_EQ(warnings("--style outline --set fill.opacity=0.5"),
            of("fill.opacity", ": style 'outline' gives parts no colour (fill.color=part does)"));
  EXPECT_EQ(warnings("--style flat --set fill.legend=false"),
            of("fill.legend", " without --legend"));
  EXPECT_EQ(warnings("--style flat --set fill.hatch_color=red"),
            of("fill.hatch_color", ": fill.hatch is none (fill.hatch=lines hatches areas)"));
  EXPECT_EQ(warnings("--style outline --set fill.hatch=lines --set fill.hatch_color=fill"),
            of("fill.hatch_color",
               ": lines have the colour of their part, which fill.color=none takes from it "
               "(fill.color=part and fill.opacity=0 colour the lines alone)"));
  EXPECT_NE(
      warnings("--style flat --set shadow.ground=true --view bottom").find("shadow.ground has no"),
      std::string::npos);
  EXPECT_NE(
      warnings("--style flat --set fill.color=red --highlight ball").find("fill.color has no"),
      std::string::npos);
  const std::string low = warnings("--style flat --set shadow.ground=true --light 1,-1,-1");
  EXPECT_NE(low.find("shadow.ground has no effect: the ground under the parts"), low.npos) << low;
  EXPECT_NE(low.find("--light has no effect: it would light the shadow on the ground"), low.npos);
  // What has an effect, or is as it was, is no matter.
  EXPECT_EQ(warnings("--style flat --set shadow.ground=true"), "");
  EXPECT_EQ(warnings("--style outline --set fill.color=none"), "");
  EXPECT_EQ(warnings("--style outline --set fill.color=part --set fill.opacity=0.5"), "");
  EXPECT_EQ(warnings("--style outline --look ball=flat --set fill.hatch=lines"), "");
}

TEST_F(KeyEffects, KeysOfStyleFilesAreToldToo) {
  const auto of = [&](const std::string& keys, const std::string& why) {
    return fmt::format("burin: warning: {}/own.json: style {} no effect{}\n", folder_.path(), keys,
                       why);
  };
  const std::string nothing_to_hatch = ": fill.hatch is none (fill.hatch=lines hatches areas)";
  folder_.write("own.json",
                R"({"base": "flat", "fill": {"hatch_angle": 30, "tint": 0.4}, "line.outer": 0.8,)"
                R"( "fill.hatch_distance": 2, "fill.hatch_width": 0.13})");
  const std::string said =
      of("keys fill.hatch_angle, fill.hatch_distance have", nothing_to_hatch) +
      of("key fill.tint has", ": it is for a spot ink, and fill.ink names none");
  EXPECT_EQ(warnings("--style @/own.json"), said);
  EXPECT_EQ(warnings("--look ball=@/own.json"), said);
  // What options change is theirs to tell; a style of parts may use the drawing's keys.
  EXPECT_EQ(
      warnings(
          "--style @/own.json --set fill.hatch=cross --set fill.ink=blue --set fill.color=#3b7dd8"),
      "");
  folder_.write("hatched.json",
                R"({"fill.hatch": "lines", "fill.ink": "blue", "fill.color": "#3b7dd8"})");
  EXPECT_EQ(warnings("--style @/own.json --look ball=@/hatched.json"), "");
  // A file is for many drawings: with and without a legend, glass, a ground that is seen.
  folder_.write("own.json", R"({"base": "flat", "fill.legend": false, "shadow.ground": true})");
  EXPECT_EQ(warnings("--style @/own.json --view bottom --ghost ball --ghost base"), "");
  folder_.write(
      "own.json",
      R"({"strokes": [{"taper": 0.7}, {"taper": 0.6, "enabled": false}], "hatch.enabled": false})");
  EXPECT_NE(warnings("--style @/own.json").find("own.json: style keys"), std::string::npos) << err_;
}

TEST_F(KeyEffects, TextsOfBuiltInStylesAskNothing) {
  for (const StyleInfo& style : builtin_styles()) {
    folder_.write("own.json", style_to_json(builtin_style(style.name)));
    EXPECT_EQ(warnings("--style @/own.json"), "") << style.name;
  }
}

TEST_F(KeyEffects, HighlightsOfWhichNothingIsLeftAreTold) {
  EXPECT_EQ(warnings("--highlight b* --highlight ball=red"), "");
  EXPECT_EQ(warnings("--highlight ball --highlight b*=red"),
            "burin: warning: --highlight 'ball' has no effect: --highlight 'b*=red' is laid over "
            "all of its parts, such as 'ball' (of several looks the last one holds, of several "
            "highlights the one that names a part most closely, and looks go over highlights)\n");
  EXPECT_EQ(
      warnings("--highlight ball --hide ball"),
      "burin: warning: --highlight 'ball' has no effect: 'ball' is left out of the drawing\n");
}

TEST_F(KeyEffects, ColoursThatAreNoneAreToldWithTheNearest) {
  EXPECT_EQ(run("draw @/two.scad -o @/a.json --set fill.color=organe"), 2);
  expect_error("'fill.color' takes a colour #rrggbb, ");
  expect_error("part or none, not 'organe'; the nearest is 'orange'");
  EXPECT_EQ(run("draw @/two.scad -o @/a.json --style flat --set shadow.color=gren"), 2);
  expect_error("or nothing, not 'gren'; the nearest is 'green'");
  EXPECT_EQ(run("draw @/two.scad -o @/a.json --look ball=red"), 2);
  expect_error("--look takes NAME=STYLE, and 'red' is a colour: --highlight ball=red");
}

TEST_F(KeyEffects, AnEmptyLegendSaysWhichKeyLeavesColoursOut) {
  EXPECT_NE(warnings("--style flat --legend --set fill.legend=false")
                .find("fill.legend=false leaves all colours out of the legend"),
            std::string::npos)
      << err_;
  EXPECT_NE(warnings("--style outline --legend").find("there is no colour for a legend"),
            std::string::npos)
      << err_;
}

}  // namespace
}  // namespace burin
