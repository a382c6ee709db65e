// Views of long parts with stretches left out, from the command line and from illustration files.
#include "models.h"

#include <nlohmann/json.hpp>

#include <string>
#include <utility>
#include <vector>

namespace burin {
namespace {

using Json = nlohmann::json;

class BrokenViewsOfCommand : public test::CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    folder_.write("bar.off", test::off_text(test::box({0, 0, 0}, {400, 20, 20})));
  }
  Json drawing() { return Json::parse(test::slurp(folder_ / "a.json")); }
  static const Json* layer(const Json& drawing, const std::string& name) {
    for (const Json& l : drawing.at("layers")) {
      if (l.at("name") == name) return &l;
    }
    return nullptr;
  }
  static Box2 extent(const Json& drawing) {
    Box2 box;
    for (const Json& l : drawing.at("layers")) {
      for (const Json& path : l.at("paths")) {
        if (path.at("kind") == "frame") continue;
        for (const Json& p : path.at("points"))
          box.add(Vec2(p[0].get<double>(), p[1].get<double>()));
      }
    }
    return box;
  }
};

TEST_F(BrokenViewsOfCommand, LeaveAStretchOut) {
  const std::string draw = "draw @/bar.off --view front --scale 1 -o @/a.json ";
  ASSERT_EQ(run(draw + "--break-view x:50..350 --dimensions overall"), 0) << err_;
  EXPECT_EQ(err_.find("break"), std::string::npos) << err_;
  Json now = drawing();
  EXPECT_NEAR(extent(now).size().x, 104, 1e-3);
  ASSERT_NE(layer(now, "breaks"), nullptr);
  EXPECT_EQ(layer(now, "breaks")->at("paths").size(), 2U);
  const Json& breaks = now.at("view").at("breaks");
  EXPECT_EQ(breaks.at("bands").size(), 1U);
  EXPECT_EQ(breaks.at("gap"), 4);
  bool true_length = false;
  for (const Json& text : layer(now, "dimensions")->at("texts")) {
    true_length = true_length || text.at("text") == "400";
  }
  EXPECT_TRUE(true_length);
  // Each place is where the numbers of the view have it.
  const Json& view = now.at("view");
  const auto vec = [](const Json& v) { return Vec3(v[0], v[1], v.size() > 2 ? double(v[2]) : 0); };
  const double low = breaks.at("bands")[0][0], high = breaks.at("bands")[0][1];
  for (const Json& l : now.at("layers")) {
    for (const Json& path : l.at("paths")) {
      if (path.at("kind") == "frame") continue;
      for (std::size_t i = 0; i < path.at("points").size(); ++i) {
        const Vec3 q = vec(path.at("points3")[i]) - vec(view.at("center"));
        const Vec2 whole = double(view.at("scale")) * Vec2(glm::dot(q, vec(view.at("right"))),
                                                           glm::dot(q, vec(view.at("up")))) +
                           Vec2(vec(view.at("offset")));
        const Vec2 along(vec(breaks.at("along")));
        const bool beyond = glm::dot(along, whole) > 0.5 * (low + high);
        const Vec2 at = whole + Vec2(vec(breaks.at("offset"))) +
                        (beyond ? double(breaks.at("gap")) - (high - low) : 0.0) * along;
        EXPECT_LT(glm::distance(at, Vec2(vec(path.at("points")[i]))), 1e-3);
      }
    }
  }
  // A drawing file is read as it was written.
  ASSERT_EQ(run("convert @/a.json -o @/b.json"), 0) << err_;
  EXPECT_EQ(Json::parse(test::slurp(folder_ / "b.json")).at("view"), now.at("view"));
  ASSERT_EQ(run(draw + "--break-view x:50..350 --set break.gap=10 --set break.line=freehand"), 0);
  EXPECT_NEAR(extent(drawing()).size().x, 110, 1e-3);
  ASSERT_EQ(run(draw + "--break-view x:50..150 --break-view x:200..350"), 0) << err_;
  EXPECT_NEAR(extent(drawing()).size().x, 158, 1e-3);
  for (const char* found : {"auto", "x"}) {
    ASSERT_EQ(run(draw + "--break-view " + found), 0) << err_;
    EXPECT_NEAR(extent(drawing()).size().x, 64, 1e-3) << found;
  }
}

TEST_F(BrokenViewsOfCommand, StandInIllustrationFiles) {
  const auto drawn = [&](const std::string& breaks) {
    folder_.write("a.burin.json", R"({"burin": "illustration", "version": 1,
 "parts": [{"file": "bar.off"}], "view": {"from": "front", "scale": 1},
 "breaks": )" + breaks + "}");
    return run("draw @/a.burin.json -o @/a.json");
  };
  for (const char* breaks :
       {R"("x:50..350")", R"(["x:50..350"])", R"([{"axis": "x", "from": 50, "to": 350}])",
        R"({"axis": [1, 0, 0], "from": 50, "to": 350})"}) {
    ASSERT_EQ(drawn(breaks), 0) << err_;
    EXPECT_NEAR(extent(drawing()).size().x, 104, 1e-3) << breaks;
  }
  ASSERT_EQ(run("illustrate @/bar.off --view front --break-view x:50..350 -o @/s.burin.json"), 0)
      << err_;
  EXPECT_EQ(Json::parse(test::slurp(folder_ / "s.burin.json")).at("breaks"),
            Json::array({"x:50..350"}));
  const std::vector<std::pair<std::string, std::string>> wrong = {
      {R"("x:350..50")", "FROM below TO"},
      {R"(7)", "breaks"},
      {R"({"axis": "x", "from": 50})", "\"to\""},
      {R"({"axis": "q", "from": 5, "to": 6})", "takes x, y, z"},
      {R"({"axis": [0, 0, 0], "from": 5, "to": 6})", "0,0,0"},
      {R"({"axis": "x", "from": 6, "to": 6})", "below"},
      {R"({"axis": "x", "from": 5, "to": 6, "gap": 1})", "gap"},
      {R"(["x:50..100", "x:90..120"])", "overlap"},
      {R"(["x:50..100", "y:5..6"])", "one axis"},
  };
  for (const auto& [breaks, said] : wrong) {
    EXPECT_EQ(drawn(breaks), 2) << breaks;
    EXPECT_NE(err_.find("a.burin.json:3: "), std::string::npos) << breaks << err_;
    EXPECT_NE(err_.find(said), std::string::npos) << breaks << err_;
    EXPECT_EQ(std::ranges::count(err_, '\n'), 1) << err_;
  }
}

TEST_F(BrokenViewsOfCommand, RefuseNonsense) {
  for (const char* wrong :
       {"q", "x:", "x:1", "x:5..4", "x:5..5", "x:a..b", "x:1..2..3", "x=5", "+x:1..2", "0,0,0:1..2",
        "x:nan..5", "x:1..inf", "auto:1..2", "1,0:1..2"}) {
    EXPECT_EQ(run(std::string("draw @/bar.off -o @/a.json --break-view ") + wrong), 2) << wrong;
    EXPECT_NE(err_.find("--break-view takes auto, or an axis"), std::string::npos) << err_;
    EXPECT_EQ(std::ranges::count(err_, '\n'), 1) << err_;
  }
  EXPECT_EQ(run("draw @/bar.off -o @/a.json --break-view x:20..180 --break-view x:100..200"), 2);
  EXPECT_NE(err_.find("overlap"), std::string::npos) << err_;
  // Who says --break is told its name.
  EXPECT_NE(run("draw @/bar.off -o @/a.json --break x:20..180"), 0);
  EXPECT_NE(err_.find("--break-view"), std::string::npos) << err_;
}

TEST_F(BrokenViewsOfCommand, TellWhatHasNoEffect) {
  const auto warns = [&](const std::string& options, const std::string& said) {
    EXPECT_EQ(run("draw @/bar.off -o @/a.json " + options), 0) << err_;
    EXPECT_NE(err_.find(said), std::string::npos) << options << err_;
  };
  warns("--view left --break-view x:50..350", "no view of the sheet shows");
  warns("--view front --break-view x:350..500", "what is drawn reaches from 0 to 400");
  warns("--view front --break-view z", "nothing is broken");
  warns("--perspective 30 --break-view x:50..350", "leave --perspective out");
  warns("--view front --set break.gap=5", "break.gap has no effect without option --break-view");
}

TEST_F(BrokenViewsOfCommand, AreTheSameInAnyFormatAndNumberOfThreads) {
  const std::string draw =
      "draw @/bar.off --views front,top,iso --style engraving --hidden dashed --set fill.color=red "
      "--section y --break-view x:50..350 -o @/a.svg -o @/a.json ";
  ASSERT_EQ(run(draw + "--threads 1"), 0) << err_;
  const std::string svg = test::slurp(folder_ / "a.svg"), json = test::slurp(folder_ / "a.json");
  ASSERT_EQ(run(draw + "--threads 2"), 0) << err_;
  EXPECT_EQ(test::slurp(folder_ / "a.svg"), svg);
  EXPECT_EQ(test::slurp(folder_ / "a.json"), json);
  EXPECT_NE(svg.find("id=\"breaks\""), std::string::npos);
  EXPECT_NE(svg.find("data-part"), std::string::npos);
}

}  // namespace
}  // namespace burin
