// Several views on one sheet and details at another scale, from the command line and from
// illustration files.
#include <burin/camera/view_grid.h>

#include "models.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace burin {
namespace {

using Json = nlohmann::json;

Vec2 vec2(const Json& p) { return {p[0].get<double>(), p[1].get<double>()}; }
Vec3 vec3(const Json& p) { return {p[0].get<double>(), p[1].get<double>(), p[2].get<double>()}; }

class SheetViews : public test::CliTest {
 protected:
  Json drawing() { return Json::parse(test::slurp(folder_ / "a.json")); }

  struct View {
    std::string name;
    Box2 box;
    Json numbers;

    Vec2 project(Vec3 p) const {
      const Vec3 q = p - vec3(numbers.at("center"));
      return numbers.at("scale").get<double>() *
                 Vec2(glm::dot(q, vec3(numbers.at("right"))), glm::dot(q, vec3(numbers.at("up")))) +
             vec2(numbers.at("offset"));
    }
  };

  static std::vector<View> views_of(const Json& drawing) {
    std::vector<View> views;
    for (const Json& view : drawing.at("views")) {
      views.push_back(
          {view.at("name"), {vec2(view.at("box")[0]), vec2(view.at("box")[1])}, view.at("view")});
    }
    return views;
  }

  /// How many points of lines each view has; each point is where the numbers of its view say.
  static std::map<std::string, int> points_of(const Json& drawing) {
    std::map<std::string, int> count;
    for (const Json& layer : drawing.at("layers")) {
      for (const Json& path : layer.at("paths")) {
        if (path.at("kind") == "frame" || path.at("kind") == "leader") continue;
        for (std::size_t i = 0; i < path.at("points").size(); ++i) {
          const Vec2 p = vec2(path.at("points")[i]);
          int found = 0;
          for (const View& view : views_of(drawing)) {
            const Box2 wide{view.box.min - 0.02, view.box.max + 0.02};
            if (!wide.contains(p)) continue;
            ++found;
            ++count[view.name];
            EXPECT_LT(glm::distance(view.project(vec3(path.at("points3")[i])), p), 1e-3)
                << view.name;
          }
          EXPECT_EQ(found, 1) << p.x << ", " << p.y;
        }
      }
    }
    return count;
  }

  static const Json* layer(const Json& drawing, const std::string& name) {
    for (const Json& l : drawing.at("layers")) {
      if (l.at("name") == name) return &l;
    }
    return nullptr;
  }
};

TEST_F(SheetViews, TakeAScaleOfIso5455WhereAsked) {
  const auto scale_of = [&](const std::string& options) {
    EXPECT_EQ(run("draw @/box.off --style outline -o @/a.json " + options), 0) << err_;
    return drawing().at("view").at("scale").get<double>();
  };
  for (const char* views : {"", "--views front,top,left,iso ", "--detail 40,30,20,4=5:1 ",
                            "--callouts --parts-list sheet "}) {
    const std::string sheet = std::string("--paper A4 ") + views;
    const double most = scale_of(sheet), iso = scale_of(sheet + "--scale iso");
    EXPECT_EQ(iso, standard_scale(most)) << views;
  }
  EXPECT_EQ(scale_of("--scale ISO --view front --paper A5"), 2);
  EXPECT_EQ(run("draw @/box.off --scale iso --paper fit -o @/a.json"), 2);
  EXPECT_NE(err_.find("--scale iso is the largest of ISO 5455 that fits on a sheet"), err_.npos)
      << err_;
  EXPECT_EQ(run("draw @/box.off --scale iso --perspective 30 -o @/a.json"), 2);
  EXPECT_NE(err_.find("leave --scale iso out"), err_.npos) << err_;
  folder_.write("a.burin.json",
                R"({"burin": "illustration", "version": 1, "parts": [{"file": "box.off"}],
 "view": {"from": "front", "scale": "iso"}, "details": [{"at": [40, 30, 20], "radius": 4,
 "scale": "iso"}]})");
  ASSERT_EQ(run("draw @/a.burin.json -o @/a.json"), 0) << err_;
  const double detail = drawing().at("views")[1].at("view").at("scale").get<double>();
  EXPECT_NEAR(detail, standard_scale(detail * (1 + 1e-9)), 1e-9);
}

TEST_F(SheetViews, HaveATitleBlockWithTheirScaleAndMethod) {
  ASSERT_EQ(run("draw @/box.off --views front,top --style outline --scale iso --title-block iso "
                "--title-block-field number=A-1 --title-block-field author=Smith -o @/a.json "
                "-o @/a.svg -o @/a.dxf"),
            0)
      << err_;
  const Json first = drawing();
  const Json* block = layer(first, "title_block");
  ASSERT_NE(block, nullptr);
  EXPECT_EQ(layer(first, "projection"), nullptr) << "it is in the block";
  std::set<std::string> said;
  Box2 all;
  for (const Json& text : block->at("texts")) {
    said.insert(text.at("text"));
    EXPECT_EQ(text.at("role"), "title_block");
  }
  for (const Json& path : block->at("paths")) {
    EXPECT_EQ(path.at("kind"), "frame");
    for (const Json& p : path.at("points")) all.add(vec2(p));
  }
  for (const char* text : {"A-1", "Smith", "box", "box.off", "2:1"}) {
    EXPECT_TRUE(said.contains(text)) << text;
  }
  EXPECT_EQ(all.min, Vec2(107, 10));
  EXPECT_EQ(all.max, Vec2(287, 46));
  for (const View& view : views_of(first)) EXPECT_FALSE(view.box.overlaps(all)) << view.name;
  EXPECT_NE(test::slurp(folder_ / "a.svg").find("id=\"title_block\""), std::string::npos);
  EXPECT_NE(test::slurp(folder_ / "a.dxf").find("\n2\ntitle_block\n"), std::string::npos);
  const std::string svg = test::slurp(folder_ / "a.svg");
  ASSERT_EQ(run("draw @/box.off --style outline --title-block iso -o @/a.json -o @/a.svg"), 0);
  EXPECT_FALSE(drawing().contains("items"));
  EXPECT_EQ(test::slurp(folder_ / "a.svg").find("\"areas\""), std::string::npos);
}

TEST_F(SheetViews, HaveTheTitleBlockOfAnIllustration) {
  folder_.write("t.svg",
                "<svg width='80mm' height='20mm' viewBox='0 0 80 20'><path d='M0 0h80v20h-80z' "
                "stroke='#000'/><text id='title' x='2' y='8' font-size='5'>NAME</text>"
                "<text id='number' x='2' y='16' font-size='5'>No.</text></svg>");
  const auto drawn = [&](const std::string& block, const std::string& options = "") {
    folder_.write("a.burin.json", R"({"burin": "illustration", "version": 1, "title": "Kiste",
 "parts": [{"file": "box.off"}], "title_block": )" +
                                      block + "}");
    const int status = run("draw @/a.burin.json --style outline -o @/a.json " + options);
    std::set<std::string> said;
    if (status != 0) return said;
    const Json now = drawing();
    if (const Json* found = layer(now, "title_block")) {
      for (const Json& text : found->at("texts")) said.insert(text.at("text"));
    }
    return said;
  };
  EXPECT_EQ(drawn(R"("t.svg")"), (std::set<std::string>{"Kiste", "No."}));
  EXPECT_EQ(drawn(R"({"template": "t.svg", "number": "7"})"),
            (std::set<std::string>{"Kiste", "7"}));
  EXPECT_TRUE(drawn(R"({"number": "7", "company": "ACME"})").contains("ACME"));
  // Options go over it, field by field.
  const auto over = drawn(R"({"number": "7", "company": "ACME"})", "--title-block-field number=8");
  EXPECT_TRUE(over.contains("8") && over.contains("ACME") && !over.contains("7"));
  EXPECT_TRUE(drawn(R"({"number": "7"})", "--title-block none").empty());
  EXPECT_EQ(err_.find("title-block"), std::string::npos) << err_;
  drawn(R"({"numbr": "7"})");
  EXPECT_NE(err_.find("a.burin.json:2: "), std::string::npos) << err_;
  EXPECT_NE(err_.find("number"), std::string::npos) << err_;
  drawn(R"({"sheet": 1})");
  EXPECT_NE(err_.find("a.burin.json:2: \"sheet\" takes text"), std::string::npos) << err_;
  drawn(R"("x.svg")");
  EXPECT_NE(err_.find("x.svg: there is no such drawing"), std::string::npos) << err_;
}

TEST_F(SheetViews, RefuseWhatIsNoTitleBlockInOneLine) {
  const auto refused = [&](const std::string& options, int status, const std::string& says) {
    EXPECT_EQ(run("draw @/box.off -o @/a.json " + options), status) << options;
    EXPECT_NE(err_.find(says), std::string::npos) << err_;
    EXPECT_EQ(std::ranges::count(err_, '\n'), 1) << err_;
  };
  refused("--title-block isoo", 2, "--title-block takes iso, none or FILE.svg, not 'isoo'");
  refused("--title-block @", 2, "--title-block takes iso, none or FILE.svg");
  refused("--title-block @/none.svg", 3, "none.svg: there is no such drawing");
  folder_.write("bad.svg", "<svg>\n<g></svg>");
  refused("--title-block @/bad.svg", 3, "bad.svg:2: bad XML");
  refused("--title-block iso --title-block-field nubmer=1", 2, "with a name of title, ");
  ASSERT_EQ(run("draw @/box.off --style outline --title-block-field number=1 -o @/a.json"), 0);
  EXPECT_NE(err_.find("--title-block-field has no effect without"), std::string::npos) << err_;
  ASSERT_EQ(run("draw @/box.off --style outline --paper 105x74 --title-block iso -o @/a.json"), 0);
  EXPECT_NE(err_.find("does not fit beside the drawing on a sheet of 105 x 74 mm"),
            std::string::npos)
      << err_;
}

TEST_F(SheetViews, StandAboutTheFrontViewAtOneScale) {
  ASSERT_EQ(run("draw @/box.off --views front,top,left,iso --style outline --verify -o @/a.json"),
            0)
      << err_;
  const Json first = drawing();
  const std::vector<View> views = views_of(first);
  ASSERT_EQ(views.size(), 4U);
  EXPECT_EQ(first.at("view"), first.at("views")[0].at("view"));
  EXPECT_EQ(first.at("stats").at("verify").at("count"), 0);
  std::set<double> scales;
  for (const View& view : views) scales.insert(view.numbers.at("scale").get<double>());
  EXPECT_EQ(scales.size(), 1U);
  const auto count = points_of(first);
  EXPECT_EQ(count.size(), 4U);
  // A corner of the box has one x in front and top, one y in front and left.
  const Vec3 corner(40, 30, 20);
  EXPECT_NEAR(views[0].project(corner).x, views[1].project(corner).x, 1e-9);
  EXPECT_NEAR(views[0].project(corner).y, views[2].project(corner).y, 1e-9);
  EXPECT_LT(views[1].project(corner).y, views[0].project(corner).y);
  EXPECT_GT(views[2].project(corner).x, views[0].project(corner).x);
  ASSERT_NE(layer(first, "projection"), nullptr);

  ASSERT_EQ(run("draw @/box.off --views front,top,right --projection third --style outline "
                "-o @/a.json"),
            0)
      << err_;
  const std::vector<View> third = views_of(drawing());
  EXPECT_GT(third[1].project(corner).y, third[0].project(corner).y);
  EXPECT_GT(third[2].project(corner).x, third[0].project(corner).x);
}

TEST_F(SheetViews, MayBeDirections) {
  ASSERT_EQ(run("draw @/box.off --views 1,2,3 --style outline -o @/a.json"), 0) << err_;
  EXPECT_EQ(views_of(drawing()).size(), 1U);
  ASSERT_EQ(run("draw @/box.off --views front;1,2,3 --style outline -o @/a.json"), 0) << err_;
  const auto views = views_of(drawing());
  ASSERT_EQ(views.size(), 2U);
  EXPECT_LT(glm::distance(vec3(views[1].numbers.at("direction")), glm::normalize(Vec3(1, 2, 3))),
            1e-6);
  folder_.write("d.burin.json", R"json({"burin": "illustration", "style": "outline",
    "parts": [{"file": "box.off"}], "views": ["front", [1, 2, 3], "0,1,0"],
    "details": ["@index=0"]})json");
  ASSERT_EQ(run("draw @/d.burin.json -o @/a.json"), 0) << err_;
  EXPECT_EQ(views_of(drawing()).size(), 4U);
}

TEST_F(SheetViews, OneAloneStandsInTheMiddle) {
  ASSERT_EQ(run("draw @/box.off --views iso --style outline -o @/a.json"), 0) << err_;
  const Json one = drawing();
  EXPECT_EQ(views_of(one).size(), 1U);
}

TEST_F(SheetViews, ADetailIsTheSamePlaceAtItsScale) {
  for (const std::string more : {"", " --perspective 30"}) {
    ASSERT_EQ(run("draw @/box.off --detail 40,0,20,4=20:1 --paper A3 --style outline --verify "
                  "-o @/a.json" +
                  more),
              0)
        << err_;
    const Json drawn = drawing();
    const std::vector<View> views = views_of(drawn);
    ASSERT_EQ(views.size(), 2U);
    EXPECT_EQ(views[1].name, "A");
    EXPECT_NEAR(views[1].box.size().x, 2 * 4 * 20, 1e-6);
    EXPECT_EQ(drawn.at("stats").at("verify").at("count"), 0);
    if (!more.empty()) continue;
    EXPECT_NEAR(views[1].numbers.at("scale").get<double>(), 20, 1e-9);
    const Vec2 middle = views[1].box.center();
    EXPECT_LT(glm::distance(views[1].project({40, 0, 20}), middle), 1e-6);
    const auto count = points_of(drawn);
    EXPECT_GE(count.at("A"), 6);  // three edges meet there
    const Json* marks = layer(drawn, "details");
    ASSERT_NE(marks, nullptr);
    EXPECT_EQ(marks->at("paths").size(), 2U);
    std::set<std::string> texts;
    for (const Json& text : marks->at("texts")) texts.insert(text.at("text").get<std::string>());
    EXPECT_EQ(texts, (std::set<std::string>{"A", "A (20:1)"}));
    for (const Json& p : marks->at("paths")[0].at("points")) {
      EXPECT_NEAR(glm::distance(vec2(p), views[0].project({40, 0, 20})),
                  4 * views[0].numbers.at("scale").get<double>(), 1e-3);
    }
  }
}

TEST_F(SheetViews, AnIllustrationHasThemAll) {
  folder_.write("a.burin.json", R"json({"burin": "illustration", "style": "outline",
    "parts": [{"file": "box.off", "name": "plate"},
              {"function": "sphere(4)", "name": "ball", "place": {"translate": [20, 15, 24]}},
              {"function": "sphere(3)", "name": "core", "place": {"translate": [20, 15, 10]}}],
    "views": ["front", "top", "iso"], "projection": "third", "callouts": true,
    "paper": {"size": "A3"}, "parts_list": "sheet",
    "details": [{"select": "ball", "letter": "X"}, "40,0,20,5=5:1", {"select": "core"}]})json");
  ASSERT_EQ(run("draw @/a.burin.json -o @/a.json -o @/a.svg -o @/a.html"), 0) << err_;
  EXPECT_EQ(err_.find("detail B"), std::string::npos) << "the plate before it is left out";
  const Json drawn = drawing();
  const std::vector<View> views = views_of(drawn);
  ASSERT_EQ(views.size(), 6U);
  EXPECT_EQ(views[3].name, "X");
  EXPECT_EQ(views[4].name, "A");
  const auto count = points_of(drawn);
  EXPECT_GT(count.at("X"), 0);
  EXPECT_GT(count.at("B"), 0);
  // Numbers stand about the pictorial view, on the sheet, and once.
  const Json* callouts = layer(drawn, "callouts");
  ASSERT_NE(callouts, nullptr);
  EXPECT_EQ(callouts->at("texts").size(), 2U);
  for (const Json& text : callouts->at("texts")) {
    EXPECT_TRUE(views[2].box.contains(vec2(text.at("at"))));
  }
  ASSERT_NE(layer(drawn, "parts_list"), nullptr);
}

TEST_F(SheetViews, WrittenAsAskedFor) {
  ASSERT_EQ(run("illustrate @/box.off --views front,iso --projection third --detail box=2:1 "
                "-o @/b.burin.json"),
            0)
      << err_;
  const Json file = Json::parse(test::slurp(folder_ / "b.burin.json"));
  EXPECT_EQ(file.at("views"), "front,iso");
  EXPECT_EQ(file.at("projection"), "third");
  EXPECT_EQ(file.at("details")[0], "box=2:1");
  ASSERT_EQ(run("draw @/b.burin.json --paper A2 --style outline -o @/a.json"), 0) << err_;
  EXPECT_EQ(views_of(drawing()).size(), 3U);
}

TEST_F(SheetViews, SayWhatTheyCannotDo) {
  const auto refused = [&](const std::string& options, const std::string& part) {
    EXPECT_EQ(run("draw @/box.off --style outline -o @/a.json " + options), 2) << options;
    expect_error(part);
  };
  refused("--views front,fornt", "fornt");
  refused("--views front,front", "each view once");
  refused("--views front,top --perspective 30", "orthographic");
  refused("--views front --paper fit", "a sheet of a fixed size");
  refused("--detail nut", "nut");
  refused("--detail box=100:1", "no room");
  refused("--detail 1,2,3,0", "takes X,Y,Z,R with a radius R over 0");
  refused("--projection fourth", "first or third");
  folder_.write("c.burin.json", R"json({"burin": "illustration",
    "parts": [{"file": "box.off"}],
    "details": [{"at": [0, 0, 0]}]})json");
  EXPECT_EQ(run("draw @/c.burin.json -o @/a.json"), 2);
  expect_error("c.burin.json:3: a detail at a point has \"radius\"");
}

TEST_F(SheetViews, WhatChangesNothingIsTold) {
  ASSERT_EQ(run("draw @/box.off --style outline --views front,top --center 1,2,3 "
                "--detail 500,0,0,2=5:1 -o @/a.json"),
            0)
      << err_;
  EXPECT_NE(err_.find("--center has no effect beside option --views"), std::string::npos) << err_;
  EXPECT_NE(err_.find("detail A is empty"), std::string::npos) << err_;
  ASSERT_EQ(run("draw @/box.off --style outline --projection third -o @/a.json"), 0);
  EXPECT_NE(err_.find("--projection has no effect without option --views"), std::string::npos)
      << err_;
}

TEST_F(SheetViews, ADetailNoLargerThanTheViewIsTold) {
  ASSERT_EQ(run("draw @/box.off --style outline --detail 0,0,0,5=1:10 -o @/a.json"), 0);
  EXPECT_NE(err_.find("no larger than the view"), std::string::npos) << err_;
}

// With numbers, and what to do.
TEST_F(SheetViews, ASheetThatIsMostlyEmptyIsTold) {
  ASSERT_EQ(run("draw @/box.off --style outline --scale 1:10 -o @/a.json"), 0) << err_;
  EXPECT_NE(err_.find("mm of a sheet of 297 x 210 mm"), std::string::npos) << err_;
  EXPECT_NE(err_.find("a --scale of 2:1 would fill it, --paper fit makes"), std::string::npos)
      << err_;
  // At that scale, and on such a sheet, nothing is told.
  ASSERT_EQ(run("draw @/box.off --style outline --scale 2:1 -o @/a.json"), 0);
  EXPECT_EQ(err_, "");
  ASSERT_EQ(run("draw @/box.off --style outline --scale 1:10 --paper fit -o @/a.json"), 0);
  EXPECT_EQ(err_, "");
  // A long thin part, fitted.
  folder_.write("wire.off", test::off_text(test::box({0, 0, 0}, {400, 2, 2})));
  ASSERT_EQ(run("draw @/wire.off --style outline --view front -o @/a.json"), 0);
  EXPECT_NE(err_.find("--paper fit makes the sheet as large as the drawing"), std::string::npos)
      << err_;
  EXPECT_EQ(err_.find("--scale"), std::string::npos) << err_;
}

TEST_F(SheetViews, AViewThatIsSmallBesideItsDetailIsTold) {
  ASSERT_EQ(run("draw @/box.off --style outline --paper A4 --detail 40,0,20,8=11:1 -o @/a.json"), 0)
      << err_;
  EXPECT_NE(err_.find("mm large, its detail A 176 mm: give the detail a smaller scale than 11:1"),
            std::string::npos)
      << err_;
  ASSERT_EQ(run("draw @/box.off --style outline --paper A4 --detail 40,0,20,8=5:1 -o @/a.json"), 0)
      << err_;
  EXPECT_EQ(err_, "");
}

/// Two boxes, the inner one wholly in the outer.
constexpr const char* kNested =
    "module shell() cube([40, 30, 20]);\n"
    "module core() translate([10, 10, 5]) cube([20, 10, 10]);\n"
    "shell(); core();\n";

int paths_of(const Json& drawing, int part, bool visible, Box2 within) {
  int count = 0;
  for (const Json& layer : drawing.at("layers")) {
    for (const Json& path : layer.at("paths")) {
      if (path.at("part") != part || path.value("visible", true) != visible) continue;
      count += within.contains(vec2(path.at("points")[0])) ? 1 : 0;
    }
  }
  return count;
}

TEST_F(SheetViews, ThatAreNamedAloneHaveHiddenLines) {
  folder_.write("nested.scad", kNested);
  const std::string sheet = "draw @/nested.scad --style outline --hidden dashed -o @/a.json ";
  const auto hidden_in = [&](const std::string& more) {
    EXPECT_EQ(run(sheet + more), 0) << err_;
    std::set<std::string> found;
    const Json all = drawing();
    for (const View& view : views_of(all)) {
      if (paths_of(all, 1, false, view.box) > 0) found.insert(view.name);
    }
    return found;
  };
  using Names = std::set<std::string>;
  EXPECT_EQ(hidden_in("--views front,top,iso"), (Names{"front", "top", "iso"}));
  EXPECT_EQ(hidden_in("--views front,top,iso --hidden-views front,top"), (Names{"front", "top"}));
  EXPECT_EQ(hidden_in("--views front,top --section-view z --hidden-views top"), Names{"top"});
  EXPECT_EQ(run(sheet + "--views front,top --hidden-views iso"), 2);
  EXPECT_EQ(err_,
            "burin: error: --hidden-views: 'iso' is none of the views of the sheet: front, "
            "top\n");
  EXPECT_EQ(run("draw @/nested.scad --views front,top --hidden-views top -o @/a.json"), 0);
  EXPECT_NE(err_.find("--hidden-views has no effect without option --hidden"), std::string::npos);
}

TEST_F(SheetViews, ADetailOfAHiddenPartShowsItWithoutWhatIsBeforeIt) {
  folder_.write("nested.scad", kNested);
  ASSERT_EQ(run("draw @/nested.scad --style flat --detail core --verify -o @/a.json"), 0) << err_;
  const Json all = drawing();
  const std::vector<View> views = views_of(all);
  ASSERT_EQ(views.size(), 2u);
  EXPECT_EQ(paths_of(all, 1, true, views[0].box), 0);
  EXPECT_GT(paths_of(all, 1, true, views[1].box), 2);
  EXPECT_EQ(paths_of(all, 0, true, views[1].box), 0) << "it is left out";
  EXPECT_EQ(all.at("stats").at("verify").at("wrong_patches"), 0) << all.at("stats");
  bool told = false;
  for (const Json& one : all.at("diagnostics")) told = told || one.at("code") == "detail.opened";
  EXPECT_TRUE(told);
}

}  // namespace
}  // namespace burin
