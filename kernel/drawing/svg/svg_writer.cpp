#include <burin/drawing/bezier.h>
#include <burin/drawing/ink.h>
#include <burin/drawing/join.h>
#include <burin/drawing/ordered_text.h>
#include <burin/drawing/writers.h>

#include "svg_areas.h"
#include "svg_path.h"
#include "svg_tags.h"

#include <algorithm>
#include <deque>
#include <list>
#include <map>
#include <ostream>
#include <set>
#include <span>
#include <utility>

namespace burin {
namespace {

/// Whether most paths of a group are areas: how they are painted is said once.
bool mostly_areas(std::span<const Path* const> paths, const SvgOptions& options) {
  if (options.flatten) return false;
  const auto areas = std::ranges::count_if(paths, [](const Path* p) { return wants_area(*p); });
  return 2 * areas > std::ssize(paths);
}

void append_paint(Buffer& out, bool filled, std::string_view ink) {
  append(out, filled ? fmt::format(" fill=\"{}\" stroke=\"none\"", ink)
                     : fmt::format(" fill=\"none\" stroke=\"{}\"", ink));
}

/// What a path has to say of its pen inside a group. Each line tells its width: programs that
/// import SVG for its shapes (OpenSCAD) do not inherit it.
void append_own_pen(Buffer& out, bool filled, double width, bool group_filled, std::string_view ink,
                    std::string_view group_ink) {
  if (filled != group_filled) {
    append_paint(out, filled, ink);
  } else if (ink != group_ink) {
    append(out, fmt::format(" {}=\"{}\"", filled ? "fill" : "stroke", ink));
  }
  if (!filled) append_pen(out, width);
}

/// One path with the tags that come before it.
struct SvgItem {
  std::string before;
  const Path* path = nullptr;
  /// Of a closed outline: what it was made of.
  std::vector<const Path*> pieces = {};
  bool group_filled = false;
  /// Its colour, and that of the group which it stands in.
  std::string_view ink = {}, group_ink = {};
  /// Those of its layer, which are fitted to its length.
  const std::vector<double>* dashes = nullptr;
};

/// All paths in order; the last item has none, only the closing tags.
class Items {
 public:
  Items(const Drawing& drawing, const SvgOptions& options, const RunContext& context)
      : drawing_(drawing), options_(options) {
    name_parts();
    SvgIds ids(options.id_prefix);
    before_ = svg_head(drawing);
    for (const DrawingItem& item : drawing.items) {
      for (const std::int32_t part : item.parts) items_of_[part] = &item;
    }
    add_areas(ids);
    Vec2 pen(0);
    for (const InkLayer& layer : ink_layers(drawing)) {
      ink_ = ink_named(ink_color(layer, drawing));
      const std::string id = ids.make(layer.name);
      dashes_ = &layer_dashes_.emplace_back(layer.dashes(options.dashes));
      before_ += svg_layer_tag(layer, id, ink_, options);
      // Without the prefix, which each id gets once.
      const std::string stem = id.substr(options.id_prefix.size());
      std::map<int, Annotation> annotations;
      for (const Text* text : layer.texts) annotations[text->item].texts.push_back(text);
      const bool by_travel = options.order == LineOrder::Travel;
      std::vector<const Path*> lines;
      for (const auto& [part, paths] : layer.parts) {
        if (!by_travel) lines.clear();
        for (const Path* path : paths) {
          const bool laid_over = path->item != 0 || path->kind == LineClass::Frame;
          (laid_over ? annotations[path->item].paths : lines).push_back(path);
        }
        if (by_travel || lines.empty()) continue;
        add_part(part, ids.make(stem + "-" + part_name(part)), lines, layer.name == kOutlineLayer);
      }
      if (by_travel) add_lines(in_travel_order(lines, pen, context), false, ink_);
      for (const auto& [item, annotation] : annotations) add_annotation(item, annotation, ids);
      before_ += "</g>\n";
    }
    items_.push_back({before_ + "</svg>\n"});
  }

  const std::vector<SvgItem>& all() const { return items_; }

 private:
  /// What is laid over the drawing about an item.
  struct Annotation {
    std::vector<const Path*> paths;
    std::vector<const Text*> texts;
  };

  const DrawingItem* item_numbered(int number) const {
    const auto found = std::ranges::find(drawing_.items, number, &DrawingItem::number);
    return found == drawing_.items.end() ? nullptr : &*found;
  }

  /// A group as catalogues of spare parts know it.
  void add_annotation(int item, const Annotation& annotation, SvgIds& ids) {
    const bool callout = std::ranges::any_of(
        annotation.texts, [](const Text* text) { return text->role == "callout"; });
    Buffer out;
    if (item == 0) {
      append(out, "<g>");
    } else if (callout) {
      append(out, fmt::format("<g id=\"{}\" class=\"callout callout_{} hotspot_{}\" "
                              "data-item=\"{}\">",
                              ids.make(fmt::format("Hotspot.{}", item)), item, item, item));
      if (const DrawingItem* named = item_numbered(item)) {
        append(out, "<title>");
        append_xml(out, named->name);
        append(out, "</title>");
      }
    } else {
      append(out, fmt::format("<g class=\"row row_{}\" data-item=\"{}\">", item, item));
    }
    before_ += fmt::to_string(out) + "\n";
    for (const Path* path : annotation.paths) {
      items_.push_back({std::exchange(before_, {}), path, {}, false, ink_of_path(*path), ink_});
    }
    for (const Text* text : annotation.texts) {
      before_ += svg_text(*text, drawing_.paper_height, ink_, options_);
    }
    before_ += "</g>\n";
  }

  /// "a/b/c", as selectors have it.
  std::string path_of(std::int32_t part) const {
    for (const DrawingPart& known : drawing_.parts) {
      if (known.id != part) continue;
      std::string path;
      for (const std::string& name : known.assembly) path += name + "/";
      return path + known.name;
    }
    return {};
  }

  /// Silhouettes below all lines, for pointing and colouring; those that have a colour are painted.
  void add_areas(SvgIds& ids) {
    if (drawing_.areas.empty()) return;
    Buffer out;
    const std::string id = ids.make("areas");
    const SvgAreaClasses classes(drawing_);
    append(out, svg_area_rules(drawing_, classes, id, svg_ink(drawing_.ink_color)));
    append(out, fmt::format("<g id=\"{}\" fill=\"none\" stroke=\"none\" fill-rule=\"evenodd\" "
                            "pointer-events=\"all\">\n",
                            id));
    for (const Area& area : drawing_.areas) {
      append(out, "<path");
      append_part_class(out, area.part, "area", classes.of(area));
      append_area_fill(out, area);
      append(out, " d=\"");
      append_area_rings(out, area, drawing_.paper_height);
      append(out, "\"><title>");
      append_xml(out, area.part < 0 ? "shadow" : part_name(area.part));
      append(out, "</title></path>\n");
    }
    append(out, "</g>\n");
    before_ += fmt::to_string(out);
  }

  /// Of parts that have a number: class, item and path. `more`: other classes.
  void append_part_class(Buffer& out, std::int32_t part, std::string_view kind,
                         const std::string& more = {}) const {
    const auto it = items_of_.find(part);
    if (it == items_of_.end()) {
      if (!more.empty()) append(out, fmt::format(" class=\"{}\"", more));
      return;
    }
    const int number = it->second->number;
    append(out, fmt::format(" class=\"{} {}_{}{}{}\" data-item=\"{}\" data-path=\"", kind, kind,
                            number, more.empty() ? "" : " ", more, number));
    append_xml(out, path_of(part));
    out.push_back('"');
  }

  /// A part of the drawing that has a name.
  struct Named {
    std::string name;
    /// Its number among the parts of that name: the second in the scene is so in every layer.
    std::size_t same = 1;
  };

  void name_parts() {
    std::map<std::string_view, std::size_t> count;
    for (const DrawingPart& part : drawing_.parts) {
      if (part.name.empty()) continue;
      named_.try_emplace(part.id, Named{part.name, ++count[part.name]});
    }
  }

  /// A part's name in ids: it stays when other parts come or go.
  std::string part_name(std::int32_t part) const {
    const auto it = named_.find(part);
    if (it == named_.end()) return part < 0 ? "none" : fmt::format("{}", part);
    const auto& [name, same] = it->second;
    return same == 1 ? name : fmt::format("{}-{}", name, same);
  }

  /// A colour as it is written, for as long as the items are there.
  std::string_view ink_named(const std::string& color) {
    return *inks_.insert(svg_ink(color)).first;
  }

  std::string_view ink_of_path(const Path& path) {
    return path.color.empty() ? ink_ : ink_named(path.color);
  }

  /// That of all paths, else that of the layer.
  std::string_view common_ink(std::span<const Path* const> paths) {
    const std::string& color = paths.front()->color;
    const bool all = std::ranges::all_of(paths, [&](const Path* p) { return p->color == color; });
    return all ? ink_of_path(*paths.front()) : ink_;
  }

  void open_part(std::int32_t part, const std::string& id, bool filled, std::string_view ink) {
    Buffer out;
    append(out, fmt::format("<g id=\"{}\" data-part=\"{}\"", id, part));
    append_part_class(out, part, "part");
    // Lines are what the layer says.
    if (filled) {
      append_paint(out, true, ink);
    } else if (ink != ink_) {
      append(out, fmt::format(" stroke=\"{}\"", ink));
    }
    append(out, "><title>");
    if (const auto it = named_.find(part); it != named_.end()) {
      append_xml(out, it->second.name);
    } else {
      append(out, part < 0 ? std::string("no part") : fmt::format("part {}", part));
    }
    append(out, "</title>\n");
    before_ += fmt::to_string(out);
  }

  void add_part(std::int32_t part, const std::string& id, std::span<const Path* const> paths,
                bool joins) {
    JoinedPaths lines;
    if (joins) {
      lines = join_rings(paths);
    } else {
      lines.paths.assign(paths.begin(), paths.end());
      lines.pieces.resize(paths.size());
    }
    const bool filled = mostly_areas(lines.paths, options_);
    const std::string_view ink = common_ink(lines.paths);
    open_part(part, id, filled, ink);
    add_lines(std::move(lines), filled, ink);
    before_ += "</g>\n";
  }

  void add_lines(JoinedPaths lines, bool filled, std::string_view group_ink) {
    for (std::size_t i = 0; i < lines.paths.size(); ++i) {
      const Path* path = lines.paths[i];
      items_.push_back({std::exchange(before_, {}), path, std::move(lines.pieces[i]), filled,
                        ink_of_path(*path), group_ink, dashes_});
    }
    kept_.push_back(std::move(lines.made));
  }

  const Drawing& drawing_;
  const SvgOptions& options_;
  /// Of all layers and paths, and of the layer at hand.
  std::set<std::string> inks_;
  std::string_view ink_;
  std::list<std::vector<double>> layer_dashes_;
  const std::vector<double>* dashes_ = nullptr;
  std::string before_;
  std::vector<SvgItem> items_;
  std::list<std::deque<Path>> kept_;
  std::map<std::int32_t, Named> named_;
  std::map<std::int32_t, const DrawingItem*> items_of_;
};

/// "a b c", each once, without -1.
std::string list_of(const std::vector<const Path*>& pieces, std::int32_t SourceId::*member) {
  std::string text;
  std::set<std::int32_t> known{-1};
  for (const Path* piece : pieces) {
    const std::int32_t number = piece->source.*member;
    if (known.insert(number).second) text += fmt::format("{}{}", text.empty() ? "" : " ", number);
  }
  return text;
}

/// Lines that the path, or what it is joined of, stands for: "part/face/edge ...", each once.
void append_svg_also(Buffer& out, const SvgItem& item) {
  std::string text;
  std::set<SourceId> known;
  const auto add = [&](const Path& path) {
    for (const PathSource& also : path.also) {
      const SourceId& of = also.source;
      if (!known.insert(of).second) continue;
      text += fmt::format("{}{}/{}/{}", text.empty() ? "" : " ", of.part, of.face, of.edge);
    }
  };
  add(*item.path);
  for (const Path* piece : item.pieces) add(*piece);
  if (!text.empty()) fmt::format_to(fmt::appender(out), " data-also=\"{}\"", text);
}

void append_source(Buffer& out, const SvgItem& item) {
  const Path& p = *item.path;
  const char* kind = to_string(p.kind);
  fmt::format_to(
      fmt::appender(out),
      " class=\"{}\" data-part=\"{}\" data-face=\"{}\" data-edge=\"{}\" data-kind=\"{}\"", kind,
      p.source.part, p.source.face, p.source.edge, kind);
  append_svg_also(out, item);
  if (item.pieces.size() < 2) return;
  const std::string faces = list_of(item.pieces, &SourceId::face);
  const std::string edges = list_of(item.pieces, &SourceId::edge);
  if (!faces.empty()) fmt::format_to(fmt::appender(out), " data-faces=\"{}\"", faces);
  if (!edges.empty()) fmt::format_to(fmt::appender(out), " data-edges=\"{}\"", edges);
}

/// Dashes that begin and end with the line.
void append_own_dashes(Buffer& out, const SvgItem& item) {
  if (item.dashes) append_dashes(out, fitted_dashes(*item.dashes, *item.path));
}

void append_polyline(Buffer& out, SvgPen& pen, const SvgItem& item, double tolerance) {
  const Path& p = *item.path;
  std::vector<Vec2> all = p.points;
  if (p.closed) all.push_back(all.front());
  std::vector<Vec2> kept;
  for (const std::size_t i : simplify(all, tolerance)) kept.push_back(all[i]);
  append(out, "<polyline");
  append_source(out, item);
  append_own_pen(out, false, mean_width(p), item.group_filled, item.ink, item.group_ink);
  append_own_dashes(out, item);
  append(out, " points=\"");
  pen.points(kept);
  append(out, "\"/>\n");
}

void append_svg_path(Buffer& out, const SvgItem& item, double paper_height,
                     const SvgOptions& options) {
  SvgPen pen(out, paper_height);
  const Path& p = *item.path;
  if (options.flatten) return append_polyline(out, pen, item, options.fit_tolerance);
  const Ink ink = ink_of(p, curve_tolerance(options));
  append(out, "<path");
  append_source(out, item);
  append_own_pen(out, ink.filled, ink.width, item.group_filled, item.ink, item.group_ink);
  if (!ink.filled) append_own_dashes(out, item);
  append(out, " d=\"");
  for (const auto& chain : ink.chains) pen.chain(chain, ink.filled || p.closed);
  if (ink.chains.front().empty()) pen.dot(p.points.front());
  append(out, "\"/>\n");
}

}  // namespace

void write_svg(const Drawing& drawing, const SvgOptions& options, std::ostream& out,
               const RunContext& context) {
  if (options.merge) return write_merged_svg(drawing, options, out, context);
  const Items made(drawing, options, context);
  const std::vector<SvgItem>& items = made.all();
  write_ordered(
      items.size(), [&](std::size_t i) { return items[i].path ? items[i].path->points.size() : 0; },
      [&](std::size_t i, Buffer& buffer) {
        append(buffer, items[i].before);
        if (items[i].path) append_svg_path(buffer, items[i], drawing.paper_height, options);
      },
      out, context);
}

}  // namespace burin
