// Notes, from the command line, in illustration files and in OpenSCAD programs.
#include "models.h"

#include <nlohmann/json.hpp>

#include <string>

namespace burin {
namespace {

using Json = nlohmann::json;

class NotesOfDrawings : public test::CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    folder_.write("box.csg", "cube(size = [40, 20, 10], center = false);\n");
  }
  Json layer() {
    const Json drawing = Json::parse(test::slurp(folder_ / "a.json"));
    for (const Json& one : drawing.at("layers")) {
      if (one.at("name") == "notes") return one;
    }
    return {{"paths", Json::array()}, {"texts", Json::array()}};
  }
  std::string illustration(const std::string& rows) {
    return R"({"burin": "illustration", "version": 1, "parts": [{"file": "box.csg"}],
"style": "outline", "view": {"from": "iso"}, "paper": "a4",
"notes": [)" +
           rows + "]}";
  }
  std::string refused(const std::string& rows) { return refused_illustration(illustration(rows)); }
};

TEST_F(NotesOfDrawings, AreWordsWithALeaderToTheirPart) {
  ASSERT_EQ(run("draw @/box.csg --note box=Oil\\nbefore -o @/a.json -o @/a.svg"), 0) << err_;
  const Json notes = layer();
  ASSERT_EQ(notes.at("texts").size(), 2U);
  EXPECT_EQ(notes.at("texts")[0].at("text"), "Oil");
  EXPECT_EQ(notes.at("texts")[0].at("role"), "note");
  EXPECT_EQ(notes.at("paths")[0].at("part"), 0);
  EXPECT_NE(test::slurp(folder_ / "a.svg").find(">before<"), std::string::npos);
  // The sheet keeps room for it.
  for (const Json& text : notes.at("texts")) {
    EXPECT_GT(text.at("at")[0].get<double>(), 0);
    EXPECT_LT(text.at("at")[0].get<double>(), 297);
  }
}

TEST_F(NotesOfDrawings, OfAnIllustrationHaveFramesMarksAndPlaces) {
  folder_.write("a.burin.json", illustration(R"({"at": [[20, 0, 5], {"point": [40, 20, 10]}],
    "text": "{area} mm2", "frame": true, "mark": "arrow"},
    {"text": "ISO 2768-m", "place": [20, 15]}, "box=v = {volume}")"));
  ASSERT_EQ(run("draw @/a.burin.json -o @/a.json"), 0) << err_;
  const Json notes = layer();
  ASSERT_EQ(notes.at("texts").size(), 3U);
  EXPECT_EQ(notes.at("texts")[0].at("text"), "400 mm2");
  EXPECT_EQ(notes.at("texts")[1].at("text"), "ISO 2768-m");
  EXPECT_NEAR(notes.at("texts")[1].at("at")[0].get<double>(), 20, 2);
  EXPECT_NEAR(notes.at("texts")[1].at("at")[1].get<double>(), 15, 2);
  EXPECT_EQ(notes.at("texts")[2].at("text"), "v = 8000");
}

TEST_F(NotesOfDrawings, KeepTheirFacesInChangedModels) {
  folder_.write("a.burin.json", illustration(R"({"at": [20, 0, 5], "text": "front"})"));
  ASSERT_EQ(run("illustrate @/a.burin.json -o @/kept.burin.json"), 0) << err_;
  const Json kept = Json::parse(test::slurp(folder_ / "kept.burin.json"));
  EXPECT_EQ(kept["notes"][0]["at"]["kept"]["kind"], "plane");
  EXPECT_FALSE(kept.contains("dimensions"));
  EXPECT_EQ(run("draw @/kept.burin.json -o @/a.json"), 0) << err_;
  EXPECT_EQ(layer().at("texts").size(), 1U);
}

TEST_F(NotesOfDrawings, OfAProgramStandAtItsParts) {
  folder_.write("burin.scad",
                test::slurp(std::string(BURIN_SOURCE_DIR) + "/samples/openscad/burin.scad"));
  folder_.write("a.scad",
                "use <burin.scad>\npart(\"lid\") note(\"{part.name}!\") cube(9);\n"
                "note(\"base\") part(\"base\") translate([20,0,0]) cube(9);\n");
  ASSERT_EQ(run("draw @/a.scad -o @/a.json"), 0) << err_;
  const Json notes = layer();
  ASSERT_EQ(notes.at("texts").size(), 2U);
  EXPECT_EQ(notes.at("texts")[0].at("text"), "lid!");
  EXPECT_EQ(notes.at("texts")[1].at("text"), "base");
}

class ArrowsOfDrawings : public NotesOfDrawings {
 protected:
  std::string with_arrows(const std::string& rows) {
    return R"({"burin": "illustration", "version": 1, "parts": [{"file": "box.csg"}],
"view": {"from": "iso"},
"arrows": )" +
           rows + "}";
  }
  std::vector<std::string> parts() {
    std::vector<std::string> names;
    const Json drawing = Json::parse(test::slurp(folder_ / "a.json"));
    for (const Json& part : drawing.at("parts")) names.push_back(part.at("name"));
    return names;
  }
  std::string refused_arrow(const std::string& row) {
    return refused_illustration(with_arrows(row));
  }
};

TEST_F(ArrowsOfDrawings, ComeFromTheCommandTheFileAndTheProgram) {
  using Names = std::vector<std::string>;
  ASSERT_EQ(run("draw @/box.csg --arrow box=0,0,1 -o @/a.json"), 0) << err_;
  EXPECT_EQ(parts(), (Names{"box", "arrow 1"}));
  folder_.write("a.burin.json", with_arrows(R"(["box=1,0,0",
    {"at": "box", "about": [0, 0, 1], "degrees": -180, "color": "orange"},
    {"from": [0, 0, 20], "to": [40, 0, 20], "width": 3}])"));
  ASSERT_EQ(run("draw @/a.burin.json -o @/a.json"), 0) << err_;
  EXPECT_EQ(parts(), (Names{"box", "arrow 1", "arrow 2", "arrow 3"}));
  bool orange = false;
  const Json drawing = Json::parse(test::slurp(folder_ / "a.json"));
  for (const Json& area : drawing.at("areas")) orange |= !area.value("fill", "").empty();
  EXPECT_TRUE(orange);
  folder_.write("burin.scad",
                test::slurp(std::string(BURIN_SOURCE_DIR) + "/samples/openscad/burin.scad"));
  folder_.write("a.scad", "use <burin.scad>\nrotate([90,0,0]) arrow([0,0,1]) cube(9);\n");
  ASSERT_EQ(run("draw @/a.scad -o @/a.json"), 0) << err_;
  EXPECT_EQ(parts(), (Names{"a", "arrow 1"}));
  ASSERT_EQ(run("draw @/box.csg --arrows steps -o @/a.json"), 0);
  EXPECT_NE(err_.find("--arrows has no effect without option --explode"), std::string::npos)
      << err_;
}

TEST_F(ArrowsOfDrawings, SayInOneLineWhatIsWrong) {
  EXPECT_NE(refused_arrow(R"({"at": "box"})").find("\"along\""), std::string::npos);
  EXPECT_NE(refused_arrow(R"({"along": [0, 0, 1]})").find("\"at\""), std::string::npos);
  EXPECT_NE(refused_arrow(R"({"at": "lid", "along": [0, 0, 1]})").find("'lid'"), std::string::npos);
  EXPECT_NE(refused_arrow(R"({"at": "box", "about": [0, 0, 1], "degrees": 400})").find("340"),
            std::string::npos);
  EXPECT_NE(refused_arrow(R"({"from": [0, 0, 1], "to": [0, 0, 1]})").find("two points"),
            std::string::npos);
  EXPECT_NE(refused_arrow(R"({"at": "box", "along": [0, 0, 1], "color": "bleu"})").find("bleu"),
            std::string::npos);
  EXPECT_NE(refused_arrow(R"("all")").find("steps"), std::string::npos);
  EXPECT_EQ(run("draw @/box.csg --arrow box=up -o @/a.json"), 2);
}

TEST_F(NotesOfDrawings, SayInOneLineWhatIsWrong) {
  EXPECT_NE(refused(R"({"at": "box"})").find("a note has \"text\""), std::string::npos);
  EXPECT_NE(refused(R"({"text": "a"})").find("\"at\""), std::string::npos);
  EXPECT_NE(refused(R"({"at": "lid", "text": "a"})").find("no part is named 'lid'"),
            std::string::npos);
  EXPECT_NE(refused(R"({"at": "box", "text": "{mass}"})").find("{mass}"), std::string::npos);
  EXPECT_NE(refused(R"({"at": "box", "text": "a", "mark": "cross"})").find("dot"),
            std::string::npos);
  EXPECT_NE(refused(R"({"at": [], "text": "a"})").find("names nothing"), std::string::npos);
  EXPECT_EQ(run("draw @/box.csg --note box -o @/a.json"), 2);
  EXPECT_EQ(run("draw @/box.csg --note box={radius} -o @/a.json"), 2);
  EXPECT_NE(err_.find("has no {radius}"), std::string::npos) << err_;
}

}  // namespace
}  // namespace burin
