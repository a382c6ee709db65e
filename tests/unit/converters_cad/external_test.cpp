// Assemblies whose parts stand in files of their own.
#include <burin/base/input_files.h>

#include "cad_files.h"

#include <algorithm>
#include <filesystem>
#include <regex>

namespace burin {
namespace {

namespace fs = std::filesystem;

class ExternalFiles : public test::CadTest {
 protected:
  /// Two blocks and a ball, each in a file of its own.
  void SetUp() override {
    test::CadDocument document;
    const TDF_Label top = document.assembly("stand");
    const TDF_Label block = document.part(test::solid_box(3, 4, 5), "block", "#ff8040");
    const TDF_Label ball = document.part(test::solid_sphere(2), "ball");
    document.use(top, block, test::moved(0, 0, 0), "left");
    document.use(top, block, test::moved(10, 0, 0), "right");
    document.use(top, ball, test::moved(20, 0, 0), "ball");
    document.step_in_files(file_);
    name_second();
    for (const auto& entry : fs::directory_iterator(folder_.path())) {
      const std::string name = entry.path().filename().string();
      if (name.find("block") != std::string::npos) block_ = entry.path();
      if (name.find("ball") != std::string::npos) ball_ = entry.path();
    }
    ASSERT_FALSE(block_.empty());
    ASSERT_FALSE(ball_.empty());
  }

  /// OCCT 7.8 writes no names of instances into an assembly of several files.
  void name_second() {
    const std::string text = test::slurp(file_);
    const std::regex nameless("(NEXT_ASSEMBLY_USAGE_OCCURRENCE\\('[0-9]+',)''");
    auto it = std::sregex_iterator(text.begin(), text.end(), nameless);
    if (it == std::sregex_iterator() || ++it == std::sregex_iterator()) return;
    const auto at = static_cast<std::size_t>(it->position());
    folder_.write("stand.step", text.substr(0, at) + (*it)[1].str() + "'right'" +
                                    text.substr(at + it->str().size()));
  }

  std::string file_ = folder_ / "stand.step";
  fs::path block_, ball_;
};

// It was sought in the folder that the program had been started in.
TEST_F(ExternalFiles, AreReadFromTheFolderOfTheAssembly) {
  InputFiles heard;
  const Scene scene = read(file_);
  ASSERT_EQ(scene.parts.size(), 3u);
  EXPECT_EQ(scene.parts[1].name, "right");
  EXPECT_EQ(scene.parts[1].definition, scene.parts[0].definition);
  EXPECT_EQ(scene.parts[0].color, "#ff8040");
  test::expect_box(scene.parts[1].form->bounds(Mat3(1)), {10, 0, 0}, {13, 4, 5});
  EXPECT_TRUE(scene.diagnostics.empty());
  for (const fs::path& path : {block_, ball_}) EXPECT_TRUE(heard.stamps().contains(path)) << path;
}

TEST_F(ExternalFiles, ThatAreNotThereAreNamedOnce) {
  fs::remove(ball_);
  const Scene scene = read(file_);
  EXPECT_EQ(scene.parts.size(), 2u);
  EXPECT_EQ(test::count_of(scene.diagnostics, "step.not_translated"), 0);
  ASSERT_EQ(test::count_of(scene.diagnostics, "step.missing_file"), 1);
  const auto reported = std::ranges::find(scene.diagnostics.entries(), "step.missing_file",
                                          [](const Diagnostic& d) { return d.code; });
  const std::string& message = reported->message;
  EXPECT_NE(message.find(ball_.filename().string()), std::string::npos) << message;
  EXPECT_EQ(message.find(block_.filename().string()), std::string::npos) << message;
}

TEST_F(ExternalFiles, WithoutWhichNothingIsLeftAreNamedByTheError) {
  fs::remove(block_);
  folder_.write(ball_.filename().string(), "no STEP file");
  const std::string message = error_of(file_);
  for (const fs::path& path : {block_, ball_}) {
    EXPECT_NE(message.find(path.filename().string()), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace burin
