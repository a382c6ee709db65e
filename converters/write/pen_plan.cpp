#include "pen_plan.h"

#include <burin/drawing/clip.h>
#include <burin/drawing/font.h>
#include <burin/drawing/ink.h>
#include <burin/drawing/path_data.h>

#include "pen_lines.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace burin {
namespace {

/// Paper mm of width by which pens differ.
constexpr double kSamePen = 0.02;

/// The width that stands in the middle of those of a layer's lines (of its dots, where it has
/// nothing else); nothing where it has texts alone.
std::optional<double> width_of(const InkLayer& layer) {
  std::vector<double> lines, dots;
  for (const auto& [part, paths] : layer.parts) {
    for (const Path* path : paths) (is_dot(*path) ? dots : lines).push_back(mean_width(*path));
  }
  std::vector<double>& widths = lines.empty() ? dots : lines;
  if (widths.empty()) return std::nullopt;
  const auto middle = widths.begin() + static_cast<std::ptrdiff_t>(widths.size() / 2);
  std::nth_element(widths.begin(), middle, widths.end());
  return *middle;
}

/// A layer, or those of its lines that have a colour of their own.
struct PenLayer {
  InkLayer ink;
  std::string color = {};
};

/// Layers with ink, parted by the colours of their lines; texts stay with what has none.
std::vector<PenLayer> by_color(std::vector<InkLayer> layers) {
  std::vector<PenLayer> out;
  for (InkLayer& layer : layers) {
    std::map<std::string, std::map<std::int32_t, std::vector<const Path*>>> colors;
    if (!layer.texts.empty()) colors[""];
    for (const auto& [part, paths] : layer.parts) {
      for (const Path* path : paths) colors[path->color][part].push_back(path);
    }
    for (auto& [color, parts] : colors) {
      layer.parts = std::move(parts);
      out.push_back({layer, color});
      layer.texts.clear();
    }
  }
  return out;
}

class Planner {
 public:
  Planner(const Drawing& drawing, const PenOptions& pens, std::string_view format,
          const WriteOptions& options, const RunContext& context)
      : pens_(pens), format_(format), options_(options), context_(context) {
    sheet_.add(Vec2(0));
    sheet_.add(Vec2(drawing.paper_width, drawing.paper_height));
    layers_ = by_color(ink_layers(drawing));
    // Letters of annotations have lines around them.
    areas_ = static_cast<std::size_t>(std::ranges::count_if(
        painted_areas(drawing), [](const Area* area) { return area->role != "pmi"; }));
    stroked_ = std::ranges::any_of(
        drawing.layers, [](const Layer& layer) { return layer.name.starts_with("stroke"); });
  }

  PenPlan run() {
    choose_pens();
    for (std::size_t i = 0; i < layers_.size(); ++i) {
      if (pen_of_[i] > 0) add_layer(layers_[i].ink, group_of(pen_of_[i]), widths_[i]);
    }
    PenOrderOptions how;
    how.join = pens_.join;
    if (options_.progress) how.progress = [&](double share) { options_.progress(0.9 * share); };
    plan_.order = pen_order(plan_.paths, how, context_);
    if (options_.report) report_all(given_order(plan_.paths, Vec2(0), context_));
    return std::move(plan_);
  }

 private:
  void report(Severity severity, const char* code, std::size_t count, std::string message) {
    if (!options_.report) return;
    options_.report({severity, code, static_cast<std::int64_t>(count), std::move(message)});
  }

  std::uint32_t group_of(std::uint32_t number) const {
    const auto at = std::ranges::find(plan_.pens, number, &Pen::number);
    return static_cast<std::uint32_t>(at - plan_.pens.begin());
  }

  void choose_pens() {
    constexpr double kLetters = 0.1;  // of their height, as letters of type B have it
    for (const auto& [layer, color] : layers_) {
      const auto width = width_of(layer);
      widths_.push_back(width ? *width : kLetters * layer.texts.front()->height);
    }
    if (pens_.pens == "one") {
      pen_of_.assign(layers_.size(), 1);
    } else if (pens_.pens == "layers") {
      for (std::uint32_t i = 0; i < layers_.size(); ++i) pen_of_.push_back(i + 1);
    } else if (pens_.pens == "auto") {
      pens_by_width();
    } else {
      pens_by_list();
    }
    std::map<std::uint32_t, Pen> pens;
    std::map<std::uint32_t, std::set<std::string>> colors;
    for (std::size_t i = 0; i < layers_.size(); ++i) {
      if (pen_of_[i] == 0) continue;
      Pen& pen = pens[pen_of_[i]];
      if (pen.layers.empty()) pen.width = widths_[i];
      pen.number = pen_of_[i];
      pen.layers.push_back(layers_[i].ink.name);
      colors[pen_of_[i]].insert(layers_[i].color);
    }
    for (const auto& [number, of_pen] : colors) {
      if (of_pen.size() < 2) continue;
      report(Severity::Info, "pen.colors", of_pen.size(),
             fmt::format("pen {} draws lines of {} colours in one; {}.pens=auto gives each its own",
                         number, of_pen.size(), format_));
    }
    for (auto& [number, pen] : pens) plan_.pens.push_back(std::move(pen));
  }

  /// The widest pen is the first; of pens of one width that of no colour of its own.
  void pens_by_width() {
    std::vector<double> sorted = widths_;
    std::ranges::sort(sorted, std::greater<>());
    std::vector<double> widest;
    for (const double width : sorted) {
      if (widest.empty() || width < widest.back() - kSamePen) widest.push_back(width);
    }
    using Kind = std::pair<std::ptrdiff_t, std::string>;
    std::vector<Kind> kinds;
    for (std::size_t i = 0; i < layers_.size(); ++i) {
      const auto wider = std::ranges::count_if(widest, [&](double w) { return w >= widths_[i]; });
      kinds.emplace_back(wider, layers_[i].color);
    }
    const std::set<Kind> pens(kinds.begin(), kinds.end());
    for (const Kind& kind : kinds) {
      const auto pen = std::distance(pens.begin(), pens.find(kind)) + 1;
      pen_of_.push_back(static_cast<std::uint32_t>(pen));
    }
  }

  void pens_by_list() {
    std::vector<std::string_view> unnamed, left_out;
    const auto once = [](std::vector<std::string_view>& names, std::string_view name) {
      if (names.empty() || names.back() != name) names.push_back(name);
    };
    for (const auto& [layer, color] : layers_) {
      const auto pen = listed_pen(pens_.pens, layer.name);
      if (!pen) once(unnamed, layer.name);
      if (pen == 0U) once(left_out, layer.name);
      pen_of_.push_back(pen.value_or(1));
    }
    if (!unnamed.empty()) {
      report(Severity::Warning, "pen.unnamed", unnamed.size(),
             fmt::format(
                 "{}.pens names no pen for {}: pen 1 draws it; add *=1, or *=0 to leave it out",
                 format_, fmt::join(unnamed, ", ")));
    }
    if (!left_out.empty()) {
      report(Severity::Info, "pen.left_out", left_out.size(),
             fmt::format("{} is left out: {}.pens gives it pen 0", fmt::join(left_out, ", "),
                         format_));
    }
  }

  void add_layer(const InkLayer& layer, std::uint32_t group, double width) {
    const std::vector<double> dashes = layer.dashes(options_.svg.dashes);
    for (const auto& [part, paths] : layer.parts) {
      for (const Path* path : paths) {
        context_.check();
        add_path(*path, group, width, fitted_dashes(dashes, *path));
      }
    }
    for (const Text* text : layer.texts) {
      for (std::vector<Vec2>& outline : text_outlines(*text, kThinned)) {
        if (outline.size() > 1) add_closed(std::move(outline), group);
      }
    }
  }

  void add_path(const Path& path, std::uint32_t group, double pen,
                const std::vector<double>& dashes) {
    if (is_dot(path)) return add_dot(path, group, pen);
    if (has_varying_width(path)) {
      // The head of an arrow is what it is by its width.
      if (path.kind == LineClass::Leader) return add_outlines(path, group);
      ++swelling_;
    }
    add_clipped(path, group, dashes);
  }

  void add_dot(const Path& path, std::uint32_t group, double pen) {
    const double width = mean_width(path);
    const Vec2 middle = 0.5 * (path.points.front() + path.points.back());
    if (!sheet_.contains(middle)) {
      ++cut_;
      return;
    }
    std::vector<std::vector<Vec2>> circles;
    if (path.kind != LineClass::Stroke) circles = disc_of(middle, width, pen);
    // Dots of a tone are as large as the pen that is put down makes them.
    if (circles.empty() && std::abs(width - pen) > kSamePen) ++other_dots_;
    if (circles.empty()) return add({middle, middle}, false, group, -1);
    for (std::vector<Vec2>& circle : circles) add_closed(std::move(circle), group);
  }

  void add_outlines(const Path& path, std::uint32_t group) {
    for (auto& chain : ink_of(path, kThinned).chains) {
      add_closed(flattened(Subpath{std::move(chain), true}, kThinned), group);
    }
  }

  void add_closed(std::vector<Vec2> points, std::uint32_t group) {
    Path ring;
    ring.closed = true;
    ring.points = std::move(points);
    add_clipped(ring, group, {});
  }

  void add_clipped(const Path& path, std::uint32_t group, const std::vector<double>& dashes) {
    if (lies_in(path, sheet_)) return add_line(path, group, dashes);
    ++cut_;
    for (const Path& piece : clipped(path, sheet_)) add_line(piece, group, dashes);
  }

  void add_line(const Path& path, std::uint32_t group, const std::vector<double>& dashes) {
    std::vector<Vec2> all = path.points;
    if (path.closed) all.push_back(all.front());
    if (!dashes.empty()) {
      for (std::vector<Vec2>& piece :
           pens_.arcs ? dashes_along(all, dashes) : dashes_of(thinned(all), dashes)) {
        add(std::move(piece), false, group, -1);
      }
      return;
    }
    std::vector<Vec2> line = thinned(all);
    const bool closed = path.closed && line.size() > 3;
    if (closed) line.pop_back();
    add(std::move(line), closed, group, 0);
  }

  void add(std::vector<Vec2> points, bool closed, std::uint32_t group, std::int64_t mark) {
    plan_.points.push_back(std::move(points));
    plan_.paths.push_back({plan_.points.back(), closed, group, mark});
  }

  void report_all(const PenOrder& given) {
    if (plan_.paths.empty()) {
      report(Severity::Warning, "pen.empty", 1,
             "there is no line on the sheet that a pen could draw");
    }
    if (areas_ > 0) {
      report(
          Severity::Warning, "pen.fills", areas_,
          fmt::format("a pen draws lines alone: the colours of {} areas are left out; "
                      "fill.hatch=lines hatches areas (with fill.opacity=0 and "
                      "fill.hatch_color=fill in their colours){}",
                      areas_, stroked_ ? "" : ", hatch.enabled=true draws strokes in the shade"));
    }
    if (cut_ > 0) {
      report(Severity::Warning, "pen.cut", cut_,
             fmt::format("{} lines run off the sheet and are cut at its edge", cut_));
    }
    if (swelling_ > 0) {
      report(
          Severity::Warning, "pen.width", swelling_,
          fmt::format("a pen draws every line in one width: {} lines whose width varies are drawn "
                      "along their middle; the style plotter shades by their distance alone",
                      swelling_));
    }
    if (other_dots_ > 0) {
      report(Severity::Warning, "pen.dots", other_dots_,
             fmt::format(
                 "a pen that is put down makes dots of one size: {} dots are larger or smaller "
                 "in the drawing",
                 other_dots_));
    }
    report(
        Severity::Info, "pen.travel", plan_.order.lines.size(),
        fmt::format("{} lines of {:.2f} m; the pen travels {:.2f} m between them ({:.2f} m in the "
                    "order of the drawing)",
                    plan_.order.lines.size(), plan_.order.drawn / 1000, plan_.order.travel / 1000,
                    given.travel / 1000));
  }

  const PenOptions& pens_;
  std::string format_;
  const WriteOptions& options_;
  const RunContext& context_;
  Box2 sheet_;
  std::vector<PenLayer> layers_;
  std::vector<double> widths_;         // of each layer
  std::vector<std::uint32_t> pen_of_;  // of each layer
  PenPlan plan_;
  std::size_t cut_ = 0, swelling_ = 0, other_dots_ = 0, areas_ = 0;
  bool stroked_ = false;
};

}  // namespace

bool PenPlan::goes_on(std::size_t line, Vec2 before, Vec2 first, double join) const {
  const auto whole = [&](const PenLine& l) {
    return paths[order.runs[l.first_run].path].mark >= 0;
  };
  return line > 0 && order.lines[line].group == order.lines[line - 1].group &&
         whole(order.lines[line]) && whole(order.lines[line - 1]) &&
         glm::distance(before, first) <= join;
}

std::vector<CurvePiece> pen_pieces(const PenLine& line, const PenPlan& plan, bool arcs) {
  std::vector<Vec2> points = points_of(line, plan.order, plan.paths);
  if (line.closed) points.push_back(points.front());
  if (!arcs) return {{std::move(points), std::nullopt}};
  std::vector<CurvePiece> pieces = fit_arcs(points, false, {kThinned, kChords, false, true});
  // Dashes come with all of their points.
  for (CurvePiece& piece : pieces) {
    if (!piece.arc) piece.points = thinned(piece.points);
  }
  return pieces;
}

PenPlan plan_pens(const Drawing& drawing, const PenOptions& pens, std::string_view format,
                  const WriteOptions& options, const RunContext& context) {
  check_pens(format, pens);
  return Planner(drawing, pens, format, options, context).run();
}

}  // namespace burin
