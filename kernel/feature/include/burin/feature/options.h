#pragma once
/// What a user chooses of feature lines.

#include <burin/options/row.h>

#include <cstddef>
#include <vector>

namespace burin {

struct FeatureOptions {
  bool contours = true;
  bool creases = true;
  bool boundaries = true;
  /// Curves in which parts, or components of one part, pass through each other.
  bool intersections = true;
  /// Of proxies that know the edges of their input: those over which the surface goes on smoothly,
  /// and those where a face meets itself.
  bool smooth = true;
  bool seams = false;
  /// Lines of equal light, so many from the dark to the light: `extract_features`, which knows no
  /// light, does not look at it (burin/feature/isophotes.h).
  std::size_t isophotes = 0;
  /// The lines on which parts of exploded views have come: `extract_features` does not look at it.
  bool trails = true;
  /// Of faces of revolution (burin/centre_lines/centre_lines.h): `extract_features` does not look
  /// at it.
  bool centre_lines = false;
  /// Lines of threads that parts are known to have (burin/threads/thread_lines.h):
  /// `extract_features` does not look at it.
  bool threads = true;
  /// Degrees between neighbouring triangles from which an edge is sharp: forms that have no edges
  /// of their own take it (RealiseOptions), `extract_features` does not look at it.
  double crease_angle = 30;

  bool operator==(const FeatureOptions&) const = default;
};
/// Names without a group: "contours" ...
const std::vector<OptionRow<FeatureOptions>>& feature_option_rows();

}  // namespace burin
