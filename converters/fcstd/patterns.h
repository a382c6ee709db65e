#pragma once
// Patterns of PartDesign, as far as they repeat threads; internal to the module.

#include <burin/base/placement.h>

#include "xml.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace burin::detail {

class FcDocument;

/// What a LinearPattern, PolarPattern, Mirrored or MultiTransform of PartDesign says, lengths in
/// mm.
struct FcPattern {
  enum class Kind : std::uint8_t { Linear, Polar, Mirrored, Multi };
  Kind kind = Kind::Linear;
  /// The features that it repeats; `whole`: all that the body is before it.
  std::vector<std::string> originals = {};
  bool whole = false;
  /// The way, the axis or the plane: an object, and what of it.
  std::string reference = {}, sub = {};
  /// From the first to the last, mm or degrees; or, where `spaced`, from each to the next (`step`).
  double extent = 0, step = 0;
  bool spaced = false, reversed = false;
  std::int64_t occurrences = 1;
  /// Of a MultiTransform: the patterns that it does one after the other.
  std::vector<std::string> transformations = {};

  /// Of objects of these types.
  static std::optional<FcPattern> of_type(std::string_view type);
  /// Takes what a property says.
  void take(std::string_view name, const pugi::xml_node& value);
};

/// Where the copies of a pattern are, in the frame of its body, the original first; nothing where
/// it refers to an edge or a face, whose place only FreeCAD knows. At most 10,000.
std::optional<std::vector<Placement>> copies_of(const FcDocument& document,
                                                const FcPattern& pattern);

}  // namespace burin::detail
