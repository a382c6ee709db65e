#include <burin/drawing/ink.h>
#include <burin/drawing/join.h>
#include <burin/drawing/length.h>
#include <burin/drawing/pen_order.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace burin {
namespace {

// Lines of one mark look the same where they are one; none where the width varies along it.
class Marks {
 public:
  std::int64_t of(const Path& path) {
    if (has_varying_width(path) || is_dot(path)) return -1;
    // Widths are told apart by what files say of them.
    const auto width = std::llround(1000 * mean_width(path));
    const std::tuple key(width, path.visible, path.in_full, path.item, path.color);
    return known_.try_emplace(key, static_cast<std::int64_t>(known_.size())).first->second;
  }

 private:
  std::map<std::tuple<long long, bool, bool, int, std::string>, std::int64_t> known_;
};

// One path, turned round.
Path turned_round(const Path& path) {
  Path out = without_points(path);
  out.item = path.item;
  out.points.assign(path.points.rbegin(), path.points.rend());
  out.width.assign(path.width.rbegin(), path.width.rend());
  return out;
}

// A ring that begins at another of its points.
Path begun_at(const Path& path, Vec2 start) {
  Path out = without_points(path);
  out.item = path.item;
  out.closed = true;
  out.points = path.points;
  out.width = path.width;
  const auto shift = std::ranges::find(path.points, start) - path.points.begin();
  std::rotate(out.points.begin(), out.points.begin() + shift, out.points.end());
  if (out.width.size() == out.points.size()) {
    std::rotate(out.width.begin(), out.width.begin() + shift, out.width.end());
  }
  return out;
}

}  // namespace

JoinedPaths in_travel_order(std::span<const Path* const> paths, Vec2& from,
                            const RunContext& context) {
  Marks marks;
  std::vector<PenPath> lines;
  lines.reserve(paths.size());
  for (const Path* path : paths) lines.push_back({path->points, path->closed, 0, marks.of(*path)});
  PenOrderOptions options;
  options.from = from;
  const PenOrder order = pen_order(lines, options, context);
  JoinedPaths out;
  for (const PenLine& line : order.lines) {
    const PenRun& run = order.runs[line.first_run];
    const Path& first = *paths[run.path];
    std::vector<const Path*> pieces;
    if (line.runs == 1 && line.closed == first.closed && !run.reversed && line.start == 0) {
      out.paths.push_back(&first);
      from = line.closed ? first.points.front() : first.points.back();
    } else {
      if (line.runs == 1 && first.closed) {
        out.made.push_back(begun_at(first, points_of(line, order, lines).front()));
      } else if (line.runs == 1 && !line.closed) {
        out.made.push_back(turned_round(first));
      } else {
        for (std::uint32_t k = 0; k < line.runs; ++k) {
          pieces.push_back(paths[order.runs[line.first_run + k].path]);
        }
        const Path& longest = **std::ranges::max_element(
            pieces, {}, [](const Path* piece) { return length_of(*piece); });
        Path& made = out.made.emplace_back(without_points(longest));
        made.item = longest.item;
        made.closed = line.closed;
        made.width = {mean_width(longest)};
        made.points = points_of(line, order, lines);
      }
      out.paths.push_back(&out.made.back());
      const Path& made = out.made.back();
      from = made.closed ? made.points.front() : made.points.back();
    }
    out.pieces.push_back(std::move(pieces));
  }
  return out;
}

}  // namespace burin
