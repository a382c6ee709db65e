#pragma once
/// Several views of a scene on one sheet, and details of them at another scale.

#include <burin/annotate/details.h>
#include <burin/annotate/sections.h>
#include <burin/drawing/paper_breaks.h>
#include <burin/illustrate/illustrate.h>
#include <burin/illustrate/session.h>
#include <burin/surface/scene.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace burin {

/// A view that stands on a sheet beside others.
struct PlacedView {
  std::string name;
  /// Its paper is the sheet.
  Camera camera;
  /// Paper mm: the part of the sheet that is its own.
  Box2 box;
  /// Lines outside are left out: a detail.
  std::optional<Disc> within = {};
  /// How many times as large as the view whose detail it is.
  double magnified = 1;
  /// Parts that a detail is there for: that none of them is seen is told.
  std::vector<std::size_t> shows = {};
  /// Whether callouts stand about it, in its box.
  bool callouts = false;
  /// The parts as this view alone shows them, cut open; null: as all show them.
  std::shared_ptr<const Scene> scene = {};
  ViewDimensions dimensions = {};
  /// Whether hidden lines are left out, whatever the drawing says.
  bool none_hidden = false;
  /// What is left out of it, from where the camera has it to the sheet.
  PaperBreaks breaks = {};

  /// Where a point of the model is on the sheet.
  Vec2 at(Vec3 p) const { return breaks.moved(camera.to_paper(p)); }
};

struct SheetOfViews {
  /// The first is that of programs that know of one.
  std::vector<PlacedView> views;
  /// Circles and letters of those of them that are details.
  std::vector<DetailMark> details = {};
  /// Where sections that have views of their own cut, and the names of these.
  std::vector<SectionMark> section_marks = {};
  std::vector<SectionName> section_names = {};
  /// How views stand about the front view; where the bottom left corner of its symbol is, unless
  /// the title block has it.
  std::optional<ProjectionMethod> method = {};
  std::optional<Vec2> symbol_at = {};

  /// One view that has the sheet for itself.
  bool plain() const { return views.size() == 1 && details.empty() && !method; }
  const Camera& camera() const { return views.front().camera; }
};

/// Draws each view as `illustrate` does and puts them together; what several of them would tell is
/// told once. A view that is alone is drawn as `illustrate` draws it. `session`, if any, is used
/// from view to view and kept for the next sheet. Throws as `illustrate`.
Drawing illustrate(const Scene& scene, const SheetOfViews& sheet, const Style& style,
                   const IllustrateOptions& options, RunContext& context,
                   Session* session = nullptr);

}  // namespace burin
