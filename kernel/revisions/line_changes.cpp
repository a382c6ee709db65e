#include <burin/drawing/coincident.h>
#include <burin/drawing/length.h>
#include <burin/drawing/views.h>
#include <burin/revisions/line_changes.h>

#include "fill_changes.h"
#include "looks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

namespace burin {
namespace {

/// Paper mm from where a line was that it may have moved, and how much of its length it may have
/// lost or gained.
constexpr double kFarthest = 20, kStretched = 0.2;

/// Paper mm between the legend and the drawing above it.
constexpr double kAboveLegend = 2;

bool is_stroke(const Path& path) { return path.kind == LineClass::Stroke; }

double whole_length(const Path& path) {
  const double length = length_of(path);
  return path.closed ? length + glm::distance(path.points.back(), path.points.front()) : length;
}

double length_of(const std::vector<Path>& pieces) {
  double sum = 0;
  for (const Path& piece : pieces) sum += whole_length(piece);
  return sum;
}

/// Features and strokes of a drawing, apart.
struct Lines {
  LinesOnPaper features, strokes;

  Lines(const Drawing& drawing, double tolerance, const RunContext& context)
      : features(tolerance), strokes(tolerance) {
    for (const Layer& layer : drawing.layers) {
      for (const Path& path : layer.paths) {
        context.check();
        if (path.visible && path.points.size() > 1) {
          (is_stroke(path) ? strokes : features).add(path);
        }
      }
    }
  }
  const LinesOnPaper& of(const Path& path) const { return is_stroke(path) ? strokes : features; }
};

/// A path that lies elsewhere than all lines of the other drawing.
struct Other {
  ChangedLine line;
  const Path* path = nullptr;
};

/// Calls `each(path, layer index, path index)` for the paths that count.
template <class Each>
void for_each_line(const Drawing& drawing, const RunContext& context, const Each& each) {
  for (std::size_t l = 0; l < drawing.layers.size(); ++l) {
    for (std::size_t p = 0; p < drawing.layers[l].paths.size(); ++p) {
      context.check();
      const Path& path = drawing.layers[l].paths[p];
      if (path.visible && path.points.size() > 1) each(path, l, p);
    }
  }
}

/// Largest distance of the points of one line from another.
double apart(const Path& a, const Path& b) {
  LinesOnPaper lines(kFarthest / 8);
  lines.add(b);
  double most = 0;
  for (const Vec2& p : a.points) most = std::max(most, lines.distance(p, kFarthest));
  return most;
}

/// Which of the lines that are gone may be this one: name and numbers of its source.
using Source = std::tuple<std::string, LineClass, std::int32_t, std::int32_t>;

class Comparison {
 public:
  Comparison(const Drawing& before, const Drawing& after, double tolerance,
             const RunContext& context)
      : before_(before), after_(after), context_(context) {
    out_.tolerance = tolerance;
  }

  LineDifference run() {
    const double least = 2 * out_.tolerance;
    const Lines was(before_, out_.tolerance, context_), is(after_, out_.tolerance, context_);
    std::vector<Other> gone = others(before_, is, least, LineChange::Gone, false);
    std::vector<Other> added = others(after_, was, least, LineChange::New, true);
    pair_moved(gone, added);
    for (const std::vector<Other>* list : {&added, &gone}) {
      for (const Other& one : *list) {
        const auto change = static_cast<std::size_t>(one.line.change);
        ++out_.counts[change];
        out_.lengths[change] += one.line.length;
        out_.lines.push_back(one.line);
      }
    }
    compare_texts();
    out_.fills = detail::compare_fills(before_, after_, out_.tolerance, context_);
    out_.inks = detail::compare_inks(before_, after_);
    out_.same_sheet =
        before_.paper_width == after_.paper_width && before_.paper_height == after_.paper_height;
    return std::move(out_);
  }

 private:
  std::vector<Other> others(const Drawing& drawing, const Lines& lines, double least,
                            LineChange change, bool counts) {
    std::vector<Other> list;
    for_each_line(drawing, context_, [&](const Path& path, std::size_t l, std::size_t p) {
      const PartedPath pieces = parted(path, lines.of(path), least);
      if (counts) out_.lengths[static_cast<std::size_t>(LineChange::Same)] += length_of(pieces.on);
      if (pieces.off.empty()) {
        if (counts) ++out_.counts[static_cast<std::size_t>(LineChange::Same)];
        return;
      }
      ChangedLine line{change,
                       drawing.layers[l].name,
                       detail::part_name(drawing, path.source.part),
                       path.kind,
                       l,
                       p,
                       length_of(pieces.off),
                       0};
      list.push_back({std::move(line), &path});
    });
    return list;
  }

  /// Takes lines that have moved out of those that are gone.
  void pair_moved(std::vector<Other>& gone, std::vector<Other>& added) {
    std::multimap<Source, std::size_t> known;
    const auto source = [](const Other& one) {
      const SourceId& id = one.path->source;
      return Source(one.line.part, one.line.kind, id.face, id.edge);
    };
    const auto has_source = [](const Other& one) {
      return !is_stroke(*one.path) && (one.path->source.face >= 0 || one.path->source.edge >= 0);
    };
    for (std::size_t i = 0; i < gone.size(); ++i) {
      if (has_source(gone[i])) known.emplace(source(gone[i]), i);
    }
    std::vector<bool> moved(gone.size(), false);
    constexpr int kMostTried = 64;
    for (Other& one : added) {
      if (!has_source(one)) continue;
      const auto [first, last] = known.equal_range(source(one));
      const double length = whole_length(*one.path);
      std::optional<std::size_t> best;
      double least = kFarthest;
      int tried = 0;
      for (auto it = first; it != last && tried < kMostTried; ++it, ++tried) {
        if (moved[it->second]) continue;
        const Path& other = *gone[it->second].path;
        if (std::abs(whole_length(other) - length) > kStretched * length) continue;
        context_.check();
        const double far = std::max(apart(*one.path, other), apart(other, *one.path));
        if (far < least) least = far, best = it->second;
      }
      if (!best) continue;
      moved[*best] = true;
      one.line.change = LineChange::Moved;
      one.line.distance = least;
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < gone.size(); ++i) {
      if (!moved[i]) gone[kept++] = gone[i];
    }
    gone.resize(kept);
  }

  void compare_texts() {
    const auto lacking = [&](const Drawing& drawing, const Drawing& other) {
      std::multimap<std::string, Vec2> known;
      for (const Layer& layer : other.layers) {
        for (const Text& text : layer.texts) known.emplace(text.text, text.at);
      }
      std::vector<Text> texts;
      for (const Layer& layer : drawing.layers) {
        for (const Text& text : layer.texts) {
          const auto [first, last] = known.equal_range(text.text);
          const auto found = std::find_if(first, last, [&](const auto& one) {
            return glm::distance(one.second, text.at) <= out_.tolerance;
          });
          if (found == last) {
            texts.push_back(text);
          } else {
            known.erase(found);
          }
        }
      }
      return texts;
    };
    out_.texts_new = lacking(after_, before_);
    out_.texts_gone = lacking(before_, after_);
  }

  const Drawing& before_;
  const Drawing& after_;
  const RunContext& context_;
  LineDifference out_;
};

}  // namespace

const char* to_string(LineChange change) {
  switch (change) {
    case LineChange::New:
      return "new";
    case LineChange::Gone:
      return "gone";
    case LineChange::Moved:
      return "moved";
    case LineChange::Same:
      break;
  }
  return "same";
}

LineDifference compare_drawings(const Drawing& before, const Drawing& after, double tolerance,
                                const RunContext& context) {
  return Comparison(before, after, tolerance, context).run();
}

namespace {

/// Where the ink of a drawing begins below, paper mm; its height where it has none.
double foot_of(const Drawing& drawing) {
  double foot = drawing.paper_height;
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      for (const Vec2 p : path.points) foot = std::min(foot, p.y);
    }
    for (const Text& text : layer.texts) foot = std::min(foot, text.at.y);
  }
  return foot;
}

/// How many parts there are.
std::size_t parts_of(const std::vector<ChangedFill>& fills) {
  std::set<std::string> parts;
  for (const ChangedFill& fill : fills) parts.insert(fill.part);
  return parts.size();
}

/// Makes the sheet higher by so many mm, which are free below.
void raise(Drawing& drawing, double by) {
  drawing.paper_height += by;
  drawing.view.offset.y += by;
  for (Layer& layer : drawing.layers) {
    for (Path& path : layer.paths) {
      for (Vec2& p : path.points) p.y += by;
    }
    for (Text& text : layer.texts) text.at.y += by;
  }
  for (Area& area : drawing.areas) {
    for (std::vector<Vec2>& ring : area.rings) {
      for (Vec2& p : ring) p.y += by;
    }
  }
}

}  // namespace

Drawing overlay(const RevisionDrawings& drawings, const LineDifference& difference,
                const OverlayOptions& options, const RunContext& context) {
  const Drawing &before = drawings.before, &after = drawings.after;
  Drawing out;
  out.paper_width = std::max(before.paper_width, after.paper_width);
  out.paper_height = std::max(before.paper_height, after.paper_height);
  out.ink_color = after.ink_color;
  out.paper_color = after.paper_color;
  out.seed = after.seed;
  out.style = after.style;
  out.title = after.title;
  out.view = after.view;
  out.parts = after.parts;
  out.stats = after.stats;
  detail::Layers layers(after, out.layers);
  const Lines was(before, difference.tolerance, context), is(after, difference.tolerance, context);
  const double least = 2 * difference.tolerance;
  std::map<std::pair<std::size_t, std::size_t>, const ChangedLine*> changed;
  for (const ChangedLine& line : difference.lines) {
    if (line.change != LineChange::Gone) changed[{line.layer_index, line.path_index}] = &line;
  }
  for_each_line(after, context, [&](const Path& path, std::size_t l, std::size_t p) {
    const auto found = changed.find({l, p});
    const std::string& name = after.layers[l].name;
    if (found == changed.end()) return layers.add("same", name, path);
    const bool moved = found->second->change == LineChange::Moved;
    PartedPath pieces = parted(path, was.of(path), least);
    for (Path& piece : pieces.on) layers.add("same", name, std::move(piece));
    for (Path& piece : pieces.off) layers.add(moved ? "moved-to" : "new", name, std::move(piece));
  });
  for_each_line(before, context, [&](const Path& path, std::size_t l, std::size_t) {
    PartedPath pieces = parted(path, is.of(path), least);
    for (Path& piece : pieces.off) {
      piece.source = {};  // parts of the new drawing have these numbers
      layers.add("gone", before.layers[l].name, std::move(piece));
    }
  });
  const auto add_texts = [&](const std::string& group, const std::vector<Text>& texts) {
    if (texts.empty()) return;
    Layer& layer = layers.named(group + "-texts", detail::look_of(group));
    layer.texts.insert(layer.texts.end(), texts.begin(), texts.end());
  };
  std::vector<Text> same;
  for (const Layer& layer : after.layers) {
    for (const Text& text : layer.texts) {
      const auto is_new = [&](const Text& one) {
        return one.text == text.text && one.at == text.at;
      };
      if (std::ranges::none_of(difference.texts_new, is_new)) same.push_back(text);
    }
  }
  add_texts("same", same);
  add_texts("gone", difference.texts_gone);
  add_texts("new", difference.texts_new);
  detail::FillPicture fills = detail::picture_of(difference.fills, before, after);
  out.areas = std::move(fills.areas);
  for (Path& border : fills.borders) layers.add("look", "fills", std::move(border));
  detail::sort_layers(out.layers);
  std::vector<detail::LegendEntry> entries;
  const auto entry = [&](const char* group, LineChange change, const char* word) {
    const std::size_t n = difference.counts[static_cast<std::size_t>(change)];
    if (n > 0)
      entries.push_back({{group}, fmt::format("{} line{} {}", n, n == 1 ? "" : "s", word)});
  };
  entry("new", LineChange::New, "new");
  entry("gone", LineChange::Gone, "gone");
  entry("moved-to", LineChange::Moved, "moved");
  if (const std::size_t n = parts_of(difference.fills); n > 0) {
    entries.push_back({{"look"}, fmt::format("{} of other colours", n)});
  }
  entry("same", LineChange::Same, "same");
  Drawing legend;
  legend.paper_width = out.paper_width;
  legend.ink_color = out.ink_color;
  legend.paper_color = out.paper_color;
  const double top = detail::lay_legend(legend, entries, options) + kAboveLegend;
  // Finished drawings have left no room for it.
  if (const double foot = foot_of(out); foot < top) raise(out, top - foot);
  std::ranges::move(legend.layers, std::back_inserter(out.layers));
  append_new(after.diagnostics, out.diagnostics);
  return out;
}

}  // namespace burin
