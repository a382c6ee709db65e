#include "page.h"

#include <burin/annotate/details.h>
#include <burin/assembly/things.h>
#include <burin/drawing/font.h>
#include <burin/drawing/views.h>
#include <burin/illustrate/ground.h>

#include "show.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
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
  constexpr double kLine = 0.5, kRadius = 0.4 * kTurn, kHead = 2.4, kWide = 1.8;
  constexpr int kCorners = 24;
  for (const double from : {0.15, 1.15}) {  // in half turns
    const auto at = [&](double share) {
      const double a = std::numbers::pi * (from + 0.7 * share);
      return middle + kRadius * Vec2(std::cos(a), std::sin(a));
    };
    Path arc;
    arc.kind = LineClass::Frame;
    arc.width = {kLine};
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

/// Things of a page that are alike, with one of them to be shown.
struct Kind {
  NewPart about;
  std::vector<std::size_t> parts;
};

/// What goes on at a step, where its parts are.
struct Scenery {
  Scene scene;
  std::vector<Vec3> moved;
  std::vector<Curve3> trails;
};

class Page {
 public:
  Page(const PageMaker& maker, const BuildStep& step) : maker_(maker), step_(step) {}

  BookPage make(std::size_t number) {
    const Scenery scenery = move_apart();
    const std::vector<Kind> kinds = kinds_of();
    const Box2 frame = inside(maker_.book.view.paper, maker_.book.margin);
    Vec2 head = text_size(number);
    const Look look =
        best_look(maker_.model.proxies(), step_, scenery.moved, maker_.book.view, maker_.context);
    if (is_turned(look))
      head.x = std::max(head.x, text_width(std::to_string(number), kNumber) + 2 * kTurn);
    const Grid grid = cells(frame, head.x, kinds.size());
    Box2 rest = frame;
    rest.max.y -= std::max(head.y, grid.box.size().y) + kApart;
    BookPage page;
    page.title = title();
    page.drawing = draw_step(scenery, look, rest);
    write_head(number, frame, is_turned(look), page.drawing);
    draw_cells(kinds, grid, look, page.drawing);
    for (const Kind& kind : kinds) page.added.push_back(kind.about);
    page.drawing.title = page.title.empty() ? fmt::format("Step {}", number)
                                            : fmt::format("Step {}: {}", number, page.title);
    return page;
  }

 private:
  /// Where small pictures stand.
  struct Grid {
    Box2 box;
    std::size_t columns = 0, shown = 0, left_out = 0;
  };

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

  std::string title() const {
    if (step_.assembly.empty()) return {};
    return step_.quantity > 1 ? fmt::format("{}, {}x", step_.assembly, step_.quantity)
                              : step_.assembly;
  }

  std::vector<Kind> kinds_of() const {
    std::map<std::vector<int>, std::size_t> known;
    std::vector<Kind> kinds;
    const auto add = [&](const std::vector<std::size_t>& parts) {
      std::vector<int> numbers;
      for (const std::size_t part : parts) numbers.push_back(number_of(part));
      std::ranges::sort(numbers);
      const auto [entry, is_new] = known.try_emplace(std::move(numbers), kinds.size());
      if (is_new) kinds.push_back({about(parts), parts});
      ++kinds[entry->second].about.quantity;
    };
    for (const BuildMove& move : step_.moves) add(move.parts);
    if (step_.begins) {
      const std::vector<std::size_t> things = things_of(maker_.scene);
      std::map<std::size_t, std::vector<std::size_t>> assembled;
      for (const std::size_t part : step_.assembled) assembled[things[part]].push_back(part);
      for (const auto& [first, parts] : assembled) add(parts);
    }
    return kinds;
  }

  int number_of(std::size_t part) const {
    const DrawingItem* item = maker_.item_of[part];
    return item ? item->number : -1 - static_cast<int>(part);
  }

  NewPart about(const std::vector<std::size_t>& parts) const {
    const std::vector<std::size_t> things = things_of(maker_.scene);
    const auto of_first = [&](std::size_t p) { return things[p] == things[parts.front()]; };
    if (std::ranges::all_of(parts, of_first)) {
      const DrawingItem* item = maker_.item_of[parts.front()];
      return item ? NewPart{item->number, item->name, 0}
                  : NewPart{0, maker_.scene.parts[parts.front()].name, 0};
    }
    return {0, name_together(maker_.scene, maker_.drawn, parts), 0};
  }

  Vec2 text_size(std::size_t number) const {
    Vec2 size(text_width(std::to_string(number), kNumber), kNumber);
    const std::string name = title();
    if (!name.empty()) {
      size.x = std::max(size.x, text_width(name, kHeading));
      size.y += kHeading + 0.6 * kHeading;
    }
    size.x = std::min(size.x, 0.4 * (maker_.book.view.paper.width));
    return size;
  }

  Grid cells(const Box2& frame, double beside, std::size_t kinds) const {
    Grid grid;
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

  /// Draws parts of a scene in a box of the sheet.
  Drawing draw_in(const Scene& scene, const IllustrateOptions& options, const ViewOptions& view,
                  const Box2& box) const {
    const Camera camera =
        Camera::fit(extent_with_shadow(scene, maker_.style, options.part_styles, view), view);
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

  Drawing draw_step(const Scenery& scenery, const Look& look, const Box2& box) const {
    IllustrateOptions options = alone(step_.parts());
    options.trails = scenery.trails;
    if (!step_.begins) {
      for (const std::size_t part : step_.assembled) {
        PartStyle& one = options.part_styles[part];
        one.hatched = false;
        one.style = light(one.style.value_or(maker_.style));
      }
    }
    for (const std::size_t part : look.ghosts) {
      options.part_styles[part].transparent = true;
      options.part_styles[part].hatched = false;
    }
    Annotations& over = options.annotations.emplace();
    over.items = new_items();
    over.callouts = maker_.book.callouts;
    const Paper& paper = maker_.book.view.paper;
    over.margin = margin_about(box, paper);
    const Box2 inner = inside(paper, annotation_margin(over, maker_.style.callout, paper));
    return draw_in(scenery.scene, options, view_of(look, inner), inner);
  }

  /// Items of what is new, with those of their parts that are on the page.
  std::vector<DrawingItem> new_items() const {
    std::vector<std::size_t> fresh;
    for (const BuildMove& move : step_.moves) {
      fresh.insert(fresh.end(), move.parts.begin(), move.parts.end());
    }
    if (step_.begins) fresh.insert(fresh.end(), step_.assembled.begin(), step_.assembled.end());
    std::ranges::sort(fresh);
    std::map<int, DrawingItem> items;
    for (const std::size_t part : fresh) {
      const DrawingItem* item = maker_.item_of[part];
      if (!item) continue;
      DrawingItem& one = items.try_emplace(item->number, *item).first->second;
      if (one.parts == item->parts) one.parts.clear(), one.selectors.clear();
      const auto id = static_cast<std::int32_t>(part);
      const auto at =
          static_cast<std::size_t>(std::ranges::find(item->parts, id) - item->parts.begin());
      one.parts.push_back(id);
      if (at < item->selectors.size()) one.selectors.push_back(item->selectors[at]);
    }
    std::vector<DrawingItem> out;
    for (auto& [number, item] : items) out.push_back(std::move(item));
    return out;
  }

  /// Whether the step is looked at from another side than was asked for.
  bool is_turned(const Look& look) const {
    constexpr double kSame = 0.999;  // cosine
    return glm::dot(look.direction, glm::normalize(maker_.book.view.direction)) < kSame;
  }

  void write_head(std::size_t number, const Box2& frame, bool turned, Drawing& drawing) const {
    Layer layer{"step", {}};
    if (turned) {
      const double beside = text_width(std::to_string(number), kNumber) + kTurn;
      add_turn_symbol({frame.min.x + beside, frame.max.y - 0.5 * kNumber}, layer);
    }
    const Vec2 at(frame.min.x, frame.max.y - kNumber);
    layer.texts.push_back({at, kNumber, TextAnchor::Start, std::to_string(number), "step", 0});
    const std::string name = title();
    if (!name.empty()) {
      const double room = 0.4 * maker_.book.view.paper.width;
      layer.texts.push_back({at - Vec2(0, 1.6 * kHeading), kHeading, TextAnchor::Start,
                             fitted_text(name, kHeading, room), "step", 0});
    }
    drawing.layers.push_back(std::move(layer));
  }

  void draw_cells(const std::vector<Kind>& kinds, const Grid& grid, const Look& look,
                  Drawing& page) const {
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
      draw_cell(kinds[i], top, look, layer, page);
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

  void draw_cell(const Kind& kind, Vec2 top, const Look& look, Layer& layer, Drawing& page) const {
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
};

}  // namespace

BookPage PageMaker::make(const BuildStep& step, std::size_t number) const {
  return Page(*this, step).make(number);
}

}  // namespace burin::detail
