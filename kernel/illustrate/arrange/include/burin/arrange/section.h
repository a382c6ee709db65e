#pragma once
/// What is taken away so that parts are cut open.

#include <burin/base/vec.h>

#include <optional>
#include <string>
#include <vector>

namespace burin {

/// A plane across an axis.
struct SectionPlane {
  Vec3 axis{0, 0, 1};  // unit
  /// What lies beyond it on this side of the axis goes, 1 or -1; 0: the side of the viewer.
  int side = 0;
  /// Model mm along the axis; absent: the middle of what is drawn.
  std::optional<double> offset = {};
};

struct Section {
  /// From the viewer down to the depth of a place, as wide as a circle in the view.
  struct Around {
    Vec3 center{0};
    double radius = 0;  // model mm
  };
  /// What lies beyond all of them goes.
  std::vector<SectionPlane> planes = {};
  /// Instead, the planes are steps: a cut, where it ends, the next cut, ...
  bool steps = false;
  /// Instead of planes.
  std::optional<Around> around = {};
  /// Selectors of parts that stay whole; absent: those that drawings leave whole by custom.
  std::optional<std::vector<std::string>> exclude = {};
  /// It cuts a view of its own alone, which stands on the sheet beside the others: by one plane or
  /// in steps.
  bool own_view = false;
  /// Of that view: "A" for "A-A"; empty: the next of A, B, C ...
  std::string letter = {};
  /// What errors begin with: "FILE:LINE: ", or empty.
  std::string place = {};
};

}  // namespace burin
