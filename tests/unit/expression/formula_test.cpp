#include <burin/base/error.h>
#include <burin/expression/formula.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

namespace burin::expression {
namespace {

constexpr std::array<std::string_view, 3> kNames{"x", "y", "ink"};

double value(std::string_view text, double x = 0, double y = 0, double ink = 0) {
  const std::array values{x, y, ink};
  return Formula(text, kNames)(values);
}

std::string refusal(std::string_view text) {
  try {
    Formula(text, kNames);
  } catch (const UsageError& e) {
    return e.what();
  }
  return "it was read";
}

TEST(Formula, HasTheValueOfItsArithmetic) {
  EXPECT_EQ(value("1 + 2 * 3 - 4 / 8"), 6.5);
  EXPECT_EQ(value("-2 ^ 2"), -4);
  EXPECT_EQ(value("2 ^ 3 ^ 2"), 512);
  EXPECT_EQ(value("2 ^ -1"), 0.5);
  EXPECT_EQ(value("(1 + 2) * 3"), 9);
  EXPECT_EQ(value("x - y * ink", 7, 2, 3), 1);
  EXPECT_DOUBLE_EQ(value("2 * pi"), 6.283185307179586);
}

TEST(Formula, HasTheValueOfItsFunctions) {
  EXPECT_EQ(value("step(x)", 0.001), 1);
  EXPECT_EQ(value("step(x)", 0), 0);
  EXPECT_EQ(value("clamp(x, 1, 2)", 5), 2);
  EXPECT_EQ(value("clamp(x, 1, 2)", -5), 1);
  EXPECT_EQ(value("mix(10, 20, x)", 0.25), 12.5);
  EXPECT_EQ(value("mod(x, 3)", -1), 2);
  EXPECT_EQ(value("min(x, y) + 10 * max(x, y)", 1, 2), 21);
  EXPECT_EQ(value("floor(-0.5) + round(1.6) + abs(-3)"), 4);
  EXPECT_DOUBLE_EQ(value("sin(x) ^ 2 + cos(x) ^ 2", 0.7), 1);
  EXPECT_DOUBLE_EQ(value("atan2(1, -1) - atan(1) - asin(1)"), 0);
  EXPECT_DOUBLE_EQ(value("log(exp(x)) + sqrt(acos(1) + 4) + tan(0)", 3), 5);
}

TEST(Formula, NoiseIsSmoothBoundedAndUneven) {
  double last = value("noise(x, 0.3, 0.7)", -20), least = 1, most = 0;
  for (double x = -20; x < 20; x += 0.01) {
    const double v = value("noise(x, 0.3, 0.7)", x);
    ASSERT_GE(v, 0);
    ASSERT_LE(v, 1);
    ASSERT_LE(std::abs(v - last), 0.02) << x;
    least = std::min(least, v);
    most = std::max(most, v);
    last = v;
  }
  EXPECT_LT(least, 0.3);
  EXPECT_GT(most, 0.7);
  EXPECT_EQ(value("noise(1e300, x, 0)", std::nan("")), 0.5);
}

TEST(Formula, KnowsWhatItLooksAt) {
  const Formula f("x + ink * 0", kNames);
  EXPECT_TRUE(f.uses(0));
  EXPECT_FALSE(f.uses(1));
  EXPECT_TRUE(f.uses(2));
  EXPECT_TRUE(Formula("1", kNames).is(1));
  EXPECT_FALSE(Formula("1 + 0", kNames).is(1));
}

TEST(Formula, RefusesWhatIsNoneInOneLine) {
  const std::string many(3000, '-'), deep(1000, '(');
  std::string sums = "1";
  for (int i = 0; i < 200; ++i) sums += "+x";
  const std::pair<std::string, const char*> wrong[] = {
      {"", "the end"},
      {"x +", "column 4"},
      {"x y", "'y' after"},
      {"(x", "')' expected"},
      {"q", "there are x, y, ink"},
      {"sin x", "write sin(x)"},
      {"sine(x)", "'sin'"},
      {"min(x)", "min(a, b)"},
      {"1e999", "out of range"},
      {"x == y", "column 3"},
      {"x \x01", "no meaning"},
      {deep, "nested more than 200"},
      {many, "nested more than 200"},
      {sums, "more than 250"},
      {std::string(5000, ' '), "longer"},
  };
  for (const auto& [text, part] : wrong) {
    const std::string reported = refusal(text);
    EXPECT_NE(reported.find(part), std::string::npos) << text << ": " << reported;
    EXPECT_EQ(reported.find('\n'), std::string::npos) << reported;
    EXPECT_LT(reported.size(), 200u) << reported;
  }
}

}  // namespace
}  // namespace burin::expression
