#pragma once
// Lines and circles of what is laid over a drawing, of kind Frame; internal to the module.

#include <burin/drawing/drawing.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace burin::detail {

inline Path line(Vec2 a, Vec2 b, double width) {
  Path path;
  path.kind = LineClass::Frame;
  path.points = {a, b};
  path.width = {width};
  return path;
}

/// A filled one of 20 degrees, its tip there.
inline Path arrow_head(Vec2 tip, Vec2 way, double length) {
  constexpr double kOpening = 0.36;  // of the length
  Path head = line(tip - length * way, tip, kOpening * length);
  head.width = {kOpening * length, 0};
  return head;
}

/// Within 0.01 mm of paper.
inline Path circle(Vec2 center, double radius, double width) {
  constexpr int kLeast = 48, kMost = 720;
  constexpr double kError = 0.01;
  const double corners = std::numbers::pi * std::sqrt(std::max(radius, 0.0) / (2 * kError));
  const int n = std::clamp(static_cast<int>(std::ceil(corners)), kLeast, kMost);
  Path path;
  path.kind = LineClass::Frame;
  path.closed = true;
  path.width = {width};
  for (int i = 0; i < n; ++i) {
    const double a = 2 * std::numbers::pi * i / n;
    path.points.push_back(center + radius * Vec2(std::cos(a), std::sin(a)));
  }
  return path;
}

}  // namespace burin::detail
