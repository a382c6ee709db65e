#include <burin/annotate/details.h>
#include <burin/annotate/legend_box.h>
#include <burin/arrange/arrange.h>
#include <burin/base/error.h>
#include <burin/illustrate/ground.h>

#include "broken_view.h"
#include "details.h"
#include "drawn_shape.h"
#include "lone_view.h"
#include "sheet_dimensions.h"
#include "wanted_views.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace burin {
namespace {

using detail::extent_of, detail::lone_view, detail::sum, detail::with_measured, detail::kMostRounds;

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
    measured_.emplace(scene_, illustration_, measuring_views());
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
  std::vector<detail::SheetView> measuring_views() const {
    if (views_.empty()) return {lone_view(scene_, illustration_)};
    std::vector<detail::SheetView> seen;
    for (const detail::WantedView& wanted : views_) {
      detail::SheetView view = lone_view(scene_, illustration_);
      view.as.axes = detail::axes_of(wanted.view);
      view.as.hidden_lines = view.as.hidden_lines && !wanted.none_hidden;
      view.name = wanted.name;
      view.broken = broken_as(wanted.view);
      view.rank = wanted.section ? 2 : wanted.marked ? 1 : 0;
      if (wanted.section) {
        const SectionView* first = illustration_.section_views.data();
        view.as.scene = 1 + static_cast<std::size_t>(wanted.section - first);
      }
      seen.push_back(std::move(view));
    }
    return seen;
  }

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

  detail::BrokenAs broken_as(const ViewOptions& view) const {
    return {scene_, illustration_, view};
  }

  /// What a view shows, with what it measures.
  Camera::ExtentFn shown_in(const ViewOptions& view, const detail::BrokenAs& broken,
                            const ViewDimensions& measured) const {
    return broken.shortened(with_measured(extent(view), measured));
  }

  /// Whether the circles about what is drawn again lie in the box of their view, where no callouts
  /// stand.
  bool circles_stay() const {
    const PlacedView& main = sheet_.views.front();
    return std::ranges::all_of(details_, [&](const detail::PlannedDetail& detail) {
      const Vec2 at = main.at(detail.at);
      const double radius = detail.radius * main.camera.scale_at(detail.at);
      const Box2 box{main.box.min + callouts_, main.box.max - callouts_};
      const Box2 circle{at - radius, at + radius};
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
      auto mark = detail::mark_of(section, scene_, illustration_, views_[*parent].view,
                                  sheet_.views[*parent]);
      if (mark) {
        sheet_.section_marks.push_back(std::move(*mark));
      } else {
        scene_.diagnostics.add(Severity::Warning, "section.no_line", 1,
                               fmt::format("{}the sheet does not show where section {}-{} cuts: "
                                           "the break leaves the place out",
                                           section.place, section.letter, section.letter));
      }
    }
  }

  /// A camera whose picture stands in the middle of a box.
  Camera in_box(ViewOptions view, const Box2& box, const Camera::ExtentFn& shown) const {
    const Paper sheet = view.paper;
    view.paper = {box.size().x, box.size().y};
    const SheetOptions whole{.margin = Margin(0), .iso_scale = illustration_.sheet.iso_scale};
    return Camera::fit(shown, settle(shown, view, whole)).on_sheet(sheet, box.min);
  }

  /// A camera of a given scale whose picture has its middle there.
  static Camera on_middle(ViewOptions view, Vec2 middle, const Camera::ExtentFn& shown) {
    const Paper sheet = view.paper;
    const Vec2 half(0.5 * sheet.width, 0.5 * sheet.height);
    view.margin = 0;
    return Camera::fit(shown, view).on_sheet(sheet, middle - half);
  }

  void place_one() {
    callouts_ = callout_capacity_of(illustration_, frame_.size());
    const detail::BrokenAs broken = broken_as(illustration_.view);
    Margin room = broken.room();
    PlacedView view{"", Camera{}, frame_, {}, 1, {}, true, {}, measured_->of_view(0, Margin(0))};
    const Camera::ExtentFn extent_of_it = shown_in(illustration_.view, broken, view.dimensions);
    const Box3 shown = extent_of_it(detail::axes_of(illustration_.view));
    for (int round = 0; round < kMostRounds; ++round) {
      view.camera = in_box(illustration_.view,
                           {frame_.min + callouts_ + Vec2(room.left, room.bottom),
                            frame_.max - callouts_ - Vec2(room.right, room.top)},
                           extent_of_it);
      const double scale = view.camera.scale();
      const Margin needed = measured_->room(0, broken.moved(view.dimensions, scale), shown, scale);
      if (detail::holds(room, needed)) break;
      room = detail::larger(room, needed);
    }
    break_view(broken, illustration_.view, view);
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
    std::vector<ViewDimensions> dimensions;
    std::vector<Camera::ExtentFn> extents;
    std::vector<Box3> shown;
    std::vector<GridView> grid_views;
    std::vector<detail::BrokenAs> broken;
    const std::size_t numbered = view_with_callouts();
    Margin callouts(0);
    for (const detail::WantedView& wanted : views_) {
      GridView view{wanted.stands_as, Vec2(0), wanted.room};
      dimensions.push_back(measured_->of_view(dimensions.size(), view.room));
      broken.push_back(broken_as(wanted.view));
      extents.push_back(shown_in(wanted.view, broken.back(), dimensions.back()));
      shown.push_back(extents.back()(detail::axes_of(wanted.view)));
      view.size = {shown.back().size().x, shown.back().size().y};
      view.room = sum(view.room, broken.back().room());
      if (grid_views.size() == numbered) {
        const Vec2 side = callout_capacity_of(illustration_, 0.5 * frame.size());
        callouts = Margin(side.y, side.x, side.y, side.x);
        if (numbered == 0) callouts_ = side;
        view.room = sum(view.room, callouts);
      }
      grid_views.push_back(std::move(view));
    }
    const auto arranged = [&](std::optional<double> scale) {
      return arrange_views(grid_views, illustration_.projection, frame, kBetweenViews, scale);
    };
    ViewGrid grid;
    for (int round = 0; round < kMostRounds; ++round) {
      try {
        grid = arranged(illustration_.view.scale);
        if (illustration_.sheet.iso_scale) grid = arranged(standard_scale(grid.scale));
      } catch (const UsageError&) {
        if (round == 0) throw;
        throw UsageError(
            "the sheet has no room for the views with their dimensions: measure less, name fewer "
            "`views`, or give a larger `paper`");
      }
      bool has_room = true;
      for (std::size_t i = 0; i < views_.size(); ++i) {
        Margin needed =
            measured_->room(i, broken[i].moved(dimensions[i], grid.scale), shown[i], grid.scale);
        if (i == numbered) needed = sum(needed, callouts);
        has_room &= detail::holds(grid_views[i].room, needed);
        grid_views[i].room = detail::larger(grid_views[i].room, needed);
      }
      if (has_room) break;
    }
    for (std::size_t i = 0; i < views_.size(); ++i) {
      ViewOptions view = views_[i].view;
      view.scale = grid.scale;
      const Margin gaps = broken[i].room();
      const Vec2 half = 0.5 * grid.scale * grid_views[i].size + Vec2(gaps.right, gaps.top);
      const Vec2 middle = grid.middles[i];
      const Box2 drawn{middle - half, middle + half};
      PlacedView placed{views_[i].name, on_middle(view, middle, extents[i]), grid.boxes[i]};
      placed.callouts = i == numbered;
      placed.none_hidden = views_[i].none_hidden;
      placed.dimensions = std::move(dimensions[i]);
      if (const SectionView* section = views_[i].section) {
        placed.scene = section->scene;
        sheet_.section_names.push_back({drawn, section->letter});
      }
      break_view(broken[i], view, placed);
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
    const Vec3 size = broken_as(first_view())
                          .shortened(extent_of(scene_, illustration_, first_view()))(main.axes())
                          .size();
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
    const PlacedView& first = sheet_.views.front();
    const Camera main = first.camera;
    const Vec2 from = main.to_paper(detail.at);
    const double scale = main.scale_at(detail.at);
    if (first.breaks.leaves_out(from, detail.radius * scale)) {
      throw UsageError(
          fmt::format("{}detail {} reaches into what the break leaves out: give it a smaller "
                      "radius, or break another stretch",
                      detail.place, detail.letter));
    }
    const Camera camera = main.magnified(detail.scale / scale, from, detail.center);
    const Disc shown{detail.center, detail.radius * detail.scale};
    if (detail.scale <= scale) {
      scene_.diagnostics.add(
          Severity::Warning, "detail.no_larger", 1,
          fmt::format("{}detail {} is drawn {}, no larger than the view, {}", detail.place,
                      detail.letter, scale_text(detail.scale), scale_text(scale)));
    }
    sheet_.details.push_back(
        {{first.at(detail.at), detail.radius * scale}, shown, detail.letter, detail.scale});
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
  /// Paper mm that callouts take on both sides of the first view.
  Vec2 callouts_{0};
  std::vector<detail::PlannedDetail> details_;
  std::vector<detail::WantedView> views_;
  std::optional<detail::SheetDimensions> measured_;
  SheetOfViews sheet_;
};

}  // namespace

Vec2 detail::drawn_shape(const Scene& scene, const Illustration& illustration) {
  if (!illustration.views.empty()) return Vec2(0);
  const ViewOptions& view = illustration.view;
  const Camera::ExtentFn extent =
      detail::BrokenAs(scene, illustration, view).shortened(extent_of(scene, illustration, view));
  const Vec3 size = extent(detail::axes_of(view)).size();
  return {size.x, size.y};
}

SheetOfViews plan_sheet(Scene& scene, const Illustration& illustration) {
  const bool several = !illustration.views.empty() || !illustration.details.empty() ||
                       !illustration.section_views.empty();
  SheetOfViews sheet = several ? SheetPlanner(scene, illustration).run()
                               : detail::plan_lone_view(scene, illustration);
  detail::report_unbroken(scene, illustration, sheet);
  return sheet;
}

}  // namespace burin
