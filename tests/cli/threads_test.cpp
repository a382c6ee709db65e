// Threads, from the command line and in illustration files.
#include "models.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <string>

namespace burin {
namespace {

using Json = nlohmann::json;

class ThreadsOfDrawings : public test::CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    // A screw of 6 mm along z.
    folder_.write("screw.csg",
                  "group() { cylinder($fn=48, h=30, r1=3, r2=3, center=false);\n"
                  "multmatrix([[1,0,0,0],[0,1,0,0],[0,0,1,30],[0,0,0,1]])\n"
                  "cylinder($fn=6, h=4, r1=5.8, r2=5.8, center=false); }\n");
  }
  Json paths(const std::string& file = "a.json") {
    const Json drawing = Json::parse(test::slurp(folder_ / file));
    for (const Json& l : drawing.at("layers")) {
      if (l.at("name") == "thread") return l.at("paths");
    }
    return Json::array();
  }
  std::string illustration(const std::string& rows) {
    return R"({"burin": "illustration", "version": 1, "parts": [{"file": "screw.csg"}],
"style": "outline", "view": {"from": "front"}, "paper": "a4",
"threads": [)" +
           rows + "]}";
  }
  /// What an illustration with these rows is refused with.
  std::string refused(const std::string& rows) { return refused_illustration(illustration(rows)); }
};

TEST_F(ThreadsOfDrawings, AreALayerOfThinLinesAtTheMinorDiameter) {
  ASSERT_EQ(run("draw @/screw.csg --style outline --view front --thread screw=M6 -o @/a.json"), 0)
      << err_;
  const Json lines = paths();
  ASSERT_EQ(lines.size(), 2U);
  for (const Json& line : lines) {
    EXPECT_EQ(line.at("kind"), "thread");
    EXPECT_EQ(line.at("width")[0], 0.18);
    EXPECT_EQ(line.at("part"), 0);
    // ISO 724: 4.917 mm, in a file of three places.
    for (const Json& p : line.at("points3")) {
      EXPECT_NEAR(std::abs(p[0].get<double>()), 0.5 * 4.917, 1e-3);
    }
  }
}

TEST_F(ThreadsOfDrawings, HaveStyleKeys) {
  const std::string draw = "draw @/screw.csg --style outline --view front --thread screw=M6 ";
  ASSERT_EQ(run(draw + "--set line.thread=0.1 -o @/a.json"), 0) << err_;
  EXPECT_EQ(paths()[0].at("width")[0], 0.1);
  ASSERT_EQ(run(draw + "--set feature.threads=false -o @/a.json"), 0) << err_;
  EXPECT_TRUE(paths().empty());
  EXPECT_NE(err_.find("--thread has no effect"), std::string::npos) << err_;
}

TEST_F(ThreadsOfDrawings, OfIllustrationsAreTheSameForAnyNumberOfProcessors) {
  folder_.write("s.burin.json",
                illustration(R"({"select": "screw", "size": "M6", "length": 18, "start": 2})"));
  std::string first;
  for (const char* threads : {"1", "2", "3"}) {
    ASSERT_EQ(run(fmt::format("draw @/s.burin.json -o @/a.json --threads {}", threads)), 0) << err_;
    const std::string text = test::slurp(folder_ / "a.json");
    if (first.empty()) first = text;
    EXPECT_EQ(text, first);
  }
  int thin = 0, wide = 0;
  for (const Json& line : paths()) {
    double low = 1e9, high = -1e9;
    for (const Json& p : line.at("points3")) {
      low = std::min(low, p[2].get<double>());
      high = std::max(high, p[2].get<double>());
    }
    const bool end = line.at("kind") == "thread-end";
    (end ? wide : thin) += 1;
    if (end) {
      EXPECT_NEAR(std::min(std::abs(low - 2), std::abs(low - 20)), 0, 1e-3);
    } else {
      EXPECT_NEAR(low, 2, 1e-3);
      EXPECT_NEAR(high, 20, 1e-3);
    }
  }
  EXPECT_EQ(thin, 2);
  EXPECT_EQ(wide, 2);
}

TEST_F(ThreadsOfDrawings, AreRefusedInOneLineWhereTheySayNothing) {
  EXPECT_NE(refused(R"({"select": "screw"})").find("a thread has a size"), std::string::npos);
  EXPECT_NE(refused(R"({"size": "M6"})").find("\"select\""), std::string::npos);
  EXPECT_NE(refused(R"({"select": "scew", "size": "M6"})").find("'screw'"), std::string::npos);
  EXPECT_NE(refused(R"({"select": "screw", "size": "M6x30"})").find("too long"), std::string::npos);
  EXPECT_NE(refused(R"({"select": "screw", "size": "6"})").find("is no size"), std::string::npos);
  EXPECT_NE(refused(R"({"select": "screw", "size": "M6", "length": -3})").find("over 0"),
            std::string::npos);
  EXPECT_NE(refused(R"({"select": "screw", "face": 1.5})").find("whole number"), std::string::npos);
  EXPECT_NE(refused(R"({"select": "screw", "size": "M6", "legnth": 3})").find("length"),
            std::string::npos);
  EXPECT_NE(refused(R"("screw M6")").find("NAME=SIZE"), std::string::npos);
}

TEST_F(ThreadsOfDrawings, ThatNoCylinderFitsAreToldOf) {
  ASSERT_EQ(run("draw @/screw.csg --style outline --thread screw=M8 -o @/a.json"), 0) << err_;
  EXPECT_NE(err_.find("thread 'M8' is not drawn: 'screw': it has no shaft of 8 mm"),
            std::string::npos)
      << err_;
}

}  // namespace
}  // namespace burin
