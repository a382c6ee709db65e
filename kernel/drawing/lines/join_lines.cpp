#include <burin/drawing/ink.h>
#include <burin/drawing/join_lines.h>
#include <burin/drawing/length.h>

#include "curves/path_piece.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

namespace burin {
namespace {

/// Paper mm within which ends are one: lines are simplified within 0.005.
constexpr double kSameEnd = 0.02;
/// Share of a line's length in the model within which its end is that of another.
constexpr double kSamePlace = 1e-3;
/// Cosines of the angles up to which a straight line is one, and a dashed one has no corner.
constexpr double kStraightCosine = 0.99999, kSmoothCosine = 0.94;

/// One end of a path: its number times two, plus one for the last point.
using End = std::size_t;

/// The open lines of a layer that may be joined with each other.
class LineJoiner {
 public:
  explicit LineJoiner(std::vector<Path*> lines)
      : lines_(std::move(lines)), partner_(2 * lines_.size()) {}

  /// Joins them; of those that went into others no points are left.
  void run() {
    find_partners();
    std::vector<bool> done(lines_.size(), false);
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      if (done[i]) continue;
      const std::vector<End> chain = chain_of(i);
      for (const End end : chain) done[end / 2] = true;
      if (chain.size() > 1) join(chain);
    }
  }

 private:
  Vec2 place(End end) const {
    const auto& points = lines_[end / 2]->points;
    return end % 2 == 0 ? points.front() : points.back();
  }
  Vec3 place3(End end) const {
    const auto& points = lines_[end / 2]->points3;
    return end % 2 == 0 ? points.front() : points.back();
  }
  /// Away from the line.
  Vec2 way(End end) const {
    const auto& points = lines_[end / 2]->points;
    const std::size_t n = points.size();
    const Vec2 out = end % 2 == 0 ? points[0] - points[1] : points[n - 1] - points[n - 2];
    const double length = glm::length(out);
    return length > 0 ? out / length : Vec2(0);
  }

  bool goes_on(End a, End b) const {
    const Path &p = *lines_[a / 2], &q = *lines_[b / 2];
    if (p.points3.size() == p.points.size() && q.points3.size() == q.points.size()) {
      const double size = glm::distance(p.points3.front(), p.points3.back()) +
                          glm::distance(q.points3.front(), q.points3.back());
      if (glm::distance(place3(a), place3(b)) > kSamePlace * size) return false;
    }
    const double along = -glm::dot(way(a), way(b));
    if (p.points.size() == 2 && q.points.size() == 2) return along >= kStraightCosine;
    return !p.visible && !p.in_full && along >= kSmoothCosine;
  }

  void find_partners() {
    std::map<std::pair<std::int64_t, std::int64_t>, std::vector<End>> cells;
    const auto cell = [](Vec2 p) {
      return std::pair(std::llround(p.x / (2 * kSameEnd)), std::llround(p.y / (2 * kSameEnd)));
    };
    for (End end = 0; end < partner_.size(); ++end) cells[cell(place(end))].push_back(end);
    std::vector<std::vector<End>> next(partner_.size());
    for (End end = 0; end < partner_.size(); ++end) {
      const auto at = cell(place(end));
      for (std::int64_t dx = -1; dx <= 1; ++dx) {
        for (std::int64_t dy = -1; dy <= 1; ++dy) {
          const auto found = cells.find({at.first + dx, at.second + dy});
          if (found == cells.end()) continue;
          for (const End other : found->second) {
            const bool near = glm::distance(place(end), place(other)) <= kSameEnd;
            if (other != end && near && goes_on(end, other)) next[end].push_back(other);
          }
        }
      }
    }
    for (End end = 0; end < partner_.size(); ++end) {
      if (next[end].size() == 1 && next[next[end][0]].size() == 1) partner_[end] = next[end][0];
    }
  }

  /// The first ends of lines that go on in each other, in order; a ring begins at its first line.
  std::vector<End> chain_of(std::size_t line) const {
    End first = 2 * line;
    while (partner_[first]) {
      first = *partner_[first] ^ 1U;
      if (first / 2 == line) break;
    }
    std::vector<End> chain{first};
    while (const auto next = partner_[chain.back() ^ 1U]) {
      if (*next / 2 == first / 2) break;
      chain.push_back(*next);
    }
    return chain;
  }

  static void turn_round(Path& path) {
    std::ranges::reverse(path.points);
    std::ranges::reverse(path.points3);
    std::ranges::reverse(path.width);
    path.faces.clear();  // the main one stays
  }

  void join(const std::vector<End>& chain) {
    std::size_t home = lines_.size();
    const Path* longest = nullptr;
    for (const End end : chain) {
      home = std::min(home, end / 2);
      const Path& one = *lines_[end / 2];
      if (!longest || length_of(one) > length_of(*longest)) longest = &one;
    }
    Path head = without_points(*longest);
    Path whole = *lines_[chain.front() / 2];
    for (const End end : chain) {
      const Path& one = *lines_[end / 2];
      add_also(head, {one.source, one.kind});
      for (const PathSource& source : one.also) add_also(head, source);
    }
    if (chain.front() % 2 != 0) turn_round(whole);
    for (std::size_t k = 1; k < chain.size(); ++k) {
      Path next = *lines_[chain[k] / 2];
      if (chain[k] % 2 != 0) turn_round(next);
      append(whole, next);
    }
    for (const End end : chain) lines_[end / 2]->points.clear();
    straighten(whole);
    whole.kind = head.kind, whole.source = head.source, whole.also = std::move(head.also);
    *lines_[home] = std::move(whole);
  }

  /// Leaves out the joints of straight pieces, and closes a ring.
  void straighten(Path& path) const {
    const bool ring = path.points.size() > 3 &&
                      glm::distance(path.points.front(), path.points.back()) <= kSameEnd;
    for (std::size_t i = path.points.size() - 1; i-- > 1;) {
      const Vec2 in = path.points[i] - path.points[i - 1],
                 out = path.points[i + 1] - path.points[i];
      if (glm::dot(in, out) < kStraightCosine * glm::length(in) * glm::length(out)) continue;
      if (!path.faces.empty()) continue;
      const auto at = static_cast<std::ptrdiff_t>(i);
      const auto drop = [&](auto& values, std::size_t points) {
        if (values.size() == points) values.erase(values.begin() + at);
      };
      const std::size_t n = path.points.size();
      if (path.width.size() == n) continue;
      drop(path.points3, n);
      drop(path.points, n);
    }
    if (!ring || path.points.size() < 4) return;
    path.closed = true;
    path.points.pop_back();
    if (path.points3.size() > path.points.size()) path.points3.pop_back();
    if (path.width.size() > path.points.size()) path.width.pop_back();
  }

  std::vector<Path*> lines_;
  std::vector<std::optional<End>> partner_;
};

}  // namespace

void join_lines(std::vector<Layer>& layers, const RunContext& context) {
  for (Layer& layer : layers) {
    context.check();
    std::map<std::tuple<std::int32_t, bool, bool, std::int64_t>, std::vector<Path*>> alike;
    for (Path& path : layer.paths) {
      const bool is_line = path.kind != LineClass::Stroke && path.kind != LineClass::Pattern &&
                           !path.closed && path.points.size() > 1 && is_finite(path) &&
                           !has_varying_width(path);
      if (!is_line) continue;
      alike[{path.source.part, path.visible, path.in_full, std::llround(1000 * mean_width(path))}]
          .push_back(&path);
    }
    for (auto& [key, lines] : alike) LineJoiner(std::move(lines)).run();
    std::erase_if(layer.paths, [](const Path& path) { return path.points.empty(); });
  }
}

}  // namespace burin
