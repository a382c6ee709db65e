// Spline patches from the file to the drawing.
#include "models.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>

namespace burin {
namespace {

using nlohmann::json;
using test::slurp;

/// A torus about z of radii 10 and 4 as IRIT data: two circles of four rational quadratics, exact.
std::string torus_itd() {
  const double corner[9][2] = {{1, 0},   {1, 1},  {0, 1},  {-1, 1}, {-1, 0},
                               {-1, -1}, {0, -1}, {1, -1}, {1, 0}};
  const std::string knots = "[KV 0 0 0 1 1 2 2 3 3 4 4 4]";
  std::string text = fmt::format(
      "[OBJECT [RGB \"10,20,30\"] RING\n[SURFACE BSPLINE 9 9 3 3 P3\n{0}\n{0}\n", knots);
  for (int j = 0; j < 9; ++j) {
    for (int i = 0; i < 9; ++i) {
      const double w =
          (i % 2 == 0 ? 1 : std::numbers::sqrt2 / 2) * (j % 2 == 0 ? 1 : std::numbers::sqrt2 / 2);
      const double r = 10 + 4 * corner[j][0];
      text += fmt::format("[{} {} {} {}]\n", w, w * r * corner[i][0], w * r * corner[i][1],
                          w * 4 * corner[j][1]);
    }
  }
  return text + "]]\n";
}

class Patches : public test::CliTest {};

TEST_F(Patches, ContoursOfATorusAreItsCircles) {
  folder_.write("ring.itd", torus_itd());
  ASSERT_EQ(run("draw @/ring.itd -o @/a.json --style outline --view top --paper A5"), 0) << err_;
  const json j = json::parse(slurp(folder_ / "a.json"));
  EXPECT_EQ(j["parts"][0]["name"], "RING");
  const double scale = j["view"]["scale"];
  double length = 0;
  for (const json& layer : j["layers"]) {
    for (const json& path : layer["paths"]) {
      EXPECT_EQ(path["kind"], "contour");  // no seam, no border of spans
      EXPECT_EQ(path["closed"], true);
      const json& points = path["points3"];
      Vec3 before(points.back()[0], points.back()[1], points.back()[2]);
      for (const json& p : points) {
        const Vec3 q(p[0], p[1], p[2]);
        const double r = std::hypot(q.x, q.y);
        // 0.01 mm of paper.
        EXPECT_LT(std::min(std::abs(r - 14), std::abs(r - 6)) * scale, 0.01);
        length += glm::distance(before, q);
        before = q;
      }
    }
  }
  EXPECT_NEAR(length / (2 * std::numbers::pi * 20), 1, 1e-3);
}

TEST_F(Patches, InfoMeasuresThem) {
  folder_.write("ring.itd", torus_itd());
  ASSERT_EQ(run("info @/ring.itd --json"), 0) << err_;
  const json file = json::parse(out_)["files"][0];
  EXPECT_EQ(file["format"], "IRIT data");
  const json& part = file["parts"][0];
  EXPECT_EQ(part["name"], "RING");
  EXPECT_EQ(part["color"], "#0a141e");
  EXPECT_EQ(part["faces"], 1);
  EXPECT_EQ(part["closed"], true);
  const double pi2 = std::numbers::pi * std::numbers::pi;
  EXPECT_NEAR(part["area"].get<double>() / (4 * pi2 * 40), 1, 2e-3);
  EXPECT_NEAR(part["volume"].get<double>() / (2 * pi2 * 160), 1, 4e-3);
}

TEST_F(Patches, DamageIsToldWithLineAndColumn) {
  folder_.write("bad.itd",
                "[OBJECT A\n  [SURFACE BEZIER 2 2 E3 [0 0 0] [1 0 0] [0 1 0] [nan 1 0]]]\n");
  EXPECT_EQ(run("draw @/bad.itd -o @/a.svg"), 3);
  expect_error("bad.itd:2: column 51: 'nan' is no finite number");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a.svg"));
}

TEST_F(Patches, AreKnownByTheirContent) {
  folder_.write("ring.txt", "# a ring\n" + torus_itd());
  EXPECT_EQ(run("info @/ring.txt"), 0) << err_;
  EXPECT_NE(out_.find("IRIT data"), std::string::npos);
}

}  // namespace
}  // namespace burin
