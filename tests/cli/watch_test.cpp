#include "models.h"
#include "pages.h"

#include <chrono>
#include <filesystem>
#include <optional>

namespace burin {
namespace {

namespace fs = std::filesystem;
using test::slurp;

/// The command under way, and what it has said.
class Watch : public test::CliTest {
 protected:
  void TearDown() override {
    if (watch_) watch_->signal(SIGKILL);
  }

  void watch(std::vector<std::string> words) {
    words.insert(words.begin(), "watch");
    give_sheet(words);
    watch_.emplace(folder_, words);
  }

  /// Waits until it has said `text` so many times.
  bool said(const std::string& text, int times) const {
    for (int i = 0; i < 1500; ++i) {  // 15 s
      if (count(text) >= times) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    ADD_FAILURE() << "not " << times << " times '" << text << "': " << slurp(folder_ / ".stderr");
    return false;
  }
  bool drawn(int times) const { return said("burin: drawn in", times); }

  int count(const std::string& text) const {
    const std::string all = slurp(folder_ / ".stderr");
    int n = 0;
    for (std::size_t at = all.find(text); at != std::string::npos; at = all.find(text, at + 1)) ++n;
    return n;
  }

  /// The bytes that `burin draw` gives for the same.
  std::string fresh(const std::string& rest) {
    test::Folder apart;
    std::vector<std::string> words = words_of("draw " + rest + " -o " + (apart / "fresh.svg"));
    give_sheet(words);
    test::Command draw(apart, words);
    EXPECT_EQ(draw.wait(), 0) << draw.std_err;
    return slurp(apart / "fresh.svg");
  }

  /// Ends it as Ctrl-C does.
  void expect_clean_end() {
    watch_->signal(SIGINT);
    EXPECT_EQ(watch_->wait(), 5) << watch_->std_err;
    EXPECT_TRUE(watch_->std_err.ends_with("burin: stopped watching\n")) << watch_->std_err;
    for (const auto& entry : fs::directory_iterator(folder_.path())) {
      EXPECT_NE(entry.path().extension(), ".part") << entry.path();
    }
  }

  std::string out() const { return slurp(folder_ / "out.svg"); }
  static std::string cube(double side) {
    return test::off_text(test::box({0, 0, 0}, {side, 30, 20}));
  }

  std::optional<test::Command> watch_;
};

TEST_F(Watch, DrawsAgainWhenTheModelChanges) {
  watch({box_, "-o", folder_ / "out.svg"});
  ASSERT_TRUE(drawn(1));
  EXPECT_EQ(out(), fresh(box_));
  const std::string first = out();
  folder_.write("box.off", cube(10));
  ASSERT_TRUE(drawn(2));
  EXPECT_NE(out(), first);
  EXPECT_EQ(out(), fresh(box_));
  // As editors save: another file takes the name.
  fs::rename(folder_.write("new.off", cube(40)), box_);
  ASSERT_TRUE(drawn(3));
  EXPECT_EQ(out(), first);
  expect_clean_end();
}

TEST_F(Watch, AFaultyFileIsToldAndWatchingGoesOn) {
  watch({box_, "-o", folder_ / "out.svg"});
  ASSERT_TRUE(drawn(1));
  const std::string first = out();
  folder_.write("box.off", "OFF\n1 1 0\n0 0 0\n3 0 1 2\n");
  ASSERT_TRUE(said("burin: not drawn", 1));
  EXPECT_EQ(count("burin: error: " + box_), 1);
  EXPECT_EQ(out(), first);  // what was there stays
  fs::remove(box_);
  ASSERT_TRUE(said("no such file", 1));
  folder_.write("box.off", cube(15));
  ASSERT_TRUE(drawn(2));
  EXPECT_EQ(out(), fresh(box_));
  expect_clean_end();
}

TEST_F(Watch, PagesLearnOfEachDrawing) {
  const std::string page = folder_ / "out.html", live = page + ".live.js";
  watch({box_, "-o", page});
  ASSERT_TRUE(drawn(1));
  EXPECT_NE(slurp(page).find(".live.js"), std::string::npos);
  const std::string first = slurp(live);
  EXPECT_TRUE(first.starts_with("burin_drawn(")) << first;
  folder_.write("box.off", cube(10));
  ASSERT_TRUE(drawn(2));
  EXPECT_NE(slurp(live), first);
  expect_clean_end();
  EXPECT_FALSE(fs::exists(live));
  // A page that nobody draws anew does not ask.
  test::Folder apart;
  test::Command draw(apart, {"draw", box_, "-o", apart / "one.html", "--paper", kSheet});
  EXPECT_EQ(draw.wait(), 0);
  EXPECT_EQ(slurp(apart / "one.html").find(".live.js"), std::string::npos);
}

/// A page whose drawing is another each time that it asks, until it was loaded three times.
TEST_F(Watch, PagesLoadThemselvesAnew) {
  if (!test::has_chromium()) GTEST_SKIP() << "chromium is not installed";
  watch({box_, "-o", folder_ / "out.html"});
  ASSERT_TRUE(drawn(1));
  std::string page = slurp(folder_ / "out.html");
  expect_clean_end();
  const std::string count =
      "<script>const loads = 1 + Number(sessionStorage.getItem('loads'));"
      "sessionStorage.setItem('loads', loads); document.body.insertAdjacentHTML('beforeend', "
      "`<pre>${loads}</pre>`);</script>";
  page.replace(page.find("</main>"), 0, count);
  folder_.write("p.html", page);
  folder_.write("p.html.live.js",
                "window.times = (window.times || 0) + 1;\n"
                "if (sessionStorage.getItem('loads') < 3) burin_drawn(times);\n");
  const std::string command =
      "timeout 60 chromium --headless=new --no-sandbox --disable-gpu --user-data-dir=" +
      (folder_ / "profile") + " --virtual-time-budget=2500 --dump-dom file://" +
      (folder_ / "p.html") + " > " + (folder_ / "dom") + " 2> " + (folder_ / "said");
  ASSERT_EQ(std::system(command.c_str()), 0) << slurp(folder_ / "said");
  const std::string dom = slurp(folder_ / "dom");
  EXPECT_NE(dom.find("<pre>3</pre>"), std::string::npos) << dom.substr(0, 2000);
}

TEST_F(Watch, SeesStylesAndMotifs) {
  const std::string style = folder_.write(
      "mine.json", R"({"base": "pencil", "hatch.length": 5, "hatch.motif": "star.svg"})");
  const std::string motif = folder_.write("star.svg", R"(<svg><path d="M0 0L10 10"/></svg>)");
  const std::string rest = "--style " + style;
  watch(words_of(box_ + " -o " + (folder_ / "out.svg") + " " + rest));
  ASSERT_TRUE(said("watching 3 files", 1));
  const std::string first = out();
  fs::rename(folder_.write("n.svg", R"(<svg><path d="M0 0L10 0"/></svg>)"), motif);
  ASSERT_TRUE(drawn(2));
  const std::string second = out();
  EXPECT_NE(second, first);
  folder_.write("mine.json", R"({"base": "pencil", "hatch.length": 3, "hatch.motif": "star.svg"})");
  ASSERT_TRUE(drawn(3));
  EXPECT_NE(out(), second);
  EXPECT_EQ(out(), fresh(box_ + " " + rest));
  expect_clean_end();
}

TEST_F(Watch, ReadsModelsAgainOnlyWhereTheyChanged) {
  const auto ring = [](double size) { return test::off_text(test::torus(size, 8, 200, 100)); };
  const auto outline = [&](double width) {
    folder_.write("mine.json", fmt::format(R"({{"base": "outline", "line.outer": {}}})", width));
  };
  const std::string model = folder_.write("ring.off", ring(20));
  outline(0.5);
  const std::string rest = model + " -v --style " + (folder_ / "mine.json");
  watch(words_of(rest + " -o " + (folder_ / "out.svg")));
  // A stage that did not run took no time at all.
  const std::string kept = "stage read 0.0000\n";
  ASSERT_TRUE(drawn(1));
  EXPECT_EQ(count(kept), 0);
  outline(0.6);
  ASSERT_TRUE(drawn(2));
  EXPECT_EQ(count(kept), 1);
  EXPECT_EQ(out(), fresh(rest));
  folder_.write("ring.off", ring(25));
  ASSERT_TRUE(drawn(3));
  EXPECT_EQ(count(kept), 1);
  EXPECT_EQ(out(), fresh(rest));
  outline(0.7);
  ASSERT_TRUE(drawn(4));
  EXPECT_EQ(count(kept), 2);
  EXPECT_EQ(out(), fresh(rest));
  expect_clean_end();
}

TEST_F(Watch, SeesIllustrationsAndWhatTheyExtend) {
  const std::string house =
      folder_.write("house.burin.json", R"({"burin": "illustration", "style": "outline"})");
  const std::string file = folder_.write(
      "a.burin.json",
      R"({"burin": "illustration", "extends": "house.burin.json", "parts": [{"file": "box.off"}]})");
  watch({file, "-o", folder_ / "out.svg"});
  ASSERT_TRUE(said("watching 3 files", 1));
  const std::string first = out();
  folder_.write("house.burin.json", R"({"burin": "illustration", "style": "patent"})");
  ASSERT_TRUE(drawn(2));
  EXPECT_NE(out(), first);
  folder_.write("house.burin.json", R"({"burin": "illustration", "style": "patnet"})");
  ASSERT_TRUE(said(house + ":1: ", 1));  // its one line
  folder_.write("house.burin.json", R"({"burin": "illustration", "style": "outline"})");
  ASSERT_TRUE(drawn(3));
  EXPECT_EQ(out(), first);
  folder_.write("box.off", cube(10));
  ASSERT_TRUE(drawn(4));
  EXPECT_EQ(out(), fresh(file));
  expect_clean_end();
}

TEST_F(Watch, SeesWhatOpenscadFilesTakeIn) {
  // Which files these are is found before OpenSCAD runs, and so also where it fails.
  ::setenv("BURIN_OPENSCAD", (folder_ / "none").c_str(), 1);
  folder_.write("deep.scad", "side = 10;");
  folder_.write("parts.scad", "include <deep.scad>\nmodule part() { cube(side); }");
  const std::string model = folder_.write(
      "m.scad", "// include <none.scad>\nuse <parts.scad>\npart(); import(\"box.off\");");
  watch({model, "-o", folder_ / "out.svg"});
  ::unsetenv("BURIN_OPENSCAD");
  ASSERT_TRUE(said("burin: not drawn; watching 4 files", 1));
  folder_.write("deep.scad", "side = 20;");
  ASSERT_TRUE(said("burin: not drawn; watching 4 files", 2));
  folder_.write("box.off", cube(10));
  ASSERT_TRUE(said("burin: not drawn; watching 4 files", 3));
  expect_clean_end();
}

TEST_F(Watch, AChangeEndsTheDrawingUnderWay) {
  // Half a minute of strokes.
  const std::string slow = folder_.write("slow.off", test::off_text(test::torus(20, 8, 400, 200)));
  watch(words_of(slow + " --style engraving --set hatch.spacing_min=0.45 --set " +
                 "hatch.spacing_max=0.45 --paper A0 --progress -o " + (folder_ / "out.svg")));
  ASSERT_TRUE(said("progress trace", 1));
  fs::copy_file(box_, slow, fs::copy_options::overwrite_existing);
  ASSERT_TRUE(said("slow.off has changed; drawing again\n", 1));
  ASSERT_TRUE(said("progress read", 2));
  expect_clean_end();
}

TEST_F(Watch, TheTimesOfEachDrawingAreItsOwn) {
  watch({box_, "-o", folder_ / "out.svg", "-v"});
  ASSERT_TRUE(drawn(1));
  folder_.write("box.off", cube(10));
  ASSERT_TRUE(drawn(2));
  EXPECT_EQ(count("burin: stage read "), 2);
  EXPECT_EQ(count("burin: total "), 2);
  expect_clean_end();
}

TEST_F(Watch, WhatIsWrongFromTheStartEndsIt) {
  EXPECT_EQ(run("watch @/box.off -o @/out.svg --style oultine"), 2);
  expect_error("outline");
  EXPECT_EQ(run("watch @/bax.off -o @/out.svg"), 3);
  expect_error("no such file");
  EXPECT_EQ(run("watch @/box.off -o @/nofolder/out.svg"), 4);
  expect_error("the folder does not exist");
  EXPECT_EQ(run("watch @/box.off -o - --format svg"), 2);
  expect_error("standard output");
  EXPECT_EQ(run("watch @/box.off"), 2);
  expect_error("burin watch INPUT... -o OUT.svg");
  EXPECT_EQ(run("watch @/box.off -o @/out.svg --style engraving --set hatch.image=@/out.png"), 3);
  expect_error("no such picture");
}

TEST_F(Watch, AnOutputIsNoInput) {
  // A picture that a style names would be drawn over, and then again and again.
  ASSERT_EQ(run("draw @/box.off -o @/a.png"), 0) << err_;
  EXPECT_EQ(run("watch @/box.off -o @/a.png --style engraving --set hatch.image=@/a.png"), 2);
  expect_error("is also an input");
}

}  // namespace
}  // namespace burin
