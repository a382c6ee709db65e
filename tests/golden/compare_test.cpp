// The comparer has to be able to fail: each kind of change to a drawing is found.
#include "compare.h"

#include <gtest/gtest.h>

namespace burin::golden {
namespace {

constexpr const char* kDrawing = R"({"format":"burin-drawing","version":1,"generator":"burin 0.1.0",
  "parts":[{"id":0,"name":"a","source":"/some/where/a.stl"}],
  "layers":[{"name":"contour","paths":[
    {"kind":"contour","visible":true,"part":0,"points":[[10.0,20.0],[30.5,40.25]],"width":[0.7]},
    {"kind":"crease","visible":true,"part":0,"points":[[-1.5,2.0],[3.0,4.0]],"width":[0.25]}]}]})";

std::string changed(const std::string& from, const std::string& to) {
  std::string text = kDrawing;
  const auto at = text.find(from);
  EXPECT_NE(at, text.npos) << from;
  return canonical(text.replace(at, from.size(), to));
}

std::string verdict(const std::string& from, const std::string& to) {
  return difference(canonical(kDrawing), changed(from, to), 0.02).value_or("same");
}

TEST(GoldenCompare, EqualDrawingsAgree) {
  EXPECT_EQ(difference(canonical(kDrawing), canonical(kDrawing), 0), std::nullopt);
}

TEST(GoldenCompare, VersionAndFoldersDoNotCount) {
  EXPECT_EQ(verdict("burin 0.1.0", "burin 9.9.9"), "same");
  EXPECT_EQ(verdict("/some/where/", "/else/"), "same");
}

TEST(GoldenCompare, NumbersMayMoveByTheToleranceAndNoMore) {
  EXPECT_EQ(verdict("30.5", "30.515"), "same");
  EXPECT_EQ(verdict("30.5", "30.53"), "line 5: 30.53 instead of 30.5");
  EXPECT_EQ(verdict("-1.5", "1.5"), "line 6: 1.5 instead of -1.5");
}

TEST(GoldenCompare, StructureMustBeTheSame) {
  EXPECT_NE(verdict("\"kind\":\"crease\"", "\"kind\":\"boundary\""), "same");
  EXPECT_NE(verdict("\"part\":0,\"points\":[[10", "\"part\":1,\"points\":[[10"), "same");
  EXPECT_NE(verdict(",[30.5,40.25]", ""), "same");
  EXPECT_NE(verdict("\"visible\":true", "\"visible\":false"), "same");
  EXPECT_NE(verdict("\"name\":\"contour\"", "\"name\":\"other\""), "same");
}

TEST(GoldenCompare, AMissingPathIsFound) {
  const std::string whole = canonical(kDrawing);
  const std::string less = whole.substr(0, whole.rfind("{\"kind\""));
  EXPECT_NE(difference(whole, less, 0.02), std::nullopt);
  EXPECT_NE(difference(less, whole, 0.02), std::nullopt);
}

TEST(GoldenCompare, SvgTextIsComparedTheSameWay) {
  const std::string svg = "<path d=\"M 1.000 2.000 C 3.5 4.25 -5.125 6 7 8\" data-part=\"3\"/>";
  const std::string near = "<path d=\"M 1.010 1.990 C 3.5 4.25 -5.125 6 7 8\" data-part=\"3\"/>";
  const std::string other_part =
      "<path d=\"M 1.000 2.000 C 3.5 4.25 -5.125 6 7 8\" data-part=\"4\"/>";
  EXPECT_EQ(difference(svg, near, 0.02), std::nullopt);
  EXPECT_NE(difference(svg, other_part, 0.02), std::nullopt);
  EXPECT_NE(difference(svg, near, 0.005), std::nullopt);
}

}  // namespace
}  // namespace burin::golden
