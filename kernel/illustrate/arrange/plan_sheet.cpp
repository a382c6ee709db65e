#include <burin/annotate/details.h>
#include <burin/annotate/legend_box.h>
#include <burin/arrange/arrange.h>
#include <burin/base/error.h>
#include <burin/illustrate/ground.h>

#include "details.h"
#include "drawn_shape.h"
#include "overall.h"
#include "wanted_views.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace burin {
namespace {

/// A perspective view knows one margin.
Margin margin_of(const Margin& m, const Illustration& illustration) {
  return illustration.view.perspective ? Margin(std::max({m.top, m.right, m.bottom, m.left})) : m;
}

/// What is drawn in a view, with its shadow on the ground where there is one.
Camera::ExtentFn extent_of(const Scene& scene, const Illustration& illustration,
                           const ViewOptions& view) {
  return extent_with_shadow(scene, illustration.style, illustration.illustrate.part_styles, view);
}

Margin sum(const Margin& a, const Margin& b) {
  return {a.top + b.top, a.right + b.right, a.bottom + b.bottom, a.left + b.left};
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
    const Margin more(std::max(m.top, needed.top), std::max(m.right, needed.right),
                      std::max(m.bottom, needed.bottom), std::max(m.left, needed.left));
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

/// What is drawn, with the ends of what is measured: corners of a box about it, which an oblique
/// view may show farther out.
Camera::ExtentFn with_measured(Camera::ExtentFn drawn, std::vector<Dimension> dimensions) {
  return [drawn = std::move(drawn), dimensions = std::move(dimensions)](const Mat3& axes) {
    Box3 box = drawn(axes);
    for (const Dimension& one : dimensions) box.add(axes * one.from), box.add(axes * one.to);
    return box;
  };
}

/// The camera of a view that has the sheet for itself. `room`: of dimensions.
Camera lone_camera(const Scene& scene, const Illustration& illustration,
                   const std::vector<Dimension>& dimensions, const Margin& room) {
  const Camera::ExtentFn extent =
      with_measured(extent_of(scene, illustration, illustration.view), dimensions);
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

/// Paper mm between views, and between a view and the edge of what it may take.
constexpr double kBetweenViews = 12;

/// Paper mm on each side that callouts about a drawing of that size need.
Vec2 callout_capacity_of(const Illustration& illustration, Vec2 size) {
  if (!illustration.illustrate.annotations || !illustration.illustrate.annotations->callouts)
    return Vec2(0);
  Annotations callouts = *illustration.illustrate.annotations;
  callouts.parts_list = false;
  callouts.legend.clear();
  callouts.title_block.reset();
  callouts.margin = Margin(0);
  const Margin m = annotation_margin(callouts, illustration.style.callout, {size.x, size.y});
  return {std::max(m.left, m.right), std::max(m.top, m.bottom)};
}

/// Places views of an illustration one after the other.
class SheetPlanner {
 public:
  SheetPlanner(Scene& scene, const Illustration& illustration)
      : scene_(scene),
        illustration_(illustration),
        frame_(inside(illustration.view.paper, illustration.sheet.margin)) {
    if (illustration.sheet.fits) {
      throw UsageError("several views or details need a sheet of a fixed size: set `paper`");
    }
    if (illustration.illustrate.annotations) {
      const Annotations& over = *illustration.illustrate.annotations;
      const CalloutOptions& style = illustration.style.callout;
      frame_ = beside_tables(over, style, illustration.view.paper);
      list_ = parts_list_box(over, style, illustration.view.paper);
      legend_ = legend_box(over, style, illustration.view.paper);
    }
  }

  SheetOfViews run() {
    const Vec2 free = frame_.size();
    views_ = detail::wanted_views(illustration_);
    std::vector<detail::OverallView> seen;
    for (const detail::WantedView& wanted : views_)
      seen.push_back({detail::axes_of(wanted.view), wanted.section ? 2 : wanted.marked ? 1 : 0});
    if (views_.empty()) seen.push_back({detail::axes_of(illustration_.view)});
    overall_.emplace(scene_, illustration_, std::move(seen));
    std::vector<std::string> letters;
    for (const SectionView& view : illustration_.section_views) letters.push_back(view.letter);
    details_ = detail::plan_details(scene_, illustration_.details, detail::axes_of(first_view()),
                                    std::min(free.x, free.y), std::move(letters));
    frame_ = detail::place_details(
        details_, detail_caption(illustration_.style.callout),
        {frame_, inside(illustration_.view.paper, illustration_.sheet.margin), list_, legend_});
    place_views();
    if (!circles_stay()) {
      with_circles_ = true;
      sheet_ = {};
      place_views();
    }
    mark_sections();
    for (const detail::PlannedDetail& detail : details_) add_detail(detail);
    report_small_view();
    return std::move(sheet_);
  }

 private:
  /// Of several views the one from above has no shadow on the ground.
  Camera::ExtentFn extent_in_grid(const ViewOptions& view) const {
    if (views_.empty()) return extent_of(scene_, illustration_, view);
    return extent_with_shadow(scene_,
                              style_in_grid(illustration_.style, glm::normalize(view.direction)),
                              illustration_.illustrate.part_styles, view);
  }

  /// With the places that are drawn again where their circles need room.
  Camera::ExtentFn extent(const ViewOptions& view) const {
    return [this, of = extent_in_grid(view)](const Mat3& axes) {
      Box3 box = of(axes);
      if (!with_circles_) return box;
      for (const detail::PlannedDetail& detail : details_) {
        const Vec3 at = axes * detail.at;
        box.add({at - detail.radius, at + detail.radius});
      }
      return box;
    };
  }

  void place_views() {
    if (views_.empty()) {
      place_one();
    } else {
      place_grid();
    }
  }

  /// Whether the circles about what is drawn again lie in the box of their view.
  bool circles_stay() const {
    const PlacedView& main = sheet_.views.front();
    return std::ranges::all_of(details_, [&](const detail::PlannedDetail& detail) {
      const Vec2 at = main.camera.to_paper(detail.at);
      const double radius = detail.radius * main.camera.scale_at(detail.at);
      const Box2 &box = main.box, circle{at - radius, at + radius};
      return box.contains(circle.min) && box.contains(circle.max);
    });
  }

  ViewOptions first_view() const {
    return views_.empty() ? illustration_.view : views_.front().view;
  }

  void mark_sections() {
    for (const SectionView& section : illustration_.section_views) {
      const auto parent = detail::parent_of(views_, illustration_, section);
      if (!parent) {
        detail::report_no_line(scene_, illustration_, section);
        continue;
      }
      sheet_.section_marks.push_back(detail::mark_of(
          section, scene_, illustration_, views_[*parent].view, sheet_.views[*parent].camera));
    }
  }

  /// A camera whose picture stands in the middle of a box.
  Camera in_box(ViewOptions view, const Box2& box, const std::vector<Dimension>& measured) const {
    const Paper sheet = view.paper;
    view.paper = {box.size().x, box.size().y};
    const Camera::ExtentFn shown = with_measured(extent(view), measured);
    const SheetOptions whole{.margin = Margin(0), .iso_scale = illustration_.sheet.iso_scale};
    return Camera::fit(shown, settle(shown, view, whole)).on_sheet(sheet, box.min);
  }

  /// A camera of a given scale whose picture has its middle there.
  Camera on_middle(ViewOptions view, Vec2 middle, const std::vector<Dimension>& measured) const {
    const Paper sheet = view.paper;
    const Vec2 half(0.5 * sheet.width, 0.5 * sheet.height);
    view.margin = 0;
    return Camera::fit(with_measured(extent(view), measured), view).on_sheet(sheet, middle - half);
  }

  void place_one() {
    const Vec2 callouts = callout_capacity_of(illustration_, frame_.size());
    Margin room(0);
    PlacedView view{"", Camera{}, frame_, {}, 1, {}, true, {}, overall_->of_view(0, room)};
    view.camera = in_box(illustration_.view,
                         {frame_.min + callouts + Vec2(room.left, room.bottom),
                          frame_.max - callouts - Vec2(room.right, room.top)},
                         view.dimensions);
    sheet_.views.push_back(std::move(view));
  }

  void place_grid() {
    if (illustration_.view.perspective) {
      throw UsageError("several views are orthographic: leave `perspective` out");
    }
    sheet_.method = illustration_.projection;
    Box2 frame = frame_;
    const std::optional<Annotations>& over = illustration_.illustrate.annotations;
    if (!over || !has_symbol(*over, illustration_.style.callout, illustration_.view.paper)) {
      // The symbol of the method stands under the views at the left.
      sheet_.symbol_at = frame_.min;
      frame.min.y += projection_symbol_size().y + 0.5 * kBetweenViews;
    }
    std::vector<std::vector<Dimension>> dimensions;
    std::vector<GridView> grid_views;
    const std::size_t numbered = view_with_callouts();
    for (const detail::WantedView& wanted : views_) {
      GridView view{wanted.stands_as, Vec2(0), wanted.room};
      dimensions.push_back(overall_->of_view(dimensions.size(), view.room));
      const Vec3 size =
          with_measured(extent(wanted.view), dimensions.back())(detail::axes_of(wanted.view))
              .size();
      view.size = {size.x, size.y};
      if (grid_views.size() == numbered) {
        const Vec2 callouts = callout_capacity_of(illustration_, 0.5 * frame.size());
        view.room = sum(view.room, Margin(callouts.y, callouts.x, callouts.y, callouts.x));
      }
      grid_views.push_back(std::move(view));
    }
    const auto arranged = [&](std::optional<double> scale) {
      return arrange_views(grid_views, illustration_.projection, frame, kBetweenViews, scale);
    };
    ViewGrid grid = arranged(illustration_.view.scale);
    if (illustration_.sheet.iso_scale) grid = arranged(standard_scale(grid.scale));
    for (std::size_t i = 0; i < views_.size(); ++i) {
      ViewOptions view = views_[i].view;
      view.scale = grid.scale;
      const Vec2 half = 0.5 * grid.scale * grid_views[i].size, middle = grid.middles[i];
      const Box2 drawn{middle - half, middle + half};
      PlacedView placed{views_[i].name, on_middle(view, middle, dimensions[i]), grid.boxes[i]};
      placed.callouts = i == numbered;
      placed.none_hidden = views_[i].none_hidden;
      placed.dimensions = std::move(dimensions[i]);
      if (const SectionView* section = views_[i].section) {
        placed.scene = section->scene;
        sheet_.section_names.push_back({drawn, section->letter});
      }
      sheet_.views.push_back(std::move(placed));
    }
  }

  /// The first pictorial one, which shows most of an assembly; else the first.
  std::size_t view_with_callouts() const {
    for (std::size_t i = 0; i < views_.size(); ++i) {
      const Vec3 d = glm::abs(views_[i].view.direction);
      if ((d.x > 0) + (d.y > 0) + (d.z > 0) > 1) return i;
    }
    return 0;
  }

  /// A view beside which a detail is half as large again says little of where it belongs.
  void report_small_view() {
    if (details_.empty()) return;
    const Camera& main = sheet_.views.front().camera;
    const Vec3 size = extent_of(scene_, illustration_, first_view())(detail::axes_of(main)).size();
    const double drawn = main.scale() * std::max(size.x, size.y);
    const auto largest = std::ranges::max_element(
        details_, {}, [](const auto& detail) { return detail.scale * detail.radius; });
    const double detail = 2 * largest->scale * largest->radius;
    if (1.5 * drawn >= detail) return;
    scene_.diagnostics.add(
        Severity::Warning, "detail.small_view", 1,
        fmt::format("{}the view is {:.0f} mm large, its detail {} {:.0f} mm: give the detail a "
                    "smaller scale than {}, such as {}, or a larger `paper`",
                    largest->place, drawn, largest->letter, detail, scale_text(largest->scale),
                    scale_text(standard_scale(largest->scale * drawn / detail))));
  }

  void add_detail(const detail::PlannedDetail& detail) {
    const Camera& main = sheet_.views.front().camera;
    const Vec2 from = main.to_paper(detail.at);
    const double scale = main.scale_at(detail.at);
    const Camera camera = main.magnified(detail.scale / scale, from, detail.center);
    const Disc shown{detail.center, detail.radius * detail.scale};
    if (detail.scale <= scale) {
      scene_.diagnostics.add(
          Severity::Warning, "detail.no_larger", 1,
          fmt::format("{}detail {} is drawn {}, no larger than the view, {}", detail.place,
                      detail.letter, scale_text(detail.scale), scale_text(scale)));
    }
    sheet_.details.push_back({{from, detail.radius * scale}, shown, detail.letter, detail.scale});
    sheet_.views.push_back({detail.letter,
                            camera,
                            {shown.center - shown.radius, shown.center + shown.radius},
                            shown,
                            detail.scale / scale,
                            detail.parts});
    sheet_.views.back().none_hidden = sheet_.views.front().none_hidden;
  }

  Scene& scene_;
  const Illustration& illustration_;
  Box2 frame_;
  std::optional<Box2> list_, legend_;
  bool with_circles_ = false;
  std::vector<detail::PlannedDetail> details_;
  std::vector<detail::WantedView> views_;
  std::optional<detail::Overall> overall_;
  SheetOfViews sheet_;
};

}  // namespace

Vec2 detail::drawn_shape(const Scene& scene, const Illustration& illustration) {
  if (!illustration.views.empty()) return Vec2(0);
  const ViewOptions& view = illustration.view;
  const Vec3 size = extent_of(scene, illustration, view)(detail::axes_of(view)).size();
  return {size.x, size.y};
}

SheetOfViews plan_sheet(Scene& scene, const Illustration& illustration) {
  if (!illustration.views.empty() || !illustration.details.empty() ||
      !illustration.section_views.empty()) {
    return SheetPlanner(scene, illustration).run();
  }
  SheetOfViews sheet;
  Margin room(0);
  const detail::Overall overall(scene, illustration, {{detail::axes_of(illustration.view)}});
  std::vector<Dimension> dimensions = overall.of_view(0, room);
  const Camera camera = lone_camera(scene, illustration, dimensions, room);
  sheet.views.push_back({"", camera, {Vec2(0), {camera.paper().width, camera.paper().height}}});
  sheet.views.front().dimensions = std::move(dimensions);
  return sheet;
}

}  // namespace burin
