#include <burin/drawing/ink.h>
#include <burin/drawing/length.h>
#include <burin/drawing/one_line.h>

#include "curves/path_piece.h"
#include "path_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

namespace burin {
namespace {

/// Paper mm: shorter stretches on another line are crossings at a small angle, or ends.
constexpr double kLeastOn = 0.2;
/// Paper mm: what is left of a line between stretches that lie on others, or at its end.
constexpr double kSpeck = 0.15;
/// Paper mm along a line from which on it does not lie on itself because it is one line.
constexpr double kFarAlong = 0.2;
/// The owner of stretches that a line has laid down itself.
constexpr std::size_t kItself = std::numeric_limits<std::size_t>::max();

/// A stretch along a path, from index and share of a segment to another, and whose line it is on.
struct LineStretch {
  double begin = 0, end = 0;
  std::size_t owner = 0;
};

/// A line that is drawn, or a piece of one.
struct Drawn {
  Path path;
  /// Where it stands: its layer, and the number of what it was made of.
  std::size_t layer = 0, number = 0;
};

bool is_line(const Layer& layer, const Path& path) {
  const bool over = path.kind == LineClass::Leader || path.kind == LineClass::Frame;
  return layer.name != "pattern" && path.kind != LineClass::Stroke &&
         path.kind != LineClass::Pattern && !over && path.points.size() > 1 && is_finite(path);
}

/// Small comes first.
auto rank_of(const Path& path, const Layer& layer) {
  const int hidden = path.visible ? 0 : path.in_full ? 1 : 2;
  const int over = layer.name == kCentreLayer ? 2 : layer.name == kTrailLayer ? 1 : 0;
  // Widths within a tenth of a mm's hundredth are one.
  return std::tuple(over, hidden, -std::llround(1000 * mean_width(path)));
}

/// The lines that stay.
class Sheet {
 public:
  explicit Sheet(const RunContext& context) : context_(context), grid_(kSameLine) {}

  void add(const Path& path, std::size_t layer, std::size_t number) {
    context_.check();
    const OpenedPath open(path);
    const std::vector<LineStretch> on = stretches_on_others(open);
    if (on.empty()) return place(path, layer, number);
    const auto last = static_cast<double>(open.points().size() - 1);
    // What is left at both ends of a closed line is one piece.
    const bool round = path.closed && on.front().begin > 0 && on.back().end < last;
    double from = 0;
    for (const LineStretch& one : on) {
      const bool first = from == 0 && round;
      if (one.begin > from && !first) place(open.piece(from, one.begin), layer, number);
      from = one.end;
    }
    if (!(from < last)) return;
    Path rest = open.piece(from, last);
    if (round) append(rest, open.piece(0, on.front().begin));
    place(std::move(rest), layer, number);
  }

  std::vector<Drawn> take() { return std::move(drawn_); }

 private:
  void place(Path path, std::size_t layer, std::size_t number) {
    grid_.add(path, drawn_.size());
    drawn_.push_back({std::move(path), layer, number});
  }

  /// Stretches of a path that lie on lines that are there, in order, without those too short to
  /// count; their owners are told what they stand for.
  std::vector<LineStretch> stretches_on_others(const OpenedPath& open) {
    std::vector<LineStretch> found;
    const auto& points = open.points();
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      grid_.along(points[i], points[i + 1], [&](double begin, double end, std::size_t owner) {
        const auto at = static_cast<double>(i);
        found.push_back({at + begin, at + end, owner});
      });
    }
    add_stretches_on_itself(open, found);
    if (found.empty()) return {};
    std::ranges::sort(found, [](const LineStretch& a, const LineStretch& b) {
      return std::tie(a.begin, a.end, a.owner) < std::tie(b.begin, b.end, b.owner);
    });
    std::vector<LineStretch> on = without_specks(united(found), open);
    note_owners(found, on, open);
    return on;
  }

  /// A contour may come back beside itself, as a circle does that is seen from its side.
  static void add_stretches_on_itself(const OpenedPath& open, std::vector<LineStretch>& found) {
    const auto& points = open.points();
    const double whole = open.length(0, static_cast<double>(points.size() - 1));
    if (whole < 2 * kFarAlong) return;
    PathGrid before(kSameLine);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const auto at = static_cast<double>(i);
      before.along(points[i], points[i + 1], [&](double begin, double end, std::size_t other) {
        const Vec2 a = points[other], d = points[other + 1] - a;
        // Along the line, from a place of this segment to the one that it lies on.
        const auto way_from = [&](double share) {
          const Vec2 p = glm::mix(points[i], points[i + 1], share);
          const double there = std::clamp(glm::dot(p - a, d) / glm::dot(d, d), 0.0, 1.0);
          const double way = open.length(static_cast<double>(other) + there, at + share);
          return open.path().closed ? std::min(way, whole - way) : way;
        };
        // Where it turns back it is nowhere far at the turn itself.
        const double way =
            std::max({way_from(begin), way_from(0.5 * (begin + end)), way_from(end)});
        if (way >= kFarAlong) found.push_back({at + begin, at + end, kItself});
      });
      before.add(points[i], points[i + 1], i);
    }
  }

  static std::vector<LineStretch> united(const std::vector<LineStretch>& found) {
    std::vector<LineStretch> out;
    for (const LineStretch& one : found) {
      if (!out.empty() && one.begin <= out.back().end) {
        out.back().end = std::max(out.back().end, one.end);
      } else {
        out.push_back(one);
      }
    }
    return out;
  }

  static std::vector<LineStretch> without_specks(const std::vector<LineStretch>& runs,
                                                 const OpenedPath& open) {
    std::vector<LineStretch> out;
    for (const LineStretch& run : runs) {
      if (!out.empty() && open.length(out.back().end, run.begin) < kSpeck) {
        out.back().end = run.end;
      } else {
        out.push_back(run);
      }
    }
    const auto last = static_cast<double>(open.points().size() - 1);
    const auto is_short = [&](const LineStretch& run) {
      const bool all = open.length(0, run.begin) < kSpeck && open.length(run.end, last) < kSpeck;
      return !all && open.length(run.begin, run.end) < kLeastOn;
    };
    std::erase_if(out, is_short);
    if (out.empty()) return out;
    // What goes on beyond may be what another line begins at.
    if (open.length(0, out.front().begin) < kSameLine) out.front().begin = 0;
    if (open.length(out.back().end, last) < kSameLine) out.back().end = last;
    return out;
  }

  void note_owners(const std::vector<LineStretch>& found, const std::vector<LineStretch>& on,
                   const OpenedPath& open) {
    std::map<std::size_t, double> lengths;
    for (const LineStretch& one : found) {
      if (one.owner == kItself) continue;
      for (const LineStretch& run : on) {
        const double begin = std::max(one.begin, run.begin), end = std::min(one.end, run.end);
        if (begin < end) lengths[one.owner] += open.length(begin, end);
      }
    }
    const Path& path = open.path();
    for (const auto& [owner, length] : lengths) {
      // A line that is met at its end alone does not stand for the other.
      const double least =
          std::min({kLeastOn, 0.5 * length_of(path), 0.5 * length_of(drawn_[owner].path)});
      if (length < least) continue;
      add_also(drawn_[owner].path, {path.source, path.kind});
      for (const PathSource& more : path.also) add_also(drawn_[owner].path, more);
    }
  }

  const RunContext& context_;
  PathGrid grid_;
  std::vector<Drawn> drawn_;
};

}  // namespace

void keep_one_line(std::vector<Layer>& layers, const RunContext& context) {
  struct Place {
    std::size_t layer, number;
  };
  std::vector<Place> order;
  // Layers are painted thin ones first, so the last lies on top.
  for (std::size_t l = layers.size(); l-- > 0;) {
    for (std::size_t i = 0; i < layers[l].paths.size(); ++i) {
      if (is_line(layers[l], layers[l].paths[i])) order.push_back({l, i});
    }
  }
  std::ranges::stable_sort(order, {}, [&](const Place& at) {
    return rank_of(layers[at.layer].paths[at.number], layers[at.layer]);
  });
  Sheet sheet(context);
  for (const Place& at : order) sheet.add(layers[at.layer].paths[at.number], at.layer, at.number);
  std::vector<std::map<std::size_t, std::vector<Path>>> made(layers.size());
  for (Drawn& one : sheet.take()) made[one.layer][one.number].push_back(std::move(one.path));
  for (std::size_t l = 0; l < layers.size(); ++l) {
    std::vector<Path> paths;
    for (std::size_t i = 0; i < layers[l].paths.size(); ++i) {
      if (!is_line(layers[l], layers[l].paths[i])) {
        paths.push_back(std::move(layers[l].paths[i]));
        continue;
      }
      for (Path& piece : made[l][i]) paths.push_back(std::move(piece));
    }
    layers[l].paths = std::move(paths);
  }
  std::erase_if(layers,
                [](const Layer& layer) { return layer.paths.empty() && layer.texts.empty(); });
}

}  // namespace burin
