#include "pen_lines.h"

#include <burin/drawing/arcs.h>
#include <burin/drawing/bezier.h>
#include <burin/drawing/length.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace burin {
namespace {

/// A line that is to be cut into dashes, with so many points on its arcs that each dash is known
/// for one.
std::vector<Vec2> along_arcs(const std::vector<Vec2>& line, const std::vector<double>& dashes) {
  constexpr double kOfADash = 6;
  const double step = *std::ranges::max_element(dashes) / kOfADash;
  std::vector<Vec2> dense;
  for (const CurvePiece& piece : fit_arcs(line, false, {kThinned, kChords, false, true})) {
    const std::size_t from = dense.empty() ? 0 : 1;  // each begins where the one before ends
    if (!piece.arc) {
      dense.insert(dense.end(), piece.points.begin() + static_cast<std::ptrdiff_t>(from),
                   piece.points.end());
      continue;
    }
    const double length = piece.arc->radius() * std::abs(piece.arc->turn);
    const double count = std::clamp(std::ceil(length / step), 1.0, 1e6);
    const auto n = std::max(piece.points.size(), static_cast<std::size_t>(count));
    for (std::size_t i = from; i <= n; ++i) {
      dense.push_back(piece.arc->at(piece.arc->begin + piece.arc->turn * double(i) / double(n)));
    }
  }
  return dense;
}

}  // namespace

std::vector<Vec2> thinned(const std::vector<Vec2>& all) {
  std::vector<Vec2> line;
  for (const std::size_t i : simplify(all, kThinned)) line.push_back(all[i]);
  return line;
}

std::vector<std::vector<Vec2>> dashes_of(const std::vector<Vec2>& line,
                                         const std::vector<double>& lengths) {
  std::vector<std::vector<Vec2>> pieces{{line.front()}};
  std::size_t part = 0;
  double left = lengths[0];
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double length = glm::distance(line[i - 1], line[i]);
    double at = 0;
    while (length - at > left) {
      at += left;
      const Vec2 here = glm::mix(line[i - 1], line[i], at / length);
      // Even parts are ink.
      if (part % 2 == 0) {
        pieces.back().push_back(here);
      } else {
        pieces.push_back({here});
      }
      part = (part + 1) % lengths.size();
      left = lengths[part];
    }
    left -= length - at;
    if (part % 2 == 0) pieces.back().push_back(line[i]);
  }
  return pieces;
}

std::vector<std::vector<Vec2>> dashes_along(const std::vector<Vec2>& line,
                                            std::vector<double> dashes) {
  const std::vector<Vec2> dense = along_arcs(line, dashes);
  constexpr double kNoRest = 1 + 1e-9;  // the last gap ends where the line does, not before
  const double length = length_of(line);
  const double factor = length > 0 ? kNoRest * length_of(dense) / length : 1;
  for (double& one : dashes) one *= factor;
  return dashes_of(dense, dashes);
}

std::vector<std::vector<Vec2>> disc_of(Vec2 middle, double diameter, double pen) {
  constexpr double kOverlap = 0.9, kThinnest = 0.05, kMostCircles = 200, kMostPoints = 1000;
  pen = std::max(pen, kThinnest);
  const double outer = 0.5 * (diameter - pen),
               step = std::max(kOverlap * pen, outer / kMostCircles);
  std::vector<std::vector<Vec2>> circles;
  double r = outer;
  for (; r > 0.05 * pen; r -= step) {
    const double turn = std::acos(std::max(1 - kThinned / r, 0.5));
    const auto n = static_cast<int>(std::clamp(std::numbers::pi / turn, 8.0, kMostPoints));
    std::vector<Vec2>& circle = circles.emplace_back();
    for (int i = 0; i < n; ++i) {
      const double a = 2 * std::numbers::pi * i / n;
      circle.push_back(middle + r * Vec2(std::cos(a), std::sin(a)));
    }
  }
  if (!circles.empty() && r + step > 0.5 * pen) circles.push_back({middle, middle});
  return circles;
}

}  // namespace burin
