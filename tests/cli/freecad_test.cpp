// The command and FreeCAD.
#include "models.h"

#include <sys/stat.h>
#include <zip.h>

#include <csignal>
#include <cstdlib>

namespace burin::test {
namespace {

class FreecadTest : public CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    // A mesh of four triangles, as FreeCAD stores it.
    std::string mesh = std::string("\xd0\xc0\xb0\xa0\0\0\1\0", 8) + std::string(256, '-');
    const auto put = [&](auto value) {
      mesh.append(reinterpret_cast<const char*>(&value), sizeof value);
    };
    for (const std::uint32_t n : {4u, 4u}) put(n);
    for (const float x : {0, 0, 0, 9, 0, 0, 0, 9, 0, 0, 0, 9}) put(x);
    for (const std::uint32_t c : {0u, 2u, 1u, 0u, 1u, 3u, 0u, 3u, 2u, 1u, 2u, 3u}) {
      put(c);
      if (++corners_ % 3 == 0) {
        for (int i = 0; i < 3; ++i) put(0xffffffffu);
      }
    }
    const std::string xml =
        "<Document ProgramVersion=\"0.20R1\"><Objects Count=\"1\"><Object type=\"Mesh::Feature\" "
        "name=\"Mesh\"/></Objects><ObjectData><Object name=\"Mesh\"><Properties><Property "
        "name=\"Label\"><String value=\"Tooth\"/></Property><Property name=\"Mesh\"><Mesh "
        "file=\"M.bms\"/></Property></Properties></Object></ObjectData></Document>";
    int error = 0;
    zip_t* archive = zip_open((folder_ / "a.FCStd").c_str(), ZIP_CREATE, &error);
    const std::pair<const char*, const std::string*> members[] = {{"Document.xml", &xml},
                                                                  {"M.bms", &mesh}};
    for (const auto& [name, bytes] : members) {
      zip_file_add(archive, name, zip_source_buffer(archive, bytes->data(), bytes->size(), 0), 0);
    }
    zip_close(archive);
  }
  void TearDown() override { ::unsetenv("BURIN_FREECAD"); }
  void use_script(const std::string& body) {
    const std::string path = folder_.write("fake", "#!/bin/sh\n" + body);
    ::chmod(path.c_str(), 0700);
    ::setenv("BURIN_FREECAD", path.c_str(), 1);
  }
  int corners_ = 0;
};

TEST_F(FreecadTest, DrawsAndTells) {
  EXPECT_EQ(run("draw @/a.FCStd -o @/a.svg"), 0) << err_;
  EXPECT_NE(slurp(folder_ / "a.svg").find("Tooth"), std::string::npos);
  EXPECT_EQ(run("info --json @/a.FCStd"), 0) << err_;
  EXPECT_NE(out_.find("FreeCAD 0.20"), std::string::npos) << out_;
  EXPECT_NE(out_.find("\"name\": \"Tooth\""), std::string::npos) << out_;
  EXPECT_EQ(run("draw @/a.FCStd -o @/b.svg --object Tooht"), 3);
  expect_error("the nearest is 'Tooth'");
}

TEST_F(FreecadTest, RecomputeNeedsTheProgram) {
  ::setenv("BURIN_FREECAD", (folder_ / "none").c_str(), 1);
  EXPECT_EQ(run("info @/a.FCStd --recompute"), 3);
  expect_error("BURIN_FREECAD");
  const std::string path = std::getenv("PATH");
  ::unsetenv("BURIN_FREECAD");
  ::setenv("PATH", folder_.path().c_str(), 1);
  EXPECT_EQ(run("info @/a.FCStd --recompute"), 3);
  ::setenv("PATH", path.c_str(), 1);
  expect_error("install the package freecad");
  ::setenv("BURIN_FREECAD", "/bin/true", 1);
  EXPECT_EQ(run("info @/a.FCStd --recompute"), 3);
  expect_error("made no copy");
}

TEST_F(FreecadTest, RecomputeEndsWithTheTimeLimitAndACancel) {
  use_script("sleep 50\n");
  EXPECT_EQ(run("info @/a.FCStd --recompute --freecad-timeout 0.3"), 3);
  expect_error("--freecad-timeout");
  std::filesystem::create_directory(folder_ / "tmp");
  ::setenv("TMPDIR", (folder_ / "tmp").c_str(), 1);
  use_script("touch " + folder_ / "started" + "\nsleep 50\n");
  Command command(folder_, {"draw", folder_ / "a.FCStd", "-o", folder_ / "c.svg", "--recompute"});
  for (int i = 0; i < 2000 && !std::filesystem::exists(folder_ / "started"); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  command.signal(SIGINT);
  EXPECT_EQ(command.wait(), 5);
  ::unsetenv("TMPDIR");
  EXPECT_TRUE(std::filesystem::is_empty(folder_ / "tmp"));
}

TEST_F(FreecadTest, TheRealFreecadRecomputes) {
  if (std::system("command -v freecadcmd >/dev/null") != 0) {
    GTEST_SKIP() << "freecadcmd is not installed (package freecad)";
  }
  const std::string script = folder_.write(
      "make_box.py",
      "import FreeCAD, os\nd = FreeCAD.newDocument('d')\nb = d.addObject('Part::Box', 'Box')\n"
      "c = d.addObject('Part::Compound', 'All')\nc.Links = [b]\nb.Visibility = False\n"
      "d.recompute()\nb.Length = 40\nd.saveAs(os.environ['BURIN_TEST_OUT'])\nos._exit(0)\n");
  ::setenv("BURIN_TEST_OUT", (folder_ / "box.FCStd").c_str(), 1);
  ::setenv("FREECAD_USER_HOME", folder_.path().c_str(), 1);
  std::system(("freecadcmd " + script + " >/dev/null 2>&1").c_str());
  // The box computes itself when it is changed, the compound of it does not.
  EXPECT_EQ(run("info @/box.FCStd"), 0) << err_;
  EXPECT_NE(out_.find("10 x 10 x 10 mm"), std::string::npos) << out_;
  EXPECT_EQ(run("info @/box.FCStd --recompute"), 0) << err_;
  EXPECT_NE(out_.find("40 x 10 x 10 mm"), std::string::npos) << out_;
}

}  // namespace
}  // namespace burin::test
