// Volumes from the file to the drawing.
#include "models.h"

#include <burin_test/mesh_files.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>

namespace burin {
namespace {

using nlohmann::json;
using test::slurp;

constexpr int kSide = 20;

/// 100 at the middle, falling by 10 a sample: a ball of radius 6 at level 40.
std::string ball() {
  std::string bytes;
  for (int k = 0; k < kSide; ++k) {
    for (int j = 0; j < kSide; ++j) {
      for (int i = 0; i < kSide; ++i) {
        const double c = (kSide - 1) / 2.0;
        const double r = std::sqrt((i - c) * (i - c) + (j - c) * (j - c) + (k - c) * (k - c));
        bytes += test::raw(static_cast<std::int16_t>(std::lround(1000 - 100 * r)));
      }
    }
  }
  return bytes;
}

std::string ball_nrrd(const std::string& more = "") {
  return fmt::format(
             "NRRD0004\ntype: short\ndimension: 3\nsizes: {0} {0} {0}\nendian: little\nencoding: "
             "raw\n{1}\n",
             kSide, more) +
         ball();
}

class Volumes : public test::CliTest {
 protected:
  /// Mean and greatest deviation of the contour from a circle of the radius, in model mm.
  void expect_circle(const std::string& options, Vec3 center, double radius, double tolerance) {
    SCOPED_TRACE(options);
    ASSERT_EQ(run("draw " + options + " -o @/a.json --style outline --view top --paper A5"), 0)
        << err_;
    double length = 0;
    const json drawing = json::parse(slurp(folder_ / "a.json"));
    for (const json& layer : drawing["layers"]) {
      for (const json& path : layer["paths"]) {
        EXPECT_EQ(path["kind"], "contour");
        const json& points = path["points3"];
        Vec3 before(points.back()[0], points.back()[1], points.back()[2]);
        for (const json& p : points) {
          const Vec3 q(p[0], p[1], p[2]);
          EXPECT_NEAR(std::hypot(q.x - center.x, q.y - center.y), radius, tolerance);
          length += glm::distance(before, q);
          before = q;
        }
      }
    }
    EXPECT_NEAR(length / (2 * std::numbers::pi * radius), 1, 0.01);
  }
};

TEST_F(Volumes, ContoursOfABallInManyFormats) {
  const double c = (kSide - 1) / 2.0;
  folder_.write("ball.nrrd", ball_nrrd());
  expect_circle("@/ball.nrrd --iso 400 --interpolate", Vec3(c), 6, 0.01);
  folder_.write("wide.nrrd", ball_nrrd("spacings: 2 2 2\naxis mins: 5 -5 0\n"));
  expect_circle("@/wide.nrrd --iso 400 --interpolate", {2 * c + 5, 2 * c - 5, 0}, 12, 0.02);
  folder_.write("ball.vol", "head" + ball());
  expect_circle("@/ball.vol --iso 400 --raw 20x20x20:i16 --raw-skip 4 --interpolate", Vec3(c), 6,
                0.01);
  // The coefficients' spline lies a sixth of the Laplacian deeper: 100 * (2 / 6) / 6 below 400.
  expect_circle("@/ball.nrrd --iso 400", Vec3(c), 6 - 2.0 / 36, 0.02);
}

TEST_F(Volumes, InfoNeedsNoLevel) {
  folder_.write("ball.nrrd", ball_nrrd("spacings: 1 2 3\n"));
  ASSERT_EQ(run("info @/ball.nrrd"), 0) << err_;
  EXPECT_NE(out_.find("20 x 20 x 20 of i16"), std::string::npos) << out_;
  EXPECT_NE(out_.find("spacing     1 x 2 x 3 mm"), std::string::npos) << out_;
  EXPECT_NE(out_.find("--iso "), std::string::npos) << out_;
  ASSERT_EQ(run("info @/ball.nrrd --json"), 0) << err_;
  json file = json::parse(out_)["files"][0];
  EXPECT_EQ(file["format"], "NRRD");
  EXPECT_TRUE(file["parts"].empty());
  const json& volume = file["volume"];
  EXPECT_EQ(volume["size"], json::array({20, 20, 20}));
  EXPECT_EQ(volume["type"], "i16");
  EXPECT_EQ(volume["steps"][1], json::array({0.0, 2.0, 0.0}));
  EXPECT_LT(volume["min"], volume["level"]);
  EXPECT_GT(volume["max"], volume["level"]);
  EXPECT_LT(volume["percentiles"]["25"], volume["percentiles"]["75"]);
  ASSERT_EQ(run("info @/ball.nrrd --json --iso 400"), 0) << err_;
  file = json::parse(out_)["files"][0];
  const double ball_volume = 4 * std::numbers::pi / 3 * 216 * 6;
  EXPECT_NEAR(file["parts"][0]["volume"].get<double>() / ball_volume, 1, 0.05);
}

TEST_F(Volumes, MistakesAreOneLine) {
  folder_.write("ball.nrrd", ball_nrrd());
  folder_.write("ball.raw", ball());
  const auto refused = [&](const std::string& line, int status, const std::string& part) {
    SCOPED_TRACE(line);
    EXPECT_EQ(run(line), status);
    expect_error(part);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "a.svg"));
  };
  refused("draw @/ball.nrrd -o @/a.svg", 3, "give the level of the surface to draw, e.g. --iso ");
  refused("draw @/ball.nrrd -o @/a.svg --iso 4000", 3, "outside the values of the data, -645 to");
  refused("draw @/ball.raw -o @/a.svg --iso 400", 3, "give --raw");
  refused("draw @/ball.raw -o @/a.svg --iso 400 --raw 20x20x21:i16", 3, "truncated");
  refused("draw @/ball.raw -o @/a.svg --raw 20x20", 2, "three sizes");
  refused("draw @/ball.nrrd -o @/a.svg --iso much", 2, "--iso takes a number");
  refused("draw @/ball.nrrd -o @/a.svg --inside out", 2, "--inside takes above or below");
  refused("draw @/ball.nrrd -o @/a.svg --smooth -1", 2, "--smooth");
  refused("draw @/ball.nrrd -o @/a.svg --volume-degree 4", 2, "2 or 3");
  refused("draw @/ball.nrrd -o @/a.svg --raw-skip 4", 2, "--raw");
  refused("draw @/ball.nrrd -o @/a.svg --iso 400 --bounds 50,50,50,60,60,60", 3, "outside");
  folder_.write("cut.nrrd", ball_nrrd().substr(0, 9000));
  refused("info @/cut.nrrd", 3, "cut.nrrd:4: 20 x 20 x 20 samples of i16 need 16000 bytes");
}

}  // namespace
}  // namespace burin
