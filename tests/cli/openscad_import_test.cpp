#include "models.h"

#include <nlohmann/json.hpp>

#include <cstdlib>

namespace burin::test {
namespace {

/// Drawings that OpenSCAD imports again.
class OpenscadImportTest : public CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    if (std::system("command -v openscad >/dev/null") != 0) {
      GTEST_SKIP() << "openscad is not installed";
    }
    folder_.write("plate.off", off_text(box({0, 0, 0}, {100, 50, 20})));
  }

  /// Width and height in mm of what OpenSCAD makes of a drawing.
  Vec2 size_of(const std::string& drawing, const std::string& options) {
    EXPECT_EQ(run("draw @/plate.off -o @/" + drawing + " --view top --scale 1 --style outline " +
                  options),
              0)
        << err_;
    folder_.write("i.scad", "hull() linear_extrude(1) import(\"" + drawing + "\");");
    EXPECT_EQ(run("info @/i.scad --json"), 0) << err_;
    const auto part = nlohmann::json::parse(out_)["files"][0]["parts"][0];
    const auto& low = part["bounds"]["min"];
    const auto& high = part["bounds"]["max"];
    return {high[0].get<double>() - low[0].get<double>(),
            high[1].get<double>() - low[1].get<double>()};
  }
};

TEST_F(OpenscadImportTest, SvgAtTrueScale) {
  // A closed outline comes as the area that it bounds.
  const Vec2 area = size_of("d.svg", "");
  EXPECT_NEAR(area.x, 100, 0.005);
  EXPECT_NEAR(area.y, 50, 0.005);
  // Open lines come as areas of their own: the pen's width on either side.
  const double pen = 0.7;
  const Vec2 lines = size_of("d.svg", "--set svg.flatten=polylines");
  EXPECT_NEAR(lines.x, 100 + pen, 0.005);
  EXPECT_NEAR(lines.y, 50 + pen, 0.005);
}

TEST_F(OpenscadImportTest, DxfAtTrueScale) {
  const Vec2 size = size_of("d.dxf", "");
  EXPECT_NEAR(size.x, 100, 0.005);
  EXPECT_NEAR(size.y, 50, 0.005);
}

}  // namespace
}  // namespace burin::test
