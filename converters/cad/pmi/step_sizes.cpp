// Dimensions: sizes, their deviations, and how they are written.

#include "step_semantics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace burin {
namespace {

// Representations in each other.
constexpr int kDeepestSize = 4;

/// The sign before a size.
std::string sign_before(std::string_view what) {
  const bool spherical = what.find("spherical") != std::string_view::npos;
  if (what.ends_with("diameter")) return spherical ? "S⌀ " : "⌀ ";
  if (what.ends_with("radius")) return spherical ? "SR " : "R ";
  return {};
}

std::string degrees(const PmiItem& item) { return item.unit == "deg" ? "°" : ""; }

std::string deviations(const PmiItem& item, const SizeDecimals& decimals) {
  const auto text = [&](double value, std::optional<int> places) {
    return number_text(std::abs(value), places) + degrees(item);
  };
  const double upper = *item.upper, lower = *item.lower;
  if (upper == -lower && upper > 0) return " ±" + text(upper, decimals.upper);
  return fmt::format(" {}{}/{}{}", upper < 0 ? '-' : '+', text(upper, decimals.upper),
                     lower > 0 ? '+' : '-', text(lower, decimals.lower));
}

std::string limits(const PmiItem& item, const SizeDecimals& decimals) {
  return number_text(*item.least, decimals.lower) + degrees(item) + " to " +
         number_text(*item.most, decimals.upper) + degrees(item);
}

std::string size_text(const PmiItem& item, const SizeDecimals& decimals) {
  std::string text = sign_before(item.what);
  if (text.empty() && !item.what.empty()) text = item.what + " ";
  if (!item.value && item.least && item.most) {
    text += limits(item, decimals);
  } else if (item.value || item.most || item.least) {
    const double size = item.value ? *item.value : item.most ? *item.most : *item.least;
    text += number_text(size, decimals.value) + degrees(item);
    if (!item.value) text += item.most ? " max" : " min";
  } else {
    text += "without a value";
  }
  if (item.value && item.least && item.most) text += " (" + limits(item, decimals) + ")";
  if (!item.fit.empty()) text += " " + item.fit;
  if (item.upper && item.lower) text += deviations(item, decimals);
  if (item.unit != "mm" && item.unit != "deg" && !item.unit.empty()) text += " " + item.unit;
  for (const std::string& modifier : item.modifiers) text += " (" + modifier + ")";
  return text;
}

/// What a number of a representation says of a size.
void take_measure(const StepMeasure& measure, PmiItem& item, SizeDecimals& decimals) {
  if (measure.name.find("upper limit") != std::string::npos) {
    item.most = measure.value;
    decimals.upper = measure.decimals;
  } else if (measure.name.find("lower limit") != std::string::npos) {
    item.least = measure.value;
    decimals.lower = measure.decimals;
  } else {
    item.value = measure.value;
    decimals.value = measure.decimals;
  }
  item.unit = measure.unit;
  for (const std::string& qualifier : measure.qualifiers) item.modifiers.push_back(qualifier);
}

}  // namespace

void StepSemantics::read_size(std::int64_t representation, int depth, PmiItem& item,
                              SizeDecimals& decimals) const {
  const StepEntity entity = text_.entity(representation);
  if (const auto measure = measure_of(text_, representation)) {
    return take_measure(*measure, item, decimals);
  }
  if (const StepRecord* said = entity.as("DESCRIPTIVE_REPRESENTATION_ITEM")) {
    if (!said->at(1).text.empty()) item.modifiers.push_back(said->at(1).text);
    return;
  }
  const StepRecord* group = entity.as_one_of({"SHAPE_DIMENSION_REPRESENTATION", "REPRESENTATION",
                                              "COMPOUND_REPRESENTATION_ITEM", "VALUE_RANGE"});
  if (group == nullptr || depth > kDeepestSize) return;
  // Of a representation of several types the one that has the items has parameters.
  const StepRecord* of = entity.as("REPRESENTATION");
  const StepRecord& items = of != nullptr ? *of : *group;
  const std::size_t place = items.values.size() == 1 ? 0 : 1;
  for (const std::int64_t one : items.at(place).references()) {
    read_size(one, depth + 1, item, decimals);
  }
}

void StepSemantics::read_deviations(std::int64_t dimension, PmiItem& item,
                                    SizeDecimals& decimals) const {
  const auto found = ranges_.find(dimension);
  if (found == ranges_.end()) return;
  for (const std::int64_t number : found->second) {
    const StepEntity entity = text_.entity(number);
    if (const StepRecord* range = entity.as("TOLERANCE_VALUE")) {
      const auto lower = measure_of(text_, range->at(0).entity);
      const auto upper = measure_of(text_, range->at(1).entity);
      if (lower) item.lower = lower->value, decimals.lower = lower->decimals;
      if (upper) item.upper = upper->value, decimals.upper = upper->decimals;
    } else if (const StepRecord* fit = entity.as("LIMITS_AND_FITS")) {
      item.fit = fit->at(0).text + fit->at(2).text;
    }
  }
}

StepPmiItem StepSemantics::dimension(std::int64_t number, const StepRecord& record) const {
  StepPmiItem out{.entity = number};
  out.item.kind = PmiKind::Dimension;
  // A size has its aspect before its name, a location two behind it.
  const bool size = record.at(0).kind == StepValue::Kind::Reference;
  out.item.what = record.at(size ? 1 : 0).text;
  const bool angular = record.type.starts_with("ANGULAR");
  if (out.item.what.empty()) out.item.what = angular ? "angle" : "linear distance";
  SizeDecimals decimals;
  if (const auto found = sizes_.find(number); found != sizes_.end()) {
    for (const std::int64_t one : found->second) read_size(one, 0, out.item, decimals);
  }
  read_deviations(number, out.item, decimals);
  out.item.text = size_text(out.item, decimals);
  for (const std::size_t place :
       size ? std::vector<std::size_t>{0} : std::vector<std::size_t>{2, 3}) {
    const std::int64_t aspect = record.at(place).entity;
    for (const std::int64_t face : aspects_.faces_of(aspect)) out.faces.push_back(face);
    if (out.product == 0) out.product = aspects_.product_of(aspect);
  }
  make_set(out.faces);
  return out;
}

}  // namespace burin
