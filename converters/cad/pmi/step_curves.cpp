// Curves of annotations as points, and outlines of their triangles.

#include "step_presentation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>
#include <utility>

namespace burin {
namespace {

// Curves made of curves.
constexpr int kDeepestCurve = 8;
// Degrees of an arc between its points: a letter's bow a millimetre large is off by a micrometre.
constexpr double kArcStep = 5;

/// A circle or an ellipse.
struct Round {
  StepAxes axes;
  double a = 0, b = 0;

  Vec3 at(double angle) const {
    return axes.origin + a * std::cos(angle) * axes.x + b * std::sin(angle) * axes.y;
  }
  double angle_of(const Vec3& p) const {
    const Vec3 d = p - axes.origin;
    return std::atan2(glm::dot(d, axes.y) / b, glm::dot(d, axes.x) / a);
  }
};

std::optional<Round> round_of(const StepText& text, std::int64_t number) {
  const StepEntity entity = text.entity(number);
  const StepRecord* record = entity.as_one_of({"CIRCLE", "ELLIPSE"});
  if (record == nullptr) return std::nullopt;
  Round round{axes_of(text, record->at(1).entity), record->at(2).as_number()};
  round.b = record->type == "CIRCLE" ? round.a : record->at(3).as_number();
  if (!(round.a > 0 && round.b > 0)) return std::nullopt;
  return round;
}

PmiLine arc(const Round& round, double from, double to) {
  const double sweep = to - from;
  const auto steps =
      static_cast<int>(std::ceil(std::abs(sweep) * 180 / std::numbers::pi / kArcStep));
  PmiLine line;
  for (int i = 0; i <= std::max(steps, 1); ++i) {
    line.points.push_back(round.at(from + sweep * i / std::max(steps, 1)));
  }
  return line;
}

/// Where a trimmed curve begins or ends: one of the two ways in which it says so.
std::optional<Vec3> trim_point(const StepText& text, const StepValue& trim) {
  for (const std::int64_t number : trim.references()) {
    if (auto point = point_of(text, number)) return point;
  }
  return std::nullopt;
}

std::optional<PmiLine> trimmed(const StepText& text, const StepRecord& record) {
  const auto from = trim_point(text, record.at(2)), to = trim_point(text, record.at(3));
  if (!from || !to) return std::nullopt;
  const bool forward = record.at(4).text != "F";
  const auto round = round_of(text, record.at(1).entity);
  if (!round) {
    const StepEntity basis = text.entity(record.at(1).entity);
    if (basis.as("LINE") == nullptr) return std::nullopt;
    return PmiLine{{*from, *to}};
  }
  constexpr double kTurn = 2 * std::numbers::pi;
  double begin = round->angle_of(*from), end = round->angle_of(*to);
  if (forward && end <= begin) end += kTurn;
  if (!forward && end >= begin) end -= kTurn;
  return arc(*round, begin, end);
}

std::optional<PmiLine> curve_at(const StepText& text, std::int64_t number, int depth);

std::optional<PmiLine> composite(const StepText& text, const StepRecord& record, int depth) {
  PmiLine line;
  for (const std::int64_t number : record.at(1).references()) {
    const StepEntity entity = text.entity(number);
    const StepRecord* segment = entity.as("COMPOSITE_CURVE_SEGMENT");
    if (segment == nullptr) return std::nullopt;
    auto piece = curve_at(text, segment->at(2).entity, depth + 1);
    if (!piece) return std::nullopt;
    if (segment->at(1).text == "F") std::ranges::reverse(piece->points);
    line.points.insert(line.points.end(), piece->points.begin(), piece->points.end());
  }
  return line;
}

std::optional<PmiLine> curve_at(const StepText& text, std::int64_t number, int depth) {
  const StepEntity entity = text.entity(number);
  if (depth > kDeepestCurve) return std::nullopt;
  if (const StepRecord* record = entity.as("POLYLINE")) {
    PmiLine line;
    for (const std::int64_t one : record->at(1).references()) {
      if (const auto point = point_of(text, one)) line.points.push_back(*point);
    }
    line.closed = line.points.size() > 3 && line.points.front() == line.points.back();
    if (line.closed) line.points.pop_back();
    return line;
  }
  if (const StepRecord* record = entity.as("TRIMMED_CURVE")) return trimmed(text, *record);
  if (const StepRecord* record = entity.as("COMPOSITE_CURVE")) {
    return composite(text, *record, depth);
  }
  if (const auto round = round_of(text, number)) {
    PmiLine line = arc(*round, 0, 2 * std::numbers::pi);
    line.points.pop_back();
    line.closed = true;
    return line;
  }
  return std::nullopt;
}

}  // namespace

std::optional<PmiLine> polyline_of(const StepText& text, std::int64_t curve) {
  return curve_at(text, curve, 0);
}

std::vector<PmiLine> outlines_of(const std::vector<std::array<Vec3, 3>>& triangles) {
  if (triangles.empty()) return {};
  using Place = std::tuple<double, double, double>;
  const auto place = [](const Vec3& p) { return Place(p.x, p.y, p.z); };
  const auto normal = [](const std::array<Vec3, 3>& t) {
    return glm::cross(t[1] - t[0], t[2] - t[0]);
  };
  // All turn as the largest does.
  const auto& largest = *std::ranges::max_element(
      triangles, {}, [&](const auto& t) { return glm::length(normal(t)); });
  std::map<std::pair<Place, Place>, int> edges;
  for (auto t : triangles) {
    if (glm::dot(normal(t), normal(largest)) < 0) std::swap(t[1], t[2]);
    for (std::size_t i = 0; i < 3; ++i) {
      const Place a = place(t[i]), b = place(t[(i + 1) % 3]);
      if (const auto other = edges.find({b, a}); other != edges.end()) {
        if (--other->second == 0) edges.erase(other);
      } else {
        ++edges[{a, b}];
      }
    }
  }
  std::vector<PmiLine> outlines;
  while (!edges.empty()) {
    PmiLine line{{}, true};
    const Place first = edges.begin()->first.first;
    Place at = first;
    do {  // from each corner some edge goes on: as many begin there as end
      const auto next = edges.lower_bound({at, Place(-INFINITY, -INFINITY, -INFINITY)});
      if (next == edges.end() || next->first.first != at) break;
      line.points.emplace_back(std::get<0>(at), std::get<1>(at), std::get<2>(at));
      at = next->first.second;
      if (--next->second == 0) edges.erase(next);
    } while (at != first);
    if (line.points.size() > 2) outlines.push_back(std::move(line));
  }
  return outlines;
}

}  // namespace burin
