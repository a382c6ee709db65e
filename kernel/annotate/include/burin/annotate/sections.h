#pragma once
/// What is laid over a sheet where a view shows a section: the line of the cut in the view that
/// sees it from its edge, with arrows and letters, and the name over the section.

#include <burin/annotate/options.h>
#include <burin/base/box.h>
#include <burin/drawing/drawing.h>

#include <span>
#include <string>
#include <vector>

namespace burin {

/// Where a section cuts, in the view that sees it from its edge.
struct SectionMark {
  /// Paper mm: from beyond one side of what the view shows to beyond the other, with a corner where
  /// a step ends.
  std::vector<Vec2> course;
  /// Unit: the way that the section is looked at.
  Vec2 sight{0};
  /// "A".
  std::string letter;
};

/// The lines of a mark and the boxes of its letters, for what is laid out before them.
std::vector<std::vector<Vec2>> lines_of(const SectionMark& mark, const CalloutOptions& style);

/// The name over a section.
struct SectionName {
  /// Paper mm: the box of what is drawn of it.
  Box2 drawn;
  std::string letter;
};

/// Paper mm that the line of a cut goes beyond what a view shows, and that a letter needs from
/// there on.
struct SectionReach {
  double beyond = 0, along = 0;
};
SectionReach section_reach(const CalloutOptions& style);

/// Paper mm above a section that its name needs.
double section_caption(const CalloutOptions& style);

/// Lays the layers "section-plane" (the line, dash and dot) and "section-marks" (its wide ends and
/// corners, arrows, letters, and the names over sections) over a sheet. A centre line under the
/// line of a cut goes. @cite ISO128
void lay_sections(Drawing& sheet, std::span<const SectionMark> marks,
                  std::span<const SectionName> names, const CalloutOptions& style);

}  // namespace burin
