// Items, parts lists, callouts and the page, from the command line and from illustration files.
#include <burin/annotate/place.h>

#include "models.h"
#include "pages.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>

namespace burin {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

class Items : public test::CliTest {
 protected:
  Json drawing() { return Json::parse(test::slurp(folder_ / "a.json")); }

  const Json* layer(const Json& drawing, const std::string& name) {
    for (const Json& l : drawing.at("layers")) {
      if (l.at("name") == name) return &l;
    }
    return nullptr;
  }

  /// Paper mm from a point to a part's area, 0 inside.
  static double off_area(const Json& drawing, int part, const Json& p) {
    const double x = p[0], y = p[1];
    double least = 1e9;
    bool inside = false;
    for (const Json& area : drawing.at("areas")) {
      if (area.at("part") != part) continue;
      for (const Json& ring : area.at("rings")) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
          const Json &a = ring[i], &b = ring[(i + 1) % ring.size()];
          const double ax = a[0], ay = a[1], bx = b[0], by = b[1];
          if ((ay > y) != (by > y) && x < ax + (bx - ax) * (y - ay) / (by - ay)) inside = !inside;
          const double square = (bx - ax) * (bx - ax) + (by - ay) * (by - ay);
          const double t =
              std::clamp(((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / square, 0.0, 1.0);
          least = std::min(least, std::hypot(ax + t * (bx - ax) - x, ay + t * (by - ay) - y));
        }
      }
    }
    return inside ? 0 : least;
  }

  /// Each leader begins on its part, and no two cross.
  void expect_sound(const Json& drawing) {
    const Json* callouts = layer(drawing, "callouts");
    ASSERT_NE(callouts, nullptr);
    std::vector<std::pair<Vec2, Vec2>> leaders;
    const auto vec = [](const Json& p) { return Vec2(p[0].get<double>(), p[1].get<double>()); };
    for (const Json& path : callouts->at("paths")) {
      const Json& points = path.at("points");
      if (path.at("kind") != "leader" || path.at("width")[0] != 0.18) continue;
      EXPECT_LT(off_area(drawing, path.at("part"), points[0]), 0.8) << path;
      for (const auto& [a, b] : leaders) {
        EXPECT_FALSE(segments_cross(a, b, vec(points[0]), vec(points[1])));
      }
      leaders.emplace_back(vec(points[0]), vec(points[1]));
    }
    EXPECT_GE(leaders.size(), 1U);
  }

  /// Three boxes of two kinds, beside each other, and a small one inside the first.
  void write_illustration(const std::string& more = "") {
    folder_.write("small.off", test::off_text(test::box({5, 5, 5}, {10, 10, 10})));
    folder_.write("cube.off", test::off_text(test::box({0, 0, 0}, {30, 30, 30})));
    folder_.write("a.burin.json", R"({"burin": "illustration", "style": "outline", "parts": [
      {"file": "box.off", "name": "plate"},
      {"file": "cube.off", "name": "cube_1", "place": {"translate": [60, 0, 0]}},
      {"file": "cube.off", "name": "cube_2", "place": {"translate": [120, 0, 0], "rotate": [90, 0, 0]}},
      {"file": "small.off", "name": "kernel, \"hidden\""}])" +
                                      more + "}");
  }
};

TEST_F(Items, HaveNumbersQuantitiesAndAList) {
  write_illustration();
  ASSERT_EQ(run("draw @/a.burin.json -o @/a.json --parts-list @/l.csv --parts-list @/l.json"), 0)
      << err_;
  const std::string csv = test::slurp(folder_ / "l.csv");
  EXPECT_TRUE(csv.starts_with("number,name,quantity,colour,source,parts\r\n1,plate,1,,")) << csv;
  EXPECT_NE(csv.find("\r\n2,cube,2,,"), std::string::npos) << csv;
  EXPECT_NE(csv.find(",/cube_1;/cube_2\r\n"), std::string::npos) << csv;
  EXPECT_NE(csv.find("\r\n3,\"kernel, \"\"hidden\"\"\",1,"), std::string::npos) << csv;
  const Json list = Json::parse(test::slurp(folder_ / "l.json"));
  ASSERT_EQ(list.at("items").size(), 3U);
  EXPECT_EQ(list.at("items")[1].at("quantity"), 2);
  EXPECT_EQ(list.at("items")[1].at("parts"), Json({"/cube_1", "/cube_2"}));
  EXPECT_EQ(drawing().at("items")[1].at("parts"), Json({1, 2}));
  EXPECT_EQ(layer(drawing(), "callouts"), nullptr);
}

TEST_F(Items, ThatAreNotSeenAreTold) {
  write_illustration();
  ASSERT_EQ(run("draw @/a.burin.json -o @/a.json --callouts"), 0) << err_;
  EXPECT_NE(err_.find("3 'kernel, \"hidden\"'"), std::string::npos) << err_;
  const Json d = drawing();
  const Json* callouts = layer(d, "callouts");
  ASSERT_NE(callouts, nullptr);
  std::set<std::string> numbers;
  for (const Json& text : callouts->at("texts")) numbers.insert(text.at("text"));
  EXPECT_EQ(numbers, (std::set<std::string>{"1", "2"}));
  // With the plate of glass it is seen.
  ASSERT_EQ(run("draw @/a.burin.json -o @/a.json --callouts --ghost plate"), 0) << err_;
  EXPECT_EQ(err_.find("no callout"), std::string::npos) << err_;
  EXPECT_EQ(layer(drawing(), "callouts")->at("texts").size(), 3U);
  // What is hidden on purpose has no row and keeps its number.
  ASSERT_EQ(run("draw @/a.burin.json -o @/a.json --callouts --hide plate"), 0) << err_;
  EXPECT_EQ(drawing().at("items").size(), 2U);
  EXPECT_EQ(drawing().at("items")[0].at("number"), 2);
}

TEST_F(Items, KeepTheNumbersOfTheIllustration) {
  write_illustration(R"(, "callouts": true, "items": {"7": "plate", "4": "gone"})");
  ASSERT_EQ(run("draw @/a.burin.json -o @/a.json"), 0) << err_;
  std::set<int> numbers;
  const Json d = drawing();
  for (const Json& item : d.at("items")) numbers.insert(item.at("number").get<int>());
  EXPECT_EQ(numbers, (std::set<int>{7, 8, 9}));
  EXPECT_NE(d.at("diagnostics").dump().find("4 'gone'"), std::string::npos);
  ASSERT_EQ(run("draw @/a.burin.json -o @/a.json --no-callouts"), 0) << err_;
  EXPECT_EQ(layer(drawing(), "callouts"), nullptr);
  for (const char* bad : {R"({"0": "a"})", R"({"x": "a"})", R"({"1": ""})", R"({"1": 2})", "[1]",
                          R"({"1": "a", "2": "a"})", R"({"100000": "a"})"}) {
    write_illustration(std::string(", \"items\": ") + bad);
    EXPECT_EQ(run("draw @/a.burin.json -o @/a.json"), 2) << bad;
    expect_error("a.burin.json:5: ");
  }
}

TEST_F(Items, AreRenamedByTheIllustration) {
  write_illustration(R"(, "items": {"2": "Würfel", "1": {"name": "Platte", "select": "plate"}})");
  ASSERT_EQ(run("draw @/a.burin.json -o @/a.json -o @/a.html --parts-list @/l.csv"), 0) << err_;
  const std::string csv = test::slurp(folder_ / "l.csv");
  EXPECT_NE(csv.find("\r\n1,Platte,1,"), std::string::npos) << csv;
  EXPECT_NE(csv.find("\r\n2,Würfel,2,"), std::string::npos) << csv;
  EXPECT_NE(csv.find("\r\n3,"), std::string::npos) << csv;
  EXPECT_NE(test::slurp(folder_ / "a.html").find("data-parts=\"/cube_1;/cube_2\""),
            std::string::npos);
  // What a drawing file holds comes out of it again.
  ASSERT_EQ(run("convert @/a.json -o @/b.html"), 0) << err_;
  EXPECT_NE(test::slurp(folder_ / "b.html").find("data-parts=\"/cube_1;/cube_2\""),
            std::string::npos);
  // A number alone leaves the name.
  write_illustration(R"(, "items": {"7": {"select": "plate"}})");
  ASSERT_EQ(run("draw @/a.burin.json -o @/a.json --parts-list @/l.csv"), 0) << err_;
  EXPECT_NE(test::slurp(folder_ / "l.csv").find("\r\n7,plate,1,"), std::string::npos);
  for (const char* bad : {R"({"1": {}})", R"({"1": {"name": "a", "of": "b"}})",
                          R"({"1": {"name": "all", "select": "*"}})"}) {
    write_illustration(std::string(", \"items\": ") + bad);
    EXPECT_EQ(run("draw @/a.burin.json -o @/a.json --callouts"), 2) << bad;
  }
}

TEST_F(Items, AreWrittenIntoAFirstIllustration) {
  ASSERT_EQ(run("illustrate @/box.off -o @/n.burin.json --callouts --parts-list sheet"), 0) << err_;
  const Json file = Json::parse(test::slurp(folder_ / "n.burin.json"));
  EXPECT_EQ(file.at("items"), Json({{"1", "box"}}));
  EXPECT_EQ(file.at("callouts"), true);
  ASSERT_EQ(run("draw @/n.burin.json -o @/a.json"), 0) << err_;
  EXPECT_NE(layer(drawing(), "callouts"), nullptr);
  EXPECT_NE(layer(drawing(), "parts_list"), nullptr);
}

TEST_F(Items, OfBadRequestsAreOneLine) {
  ASSERT_EQ(run("draw @/box.off -o @/a.svg --parts-list @/l.txt"), 2);
  expect_error("--parts-list takes sheet, FILE.csv or FILE.json");
  ASSERT_EQ(run("draw @/box.off -o @/l.json --parts-list @/l.json"), 2);
  expect_error("would take the place of another file");
  ASSERT_EQ(run("draw @/box.off -o @/a.svg --parts-list @/none/l.csv"), 4);
  expect_error("the folder does not exist");
  ASSERT_EQ(run("draw @/box.off -o @/a.svg --set callout.height=3"), 0);
  EXPECT_NE(err_.find("callout.height has no effect without option --callouts"), std::string::npos);
}

TEST_F(Items, AreTheSameTextsInAllFormats) {
  write_illustration();
  ASSERT_EQ(run("draw @/a.burin.json -o @/a.json -o @/a.svg -o @/a.dxf -o @/a.eps -o @/a.pdf "
                "--callouts --parts-list sheet --ghost plate"),
            0)
      << err_;
  const std::string svg = test::slurp(folder_ / "a.svg");
  EXPECT_NE(svg.find("id=\"Hotspot.3\" class=\"callout callout_3 hotspot_3\" data-item=\"3\""),
            std::string::npos);
  EXPECT_NE(svg.find("kernel, &quot;hidden&quot;</text>"), std::string::npos);
  EXPECT_NE(svg.find("class=\"part part_2\" data-item=\"2\" data-path=\"cube_1\""),
            std::string::npos);
  const std::string dxf = test::slurp(folder_ / "a.dxf");
  EXPECT_NE(dxf.find("\nkernel, \"hidden\"\n"), std::string::npos);
  // What a drawing file holds is what comes of it later.
  ASSERT_EQ(run("convert @/a.json -o @/b.svg -o @/b.json -o @/b.dxf -o @/b.eps"), 0) << err_;
  // Places are rounded on the way, no more.
  EXPECT_EQ(std::ranges::count(test::slurp(folder_ / "b.svg"), '\n'),
            std::ranges::count(svg, '\n'));
  EXPECT_EQ(test::slurp(folder_ / "b.json"), test::slurp(folder_ / "a.json"));
  EXPECT_NE(test::slurp(folder_ / "b.dxf").find("\nkernel, \"hidden\"\n"), std::string::npos);
  // Plotters have no letters: there they are lines.
  ASSERT_EQ(run("convert @/a.json -o @/c.svg --set svg.flatten=true"), 0) << err_;
  EXPECT_EQ(test::slurp(folder_ / "c.svg").find("<text"), std::string::npos);
  EXPECT_NE(test::slurp(folder_ / "c.svg").find("<polyline class=\"text\""), std::string::npos);
  ASSERT_EQ(run("convert @/a.json -o @/d.svg --set svg.merge=true"), 0) << err_;
  EXPECT_NE(test::slurp(folder_ / "d.svg").find("<text"), std::string::npos);
}

TEST_F(Items, LeaveRoomAndAreTheSameForAnyNumberOfThreads) {
  write_illustration();
  ASSERT_EQ(run("draw @/a.burin.json -o @/a.json -o @/a.svg --callouts --parts-list sheet"), 0);
  const Json d = drawing();
  EXPECT_EQ(err_.find("cut"), std::string::npos) << err_;
  for (const Json& l : d.at("layers")) {
    for (const Json& path : l.at("paths")) {
      for (const Json& p : path.at("points")) {
        EXPECT_GE(p[0].get<double>(), 10 - 0.1);
        EXPECT_LE(p[0].get<double>(), 287 + 0.1);
        EXPECT_GE(p[1].get<double>(), 10 - 0.1);
        EXPECT_LE(p[1].get<double>(), 200 + 0.1);
      }
    }
  }
  ASSERT_EQ(run("draw @/a.burin.json -o @/b.svg --callouts --parts-list sheet --threads 1"), 0);
  EXPECT_EQ(test::slurp(folder_ / "a.svg"), test::slurp(folder_ / "b.svg"));
}

TEST_F(Items, MakeASheetThatFitsAsLargeAsTheyNeed) {
  write_illustration();
  for (const char* more : {"", " --perspective 30"}) {
    ASSERT_EQ(run(std::string("draw @/a.burin.json -o @/a.json --paper fit --scale 1:3 --callouts "
                              "--parts-list sheet --ghost plate") +
                  more),
              0)
        << err_;
    EXPECT_EQ(err_, "");
    const Json d = drawing();
    EXPECT_EQ(layer(d, "callouts")->at("texts").size(), 3U);
    EXPECT_NE(layer(d, "parts_list"), nullptr);
    expect_sound(d);
    EXPECT_LT(d.at("paper").at("width").get<double>(), 250) << "no larger than it must";
  }
}

TEST_F(Items, OfRealAssembliesAreThoseKnownByHand) {
  const fs::path root = fs::path(BURIN_TEST_DATA) / "step";
  int seen = 0;
  for (const char* file :
       {"pythonocc/as1-oc-214.stp", "gmsh/as1-tu-203.stp", "freecad/as1-ac-214.stp"}) {
    if (!fs::exists(root / file)) continue;
    ++seen;
    ASSERT_EQ(run("draw " + (root / file).string() + " -o @/a.json --callouts --style outline"), 0)
        << err_;
    std::map<std::string, std::size_t> quantities;
    const Json d = drawing();
    for (const Json& item : d.at("items")) {
      std::string name = item.at("name");
      std::ranges::transform(name, name.begin(), [](char c) { return std::tolower(c); });
      quantities[name] = item.at("quantity").get<std::size_t>();
    }
    EXPECT_EQ(quantities, (std::map<std::string, std::size_t>{
                              {"plate", 1}, {"l-bracket", 2}, {"bolt", 6}, {"nut", 8}, {"rod", 1}}))
        << file;
    EXPECT_EQ(layer(d, "callouts")->at("texts").size(), 5U) << file;
    expect_sound(d);
  }
  if (seen == 0) GTEST_SKIP() << "no real models";
}

TEST_F(Items, OfTheCouplingHaveTheirAnchorsOnTheirParts) {
  const std::string coupling = std::string(BURIN_SOURCE_DIR) + "/samples/coupling.step";
  for (const char* view : {"iso", "front", "-1,-2,0.3", "top"}) {
    for (const char* layout : {"columns", "rows", "around"}) {
      ASSERT_EQ(run("draw " + coupling +
                    " -o @/a.json --style outline --paper A4 --callouts --view=" + view +
                    " --set callout.layout=" + layout),
                0)
          << err_;
      const Json d = drawing();
      ASSERT_EQ(d.at("items").size(), 8U);
      const std::size_t shown = layer(d, "callouts")->at("texts").size();
      const bool told = err_.find("have no callout") != std::string::npos;
      EXPECT_TRUE(shown == 8 || (shown < 8 && told)) << view << " " << err_;
      expect_sound(d);
    }
  }
  ASSERT_EQ(run("draw " + coupling +
                " -o @/a.json --style outline --paper A4 --callouts --perspective 30"),
            0);
  expect_sound(drawing());
}

/// What the page does is asked of it in a browser without a window.
TEST_F(Items, AreLinkedInThePage) {
  write_illustration();
  ASSERT_EQ(run("draw @/a.burin.json -o @/a.html --callouts --ghost plate"), 0) << err_;
  std::string page = test::slurp(folder_ / "a.html");
  EXPECT_EQ(page.find("http://"), page.find("http://www.w3.org/")) << "needs no network";
  EXPECT_EQ(page.find("src="), std::string::npos);
  if (!test::has_chromium()) GTEST_SKIP() << "no chromium to open the page in";
  const std::string probe = R"page(<script>
const out = [], q = s => [...document.querySelectorAll(s)];
const fire = (e, t, o = {}) => e.dispatchEvent(new (t === "click" ? MouseEvent :
  t.startsWith("key") ? KeyboardEvent : PointerEvent)(t, {bubbles: true, ...o}));
const marked = () => [...new Set(q(".marked").map(e => e.dataset.item))].join();
const row = n => q('tbody tr[data-item="' + n + '"]')[0];
out.push(q("tbody tr").length, q(".area").length, q("g.callout").length);
fire(row(2).cells[2], "pointerover");
out.push(marked(), q("svg .area.marked").length);
fire(q('g.callout[data-item="3"] text')[0], "pointerover");
out.push(marked(), row(3).className);
fire(q('.area[data-item="2"]')[0], "click");
const kept = marked();
fire(document.body, "pointerover");
out.push(kept, marked(), q("tr.chosen").length);
fire(document.body, "keydown", {key: "Escape"});
out.push(marked());
fire(document.body, "keydown", {key: "ArrowDown"});
fire(document.activeElement, "keydown", {key: "ArrowDown"});
fire(document.activeElement, "keydown", {key: "Enter"});
out.push(q("tr.chosen")[0].dataset.item);
fire(document.body, "keydown", {key: "/"});
out.push(document.activeElement.type);
document.activeElement.value = "CU be";
document.activeElement.dispatchEvent(new Event("input"));
out.push(q("tbody tr:not([hidden])").map(r => r.cells[2].textContent).join());
document.body.innerHTML = "<pre>" + out.join("|") + "</pre>";
</script>)page";
  const std::string said = test::said_by_page(folder_, page, probe);
  EXPECT_EQ(said, "3|4|3|2|2|3|marked|2|2|1||2|search|cube");
}

}  // namespace
}  // namespace burin
