// Rows of dimensions in illustration files, and the file that keeps them.
#include "models.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace burin {
namespace {

class DimensionFiles : public test::CliTest {
 protected:
  using Json = nlohmann::json;
  using Written = std::vector<std::string>;
  int draw(const std::string& dimensions, const std::string& more = "") {
    folder_.write("a.burin.json", R"({"burin": "illustration", "parts": [{"file": "box.off"}],
      "style": "outline", "views": ["front", "top"],
      "dimensions": )" + dimensions + more +
                                      "}");
    return run("draw @/a.burin.json -o @/a.json");
  }
  Written texts() {
    Written out;
    const Json drawing = Json::parse(test::slurp(folder_ / "a.json"));
    for (const Json& layer : drawing["layers"]) {
      if (layer["name"] != "dimensions") continue;
      for (const Json& text : layer["texts"]) out.push_back(text["text"]);
    }
    return out;
  }
  /// What drawing a row says that is refused.
  std::string refused(const std::string& row) {
    EXPECT_EQ(draw("[" + row + "]"), 2);
    return err_;
  }
};

TEST_F(DimensionFiles, SayWhatRowsTake) {
  EXPECT_NE(refused(R"({})").find("a.burin.json:3: a dimension has one of distance, diameter, "
                                  "radius, angle, depth, thread"),
            std::string::npos)
      << err_;
  EXPECT_NE(refused(R"({"diametre": [0, 0, 0]})").find("did you mean 'diameter'?"),
            std::string::npos);
  EXPECT_NE(refused(R"({"distance": [[0, 0, 0]]})").find("\"distance\" takes a list of two"),
            std::string::npos);
  EXPECT_NE(refused(R"({"diameter": {"face": 3}})").find("a number is one of a part"),
            std::string::npos);
  EXPECT_NE(refused(R"({"thread": [0, 0, 0]})").find("a thread has \"text\", such as \"M8\""),
            std::string::npos);
  EXPECT_NE(
      refused(R"({"radius": [0, 0, 0], "along": [1, 0, 0]})").find("\"along\" is for a distance"),
      std::string::npos);
  EXPECT_NE(refused(R"({"radius": [0, 0, 0], "supplement": true})")
                .find("\"supplement\" is for an angle"),
            std::string::npos);
  EXPECT_NE(refused(R"({"radius": [0, 0, 0], "unit": "yard"})")
                .find("\"unit\" takes mm, cm, m, inch, not yard"),
            std::string::npos);
  EXPECT_NE(refused(R"({"radius": {"part": "box", "face": 0}})").find("a plane"),
            std::string::npos);
  EXPECT_NE(refused("5").find("\"dimensions\" takes \"overall\" and rows such as"),
            std::string::npos)
      << err_;
  EXPECT_NE(refused(R"("all")").find("\"dimensions\" takes none or overall"), std::string::npos)
      << err_;
}

TEST_F(DimensionFiles, RefuseTextsThatCannotBeMeant) {
  const auto said = [&](const std::string& more) {
    return refused(R"({"distance": [[0, 15, 10], [40, 15, 10]], )" + more + "}");
  };
  EXPECT_NE(said(R"("tolerance": ["+0.1", "+0.2"])")
                .find("the upper deviation comes first, and \"+0.1\" is less than \"+0.2\""),
            std::string::npos)
      << err_;
  EXPECT_NE(said(R"("tolerance": ["a", "b"])").find("a deviation is a number such as \"+0.1\""),
            std::string::npos)
      << err_;
  EXPECT_NE(said(R"("text": "{valu}")").find("\"text\" has {valu}: only {value} is known"),
            std::string::npos)
      << err_;
  EXPECT_EQ(draw(R"([{"distance": [[0, 15, 10], [40, 15, 10]], "text": "2x {value}",
                      "tolerance": ["+0,2\u00b0", "\u22120.1"]}])"),
            0)
      << err_;
}

/// A countersink: the angle between opposite sides of one cone, in the section that shows it.
TEST_F(DimensionFiles, MeasureTheAngleOfACone) {
  folder_.write("sunk.scad",
                "$fn=96; difference() { cube([40, 30, 10]); translate([20, 15, 5]) "
                "cylinder(h=5, r1=2, r2=7); }");
  folder_.write("cone.burin.json", R"({"burin": "illustration", "style": "outline",
    "parts": [{"file": "sunk.scad"}], "views": ["top"], "section": [{"plane": "y", "view": true}],
    "dimensions": [{"angle": [[20, 19.5, 7.5]]}]})");
  ASSERT_EQ(run("draw @/cone.burin.json -o @/a.json"), 0) << err_;
  EXPECT_EQ(texts(), Written{"90\u00b0"}) << err_;
  EXPECT_NE(refused(R"({"angle": [[0, 15, 10]]})").find("name a cone, or two features"),
            std::string::npos)
      << err_;
  EXPECT_NE(refused(R"({"angle": []})").find("takes a list of two features, or of one cone"),
            std::string::npos)
      << err_;
  EXPECT_NE(refused(R"({"angle": [[0, 15, 10]], "supplement": true})").find("between two features"),
            std::string::npos)
      << err_;
}

TEST_F(DimensionFiles, DrawRowsBesideOverallOnes) {
  ASSERT_EQ(draw(R"(["overall", {"distance": [{"point": [0, 0, 0]}, {"point": [10.5, 0, 0]}],
                    "tolerance": ["+0.1", -0.05], "decimals": 1, "sign": "comma"}])"),
            0)
      << err_;
  const Written drawn = texts();
  for (const char* text : {"10,5", "+0,1", "-0,05"}) {
    EXPECT_EQ(std::ranges::count(drawn, text), 1) << text;
  }
  EXPECT_EQ(drawn.size(), 6U);  // and three of all of it
}

TEST_F(DimensionFiles, SayWhereASmallSheetHasNoRoomForThem) {
  std::string rows = "\"overall\"";
  for (int i = 0; i < 12; ++i) {
    rows += R"(, {"distance": [{"part": "box", "face": [0, 15, 10]}, {"point": [)";
    rows += fmt::format("{}, 0, 0]}}]}}", 10 + 2 * i);
  }
  folder_.write("small.burin.json", fmt::format(R"({{"burin": "illustration", "style": "outline",
    "parts": [{{"file": "box.off", "name": "box"}}], "views": ["front", "top", "iso"],
    "paper": {{"size": [70, 60], "margin": 5}}, "dimensions": [{}]}})",
                                                rows));
  EXPECT_EQ(run("draw @/small.burin.json -o @/a.json"), 2) << err_;
  EXPECT_NE(err_.find("no room for the views with their dimensions"), std::string::npos) << err_;
}

TEST_F(DimensionFiles, AreKeptInAFileThatExtendsTheirs) {
  const std::string row =
      R"([{"distance": [{"face": [0, 15, 10]}, {"face": [40, 15, 10]}], "tolerance": "H7"}])";
  ASSERT_EQ(draw(row), 0) << err_;
  const Written drawn = texts();
  ASSERT_EQ(drawn.size(), 1U);
  ASSERT_EQ(run("illustrate @/a.burin.json -o @/kept.burin.json"), 0) << err_;
  const Json kept = Json::parse(test::slurp(folder_ / "kept.burin.json"));
  const Json& first = kept["dimensions"][0]["distance"][0];
  EXPECT_EQ(first["part"], "/box");
  EXPECT_EQ(first["kept"]["kind"], "plane");
  EXPECT_EQ(first["kept"]["beside"].size(), 4U);
  ASSERT_EQ(run("draw @/kept.burin.json -o @/a.json"), 0) << err_;
  EXPECT_EQ(texts(), drawn);
  // Another number, the same face.
  Json moved = kept;
  moved["dimensions"][0]["distance"][0]["face"] = moved["dimensions"][0]["distance"][1]["face"];
  folder_.write("moved.burin.json", moved.dump());
  ASSERT_EQ(run("draw @/moved.burin.json -o @/a.json"), 0) << err_;
  EXPECT_EQ(texts(), drawn);
  moved["dimensions"][0]["distance"][0]["kept"]["kind"] = "cone";
  folder_.write("lost.burin.json", moved.dump());
  ASSERT_EQ(run("draw @/lost.burin.json -o @/a.json"), 0) << err_;
  EXPECT_EQ(texts(), Written{});
  EXPECT_NE(err_.find("dimension 1 (distance) lost its place and is not drawn"), std::string::npos)
      << err_;
  // Without rows there is nothing to keep.
  ASSERT_EQ(draw(R"("overall")"), 0) << err_;
  EXPECT_EQ(run("illustrate @/a.burin.json -o @/none.burin.json"), 2);
  EXPECT_NE(err_.find("rows of \"dimensions\""), std::string::npos) << err_;
}

}  // namespace
}  // namespace burin
