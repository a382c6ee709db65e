#pragma once
/// What two drawings differ by, line by line and colour by colour.

#include <burin/base/run_context.h>
#include <burin/drawing/drawing.h>
#include <burin/revisions/overlay.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace burin {

enum class LineChange { New, Gone, Moved, Same };
inline constexpr std::size_t kLineChanges = 4;

/// "new", "gone", "moved", "same".
const char* to_string(LineChange change);

/// A path that is not the same: of the new drawing; of the old one where it is gone.
struct ChangedLine {
  LineChange change = LineChange::New;
  std::string layer, part;
  LineClass kind = LineClass::Contour;
  /// Its place in the drawing that it is of.
  std::size_t layer_index = 0, path_index = 0;
  /// Paper mm of it that lie on no line of the other drawing.
  double length = 0;
  /// Moved: the largest distance of its points from where it was, paper mm.
  double distance = 0;
};

/// The tint of a spot ink that a place is printed in; of no name: no ink.
struct InkTint {
  std::string ink = {};
  double tint = 1;
  auto operator<=>(const InkTint&) const = default;
};

/// A spot ink that is not the same; a colour is empty in the drawing that has no such ink.
struct ChangedInk {
  std::string name, before, after;
};

/// What the flat colours of a part have become.
struct ChangedFill {
  /// Of the new drawing where that paints a part there, else of the old one; empty: a shadow.
  std::string part;
  /// "#rrggbb" as seen, mixed with what lies beneath; empty: nothing is painted.
  std::string before, after;
  /// What that is printed in.
  InkTint ink_before, ink_after;
  /// Paper mm^2, and a place in them.
  double size = 0;
  Vec2 at{0};
};

struct LineDifference {
  std::vector<ChangedLine> lines;
  /// By part, then the largest first.
  std::vector<ChangedFill> fills;
  /// By name.
  std::vector<ChangedInk> inks;
  /// Paths, and paper mm, by `LineChange`.
  std::array<std::size_t, kLineChanges> counts{};
  std::array<double, kLineChanges> lengths{};
  /// Texts that are in one drawing alone, by their letters and places.
  std::vector<Text> texts_new, texts_gone;
  /// Whether both have one sheet.
  bool same_sheet = true;
  double tolerance = 0;

  bool same() const {
    return lines.empty() && fills.empty() && inks.empty() && texts_new.empty() &&
           texts_gone.empty() && same_sheet;
  }
};

/// Compares the visible lines of two drawings, features with features and strokes with strokes. A
/// path is the same where all of it lies within `tolerance` paper mm of lines of the other drawing,
/// but for stretches of less than twice that; it has moved where a path of the same part, kind,
/// face and edge, and about the same length, is gone within 20 mm of it. Widths and the order of
/// layers do not count. Flat colours are compared every 0.5 mm, farther than `tolerance` from where
/// one of the drawings changes its colour; a place in another tint of a spot ink, or in another
/// one, has changed, too. Throws Cancelled. Cost: 0.2 us a question, two of which a tolerance of
/// line.
LineDifference compare_drawings(const Drawing& before, const Drawing& after, double tolerance,
                                const RunContext& context);

/// The new drawing light, with lines that are new in layers "new-", what is gone (or was elsewhere)
/// in "gone-", moved lines in "moved-to-", the areas of parts whose colours are others in these and
/// with borders in "look-fills", and "legend", for which the sheet gets higher where the
/// drawings leave no room below. Looks as those of the other `overlay`.
Drawing overlay(const RevisionDrawings& drawings, const LineDifference& difference,
                const OverlayOptions& options, const RunContext& context);

}  // namespace burin
