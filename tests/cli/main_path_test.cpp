// The stages called one by one, as samples/main_path does it, draw what the command draws.
#include "models.h"

#include <pugixml.hpp>

#include <cstdlib>

namespace burin {
namespace {

class MainPath : public test::CliTest {
 protected:
  /// The paths of a drawing that are no strokes, and those that are.
  struct Count {
    std::size_t features = 0, strokes = 0;
    std::string sheet;
  };
  static Count count(const std::string& file) {
    pugi::xml_document document;
    EXPECT_TRUE(document.load_file(file.c_str())) << file;
    Count count;
    count.sheet = document.child("svg").attribute("viewBox").value();
    for (const auto& node : document.select_nodes("//path")) {
      const std::string data = node.node().attribute("class").value();
      ++(data.find("stroke") == std::string::npos ? count.features : count.strokes);
    }
    return count;
  }
};

TEST_F(MainPath, DrawsWhatTheCommandDraws) {
  for (const std::string model : {"bracket.off", "coupling.step", "blend.implicit"}) {
    const std::string path = std::string(BURIN_SOURCE_DIR "/samples/") + model;
    const std::string ours = folder_ / "ours.svg", theirs = folder_ / "theirs.svg";
    ASSERT_EQ(std::system((std::string(BURIN_MAIN_PATH " ") + path + " " + ours).c_str()), 0);
    ASSERT_EQ(run_as_it_stands("draw " + path + " -o @/theirs.svg"), 0);
    const Count one = count(ours), other = count(theirs);
    EXPECT_EQ(one.sheet, other.sheet) << model;
    // The command also drops stubs of strokes at outlines, and joins and cuts lines for their
    // widths.
    EXPECT_GT(one.strokes, 20u) << model;
    EXPECT_NEAR(static_cast<double>(one.strokes), static_cast<double>(other.strokes),
                0.1 * static_cast<double>(other.strokes))
        << model;
    EXPECT_GE(one.features, 4u) << model;
  }
}

}  // namespace
}  // namespace burin
