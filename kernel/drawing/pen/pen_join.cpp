#include "pen_join.h"

#include <burin/base/parallel.h>

#include "point_tree.h"

#include <algorithm>
#include <tuple>

namespace burin {
namespace {

// Ends that are looked at around each end; where more meet, some of them stay ends.
constexpr std::size_t kMostNearEnds = 8;

// One end of a line: its number times two, plus one for the last point.
using PenEnd = std::uint32_t;
constexpr PenEnd kFree = static_cast<PenEnd>(-1);

struct Pair {
  double turn = 0;  // 0: straight on; 2: back
  PenEnd a = 0, b = 0;
};

class PenJoiner {
 public:
  PenJoiner(std::span<const PenPath> paths, double tolerance, const RunContext& context)
      : paths_(paths),
        tolerance_(tolerance),
        context_(context),
        partner_(2 * paths.size(), kFree),
        done_(paths.size(), false) {}

  PenOrder run() {
    pair_ends();
    // Lines with a free end first: what is left then is rings.
    for (PenEnd end = 0; end < partner_.size(); ++end) {
      if (partner_[end] == kFree && !done_[end / 2]) follow(end);
    }
    for (std::uint32_t i = 0; i < paths_.size(); ++i) {
      if (!done_[i]) follow(2 * i);
    }
    std::ranges::sort(out_.lines, {}, [&](const PenLine& line) {
      context_.check();
      std::uint32_t first = out_.runs[line.first_run].path;
      for (std::uint32_t k = 1; k < line.runs; ++k) {
        first = std::min(first, out_.runs[line.first_run + k].path);
      }
      return first;
    });
    return std::move(out_);
  }

 private:
  bool joins(const PenPath& path) const {
    return !path.closed && path.mark >= 0 && path.points.size() > 1;
  }
  Vec2 place(PenEnd end) const {
    const auto points = paths_[end / 2].points;
    return end % 2 == 0 ? points.front() : points.back();
  }
  // The unit direction in which the line leaves its end, inwards.
  Vec2 inwards(PenEnd end) const {
    const auto points = paths_[end / 2].points;
    const std::size_t n = points.size();
    const auto point = [&](std::size_t k) { return points[end % 2 == 0 ? k : n - 1 - k]; };
    for (std::size_t k = 1; k < n; ++k) {
      const Vec2 way = point(k) - point(0);
      if (glm::length(way) > tolerance_) return glm::normalize(way);
    }
    return Vec2(0);
  }

  void pair_ends() {
    std::vector<Vec2> places;
    std::vector<PenEnd> ends;
    for (std::uint32_t i = 0; i < paths_.size(); ++i) {
      context_.check();
      if (!joins(paths_[i])) continue;
      for (const PenEnd end : {2 * i, 2 * i + 1}) {
        places.push_back(place(end));
        ends.push_back(end);
      }
    }
    const PointTree tree(std::move(places), context_);
    constexpr std::size_t kGrain = 1024;
    std::vector<std::vector<Pair>> found((ends.size() + kGrain - 1) / kGrain);
    parallel_for(
        ends.size(), kGrain,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t k = begin; k < end; ++k) add_pairs(tree, ends, k, found[begin / kGrain]);
        },
        &context_);
    std::vector<Pair> pairs;
    for (const auto& some : found) {
      context_.check();
      pairs.insert(pairs.end(), some.begin(), some.end());
    }
    std::sort(pairs.begin(), pairs.end(), [&](const Pair& p, const Pair& q) {
      context_.check();
      return std::tie(p.turn, p.a, p.b) < std::tie(q.turn, q.a, q.b);
    });
    for (const Pair& pair : pairs) {
      context_.check();
      if (partner_[pair.a] != kFree || partner_[pair.b] != kFree) continue;
      partner_[pair.a] = pair.b;
      partner_[pair.b] = pair.a;
    }
  }

  void add_pairs(const PointTree& tree, const std::vector<PenEnd>& ends, std::size_t k,
                 std::vector<Pair>& pairs) const {
    const PenEnd end = ends[k];
    const PenPath& path = paths_[end / 2];
    for (const PointTree::Near& near : tree.near(tree.points()[k], kMostNearEnds + 1, tolerance_)) {
      const PenEnd other = ends[near.point];
      const PenPath& its = paths_[other / 2];
      if (other == end || its.group != path.group || its.mark != path.mark) continue;
      // A line that is all within the tolerance does not close.
      if (other / 2 == end / 2 && path.points.size() < 4) continue;
      const double turn = 1 + glm::dot(inwards(end), inwards(other));
      pairs.push_back({turn, std::min(end, other), std::max(end, other)});
    }
  }

  // A line from one of its ends on.
  void follow(PenEnd first) {
    PenLine line{paths_[first / 2].group, static_cast<std::uint32_t>(out_.runs.size()), 0,
                 paths_[first / 2].closed, 0};
    std::size_t points = 0;
    for (PenEnd end = first;;) {
      done_[end / 2] = true;
      out_.runs.push_back({end / 2, end % 2 == 1});
      points += paths_[end / 2].points.size() - 1;
      const PenEnd next = partner_[end ^ 1U];
      if (next == kFree) break;
      if (next == first) {
        // There and back is no ring.
        line.closed = points >= 3;
        break;
      }
      end = next;
    }
    line.runs = static_cast<std::uint32_t>(out_.runs.size()) - line.first_run;
    out_.lines.push_back(line);
    context_.check();
  }

  std::span<const PenPath> paths_;
  double tolerance_;
  const RunContext& context_;
  std::vector<PenEnd> partner_;
  std::vector<bool> done_;
  PenOrder out_;
};

}  // namespace

PenOrder join_lines(std::span<const PenPath> paths, double tolerance, const RunContext& context) {
  return PenJoiner(paths, tolerance, context).run();
}

}  // namespace burin
