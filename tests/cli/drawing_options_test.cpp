// The sheet, the ids and the links of a drawing, and what is told of options that change nothing.
#include "models.h"

#include <burin_test/sanitized.h>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <sys/resource.h>

#include <algorithm>
#include <filesystem>

namespace burin {
namespace {

namespace fs = std::filesystem;

class DrawingOptions : public test::CliTest {
 protected:
  pugi::xml_document svg(const std::string& name) const {
    pugi::xml_document doc;
    EXPECT_TRUE(doc.load_file((folder_ / name).c_str()));
    return doc;
  }

  /// That a run drew and said a line of warning for each of `parts`, which holds it, and nothing
  /// else.
  void expect_warnings(const std::string& line, const std::vector<std::string>& parts) {
    ASSERT_EQ(run(line + " -o @/w.json --no-progress"), 0) << err_;
    const auto lines = static_cast<std::size_t>(std::count(err_.begin(), err_.end(), '\n'));
    EXPECT_EQ(lines, parts.size()) << line << ":\n" << err_;
    // Without the words of the console: what stands in the drawing.
    const auto drawing = nlohmann::json::parse(test::slurp(folder_ / "w.json"));
    ASSERT_EQ(drawing["diagnostics"].size(), parts.size()) << drawing["diagnostics"];
    for (const std::string& part : parts) {
      const std::size_t at = err_.find(part);
      ASSERT_NE(at, std::string::npos) << err_ << " lacks " << part;
      EXPECT_TRUE(err_.substr(err_.rfind('\n', at) + 1).starts_with("burin: warning: ")) << err_;
      EXPECT_TRUE(std::ranges::any_of(drawing["diagnostics"], [&](const auto& one) {
        return one["message"].template get<std::string>().find(part) != std::string::npos;
      })) << part;
    }
  }
  void expect_warning(const std::string& line, const std::string& part) {
    expect_warnings(line, {part});
  }
};

TEST_F(DrawingOptions, SheetsOfEveryKind) {
  const auto size = [&](const std::string& options) {
    EXPECT_EQ(run("draw @/box.off -o @/a.svg --quiet " + options), 0) << err_;
    const pugi::xml_document doc = svg("a.svg");
    const auto root = doc.child("svg");
    return std::string(root.attribute("width").value()) + " " + root.attribute("height").value();
  };
  EXPECT_EQ(size("--paper b5 --view ISO"), "250mm 176mm");
  EXPECT_EQ(size("--paper LegalP"), "215.9mm 355.6mm");
  EXPECT_EQ(size("--paper fit --view front --scale 2:1 --margin 1,2,3,4"), "86mm 44mm");
  EXPECT_EQ(size("--paper Fit --view front --margin 0"), "40mm 20mm");
  EXPECT_NE(size("--paper fit --perspective 30 --scale 1:2"), "297mm 210mm");
}

TEST_F(DrawingOptions, ScalesAndMarginsThatAreNone) {
  const auto refused = [&](const std::string& options, const std::string& part) {
    EXPECT_EQ(run("draw @/box.off -o @/a.svg " + options), 2) << options;
    expect_error(part);
  };
  for (const char* scale : {"1:0", "0:1", ":2", "1:", "1:2:3", "-1:2", "nan", "1:x"}) {
    refused(std::string("--scale ") + scale, "takes a number over 0, or a ratio like 1:2");
  }
  refused("--scale 1e30", "takes 1e-");
  refused("--tolerance 1e-30", "takes a number of mm from 1e-12 to 1e12");
  refused("--detail 0,0,0,0", "takes X,Y,Z,R with a radius R over 0");
  refused("--margin 1,2,3", "TOP,RIGHT,BOTTOM,LEFT");
  refused("--margin 100,0,109,0 --paper A4", "leave 2 mm of 297 x 210 mm");
  refused("--margin 1,2,3,-4", "TOP,RIGHT,BOTTOM,LEFT");
  refused("--margin 1,2,3,4 --perspective 30", "same margin on all sides");
  refused("--paper fit --scale 10000", "10000 mm a side are the most");
  refused("--perspective 150", "1 to 120 degrees");
  refused("--id-prefix 1x", "--id-prefix takes a letter");
  EXPECT_FALSE(fs::exists(folder_ / "a.svg"));
}

TEST_F(DrawingOptions, ALinkToNothingStaysALink) {
  fs::create_directory(folder_ / "far");
  fs::create_symlink("far/real.svg", folder_ / "link.svg");
  fs::create_symlink("link.svg", folder_ / "link2.svg");
  ASSERT_EQ(run("draw @/box.off -o @/link2.svg"), 0) << err_;
  EXPECT_TRUE(fs::is_symlink(folder_ / "link.svg"));
  EXPECT_TRUE(fs::is_symlink(folder_ / "link2.svg"));
  EXPECT_TRUE(test::slurp(folder_ / "far/real.svg").starts_with("<?xml"));
  fs::create_symlink("ring.svg", folder_ / "ring.svg");
  EXPECT_EQ(run("draw @/box.off -o @/ring.svg"), 4);
  expect_error("leads to itself");
  fs::create_symlink("none/real.svg", folder_ / "lost.svg");
  EXPECT_EQ(run("draw @/box.off -o @/lost.svg"), 4);
  expect_error("the folder does not exist");
  EXPECT_EQ(run("draw @/box.off -o /proc/box.svg"), 4);
  expect_error("this folder takes no files");
}

TEST_F(DrawingOptions, IdsKeepTheirNamesAndHaveTheirPrefix) {
  folder_.write("nut.off", test::off_text(test::box({60, 0, 0}, {70, 10, 10})));
  const auto ids = [&](const std::string& line) {
    EXPECT_EQ(run("draw " + line + " -o @/a.svg --style outline"), 0) << err_;
    const pugi::xml_document doc = svg("a.svg");
    std::vector<std::string> out;
    for (const auto& node : doc.select_nodes("//*[@id]")) {
      out.emplace_back(node.node().attribute("id").value());
    }
    return out;
  };
  const auto one = ids("@/box.off");
  EXPECT_NE(std::ranges::find(one, "outline-box"), one.end());
  const auto two = ids("@/nut.off @/box.off");
  for (const std::string& id : one) EXPECT_NE(std::ranges::find(two, id), two.end()) << id;
  EXPECT_NE(std::ranges::find(two, "crease-nut"), two.end());
  const auto same = ids("@/box.off @/nut.off @/box.off --set feature.intersections=false");
  EXPECT_NE(std::ranges::find(same, "crease-box"), same.end());
  for (const std::string& id : ids("@/box.off --id-prefix fig1.")) {
    EXPECT_TRUE(id.starts_with("fig1.")) << id;
  }
  ASSERT_EQ(run("draw @/box.off -o @/a.json"), 0);
  ASSERT_EQ(run("convert @/a.json -o @/b.svg --id-prefix p-"), 0) << err_;
  EXPECT_NE(test::slurp(folder_ / "b.svg").find("id=\"p-outline\""), std::string::npos);
}

TEST_F(DrawingOptions, AnSvgTellsWhatItIsAndItsOutlineIsOnePath) {
  ASSERT_EQ(run("draw @/box.off -o @/a.svg -o @/a.json --style outline"), 0) << err_;
  const pugi::xml_document doc = svg("a.svg");
  const auto root = doc.child("svg");
  EXPECT_STREQ(root.attribute("role").value(), "img");
  EXPECT_STREQ(root.first_child().name(), "title");
  EXPECT_STREQ(root.child("title").child_value(), "box");
  const auto outline = doc.select_nodes("//g[@id='outline']//path");
  ASSERT_EQ(outline.size(), 1u);
  const std::string d = outline.begin()->node().attribute("d").value();
  EXPECT_TRUE(d.ends_with("z")) << d;
  EXPECT_EQ(std::count(d.begin(), d.end(), 'M'), 1) << d;
  for (const auto& node : doc.select_nodes("//path")) {
    for (const char* name : {"class", "data-part", "data-face", "data-edge", "data-kind"}) {
      EXPECT_TRUE(node.node().attribute(name)) << name;
    }
  }
  // The drawing file tells of each edge.
  const auto drawing = nlohmann::json::parse(test::slurp(folder_ / "a.json"));
  EXPECT_EQ(drawing["layers"].back()["paths"].size(), 6u);
}

TEST_F(DrawingOptions, OptionsWithoutEffectAreTold) {
  const std::string outline = "draw @/box.off --style outline ";
  // Each is told in a line of its own.
  std::string line = outline;
  std::vector<std::string> parts;
  for (const std::string option :
       {"--iso 3", "--inside above", "--smooth 1", "--specks 0.1", "--volume-degree 2",
        "--interpolate", "--raw 2x2x2", "-D n=3", "--openscad-timeout 5", "--object Pad",
        "--recompute", "--freecad-timeout 9", "--mesher nets", "--bounds 0,0,0,1,1,1"}) {
    const std::string name = option.substr(0, option.find(' '));
    line += option + " ";
    parts.push_back("option " + (name == "-D" ? "--define" : name) + " has no effect on ");
  }
  expect_warnings(line, parts);
  expect_warnings(
      outline +
          "--light 1,0,0 --set hatch.taper=1 --set tone.rim=1 "
          "--set png.dpi=600 --set svg.merge=true --id-prefix a --up 1,-1,1",
      {"option --light has no effect", "style key hatch.taper has no effect",
       "style key tone.rim has no effect", "style key png.dpi has no effect: no output is",
       "style key svg.merge has no effect: no output is .svg",
       "option --id-prefix has no effect: no output is .svg", "lies along the view"});
  expect_warning(outline + "--light 1,0,0", "option --light has no effect");
  expect_warning(outline + "--set callout.legend=top-left",
                 "has no effect without option --legend");
  expect_warning("draw @/box.off --style wireframe --hidden dashed", "draws hidden lines in full");
  expect_warning(outline + "--scale 100", "what runs off it is cut");
  expect_warning(outline + "--scale 0.0001", "no larger than a dot");
  expect_warning(outline + "--scale 1 --center 9999,0,0", "nothing of the drawing lies on");
}

TEST_F(DrawingOptions, OptionsWithEffectAreNot) {
  folder_.write("ball.implicit", "sphere(5)\n");
  folder_.write("cube.raw", std::string(8 * 8 * 8, '\1') + std::string(4, '\0'));
  for (const std::string line :
       {"draw @/box.off --style outline --set shadow.cast=true --light 1,1,1",
        "draw @/box.off --style flat --set shadow.ground=true --light 1,1,1",
        "draw @/box.off --heal", "draw @/box.off --no-heal --style outline --hidden dashed",
        "draw @/ball.implicit --mesher delaunay --bounds -9,-9,-9,9,9,9 --tolerance 0.1",
        "draw @/ball.implicit @/box.off --mesher nets --heal --set hatch.taper=1 --light 1,1,1",
        "draw @/ball.implicit --style flat --set tone.steps=3 --light 1,1,1",
        "draw @/ball.implicit --style outline --set feature.isophotes=4 --set tone.light=1,0,0",
        "draw @/box.off --style engraving --up 0,1,0 --margin 0 --paper fit --scale 1:2"}) {
    const bool has_sheet = line.find("--paper") != std::string::npos;
    ASSERT_EQ(run(line + (has_sheet ? "" : " --paper A6") + " -o @/a.svg --no-progress"), 0)
        << err_;
    EXPECT_EQ(err_, "") << line;
  }
}

TEST_F(DrawingOptions, ASheetThatWantsTooManyStrokesIsRefusedBeforehand) {
  const std::string huge = "draw @/box.off -o @/a.svg --paper 4000x4000 --style engraving ";
  EXPECT_EQ(run(huge), 2);
  expect_error("set hatch.spacing_min to");
  // What is advised is taken at its word.
  const auto number = [&](const std::string& key) {
    const std::size_t at = err_.find(key + " to ") + key.size() + 4;
    return err_.substr(at, err_.find_first_of(" ,", at) - at);
  };
  const std::string advice = " --set hatch.spacing_min=" + number("hatch.spacing_min") +
                             " --set hatch.spacing_max=" + number("hatch.spacing_max");
  EXPECT_GT(std::stod(number("hatch.spacing_min")), 1) << err_;
  EXPECT_EQ(run(huge + "--view front" + advice + " --set hatch.enabled=false"), 0) << err_;
}

TEST_F(DrawingOptions, ASheetOfTenMetresTakesLittleMemory) {
  if (test::kSanitized) GTEST_SKIP() << "sanitizers take addresses of their own";
  for (const auto& [style, status] : {std::pair("outline", 0), std::pair("engraving", 2)}) {
    const std::string script = folder_.write(
        "limited.sh", fmt::format("ulimit -v 1500000\nexec {} draw {} -o {}/m.svg --style {} "
                                  "--paper 10000x10000 --threads 2 2> {}/said\n",
                                  BURIN_COMMAND, box_, folder_.path(), style, folder_.path()));
    const int ended = std::system(("sh " + script).c_str());
    EXPECT_EQ(WEXITSTATUS(ended), status) << test::slurp(folder_ / "said");
  }
}

TEST_F(DrawingOptions, MemoryThatRunsOutIsToldInOneLine) {
  if (test::kSanitized) GTEST_SKIP() << "sanitizers take addresses of their own";
  // Little more than the program itself takes: who runs out first differs from machine to machine.
  int told = 0;
  for (const unsigned megabytes : {110U, 140U, 180U, 230U, 290U}) {
    const std::string script = folder_.write(
        "limited.sh",
        fmt::format("ulimit -v {}\nexec {} draw {} -o {}/m.svg --style engraving "
                    "--paper A1 --quiet 2> {}/said\n",
                    megabytes * 1024, BURIN_COMMAND, box_, folder_.path(), folder_.path()));
    const int status = std::system(("sh " + script).c_str());
    if (status == 0) continue;
    const std::string said = test::slurp(folder_ / "said");
    if (said.find("loading shared libraries") != std::string::npos) continue;  // not yet ours
    EXPECT_EQ(WEXITSTATUS(status), 1) << megabytes << ": " << said;
    EXPECT_NE(said.find("out of memory"), std::string::npos) << megabytes << ": " << said;
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
    EXPECT_FALSE(fs::exists(folder_ / "m.svg"));
    ++told;
  }
  EXPECT_GT(told, 0);
}

}  // namespace
}  // namespace burin
