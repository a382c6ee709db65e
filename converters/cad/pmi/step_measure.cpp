#include "step_measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>

namespace burin {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;
// Units in units of each other: a definition of one by another has few steps.
constexpr int kDeepestUnit = 8;

double prefix_of(const StepValue& value) {
  constexpr std::array<std::pair<std::string_view, double>, 8> kPrefixes{{{"KILO", 1e3},
                                                                          {"HECTO", 1e2},
                                                                          {"DECA", 1e1},
                                                                          {"DECI", 1e-1},
                                                                          {"CENTI", 1e-2},
                                                                          {"MILLI", 1e-3},
                                                                          {"MICRO", 1e-6},
                                                                          {"NANO", 1e-9}}};
  for (const auto& [name, factor] : kPrefixes) {
    if (value.text == name) return factor;
  }
  return 1;
}

StepUnit unit_at(const StepText& text, std::int64_t number, int depth) {
  const StepEntity entity = text.entity(number);
  StepUnit unit;
  if (const StepRecord* si = entity.as("SI_UNIT")) {
    // By itself it has the dimensions before the prefix.
    const std::size_t first = si->values.size() == 3 ? 1 : 0;
    const std::string& name = si->at(first + 1).text;
    if (name == "METRE") unit = {StepUnit::Kind::Length, 1e3 * prefix_of(si->at(first))};
    if (name == "RADIAN") unit = {StepUnit::Kind::Angle, kDegrees * prefix_of(si->at(first))};
    return unit;
  }
  const StepRecord* other = entity.as("CONVERSION_BASED_UNIT");
  if (other == nullptr || depth > kDeepestUnit) return unit;
  const StepEntity one = text.entity(other->at(1).entity);
  const StepRecord* measure = one.as_one_of(
      {"MEASURE_WITH_UNIT", "LENGTH_MEASURE_WITH_UNIT", "PLANE_ANGLE_MEASURE_WITH_UNIT"});
  if (measure == nullptr) return unit;
  unit = unit_at(text, measure->at(1).entity, depth + 1);
  unit.factor *= measure->at(0).as_number();
  return unit;
}

/// What qualifiers say: "NR2 1.3" has three places after the point.
void read_qualifiers(const StepText& text, const StepRecord& record, StepMeasure& measure) {
  for (const std::int64_t number : record.at(record.values.size() - 1).references()) {
    const StepEntity entity = text.entity(number);
    if (const StepRecord* format = entity.as("VALUE_FORMAT_TYPE_QUALIFIER")) {
      const std::string& words = format->at(0).text;
      const std::size_t point = words.rfind('.');
      if (!words.starts_with("NR2") || point + 2 != words.size()) continue;
      measure.decimals = std::clamp(words.back() - '0', 0, 9);
    } else if (const StepRecord* type = entity.as("TYPE_QUALIFIER")) {
      measure.qualifiers.push_back(type->at(0).text);
    }
  }
}

}  // namespace

std::string StepUnit::name() const {
  if (kind == Kind::Angle) return "deg";
  if (kind == Kind::Other) return {};
  constexpr double kNear = 1e-9;
  constexpr std::array<std::pair<std::string_view, double>, 6> kNames{
      {{"mm", 1}, {"cm", 10}, {"m", 1000}, {"in", 25.4}, {"ft", 304.8}, {"um", 1e-3}}};
  for (const auto& [name, mm] : kNames) {
    if (std::abs(factor / mm - 1) < kNear) return std::string(name);
  }
  return "mm";
}

StepUnit unit_of(const StepText& text, std::int64_t number) { return unit_at(text, number, 0); }

StepUnit length_unit_of_context(const StepText& text, std::int64_t context) {
  const StepEntity entity = text.entity(context);
  if (const StepRecord* units = entity.as("GLOBAL_UNIT_ASSIGNED_CONTEXT")) {
    for (const std::int64_t number : units->at(units->values.size() - 1).references()) {
      const StepUnit unit = unit_of(text, number);
      if (unit.kind == StepUnit::Kind::Length && unit.factor > 0) return unit;
    }
  }
  return {StepUnit::Kind::Length, 1};
}

std::optional<StepMeasure> measure_of(const StepText& text, std::int64_t number) {
  const StepEntity entity = text.entity(number);
  const StepRecord* record =
      entity.as_one_of({"MEASURE_WITH_UNIT", "LENGTH_MEASURE_WITH_UNIT",
                        "PLANE_ANGLE_MEASURE_WITH_UNIT", "MEASURE_REPRESENTATION_ITEM"});
  if (record == nullptr) return std::nullopt;
  // By itself an item of a representation has its name before the number.
  const std::size_t first = record->values.size() == 3 ? 1 : 0;
  const StepUnit unit = unit_of(text, record->at(first + 1).entity);
  StepMeasure measure{record->at(first).as_number(), unit.name()};
  const bool counted = unit.kind == StepUnit::Kind::Length && measure.unit == "mm";
  if (unit.kind == StepUnit::Kind::Angle || counted) measure.value *= unit.factor;
  if (first == 1) measure.name = record->at(0).text;
  if (const StepRecord* item = entity.as("REPRESENTATION_ITEM")) measure.name = item->at(0).text;
  if (const StepRecord* qualified = entity.as("QUALIFIED_REPRESENTATION_ITEM")) {
    read_qualifiers(text, *qualified, measure);
  }
  return measure;
}

std::string number_text(double value, std::optional<int> decimals) {
  if (decimals) return fmt::format("{:.{}f}", value, *decimals);
  return fmt::format("{:.6g}", value + 0.0);
}

}  // namespace burin
