#include "sheet_dimensions.h"

#include <burin/base/error.h>
#include <burin/base/plugin_error.h>
#include <burin/camera/view_grid.h>
#include <burin/illustrate/ground.h>
#include <burin/illustrate/illustrate.h>

#include "overall.h"
#include "rows/measured_rows.h"
#include "rows/row_text.h"
#include "wanted_views.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace burin::detail {
namespace {

/// Names of views as messages list them.
std::string names_of(const std::vector<SheetView>& views) {
  std::vector<std::string> names;
  for (const SheetView& view : views) names.push_back(view.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

bool is_cut_away(const MeasuredRow& row, std::size_t scene) {
  // Features of one target of a note stand for each other.
  std::map<std::size_t, bool> left;
  for (std::size_t k = 0; k < row.target.size(); ++k) {
    left[row.target[k]] |= row.parts[k] == MeasuredRow::kNoPart || row.there[scene][k];
  }
  if (row.row.kind == DimensionRow::Kind::Note) {
    return std::ranges::any_of(left, [](const auto& one) { return !one.second; });
  }
  for (std::size_t k = 0; k < row.of.size(); ++k) {
    if (row.parts[k] != MeasuredRow::kNoPart && !row.there[scene][k]) return true;
  }
  return false;
}

/// Of the sheet within its margin: what dimensions may take on both sides of a view together.
constexpr double kMostRoom = 0.7;

Vec2 most_room(const Illustration& illustration) {
  if (illustration.sheet.fits) return Vec2(std::numeric_limits<double>::infinity());
  const Box2 inner = inside(illustration.view.paper, illustration.sheet.margin);
  return kMostRoom * glm::max(inner.size(), Vec2(0));
}

void shrink(double& a, double& b, double most) {
  if (!(a + b > most)) return;
  const double share = most / (a + b);
  a *= share;
  b *= share;
}

/// What a user may do to see a row.
std::string advice(const MeasuredRow& row, const FeatureSight& sight,
                   const DimensionOptions& style) {
  bool hidden = false;
  for (const char* name : {"front", "top", "left", "right", "back", "bottom"}) {
    const NamedView named = view_in_grid(name);
    const ViewOptions view{.direction = named.direction, .up = named.up};
    const auto shown = row_in_view(row, {axes_of(view)}, sight, style);
    if (!shown) continue;
    if (shown->seen) return fmt::format(": add {} to `views`", name);
    hidden = true;
  }
  return hidden ? ": cut it open (`section`) or draw hidden lines (`hidden`)" : "";
}

}  // namespace

Margin larger(const Margin& a, const Margin& b) {
  return {std::max(a.top, b.top), std::max(a.right, b.right), std::max(a.bottom, b.bottom),
          std::max(a.left, b.left)};
}

bool holds(const Margin& a, const Margin& b) {
  constexpr double kRounding = 1e-6;  // paper mm
  return a.top >= b.top - kRounding && a.right >= b.right - kRounding &&
         a.bottom >= b.bottom - kRounding && a.left >= b.left - kRounding;
}

SheetDimensions::SheetDimensions(Scene& scene, const Illustration& illustration,
                                 std::vector<SheetView> views)
    : style_(illustration.style.dimension),
      sights_(illustration.sights),
      most_(most_room(illustration)),
      views_(std::move(views)),
      lists_(views_.size()),
      beside_(views_.size()) {
  const bool overall = illustration.overall_dimensions && illustration.whole;
  if (!overall && illustration.measured.empty()) return;
  if (illustration.view.perspective) {
    scene.diagnostics.add(Severity::Warning, "dimensions.not_drawn", 1,
                          "a perspective view has no dimensions or notes: leave `perspective` out");
    return;
  }
  drawn_ = drawn_bounds(scene, illustration.illustrate.part_styles);
  if (overall && illustration.left_parts) {
    for (SheetView& view : views_) view.reaches = view.broken.reaches(*illustration.left_parts);
  }
  deal(scene, illustration);
  keep_clear_of_annotations(scene, illustration);
}

void SheetDimensions::keep_clear_of_annotations(const Scene& scene,
                                                const Illustration& illustration) {
  for (std::size_t i = 0; i < views_.size(); ++i) {
    if (lists_[i].empty()) continue;
    const MeasuringView& view = views_[i].as;
    const Scene& shown =
        view.scene == 0 ? scene : *illustration.section_views[view.scene - 1].scene;
    const Mat3 sides = glm::transpose(view.axes);
    beside_[i] = annotation_lines(shown, illustration.illustrate.part_styles,
                                  illustration.style.pmi, {.direction = sides[2], .up = sides[1]});
    if (beside_[i].empty()) continue;
    // The other side may have none of them.
    for (Dimension& one : lists_[i]) {
      if (one.overall && is_seen_square(view.axes, one.to - one.from)) one.outwards = Vec3(0);
    }
  }
}

void SheetDimensions::deal(Scene& scene, const Illustration& illustration) {
  for (const MeasuredRow& row : illustration.measured) deal_row(scene, row);
  const std::vector<OverallShares> shares = share_overall(scene, illustration, drawn_, views_);
  for (std::size_t i = 0; i < views_.size(); ++i) {
    std::ranges::move(overall_of_view(drawn_, views_[i].as.axes, shares[i], style_),
                      std::back_inserter(lists_[i]));
  }
}

void SheetDimensions::write_note(const MeasuredRow& row, Dimension& note, Scene& scene) const {
  try {
    note.label = note_label(row, style_);
  } catch (const PluginError& e) {
    scene.diagnostics.add(Severity::Warning, "plugin.quarantined", 1,
                          std::string(e.what()) + "; the words of the note are drawn alone");
    note.label = note_words(row, style_);
  }
}

void SheetDimensions::deal_row(Scene& scene, const MeasuredRow& row) {
  const std::string& wanted = row.row.view;
  const auto is_wanted = [&](const SheetView& view) {
    return wanted.empty() || view.name == wanted;
  };
  if (std::ranges::none_of(views_, is_wanted)) {
    throw UsageError(fmt::format("{}{}: no view is called '{}': there is {}", row.row.place,
                                 called(row), wanted, names_of(views_)));
  }
  std::optional<RowInView> best;
  std::size_t where = 0;
  bool cut = true, left_out = false;
  std::vector<std::string> hidden_in;
  for (std::size_t i = 0; i < views_.size(); ++i) {
    if (best && best->rank == 0) break;  // no other shows it better
    if (!is_wanted(views_[i])) continue;
    const MeasuringView& view = views_[i].as;
    cut &= is_cut_away(row, view.scene);
    std::optional<RowInView> shown = row_in_view(row, view, *sights_[view.scene], style_);
    if (!shown) continue;
    if (!shown->seen && !view.hidden_lines) {
      hidden_in.push_back(views_[i].name);
      if (wanted.empty()) continue;
    }
    if (best && shown->rank >= best->rank) continue;
    if (!views_[i].broken.put_where_seen(shown->dimension)) {
      left_out = true;
      continue;
    }
    best = std::move(shown);
    where = i;
  }
  const char* what =
      row.row.kind == DimensionRow::Kind::Note ? "what it points at" : "what it measures";
  if (best) {
    if (row.row.kind == DimensionRow::Kind::Note) write_note(row, best->dimension, scene);
    lists_[where].push_back(std::move(best->dimension));
    if (hidden_in.empty() || wanted.empty()) return;
    return tell_of(row, "dimensions.hidden",
                   fmt::format("is drawn in the view {}, where {} is hidden", wanted, what),
                   scene.diagnostics);
  }
  std::string why = fmt::format("a section takes {} away", what);
  if (left_out) {
    why = fmt::format("the break leaves out {}", what);
  } else if (!cut && !wanted.empty()) {
    why = fmt::format("the view {} does not show it as it is", wanted);
  } else if (!cut) {
    why = hidden_in.empty()
              ? "no view of the sheet shows it as it is"
              : fmt::format("{} is hidden in the {} {}", what,
                            hidden_in.size() > 1 ? "views" : "view", fmt::join(hidden_in, ", "));
    why += advice(row, *sights_.front(), style_);
  }
  tell_of(row, "dimensions.not_drawn", "is not drawn: " + why, scene.diagnostics);
}

ViewDimensions SheetDimensions::of_view(std::size_t i, const Margin& taken) const {
  return {lists_[i], drawn_, beside_[i], taken};
}

Margin SheetDimensions::room(std::size_t i, const ViewDimensions& dimensions, const Box3& extent,
                             double scale) const {
  // What has a place of its own on the sheet takes none beside the view.
  ViewDimensions beside = dimensions;
  std::erase_if(beside.list, [](const Dimension& one) { return one.place.has_value(); });
  if (beside.list.empty()) return dimensions.taken;
  const Box2 laid = lay_out(beside, {views_[i].as.axes, scale, Vec2(0)}, style_).box;
  const Vec2 low = scale * Vec2(extent.min), high = scale * Vec2(extent.max);
  Margin room = larger(dimensions.taken, {laid.max.y - high.y, laid.max.x - high.x,
                                          low.y - laid.min.y, low.x - laid.min.x});
  shrink(room.left, room.right, most_.x);
  shrink(room.bottom, room.top, most_.y);
  return room;
}

}  // namespace burin::detail
