#include <burin/base/version.h>

#include "models.h"

#include <nlohmann/json.hpp>
#include <pugixml.hpp>

namespace burin {
namespace {

using nlohmann::json;
using test::slurp;

class Draw : public test::CliTest {
 protected:
  /// The drawing file of a run with these options.
  json draw(const std::string& options) {
    EXPECT_EQ(run("draw @/box.off -o @/out.json " + options), 0) << options << "\n" << err_;
    const std::string text = slurp(folder_ / "out.json");
    EXPECT_TRUE(json::accept(text)) << options;
    return json::accept(text) ? json::parse(text) : json::object();
  }

  static std::vector<double> numbers(const json& j) { return j.get<std::vector<double>>(); }
};

TEST_F(Draw, WritesSvgAndJsonAtOnce) {
  ASSERT_EQ(run_as_it_stands("draw @/box.off -o @/a.svg -o @/a.json"), 0) << err_;
  EXPECT_EQ(out_, "");
  EXPECT_EQ(err_, "");
  pugi::xml_document svg;
  ASSERT_TRUE(svg.load_file((folder_ / "a.svg").c_str()));
  EXPECT_STREQ(svg.child("svg").attribute("width").value(), "297mm");
  const json j = json::parse(slurp(folder_ / "a.json"));
  EXPECT_EQ(j["format"], "burin-drawing");
  EXPECT_EQ(j["style"], "technical");
  EXPECT_EQ(j["seed"], 1);
  EXPECT_EQ(j["parts"][0]["source"], box_);
  EXPECT_EQ(j["parts"][0]["triangles"], 12);
  EXPECT_EQ(folder_.count(), 3u);
}

TEST_F(Draw, OutlineOfABoxHasItsVisibleEdges) {
  const json j = draw("--style outline --set json.points3=true");
  // Isometric: 3 visible faces, 9 visible edges; lengths in paper mm from the view.
  double length = 0;
  const json& view = j["view"];
  for (const json& layer : j["layers"]) {
    for (const json& path : layer["paths"]) {
      EXPECT_TRUE(path["visible"]);
      const json &p = path["points"], &q = path["points3"];
      ASSERT_EQ(p.size(), q.size());
      const std::size_t n = p.size();
      for (std::size_t i = 0; i < n; ++i) {
        double x = view["offset"][0], y = view["offset"][1];
        for (int c = 0; c < 3; ++c) {
          const double d = q[i][c].get<double>() - view["center"][c].get<double>();
          x += view["scale"].get<double>() * d * view["right"][c].get<double>();
          y += view["scale"].get<double>() * d * view["up"][c].get<double>();
        }
        EXPECT_NEAR(x, p[i][0].get<double>(), 1e-3);
        EXPECT_NEAR(y, p[i][1].get<double>(), 1e-3);
        if (i + 1 == n && !path["closed"]) continue;
        const json& next = p[(i + 1) % n];
        length += std::hypot(next[0].get<double>() - p[i][0].get<double>(),
                             next[1].get<double>() - p[i][1].get<double>());
      }
    }
  }
  const double expected = view["scale"].get<double>() * 3 * (40 + 30 + 20) * std::sqrt(2.0 / 3);
  EXPECT_NEAR(length, expected, 0.1);
}

TEST_F(Draw, View) {
  const double s = 1 / std::sqrt(3.0);
  const auto direction = [&](const std::string& options) {
    return numbers(draw(options)["view"]["direction"]);
  };
  const auto expect = [](const std::vector<double>& a, const Vec3& b) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[static_cast<std::size_t>(c)], b[c], 1e-12);
  };
  expect(direction(""), {s, -s, s});
  expect(direction("--view front"), {0, -1, 0});
  expect(direction("--view=-1,-1,1"), {-s, -s, s});
  expect(direction("--view -2,0,0"), {-1, 0, 0});
  const json top = draw("--view top")["view"];
  expect(numbers(top["up"]), {0, 1, 0});
  expect(numbers(draw("--view top --up 1,0,0")["view"]["up"]), {1, 0, 0});
}

TEST_F(Draw, PaperScaleMarginPerspective) {
  EXPECT_EQ(draw("--paper A4p")["paper"]["height"], 297);
  const json j = draw("--paper 200x150 --scale 1.5");
  EXPECT_EQ(j["paper"]["width"], 200);
  EXPECT_EQ(j["view"]["scale"], 1.5);
  // Front: 40 x 20 mm; inside a margin of 50 the width decides.
  EXPECT_NEAR(draw("--view front --paper 200x150 --margin 50")["view"]["scale"].get<double>(), 2.5,
              1e-9);
  const json view = draw("--perspective 40")["view"];
  EXPECT_EQ(view["projection"], "perspective");
  EXPECT_EQ(view["field_of_view"], 40);
  EXPECT_EQ(view["eye"].size(), 3u);
}

TEST_F(Draw, StyleSetAndLight) {
  const json outline = draw("--style outline --set line.outer=1.25 --set line.crease=0.5");
  bool outer = false, crease = false;
  for (const json& layer : outline["layers"]) {
    for (const json& path : layer["paths"]) {
      outer = outer || path["width"][0] == 1.25;
      crease = crease || (path["kind"] == "crease" && path["width"][0] == 0.5);
      EXPECT_NE(path["kind"], "stroke");
    }
  }
  EXPECT_TRUE(outer);
  EXPECT_TRUE(crease);
  EXPECT_FALSE(draw("--set json.points3=false")["layers"][0]["paths"][0].contains("points3"));
  folder_.write("mine.json", R"({"base": "outline", "line": {"outer": 0.9}})");
  EXPECT_EQ(draw("--style @/mine.json")["style"], "mine");
  const json left = draw("--style engraving --light -1,0,0.2");
  const json right = draw("--style engraving --light 1,0,0.2");
  EXPECT_NE(left["layers"], right["layers"]);
}

TEST_F(Draw, HiddenLinesDashed) {
  const json none = draw("--style outline");
  for (const json& layer : none["layers"]) EXPECT_NE(layer["name"], "hidden");
  const json dashed = draw("--style outline --hidden dashed");
  int hidden = 0;
  for (const json& layer : dashed["layers"]) {
    for (const json& path : layer["paths"]) hidden += path["visible"] ? 0 : 1;
  }
  EXPECT_GE(hidden, 1);
  ASSERT_EQ(run("draw @/box.off -o @/a.svg --hidden dashed --set line.dash=3"), 0);
  EXPECT_NE(slurp(folder_ / "a.svg").find("stroke-dasharray=\"3 1\""), std::string::npos);
}

TEST_F(Draw, SameBytesForSeedAndThreads) {
  folder_.write("torus.off", test::off_text(test::torus(20, 8, 60, 30)));
  const auto drawing = [&](const std::string& options) {
    EXPECT_EQ(
        run("draw @/torus.off -o @/t.svg -o @/t.json --style engraving --paper A6 " + options), 0);
    return slurp(folder_ / "t.svg") + slurp(folder_ / "t.json");
  };
  const std::string first = drawing("");
  EXPECT_GT(first.size(), 10000u);
  EXPECT_TRUE(first == drawing(""));
  EXPECT_TRUE(first == drawing("--threads 1"));
  EXPECT_TRUE(first == drawing("--threads 3 --quiet"));
  EXPECT_FALSE(first == drawing("--seed 2"));
}

TEST_F(Draw, SeveralInputsAreSeveralParts) {
  folder_.write("other.off", test::off_text(test::box({50, 0, 0}, {60, 10, 10})));
  ASSERT_EQ(run("draw @/box.off @/other.off -o @/two.json --tolerance 0.1"), 0) << err_;
  const json j = json::parse(slurp(folder_ / "two.json"));
  ASSERT_EQ(j["parts"].size(), 2u);
  EXPECT_EQ(j["parts"][1]["id"], 1);
  EXPECT_EQ(j["parts"][1]["name"], "other");
  EXPECT_EQ(j["parts"][1]["source"], folder_ / "other.off");
}

TEST_F(Draw, StandardOutput) {
  ASSERT_EQ(run("draw @/box.off -o - --format svg"), 0) << err_;
  EXPECT_TRUE(out_.starts_with("<?xml"));
  const std::string svg = out_;
  ASSERT_EQ(run("draw @/box.off --output - --format json -o @/b.svg"), 0) << err_;
  EXPECT_TRUE(json::accept(out_));
  EXPECT_EQ(slurp(folder_ / "b.svg"), svg);
  ASSERT_EQ(run("draw @/box.off -o @/noname --format svg"), 0) << err_;
  EXPECT_EQ(slurp(folder_ / "noname"), svg);
}

TEST_F(Draw, FlattenGivesPolylines) {
  ASSERT_EQ(run("draw @/box.off -o @/a.svg --set svg.flatten=polylines"), 0) << err_;
  const std::string svg = slurp(folder_ / "a.svg");
  EXPECT_NE(svg.find("<polyline"), std::string::npos);
  EXPECT_EQ(svg.find("<path"), std::string::npos);
}

TEST_F(Draw, VerboseTellsEveryStageOnce) {
  ASSERT_EQ(run("draw @/box.off -o @/a.svg --verbose"), 0);
  std::string names;
  std::istringstream lines(err_);
  double sum = 0, total = 0;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string burin, kind, name;
    double seconds = -1;
    words >> burin >> kind;
    EXPECT_EQ(burin, "burin:");
    if (kind == "stage") words >> name;
    words >> seconds;
    EXPECT_GE(seconds, 0) << line;
    (kind == "total" ? total : sum) += seconds;
    names += (kind == "total" ? kind : name) + " ";
  }
  EXPECT_EQ(names,
            "read build curvature field cover trace features visibility compose write total ");
  EXPECT_LE(sum, total + 0.001);
}

TEST_F(Draw, WarningsUnlessQuiet) {
  folder_.write("bad.off",
                "OFF\n5 3 0\n0 0 0\n9 0 0\n0 9 0\n0 0 9\nnan 0 0\n3 0 1 2\n3 0 1 3\n3 0 1 4\n");
  ASSERT_EQ(run("draw @/bad.off -o @/a.svg"), 0) << err_;
  EXPECT_TRUE(err_.starts_with("burin: warning: ")) << err_;
  ASSERT_EQ(run("draw @/bad.off -o @/a.svg --quiet"), 0);
  EXPECT_EQ(err_, "");
}

TEST_F(Draw, ProgressInLinesWhereNoTerminalIs) {
  ASSERT_EQ(run("draw @/box.off -o @/a.svg --progress"), 0);
  EXPECT_NE(err_.find("burin: progress write "), std::string::npos) << err_;
  EXPECT_EQ(err_.find('\r'), std::string::npos);
  ASSERT_EQ(run("draw @/box.off -o @/a.svg --progress --quiet"), 0);
  EXPECT_EQ(err_, "");
}

TEST_F(Draw, KeepsLinksAndPermissions) {
  namespace fs = std::filesystem;
  folder_.write("real.svg", "old");
  fs::permissions(folder_ / "real.svg", fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("real.svg", folder_ / "link.svg");
  ASSERT_EQ(run("draw @/box.off -o @/link.svg"), 0) << err_;
  EXPECT_TRUE(fs::is_symlink(folder_ / "link.svg"));
  EXPECT_TRUE(slurp(folder_ / "real.svg").starts_with("<?xml"));
  EXPECT_EQ(fs::status(folder_ / "real.svg").permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(Draw, OtherCommands) {
  ASSERT_EQ(run("--version"), 0);
  EXPECT_TRUE(out_.starts_with(std::string("burin ") + version() + "\nbuilt with ")) << out_;
  ASSERT_EQ(run("--help"), 0);
  for (const char* word : {"draw", "info", "styles", "plugins"}) {
    EXPECT_NE(out_.find(word), std::string::npos) << word;
  }
  ASSERT_EQ(run("draw --help"), 0);
  for (const char* word :
       {"--output", "--view", "--up", "--perspective", "--paper", "--scale", "--margin", "--style",
        "--set", "--light", "--hidden", "--tolerance", "--seed", "--threads", "--quiet",
        "--progress", "--verbose", "--format", "Exit status"}) {
    EXPECT_NE(out_.find(word), std::string::npos) << word;
  }
  ASSERT_EQ(run("plugins"), 0);
  EXPECT_TRUE(out_.starts_with("no plug-ins; these folders are looked through")) << out_;
  ASSERT_EQ(run("styles"), 0);
  for (const char* word : {"outline", "technical", "engraving"}) {
    EXPECT_NE(out_.find(word), std::string::npos) << word;
  }
  ASSERT_EQ(run("styles --keys"), 0);
  EXPECT_NE(out_.find("hatch.spacing_min"), std::string::npos);
  ASSERT_EQ(run("styles --show engraving"), 0);
  folder_.write("shown.json", out_);
  ASSERT_EQ(run("draw @/box.off -o @/a.svg --style engraving"), 0);
  ASSERT_EQ(run("draw @/box.off -o @/b.svg --style @/shown.json"), 0);
  EXPECT_EQ(slurp(folder_ / "a.svg"), slurp(folder_ / "b.svg"));
  ASSERT_EQ(run("info @/box.off --json"), 0) << err_;
  EXPECT_TRUE(json::accept(out_));
}

TEST_F(Draw, ProvesItselfWhereThatIsAskedFor) {
  ASSERT_EQ(run("draw @/box.off -o @/a.json --style outline --verify"), 0);
  EXPECT_EQ(std::count(err_.begin(), err_.end(), '\n'), 1) << err_;
  EXPECT_TRUE(err_.starts_with("burin: verify: 0.0 of ")) << err_;
  const auto proof =
      nlohmann::json::parse(test::slurp(folder_ / "a.json")).at("stats").at("verify");
  // Nine edges are seen, three are hidden by the box itself.
  EXPECT_GE(proof.at("spans"), 10);
  EXPECT_GT(proof.at("length"), 300);
  EXPECT_EQ(proof.at("contradicted"), 0);
  EXPECT_EQ(proof.at("loose_ends"), 0);
  EXPECT_TRUE(proof.at("contradictions").empty());
  // A drawing file keeps it.
  ASSERT_EQ(run("convert @/a.json -o @/b.json"), 0) << err_;
  EXPECT_EQ(test::slurp(folder_ / "a.json"), test::slurp(folder_ / "b.json"));
  ASSERT_EQ(run("draw @/box.off -o @/a.json --style outline --verify --quiet"), 0);
  EXPECT_EQ(err_, "");
}

}  // namespace
}  // namespace burin
