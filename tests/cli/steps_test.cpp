// Step books from the command line.
#include <burin/camera/view_grid.h>

#include "models.h"
#include "pages.h"

#include <burin_test/pictures.h>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <regex>
#include <set>

namespace burin {
namespace {

namespace fs = std::filesystem;

class Steps : public test::CliTest {
 protected:
  std::string pump() const { return std::string(BURIN_SOURCE_DIR) + "/samples/gear_pump.step"; }

  static std::size_t count(const std::string& text, const std::string& what) {
    std::size_t n = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
      ++n;
    return n;
  }
};

TEST_F(Steps, TheGearPumpIsPutTogetherInElevenSteps) {
  ASSERT_EQ(run("steps " + pump() +
                " -o @/pump.md -o @/pump.pdf -o @/pump.html -o "
                "@/pump.json --style outline"),
            0)
      << err_;
  EXPECT_EQ(err_, "");
  const std::string text = test::slurp(folder_ / "pump.md");
  EXPECT_TRUE(text.starts_with("# gear pump\n")) << text;
  EXPECT_EQ(count(text, "\n## Step "), 11U);
  EXPECT_NE(text.find("## Step 2: idler\n"), std::string::npos);
  EXPECT_NE(text.find("- 6 x screw M6 (10)\n"), std::string::npos);
  EXPECT_NE(text.find("| 10 | 6 | screw M6 |"), std::string::npos);
  // Each picture is there, with what the page lists.
  for (int step = 1; step <= 11; ++step) {
    const std::string name = fmt::format("pump-step-{:02}.svg", step);
    EXPECT_NE(text.find("](" + name + ")"), std::string::npos);
    pugi::xml_document svg;
    ASSERT_TRUE(svg.load_file((folder_ / name).c_str())) << name;
    EXPECT_EQ(std::string(svg.child("svg").child("title").text().get())
                  .rfind(fmt::format("Step {}", step), 0),
              0U);
  }
  // cairo 1.18 packs the list of pages.
  if (test::has_program("pdfinfo")) {
    const fs::path file = folder_ / "pump.pdf", listed = folder_ / "info";
    ASSERT_TRUE(test::shell(fmt::format("pdfinfo {} >{}", file.string(), listed.string())));
    const std::string info = test::slurp(listed);
    EXPECT_TRUE(std::regex_search(info, std::regex("Pages: +12\n"))) << info;
  }
  const auto data = nlohmann::json::parse(test::slurp(folder_ / "pump.json"));
  ASSERT_EQ(data.at("pages").size(), 11U);
  EXPECT_EQ(data.at("pages")[1].at("heading"), "Step 2: idler");
  EXPECT_EQ(data.at("items").size(), 11U);
  std::ofstream(folder_ / "page.json") << data.at("pages")[1].at("drawing");
  ASSERT_EQ(run("convert @/page.json -o @/page.svg"), 0) << err_;
  // What is written twice is rounded twice: the paths are as many.
  EXPECT_EQ(count(test::slurp(folder_ / "page.svg"), "<path"),
            count(test::slurp(folder_ / "pump-step-02.svg"), "<path"));
  const std::string html = test::slurp(folder_ / "pump.html");
  EXPECT_EQ(count(html, "<section id=\"step-"), 11U);
  EXPECT_EQ(count(html, "<tr data-item="), 11U);
  // Ids are of one element each.
  std::set<std::string> ids;
  const std::regex id(" id=\"([^\"]*)\"");
  for (auto it = std::sregex_iterator(html.begin(), html.end(), id); it != std::sregex_iterator();
       ++it) {
    EXPECT_TRUE(ids.insert((*it)[1]).second) << (*it)[1];
  }
}

TEST_F(Steps, ThePageGoesFromTheListToTheFirstStep) {
  ASSERT_EQ(run("steps " + pump() + " -o @/pump.html --style outline"), 0) << err_;
  if (!test::has_chromium()) GTEST_SKIP() << "no chromium to open the page in";
  const std::string probe = R"page(<script>
const out = [], q = s => [...document.querySelectorAll(s)];
let went = "";
Element.prototype.scrollIntoView = function() { if (this.id) went = this.id; };
const row = n => q('tbody tr[data-item="' + n + '"]')[0];
row(10).cells[2].dispatchEvent(new MouseEvent("click", {bubbles: true}));
out.push(went, q("tr.chosen").length, q("section#step-11 .marked").length > 0);
went = "";
q("section#step-7 .area[data-item='2']")[0].dispatchEvent(new MouseEvent("click", {bubbles: true}));
out.push(went, q("tr.chosen")[0].dataset.item);
document.body.innerHTML = "<pre>" + out.join("|") + "</pre>";
</script>)page";
  EXPECT_EQ(test::said_by_page(folder_, test::slurp(folder_ / "pump.html"), probe),
            "step-11|1|true||2");
}

TEST_F(Steps, SameBytesForAnyNumberOfThreads) {
  ASSERT_EQ(run("steps " + pump() + " -o @/a.html --style outline --paper A6 --threads 1"), 0)
      << err_;
  ASSERT_EQ(run("steps " + pump() + " -o @/b.html --style outline --paper A6 --threads 4"), 0)
      << err_;
  EXPECT_EQ(test::slurp(folder_ / "a.html"), test::slurp(folder_ / "b.html"));
}

TEST_F(Steps, PagesOfOneAssemblyHaveOneScaleAndSayWhereItChanges) {
  const auto pages = [&](const std::string& options) {
    EXPECT_EQ(run("steps " + pump() + " -o @/s.json -o @/s.md --style outline" + options), 0);
    EXPECT_EQ(err_, "");
    return nlohmann::json::parse(test::slurp(folder_ / "s.json"))["pages"];
  };
  const auto own = pages("");
  ASSERT_EQ(own.size(), 11U);
  std::map<std::string, std::set<double>> scales;
  std::string before;
  for (std::size_t i = 0; i < own.size(); ++i) {
    const double scale = own[i]["scale"];
    EXPECT_NEAR(scale, double(own[i]["drawing"]["view"]["scale"]), 1e-12 * scale);
    const std::string heading = own[i]["heading"];
    scales[heading.find(':') == std::string::npos ? "" : heading.substr(heading.find(':'))].insert(
        scale);
    // The picture says the scale, unless it is that of the page before.
    const std::string said = scale_text(scale);
    const std::string picture = test::slurp(folder_ / fmt::format("s-step-{:02}.svg", i + 1));
    EXPECT_EQ(picture.find(">" + said + "<") != std::string::npos, said != before) << heading;
    before = said;
  }
  ASSERT_EQ(scales.size(), 5U);  // the pump and four assemblies in it
  for (const auto& [name, all] : scales) EXPECT_EQ(all.size(), 1U) << name;

  for (const auto& page : pages(" --scale iso")) {
    const double scale = page["scale"];
    EXPECT_DOUBLE_EQ(scale, standard_scale(scale));
  }
  // On a small sheet the step stands beside a high column of small pictures.
  EXPECT_GT(double(pages(" --paper A6")[0]["scale"]), 1);
  for (const auto& page : pages(" --scale 1:2")) EXPECT_EQ(double(page["scale"]), 0.5);
  ASSERT_EQ(run("steps " + pump() + " -o @/s.json --style outline --scale 1"), 0);
  EXPECT_NE(err_.find("7 of 11 steps are drawn smaller than 1:1, for which their pages have no "
                      "room: at 1:1.16 and more; use a larger --paper"),
            std::string::npos)
      << err_;
}

// A tower of blocks grows eightfold: its first page would be all but empty at the scale of the
// last.
TEST_F(Steps, AScaleIsLeftWhereAPageCouldBeTwiceAsLarge) {
  std::string parts, steps;
  for (int i = 0; i < 16; ++i) {
    const std::string file = fmt::format("b{}.off", i);
    folder_.write(file,
                  test::off_text(test::box({0, 0, 10.0 * i}, {10, 10 + 0.01 * i, 10.0 * i + 9})));
    parts += fmt::format("{}{{\"file\": \"{}\"}}", i ? "," : "", file);
    if (i > 0) {
      steps = fmt::format("{{\"move\": \"b{}\", \"along\": [0,0,1], \"by\": 20}}{}", i,
                          i > 1 ? "," : "") +
              steps;
    }
  }
  folder_.write("a.burin.json", R"({"burin": "illustration", "style": "outline", "parts": [)" +
                                    parts + R"(], "explode": {"steps": [)" + steps + "]}}");
  ASSERT_EQ(run("steps @/a.burin.json -o @/a.json"), 0) << err_;
  std::vector<double> scales;
  const auto pages = nlohmann::json::parse(test::slurp(folder_ / "a.json"))["pages"];
  for (const auto& page : pages) scales.push_back(page["scale"]);
  ASSERT_EQ(scales.size(), 15U);
  EXPECT_TRUE(std::ranges::is_sorted(scales, std::greater()));
  const std::set<double> several(scales.begin(), scales.end());
  EXPECT_GE(several.size(), 2U);
  EXPECT_LE(several.size(), 4U);
}

TEST_F(Steps, AnIllustrationSaysTheOrderTitleAndWhatIsLeftOut) {
  folder_.write("small.off", test::off_text(test::box({5, 5, 20}, {10, 10, 30})));
  folder_.write("a.burin.json", R"json({"burin": "illustration", "style": "outline",
    "title": "Box | with *lid*", "parts": [
      {"file": "box.off", "name": "box"},
      {"file": "small.off", "name": "lid | 1"},
      {"file": "small.off", "name": "cap", "place": {"translate": [10, 0, 0]}},
      {"file": "small.off", "name": "jig", "place": {"translate": [20, 0, 0]}}],
    "looks": [{"select": "jig", "drawn": false}],
    "explode": {"steps": [{"move": "cap", "along": [0, 0, 1], "by": 40},
                          {"move": "lid | 1", "along": [0, 0, 1], "by": 20}]}})json");
  ASSERT_EQ(run("steps @/a.burin.json -o @/a.md --callouts"), 0) << err_;
  const std::string text = test::slurp(folder_ / "a.md");
  EXPECT_TRUE(text.starts_with("# Box \\| with \\*lid\\*\n")) << text;
  EXPECT_EQ(count(text, "\n## Step "), 2U);
  const std::size_t lid = text.find("lid \\| 1"), cap = text.find("cap");
  EXPECT_LT(lid, cap);
  EXPECT_EQ(text.find("jig"), std::string::npos);
}

TEST_F(Steps, OnePartIsOneStep) {
  ASSERT_EQ(run("steps @/box.off -o @/a.pdf -o @/a.html"), 0) << err_;
  EXPECT_NE(err_.find("there is one part"), std::string::npos) << err_;
  EXPECT_TRUE(fs::exists(folder_ / "a.pdf"));
}

TEST_F(Steps, SayWhatTheyCannotDo) {
  const auto refused = [&](const std::string& line, int status, const std::string& part) {
    EXPECT_EQ(run("steps " + line), status) << line;
    expect_error(part);
  };
  refused("", 2, "no input");
  refused("@/box.off", 2, "no output");
  refused("@/box.off -o @/a.svg", 2, ".pdf, .html, .md or .json");
  refused("@/box.off -o @/a.md -o @/a.md", 2, "another file");
  refused("@/box.off -o @/a.md --items 0", 2, "--items takes a whole number from 1");
  refused("@/box.off -o @/a.md --paper fit", 2, "give --paper one");
  refused("@/box.off -o @/a.md --paper 60x40", 2, "too small for the pages of a step book");
  refused("@/box.off -o @/a.md --scale iso --perspective 40", 2, "leave --scale iso out");
  refused("@/box.off -o @/none/a.md", 4, "folder does not exist");
  refused("@/box.off -o @/a.md --hide box", 2, "nothing is left");
  refused("@/box.off -o @/a.md --explode-factor 2", 2, "unknown option");
  for (const auto& entry : fs::directory_iterator(folder_.path())) {
    EXPECT_EQ(entry.path().filename(), "box.off");
  }
}

}  // namespace
}  // namespace burin
