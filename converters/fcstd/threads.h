#pragma once
// The threads of holes of PartDesign, which have no shape; internal to the module.

#include <burin/surface/thread.h>

#include "xml.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace burin::detail {

class FcDocument;
struct FcObject;

/// What a PartDesign::Hole says of its thread, lengths in mm.
struct FcHole {
  bool threaded = false, modelled = false, reversed = false;
  /// As FreeCAD counts them: 1 is ISOMetricProfile; a size of that type.
  std::int64_t type = 0, size = 0;
  /// Of the drill.
  double diameter = 0;
  /// DepthType: 0 is `depth`, 1 through all.
  std::int64_t depth_type = 0;
  double depth = 0;
  /// Absent in documents of before 0.20: as deep as the hole.
  std::optional<double> thread_depth = {};
  /// The sketch whose circles are the holes.
  std::string profile = {};

  /// Takes what a property says.
  void take(std::string_view name, const pugi::xml_node& value);
};

/// The centres of the circles of a list of geometry that are no construction lines.
std::vector<Vec3> circle_centers(const pugi::xml_node& geometry);

/// Holes and patterns whose threads are not drawn, by their labels.
struct LostThreads {
  /// Of a size that is not known; repeated along an edge or a face of the shape.
  std::vector<std::string> sizes = {}, patterns = {};
};

/// The threads of the holes of a body, up to its tip, and of their copies in patterns, in its own
/// frame; no faces are known.
std::vector<Thread> threads_of(const FcDocument& document, const FcObject& body, LostThreads& lost);

}  // namespace burin::detail
