// Dimensions, tolerances and notes that a STEP file carries, from the command line.
#include "models.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>

namespace burin {
namespace {

using Json = nlohmann::json;

class AnnotationsOfFiles : public test::CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    write("bearing.step", "(300.,-500.,0.)", "(1.,0.,0.)");
  }

  /// The sample with a dimension that a saved view shows, at a place, read from the front in
  /// `along`: a line of 50 mm and two triangles.
  void write(const std::string& name, const std::string& place, const std::string& along) {
    std::string text = test::slurp(std::string(BURIN_SOURCE_DIR) + "/samples/pedestal.step");
    const std::size_t face = text.rfind('#', text.find("ADVANCED_FACE"));
    const std::string number = text.substr(face, text.find(' ', face) - face);
    const std::string pmi =
        "#90001=(DRAUGHTING_MODEL()REPRESENTATION('',(#90002,#90003,#90004),#90030));\n"
        "#90030=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#90031))"
        "REPRESENTATION_CONTEXT('',''));\n"
        "#90031=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));\n"
        "#90002=CAMERA_MODEL_D3('Front side',#90020,$);\n"
        "#90003=DRAUGHTING_CALLOUT('Size.1',(#90005));\n"
        "#90004=ANNOTATION_PLANE('',(),#90006,(#90003));\n"
        "#90005=TESSELLATED_ANNOTATION_OCCURRENCE('',(),#90007);\n#90006=PLANE('',#90008);\n"
        "#90007=(GEOMETRIC_REPRESENTATION_ITEM()REPOSITIONED_TESSELLATED_ITEM(#90008)"
        "REPRESENTATION_ITEM('')TESSELLATED_GEOMETRIC_SET((#90009,#90010))TESSELLATED_ITEM());\n"
        "#90008=AXIS2_PLACEMENT_3D('',#90011,#90012,#90013);\n"
        "#90009=TESSELLATED_CURVE_SET('',#90014,((1,2)));\n"
        "#90010=COMPLEX_TRIANGULATED_SURFACE_SET('',#90014,4,((0.,0.,1.)),(),((1,2,4,3)),());\n"
        "#90011=CARTESIAN_POINT('',WHERE);\n#90012=DIRECTION('',(0.,-1.,0.));\n"
        "#90013=DIRECTION('',THE_WAY);\n"
        "#90014=COORDINATES_LIST('',4,((0.,0.,0.),(50.,0.,0.),(50.,20.,0.),(0.,20.,0.)));\n"
        "#90020=AXIS2_PLACEMENT_3D('',#90021,#90022,#90023);\n"
        "#90021=CARTESIAN_POINT('',(0.,-900.,0.));\n#90022=DIRECTION('',(0.,1.,0.));\n"
        "#90023=DIRECTION('',(-1.,0.,0.));\n"
        "#90040=SHAPE_ASPECT('','',#4,.T.);\n"
        "#90041=GEOMETRIC_ITEM_SPECIFIC_USAGE('','',#90040,#90030,THE_FACE);\n"
        "#90042=DIMENSIONAL_SIZE(#90040,'diameter');\n"
        "#90043=DIMENSIONAL_CHARACTERISTIC_REPRESENTATION(#90042,#90044);\n"
        "#90044=SHAPE_DIMENSION_REPRESENTATION('',(#90045),#90030);\n"
        "#90045=(LENGTH_MEASURE_WITH_UNIT()MEASURE_REPRESENTATION_ITEM()MEASURE_WITH_UNIT("
        "LENGTH_MEASURE(35.),#90031)REPRESENTATION_ITEM('nominal value'));\n"
        "#90046=DRAUGHTING_MODEL_ITEM_ASSOCIATION('','',#90042,#90001,#90003);\n"
        "#90047=FLATNESS_TOLERANCE('Flat.1','',#90045,#90040);\n";
    text.insert(text.rfind("ENDSEC;"), pmi);
    replace(text, "WHERE", place);
    replace(text, "THE_WAY", along);
    replace(text, "THE_FACE)", number + ")");
    folder_.write(name, text);
  }
  static void replace(std::string& text, const std::string& what, const std::string& by) {
    text.replace(text.rfind(what), what.size(), by);
  }

  int draw(const std::string& options, const std::string& file = "bearing.step") {
    return run("draw @/" + file + " --style outline -o @/a.json " + options);
  }
  Json drawing() const { return Json::parse(test::slurp(folder_ / "a.json")); }
  Json paths() const {
    const Json all = drawing();
    for (const Json& layer : all.at("layers")) {
      if (layer.at("name") == "pmi") return layer.at("paths");
    }
    return Json::array();
  }
};

TEST_F(AnnotationsOfFiles, AreDrawnWhereTheyFaceTheViewer) {
  ASSERT_EQ(draw("--view front"), 0) << err_;
  EXPECT_TRUE(paths().empty());
  ASSERT_EQ(draw("--view front --pmi"), 0) << err_;
  const Json lines = paths();
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0].at("points3")[1], (Json{350, -500, 0}));
  EXPECT_EQ(lines[0].at("width")[0], 0.18);
  EXPECT_EQ(lines[0].at("part"), 0);
  EXPECT_EQ(lines[0].at("face"), 0);
  EXPECT_EQ(lines[1].at("points").size(), 4U);
  ASSERT_EQ(drawing().at("areas").size(), 1U);
  EXPECT_EQ(drawing().at("areas")[0].at("role"), "pmi");
  // The tolerance has no lines.
  EXPECT_NE(err_.find("flatness 35"), std::string::npos) << err_;
  for (const char* view : {"back", "top", "left"}) {
    ASSERT_EQ(draw(std::string("--pmi --view ") + view), 0);
    EXPECT_TRUE(paths().empty()) << view;
    EXPECT_NE(err_.find("saved-view Front side"), std::string::npos) << err_;
  }
}

TEST_F(AnnotationsOfFiles, RunOverBreaksOrAreLeftOut) {
  write("over.step", "(-25.,-500.,20.)", "(1.,0.,0.)");  // from -25 to 25
  const std::string view = "--view front --pmi --scale 1 --break-view ";
  ASSERT_EQ(draw(view + "x:-15..15", "over.step"), 0) << err_;
  const Json line = paths().at(0).at("points");
  EXPECT_NEAR(line[1][0].get<double>() - line[0][0].get<double>(), 50 - 30 + 4, 1e-3);
  EXPECT_EQ(err_.find("are not drawn (1)"), std::string::npos) << err_;
  // Letters stay as they are.
  const Json letters = drawing().at("areas")[0].at("rings")[0];
  EXPECT_NEAR(letters[1][0].get<double>() - letters[0][0].get<double>(), 50, 1e-3);
  ASSERT_EQ(draw(view + "x:10..40", "over.step"), 0) << err_;
  EXPECT_TRUE(paths().empty());
  EXPECT_NE(err_.find("what a break leaves out are not drawn (1)"), std::string::npos) << err_;
}

TEST_F(AnnotationsOfFiles, AreMissedInTheViewThatIsNamed) {
  ASSERT_EQ(draw("--views front,top --pmi"), 0) << err_;
  EXPECT_NE(err_.find("view top: annotations seen from behind"), std::string::npos) << err_;
  EXPECT_EQ(err_.find("view front: annotations"), std::string::npos) << err_;
}

TEST_F(AnnotationsOfFiles, AreNotDrawnUpsideDownOrBehindParts) {
  write("turned.step", "(300.,-500.,0.)", "(-1.,0.,0.)");
  ASSERT_EQ(draw("--view front --pmi", "turned.step"), 0) << err_;
  EXPECT_TRUE(paths().empty());
  EXPECT_NE(err_.find("upside down"), std::string::npos) << err_;
  write("behind.step", "(-25.,500.,5.)", "(1.,0.,0.)");
  ASSERT_EQ(draw("--view front --pmi", "behind.step"), 0) << err_;
  EXPECT_TRUE(paths().empty());
  EXPECT_NE(err_.find("behind parts"), std::string::npos) << err_;
}

TEST_F(AnnotationsOfFiles, HaveRoomOnTheSheet) {
  for (const char* options : {"--view front", "--view iso", "--paper fit --margin 5"}) {
    ASSERT_EQ(draw(std::string("--pmi ") + options), 0) << err_;
    const Json sheet = drawing();
    const double width = sheet.at("paper").at("width"), height = sheet.at("paper").at("height");
    ASSERT_FALSE(paths().empty()) << options;
    const Json lines = paths();
    for (const Json& path : lines) {
      for (const Json& point : path.at("points")) {
        EXPECT_TRUE(point[0] >= 0 && point[0] <= width && point[1] >= 0 && point[1] <= height);
      }
    }
  }
}

/// An annotation below the part, as high as letters are, and dimensions of the whole.
TEST_F(AnnotationsOfFiles, HaveDimensionsOutsideOfThem) {
  write("below.step", "(-25.,-500.,-40.)", "(1.,0.,0.)");
  ASSERT_EQ(draw("--view front --pmi --dimensions overall", "below.step"), 0) << err_;
  double low = 1e9, high = -1e9;
  const Json lines = paths();
  ASSERT_FALSE(lines.empty());
  for (const Json& path : lines) {
    for (const Json& point : path.at("points")) {
      low = std::min(low, point[1].get<double>());
      high = std::max(high, point[1].get<double>());
    }
  }
  const Json all = drawing();
  const auto layer = std::ranges::find_if(
      all.at("layers"), [](const Json& one) { return one.at("name") == "dimensions"; });
  ASSERT_NE(layer, all.at("layers").end());
  ASSERT_EQ(layer->at("texts").size(), 2U);
  int begin_at_part = 0, below = 0;
  for (const Json& path : layer->at("paths")) {
    const Json &a = path.at("points")[0], &b = path.at("points")[1];
    const double top = std::max(a[1].get<double>(), b[1].get<double>());
    if (a[0] == b[0] && std::min(a[1].get<double>(), b[1].get<double>()) < low) {
      begin_at_part += top > high;
    }
    below += a[1] == b[1] && top < low;
  }
  EXPECT_EQ(begin_at_part, 2);  // both extension lines of the width
  EXPECT_GE(below, 1);          // and its line
}

TEST_F(AnnotationsOfFiles, ComeWithTheViewThatShowsThem) {
  ASSERT_EQ(run_words({"draw", folder_ / "bearing.step", "--style", "outline", "--paper", "A6",
                       "--saved-view", "Front side", "-o", folder_ / "a.json"},
                      ""),
            0)
      << err_;
  EXPECT_EQ(paths().size(), 2U);
  EXPECT_EQ(drawing().at("view").at("direction"), (Json{0, -1, 0}));
  EXPECT_EQ(run_words({"draw", folder_ / "bearing.step", "--saved-view", "Front side", "--view",
                       "front", "-o", folder_ / "a.json"},
                      ""),
            2);
  expect_error("--saved-view and --view both say where the drawing is seen from");
  EXPECT_EQ(draw("--saved-view Back"), 2);
  expect_error("the file has Front side");
  EXPECT_EQ(run("draw @/box.off --saved-view Back -o @/a.json"), 2);
}

TEST_F(AnnotationsOfFiles, HaveKeysOfStyles) {
  ASSERT_EQ(draw("--view front --pmi --set pmi.line=0.3 --set pmi.color=#aa0000"), 0) << err_;
  EXPECT_EQ(paths()[0].at("width")[0], 0.3);
  EXPECT_EQ(paths()[1].at("width")[0], 0.15);
  EXPECT_EQ(drawing().at("areas")[0].at("fill"), "#aa0000");
  ASSERT_EQ(draw("--view iso --pmi --set pmi.angle=50"), 0) << err_;
  EXPECT_TRUE(paths().empty());
}

TEST_F(AnnotationsOfFiles, AreListedByInfo) {
  ASSERT_EQ(run("info @/bearing.step"), 0) << err_;
  EXPECT_NE(out_.find("pmi         1 dimension, 1 tolerance; view Front side"), std::string::npos)
      << out_;
  EXPECT_NE(out_.find("dimension   ⌀ 35  face 0"), std::string::npos) << out_;
  EXPECT_NE(out_.find("flatness 35  face 0  (not shown in the file)"), std::string::npos) << out_;
  ASSERT_EQ(run("info @/bearing.step --json"), 0) << err_;
  const Json pmi = Json::parse(out_).at("files")[0].at("parts")[0].at("pmi");
  EXPECT_EQ(pmi.at("items")[0].at("value"), 35);
  EXPECT_EQ(pmi.at("items")[0].at("shown"), true);
  EXPECT_EQ(pmi.at("views")[0].at("direction"), (Json{0, -1, 0}));
}

TEST_F(AnnotationsOfFiles, AreMissedWhereThereAreNone) {
  const std::string sample = std::string(BURIN_SOURCE_DIR) + "/samples/pedestal.step";
  ASSERT_EQ(run("draw " + sample + " --style outline --pmi -o @/a.json"), 0) << err_;
  EXPECT_NE(err_.find("carries no dimensions"), std::string::npos) << err_;
  EXPECT_EQ(std::count(err_.begin(), err_.end(), '\n'), 1) << err_;
  ASSERT_EQ(run("draw @/box.off --pmi -o @/a.json"), 0) << err_;
  EXPECT_NE(err_.find("--pmi"), std::string::npos) << err_;
}

TEST_F(AnnotationsOfFiles, AreAKeyOfPartsOfIllustrations) {
  folder_.write("a.burin.json",
                R"({"burin": "illustration", "style": "outline", "view": {"from": "front"},
                    "parts": [{"file": "bearing.step", "pmi": true,
                               "place": {"translate": [0, 0, 100]}}]})");
  ASSERT_EQ(run("draw @/a.burin.json -o @/a.json"), 0) << err_;
  ASSERT_EQ(paths().size(), 2U);
  EXPECT_EQ(paths()[0].at("points3")[0], (Json{300, -500, 100}));
}

}  // namespace
}  // namespace burin
