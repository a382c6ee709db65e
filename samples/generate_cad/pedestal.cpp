#include "kit.h"
#include "models.h"

#include <cmath>
#include <numbers>

namespace burin::samples {
namespace {

constexpr double kLength = 74, kWidth = 40, kFoot = 16;       // half, half, height
constexpr double kAxis = 68, kBarrel = 36, kBarrelHalf = 31;  // height, radius, half length
constexpr double kWall = 17;                                  // half thickness
const gp_Dir kAlong(0, 1, 0), kUp(0, 0, 1);

TopoDS_Shape foot() {
  const TopoDS_Shape block = box({-kLength, -kWidth, 0}, {kLength, kWidth, kFoot});
  const TopoDS_Shape corners = rounded(
      block, 14, [](const EdgeView& e) { return e.line && std::abs(e.direction.Z()) > 0.9; });
  // Relieved below, so that it stands on two pads.
  return cut(corners, {box({-36, -60, -1}, {36, 60, 3})});
}

TopoDS_Shape wall() {
  return prism({{-50, -kWall, 8}, {50, -kWall, 8}, {22, -kWall, kAxis}, {-22, -kWall, kAxis}},
               {0, 2 * kWall, 0});
}

TopoDS_Shape ribs() {
  return prism({{-6, -36, 8}, {-6, 36, 8}, {-6, 14, 46}, {-6, -14, 46}}, {12, 0, 0});
}

TopoDS_Shape body() {
  const TopoDS_Shape barrel = cylinder({0, -kBarrelHalf, kAxis}, kAlong, kBarrel, 2 * kBarrelHalf);
  const TopoDS_Shape boss = cylinder({0, 0, kAxis}, kUp, 9, kBarrel + 9);
  const TopoDS_Shape rough = fuse({foot(), wall(), ribs(), barrel, boss});
  const TopoDS_Shape inside =
      rounded(rough, 3.5, [](const EdgeView& e) { return !e.convex && e.middle.Z() > 10; });
  return rounded(inside, 2, [](const EdgeView& e) {
    const bool rim = std::abs(std::abs(e.middle.Y()) - kBarrelHalf) < 1e-3 && e.middle.Z() > 25;
    return e.convex && (rim || std::abs(e.middle.Z() - kFoot) < 1e-3);
  });
}

std::vector<TopoDS_Shape> holes() {
  std::vector<TopoDS_Shape> tools;
  tools.push_back(cylinder({0, -60, kAxis}, kAlong, 19, 120));
  tools.push_back(cylinder({0, 10, kAxis}, kAlong, 26, 60));
  tools.push_back(cylinder({0, -10, kAxis}, gp_Dir(0, -1, 0), 26, 60));
  tools.push_back(cylinder({0, 0, kAxis}, kUp, 3, 80));
  tools.push_back(cylinder({0, 0, kAxis + kBarrel + 4}, kUp, 5.5, 20));
  for (const double x : {-58.0, 58.0}) {
    for (const double y : {-25.0, 25.0}) {
      tools.push_back(cylinder({x, y, -5}, kUp, 5.5, 60));
      tools.push_back(cylinder({x, y, kFoot - 6}, kUp, 9, 60));
    }
  }
  for (int i = 0; i < 6; ++i) {
    const double a = std::numbers::pi * (i + 0.5) / 3;
    const gp_Pnt p(31 * std::cos(a), 0, kAxis + 31 * std::sin(a));
    tools.push_back(cylinder({p.X(), kBarrelHalf - 12, p.Z()}, kAlong, 2.1, 40));
    tools.push_back(cylinder({p.X(), -kBarrelHalf + 12, p.Z()}, gp_Dir(0, -1, 0), 2.1, 40));
  }
  return tools;
}

}  // namespace

TopoDS_Shape pedestal() {
  const TopoDS_Shape drilled = cut(body(), holes());
  return chamfered(drilled, 1, [](const EdgeView& e) {
    // The rim of the bore.
    const double r = std::hypot(e.middle.X(), e.middle.Z() - kAxis);
    return e.convex && std::abs(std::abs(e.middle.Y()) - kBarrelHalf) < 1e-3 &&
           std::abs(r - 26) < 1e-3;
  });
}

}  // namespace burin::samples
