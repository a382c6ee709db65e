#pragma once
/// Two revisions of a model in one drawing.

#include <burin/base/run_context.h>
#include <burin/diff/difference.h>
#include <burin/illustrate/sheet.h>

namespace burin {

/// The drawings of both revisions on one sheet.
struct RevisionDrawings {
  const Drawing& before;
  const Drawing& after;
};

struct OverlayOptions {
  /// Hidden lines are shown, dashed; both drawings have them either way, so that what is merely
  /// covered does not count as gone.
  bool hidden = false;
  /// Of the legend.
  CalloutOptions letters{};
  Margin margin{};
};

/// Paper mm that the legend needs above the lower margin of a sheet so wide between its margins.
double legend_height(const CalloutOptions& letters, double width);

/// What `before` lacks or has elsewhere, laid over `after`. Layers are called by what became of
/// their parts and by the layers of the drawings ("same-crease"): "same-" light, "changed-to-" in
/// full, with lines that it had not in "changed-new-" and those that it has no more in
/// "changed-from-", "moved-from-" and "moved-to-" with arrows in "moved-arrows", "added-",
/// "removed-", "renamed-", "look-"; areas are painted of parts of another look alone; "legend" says
/// how many there are of each. Colours come with dashes and widths, so that they may be missing.
/// Parts of `before` have the numbers behind those of `after`; `Drawing::items` has one entry a
/// part of the difference, in its order, from 1. Lines are one within 0.2 mm of paper. Throws
/// Cancelled. Cost: that of a look every 0.1 mm along the lines of changed parts.
Drawing overlay(const RevisionDrawings& drawings, const Difference& difference,
                const SheetOfViews& sheet, const OverlayOptions& options,
                const RunContext& context);

}  // namespace burin
