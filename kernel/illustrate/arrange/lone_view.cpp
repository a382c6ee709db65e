#include "lone_view.h"

#include <burin/annotate/annotate.h>
#include <burin/base/error.h>
#include <burin/illustrate/ground.h>

#include "broken_view.h"
#include "wanted_views.h"

#include <algorithm>
#include <utility>

namespace burin::detail {

Camera::ExtentFn extent_of(const Scene& scene, const Illustration& illustration,
                           const ViewOptions& view) {
  return extent_with_shadow(scene, illustration.style, illustration.illustrate.part_styles, view);
}

Margin sum(const Margin& a, const Margin& b) {
  return {a.top + b.top, a.right + b.right, a.bottom + b.bottom, a.left + b.left};
}

Camera::ExtentFn with_measured(Camera::ExtentFn drawn, const ViewDimensions& measured) {
  return [drawn = std::move(drawn), list = measured.list](const Mat3& axes) {
    Box3 box = drawn(axes);
    for (const Dimension& one : list) {
      if (one.overall) box.add(axes * one.from), box.add(axes * one.to);
    }
    return box;
  };
}

SheetView lone_view(const Scene& scene, const Illustration& illustration) {
  return {{axes_of(illustration.view), 0, illustration.style.feature.centre_lines,
           illustration.illustrate.hidden == HiddenLines::Dashed},
          name_of(illustration.view),
          0,
          BrokenAs(scene, illustration, illustration.view)};
}

namespace {

/// A perspective view knows one margin.
Margin margin_of(const Margin& m, const Illustration& illustration) {
  return illustration.view.perspective ? Margin(std::max({m.top, m.right, m.bottom, m.left})) : m;
}

/// The margin with the room that callouts and the parts list need.
SheetOptions sheet_with_tables(const Camera::ExtentFn& extent, const Illustration& illustration) {
  SheetOptions sheet = illustration.sheet;
  if (!illustration.illustrate.annotations) return sheet;
  const Annotations& over = *illustration.illustrate.annotations;
  const CalloutOptions& style = illustration.style.callout;
  if (!sheet.fits) {
    sheet.margin = annotation_margin(over, style, illustration.view.paper);
    return sheet;
  }
  // A sheet that fits grows until they have room; what has none then is told by the drawing.
  constexpr int kMostSteps = 200;
  constexpr double kStep = 5;  // paper mm
  for (int step = 0; step < kMostSteps; ++step) {
    const Paper paper = settle(extent, illustration.view, sheet).paper;
    if (annotations_fit(over, style, paper, sheet.margin)) break;
    const Margin needed = annotation_margin(over, style, paper);
    Margin& m = sheet.margin;
    const Margin more = larger(m, needed);
    const bool grows =
        more.top > m.top || more.right > m.right || more.bottom > m.bottom || more.left > m.left;
    m = grows ? more : Margin(m.top + kStep, m.right + kStep, m.bottom + kStep, m.left + kStep);
    m = margin_of(m, illustration);
  }
  return sheet;
}

/// And that which dimensions need.
SheetOptions sheet_with_room(const Camera::ExtentFn& extent, const Illustration& illustration,
                             const Margin& room) {
  SheetOptions sheet = sheet_with_tables(extent, illustration);
  sheet.margin = sum(sheet.margin, room);
  return sheet;
}

/// The camera of a view that has the sheet for itself and shows that. `room`: of dimensions.
Camera lone_camera(const Camera::ExtentFn& extent, const Illustration& illustration,
                   const Margin& room) {
  if (!illustration.illustrate.annotations || !illustration.view.perspective ||
      illustration.sheet.fits) {
    return Camera::fit(
        extent, settle(extent, illustration.view, sheet_with_room(extent, illustration, room)));
  }
  // A perspective view knows one margin: it is fitted to what is left of the sheet.
  ViewOptions view = settle(extent, illustration.view, illustration.sheet);
  const Paper sheet = view.paper;
  const Margin m = sum(
      annotation_margin(*illustration.illustrate.annotations, illustration.style.callout, sheet),
      room);
  view.paper = {sheet.width - m.left - m.right, sheet.height - m.bottom - m.top};
  view.margin = 0;
  return Camera::fit(extent, view).on_sheet(sheet, {m.left, m.bottom});
}

}  // namespace

SheetOfViews plan_lone_view(Scene& scene, const Illustration& illustration) {
  SheetOfViews sheet;
  SheetView alone = lone_view(scene, illustration);
  const BrokenAs broken = alone.broken;
  Margin room = broken.room();
  const SheetDimensions measured(scene, illustration, {std::move(alone)});
  ViewDimensions dimensions = measured.of_view(0, Margin(0));
  const Camera::ExtentFn extent = broken.shortened(
      with_measured(extent_of(scene, illustration, illustration.view), dimensions));
  const Box3 shown = extent(axes_of(illustration.view));
  Camera camera = lone_camera(extent, illustration, room);
  for (int round = 1; round < kMostRounds && !dimensions.list.empty(); ++round) {
    const double scale = camera.scale();
    const Margin needed = measured.room(0, broken.moved(dimensions, scale), shown, scale);
    if (holds(room, needed)) break;
    room = larger(room, needed);
    try {
      camera = lone_camera(extent, illustration, room);
    } catch (const UsageError&) {
      throw UsageError(
          "the sheet has no room for the view beside its notes, dimensions and lists: give a "
          "larger "
          "`paper`, shorter notes (\\n begins a line) or a smaller `dimension.height`");
    }
  }
  sheet.views.push_back({"", camera, {Vec2(0), {camera.paper().width, camera.paper().height}}});
  sheet.views.front().dimensions = std::move(dimensions);
  break_view(broken, illustration.view, sheet.views.front());
  return sheet;
}

}  // namespace burin::detail
