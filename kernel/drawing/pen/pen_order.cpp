#include <burin/drawing/length.h>
#include <burin/drawing/pen_order.h>

#include "pen_join.h"
#include "pen_tour.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace burin {
namespace {

Vec2 first_of(const PenRun& run, std::span<const PenPath> paths) {
  const auto points = paths[run.path].points;
  return run.reversed ? points.back() : points.front();
}
Vec2 last_of(const PenRun& run, std::span<const PenPath> paths) {
  const auto points = paths[run.path].points;
  return run.reversed ? points.front() : points.back();
}

// Adds up what is drawn and what is travelled.
void measure(PenOrder& order, std::span<const PenPath> paths, Vec2 from,
             const RunContext& context) {
  for (const PenLine& line : order.lines) {
    context.check();
    const std::vector<Vec2> points = points_of(line, order, paths);
    order.travel += glm::distance(from, points.front());
    order.drawn += length_of(points);
    if (line.closed) order.drawn += glm::distance(points.back(), points.front());
    from = line.closed ? points.front() : points.back();
  }
}

// Turns the runs of a line round.
void reverse_runs(const PenLine& line, std::vector<PenRun>& runs) {
  const auto begin = runs.begin() + line.first_run;
  std::reverse(begin, begin + line.runs);
  std::for_each(begin, begin + line.runs, [](PenRun& run) { run.reversed = !run.reversed; });
}

}  // namespace

std::vector<Vec2> points_of(const PenLine& line, const PenOrder& order,
                            std::span<const PenPath> paths) {
  std::vector<Vec2> points;
  for (std::uint32_t k = 0; k < line.runs; ++k) {
    const PenRun& run = order.runs[line.first_run + k];
    const auto its = paths[run.path].points;
    const auto add = [&](Vec2 p) {
      // Of a joint there is one point where both ends are the same.
      if (k == 0 || points.back() != p) points.push_back(p);
    };
    if (run.reversed) {
      std::for_each(its.rbegin(), its.rend(), add);
    } else {
      std::for_each(its.begin(), its.end(), add);
    }
  }
  if (!line.closed) return points;
  while (points.size() > 1 && points.back() == points.front()) points.pop_back();
  std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(line.start),
              points.end());
  return points;
}

PenOrder pen_order(std::span<const PenPath> paths, const PenOrderOptions& options,
                   const RunContext& context) {
  PenOrder joined = join_lines(paths, options.join, context);
  const auto group_of = [&](const PenLine& line) {
    context.check();
    return line.group;
  };
  std::ranges::stable_sort(joined.lines, {}, group_of);
  PenOrder out;
  out.lines.reserve(joined.lines.size());
  Vec2 from = options.from;
  for (std::size_t begin = 0; begin < joined.lines.size();) {
    std::size_t end = begin;
    std::vector<TourLine> lines;
    for (; end < joined.lines.size() && joined.lines[end].group == joined.lines[begin].group;
         ++end) {
      const PenLine& line = joined.lines[end];
      TourLine& its = lines.emplace_back();
      its.ends = {first_of(joined.runs[line.first_run], paths),
                  last_of(joined.runs[line.first_run + line.runs - 1], paths)};
      if (line.closed) its.ring = points_of(line, joined, paths);
      context.check();
    }
    const auto progress = [&](double share) {
      if (!options.progress) return;
      const double done = static_cast<double>(begin) + share * static_cast<double>(end - begin);
      options.progress(done / static_cast<double>(joined.lines.size()));
    };
    for (const std::uint32_t i : shortest_tour(lines, from, context, progress)) {
      context.check();
      PenLine line = joined.lines[begin + i];
      if (lines[i].reversed && !line.closed) reverse_runs(line, joined.runs);
      line.start = lines[i].start;
      out.lines.push_back(line);
      from = lines[i].ends[lines[i].reversed ? 0 : 1];
    }
    begin = end;
  }
  out.runs = std::move(joined.runs);
  measure(out, paths, options.from, context);
  return out;
}

PenOrder given_order(std::span<const PenPath> paths, Vec2 from, const RunContext& context) {
  PenOrder order;
  for (std::uint32_t i = 0; i < paths.size(); ++i) {
    order.lines.push_back({paths[i].group, i, 1, paths[i].closed, 0});
    order.runs.push_back({i, false});
  }
  std::ranges::stable_sort(order.lines, {}, &PenLine::group);
  measure(order, paths, from, context);
  return order;
}

}  // namespace burin
