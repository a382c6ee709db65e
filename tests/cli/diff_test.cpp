// What has changed between two revisions, from the command line.
#include "models.h"
#include "pages.h"

#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace burin {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class Diff : public test::CliTest {
 protected:
  static std::string sample(const std::string& name) {
    return std::string(BURIN_SOURCE_DIR) + "/samples/" + name;
  }

  json report(const std::string& name) const { return json::parse(test::slurp(folder_ / name)); }

  /// A plate of 40 x 30 x 4 with square holes of 6 mm at these places along x.
  static TriMesh plate(const std::vector<double>& holes) {
    const auto square = [](double x, double y) {
      return std::vector<Vec2>{{x, y}, {x + 6, y}, {x + 6, y + 6}, {x, y + 6}};
    };
    std::vector<double> xs{0, 40}, ys{0, 30};
    for (const double x : holes) {
      for (const Vec2& p : square(x, 12)) xs.push_back(p.x), ys.push_back(p.y);
    }
    for (auto* list : {&xs, &ys}) {
      std::ranges::sort(*list);
      list->erase(std::unique(list->begin(), list->end()), list->end());
    }
    const auto is_hole = [&](double x, double y) {
      return y > 12 && y < 18 &&
             std::ranges::any_of(holes, [&](double h) { return x > h && x < h + 6; });
    };
    TriMesh mesh;
    const auto quad = [&](Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
      const auto v = static_cast<std::uint32_t>(mesh.positions.size());
      mesh.positions.insert(mesh.positions.end(), {a, b, c, d});
      mesh.triangles.push_back({v, v + 1, v + 2});
      mesh.triangles.push_back({v, v + 2, v + 3});
    };
    const auto full = [&](std::size_t i, std::size_t j) {
      if (i >= xs.size() - 1 || j >= ys.size() - 1) return false;
      return !is_hole(0.5 * (xs[i] + xs[i + 1]), 0.5 * (ys[j] + ys[j + 1]));
    };
    constexpr auto kNone = static_cast<std::size_t>(-1);
    for (std::size_t i = 0; i + 1 < xs.size(); ++i) {
      for (std::size_t j = 0; j + 1 < ys.size(); ++j) {
        if (!full(i, j)) continue;
        const double x0 = xs[i], x1 = xs[i + 1], y0 = ys[j], y1 = ys[j + 1];
        quad({x0, y0, 4}, {x1, y0, 4}, {x1, y1, 4}, {x0, y1, 4});
        quad({x0, y0, 0}, {x0, y1, 0}, {x1, y1, 0}, {x1, y0, 0});
        if (i == 0 || !full(i - 1, j)) quad({x0, y0, 0}, {x0, y0, 4}, {x0, y1, 4}, {x0, y1, 0});
        if (!full(i + 1, j)) quad({x1, y0, 0}, {x1, y1, 0}, {x1, y1, 4}, {x1, y0, 4});
        if (j == 0 || !full(i, j == 0 ? kNone : j - 1))
          quad({x0, y0, 0}, {x1, y0, 0}, {x1, y0, 4}, {x0, y0, 4});
        if (!full(i, j + 1)) quad({x0, y1, 0}, {x0, y1, 4}, {x1, y1, 4}, {x1, y1, 0});
      }
    }
    return mesh;
  }

  /// Parts of an OBJ file by name.
  static std::string obj_text(const std::vector<std::pair<std::string, TriMesh>>& parts) {
    std::string text;
    std::size_t first = 1;
    for (const auto& [name, m] : parts) {
      text += "o " + name + "\n";
      for (const Vec3& p : m.positions) text += fmt::format("v {} {} {}\n", p.x, p.y, p.z);
      for (const Triangle& t : m.triangles) {
        text += fmt::format("f {} {} {}\n", first + t[0], first + t[1], first + t[2]);
      }
      first += m.positions.size();
    }
    return text;
  }

  /// The same STEP file with other numbers, in another order.
  static std::string rewritten(const std::string& step) {
    const std::size_t data = step.find("DATA;") + 5, end = step.find("ENDSEC;", data);
    std::vector<std::string> entities;
    std::string one;
    bool quoted = false;
    for (std::size_t i = data; i < end; ++i) {
      if (step[i] == '\'') quoted = !quoted;
      one += step[i];
      if (step[i] == ';' && !quoted) {
        const std::regex number("#([0-9]+)");
        std::string changed;
        std::sregex_iterator it(one.begin(), one.end(), number);
        std::size_t at = 0;
        for (; it != std::sregex_iterator(); ++it) {
          changed += one.substr(at, static_cast<std::size_t>(it->position()) - at);
          changed += fmt::format("#{}", 3 * std::stoi((*it)[1]) + 1000);
          at = static_cast<std::size_t>(it->position() + it->length());
        }
        entities.push_back(changed + one.substr(at));
        one.clear();
      }
    }
    std::ranges::reverse(entities);
    std::string text = step.substr(0, data);
    for (const std::string& entity : entities) text += entity;
    return text + "\n" + step.substr(end);
  }
};

TEST_F(Diff, AStepFileWithOtherNumbersIsTheSame) {
  folder_.write("b.step", rewritten(test::slurp(sample("coupling.step"))));
  EXPECT_EQ(run("diff " + sample("coupling.step") + " @/b.step -o @/r.json"), 0) << out_ << err_;
  EXPECT_EQ(err_, "");
  const json r = report("r.json");
  EXPECT_TRUE(r["same"]);
  EXPECT_EQ(r["counts"]["same"], r["parts"].size());
  EXPECT_EQ(std::count(out_.begin(), out_.end(), '\n'), 1) << out_;
}

TEST_F(Diff, AFileIsTheSameAsItself) {
  EXPECT_EQ(run("diff @/box.off @/box.off"), 0) << err_;
  EXPECT_EQ(out_, "1 part: 1 same\n");
}

TEST_F(Diff, ShuffledTrianglesAreTheSameAndAnotherFormatIs) {
  TriMesh m = plate({10});
  folder_.write("a.off", test::off_text(m));
  std::ranges::reverse(m.positions);
  const auto n = static_cast<std::uint32_t>(m.positions.size());
  for (Triangle& t : m.triangles) t = {n - 1 - t[0], n - 1 - t[1], n - 1 - t[2]};
  std::ranges::reverse(m.triangles);
  folder_.write("b.obj", obj_text({{"b", m}}));
  EXPECT_EQ(run("diff @/a.off @/b.obj"), 0) << out_ << err_;
}

TEST_F(Diff, AnAddedHoleIsNamedAndDrawn) {
  TriMesh lid = plate({5});
  for (Vec3& p : lid.positions) p.z += 20;
  folder_.write("a.obj", obj_text({{"base", plate({5})}, {"lid", lid}}));
  folder_.write("b.obj", obj_text({{"base", plate({5, 25})}, {"lid", lid}}));
  ASSERT_EQ(run("diff @/a.obj @/b.obj -o @/d.svg -o @/d.json -o @/d.drawing.json --style outline"),
            6)
      << err_;
  EXPECT_EQ(err_, "");
  EXPECT_NE(out_.find("changed  base: volume 4656 to 4512 mm3 (-3.09 %)"), std::string::npos)
      << out_;
  EXPECT_NE(out_.find("2 parts: 1 same, 1 changed\n"), std::string::npos) << out_;
  const json r = report("d.json");
  EXPECT_EQ(r["format"], "burin-difference");
  EXPECT_FALSE(r["same"]);
  EXPECT_EQ(r["parts"][0]["change"], "changed");
  EXPECT_EQ(r["parts"][0]["changes"], json::array({"changed"}));
  EXPECT_NEAR(r["parts"][0]["volume"][0], 4656, 1e-6);
  EXPECT_EQ(r["parts"][1]["change"], "same");
  // The hole is new, nothing else is.
  const json drawing = report("d.drawing.json");
  double added = 0, gone = 0;
  std::set<std::string> names;
  for (const json& layer : drawing["layers"]) {
    const std::string name = layer["name"];
    names.insert(name);
    for (const json& path : layer["paths"]) {
      double length = 0;
      const auto& points = path["points"];
      for (std::size_t i = 1; i < points.size(); ++i) {
        length += std::hypot(points[i][0].get<double>() - points[i - 1][0].get<double>(),
                             points[i][1].get<double>() - points[i - 1][1].get<double>());
      }
      if (name.starts_with("changed-new-")) added += length;
      if (name.starts_with("changed-from-")) gone += length;
    }
  }
  const double scale = drawing["view"]["scale"];
  EXPECT_GT(added, 10 * scale);
  EXPECT_LT(added, 8 * 6 * scale);
  EXPECT_LT(gone, 0.5);
  EXPECT_TRUE(names.contains("same-outline"));
  EXPECT_TRUE(names.contains("changed-to-outline"));
  pugi::xml_document svg;
  ASSERT_TRUE(svg.load_file((folder_ / "d.svg").c_str()));
  const std::string text = test::slurp(folder_ / "d.svg");
  EXPECT_NE(text.find("stroke=\"#00802b\""), std::string::npos);
  EXPECT_NE(text.find("1 changed"), std::string::npos);
}

TEST_F(Diff, MovedAddedRemovedAndRenamedPartsAreNamed) {
  const auto at = [](Vec3 low, double side) { return test::box(low, low + side); };
  folder_.write("a.obj", obj_text({{"base", at({0, 0, 0}, 20)},
                                   {"pin", at({30, 0, 0}, 5)},
                                   {"lid", at({40, 0, 0}, 7)},
                                   {"gone", at({60, 0, 0}, 6)}}));
  folder_.write("b.obj", obj_text({{"extra", at({0, 40, 0}, 3)},
                                   {"base", at({0, 0, 0}, 20)},
                                   {"pin", at({30, 12, 0}, 5)},
                                   {"cover", at({40, 0, 0}, 7)}}));
  ASSERT_EQ(run("diff @/a.obj @/b.obj -o @/d.json -o @/d.svg --style outline"), 6) << err_;
  std::map<std::string, std::string> found;
  const json r = report("d.json");
  for (const json& part : r["parts"]) {
    found[part["new"].is_null() ? part["old"] : part["new"]] = part["change"];
  }
  EXPECT_EQ(found, (std::map<std::string, std::string>{{"base", "same"},
                                                       {"pin", "moved"},
                                                       {"cover", "renamed"},
                                                       {"extra", "added"},
                                                       {"gone", "removed"}}));
  EXPECT_NE(out_.find("moved    pin: moved by 12 mm (0, 12, 0)\n"), std::string::npos) << out_;
  EXPECT_NE(out_.find("renamed  cover: was called lid\n"), std::string::npos) << out_;
  EXPECT_NE(out_.find("4 parts: 1 same, 1 moved, 1 added, 1 removed, 1 renamed\n"),
            std::string::npos)
      << out_;
  const std::string svg = test::slurp(folder_ / "d.svg");
  for (const char* layer :
       {"same-outline", "moved-from-outline", "moved-to-outline", "moved-arrows", "added-outline",
        "removed-outline", "renamed-outline", "legend"}) {
    EXPECT_NE(svg.find(std::string("inkscape:label=\"") + layer + "\""), std::string::npos)
        << layer;
  }
  EXPECT_NE(svg.find("stroke-dasharray=\"2 1\""), std::string::npos);
}

TEST_F(Diff, ThePageMarksPartsAndShowsOneRevision) {
  folder_.write("a.obj", obj_text({{"base", test::box({0, 0, 0}, {20, 20, 20})},
                                   {"gone", test::box({30, 0, 0}, {36, 6, 6})}}));
  folder_.write("b.obj", obj_text({{"base", test::box({0, 0, 0}, {20, 20, 20})},
                                   {"more", test::box({0, -15, 0}, {5, -10, 5})}}));
  ASSERT_EQ(run("diff @/a.obj @/b.obj -o @/d.html --style outline"), 6) << err_;
  const std::string page = test::slurp(folder_ / "d.html");
  EXPECT_NE(page.find("<td>removed</td><td>gone</td>"), std::string::npos);
  if (!test::has_chromium()) GTEST_SKIP() << "no chromium to open the page in";
  const std::string probe = R"page(<script>
const out = [], q = s => [...document.querySelectorAll(s)];
const seen = name => q("main g").filter(g => g.getAttribute("inkscape:label") === name)
  .map(g => getComputedStyle(g).display !== "none").join();
const show = () => out.push(seen("same-outline") + seen("removed-outline") + seen("added-outline"));
show();
q("nav button")[0].click(); show();
q("nav button")[2].click(); show();
q("nav button")[1].click(); show();
const row = q("tbody tr").find(r => r.cells[1].textContent === "gone");
row.dispatchEvent(new MouseEvent("click", {bubbles: true}));
out.push([...new Set(q("main g.part.marked title").map(t => t.textContent))].join());
out.push(q("tbody tr")[0].cells[0].textContent, q("tbody tr").length);
document.body.innerHTML = "<pre>" + out.join("|") + "</pre>";
</script>)page";
  EXPECT_EQ(test::said_by_page(folder_, page, probe),
            "truetruetrue|truetruefalse|truefalsetrue|truetruetrue|gone|added|3");
}

TEST_F(Diff, IllustrationsTellLooks) {
  const auto text = [](const std::string& look) {
    return R"json({"burin": "illustration", "style": "outline", "parts": [
      {"file": "box.off", "name": "box"},
      {"file": "box.off", "name": "lid", "place": {"translate": [0, 0, 20]}}],
      "explode": {"steps": [{"move": "lid", "along": [0, 0, 1], "by": 30}]})json" +
           look + "}";
  };
  folder_.write("a.burin.json", text(""));
  folder_.write("b.burin.json", text(R"json(, "looks": [{"select": "lid", "drawn": false}])json"));
  EXPECT_EQ(run("diff @/a.burin.json @/a.burin.json -o @/same.svg"), 0) << err_;
  EXPECT_NE(err_.find("exploded view"), std::string::npos) << err_;
  EXPECT_EQ(run("diff @/a.burin.json @/b.burin.json"), 6) << err_;
  EXPECT_EQ(out_, "look     lid: left out\n2 parts before, 1 now: 1 same, 1 of another look\n");
  folder_.write("a.obj", obj_text({{"base", test::box({0, 0, 0}, {20, 20, 20})}}));
  folder_.write("none.obj", "mtllib glass.mtl\nusemtl glass\n" +
                                obj_text({{"base", test::box({0, 0, 0}, {20, 20, 20})}}));
  folder_.write("glass.mtl", "newmtl glass\nKd 1 0 0\nd 0.25\n");
  EXPECT_EQ(run("diff @/a.obj @/none.obj"), 6) << err_;
  EXPECT_NE(out_.find("opacity 1 to 0.25"), std::string::npos) << out_;
  // What the command leaves out is not compared.
  EXPECT_EQ(run("diff @/box.off @/a.burin.json --hide lid"), 2);
}

TEST_F(Diff, OptionsChooseWhatIsCompared) {
  folder_.write("a.obj", obj_text({{"base", test::box({0, 0, 0}, {20, 20, 20})},
                                   {"pin", test::box({30, 0, 0}, {36, 6, 6})}}));
  folder_.write("b.obj", obj_text({{"base", test::box({0, 0, 0}, {20, 20, 20})}}));
  EXPECT_EQ(run("diff @/a.obj @/b.obj"), 6);
  EXPECT_EQ(run("diff @/a.obj @/b.obj --hide pin"), 0) << out_ << err_;
  EXPECT_EQ(run("diff @/a.obj @/b.obj --part pin -o @/d.svg"), 6) << err_;
  EXPECT_EQ(out_.substr(0, 12), "removed  pin") << out_;
}

TEST_F(Diff, ColoursAreToldOfModelsAndOfDrawings) {
  const std::vector<std::pair<std::string, TriMesh>> parts = {
      {"base", test::box(Vec3(0), Vec3(20))}, {"lid", test::box({30, 0, 0}, {40, 20, 20})}};
  for (const auto& [name, color] : {std::pair("a", "0 1 0"), std::pair("b", "1 0 0")}) {
    std::string text = obj_text(parts);
    text.insert(text.find("o lid"), "usemtl paint\n");
    folder_.write(std::string(name) + ".obj", fmt::format("mtllib {}.mtl\n", name) + text);
    folder_.write(std::string(name) + ".mtl", fmt::format("newmtl paint\nKd {}\n", color));
    ASSERT_EQ(run(fmt::format("draw @/{0}.obj -o @/{0}.json --style flat", name)), 0) << err_;
  }
  EXPECT_EQ(run("diff @/a.obj @/b.obj --style flat -o @/d.svg"), 6) << err_;
  EXPECT_NE(out_.find("look     lid: colour #00ff00 to #ff0000\n"), std::string::npos) << out_;
  const std::string models = test::slurp(folder_ / "d.svg");
  EXPECT_NE(models.find(" fill=\"#ff0000\""), std::string::npos);
  EXPECT_EQ(models.find("class=\"part_0\" fill=\"#"), std::string::npos) << "the base is the same";

  EXPECT_EQ(run("diff @/a.json @/a.json"), 0) << out_;
  EXPECT_EQ(run("diff @/a.json @/b.json -o @/d.json -o @/d.svg"), 6) << err_;
  EXPECT_EQ(out_.find("changed  lid: colour #00ff00 to #ff0000, "), 0u) << out_;
  EXPECT_NE(out_.find(", 1 part of other colours\n"), std::string::npos) << out_;
  const json r = report("d.json");
  EXPECT_FALSE(r["same"].get<bool>());
  EXPECT_TRUE(r["lines"].empty());
  ASSERT_EQ(r["fills"].size(), 1u);
  EXPECT_EQ(r["fills"][0]["part"], "lid");
  EXPECT_EQ(r["fills"][0]["color"], (json{"#00ff00", "#ff0000"}));
  EXPECT_GT(r["fills"][0]["size"], 100);
  const std::string drawings = test::slurp(folder_ / "d.svg");
  EXPECT_NE(drawings.find(" fill=\"#ff0000\""), std::string::npos);
  EXPECT_NE(drawings.find("inkscape:label=\"look-fills\""), std::string::npos);
}

TEST_F(Diff, EveryFormatIsWrittenAndSectionsAreOne) {
  folder_.write("a.off", test::off_text(plate({5})));
  folder_.write("b.off", test::off_text(plate({5, 25})));
  std::string line = "diff @/a.off @/b.off --section y --style engraving";
  for (const char* name : {"d.svg", "d.pdf", "d.eps", "d.png", "d.dxf", "d.html", "d.json"}) {
    line += std::string(" -o @/") + name;
  }
  ASSERT_EQ(run(line), 6) << err_;
  EXPECT_NE(test::slurp(folder_ / "d.eps").find("0.0000 0.5020 0.1686 setrgbcolor"),
            std::string::npos);
  EXPECT_NE(test::slurp(folder_ / "d.dxf").find("changed-new-"), std::string::npos);
}

TEST_F(Diff, SameBytesForAnyNumberOfThreads) {
  folder_.write("a.off", test::off_text(plate({5})));
  folder_.write("b.off", test::off_text(plate({5, 25})));
  for (const char* threads : {"1", "4"}) {
    ASSERT_EQ(
        run(fmt::format("diff @/a.off @/b.off --threads {0} -o @/{0}.html -o @/{0}.json", threads)),
        6)
        << err_;
  }
  EXPECT_EQ(test::slurp(folder_ / "1.html"), test::slurp(folder_ / "4.html"));
  EXPECT_EQ(test::slurp(folder_ / "1.json"), test::slurp(folder_ / "4.json"));
}

TEST_F(Diff, DrawingsAreComparedLineByLine) {
  folder_.write("plate.off", test::off_text(plate({5})));
  folder_.write("holes.off", test::off_text(plate({5, 25})));
  const std::string how = " --style outline --view top --scale 2 --center 20,15,0";
  ASSERT_EQ(run("draw @/plate.off -o @/a.json" + how), 0) << err_;
  ASSERT_EQ(run("draw @/holes.off -o @/b.json" + how), 0) << err_;
  EXPECT_EQ(run("diff @/a.json @/a.json"), 0) << out_ << err_;
  ASSERT_EQ(run("diff @/a.json @/b.json -o @/d.svg -o @/d.json"), 6) << err_;
  const json r = report("d.json");
  EXPECT_EQ(r["of"], "drawings");
  EXPECT_EQ(r["counts"]["gone"], 0);
  EXPECT_NEAR(r["lengths"]["new"], 4 * 6 * 2, 0.5) << "the hole's four sides at 2:1";
  EXPECT_EQ(r["lines"][0]["part"], "holes");
  EXPECT_NE(test::slurp(folder_ / "d.svg").find("inkscape:label=\"new-"), std::string::npos);
  // A tenth of a mm to the side is the same for who says so.
  ASSERT_EQ(run("draw @/plate.off -o @/c.json --style outline --view top --scale 2 --center "
                "20.1,15,0"),
            0);
  EXPECT_EQ(run("diff @/a.json @/c.json"), 6);
  EXPECT_EQ(run("diff @/a.json @/c.json --line-tolerance 0.3"), 0) << out_;
  EXPECT_EQ(run("diff @/a.json @/plate.off"), 2);
  expect_error("compare a drawing with a drawing");
  EXPECT_EQ(run("diff @/a.json @/b.json --view top"), 2);
  expect_error("option --view has shaped a drawing already");
}

TEST_F(Diff, SaysWhatItCannotDo) {
  const auto refused = [&](const std::string& line, int status, const std::string& part) {
    EXPECT_EQ(run("diff " + line), status) << line;
    expect_error(part);
  };
  refused("", 2, "two revisions");
  refused("@/box.off", 2, "two revisions, not 1");
  refused("@/box.off @/box.off @/box.off", 2, "two revisions, not 3");
  refused("@/box.off @/none.off", 3, "none.off");
  refused("@/none.off @/box.off", 3, "none.off");
  refused("@/box.off @/box.off -o @/box.off", 2, "box.off");
  refused("@/box.off @/box.off -o @/none/a.svg", 4, "folder does not exist");
  refused("@/box.off @/box.off --callouts", 2, "--callouts is an option of burin draw");
  refused("@/box.off @/box.off --line-tolerance 1", 2, "two drawing files");
  refused("@/box.off @/box.off --hide nobody", 2, "no part is named 'nobody'");
  for (const auto& entry : fs::directory_iterator(folder_.path())) {
    EXPECT_EQ(entry.path().filename(), "box.off");
  }
  EXPECT_EQ(run("diff @/box.off @/box.off --quiet"), 0);
  EXPECT_EQ(out_ + err_, "");
  EXPECT_EQ(run("diff @/box.off @/box.off -o - --format json"), 0);
  EXPECT_TRUE(json::accept(out_)) << out_;
}

// What neither drawing shows is not reported.
TEST_F(Diff, LeavesOutWhatIsNotDrawn) {
  const auto revision = [&](const char* name, double size, const char* looks) {
    folder_.write(std::string(name) + ".obj",
                  obj_text({{"lid", test::box({0, 0, 0}, {10, 10, size})},
                            {"base", test::box({20, 0, 0}, {30, 10, 10})}}));
    folder_.write(std::string(name) + ".burin.json",
                  std::string("{\"burin\": \"illustration\", \"parts\": [{\"file\": \"") + name +
                      ".obj\"}], \"looks\": [" + looks + "]}");
  };
  const char* hidden = R"({"select": "lid", "drawn": false})";
  const char* ghost = R"({"select": "lid", "transparent": true})";
  revision("old", 10, hidden);
  revision("new", 20, hidden);
  ASSERT_EQ(run("diff @/old.burin.json @/new.burin.json -o @/d.json"), 0) << err_ << out_;
  EXPECT_EQ(out_.find("lid"), std::string::npos) << out_;
  EXPECT_NE(out_.find("1 part: 1 same"), std::string::npos) << out_;
  EXPECT_EQ(report("d.json").at("parts").size(), 1U);
  // A part that can be looked through is drawn; one that one revision hides has changed its look.
  revision("old", 10, ghost);
  revision("new", 20, ghost);
  EXPECT_EQ(run("diff @/old.burin.json @/new.burin.json"), 6) << err_;
  EXPECT_NE(out_.find("changed  "), std::string::npos) << out_;
  revision("new", 10, hidden);
  EXPECT_EQ(run("diff @/old.burin.json @/new.burin.json"), 6) << err_;
  EXPECT_NE(out_.find("left out"), std::string::npos) << out_;
}

}  // namespace
}  // namespace burin
