#include "page.h"

#include <burin/annotate/details.h>
#include <burin/base/error.h>
#include <burin/drawing/font.h>
#include <burin/drawing/views.h>
#include <burin/illustrate/ground.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace burin::detail {
namespace {

// Paper mm.
constexpr double kNumber = 12;   // height of the number of a step
constexpr double kHeading = 5;   // of the name of a sub-assembly
constexpr double kCount = 4;     // of "4x"
constexpr double kName = 2.5;    // of names of parts
constexpr double kScale = 3.5;   // of the scale
constexpr double kLine = 1.6;    // from line to line, in heights of the text
constexpr double kTurn = 10;     // diameter of the symbol beside the number, and its distance
constexpr Vec2 kCell{34, 34};    // a small picture and what stands below it
constexpr double kPicture = 20;  // of the height of a cell
constexpr double kInset = 1.5;   // between a cell and what is in it
constexpr double kApart = 6;     // between parts of a page
constexpr double kThin = 0.18;   // frames, after ISO 128
constexpr std::size_t kMostRows = 2;
/// Of the diagonal of a step: free space between what is new and its place.
constexpr double kGap = 0.06;
/// What stands already: widths of its lines, of those of the style, and the least, paper mm.
constexpr double kLight = 0.5, kLeastLine = 0.13;

Style light(Style style) {
  LineOptions& line = style.line;
  for (double* width : {&line.outer, &line.contour, &line.crease, &line.boundary, &line.smooth,
                        &line.intersection}) {
    *width = std::min(*width, std::max(kLight * *width, kLeastLine));
  }
  return style;
}

/// Two arrows round a circle: the product is turned over.
void add_turn_symbol(Vec2 middle, Layer& layer) {
  constexpr double kPen = 0.5, kRadius = 0.4 * kTurn, kHead = 2.4, kWide = 1.8;
  constexpr int kCorners = 24;
  for (const double from : {0.15, 1.15}) {  // in half turns
    const auto at = [&](double share) {
      const double a = std::numbers::pi * (from + 0.7 * share);
      return middle + kRadius * Vec2(std::cos(a), std::sin(a));
    };
    Path arc;
    arc.kind = LineClass::Frame;
    arc.width = {kPen};
    for (int i = 0; i <= kCorners; ++i) arc.points.push_back(at(static_cast<double>(i) / kCorners));
    const Vec2 way = glm::normalize(arc.points.back() - arc.points[kCorners - 1]);
    Path head;
    head.kind = LineClass::Frame;
    head.points = {arc.points.back(), arc.points.back() + kHead * way};
    head.width = {kWide, 0};
    layer.paths.push_back(std::move(arc));
    layer.paths.push_back(std::move(head));
  }
}

bool has_room(const Box2& box) { return box.size().x > 0 && box.size().y > 0; }

class Page {
 public:
  Page(const PageMaker& maker, const BuildStep& step, std::size_t number)
      : maker_(maker), step_(step), number_(number) {}

  PagePlan plan() const {
    PagePlan plan{.scenery = move_apart(), .look = {}, .added = new_kinds(maker_, step_)};
    const Box2 frame = inside(maker_.book.view.paper, maker_.book.margin);
    Vec2 head = head_size();
    plan.look = best_look(maker_.model.proxies(), step_, plan.scenery.moved, maker_.book.view,
                          maker_.context);
    if (is_turned(plan.look)) {
      head.x = std::max(head.x, text_width(std::to_string(number_), kNumber) + 2 * kTurn);
    }
    plan.grid = cells(frame, head.x, plan.added.size());
    plan.over.items = new_items(maker_, step_);
    plan.over.callouts = maker_.book.callouts;
    // Below the small pictures, or beside them.
    Box2 below = frame, beside = frame;
    below.max.y -= std::max(head.y, plan.grid.box.size().y) + kApart;
    beside.max = {plan.grid.box.min.x - kApart, frame.max.y - head.y - kApart};
    plan.fitted = 0;
    const Paper& paper = maker_.book.view.paper;
    const IllustrateOptions drawn = drawn_at(plan);
    Annotations over = plan.over;
    for (const Box2& rest : {below, beside}) {
      over.margin = margin_about(rest, paper);
      const Box2 box = inside(paper, annotation_margin(over, maker_.style.callout, paper));
      if (!has_room(rest) || !has_room(box)) continue;
      const double fitted = camera_in(plan.scenery.scene, drawn, view_of(plan.look, box)).scale();
      if (fitted <= plan.fitted) continue;
      plan.over.margin = over.margin;
      plan.box = box;
      plan.fitted = fitted;
    }
    if (plan.fitted <= 0) {
      throw UsageError(
          fmt::format("{:g} x {:g} mm are too small for the pages of a step book: use "
                      "a larger `paper` or a smaller `margin`",
                      paper.width, paper.height));
    }
    return plan;
  }

  BookPage draw(const PagePlan& plan, const PageScale& scale) const {
    BookPage page;
    page.title = title();
    page.scale = scale.value;
    page.drawing = draw_step(plan, scale.value);
    write_head(plan, scale.told, page.drawing);
    draw_cells(plan, page.drawing);
    for (const NewKind& kind : plan.added) page.added.push_back(kind.about);
    page.drawing.title = page.title.empty() ? fmt::format("Step {}", number_)
                                            : fmt::format("Step {}: {}", number_, page.title);
    return page;
  }

 private:
  /// What is new stands before its place.
  Scenery move_apart() const {
    Scenery out{maker_.scene, {}, {}};
    Box3 box;
    for (const std::size_t part : step_.parts()) {
      box.add(maker_.scene.parts[part].form->bounds(Mat3(1)));
    }
    std::vector<ExplodeStep> steps;
    std::vector<bool> there(maker_.scene.parts.size(), false);
    for (const std::size_t part : step_.parts()) there[part] = true;
    for (const BuildMove& move : step_.moves) {
      const double by =
          maker_.model.way_out(move.parts, step_.assembled, move.along) + kGap * box.diagonal();
      steps.push_back({.parts = move.parts, .along = move.along, .by = by});
    }
    out.moved = moves_of(steps, maker_.scene.parts.size(), 1);
    move_parts(out.scene, out.moved);
    out.trails = maker_.model.trails(steps, 1, there);
    return out;
  }

  std::string quantity() const {
    return step_.quantity > 1 ? fmt::format(", {}x", step_.quantity) : std::string();
  }
  std::string title() const {
    return step_.assembly.empty() ? std::string() : step_.assembly + quantity();
  }

  /// Of the number, the name and the scale.
  Vec2 head_size() const {
    Vec2 size(text_width(std::to_string(number_), kNumber), kNumber + kLine * kScale);
    const std::string name = title();
    if (!name.empty()) {
      size.x = std::max(size.x, text_width(name, kHeading));
      size.y += kLine * kHeading;
    }
    size.x = std::min(size.x, 0.4 * (maker_.book.view.paper.width));
    return size;
  }

  CellGrid cells(const Box2& frame, double beside, std::size_t kinds) const {
    CellGrid grid;
    const double width = frame.size().x - beside - kApart;
    grid.columns = static_cast<std::size_t>(std::max(1.0, std::floor(width / kCell.x)));
    const std::size_t room = grid.columns * kMostRows;
    grid.shown = std::min(kinds, room);
    grid.left_out = kinds - grid.shown;
    grid.columns = std::min(grid.columns, grid.shown);
    if (grid.shown == 0) return {{frame.max, frame.max}, 0, 0, 0};
    const std::size_t rows = (grid.shown + grid.columns - 1) / grid.columns;
    const Vec2 size = kCell * Vec2(static_cast<double>(grid.columns), static_cast<double>(rows));
    grid.box = {{frame.max.x - size.x, frame.max.y - size.y}, frame.max};
    return grid;
  }

  ViewOptions view_of(const Look& look, const Box2& box) const {
    ViewOptions view = maker_.book.view;
    view.direction = look.direction;
    view.up = look.up;
    view.scale.reset();
    view.center.reset();
    view.margin = 0;
    view.paper = {box.size().x, box.size().y};
    return view;
  }

  Camera camera_in(const Scene& scene, const IllustrateOptions& options,
                   const ViewOptions& view) const {
    return Camera::fit(extent_with_shadow(scene, maker_.style, options.part_styles, view), view);
  }

  /// Draws parts of a scene in a box of the sheet.
  Drawing draw_in(const Scene& scene, const IllustrateOptions& options, const ViewOptions& view,
                  const Box2& box) const {
    const Camera camera = camera_in(scene, options, view);
    return illustrate(scene, camera.on_sheet(maker_.book.view.paper, box.min), maker_.style,
                      options, maker_.context);
  }

  /// Options by which these parts alone, ascending, are drawn.
  IllustrateOptions alone(const std::vector<std::size_t>& parts) const {
    IllustrateOptions options = maker_.options;
    options.annotations.reset();
    options.part_styles.resize(maker_.scene.parts.size());
    for (std::size_t i = 0; i < options.part_styles.size(); ++i) {
      if (!std::ranges::binary_search(parts, i)) options.part_styles[i].drawn = false;
    }
    return options;
  }

  /// How the step itself is drawn.
  IllustrateOptions drawn_at(const PagePlan& plan) const {
    IllustrateOptions options = alone(step_.parts());
    options.trails = plan.scenery.trails;
    if (!step_.begins) {
      for (const std::size_t part : step_.assembled) {
        PartStyle& one = options.part_styles[part];
        one.hatched = false;
        one.style = light(one.style.value_or(maker_.style));
      }
    }
    for (const std::size_t part : plan.look.ghosts) {
      options.part_styles[part].transparent = true;
      options.part_styles[part].hatched = false;
    }
    options.annotations = plan.over;
    return options;
  }

  Drawing draw_step(const PagePlan& plan, double scale) const {
    ViewOptions view = view_of(plan.look, plan.box);
    if (scale != plan.fitted) view.scale = scale;
    return draw_in(plan.scenery.scene, drawn_at(plan), view, plan.box);
  }

  /// Whether the step is looked at from another side than was asked for.
  bool is_turned(const Look& look) const {
    constexpr double kSame = 0.999;  // cosine
    return glm::dot(look.direction, glm::normalize(maker_.book.view.direction)) < kSame;
  }

  void write_head(const PagePlan& plan, const std::string& scale, Drawing& drawing) const {
    const Box2 frame = inside(maker_.book.view.paper, maker_.book.margin);
    Layer layer{"step", {}};
    if (is_turned(plan.look)) {
      const double beside = text_width(std::to_string(number_), kNumber) + kTurn;
      add_turn_symbol({frame.min.x + beside, frame.max.y - 0.5 * kNumber}, layer);
    }
    Vec2 at(frame.min.x, frame.max.y - kNumber);
    const auto write = [&](std::string text, double height) {
      layer.texts.push_back({at, height, TextAnchor::Start, std::move(text), "step", 0});
    };
    write(std::to_string(number_), kNumber);
    if (!step_.assembly.empty()) {
      at.y -= kLine * kHeading;
      // Up to the small pictures; however long the name is, its quantity stays.
      const double room =
          std::max(0.4 * maker_.book.view.paper.width, plan.grid.box.min.x - kApart - frame.min.x);
      const std::string count = quantity();
      write(fitted_text(step_.assembly, kHeading, room - text_width(count, kHeading)) + count,
            kHeading);
    }
    if (!scale.empty()) {
      at.y -= kLine * kScale;
      write(scale, kScale);
    }
    drawing.layers.push_back(std::move(layer));
  }

  void draw_cells(const PagePlan& plan, Drawing& page) const {
    const CellGrid& grid = plan.grid;
    if (grid.shown == 0) return;
    Layer layer{"step", {}};
    Path border;
    border.kind = LineClass::Frame;
    border.closed = true;
    border.width = {kThin};
    border.points = {grid.box.min,
                     {grid.box.max.x, grid.box.min.y},
                     grid.box.max,
                     {grid.box.min.x, grid.box.max.y}};
    layer.paths.push_back(std::move(border));
    for (std::size_t i = 0; i < grid.shown; ++i) {
      const std::size_t above = i / grid.columns;
      const auto column = static_cast<double>(i % grid.columns), row = static_cast<double>(above);
      const Vec2 top(grid.box.min.x + column * kCell.x, grid.box.max.y - row * kCell.y);
      draw_cell(plan.added[i], top, plan.look, layer, page);
    }
    if (grid.left_out > 0) {
      layer.texts.push_back({{grid.box.max.x, grid.box.min.y - 1.6 * kName},
                             kName,
                             TextAnchor::End,
                             fmt::format("and {} more", grid.left_out),
                             "step",
                             0});
    }
    Drawing texts;
    texts.layers.push_back(std::move(layer));
    append_view(page, std::move(texts));
  }

  void draw_cell(const NewKind& kind, Vec2 top, const Look& look, Layer& layer,
                 Drawing& page) const {
    const Box2 box{top + Vec2(kInset, -kPicture), top + Vec2(kCell.x - kInset, -kInset)};
    Drawing small =
        draw_in(maker_.scene, alone(kind.parts), view_of({look.direction, look.up, {}}, box), box);
    small.diagnostics = {};  // the step tells it
    append_view(page, std::move(small));
    const double y = top.y - kPicture - 0.4 * kCount;
    const int item = kind.about.item;
    layer.texts.push_back({{top.x + kInset, y - kCount},
                           kCount,
                           TextAnchor::Start,
                           fmt::format("{}x", kind.about.quantity),
                           "step",
                           item});
    const std::string name =
        item > 0 ? fmt::format("{} {}", item, kind.about.name) : kind.about.name;
    layer.texts.push_back({{top.x + kInset, y - kCount - 1.8 * kName},
                           kName,
                           TextAnchor::Start,
                           fitted_text(name, kName, kCell.x - 2 * kInset),
                           "step",
                           item});
  }

  const PageMaker& maker_;
  const BuildStep& step_;
  std::size_t number_;
};

}  // namespace

PagePlan PageMaker::plan(const BuildStep& step, std::size_t number) const {
  return Page(*this, step, number).plan();
}

BookPage PageMaker::draw(const BuildStep& step, std::size_t number, const PagePlan& plan,
                         const PageScale& scale) const {
  return Page(*this, step, number).draw(plan, scale);
}

}  // namespace burin::detail
