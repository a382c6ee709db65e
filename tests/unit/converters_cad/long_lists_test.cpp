#include "long_lists.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace burin {
namespace {

std::string points(int count) {
  std::string out = "(0.,0.,0.)";
  for (int i = 1; i < count; ++i) out += ",\n(1.,2.,3.)";
  return out;
}

TEST(LongLists, OfTrianglesKeepTheirFirstEntryAndTheirLines) {
  const std::string head = "#1=COORDINATES_LIST('it''s; (a) list',200,(";
  const std::string tail = "));\n#2=CARTESIAN_POINT('',(1.,2.,3.));\n";
  const std::string text = head + points(200) + tail;
  const std::string out = without_triangle_lists(text);
  ASSERT_EQ(out.size(), text.size());
  EXPECT_EQ(std::ranges::count(out, '\n'), std::ranges::count(text, '\n'));
  std::string squeezed = out;
  std::erase(squeezed, ' ');
  std::erase(squeezed, '\n');
  EXPECT_EQ(squeezed,
            "#1=COORDINATES_LIST('it''s;(a)list',200,((0.,0.,0.)));#2=CARTESIAN_POINT('',(1.,2.,3.)"
            ");");
}

TEST(LongLists, OfATypeAmongSeveralAreShortened) {
  const std::string text = "#3=(COMPLEX_TRIANGULATED_FACE('',#1,4,(" + points(300) +
                           "),$,(),((1,4,3)),())TESSELLATED_ITEM());\n";
  const std::string out = without_triangle_lists(text);
  ASSERT_EQ(out.size(), text.size());
  EXPECT_TRUE(out.ends_with("),$,(),((1,4,3)),())TESSELLATED_ITEM());\n"));
  EXPECT_EQ(std::ranges::count(out, ','), 3 + 2 + 6);
}

TEST(LongLists, OfOtherEntitiesStay) {
  const std::string shell = "#1=CLOSED_SHELL('COORDINATES_LIST',(" + points(500) + "));\n";
  EXPECT_EQ(without_triangle_lists(shell), "");
  EXPECT_EQ(without_triangle_lists("#1=COORDINATES_LIST('',2,((0.,0.,0.),(1.,0.,0.)));\n"), "");
  EXPECT_EQ(without_triangle_lists(""), "");
}

TEST(LongLists, ThatNeverEndStopAtTheEndOfTheText) {
  const std::string text = "#1=COORDINATES_LIST('',200,(" + points(200);
  EXPECT_EQ(without_triangle_lists(text), "");
  EXPECT_EQ(without_triangle_lists(text + "\n#2=COORDINATES_LIST('"), "");
}

}  // namespace
}  // namespace burin
