// Parts cut open, from the command line and from illustration files.
#include "models.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>

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

}  // namespace
}  // namespace burin
