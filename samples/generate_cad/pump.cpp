#include "kit.h"
#include "models.h"

#include <cmath>
#include <numbers>

namespace burin::samples {
namespace {

// Both gears stand along z, side by side in x; the pump chamber opens to the top.
constexpr double kApart = 36, kTip = 21, kRoot = 15, kGearHeight = 22;
constexpr int kTeeth = 9;
constexpr double kBody = 44, kFloor = kBody - kGearHeight, kGasket = 1.5, kCover = 16;
constexpr double kShaft = 7, kBolt = 3, kWide = 62, kDeep = 40;
const gp_Dir kUp(0, 0, 1);

/// A block with rounded corners from z to z.
TopoDS_Shape plate(double from, double to) {
  return rounded(box({-kWide, -kDeep, from}, {kWide, kDeep, to}), 12,
                 [](const EdgeView& e) { return std::abs(e.direction.Z()) > 0.9; });
}

std::vector<gp_Pnt> bolt_places() {
  std::vector<gp_Pnt> places;
  for (const double x : {-50.0, 0.0, 50.0}) {
    for (const double y : {-30.0, 30.0}) places.emplace_back(x, y, 0);
  }
  return places;
}

std::vector<gp_Pnt> dowel_places() { return {{-52, 0, 0}, {52, 0, 0}}; }

void drill(std::vector<TopoDS_Shape>& tools, const std::vector<gp_Pnt>& places, double radius,
           double from, double to) {
  for (const gp_Pnt& p : places) {
    tools.push_back(cylinder({p.X(), p.Y(), from}, kUp, radius, to - from));
  }
}

/// The room of both gears.
TopoDS_Shape chamber(double from, double to, double radius) {
  const double x = kApart / 2;
  return fuse({cylinder({-x, 0, from}, kUp, radius, to - from),
               cylinder({x, 0, from}, kUp, radius, to - from),
               box({-x / 2, -9, from}, {x / 2, 9, to})});
}

TopoDS_Shape body() {
  std::vector<TopoDS_Shape> tools = {
      chamber(kFloor, kBody + 1, kTip + 0.2),
      cylinder({-kApart / 2, 0, kFloor - 14}, kUp, kShaft, 20),
      cylinder({kApart / 2, 0, kFloor - 14}, kUp, kShaft, 20),
      cylinder({0, -kDeep - 1, kFloor + 11}, gp_Dir(0, 1, 0), 7, 2 * kDeep + 2)};
  drill(tools, bolt_places(), kBolt, 12, kBody + 1);
  drill(tools, dowel_places(), kBolt, kBody - 8, kBody + 1);
  const TopoDS_Shape foot = box({-kWide - 18, -kDeep, 0}, {kWide + 18, kDeep, 10});
  TopoDS_Shape whole = fuse({plate(0, kBody), foot});
  for (const double x : {-kWide - 9, kWide + 9}) {
    for (const double y : {-26.0, 26.0}) tools.push_back(cylinder({x, y, -1}, kUp, 4.5, 20));
  }
  return cut(whole, tools);
}

TopoDS_Shape gasket() {
  std::vector<TopoDS_Shape> tools = {chamber(kBody - 1, kBody + 5, kTip + 2)};
  drill(tools, bolt_places(), kBolt + 0.3, kBody - 1, kBody + 5);
  drill(tools, dowel_places(), kBolt + 0.3, kBody - 1, kBody + 5);
  return cut(plate(kBody, kBody + kGasket), tools);
}

TopoDS_Shape cover() {
  const double low = kBody + kGasket, high = low + kCover;
  TopoDS_Shape whole =
      fuse({plate(low, high), cylinder({-kApart / 2, 0, low}, kUp, 16, kCover + 12)});
  whole = rounded(whole, 4, [](const EdgeView& e) { return !e.convex; });
  whole = chamfered(whole, 1.5, [&](const EdgeView& e) {
    return e.convex && !e.smooth && e.middle.Z() > high + 1;
  });
  std::vector<TopoDS_Shape> tools = {cylinder({-kApart / 2, 0, low - 1}, kUp, kShaft, 60),
                                     cylinder({kApart / 2, 0, low - 1}, kUp, kShaft, 11)};
  drill(tools, bolt_places(), kBolt + 0.3, low - 1, high + 1);
  drill(tools, dowel_places(), kBolt, low - 1, low + 6);
  return cut(whole, tools);
}

/// Straight flanks; the first tooth at `angle`.
TopoDS_Shape gear(double angle) {
  std::vector<gp_Pnt> corners;
  const double pitch = 2 * std::numbers::pi / kTeeth;
  for (int i = 0; i < kTeeth; ++i) {
    for (const auto& [share, r] : {std::pair(-0.32, kRoot), std::pair(-0.13, kTip),
                                   std::pair(0.13, kTip), std::pair(0.32, kRoot)}) {
      const double a = angle + pitch * (i + share);
      corners.emplace_back(r * std::cos(a), r * std::sin(a), 0);
    }
  }
  return cut(prism(corners, {0, 0, kGearHeight}),
             {cylinder({0, 0, -1}, kUp, kShaft, 40), box({-2.5, 0, -1}, {2.5, 10, 40})});
}

/// With the slot of the key where the gear sits, z = 0 at the lower side of that.
TopoDS_Shape shaft(double down, double up) {
  TopoDS_Shape whole = cylinder({0, 0, -down}, kUp, kShaft, down + up);
  whole = chamfered(whole, 1, [](const EdgeView& e) { return e.convex && !e.line; });
  return cut(whole, {box({-2.5, 4, 3}, {2.5, 20, 19})});
}

TopoDS_Shape key() { return box({-2.5, 4, 3}, {2.5, 10, 19}); }

TopoDS_Shape dowel() {
  return chamfered(cylinder({0, 0, -8}, kUp, kBolt, 15), 0.6,
                   [](const EdgeView& e) { return e.convex && !e.line; });
}

/// A cap screw; its head stands on z = 0.
TopoDS_Shape screw(double length) {
  TopoDS_Shape whole =
      fuse({cylinder({0, 0, -length}, kUp, kBolt, length + 1), cylinder({0, 0, 0}, kUp, 5, 6)});
  whole = chamfered(whole, 0.5, [](const EdgeView& e) { return e.convex && !e.line; });
  std::vector<gp_Pnt> socket;
  for (int i = 0; i < 6; ++i) {
    const double a = std::numbers::pi / 3 * i;
    socket.emplace_back(2.9 * std::cos(a), 2.9 * std::sin(a), 3);
  }
  return cut(whole, {prism(socket, {0, 0, 10})});
}

TopoDS_Shape washer() {
  return cut(cylinder({0, 0, 0}, kUp, 6.5, 1.6), {cylinder({0, 0, -1}, kUp, kBolt + 0.2, 4)});
}

gp_Trsf to(double x, double y, double z) {
  gp_Trsf t;
  t.SetTranslation(gp_Vec(x, y, z));
  return t;
}

}  // namespace

Assembly pump() {
  Assembly a;
  a.name = "gear pump";
  const auto color = [](double r, double g, double b) {
    return Quantity_Color(r, g, b, Quantity_TOC_sRGB);
  };
  a.parts = {
      {"body", color(0.55, 0.60, 0.66), body()},
      {"gasket", color(0.45, 0.30, 0.22), gasket()},
      {"cover", color(0.60, 0.64, 0.68), cover()},
      {"gear A", color(0.78, 0.66, 0.36), gear(0)},
      {"gear B", color(0.78, 0.66, 0.36), gear(std::numbers::pi + std::numbers::pi / kTeeth)},
      {"drive shaft", color(0.80, 0.80, 0.82), shaft(12, 70)},
      {"idler shaft", color(0.80, 0.80, 0.82), shaft(12, 32)},
      {"key", color(0.45, 0.45, 0.48), key()},
      {"dowel", color(0.70, 0.70, 0.72), dowel()},
      {"screw M6", color(0.25, 0.25, 0.28), screw(42)},
      {"washer 6", color(0.85, 0.85, 0.85), washer()}};
  a.members = {{"body", 0, {}, {}}, {"gasket", 1, {}, {}}, {"cover", 2, {}, {}}};
  a.members.push_back({"drive",
                       -1,
                       {{"shaft", 5, {}, {}}, {"gear", 3, {}, {}}, {"key", 7, {}, {}}},
                       to(-kApart / 2, 0, kFloor)});
  a.members.push_back({"idler",
                       -1,
                       {{"shaft", 6, {}, {}}, {"gear", 4, {}, {}}, {"key", 7, {}, {}}},
                       to(kApart / 2, 0, kFloor)});
  int number = 0;
  for (const gp_Pnt& p : dowel_places()) {
    a.members.push_back({"dowel " + std::to_string(++number), 8, {}, to(p.X(), p.Y(), kBody)});
  }
  number = 0;
  const double top = kBody + kGasket + kCover;
  for (const gp_Pnt& p : bolt_places()) {
    const std::string n = std::to_string(++number);
    a.members.push_back({"screw " + n, 9, {}, to(p.X(), p.Y(), top + 1.6)});
    a.members.push_back({"washer " + n, 10, {}, to(p.X(), p.Y(), top)});
  }
  return a;
}

}  // namespace burin::samples
