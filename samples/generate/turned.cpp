// Surfaces of revolution and their relatives: spindle, vase, spring, knot.
#include "models.h"

#include <cmath>
#include <numbers>

namespace burin::samples {

namespace {
constexpr double kPi = std::numbers::pi;

void append(Outline& to, const Outline& more) { to.insert(to.end(), more.begin(), more.end()); }
}  // namespace

std::vector<Solid> spindle() {
  // (radius, height) from the chamfered end to the ball end.
  Outline profile = rounded(
      {{{0, 0}},        {{8, 0}},       {{9.5, 1.5}},     {{9.5, 24}},      {{8, 24}, 0.6},
       {{8, 28}, 0.6},  {{14, 28}},     {{15, 29}},       {{15, 46}, 4},    {{30, 46}, 1.5},
       {{30, 56}, 1.5}, {{18, 56}, 5},  {{18, 70}},       {{15.5, 70}, .5}, {{15.5, 74}, .5},
       {{18, 74}},      {{18, 80}},     {{15.5, 80}, .5}, {{15.5, 84}, .5}, {{18, 84}},
       {{18, 90}, 3},   {{11, 114}, 8}, {{6.5, 118}, 3},  {{6.5, 122}}},
      false);
  // The ball sits where the neck of radius 6.5 meets it.
  const double ball = 13, start = -std::acos(6.5 / ball);
  const Vec2 center(0, 122 - ball * std::sin(start));
  Outline cap = arc(center, ball, start, kPi / 2);
  cap.erase(cap.begin());
  cap.back() = {0, center.y + ball};
  append(profile, cap);
  Builder builder;
  builder.revolve(profile, {0, 0, 0}, {1, 0, 0}, circle_segments(30));
  return {{"spindle", builder.finish()}};
}

std::vector<Solid> vase() {
  const int around = 200, up = 64;
  // The belly as a smooth profile; lobes that turn as they rise and fade towards foot and neck.
  const auto belly = [](double t) {
    return 21 + 15 * std::sin(kPi * (0.12 + 1.15 * t)) + 4 * std::pow(t, 6);
  };
  const auto row = [&](double t, double inset) {
    const double fade =
        std::pow(std::sin(kPi * std::min(1.0, std::max(0.0, (t - 0.04) / 0.80))), 2);
    Loop loop;
    for (int i = 0; i < around; ++i) {
      const double a = 2 * kPi * i / around;
      const double lobe = std::pow(std::abs(std::cos(6 * (a + 1.1 * t))), 1.4);
      const double r = belly(t) - inset + (inset > 0 ? 0 : 3.2 * fade * (lobe - 0.5));
      loop.emplace_back(r * std::cos(a), r * std::sin(a), 4 + 106 * t);
    }
    return loop;
  };
  const auto ring = [&](double r, double z) {
    return place(circle({0, 0}, r, around), {0, 0, z}, {1, 0, 0}, {0, 1, 0});
  };
  std::vector<Loop> rows{{Vec3(0, 0, 1.5)}, ring(18, 1.5), ring(19.5, 0)};
  const double foot = belly(0);
  for (const Vec2 p : arc({foot + 1.2, 2}, 2, -kPi / 2, kPi / 2)) rows.push_back(ring(p.x, p.y));
  for (int j = 0; j <= up; ++j) rows.push_back(row(static_cast<double>(j) / up, 0));
  const double lip = belly(1);
  for (const Vec2 p : arc({lip - 1.5, 110}, 1.5, 0.2, kPi - 0.2)) rows.push_back(ring(p.x, p.y));
  for (int j = 40; j >= 0; --j) rows.push_back(row(j / 40.0, 3));
  rows.push_back({Vec3(0, 0, 4)});
  Builder builder;
  builder.loft(rows);
  return {{"vase", builder.finish()}};
}

std::vector<Solid> spring() {
  // Six working turns between closed end turns, where the wire lies wire on wire.
  const double wire = 2.2, radius = 17, turns = 9, pitch = 10;
  const auto height = [&](double t) {
    const double closed = 2 * wire + 0.15, end = 1.0, blend = 1.0;
    double z = 0;
    const int steps = 400;
    for (int i = 0; i < steps; ++i) {
      const double at = turns * t * (i + 0.5) / steps, edge = std::min(at, turns - at);
      const double share = std::min(1.0, std::max(0.0, (edge - end) / blend));
      z += (closed + (pitch - closed) * share * share * (3 - 2 * share)) * turns * t / steps;
    }
    return z;
  };
  const auto curve = [&](double t) {
    const double a = 2 * kPi * turns * t;
    return Vec3(radius * std::cos(a), radius * std::sin(a), height(t));
  };
  return {{"spring", tube(
                         curve, [&](double) { return wire; }, 560, 24, false)}};
}

std::vector<Solid> knot(int along, int around) {
  const auto curve = [](double t) {
    const double a = 2 * kPi * t;
    return 17.0 * Vec3(std::sin(a) + 2 * std::sin(2 * a), std::cos(a) - 2 * std::cos(2 * a),
                       -1.15 * std::sin(3 * a));
  };
  return {{"knot", tube(
                       curve, [](double) { return 9.5; }, along, around, true)}};
}

}  // namespace burin::samples
