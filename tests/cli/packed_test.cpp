// Models that gzip packed, and models and drawings that are piped.
#include "models.h"

#include <burin_test/mesh_files.h>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace burin {
namespace {

namespace fs = std::filesystem;

class Packed : public test::CliTest {
 protected:
  /// A file of the folder, packed by the program gzip under another name.
  void pack(const std::string& file, const std::string& as) {
    const std::string words = "gzip -c '" + folder_ / file + "' > '" + folder_ / as + "'";
    ASSERT_EQ(std::system(words.c_str()), 0);  // NOLINT(cert-env33-c): a test's own file
  }
  /// The paths of a drawing file.
  nlohmann::json drawn(const std::string& line, const std::string& in = "") {
    EXPECT_EQ(run("draw " + line + " -o @/d.json --quiet", in), 0) << err_;
    const auto drawing = nlohmann::json::parse(test::slurp(folder_ / "d.json"));
    name_ = drawing["parts"][0]["name"];
    return drawing["layers"];
  }
  std::string name_;
};

TEST_F(Packed, ModelsAreUnpackedByTheirBytes) {
  pack("box.off", "box.off.gz");
  pack("box.off", "named.stl");
  const auto plain = drawn("@/box.off");
  EXPECT_EQ(drawn("@/box.off.gz"), plain);
  EXPECT_EQ(name_, "box");
  EXPECT_EQ(drawn("@/named.stl"), plain);
  const std::string step = std::string(BURIN_SOURCE_DIR) + "/samples/coupling.step";
  fs::copy_file(step, folder_ / "part.step");
  pack("part.step", "part.stpz");
  pack("part.step", "part.stp.gz");
  const auto exact = drawn("@/part.step --style outline");
  EXPECT_EQ(drawn("@/part.stpz --style outline"), exact);
  EXPECT_EQ(drawn("@/part.stp.gz --style outline"), exact);
  EXPECT_EQ(run("info @/part.stpz"), 0) << err_;
  EXPECT_NE(out_.find("STEP"), std::string::npos);
}

// "renamed  lid: was called box", as the name of a part alone is that of its file.
TEST_F(Packed, ModelsAreTheSameRevisionAsOthers) {
  pack("box.off", "lid.off.gz");
  EXPECT_EQ(run("diff @/box.off @/lid.off.gz"), 0) << out_ << err_;
  EXPECT_EQ(run("diff - @/lid.off.gz", "box.off"), 0) << out_ << err_;
}

TEST_F(Packed, PackedTwice) {
  const auto plain = drawn("@/box.off");
  pack("box.off", "box.off.gz");
  pack("box.off.gz", "box.off.gz.gz");
  pack("box.off.gz.gz", "three.off.gz");
  pack("three.off.gz", "four.off.gz");
  EXPECT_EQ(drawn("@/box.off.gz.gz"), plain);
  EXPECT_EQ(name_, "box");
  EXPECT_EQ(drawn("@/three.off.gz"), plain);
  EXPECT_EQ(run("draw @/four.off.gz -o @/a.svg"), 3);
  expect_error("over 3 times");
  folder_.write("tail.off.gz", test::slurp(folder_ / "box.off.gz") + "bytes behind");
  EXPECT_EQ(drawn("@/tail.off.gz"), plain);
}

TEST_F(Packed, MeshesWithTheSuffixOfAnotherFormat) {
  const auto plain = drawn("@/box.off");
  const std::string text = test::slurp(folder_ / "box.off");
  for (const char* name : {"box.step", "box.igs", "box.glb", "box.stl"}) {
    folder_.write(name, text);
    EXPECT_EQ(drawn(std::string("@/") + name), plain) << name;
  }
  const TriMesh box = test::box({0, 0, 0}, {1, 2, 3});
  folder_.write("binary.step", test::stl_binary(box));
  folder_.write("text.gltf", test::stl_ascii(box));
  drawn("@/binary.step");
  EXPECT_EQ(name_, "binary");
  drawn("@/text.gltf");
  EXPECT_EQ(name_, "part");
}

TEST_F(Packed, BombsAndDamageAreRefusedInOneLine) {
  const std::string bomb = folder_ / "bomb.stl.gz";
  const std::string make = "head -c 300000000 /dev/zero | gzip -9 > '" + bomb + "'";
  ASSERT_EQ(std::system(make.c_str()), 0);  // NOLINT(cert-env33-c): a test's own file
  EXPECT_EQ(run("draw @/bomb.stl.gz -o @/a.svg"), 3);
  expect_error("hostile");
  EXPECT_LT(peak_mb_, 600);
  pack("box.off", "box.off.gz");
  const std::string whole = test::slurp(folder_ / "box.off.gz");
  for (std::size_t n = 3; n < whole.size(); n += 11) {
    folder_.write("cut.off.gz", whole.substr(0, n));
    EXPECT_EQ(run("draw @/cut.off.gz -o @/a.svg"), 3) << n;
    expect_error("cut.off.gz");
  }
  EXPECT_FALSE(fs::exists(folder_ / "a.svg"));
}

TEST_F(Packed, StandardInput) {
  pack("box.off", "box.off.gz");
  const auto plain = drawn("@/box.off");
  EXPECT_EQ(drawn("-", "box.off"), plain);
  EXPECT_EQ(name_, "stdin");
  EXPECT_EQ(drawn("/dev/stdin", "box.off.gz"), plain);
  EXPECT_EQ(run("info -", "box.off"), 0) << err_;
  EXPECT_NE(out_.find("OFF"), std::string::npos);
  EXPECT_EQ(run("draw - -o @/a.svg"), 3);
  expect_error("standard input: is empty");
  folder_.write("x", "what is this");
  EXPECT_EQ(run("draw - -o @/a.svg", "x"), 3);
  expect_error("standard input: ");
  folder_.write("x", "cube(9);\n");
  EXPECT_EQ(run("draw - -o @/a.svg", "x"), 3);
  expect_error("save it with the suffix .scad");
  EXPECT_EQ(run("watch - -o @/a.svg", "box.off"), 2);
  expect_error("burin watch looks at files");
}

TEST_F(Packed, InputFormatSaysWhatBytesDoNot) {
  folder_.write("ball", "sphere(10)\n");
  const auto ball = drawn("- --input-format implicit", "ball");
  EXPECT_EQ(drawn("@/ball --input-format .IMPLICIT"), ball);
  EXPECT_EQ(run("draw - -o @/a.svg", "ball"), 3);
  // The bytes go before it, and so does a suffix that is known, of which it says so.
  const auto plain = drawn("@/box.off");
  EXPECT_EQ(drawn("- --input-format stl", "box.off"), plain);
  EXPECT_EQ(run("draw @/box.off -o @/a.svg --input-format stl"), 0) << err_;
  EXPECT_NE(err_.find("--input-format has no effect on"), std::string::npos) << err_;
  EXPECT_EQ(run("draw - -o @/a.svg --input-format nonsense", "ball"), 2);
  expect_error("--input-format takes a suffix of a format that is read");
  EXPECT_EQ(run("draw - -o @/a.svg --input-format scad", "ball"), 2);
  expect_error("OpenSCAD's programs are read from files");
}

TEST_F(Packed, EachFormatGoesToStandardOutput) {
  const std::vector<std::string> formats{"svg",  "eps",  "dxf", "hpgl", "gcode",
                                         "json", "html", "pdf", "png"};
  const std::string draw = "draw @/box.off --style outline --quiet";
  std::string files;
  for (const std::string& format : formats) {
    if (format != "html") files += " -o @/a." + format;
  }
  ASSERT_EQ(run(draw + files), 0) << err_;
  // Beside a page, which lists the items, the others would have them, too.
  ASSERT_EQ(run(draw + " -o @/a.html"), 0) << err_;
  for (const std::string& format : formats) {
    ASSERT_EQ(run(draw + " -o - --format " + format), 0) << format << err_;
    EXPECT_EQ(out_, test::slurp(folder_ / ("a." + format))) << format;
    EXPECT_GT(out_.size(), 100u) << format;
    EXPECT_EQ(err_, "") << format;
  }
}

}  // namespace
}  // namespace burin
