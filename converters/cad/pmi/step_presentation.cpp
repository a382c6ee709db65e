#include "step_presentation.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

// Callouts in callouts, sets in sets.
constexpr int kDeepestSet = 12;

std::optional<Vec3> direction_of(const StepText& text, std::int64_t number) {
  const StepEntity entity = text.entity(number);
  const StepRecord* record = entity.as("DIRECTION");
  if (record == nullptr || record->at(1).items.size() != 3) return std::nullopt;
  const auto& ratios = record->at(1).items;
  const Vec3 d(ratios[0].as_number(), ratios[1].as_number(), ratios[2].as_number());
  const double length = glm::length(d);
  if (!std::isfinite(length) || length <= 0) return std::nullopt;
  return d / length;
}

/// The points of a strip or a fan of triangles, or of a line: places in a list of points from 1.
std::vector<std::size_t> places_of(const StepValue& list, std::size_t count) {
  std::vector<std::size_t> places;
  for (const StepValue& item : list.items) {
    const double place = item.as_number();
    if (place >= 1 && place <= static_cast<double>(count)) {
      places.push_back(static_cast<std::size_t>(place) - 1);
    }
  }
  return places;
}

using Triangles = std::vector<std::array<Vec3, 3>>;

void add_triangle(const std::vector<Vec3>& points, std::size_t a, std::size_t b, std::size_t c,
                  Triangles& all) {
  const Vec3 &p = points[a], &q = points[b], &r = points[c];
  if (p == q || q == r || r == p) return;
  all.push_back({p, q, r});
}

}  // namespace

std::optional<Vec3> point_of(const StepText& text, std::int64_t number) {
  const StepEntity entity = text.entity(number);
  const StepRecord* record = entity.as("CARTESIAN_POINT");
  if (record == nullptr || record->at(1).items.size() != 3) return std::nullopt;
  const auto& at = record->at(1).items;
  const Vec3 p(at[0].as_number(), at[1].as_number(), at[2].as_number());
  if (!std::isfinite(p.x + p.y + p.z)) return std::nullopt;
  return p;
}

StepAxes axes_of(const StepText& text, std::int64_t number) {
  StepAxes axes;
  const StepEntity entity = text.entity(number);
  const StepRecord* record = entity.as("AXIS2_PLACEMENT_3D");
  if (record == nullptr) return axes;
  axes.origin = point_of(text, record->at(1).entity).value_or(Vec3(0));
  axes.z = direction_of(text, record->at(2).entity).value_or(axes.z);
  // What is along z says nothing.
  constexpr double kAlong = 1e-6;
  const auto across = [&](const Vec3& d) { return d - glm::dot(d, axes.z) * axes.z; };
  Vec3 x = across(direction_of(text, record->at(3).entity).value_or(Vec3(1, 0, 0)));
  if (glm::length(x) < kAlong) x = across(Vec3(0, 1, 0));
  axes.x = glm::normalize(x);
  axes.y = glm::cross(axes.z, axes.x);
  return axes;
}

StepShown StepPresentation::of(std::int64_t callout) {
  StepShown shown;
  visit(callout, 0, {}, shown);
  return shown;
}

void StepPresentation::visit(std::int64_t number, int depth, const StepAxes& place,
                             StepShown& shown) {
  const StepEntity entity = text_.entity(number);
  if (entity.records.empty() || depth > kDeepestSet) return;
  const auto visit_all = [&](const StepValue& value, const StepAxes& at) {
    for (const std::int64_t one : value.references()) visit(one, depth + 1, at, shown);
  };
  // Placeholders of text that another program fills in, and terminators that lines have beside
  // them.
  if (entity.as("ANNOTATION_PLACEHOLDER_OCCURRENCE") != nullptr) return;
  if (const StepRecord* callout =
          entity.as_one_of({"DRAUGHTING_CALLOUT", "LEADER_DIRECTED_CALLOUT", "ANNOTATION_FILL_AREA",
                            "GEOMETRIC_CURVE_SET", "GEOMETRIC_SET"})) {
    return visit_all(callout->at(callout->values.size() - 1), place);
  }
  if (const StepRecord* styled =
          entity.as_one_of({"TESSELLATED_ANNOTATION_OCCURRENCE", "ANNOTATION_CURVE_OCCURRENCE",
                            "STYLED_ITEM", "ANNOTATION_OCCURRENCE"})) {
    return visit_all(styled->at(styled->values.size() - 1), place);
  }
  if (const StepRecord* fill = entity.as("ANNOTATION_FILL_AREA_OCCURRENCE")) {
    StepShown outlines;
    for (const std::int64_t one : fill->at(2).references()) {
      visit(one, depth + 1, place, outlines);
    }
    for (PmiLine& line : outlines.lines) {
      line.closed = true;
      shown.filled.push_back(std::move(line));
    }
    return;
  }
  if (const StepRecord* set = entity.as("TESSELLATED_GEOMETRIC_SET")) {
    const StepRecord* moved = entity.as("REPOSITIONED_TESSELLATED_ITEM");
    if (moved == nullptr) return visit_all(set->at(set->values.size() - 1), place);
    const StepAxes at = axes_of(text_, moved->at(moved->values.size() - 1).entity);
    if (!shown.plane) shown.plane = at;
    return visit_all(set->at(set->values.size() - 1), at);
  }
  if (const StepRecord* curves = entity.as("TESSELLATED_CURVE_SET")) {
    return curve_set(*curves, place, shown);
  }
  if (const StepRecord* faces =
          entity.as_one_of({"COMPLEX_TRIANGULATED_SURFACE_SET", "TRIANGULATED_SURFACE_SET",
                            "COMPLEX_TRIANGULATED_FACE", "TRIANGULATED_FACE"})) {
    return triangles(*faces, place, shown);
  }
  if (auto line = polyline_of(text_, number)) {
    if (line->points.size() > 1) shown.lines.push_back(*std::move(line));
    return;
  }
  ++unknown_[std::string(entity.records.front().type)];
}

std::vector<Vec3> StepPresentation::coordinates(std::int64_t number, const StepAxes& place) const {
  std::vector<Vec3> points;
  const StepEntity entity = text_.entity(number);
  const StepRecord* record = entity.as("COORDINATES_LIST");
  if (record == nullptr) return points;
  const StepValue& list = record->at(record->values.size() - 1);
  points.reserve(list.items.size());
  for (const StepValue& item : list.items) {
    Vec3 p(0);
    for (std::size_t i = 0; i < std::min<std::size_t>(item.items.size(), 3); ++i) {
      p[static_cast<int>(i)] = item.items[i].as_number();
    }
    points.push_back(place.point(p));
  }
  return points;
}

void StepPresentation::curve_set(const StepRecord& record, const StepAxes& place,
                                 StepShown& shown) const {
  const std::vector<Vec3> points = coordinates(record.at(1).entity, place);
  for (const StepValue& strip : record.at(2).items) {
    PmiLine line;
    for (const std::size_t at : places_of(strip, points.size())) {
      if (line.points.empty() || line.points.back() != points[at]) {
        line.points.push_back(points[at]);
      }
    }
    line.closed = line.points.size() > 3 && line.points.front() == line.points.back();
    if (line.closed) line.points.pop_back();
    if (line.points.size() > 1) shown.lines.push_back(std::move(line));
  }
}

void StepPresentation::triangles(const StepRecord& record, const StepAxes& place,
                                 StepShown& shown) const {
  const bool face = record.type.ends_with("_FACE");
  const bool strips = record.type.starts_with("COMPLEX_");
  std::vector<Vec3> points = coordinates(record.at(1).entity, place);
  // A face has the surface that it stands for before the places of its points.
  std::size_t next = face ? 5 : 4;
  if (const StepValue& used = record.at(next); !used.items.empty()) {
    std::vector<Vec3> some;
    for (const std::size_t at : places_of(used, points.size())) some.push_back(points[at]);
    points = std::move(some);
  }
  ++next;
  Triangles all;
  for (const StepValue& one : record.at(next).items) {  // triangles, or strips of them
    const std::vector<std::size_t> at = places_of(one, points.size());
    for (std::size_t i = 2; i < at.size(); ++i) {
      const bool turned = strips && i % 2 == 1;
      add_triangle(points, at[i - 2], at[turned ? i : i - 1], at[turned ? i - 1 : i], all);
    }
  }
  if (strips) {
    for (const StepValue& fan : record.at(next + 1).items) {
      const std::vector<std::size_t> at = places_of(fan, points.size());
      for (std::size_t i = 2; i < at.size(); ++i) {
        add_triangle(points, at[0], at[i - 1], at[i], all);
      }
    }
  }
  std::ranges::move(outlines_of(all), std::back_inserter(shown.filled));
}

}  // namespace burin
