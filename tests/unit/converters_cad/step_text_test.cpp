// The entities of a STEP file as they stand in its text.
#include "pmi/step_text.h"

#include <gtest/gtest.h>

#include <string>

namespace burin {
namespace {

StepText read(const std::string& text) { return {text, RunContext()}; }

TEST(StepText, HasParametersOfEachKind) {
  const std::string text =
      "HEADER; DATA;\n#7 = ONE('it''s; (a)', 2.5, -1.E2, .TRUE., $, *, #8, (#9,(1,2)),"
      "LENGTH_MEASURE(3.));";
  const StepText file = read(text);
  const StepEntity entity = file.entity(7);
  const StepRecord* one = entity.as("ONE");
  ASSERT_NE(one, nullptr);
  ASSERT_EQ(one->values.size(), 9u);
  EXPECT_EQ(one->at(0).text, "it's; (a)");
  EXPECT_EQ(one->at(1).number, 2.5);
  EXPECT_EQ(one->at(2).number, -100);
  EXPECT_EQ(one->at(3).text, "TRUE");
  EXPECT_EQ(one->at(4).kind, StepValue::Kind::None);
  EXPECT_EQ(one->at(6).entity, 8);
  EXPECT_EQ(one->at(7).references(), (std::vector<std::int64_t>{9}));
  EXPECT_EQ(one->at(7).items[1].items[1].number, 2);
  EXPECT_EQ(one->at(8).as_number(), 3);
  EXPECT_EQ(one->at(20).kind, StepValue::Kind::None);
}

TEST(StepText, FindsEntitiesOfSeveralTypesByEach) {
  const std::string text = "DATA;\n#2=(A('x')\nB_C()D(#1));\n#1=A('#3=D();');/* #4=A(); */";
  const StepText file = read(text);
  EXPECT_EQ(file.of_type("A"), (std::vector<std::int64_t>{2, 1}));
  EXPECT_EQ(file.of_type("D"), (std::vector<std::int64_t>{2}));
  EXPECT_TRUE(file.of_type("x").empty());
  EXPECT_NE(file.entity(2).as("B_C"), nullptr);
  EXPECT_EQ(file.entity(1).as("A")->at(0).text, "#3=D();");
  EXPECT_TRUE(file.entity(4).records.empty());
}

TEST(StepText, DecodesControlDirectives) {
  const std::string text =
      "DATA;\n#1=A('\\X2\\00E42300\\X0\\ \\X\\E4 \\S\\d \\\\ \\X4\\0001F600\\X0\\');";
  EXPECT_EQ(read(text).entity(1).as("A")->at(0).text, "ä⌀ ä ä \\ 😀");
}

TEST(StepText, EndsInWhatIsBroken) {
  for (const std::string text :
       {"DATA;\n#1=A('open", "DATA;\n#1=A((((", "DATA;\n#1", "DATA;\n#1=(A(", "DATA;\n#1=A(.T",
        "DATA;\n#=A();#1=", "DATA;\n/* #1=A();", "DATA;\n#1=A('\\X2\\00');"}) {
    SCOPED_TRACE(text);
    const StepText file = read(text);
    (void)file.entity(1);
  }
  std::string deep = "DATA;\n#1=A(";
  for (int i = 0; i < 100000; ++i) deep += '(';
  (void)read(deep + ";").entity(1);
}

}  // namespace
}  // namespace burin
