#include "models.h"

namespace burin {
namespace {

namespace fs = std::filesystem;
using test::slurp;

class CliErrors : public test::CliTest {
 protected:
  /// A failing run: status, a part of its one line of error, and nothing left behind.
  void expect_failure(const std::string& line, int status, const std::string& part) {
    SCOPED_TRACE(line);
    const std::size_t before = folder_.count();
    EXPECT_EQ(run(line), status);
    expect_error(part);
    EXPECT_EQ(out_, "");
    EXPECT_EQ(folder_.count(), before);
  }
};

TEST_F(CliErrors, UsageNamesTheNearest) {
  expect_failure("", 2, "burin --help");
  expect_failure("drow @/box.off", 2, "'draw'");
  expect_failure("--verson", 2, "--version");
  expect_failure("draw @/box.off -o @/a.svg --vew front", 2, "--view");
  expect_failure("draw @/box.off --ouput @/a.svg", 2, "--output");
  expect_failure("draw @/box.off -o @/a.svg --set line.outr=1", 2, "'line.outer'");
  expect_failure("draw @/box.off -o @/a.svg --style engravin", 2, "'engraving'");
  expect_failure("styles --show outlin", 2, "'outline'");
  expect_failure("info --jsn @/box.off", 2, "--json");
  const std::string draw = "draw @/box.off -o @/a.svg ";
  expect_failure(draw + "--view isometric", 2, "the nearest is 'iso'");
  expect_failure(draw + "--view plan", 2, "the nearest is 'top'");
  expect_failure(draw + "--view rear", 2, "the nearest is 'back'");
  expect_failure(draw + "--view perspective", 2, "asked for by --perspective");
  expect_failure(draw + "--views front,isometric", 2, "the nearest is 'iso'");
  expect_failure(draw + "--legend=top-left", 2, "--legend takes no value, not 'top-left'");
  EXPECT_NE(err_.find("--set callout.legend=top-left"), std::string::npos) << err_;
  expect_failure(draw + "--look box=line.color=red", 2, "{\"line.color\": \"red\"}");
}

TEST_F(CliErrors, UsageOfEachOption) {
  const std::string draw = "draw @/box.off -o @/a.svg ";
  expect_failure("draw", 2, "no input");
  expect_failure("info", 2, "no input");
  expect_failure("draw @/box.off", 2, "no output");
  expect_failure("draw @/box.off -o", 2, "--output");
  expect_failure(draw + "--view sideways", 2, "sideways");
  expect_failure(draw + "--view 0,0,0", 2, "0,0,0");
  expect_failure(draw + "--up 0,1", 2, "--up");
  expect_failure(draw + "--perspective 200", 2, "--perspective");
  expect_failure(draw + "--paper A9", 2, "A9");
  expect_failure(draw + "--scale 0", 2, "--scale");
  expect_failure(draw + "--scale big", 2, "--scale");
  expect_failure(draw + "--margin 110", 2, "--margin");
  expect_failure(draw + "--bounds 0,0,0,1,1", 2, "--bounds");
  expect_failure(draw + "--bounds 0,0,0,1,1,0", 2, "--bounds");
  expect_failure(draw + "--set line.outer", 2, "KEY=VALUE");
  expect_failure(draw + "--set line.outer=99", 2, "0.01 to 10");
  expect_failure(draw + "--set hatch.spacing_min=20", 2, "hatch.spacing_max");
  expect_failure(draw + "--set svg.flatten=maybe", 2, "polylines or none");
  expect_failure(draw + "--light 0,0,0", 2, "--light");
  expect_failure(draw + "--hidden solid", 2, "--hidden");
  expect_failure(draw + "--tolerance -1", 2, "--tolerance");
  expect_failure(draw + "--seed 1.5", 2, "--seed");
  expect_failure(draw + "--seed -1", 2, "--seed");
  expect_failure(draw + "--threads 0", 2, "--threads");
  expect_failure(draw + "--mesher fine", 2, "auto, nets or delaunay, not 'fine'");
  expect_failure(draw + "--quiet=maybe", 2, "quiet");
}

TEST_F(CliErrors, EmptyValuesAreNoDefaults) {
  for (const std::string option :
       {"--iso", "--scale", "--center", "--bounds", "--mesher", "--smooth", "--seed", "--style",
        "--format", "--openscad-timeout"}) {
    test::Command command(folder_, {"draw", box_, "-o", folder_ / "a.svg", option, ""});
    EXPECT_EQ(command.wait(), 2);
    EXPECT_EQ(command.std_err, "burin: error: option " + option + " has an empty value\n");
  }
  // With the sign of equality nothing follows: the next word is another option.
  for (const std::string option :
       {"--view", "--iso", "--part", "--set", "--style", "--output", "--verify"}) {
    test::Command command(folder_, {"draw", box_, option + "=", "-o", folder_ / "a.svg"});
    EXPECT_EQ(command.wait(), 2);
    EXPECT_EQ(command.std_err, "burin: error: option " + option + " has an empty value\n");
  }
  expect_failure("draw @/box.off --nosuch= -o @/a.svg", 2, "unknown option --nosuch");
  test::Command nameless(folder_, {"draw", "", "-o", folder_ / "a.svg"});
  EXPECT_EQ(nameless.wait(), 3);
  EXPECT_EQ(nameless.std_err, "burin: error: the name of a model file is empty\n");
}

TEST_F(CliErrors, UsageOfOutputs) {
  expect_failure("draw @/box.off -o @/a.bmp", 2, ".json or .html");
  expect_failure("draw @/box.off -o @/a", 2, ".json or .html");
  expect_failure("draw @/box.off -o -", 2, "--format");
  expect_failure("draw @/box.off -o @/a --format bmp", 2, "--format");
  expect_failure("draw @/box.off -o @/a.svg -o @/./a.svg", 2, "twice");
  expect_failure("draw @/box.off -o - -o - --format svg", 2, "twice");
  // Of relative names, too, before any of them is there.
  test::Command relative(folder_, {"draw", box_, "-o", "twice.svg", "-o", "./twice.svg"});
  EXPECT_EQ(relative.wait(), 2);
  EXPECT_NE(relative.std_err.find("./twice.svg: is given twice as output"), std::string::npos)
      << relative.std_err;
  // An input is never overwritten, by whatever way it is named.
  const std::string before = slurp(box_);
  fs::create_symlink("box.off", folder_ / "box.svg");
  expect_failure("draw @/box.off -o @/box.svg", 2, "input");
  expect_failure("draw @/box.off -o @/box.off --format svg", 2, "input");
  folder_.write("s.json", "{}");
  expect_failure("draw @/box.off -o @/s.json --style @/s.json", 2, "input");
  EXPECT_EQ(slurp(box_), before);
  EXPECT_EQ(slurp(folder_ / "s.json"), "{}");
}

TEST_F(CliErrors, BadInput) {
  expect_failure("draw @/none.stl -o @/a.svg", 3, "none.stl: ");
  expect_failure("info @/none.stl", 3, "none.stl: ");
  expect_failure("draw @ -o @/a.svg", 3, "folder");
  folder_.write("empty.stl", "");
  expect_failure("draw @/empty.stl -o @/a.svg", 3, "empty.stl: ");
  folder_.write("short.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n");
  expect_failure("draw @/short.off -o @/a.svg", 3, "short.off:");
  folder_.write("word.off", "OFF\n3 1 0\n0 0 0\n1 0 zero\n0 1 0\n3 0 1 2\n");
  expect_failure("draw @/word.off -o @/a.svg", 3, "word.off:4: ");
  folder_.write("flat.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n");
  expect_failure("draw @/flat.off -o @/a.svg", 3, "flat.off: ");
  expect_failure("convert @/short.off -o @/a.svg", 3, "short.off: is a model (off), not a drawing");
  for (const std::string suffix : {"stl", "obj", "off"}) {
    std::string wide = "\xff\xfe";
    for (const char c : std::string("solid a\nfacet\n")) wide += {c, '\0'};
    folder_.write("wide." + suffix, wide);
    expect_failure("draw @/wide." + suffix + " -o @/a.svg", 3,
                   "is text in UTF-16; save it as UTF-8 or ASCII");
  }
  folder_.write("thing.xyz", "one two three\n");
  expect_failure("draw @/thing.xyz -o @/a.svg", 3, "of no kind that is read (suffix '.xyz')");
  folder_.write("drawing.json", R"({"format": "burin-drawing", "version": 1, "layers": []})");
  expect_failure("draw @/drawing.json -o @/a.svg", 3, "burin convert");
}

TEST_F(CliErrors, BadStyleFiles) {
  folder_.write("broken.json", "{\n\"line.outer\": 0.5,\n\"line.crease\" 3}");
  expect_failure("draw @/box.off -o @/a.svg --style @/broken.json", 3, "broken.json:3: ");
  folder_.write("wrong.json", "{\n\"line.outr\": 0.5}");
  expect_failure("draw @/box.off -o @/a.svg --style @/wrong.json", 2, "wrong.json:2: ");
  expect_failure("draw @/box.off -o @/a.svg --style @/none.json", 3, "none.json: ");
}

TEST_F(CliErrors, OutputThatCannotBeWritten) {
  expect_failure("draw @/box.off -o @/no/such/a.svg", 4, "no/such/a.svg: ");
  expect_failure("draw @/box.off -o @/box.off/a.svg", 4, "box.off/a.svg: ");
  fs::create_directory(folder_ / "dir.svg");
  expect_failure("draw @/box.off -o @/dir.svg", 4, "folder");
  expect_failure("draw @/box.off -o /proc/a.svg", 4, "/proc/a.svg: ");
  expect_failure("draw @/box.off -o @/good.svg -o @/no/bad.json", 4, "no/bad.json: ");
  // An unwritable output is known before the input is read.
  folder_.write("broken.off", "OFF\nnonsense\n");
  expect_failure("draw @/broken.off -o @/no/a.svg", 4, "no/a.svg");
  if (::geteuid() != 0) {
    fs::create_directory(folder_ / "locked");
    fs::permissions(folder_ / "locked", fs::perms::owner_read | fs::perms::owner_exec);
    expect_failure("draw @/box.off -o @/locked/a.svg", 4, "permission");
  }
}

TEST_F(CliErrors, FullDisk) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  // The good file of the same run is not left behind either.
  expect_failure("draw @/box.off -o @/good.svg -o /dev/full --format svg", 4,
                 "/dev/full: the disk is full");
  test::Command command(folder_, {"draw", box_, "-o", "-", "--format", "svg"}, "/dev/full");
  EXPECT_EQ(command.wait(), 4);
  EXPECT_TRUE(command.std_err.starts_with("burin: error: standard output: ")) << command.std_err;
  test::Command help(folder_, {"--help"}, "/dev/full");
  EXPECT_EQ(help.wait(), 4);
}

TEST_F(CliErrors, ClosedPipe) {
  const std::string pipe = folder_ / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  folder_.write("torus.off", test::off_text(test::torus(20, 8, 60, 30)));
  const int reader = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  test::Command command(
      folder_,
      {"draw", folder_ / "torus.off", "-o", "-", "--format", "json", "--style", "engraving"}, pipe);
  ::close(reader);
  EXPECT_EQ(command.wait(), 4);
}

TEST_F(CliErrors, TextsThatNobodyReadsOnAreNone) {
  const std::string pipe = folder_ / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const int reader = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  test::Command command(folder_, {"options", "--completion", "zsh"}, pipe);
  ::close(reader);
  EXPECT_EQ(command.wait(), 0);
  EXPECT_EQ(command.std_err, "");
}

TEST_F(CliErrors, EarlierOutputStaysOnFailure) {
  folder_.write("a.svg", "precious");
  expect_failure("draw @/none.stl -o @/a.svg", 3, "none.stl");
  EXPECT_EQ(slurp(folder_ / "a.svg"), "precious");
}

class CliSignals : public test::CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    torus_ = folder_.write("torus.off", test::off_text(test::torus(20, 8, 600, 300)));
  }
  /// Starts a long run and waits until it says that it is in `stage`.
  void expect_stopped(const std::string& stage, int signal) {
    SCOPED_TRACE(stage);
    folder_.write("a.svg", "old");
    const std::size_t before = folder_.count();
    test::Command command(
        folder_, {"draw", torus_, "-o", folder_ / "a.svg", "-o", folder_ / "b.json", "--style",
                  "engraving", "--progress", "--paper", "A2"});
    ASSERT_TRUE(command.wait_for("progress " + stage));
    command.signal(signal);
    EXPECT_EQ(command.wait(), 5) << command.std_err;
    EXPECT_TRUE(command.std_err.ends_with("burin: error: cancelled\n")) << command.std_err;
    EXPECT_EQ(folder_.count(), before);
    EXPECT_EQ(slurp(folder_ / "a.svg"), "old");
  }
  std::string torus_;
};

TEST_F(CliSignals, StopsInEachStage) {
  expect_stopped("read", SIGINT);
  expect_stopped("build", SIGTERM);
  expect_stopped("field", SIGINT);
  expect_stopped("cover", SIGHUP);
  expect_stopped("trace", SIGINT);
}

TEST_F(CliSignals, SecondSignalKills) {
  const std::size_t before = folder_.count();
  test::Command command(folder_, {"draw", torus_, "-o", folder_ / "a.svg", "--style", "engraving",
                                  "--progress", "--paper", "A2"});
  ASSERT_TRUE(command.wait_for("progress build"));
  command.signal(SIGINT);
  command.signal(SIGTERM);
  const int status = command.wait();
  // Whichever came first: the orderly end or the kill.
  EXPECT_TRUE(status == 5 || status == 1000 + SIGINT || status == 1000 + SIGTERM) << status;
  EXPECT_EQ(folder_.count(), before);
}

// What newcomers try, and what they mean by it: in meaning, not in letters.
TEST_F(CliErrors, OptionsOfOtherProgramsAreUnderstood) {
  const std::vector<std::pair<std::string, std::string>> words = {
      {"--title Pump", "\"title\""},
      {"--dims", "overall writes width, depth and height"},
      {"--bom", "--parts-list"},
      {"--balloons", "--callouts"},
      {"--labels", "--callouts"},
      {"--annotate", "--callouts"},
      {"--camera iso", "--view"},
      {"--rotate 30", "--view"},
      {"--azimuth 30", "--view"},
      {"--elevation 30", "--view"},
      {"--isometric", "--view"},
      {"--front", "--view"},
      {"--fov 30", "--perspective"},
      {"--size A3", "--paper"},
      {"--width 200", "--paper"},
      {"--page A4", "--paper"},
      {"--landscape", "--paper"},
      {"--border 5", "--margin"},
      {"--zoom 2", "--detail"},
      {"--cut x", "--section"},
      {"--clip x", "--section"},
      {"--slice x", "--section"},
      {"--cross-section x", "--section"},
      {"--exploded", "--explode"},
      {"--transparent lid", "--ghost"},
      {"--opacity 0.5", "--ghost"},
      {"--exclude lid", "--hide"},
      {"--only lid", "--part"},
      {"--select lid", "--part"},
      {"--hidden-lines", "--hidden"},
      {"--dashed", "--hidden"},
      {"--quality high", "--tolerance"},
      {"--deflection 0.1", "--tolerance"},
      {"--theme dark", "--style"},
      {"--preset x", "--style"},
      {"--jobs 4", "--threads"},
      {"-j 4", "--threads"},
      {"--param a=1", "--define"},
      {"--out a.svg", "--output"},
      {"--svg a.svg", "--output"},
      {"--silent", "--quiet"},
      {"--debug", "--verbose"},
      {"--dpi 300", "--set png.dpi=VALUE"},
      {"--resolution 300", "--set png.dpi=VALUE"},
      {"--line-width 1", "--set line.outer=VALUE"},
      {"--stroke-width 1", "--set line.outer=VALUE"},
      {"--color red", "style key fill.color"},
      {"--colours", "--style flat"},
      {"--palette bright", "--style flat"},
      {"--background white", "--set sheet.paper=VALUE"},
      {"--shadows", "style key shadow.cast draws shadows"},
      {"--no-hatching", "--set hatch.enabled=VALUE"},
      {"--crease-angle 20", "--set feature.crease_angle=VALUE"},
      {"--silhouette", "--set feature.contours=VALUE"},
      {"--units mm", "models are read in mm"},
      {"--input a.stl", "models are named without an option"},
      {"--overwrite", "files are replaced without asking"},
      {"--animate", "still pictures"},
      {"--layers", "each kind of line is a layer"},
      {"--config a.toml", "--set"},
  };
  EXPECT_GE(words.size(), 50U);
  for (const auto& [said, meant] : words) {
    expect_failure("draw @/box.off -o @/a.svg " + said, 2, meant);
    EXPECT_NE(err_.find("(see burin draw --help)"), std::string::npos) << err_;
  }
}

// No wrong suggestion where nothing is near.
TEST_F(CliErrors, NothingIsSuggestedWhereNothingIsNear) {
  for (const char* word : {"--flavour", "--xyzzy", "--temperature", "--wolf"}) {
    expect_failure(std::string("draw @/box.off -o @/a.svg ") + word, 2,
                   std::string("unknown option ") + word + " (see burin draw --help)");
  }
  const std::string commands = "; the commands are draw, watch, illustrate, ";
  expect_failure("frobnicate @/box.off", 2, "unknown command 'frobnicate'" + commands);
  // "node" is another name of an option of draw.
  expect_failure("--nodde", 2, "unknown option --nodde" + commands);
  EXPECT_EQ(err_.find("--object"), std::string::npos) << err_;
  expect_failure("help nonsense", 2, "unknown command 'nonsense'" + commands);
  expect_failure("bom @/box.off", 2, "burin draw INPUT... -o OUT --parts-list FILE.csv");
  expect_failure("draw @/box.off -o @/a.svg --set foo.bar=1", 2,
                 "unknown style key 'foo.bar' (all: burin styles --keys)");
  expect_failure("draw @/box.off -o @/a.svg --style xyzzy", 2, "unknown style 'xyzzy' (built in: ");
}

TEST_F(CliErrors, ValuesBesideTheirOptionSayWhereTheyBelong) {
  const std::string draw = "draw -o @/a.svg ";
  const std::string corner = ": write --legend --set callout.legend=top-left";
  expect_failure(draw + "--legend top-left @/box.off", 2,
                 "takes no value, not 'top-left'" + corner);
  expect_failure(draw + "--legend=top-left @/box.off", 2,
                 "takes no value, not 'top-left'" + corner);
  expect_failure(draw + "--highlight box red @/box.off", 2, "--highlight 'box=red'");
  expect_failure(draw + "--highlight=box #ff0000 @/box.off", 2, "--highlight 'box=#ff0000'");
  expect_failure(draw + "@/box.off --highlight box=#ff000080", 2,
                 "a colour has no alpha: write #ff0000, and set the opacity by fill.opacity");
  expect_failure(draw + "@/box.off --set fill.color=#ff000080", 2, "a colour has no alpha");
  // A file of that name is a file.
  expect_failure(draw + "--legend nothing.off", 3, "nothing.off: there is no such file");
}

TEST_F(CliErrors, WordsThatBelongElsewhereSayWhere) {
  expect_failure("info @/box.off --style outline", 2, "--style is an option of burin draw");
  expect_failure("draw @/box.off -o @/a.svg --set view=top", 2, "it is the option --view");
  expect_failure("draw @/box.off -o @/a.svg --set dpi=300", 2, "'png.dpi'");
  expect_failure("draw @/box.off -o @/a.svg --style sketch", 2, "'pencil'");
  expect_failure("draw @/box.off -o @/a.svg --style dots", 2, "'stipple'");
  expect_failure("render @/box.off -o @/a.svg", 2, "'draw'");
  expect_failure("compare @/box.off @/box.off", 2, "'diff'");
  expect_failure("@/box.off -o @/a.svg", 2, "to draw: burin draw ");
  expect_failure("-o @/a.svg @/box.off", 2, "to draw: burin draw ");
}

// A look changes what can differ by part; the rest is not swallowed.
TEST_F(CliErrors, KeysOfALookThatHoldForTheWholeDrawing) {
  folder_.write("grey.json", R"({"base": "outline", "sheet.ink": "#808080"})");
  folder_.write("red.json", "{\"base\": \"outline\",\n\"sheet.ink\": \"#d00000\"}");
  const std::string draw = "draw @/box.off -o @/a.json --style @/grey.json --look box=@/red.json";
  expect_failure(draw, 2, "red.json:2: style key 'sheet.ink' holds for the whole drawing");
  EXPECT_NE(err_.find("line.color"), std::string::npos) << err_;
  folder_.write("red.json", R"({"base": "outline", "line.color": "#d00000"})");
  ASSERT_EQ(run(draw), 0) << err_;
  EXPECT_EQ(err_, "");
  const std::string drawing = slurp(folder_ / "a.json");
  EXPECT_NE(drawing.find("\"ink_color\": \"#808080\""), std::string::npos);
  EXPECT_NE(drawing.find("\"color\": \"#d00000\", \"points\""), std::string::npos);
  // Of an illustration file, too, with its line.
  folder_.write("a.burin.json",
                "{\"burin\": \"illustration\", \"parts\": [{\"file\": \"box.off\"}],\n"
                "\"looks\": [{\"select\": \"box\", \"style\": {\n\"halo.gap\": 1}}]}");
  expect_failure("draw @/a.burin.json -o @/b.svg", 2, "a.burin.json:3: style key 'halo.gap'");
}

}  // namespace
}  // namespace burin
