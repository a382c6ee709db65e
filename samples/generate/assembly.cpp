// The bearing stand: an assembly whose parts touch exactly, plane on plane and cylinder in bore.
#include "models.h"

#include <cmath>
#include <numbers>

namespace burin::samples {

namespace {

constexpr double kPi = std::numbers::pi;
const Vec3 kX(1, 0, 0), kY(0, 1, 0), kZ(0, 0, 1);
constexpr double kAxis = 40;  // height of the shaft over the base plate's top

TriMesh ring(const Outline& section, Vec3 origin, Vec3 axis, int segments) {
  Outline closed = section;
  closed.push_back(section.front());
  Builder builder;
  builder.revolve(closed, origin, axis, segments);
  return builder.finish();
}

// A pillow block: foot and eye in one outline, extruded along y, its bore for the bearing.
TriMesh pillow(double y) {
  const double eye = 24, foot = 54, thick = 11;
  // The cheeks run from the eye down to the foot, tangent to the eye and rounded into the foot.
  const double lean = 0.15;
  const Vec2 touch(eye * std::cos(lean), kAxis + eye * std::sin(lean));
  const Vec2 down(touch.x + (touch.y - thick) * std::tan(lean), thick);
  Outline outline =
      rounded({{{-foot, 0}}, {{foot, 0}}, {{foot, thick}, 3}, {down, 6}, {touch}}, false);
  for (const Vec2 p : arc({0, kAxis}, eye, lean, kPi - lean)) outline.push_back(p);
  const Outline left = rounded(
      {{{-touch.x, touch.y}}, {{-down.x, down.y}, 6}, {{-foot, thick}, 3}, {{-foot, 0}}}, false);
  outline.insert(outline.end(), left.begin() + 1, left.end() - 1);
  // `touch` came twice, from the cheek and from the arc.
  Outline clean;
  for (const Vec2 p : outline) {
    if (clean.empty() || glm::distance(clean.back(), p) > 1e-6) clean.push_back(p);
  }
  const TriMesh flat = plate(clean, {circle({0, kAxis}, 17, circle_segments(17))}, 22, {1, false});
  return transformed(flat, [&](Vec3 p) { return Vec3(p.x, y + 11 - p.z, p.y); });
}

void bearing(std::vector<Solid>& out, const std::string& name, double y) {
  const Vec3 at(0, y, kAxis);
  const int n = circle_segments(17, 0.02);
  // Sections as (radius, along the axis).
  const Outline outer = rounded({{{14.2, -5}},
                                 {{17, -5}, .6},
                                 {{17, 5}, .6},
                                 {{14.2, 5}},
                                 {{14.2, 2.5}},
                                 {{15.2, 0}, 3},
                                 {{14.2, -2.5}}},
                                true);
  const Outline inner = rounded({{{9, -5}, .6},
                                 {{11.4, -5}},
                                 {{11.4, -2.5}},
                                 {{10.4, 0}, 3},
                                 {{11.4, 2.5}},
                                 {{11.4, 5}},
                                 {{9, 5}, .6}},
                                true);
  out.push_back({name + "_outer_ring", ring(outer, at, kY, n)});
  out.push_back({name + "_inner_ring", ring(inner, at, kY, n)});
  Builder balls;
  for (int k = 0; k < 9; ++k) {
    const double a = 2 * kPi * k / 9 + 0.1;
    Outline half = arc({0, 0}, 2.1, -kPi / 2, kPi / 2, 0.03);
    half.front() = {0, -2.1};
    half.back() = {0, 2.1};
    balls.revolve(half, at + 12.8 * Vec3(std::cos(a), 0, std::sin(a)), kY, 24);
  }
  out.push_back({name + "_balls", balls.finish()});
}

TriMesh cap_screw(Vec3 at) {
  // A socket head screw standing on a plane: knurl left out, socket hexagonal.
  const int n = 48;
  const auto loop = [&](double r, double z) {
    return place(circle({0, 0}, r, n), at + z * kZ, kX, kY);
  };
  Builder builder;
  std::vector<Loop> rows{{at}, loop(6.5, 0)};
  for (const Vec2 p : rounded({{{6.5, 0}}, {{6.5, 8}, 0.8}, {{4.4, 8}}}, false)) {
    if (p.y > 0) rows.push_back(loop(p.x, p.y));
  }
  builder.loft(rows);
  Loop mouth, floor;
  for (int k = 0; k < 6; ++k) {
    const double a = kPi / 3 * k;
    mouth.push_back(at + Vec3(3.4 * std::cos(a), 3.4 * std::sin(a), 8));
    floor.push_back(mouth.back() - 4.0 * kZ);
  }
  builder.plane(rows.back(), {mouth});
  builder.strip(mouth, floor);
  builder.plane(floor);
  return builder.finish();
}

TriMesh shaft() {
  const Outline profile = rounded({{{0, -62}},
                                   {{7, -62}},
                                   {{8, -61}},
                                   {{8, -38}},
                                   {{9, -37.5}},
                                   {{9, -14}},
                                   {{11, -14}, .8},
                                   {{11, 14}, .8},
                                   {{9, 14}},
                                   {{9, 48}},
                                   {{8, 48.5}},
                                   {{8, 75}},
                                   {{7, 76}},
                                   {{0, 76}}},
                                  false);
  Builder builder;
  builder.revolve(profile, {0, 0, kAxis}, kY, circle_segments(11, 0.02));
  return builder.finish();
}

TriMesh pulley() {
  // A V-belt pulley on the shaft's thick middle, its web dished.
  const Outline section = rounded({{{11, -13}},
                                   {{17, -13}, 1},
                                   {{18, -4}, 3},
                                   {{34, -4}, 3},
                                   {{35, -11}, 1},
                                   {{42, -11}, .8},
                                   {{42, -8}, .5},
                                   {{33, -2.5}, 1},
                                   {{33, 2.5}, 1},
                                   {{42, 8}, .5},
                                   {{42, 11}, .8},
                                   {{35, 11}, 1},
                                   {{34, 4}, 3},
                                   {{18, 4}, 3},
                                   {{17, 13}, 1},
                                   {{11, 13}}},
                                  true);
  return ring(section, {0, 0, kAxis}, kY, circle_segments(42, 0.03));
}

}  // namespace

std::vector<Solid> bearing_stand() {
  const double thick = 14;
  std::vector<Solid> parts;
  const Outline base =
      rounded({{{-62, -60}, 12}, {{62, -60}, 12}, {{62, 60}, 12}, {{-62, 60}, 12}}, true);
  // The belt pulley dips into a window of the base plate.
  const Outline window =
      rounded({{{-34, -17}, 6}, {{34, -17}, 6}, {{34, 17}, 6}, {{-34, 17}, 6}}, true);
  parts.push_back(
      {"base_plate", moved(plate(base, {window}, thick, {1.5, false}), {0, 0, -thick})});
  for (const double y : {-37.0, 37.0}) {
    const std::string side = y < 0 ? "front" : "rear";
    parts.push_back({"pillow_block_" + side, pillow(y)});
    bearing(parts, "bearing_" + side, y);
    for (const double x : {-45.0, 45.0}) {
      parts.push_back({"screw_" + side + (x < 0 ? "_left" : "_right"), cap_screw({x, y, 11})});
    }
  }
  parts.push_back({"shaft", shaft()});
  parts.push_back({"pulley", pulley()});
  return parts;
}

}  // namespace burin::samples
