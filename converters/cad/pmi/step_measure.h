#pragma once
/// Numbers with their units in a STEP file.

#include "step_text.h"

#include <cstdint>
#include <optional>
#include <string>

namespace burin {

/// A unit of length or angle.
struct StepUnit {
  enum class Kind { Length, Angle, Other };
  Kind kind = Kind::Other;
  /// mm or degrees that one of it is.
  double factor = 1;

  /// "mm", "in", "deg"; a length that has no short name is counted in mm.
  std::string name() const;
};
StepUnit unit_of(const StepText& text, std::int64_t number);

/// The unit of lengths in a context of representations; millimetres where it says none.
StepUnit length_unit_of_context(const StepText& text, std::int64_t context);

struct StepMeasure {
  /// In `unit`: lengths as the file has them, angles in degrees.
  double value = 0;
  std::string unit;
  /// What it is for, "nominal value"; empty: it does not say.
  std::string name = {};
  /// Places after the point that it is to be written with.
  std::optional<int> decimals = {};
  /// "maximum", "average".
  std::vector<std::string> qualifiers = {};
};

/// Absent where the entity is none.
std::optional<StepMeasure> measure_of(const StepText& text, std::int64_t number);

/// A number as drawings write it: with so many decimals, else the shortest of six digits.
std::string number_text(double value, std::optional<int> decimals);

}  // namespace burin
