/// The text form: values, errors with line and column, and texts that mean harm.

#include <burin/base/error.h>
#include <burin/base/rng.h>
#include <burin/converters/implicit_reader.h>

#include <burin_test/folder.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

namespace burin {
namespace {

double value(const std::string& text, Vec3 p = Vec3(2, 3, 5)) {
  return make_function(parse_implicit(text))->value(p);
}

void expect_error(const std::string& text, std::int64_t line, const std::string& what) {
  try {
    parse_implicit(text, "f.implicit");
    ADD_FAILURE() << "not refused: " << text.substr(0, 60);
  } catch (const InputError& e) {
    EXPECT_EQ(e.line(), line) << e.what();
    EXPECT_EQ(e.file(), "f.implicit");
    EXPECT_NE(std::string(e.what()).find(what), std::string::npos) << e.what();
    EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos);
    EXPECT_LT(std::string(e.what()).size(), 200u);
  }
}

TEST(ImplicitText, ArithmeticBindsAsUsual) {
  EXPECT_EQ(value("1 + 2 * 3 - 8 / 4"), 5);
  EXPECT_EQ(value("-x^2"), -4);
  EXPECT_EQ(value("2^3^2"), 512);
  EXPECT_EQ(value("2^-1"), 0.5);
  EXPECT_EQ(value("(x + y) * z"), 25);
  EXPECT_EQ(value("x - y - z"), -6);
  EXPECT_EQ(value("1e3 + .5 + 2."), 1002.5);
  EXPECT_NEAR(value("cos(pi)"), -1, 1e-15);
  EXPECT_EQ(value("min(z, x, y) + max(x, z, y)"), 7);
  EXPECT_EQ(value("+x"), 2);
}

TEST(ImplicitText, DefinitionsCommentsAndTheLastExpression) {
  EXPECT_EQ(value("# a comment\na = x + 1; # another\nb = a * a;\nb - 9 # end"), 0);
  EXPECT_EQ(value("a = 3;\r\na"), 3);
  EXPECT_EQ(value("x;"), 2);
}

TEST(ImplicitText, TheWholeVocabulary) {
  const Vec3 p(0.3, 0.2, 0.1);
  for (const char* text : {"sphere(1)",
                           "box(1,2,3)",
                           "round_box(1,2,3,0.2)",
                           "cylinder(1,2)",
                           "cone(1,0,2)",
                           "torus(3,1)",
                           "capsule(1,2)",
                           "plane(0,0,1,2)",
                           "gyroid(4,0.5)",
                           "superquadric(1,1,1,0.5,0.5)",
                           "1 - blob(2)",
                           "union(sphere(1), box(1,1,1), torus(2,1))",
                           "intersection(sphere(1), box(1,1,1))",
                           "difference(sphere(1), box(1,1,1), x)",
                           "smooth_union(sphere(1), x, 0.3)",
                           "smooth_intersection(sphere(1), x, 0.3)",
                           "smooth_difference(sphere(1), x, 0.3)",
                           "translate(sphere(1), 1, 2, 3)",
                           "rotate(box(1,2,3), 10, 20, 30)",
                           "scale(sphere(1), 2)",
                           "mirror(box(1,2,3), 1, 1, 0)",
                           "shell(sphere(1), 0.1)",
                           "offset(sphere(1), 0.1)",
                           "twist(box(1,1,3), 30)",
                           "repeat(sphere(0.4), 1, 1, 0)",
                           "round(x)",
                           "pow(x, 2)",
                           "atan2(y, x)",
                           "tan(asin(x))",
                           "acos(x) + atan(y) + exp(z) + log(x) + sqrt(y) + abs(z) + sin(x)"}) {
    EXPECT_TRUE(std::isfinite(value(text, p))) << text;
  }
  EXPECT_EQ(value("translate(sphere(1), 1, 3, 5)"), 0);
}

TEST(ImplicitText, ErrorsNameLineAndColumn) {
  expect_error("", 1, "column 1: no function");
  expect_error("a = 1;\n", 2, "no function");
  expect_error("x + * y", 1, "column 5: a number, a name or '(' expected, not '*'");
  expect_error("a = x;\n b = (a + 1;\nb", 2, "column 12: ')' expected here, not ';'");
  expect_error("sphere(1) box(1,1,1)", 1, "column 11: 'box' after the last expression");
  expect_error("x +\n\n  $", 3, "column 3: '$' has no meaning here");
  expect_error("x \xc3\xa4", 1, "byte 0xc3");
  expect_error("1e999", 1, "out of range");
}

TEST(ImplicitText, UnknownNamesComeWithTheNearest) {
  expect_error("spere(1)", 1, "unknown function 'spere'; the nearest is 'sphere'");
  expect_error("body = x;\nbdoy + 1", 2, "unknown name 'bdoy'; the nearest is 'body'");
  expect_error("sphere", 1, "write sphere(r)");
  expect_error("x(3)", 1, "'x' is no function");
  expect_error("sphere = 3; x", 1, "has a meaning already");
  expect_error("a = 1; a = 2; a", 1, "defined twice");
}

TEST(ImplicitText, WrongArgumentsSayHowToWriteIt) {
  expect_error("sphere()", 1, "too few arguments; write sphere(r)");
  expect_error("sphere(1, 2)", 1, "column 11: too many arguments");
  expect_error("box(1, x, 2)", 1, "column 8: a number expected, without x, y and z");
  expect_error("translate(sphere(1), 1, 2)", 1, "too few arguments");
  expect_error("union(x)", 1, "too few arguments");
  expect_error("a = 1;\n  sphere(-a)", 2, "column 3: the radius of a sphere");
  expect_error("sphere(1/0)", 1, "not finite");
}

TEST(ImplicitText, DepthAndSizeHaveBounds) {
  expect_error(std::string(5000, '(') + "x", 1, "nested more than 200 deep");
  expect_error(std::string(50'000, '-') + "x", 1, "nested more than 200 deep");
  std::string sum = "x";
  for (int i = 0; i < 20'000; ++i) sum += "+y";
  expect_error(sum, 1, "operations deep");
  std::string wide = "min(x";
  for (int i = 0; i < 9'000; ++i) wide += ",y+" + std::to_string(i);
  EXPECT_EQ(value(wide + ")"), 2);
  EXPECT_THROW(parse_implicit(std::string(2'000'000, ' ')), InputError);
  expect_error("f = " + std::string(9000, 'a') + "; f", 1, "unknown name");
}

TEST(ImplicitText, GarbageNeverCrashes) {
  const std::string words[] = {"x",  "y",      "(",   ")",     ",",   "+",     "-",  "*",    "/",
                               "^",  "sphere", "box", "union", "3",   "0.5",   "=",  ";",    "a",
                               "\n", "rotate", "#",   "min",   "log", "twist", "pi", "\xff", "1e3"};
  const Rng rng(11);
  int parsed = 0;
  for (std::uint64_t i = 0; i < 20'000; ++i) {
    std::string text;
    const auto n = rng.bits(100 * i) % 24;
    for (std::uint64_t k = 0; k < n; ++k) {
      text += words[rng.bits(100 * i + k + 1) % std::size(words)];
    }
    try {
      parse_implicit(text);
      ++parsed;
    } catch (const InputError&) {
    }
  }
  EXPECT_GT(parsed, 50);
}

TEST(ImplicitReader, ReadsAPartNamedByItsFile) {
  const test::TempFile file("ball.implicit", "sphere(2)\n");
  const std::filesystem::path& path = file.path();
  RunContext context;
  const Scene scene = read_implicit(path, {}, context);
  ASSERT_EQ(scene.parts.size(), 1u);
  EXPECT_EQ(scene.parts[0].name, "ball");
  EXPECT_NEAR(scene.parts[0].form->bounds(Mat3(1)).max.x, 2, 1e-9);
  const FileInfo info = inspect_implicit(path, {}, context);
  EXPECT_NEAR(info.parts.at(0).volume, 4.0 / 3 * 3.14159265358979 * 8, 0.02);
  EXPECT_EQ(info.parts[0].components, 1);
  std::ofstream(path) << "sphere(2) + 9\n";
  EXPECT_THROW(read_implicit(path, {}, context), InputError);
  std::ofstream(path) << "z\n";
  EXPECT_THROW(read_implicit(path, {}, context), InputError);
  EXPECT_EQ(read_implicit(path, {Box3{Vec3(-1), Vec3(1)}}, context).parts.size(), 1u);
  EXPECT_TRUE(is_implicit_suffix("a/B.IMPLICIT"));
  EXPECT_FALSE(is_implicit_suffix("implicit"));
}

}  // namespace
}  // namespace burin
