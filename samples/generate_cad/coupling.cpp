#include "kit.h"
#include "models.h"

#include <BRepAlgoAPI_Common.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeCone.hxx>

#include <cmath>
#include <numbers>

namespace burin::samples {
namespace {

constexpr double kShaft = 16, kFlange = 62, kPlate = 16, kBoss = 30, kHubLength = 52;
constexpr double kBoltCircle = 46, kBolt = 5;
constexpr int kBolts = 6;
const gp_Dir kUp(0, 0, 1);

/// A key and its slot: a box in the side of the shaft that comes to lie on top.
TopoDS_Shape key_block(double low, double high, double width, double top) {
  return box({-top, -width, low}, {4 - kShaft, width, high});
}

/// The half coupling: the flange's face at z = 0, the hub towards +z. `spigot` > 0 stands out of
/// the face, < 0 is the recess for it.
TopoDS_Shape half(double spigot) {
  const TopoDS_Shape plate = cylinder({0, 0, 0}, kUp, kFlange, kPlate);
  const TopoDS_Shape boss = cylinder({0, 0, 0}, kUp, kBoss, kHubLength);
  TopoDS_Shape body = fuse({plate, boss});
  body = rounded(body, 6, [](const EdgeView& e) { return !e.convex; });
  body = chamfered(body, 1.5, [](const EdgeView& e) { return e.convex && e.middle.Z() > 1; });
  std::vector<TopoDS_Shape> tools = {cylinder({0, 0, -10}, kUp, kShaft, 100),
                                     box({-kShaft - 3.3, -5, -10}, {0, 5, 100})};
  const TopoDS_Shape hole = cylinder({kBoltCircle, 0, -10}, kUp, kBolt + 0.25, 60);
  for (TopoDS_Shape& copy : round_about(hole, kBolts)) tools.push_back(copy);
  if (spigot > 0) {
    body = fuse({body, cylinder({0, 0, -spigot}, kUp, 28, 10)});
  } else {
    tools.push_back(cylinder({0, 0, -10}, kUp, 28.1, 10 - spigot));
  }
  return cut(body, tools);
}

/// From the middle of the coupling along +z, with a slot for the key.
TopoDS_Shape shaft(double from, double to) {
  TopoDS_Shape body = cylinder({0, 0, from}, kUp, kShaft, to - from);
  body = chamfered(body, 1.5, [](const EdgeView& e) { return e.convex && !e.line; });
  return cut(body, {key_block(8, 62, 5, 40)});
}

TopoDS_Shape key() {
  return rounded(key_block(8, 62, 5, kShaft + 3), 4.9,
                 [](const EdgeView& e) { return std::abs(e.direction.X()) > 0.9; });
}

/// A hexagonal prism from z = 0, chamfered by a cone at its upper end, or both.
TopoDS_Shape hexagon(double across, double height, bool both) {
  std::vector<gp_Pnt> corners;
  const double r = across / std::sqrt(3.0);
  for (int i = 0; i < 6; ++i) {
    const double a = std::numbers::pi / 3 * i;
    corners.emplace_back(r * std::cos(a), r * std::sin(a), 0);
  }
  const double top = across / 2 - 0.4, slope = std::tan(std::numbers::pi / 6);
  const double drop = (r - top) * slope;
  std::vector<std::pair<double, double>> profile = {
      {0, 0},        {both ? top : r, 0}, {r, both ? drop : 0.0}, {r, height - drop},
      {top, height}, {0, height}};
  if (!both) profile.erase(profile.begin() + 2);
  return BRepAlgoAPI_Common(prism(corners, {0, 0, height}), turned(profile)).Shape();
}

TopoDS_Shape bolt(double grip) {
  TopoDS_Shape shank = cylinder({0, 0, -grip}, kUp, kBolt, grip + 1);
  shank = chamfered(shank, 0.9, [](const EdgeView& e) { return e.convex && e.middle.Z() < 0; });
  return fuse({shank, hexagon(17, 6.4, false)});
}

TopoDS_Shape nut() {
  const TopoDS_Shape body = cut(hexagon(17, 8, true), {cylinder({0, 0, -1}, kUp, kBolt, 20)});
  return chamfered(body, 0.7, [](const EdgeView& e) {
    return e.convex && std::hypot(e.middle.X(), e.middle.Y()) < kBolt + 1e-3;
  });
}

TopoDS_Shape washer() {
  return cut(cylinder({0, 0, 0}, kUp, 10, 2), {cylinder({0, 0, -1}, kUp, kBolt + 0.3, 4)});
}

gp_Trsf turn_over() {
  gp_Trsf t;
  t.SetRotation(gp::OX(), std::numbers::pi);
  return t;
}

gp_Trsf lift(double z) {
  gp_Trsf t;
  t.SetTranslation(gp_Vec(0, 0, z));
  return t;
}

/// The coupling stands along x.
gp_Trsf lay_down() {
  gp_Trsf t;
  t.SetRotation(gp::OY(), std::numbers::pi / 2);
  return t;
}

}  // namespace

Assembly coupling() {
  Assembly a;
  a.name = "flange coupling";
  const auto color = [](double r, double g, double b) {
    return Quantity_Color(r, g, b, Quantity_TOC_sRGB);
  };
  a.parts = {{"driving hub", color(0.55, 0.60, 0.66), half(4)},
             {"driven hub", color(0.66, 0.60, 0.52), half(-4.5)},
             {"driving shaft", color(0.80, 0.80, 0.82), shaft(2, 120)},
             {"driven shaft", color(0.80, 0.80, 0.82), shaft(6, 120)},
             {"key", color(0.45, 0.45, 0.48), key()},
             {"bolt M10", color(0.25, 0.25, 0.28), bolt(50)},
             {"nut M10", color(0.72, 0.62, 0.30), nut()},
             {"washer 10", color(0.85, 0.85, 0.85), washer()}};
  const gp_Trsf over = turn_over();
  Member driving{"driving side",
                 -1,
                 {{"hub", 0, {}, {}}, {"shaft", 2, {}, {}}, {"key", 4, {}, {}}},
                 lay_down()};
  Member driven{"driven side",
                -1,
                {{"hub", 1, {}, {}}, {"shaft", 3, {}, {}}, {"key", 4, {}, {}}},
                lay_down() * over};
  Member set{"bolt set",
             -1,
             {{"bolt", 5, {}, lift(kPlate + 2)},
              {"upper washer", 7, {}, lift(kPlate)},
              {"lower washer", 7, {}, lift(-kPlate - 2)},
              {"nut", 6, {}, lift(-kPlate - 10)}},
             {}};
  a.members = {driving, driven};
  for (int i = 0; i < kBolts; ++i) {
    gp_Trsf turn, out;
    turn.SetRotation(gp::OZ(), 2 * std::numbers::pi * i / kBolts);
    out.SetTranslation(gp_Vec(kBoltCircle, 0, 0));
    set.name = "bolt set " + std::to_string(i + 1);
    set.place = lay_down() * turn * out;
    a.members.push_back(set);
  }
  return a;
}

Assembly revised_coupling() {
  Assembly a = coupling();
  // Holes between those of the bolts.
  std::vector<TopoDS_Shape> holes;
  for (int i = 0; i < 3; ++i) {
    gp_Trsf turn;
    turn.SetRotation(gp::OZ(), std::numbers::pi / kBolts * (4 * i + 1));
    const TopoDS_Shape hole = cylinder({kBoltCircle, 0, -10}, kUp, 6, 60);
    holes.push_back(BRepBuilderAPI_Transform(hole, turn, Standard_True).Shape());
  }
  a.parts[0].shape = cut(a.parts[0].shape, holes);
  Member& driving = a.members[0];
  driving.group[2].place = lift(24);  // the key
  a.parts.push_back({"set screw", a.parts[5].color, cylinder({0, -27, 40}, -gp::DY(), 4, 9)});
  driving.group.push_back({"set screw", static_cast<int>(a.parts.size()) - 1, {}, {}});
  a.members.erase(a.members.begin() + 5);  // bolt set 4
  return a;
}

}  // namespace burin::samples
