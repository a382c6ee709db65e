// Machine elements: bracket, gear, bolt with washer and nut.
#include "models.h"

#include <cmath>
#include <numbers>

namespace burin::samples {

namespace {

constexpr double kPi = std::numbers::pi;
const Vec3 kX(1, 0, 0), kY(0, 1, 0), kZ(0, 0, 1);

// A hole through both faces of a panel, with a countersink on the upper one.
struct Hole {
  Outline at;
  Outline sink;
  double depth = 0;
};

Hole drilled(Vec2 center, double radius, double sink = 0) {
  const int n = circle_segments(std::max(radius, sink));
  return {circle(center, radius, n), sink > 0 ? circle(center, sink, n) : Outline{}, sink - radius};
}

Hole slot(Vec2 center, double half_length, double radius) {
  return {rounded({{center + Vec2(-half_length - radius, -radius), radius * 0.999999},
                   {center + Vec2(half_length + radius, -radius), radius * 0.999999},
                   {center + Vec2(half_length + radius, radius), radius * 0.999999},
                   {center + Vec2(-half_length - radius, radius), radius * 0.999999}},
                  true),
          {},
          0};
}

// A flat panel of thickness `t` in the frame (origin, u, v, w): its faces and its holes, without
// the rim between.
void panel(Builder& builder, const Outline& outline, const std::vector<Hole>& holes, double t,
           Vec3 origin, Vec3 u, Vec3 v, const std::vector<Loop>& bosses = {}) {
  const Vec3 w = glm::cross(u, v);
  std::vector<Loop> lower, upper = bosses;
  for (const Hole& h : holes) {
    lower.push_back(place(h.at, origin, u, v));
    if (h.sink.empty()) {
      upper.push_back(place(h.at, origin + t * w, u, v));
      builder.strip(lower.back(), upper.back());
    } else {
      const Loop neck = place(h.at, origin + (t - h.depth) * w, u, v);
      upper.push_back(place(h.sink, origin + t * w, u, v));
      builder.loft({lower.back(), neck, upper.back()});
    }
  }
  builder.plane(place(outline, origin, u, v), lower);
  builder.plane(place(outline, origin + t * w, u, v), upper);
}

// The rim between the two faces of a panel, but for the last segment, where the bend goes on.
void rim(Builder& builder, const Outline& outline, double t, Vec3 origin, Vec3 u, Vec3 v) {
  builder.strip(place(outline, origin, u, v), place(outline, origin + t * glm::cross(u, v), u, v),
                false);
}

}  // namespace

std::vector<Solid> bracket() {
  // A base and a wall, joined by a bend of inner radius `in`; the wall ends round about a boss with
  // a bore.
  const double t = 8, width = 76, in = 7, base = 62, boss_z = 52, half = width / 2;
  Builder builder;
  // Both outlines begin and end on the bend: x from -half to half, their second coordinate away
  // from it.
  const Outline floor =
      rounded({{{half, 0}}, {{half, base}, 14}, {{-half, base}, 14}, {{-half, 0}}}, false);
  Outline wall{{half, 0}};
  for (const Vec2 p : arc({0, boss_z}, half, 0, kPi)) wall.push_back(p);
  wall.emplace_back(-half, 0);

  const Vec3 floor_at(0, -in, 0), wall_at(0, 0, in + t);
  // The floor runs towards -y; seen from above it is mirrored, so its frame is (-x, -y, z).
  panel(builder, floor,
        {drilled({-24, 46}, 4.5, 8.5), drilled({24, 46}, 4.5, 8.5), slot({0, 24}, 12, 4.5)}, t,
        floor_at, -kX, -kY);
  rim(builder, floor, t, floor_at, -kX, -kY);

  // The boss on the front of the wall: fillet, cylinder, rounded edge, counterbore, bore.
  const int n = circle_segments(half);
  const auto ring = [&](double r, double out) {
    return place(circle({0, boss_z}, r, n), wall_at + Vec3(0, -out, 0), kX, kZ);
  };
  const Outline boss = rounded({{{27, 0}},
                                {{23, 0}, 4},
                                {{23, 14}, 2},
                                {{16, 14}},
                                {{15, 13}},
                                {{15, 8}},
                                {{11, 8}},
                                {{11, -t}}},
                               false);
  std::vector<Loop> rings;
  for (const Vec2 p : boss) rings.push_back(ring(p.x, p.y));
  builder.loft(rings);
  const auto drill = [&](double x, double z) { return drilled({x, z}, 3.3); };
  const std::vector<Hole> small{drill(-26, 12), drill(26, 12)};
  std::vector<Loop> front{rings.front()}, back{rings.back()};
  for (const Hole& h : small) {
    front.push_back(place(h.at, wall_at, kX, kZ));
    back.push_back(place(h.at, wall_at + Vec3(0, t, 0), kX, kZ));
    builder.strip(front.back(), back.back());
  }
  builder.plane(place(wall, wall_at, kX, kZ), front);
  builder.plane(place(wall, wall_at + Vec3(0, t, 0), kX, kZ), back);
  builder.strip(place(wall, wall_at, kX, kZ), place(wall, wall_at + Vec3(0, t, 0), kX, kZ), false);

  // The bend: quarter circles about (y, z) = (-in, in + t).
  const Outline turn = arc({0, 0}, in + t, -kPi / 2, 0);
  std::vector<Loop> inner, outer;
  for (const Vec2 p : turn) {
    const Vec3 o(0, -in + p.x, in + t + p.y),
        i(0, -in + p.x * in / (in + t), in + t + p.y * in / (in + t));
    outer.push_back({o + half * kX, o - half * kX});
    inner.push_back({i + half * kX, i - half * kX});
  }
  builder.loft(outer, false);
  builder.loft(inner, false);
  for (const std::size_t side : {0u, 1u}) {
    Loop a, b;
    for (std::size_t i = 0; i < turn.size(); ++i) {
      a.push_back(inner[i][side]);
      b.push_back(outer[i][side]);
    }
    builder.strip(a, b, false);
  }
  return {{"bracket", builder.finish()}};
}

namespace {

// The outline of an involute gear, centred, starting in the middle of a gap.
Outline gear_outline(int teeth, double module, double pressure) {
  const double pitch = module * teeth / 2, base = pitch * std::cos(pressure);
  const double tip = pitch + module, root = pitch - 1.25 * module;
  const auto involute = [](double a) { return std::tan(a) - a; };
  const auto half_at = [&](double r) {
    const double a = r > base ? std::acos(base / r) : 0;
    return kPi / (2 * teeth) + involute(pressure) - involute(a);
  };
  std::vector<Vec2> half;  // (radius, half angle) from the gap to the tip
  const double gap = kPi / teeth, foot = half_at(base), fillet = root + 0.38 * module;
  for (int i = 0; i <= 4; ++i) {  // the fillet of the root, a quarter of an ellipse
    const double s = kPi / 2 * i / 4;
    half.emplace_back(root + (fillet - root) * (1 - std::cos(s)),
                      gap - (gap - foot - 0.004) * (0.35 + 0.65 * std::sin(s)));
  }
  const double start = std::max(base, fillet) + 0.05;
  for (int i = 0; i <= 8; ++i) {
    const double r = start + (tip - start) * std::pow(i / 8.0, 0.8);
    half.emplace_back(r, half_at(r));
  }
  Outline out;
  for (int k = 0; k < teeth; ++k) {
    const double center = 2 * kPi * k / teeth;
    const auto add = [&](double r, double a) { out.push_back({r * std::cos(a), r * std::sin(a)}); };
    for (const Vec2 p : half) add(p.x, center - p.y);
    for (auto p = half.rbegin(); p != half.rend(); ++p) add(p->x, center + p->y);
  }
  return out;
}

}  // namespace

std::vector<Solid> gear() {
  // A herringbone gear: the outline turns one way up to the middle and back again.
  const int teeth = 30;
  const double module = 3, half = 13, helix = 26 * kPi / 180, pitch = module * teeth / 2;
  const Outline outline = gear_outline(teeth, module, 20 * kPi / 180);
  Builder builder;
  std::vector<Loop> rows;
  const int layers = 7;
  for (int j = -layers; j <= layers; ++j) {
    const double z = half * j / layers, a = (half - std::abs(z)) * std::tan(helix) / pitch;
    const Vec3 u(std::cos(a), std::sin(a), 0);
    rows.push_back(place(outline, {0, 0, z}, u, glm::cross(kZ, u)));
  }
  builder.loft(rows);
  // Both sides: rim, recess with fillets, web with holes, hub with a chamfered bore.
  const int n = circle_segments(34);
  const Outline side = rounded(
      {{{34, 13}}, {{32.5, 6}, 2.5}, {{16.5, 6}, 2.5}, {{15, 15}}, {{9.5, 15}}, {{8.5, 14}}},
      false);
  std::vector<std::vector<Loop>> sides;
  for (const double sign : {1.0, -1.0}) {
    std::vector<Loop> rings;
    std::size_t web = 0;
    for (const Vec2 p : side)
      rings.push_back(place(circle({0, 0}, p.x, n), {0, 0, sign * p.y}, kX, kY));
    builder.plane(sign > 0 ? rows.back() : rows.front(), {rings.front()});
    for (std::size_t i = 0; i + 1 < side.size(); ++i) {
      if (side[i].y == side[i + 1].y && side[i].y < 7 && side[i].x - side[i + 1].x > 3) {
        web = i;
      } else {
        builder.strip(rings[i], rings[i + 1]);
      }
    }
    sides.push_back({rings[web], rings[web + 1], rings.back()});
  }
  std::vector<Loop> upper{sides[0][1]}, lower{sides[1][1]};
  for (int k = 0; k < 6; ++k) {
    const double a = kPi / 3 * k;
    const Outline hole = circle({24.5 * std::cos(a), 24.5 * std::sin(a)}, 5, circle_segments(5));
    upper.push_back(place(hole, {0, 0, 6}, kX, kY));
    lower.push_back(place(hole, {0, 0, -6}, kX, kY));
    builder.strip(upper.back(), lower.back());
  }
  builder.plane(sides[0][0], upper);
  builder.plane(sides[1][0], lower);
  builder.strip(sides[0][2], sides[1][2]);
  return {{"gear", builder.finish()}};
}

std::vector<Loop> thread_rows(double major, double core, double pitch, double length,
                              int segments) {
  // Rows along the helix: every row is one line of the thread's profile (root, flank, crest,
  // flank), and steps up by one pitch a turn. Where a point leaves [0, length] it is set on the end
  // circle: there the thread has faded.
  const double step[] = {0.0, 0.15, 0.45, 0.55, 0.85};
  const double share[] = {0, 0, 1, 1, 0};
  std::vector<Loop> rows;
  const int turns = static_cast<int>(std::ceil(length / pitch));
  for (int k = -1; k <= turns; ++k) {
    for (std::size_t s = 0; s < std::size(step); ++s) {
      Loop row;
      for (int i = 0; i <= segments; ++i) {
        const double a = 2 * kPi * i / segments;
        const double z = std::min(
            length, std::max(0.0, pitch * (k + step[s] + static_cast<double>(i) / segments)));
        const double fade =
            std::min(1.0, std::max(0.0, (std::min(z, length - z) / pitch - 0.1) / 0.9));
        const double r = core + (major - core) * share[s] * fade;
        row.emplace_back(r * std::cos(a), r * std::sin(a), z);
      }
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

namespace {

// A hexagon of width `flats` across flats, `per_side` points a side, with a height that the chamfer
// cone of 30 degrees leaves below `top`.
Loop hexagon(double flats, int per_side, const std::function<double(double)>& height) {
  Loop loop;
  for (int k = 0; k < 6; ++k) {
    for (int i = 0; i < per_side; ++i) {
      const double a = kPi / 3 * k,
                   y = flats / std::sqrt(3.0) * (static_cast<double>(i) / per_side - 0.5);
      const Vec2 p(flats / 2, y);
      const double r = glm::length(p);
      loop.emplace_back(p.x * std::cos(a) - p.y * std::sin(a),
                        p.x * std::sin(a) + p.y * std::cos(a), height(r));
    }
  }
  return loop;
}

// A circle whose points stand at the angles of a hexagon's points.
Loop beside(const Loop& hex, double radius, double z) {
  Loop loop;
  for (const Vec3& p : hex) {
    const double r = std::hypot(p.x, p.y);
    loop.emplace_back(p.x / r * radius, p.y / r * radius, z);
  }
  return loop;
}

constexpr int kPerSide = 16;
constexpr int kRound = 6 * kPerSide;

Loop round_loop(double r, double z) { return place(circle({0, 0}, r, kRound), {0, 0, z}, kX, kY); }

}  // namespace

std::vector<Solid> bolt() {
  const double flats = 24, shank = 8, core = 6.7, pitch = 2, length = 46, neck = 74;
  const auto cone = [&](double top, double sign) {
    return
        [=](double r) { return top - sign * std::max(0.0, r - flats * 0.475) * std::tan(kPi / 6); };
  };
  Builder head;
  const auto rows = thread_rows(shank, core, pitch, length, kRound);
  head.loft(rows, false);
  head.loft({{Vec3(0, 0, -1)}, round_loop(core - 1, -1), round_loop(core, 0)});
  const Outline shape = rounded({{{core, length}},
                                 {{shank, length + 1.5}},
                                 {{shank, neck}, 1},
                                 {{11.2, neck}},
                                 {{11.2, neck + 0.6}}},
                                false);
  std::vector<Loop> rings;
  for (const Vec2 p : shape) rings.push_back(round_loop(p.x, p.y));
  head.loft(rings);
  const Loop bottom = hexagon(flats, kPerSide, [&](double) { return neck + 0.6; });
  head.plane(bottom, {rings.back()});
  const Loop edge = hexagon(flats, kPerSide, cone(neck + 10.6, 1));
  head.loft({bottom, edge, beside(edge, flats * 0.475, neck + 10.6), {Vec3(0, 0, neck + 10.6)}});

  // The nut: chamfered on both faces, its thread a plain bore that clears the bolt's crest by
  // nothing visible.
  const double low = 18, high = 31;
  Builder nut;
  const Loop below = hexagon(flats, kPerSide, cone(low, -1)),
             above = hexagon(flats, kPerSide, cone(high, 1));
  nut.loft({round_loop(shank + 0.05, low + 0.8), round_loop(shank + 0.85, low),
            beside(below, flats * 0.475, low), below, above, beside(above, flats * 0.475, high),
            round_loop(shank + 0.85, high), round_loop(shank + 0.05, high - 0.8)});
  nut.strip(round_loop(shank + 0.05, low + 0.8), round_loop(shank + 0.05, high - 0.8));

  Builder washer;
  const Outline ring =
      rounded({{{8.5, neck - 3}}, {{15, neck - 3}, 0.3}, {{15, neck}, 0.3}, {{8.5, neck}}}, true);
  std::vector<Loop> loops;
  for (const Vec2 p : ring) loops.push_back(round_loop(p.x, p.y));
  loops.push_back(loops.front());
  washer.loft(loops);
  return {{"bolt", head.finish()}, {"nut", nut.finish()}, {"washer", washer.finish()}};
}

}  // namespace burin::samples
