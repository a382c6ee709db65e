/// Sizes of metric threads against the numbers of the standards.

#include <burin/threads/metric.h>
#include <burin/threads/unified.h>

#include <gtest/gtest.h>

namespace burin {
namespace {

TEST(Metric, CoarsePitchesAreThoseOfIso261) {
  EXPECT_EQ(coarse_pitch(1.6), 0.35);
  EXPECT_EQ(coarse_pitch(6), 1.0);
  EXPECT_EQ(coarse_pitch(8), 1.25);
  EXPECT_EQ(coarse_pitch(24), 3.0);
  EXPECT_EQ(coarse_pitch(64), 6.0);
  EXPECT_FALSE(coarse_pitch(6.5));
  EXPECT_FALSE(coarse_pitch(200));
}

// The tables of ISO 724 have three places.
TEST(Metric, MinorDiametersAreThoseOfIso724) {
  EXPECT_NEAR(minor_diameter(3, 0.5), 2.459, 5e-4);
  EXPECT_NEAR(minor_diameter(6, 1), 4.917, 5e-4);
  EXPECT_NEAR(minor_diameter(6, 0.75), 5.188, 5e-4);
  EXPECT_NEAR(minor_diameter(10, 1.5), 8.376, 5e-4);
  EXPECT_NEAR(minor_diameter(64, 6), 57.505, 5e-4);
}

TEST(Metric, ADrillTellsItsThread) {
  EXPECT_EQ(coarse_of_minor(5.0), 6.0);
  EXPECT_EQ(coarse_of_minor(8.5), 10.0);
  EXPECT_FALSE(coarse_of_minor(80));
}

TEST(Metric, DesignationsAreReadAsPeopleWriteThem) {
  for (const char* text : {"M6", "m6", " M6 ", "M6-6H", "M6.0"}) {
    const auto size = metric_size(text);
    ASSERT_TRUE(size) << text;
    EXPECT_EQ(size->diameter, 6) << text;
    EXPECT_FALSE(size->pitch) << text;
  }
  for (const char* text : {"M6x0.75", "M6 X 0.75",
                           "M6\xc3\x97"
                           "0.75",
                           "M6x0.75-LH"}) {
    const auto size = metric_size(text);
    ASSERT_TRUE(size) << text;
    EXPECT_EQ(size->diameter, 6) << text;
    EXPECT_EQ(size->pitch, 0.75) << text;
  }
  for (const char* text : {"", "6", "M", "Mx1", "M-6", "M0", "M6x", "M6 bolt", "G1/4", "Mnan"}) {
    EXPECT_FALSE(metric_size(text)) << text;
  }
}

TEST(Unified, SizesAreThoseOfAsmeB11) {
  for (const char* text : {"1/4 UNC", "1/4-20 UNC"}) {
    const auto size = unified_size(text);
    ASSERT_TRUE(size) << text;
    EXPECT_EQ(size->designation, "1/4-20 UNC");
    EXPECT_NEAR(size->diameter, 6.35, 1e-12);
    EXPECT_NEAR(size->pitch, 1.27, 1e-12);
  }
  EXPECT_NEAR(unified_size("#10 UNF")->diameter, 4.826, 1e-9);
  EXPECT_NEAR(unified_size("1 1/8-18 UNEF")->diameter, 28.575, 1e-9);
  EXPECT_EQ(unified_size("UNC", 9)->designation, "1/4-20 UNC");
  EXPECT_EQ(unified_size("UNF", 0)->designation, "#0-80 UNF");
  for (const char* text : {"", "1/4", "1/4-28 UNC", "1/3 UNC", "UNC", " UNC"}) {
    EXPECT_FALSE(unified_size(text)) << text;
  }
  EXPECT_FALSE(unified_size("UNC", 99));
  EXPECT_FALSE(unified_size("BSW", 1));
}

}  // namespace
}  // namespace burin
