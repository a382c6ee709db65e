// Labels of whole drawings: none lies on another, none is off the sheet.
#include <burin/converters/read_drawing.h>

#include <burin_test/command.h>
#include <burin_test/label_faults.h>
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

namespace burin {
namespace {

const std::string kSheet = " --title-block iso --parts-list sheet";

class Labels : public ::testing::Test {
 protected:
  /// What is wrong in the drawing of a sample.
  test::LabelFaults faults_of(const std::string& sample, const std::string& options) {
    std::vector<std::string> words{"draw", BURIN_SOURCE_DIR "/samples/" + sample};
    std::istringstream more(options + " --style outline -o " + (folder_ / "a.json"));
    for (std::string word; more >> word;) words.push_back(word);
    test::Command command(folder_, words);
    EXPECT_EQ(command.wait(), 0) << command.std_err;
    RunContext context;
    return test::label_faults(read_drawing(folder_ / "a.json", context));
  }
  void expect_clear(const std::string& sample, const std::string& options) {
    const test::LabelFaults faults = faults_of(sample, options);
    EXPECT_GT(faults.texts, 0U);
    EXPECT_EQ(faults.labels(), 0U) << sample << " " << options << "\n" << told(faults);
    EXPECT_EQ(faults.under_leaders + faults.under_lines + faults.crossings, 0U)
        << sample << " " << options << "\n"
        << told(faults);
  }
  static std::string told(const test::LabelFaults& faults) {
    std::string all;
    for (const std::string& line : faults.told) all += "  " + line + "\n";
    return all;
  }

  test::Folder folder_;
};

Text text(Vec2 at, const char* words) { return {at, 5, TextAnchor::Start, words, "note"}; }

Path line(Vec2 a, Vec2 b, int item = 0) {
  Path path;
  path.kind = LineClass::Leader;
  path.points = {a, b};
  path.width = {0.2};
  path.item = item;
  return path;
}

TEST(LabelFaults, AreFound) {
  Drawing drawing;
  drawing.layers.push_back({"notes", {line({20, 52}, {40, 52})}, {text({20, 50}, "under")}});
  EXPECT_EQ(test::label_faults(drawing).under_lines, 1U);
  drawing.layers.back().paths.front() = line({20, 48}, {40, 48});
  EXPECT_EQ(test::label_faults(drawing).lines(), 0U);
  drawing.layers.back().texts.push_back(text({30, 53}, "over"));
  drawing.layers.back().texts.push_back(text({290, 20}, "outside"));
  Text upright = text({24, 30}, "upright");
  upright.turn = 90;
  drawing.layers.back().texts.push_back(upright);
  test::LabelFaults faults = test::label_faults(drawing);
  EXPECT_EQ(faults.overlaps, 2U);  // "over" and "upright" with "under"
  EXPECT_EQ(faults.off_sheet, 1U);
  drawing.layers.push_back(
      {"callouts", {line({10, 10}, {60, 60}, 1), line({60, 10}, {10, 60}, 2)}});
  faults = test::label_faults(drawing);
  EXPECT_EQ(faults.crossings, 1U);
  EXPECT_GT(faults.under_leaders, 0U);
  EXPECT_EQ(faults.over_lines, 1U);
}

TEST_F(Labels, OfPicturesAreClear) {
  for (const char* view : {"iso", "front", "back"}) {
    expect_clear("gear_pump.step", std::string("--paper A4 --callouts --dimensions overall ") +
                                       "--note gasket=Change --note cover=Oil --view " + view +
                                       kSheet);
  }
  expect_clear("coupling.step",
               "--paper A3 --callouts --dimensions overall --note *=Edges --title-block iso");
}

TEST_F(Labels, OfExplodedViewsAreClear) {
  for (const char* sample : {"gear_pump.step", "coupling.step"}) {
    expect_clear(sample, "--paper A4 --explode auto --callouts --dimensions overall" + kSheet);
  }
  expect_clear(
      "gear_pump.step",
      "--paper A3 --explode auto --views iso,front --callouts --note cover=First" + kSheet);
}

TEST_F(Labels, OfSheetsAreClear) {
  const std::string views = "--paper A3 --callouts --dimensions overall --centre-lines auto ";
  for (const char* sample : {"gear_pump.step", "coupling.step", "pedestal.step"}) {
    expect_clear(sample, views + "--views front,top,left,iso --section-view y" + kSheet);
    expect_clear(sample, views + "--views front,top,left --section-view x --section-view y " +
                             "--detail 0,0,0,10 --note *=Item");
  }
}

}  // namespace
}  // namespace burin
