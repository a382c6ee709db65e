#include <burin/drawing/coincident.h>
#include <burin/drawing/views.h>
#include <burin/revisions/overlay.h>

#include "looks.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace burin {
namespace {

/// Paper mm: lines nearer to each other are one; stretches shorter than the other are none.
constexpr double kOneLine = 0.2, kLeast = 0.8;
/// Paper mm of a move that is worth an arrow, of its line and of its head.
constexpr double kLeastArrow = 2.5, kArrow = 0.35, kHead = 2.5, kHeadWidth = 1.4;

bool is_stroke_or_pattern(const Path& path) {
  return path.kind == LineClass::Stroke || path.kind == LineClass::Pattern;
}

class Overlay {
 public:
  Overlay(const RevisionDrawings& drawings, const Difference& difference, const SheetOfViews& sheet,
          const OverlayOptions& options, const RunContext& context)
      : before_(drawings.before),
        after_(drawings.after),
        difference_(difference),
        sheet_(sheet),
        options_(options),
        context_(context),
        layers_(drawings.after, out_.layers) {
    for (std::size_t i = 0; i < difference.parts.size(); ++i) {
      const PartMatch& match = difference.parts[i].match;
      if (match.before != kNoPart) of_before_[id(match.before)] = i;
      if (match.after != kNoPart) of_after_[id(match.after)] = i;
    }
  }

  Drawing run() {
    begin();
    add_areas();
    collect_changed();
    add_after();
    add_before();
    detail::sort_layers(out_.layers);
    add_arrows();
    for (Layer& layer : others_) out_.layers.push_back(std::move(layer));
    detail::lay_legend(out_, legend(), options_);
    add_items();
    return std::move(out_);
  }

 private:
  static std::int32_t id(std::size_t part) { return static_cast<std::int32_t>(part); }
  std::int32_t id_of_before(std::int32_t part) const {
    return part + static_cast<std::int32_t>(after_.parts.size());
  }

  void begin() {
    out_.paper_width = after_.paper_width;
    out_.paper_height = after_.paper_height;
    out_.ink_color = after_.ink_color;
    out_.paper_color = after_.paper_color;
    out_.seed = after_.seed;
    out_.title = after_.title;
    out_.style = after_.style;
    out_.view = after_.view;
    out_.views = after_.views;
    out_.parts = after_.parts;
    out_.diagnostics = after_.diagnostics;
    out_.stats = after_.stats;
    append_new(before_.diagnostics, out_.diagnostics);
    for (DrawingPart part : before_.parts) {
      part.id = id_of_before(part.id);
      out_.parts.push_back(std::move(part));
    }
  }

  const PartDifference* of(const std::map<std::int32_t, std::size_t>& known,
                           std::int32_t part) const {
    const auto found = known.find(part);
    return found == known.end() ? nullptr : &difference_.parts[found->second];
  }

  /// What is painted of parts of another look.
  void add_areas() {
    for (const Area& area : after_.areas) {
      const PartDifference* part = of(of_after_, area.part);
      if (part && part->match.look && !area.fill.empty()) out_.areas.push_back(area);
    }
  }

  /// The lines of parts that have changed, hidden ones too.
  void collect_changed() {
    const auto collect = [&](const Drawing& drawing,
                             const std::map<std::int32_t, std::size_t>& known,
                             std::map<std::size_t, LinesOnPaper>& lines) {
      for (const Layer& layer : drawing.layers) {
        for (const Path& path : layer.paths) {
          const PartDifference* part = of(known, path.source.part);
          if (!part || part->change() != PartChange::Changed || is_stroke_or_pattern(path))
            continue;
          context_.check();
          lines.try_emplace(known.at(path.source.part), kOneLine).first->second.add(path);
        }
      }
    };
    collect(before_, of_before_, lines_before_);
    collect(after_, of_after_, lines_after_);
  }

  bool shown(const Path& path) const { return path.visible || path.in_full || options_.hidden; }

  void add_after() {
    for (const Layer& layer : after_.layers) {
      Layer other{layer.name, {}, layer.texts, layer.color, layer.dashes};
      for (const Path& path : layer.paths) {
        const PartDifference* part = of(of_after_, path.source.part);
        if (!part) {
          other.paths.push_back(path);
        } else if (shown(path)) {
          add_after(*part, layer.name, path);
        }
      }
      // Circles of details and symbols of the sheet.
      if (!other.paths.empty() || !other.texts.empty()) others_.push_back(std::move(other));
    }
  }

  void add_after(const PartDifference& part, const std::string& layer, const Path& path) {
    switch (part.change()) {
      case PartChange::Changed:
        return add_changed(path, layer, lines_before_, of_after_, "changed-to", "changed-new");
      case PartChange::Moved:
        return layers_.add("moved-to", layer, path);
      default:
        return layers_.add(to_string(part.change()), layer, path);
    }
  }

  void add_before() {
    for (const Layer& layer : before_.layers) {
      for (const Path& path : layer.paths) {
        const PartDifference* part = of(of_before_, path.source.part);
        if (!part || !shown(path) || is_stroke_or_pattern(path)) continue;
        Path line = path;
        line.source.part = id_of_before(path.source.part);
        if (part->change() == PartChange::Changed) {
          add_changed(line, layer.name, lines_after_, of_before_, "", "changed-from",
                      path.source.part);
        } else if (part->change() == PartChange::Moved) {
          layers_.add("moved-from", layer.name, std::move(line));
        } else if (part->change() == PartChange::Removed) {
          layers_.add("removed", layer.name, std::move(line));
        }
      }
    }
  }

  /// Parts a line by those of the other revision; `on` empty: what lies on them is left out.
  void add_changed(const Path& path, const std::string& layer,
                   const std::map<std::size_t, LinesOnPaper>& others,
                   const std::map<std::int32_t, std::size_t>& known, const std::string& on,
                   const std::string& off, std::optional<std::int32_t> part = {}) {
    context_.check();
    if (is_stroke_or_pattern(path)) return layers_.add(on, layer, path);
    const auto lines = others.find(known.at(part.value_or(path.source.part)));
    if (lines == others.end()) return layers_.add(off, layer, path);
    PartedPath pieces = parted(path, lines->second, kLeast);
    for (Path& piece : pieces.off) layers_.add(off, layer, std::move(piece));
    if (on.empty()) return;
    for (Path& piece : pieces.on) layers_.add(on, layer, std::move(piece));
  }

  void add_arrows() {
    std::set<std::int32_t> seen;
    for (const Layer& layer : out_.layers) {
      for (const Path& path : layer.paths) seen.insert(path.source.part);
    }
    for (const PartDifference& part : difference_.parts) {
      if (!part.motion || !part.drawn_before || !part.drawn_after) continue;
      // What is hidden in both places has no arrow over what hides it.
      if (!seen.contains(id(part.match.after)) &&
          !seen.contains(id_of_before(id(part.match.before)))) {
        continue;
      }
      const Vec3 from = part.numbers_before->middle;
      for (const PlacedView& view : sheet_.views) {
        if (!view.within) add_arrow(view, from, from + part.motion->by, id(part.match.after));
      }
    }
  }

  void add_arrow(const PlacedView& view, Vec3 from3, Vec3 to3, std::int32_t part) {
    const Vec2 from = view.camera.to_paper(from3), to = view.camera.to_paper(to3);
    const double length = glm::distance(from, to);
    if (!(length >= kLeastArrow) || !view.box.contains(from) || !view.box.contains(to)) return;
    Layer& layer = layers_.named("moved-arrows", detail::look_of("moved-to"));
    const Vec2 way = (to - from) / length, neck = to - std::min(kHead, 0.6 * length) * way;
    const auto line = [&](Vec2 a, Vec2 b, std::vector<double> width) {
      Path path;
      path.kind = LineClass::Leader;
      path.source.part = part;
      path.points = {a, b};
      path.width = std::move(width);
      layer.paths.push_back(std::move(path));
    };
    line(from, neck, {kArrow});
    line(neck, to, {kHeadWidth, 0});
  }

  std::vector<detail::LegendEntry> legend() const {
    const auto count = [&](PartChange change) { return difference_.count(change); };
    std::vector<detail::LegendEntry> entries;
    const auto entry = [&](std::vector<std::string> groups, const char* word, std::size_t n) {
      if (n > 0) entries.push_back({std::move(groups), fmt::format("{} {}", n, word)});
    };
    entry({"added"}, "added", count(PartChange::Added));
    entry({"removed"}, "removed", count(PartChange::Removed));
    entry({"changed-to"}, "changed", count(PartChange::Changed));
    if (count(PartChange::Changed) > 0) {
      entries.push_back({{"changed-new"}, "its new lines"});
      entries.push_back({{"changed-from"}, "as it was"});
    }
    entry({"moved-from", "moved-to"}, "moved", count(PartChange::Moved));
    entry({"renamed"}, "renamed", count(PartChange::Renamed));
    entry({"look"}, "other look", count(PartChange::Look));
    entry({"same"}, "same", count(PartChange::Same));
    return entries;
  }

  void add_items() {
    int number = 0;
    for (const PartDifference& part : difference_.parts) {
      DrawingItem item{++number, part.after.empty() ? part.before : part.after, {}, {}, {}};
      item.color = part.match.after != kNoPart ? part.color_after : part.color_before;
      const auto add = [&](std::int32_t part_id, const std::vector<DrawingPart>& parts,
                           std::size_t index) {
        item.parts.push_back(part_id);
        if (item.source.empty() && index < parts.size()) item.source = parts[index].source;
      };
      if (part.match.after != kNoPart) {
        add(id(part.match.after), after_.parts, part.match.after);
      }
      if (part.match.before != kNoPart) {
        add(id_of_before(id(part.match.before)), before_.parts, part.match.before);
      }
      out_.items.push_back(std::move(item));
    }
  }

  const Drawing& before_;
  const Drawing& after_;
  const Difference& difference_;
  const SheetOfViews& sheet_;
  const OverlayOptions& options_;
  const RunContext& context_;
  Drawing out_;
  detail::Layers layers_;
  std::vector<Layer> others_;
  std::map<std::int32_t, std::size_t> of_before_, of_after_;
  std::map<std::size_t, LinesOnPaper> lines_before_, lines_after_;
};

}  // namespace

Drawing overlay(const RevisionDrawings& drawings, const Difference& difference,
                const SheetOfViews& sheet, const OverlayOptions& options,
                const RunContext& context) {
  return Overlay(drawings, difference, sheet, options, context).run();
}

}  // namespace burin
