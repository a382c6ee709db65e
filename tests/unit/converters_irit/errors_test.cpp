// Damaged files: each is refused with the line and the column of the place.
#include "reading.h"

namespace burin {
namespace {

using test::expect_error;

const std::string kPoints = "[0 0 0] [1 0 0] [0 1 0] [1 1 0]";

TEST(IritErrors, Brackets) {
  expect_error("[OBJECT A\n  [SURFACE BEZIER 2 2 E3 " + kPoints + "]\n", 1, "never closes");
  expect_error("[OBJECT A\n  [SURFACE BEZIER 2 2 E3 " + kPoints + "]]\n]\n", 3, "do not balance");
  expect_error("[OBJECT A\n  [SURFACE BEZIER 2 2 E3 [0 0 0] [1 0 0]", 2, "cannot fit");
  expect_error("[OBJECT [COLOR 4", 1, "the file ends");
  expect_error("[OBJECT A [TRISRF [x] [y\n", 1, "column 18: the block");
}

TEST(IritErrors, Counts) {
  expect_error("[OBJECT A\n[SURFACE BEZIER 2 2 E3 [0 0 0] [1 0 0] [0 1 0]]\n]       padding", 2,
               "column 47: ']' is not the [ of a control point");
  expect_error("[OBJECT A\n[SURFACE BEZIER 2 2 E3 " + kPoints + " [2 2 2]]]", 2,
               "after the control");
  expect_error("[SURFACE BEZIER 2 999999999999 E3 " + kPoints + "]", 1, "at most 32");
  expect_error("[SURFACE BSPLINE 99999 99999 3 3 E3 " + kPoints + "]", 1, "cannot fit");
  expect_error("[SURFACE BSPLINE 9223372036854775807 9223372036854775807 3 3 E3 " + kPoints + "]",
               1, "cannot fit");
  expect_error("[SURFACE BSPLINE 99999999999999999999 2 2 2 E3 " + kPoints + "]", 1,
               "column 18: '99999999999999999999' is not a number of control points");
  expect_error("[SURFACE BEZIER -2 2 E3 " + kPoints + "]", 1, "is not a number of control points");
  expect_error("[SURFACE BEZIER 2 1 E3 [0 0 0] [1 1 1]]", 1, "order 1");
  expect_error("[SURFACE BSPLINE 2 2 3 2 E3 [KV 0 0 0 1 1] [KV 0 0 1 1] " + kPoints + "]", 1,
               "order 3 of 2 control points");
  expect_error("[OBJECT P [POLYGON 4000 [0 0 0]]]", 1, "4000 points cannot fit");
}

TEST(IritErrors, Numbers) {
  expect_error("[OBJECT A\n[SURFACE BEZIER 2 2 E3\n[0 0 0] [1 0 0] [0 nan 0] [1 1 0]]]", 3,
               "column 20: 'nan' is no finite number");
  expect_error("[SURFACE BEZIER 2 2 E3 [0 0 0] [1 0 0] [0 1e999 0] [1 1 0]]", 1,
               "no finite number");
  expect_error("[SURFACE BEZIER 2 2 E3 [0 0 0] [1 0 0] [0 1e99 0] [1 1 0]]", 1, "absurdly large");
  expect_error("[SURFACE BEZIER 2 2 E3 [0 0 0] [1 x 0] [0 1 0] [1 1 0]]", 1,
               "'x' is not a coordinate");
  expect_error("[SURFACE BEZIER 2 2 P3 [1 0 0 0] [0 1 0 0] [1 0 1 0] [1 1 1 0]]", 1,
               "column 35: the weight 0 is not positive");
  expect_error("[SURFACE BEZIER 2 2 F3 " + kPoints + "]", 1, "is not a type of points");
  expect_error("[SURFACE BEZIER 2 2 E0 " + kPoints + "]", 1, "is not a type of points");
}

TEST(IritErrors, WildPoints) {
  expect_error("[OBJECT A\n[SURFACE BEZIER 2 2 E3 [0 0 0] [1 0 0] [0 1e30 0] [1 1 0]]]", 2,
               "a billion times farther out");
  expect_error("[SURFACE BEZIER 2 2 P3 [1 0 0 0] [1 1 0 0] [4294967295 0 1 0] [1 1 1 0]]", 1,
               "weights of control points from 1 to 4294967295");
}

TEST(IritErrors, Knots) {
  const auto surface = [](const std::string& u) {
    return "[SURFACE BSPLINE 2 2 2 2 E3\n" + u + "\n[KV 0 0 1 1] " + kPoints + "]";
  };
  expect_error(surface("[KV 0 0 2 1]"), 2,
               "column 11: the knot 1 is less than the one before it, 2");
  expect_error(surface("[KV 0 0 1]"), 2, "holds 3 knots");
  expect_error(surface("[KV 0 0 1 1 1]"), 2, "need 4");
  expect_error(surface("[KVP 0 0 1 1]"), 2, "need 5");
  expect_error(surface("[KV 0 1 1 1]"), 2, "no interval");
  expect_error(surface("[KW 0 0 1 1]"), 2, "'KW' is not KV or KVP");
  expect_error(surface("[KV 0 0 1 inf]"), 2, "no finite number");
  // As many knots as the file holds and no more.
  expect_error(surface("[KV 0 0 1 1"), 3, "'[' is not a knot");
}

TEST(IritErrors, DeepNestingNeitherHangsNorOverflows) {
  const auto nested = [](int depth, const std::string& open) {
    std::string text;
    for (int i = 0; i < depth; ++i) text += open;
    return text + std::string(static_cast<std::size_t>(depth), ']');
  };
  expect_error(nested(100000, "[OBJECT A "), 1, "more than 200 deep");
  expect_error("[OBJECT A [SURFACE BEZIER 2 2 E3 " + kPoints + "] " + nested(200000, "[x ") + "] ]",
               1, "do not balance");
  expect_error(nested(100000, "["), 1, "begins with no word");
  EXPECT_EQ(test::scene_of("[OBJECT " + nested(100000, "[x ") + " A [SURFACE BEZIER 2 2 E3 " +
                           kPoints + "]]")
                .parts.size(),
            1u);
}

TEST(IritErrors, NothingToDraw) {
  expect_error(
      "[OBJECT A [TRISRF x]\n]\n[OBJECT B [TRIVAR BEZIER 2 2 2 E3 [0 0 0] [1 0 0] "
      "[0 1 0] [1 1 0] [0 0 1] [1 0 1] [0 1 1] [1 1 1]]]",
      1, "1 TRISRF (triangular patch), 1 TRIVAR of points E3 (trivariate volume)");
  expect_error("\n[OBJECT A [CURVE BEZIER 2 E3 [0 0 0] [1 0 0]]]", 2, "no surface, only 1 CURVE");
  expect_error("[OBJECT A]", 0, "holds no surface");
  expect_error("some text", 0, "neither IRIT data");
  expect_error(std::string("\0\1\2[OBJECT", 10), 0, "binary");
}

}  // namespace
}  // namespace burin
