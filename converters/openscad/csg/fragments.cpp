#include "fragments.h"

#include <burin/base/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace burin::csg {
namespace {

// Below it OpenSCAD takes a circle for a point.
constexpr double kPoint = 0x1p-20;

/// Of whole degrees, so that what turns by 30, 45 or 90 closes to the bit.
double sine(double degrees) {
  degrees = std::fmod(degrees, 360.0);
  if (degrees < 0) degrees += 360;
  const bool below = degrees >= 180;
  if (below) degrees -= 180;
  if (degrees > 90) degrees = 180 - degrees;
  const double value = degrees == 30   ? 0.5
                       : degrees == 45 ? std::numbers::sqrt2 / 2
                       : degrees == 60 ? std::numbers::sqrt3 / 2
                                       : std::sin(degrees * std::numbers::pi / 180);
  return below ? -value : value;
}

}  // namespace

Fineness fineness_of(const Node& node) {
  Fineness out;
  out.fn = node.number("$fn", out.fn);
  out.fa = node.number("$fa", out.fa);
  out.fs = node.number("$fs", out.fs);
  return out;
}

int fragments(double r, const Fineness& f) {
  if (r < kPoint || !std::isfinite(f.fn)) return 3;
  const double count =
      f.fn > 0 ? std::max(std::floor(f.fn), 3.0)
               : std::ceil(std::max(std::min(360 / f.fa, 2 * std::numbers::pi * r / f.fs), 5.0));
  if (!(count <= kMostFragments)) {
    throw InputError(
        fmt::format("a circle of {:g} corners; set $fn, $fa or $fs to what a machine can hold, "
                    "for example $fn = 100",
                    count));
  }
  return static_cast<int>(count);
}

Vec2 corner(int i, int n) { return direction(360.0 * i / n); }

Vec2 direction(double degrees) { return {sine(degrees + 90), sine(degrees)}; }

}  // namespace burin::csg
