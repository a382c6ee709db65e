// Centre lines, from the command line and by keys of styles.
#include "models.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>
#include <string>

namespace burin {
namespace {

using Json = nlohmann::json;

class CentreLinesOfDrawings : public test::CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    // A flange with a bore of 20 mm and six holes on a circle of 60 mm.
    std::string holes;
    for (int i = 0; i < 6; ++i) {
      const double angle = 0.2 + i * std::numbers::pi / 3;
      holes += fmt::format(
          "multmatrix([[1,0,0,{}],[0,1,0,{}],[0,0,1,-1],[0,0,0,1]]) "
          "cylinder($fn=32, h=12, r1=3, r2=3, center=false);\n",
          30 * std::cos(angle), 30 * std::sin(angle));
    }
    folder_.write("flange.csg",
                  "difference() {\n"
                  "cylinder($fn=96, h=10, r1=40, r2=40, center=false);\n"
                  "multmatrix([[1,0,0,0],[0,1,0,0],[0,0,1,-1],[0,0,0,1]]) "
                  "cylinder($fn=48, h=12, r1=10, r2=10, center=false);\n" +
                      holes + "}\n");
  }
  int draw(const std::string& options) {
    return run("draw @/flange.csg --style outline -o @/a.json " + options);
  }
  Json paths() {
    const Json drawing = Json::parse(test::slurp(folder_ / "a.json"));
    for (const Json& l : drawing.at("layers")) {
      if (l.at("name") == "centre") return l.at("paths");
    }
    return Json::array();
  }
};

TEST_F(CentreLinesOfDrawings, MarkTheBoreAndHaveAPitchCircle) {
  ASSERT_EQ(draw("--view top --centre-lines auto --verify"), 0) << err_;
  int circles = 0, through_middle = 0, towards_middle = 0;
  for (const Json& path : paths()) {
    EXPECT_EQ(path.at("kind"), "centre");
    EXPECT_EQ(path.at("width")[0], 0.18);
    const Json& p = path.at("points3");
    if (path.at("closed")) {
      ++circles;
      for (const Json& q : p) {
        EXPECT_NEAR(std::hypot(q[0].get<double>(), q[1].get<double>()), 30, 0.02);
      }
      continue;
    }
    const double x = 0.5 * (p[0][0].get<double>() + p[1][0].get<double>());
    const double y = 0.5 * (p[0][1].get<double>() + p[1][1].get<double>());
    const double out = std::hypot(x, y);
    through_middle += out < 1e-3 ? 1 : 0;
    towards_middle += std::abs(out - 30) < 1e-3 ? 1 : 0;
  }
  EXPECT_EQ(circles, 1);
  EXPECT_EQ(through_middle, 2);
  EXPECT_EQ(towards_middle, 6);
}

TEST_F(CentreLinesOfDrawings, OfHiddenHolesComeWithHiddenLines) {
  ASSERT_EQ(draw("--view front --centre-lines auto"), 0) << err_;
  EXPECT_EQ(paths().size(), 1U);
  ASSERT_EQ(draw("--view front --centre-lines auto --hidden dashed"), 0) << err_;
  EXPECT_EQ(paths().size(), 7U);
}

TEST_F(CentreLinesOfDrawings, RunThroughHolesThatASectionOpens) {
  // Along the axis of the first hole, of which half is left.
  ASSERT_EQ(
      draw(fmt::format("--view front --section y={} --centre-lines auto", 30 * std::sin(0.2))), 0)
      << err_;
  const Json lines = paths();
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_NEAR(lines[0].at("points3")[0][0].get<double>(), 30 * std::cos(0.2), 1e-3);
}

TEST_F(CentreLinesOfDrawings, RunOverCutFaces) {
  for (const char* solid : {"cylinder($fn=48, h=30, r1=10, r2=10, center=false);",
                            "cylinder($fn=48, h=30, r1=10, r2=0, center=false);"}) {
    folder_.write("solid.csg", solid);
    ASSERT_EQ(run("draw @/solid.csg --style outline --view front --section y=0 -o @/a.json "
                  "--centre-lines auto"),
              0)
        << err_;
    const Json lines = paths();
    ASSERT_EQ(lines.size(), 1U) << solid;
    EXPECT_NEAR(lines[0].at("points3")[0][0].get<double>(), 0, 1e-6);
  }
}

TEST_F(CentreLinesOfDrawings, HoldForPartsInStylesOfTheirOwn) {
  ASSERT_EQ(draw("--view top --centre-lines auto --look *=pencil"), 0) << err_;
  EXPECT_FALSE(paths().empty());
}

TEST_F(CentreLinesOfDrawings, AreThereWhereTheyAreAskedForAlone) {
  ASSERT_EQ(draw("--view top"), 0) << err_;
  EXPECT_TRUE(paths().empty());
  ASSERT_EQ(draw("--view top --set feature.centre_lines=true --set line.centre=0.25"), 0) << err_;
  ASSERT_FALSE(paths().empty());
  EXPECT_EQ(paths()[0].at("width")[0], 0.25);
  ASSERT_EQ(draw("--view top --set feature.centre_lines=true --centre-lines none"), 0) << err_;
  EXPECT_TRUE(paths().empty());
  EXPECT_EQ(draw("--centre-lines maybe"), 2);
  EXPECT_NE(err_.find("none or auto"), std::string::npos) << err_;
  ASSERT_EQ(draw("--set line.centre_over=3"), 0);
  EXPECT_NE(err_.find("feature.centre_lines=true"), std::string::npos) << err_;
}

TEST_F(CentreLinesOfDrawings, StayOnTheSheet) {
  for (const char* options :
       {"--margin 0", "--paper fit --margin 0", "--margin 0 --perspective 30"}) {
    ASSERT_EQ(draw(std::string("--view top --centre-lines auto ") + options), 0) << err_;
    EXPECT_EQ(err_, "") << options;
    EXPECT_FALSE(paths().empty());
  }
}

TEST_F(CentreLinesOfDrawings, AreAKeyOfIllustrations) {
  folder_.write("a.burin.json",
                R"({"burin": "illustration", "parts": [{"file": "flange.csg"}], "style": "outline",
                    "view": {"from": "top"}, "centre_lines": "auto"})");
  ASSERT_EQ(run("draw @/a.burin.json -o @/a.json"), 0) << err_;
  EXPECT_FALSE(paths().empty());
  ASSERT_EQ(run("illustrate @/flange.csg --centre-lines auto -o @/b.burin.json"), 0) << err_;
  EXPECT_EQ(Json::parse(test::slurp(folder_ / "b.burin.json")).at("centre_lines"), "auto");
}

TEST_F(CentreLinesOfDrawings, HaveTheirOwnLineType) {
  ASSERT_EQ(run("draw @/flange.csg --style outline --view top --centre-lines auto -o @/a.dxf "
                "-o @/a.svg"),
            0)
      << err_;
  EXPECT_NE(test::slurp(folder_ / "a.dxf").find("\ncentre\n70\n0\n62\n7\n6\nACAD_ISO04W100\n"),
            std::string::npos);
  const std::string svg = test::slurp(folder_ / "a.svg");
  EXPECT_NE(svg.find("id=\"centre\""), std::string::npos);
  EXPECT_NE(svg.find("stroke-dasharray", svg.find("id=\"centre\"")), std::string::npos);
}

}  // namespace
}  // namespace burin
