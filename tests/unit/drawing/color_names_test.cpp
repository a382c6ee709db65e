/// Names of colours and the short form of CSS.

#include <burin/drawing/color.h>

#include <gtest/gtest.h>

namespace burin {
namespace {

TEST(ColorNames, OfCssStandForItsColours) {
  EXPECT_EQ(without_name("steelblue"), "#4682b4");
  EXPECT_EQ(without_name("SteelBlue"), "#4682b4");
  EXPECT_EQ(without_name("aliceblue"), "#f0f8ff");
  EXPECT_EQ(without_name("yellowgreen"), "#9acd32");
  EXPECT_EQ(without_name("steelblu"), "steelblu");
  EXPECT_EQ(without_name(""), "");
}

// Those that are told apart on paper, not those of screens.
TEST(ColorNames, OfThisProgramGoBeforeThoseOfCss) {
  for (const std::string& name : color_names()) EXPECT_TRUE(rgb_of(without_name(name))) << name;
  EXPECT_EQ(without_name("red"), "#d62728");
}

TEST(ColorNames, ThreeDigitsStandForSix) {
  EXPECT_EQ(without_name("#a0F"), "#aa00FF");
  EXPECT_EQ(without_name("#a0g"), "#a0g");
  EXPECT_EQ(without_name("#a0"), "#a0");
}

}  // namespace
}  // namespace burin
