#include <burin/drawing/ink.h>
#include <burin/drawing/join.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

namespace burin {
namespace {

// Paper mm within which two ends are one: a few steps of the grid that files are written on.
constexpr double kSame = 0.003;
// Paper mm of width by which pens differ.
constexpr double kSamePen = 0.0005;

// One end of a path: its number times two, plus one for the last point.
using End = std::size_t;

class PieceJoiner {
 public:
  explicit PieceJoiner(std::span<const Path* const> paths)
      : paths_(paths), partner_(2 * paths.size()), state_(paths.size(), State::New) {}

  JoinedPaths run(const std::function<bool(const Path&)>& wanted) {
    find_partners();
    JoinedPaths out;
    for (std::size_t i = 0; i < paths_.size(); ++i) {
      if (state_[i] == State::InRing) continue;
      const std::vector<End> ends = state_[i] == State::New ? ring_from(i) : std::vector<End>();
      std::optional<Path> ring;
      if (!ends.empty()) ring = join(ends);
      const bool join_them = ring && (!wanted || wanted(*ring));
      for (const End end : ends) state_[end / 2] = join_them ? State::InRing : State::Alone;
      if (!join_them) {
        out.paths.push_back(paths_[i]);
        out.pieces.emplace_back();
        continue;
      }
      out.made.push_back(std::move(*ring));
      out.paths.push_back(&out.made.back());
      out.pieces.emplace_back();
      for (const End end : ends) out.pieces.back().push_back(paths_[end / 2]);
    }
    return out;
  }

 private:
  enum class State : std::uint8_t { New, InRing, Alone };

  bool joins(std::size_t i) const {
    const Path& p = *paths_[i];
    return !p.closed && p.points.size() > 1 && !has_varying_width(p);
  }
  Vec2 place(End end) const {
    const auto& points = paths_[end / 2]->points;
    return end % 2 == 0 ? points.front() : points.back();
  }
  bool same_pen(End a, End b) const {
    const Path &p = *paths_[a / 2], &q = *paths_[b / 2];
    return p.visible == q.visible && p.in_full == q.in_full && p.color == q.color &&
           std::abs(mean_width(p) - mean_width(q)) < kSamePen;
  }

  // Ends at which exactly two meet.
  void find_partners() {
    using Cell = std::pair<std::int64_t, std::int64_t>;
    const auto cell = [](Vec2 p) {
      return Cell{std::llround(p.x / (2 * kSame)), std::llround(p.y / (2 * kSame))};
    };
    std::map<Cell, std::vector<End>> ends;
    for (End end = 0; end < partner_.size(); ++end) {
      if (joins(end / 2)) ends[cell(place(end))].push_back(end);
    }
    const auto others = [&](End end) {
      std::vector<End> found;
      const Cell at = cell(place(end));
      for (std::int64_t dx = -1; dx <= 1; ++dx) {
        for (std::int64_t dy = -1; dy <= 1; ++dy) {
          const auto it = ends.find({at.first + dx, at.second + dy});
          if (it == ends.end()) continue;
          for (const End other : it->second) {
            if (other != end && glm::distance(place(end), place(other)) <= kSame) {
              found.push_back(other);
            }
          }
        }
      }
      return found;
    };
    for (End end = 0; end < partner_.size(); ++end) {
      if (!joins(end / 2)) continue;
      const std::vector<End> near = others(end);
      if (near.size() == 1 && same_pen(end, near[0]) && others(near[0]).size() == 1) {
        partner_[end] = near[0];
      }
    }
  }

  // The first ends of the paths of a ring, in order; empty where they do not close.
  std::vector<End> ring_from(std::size_t start) const {
    std::vector<End> out;
    for (End first = 2 * start;;) {
      out.push_back(first);
      const auto next = partner_[first ^ 1U];
      if (!next || out.size() > paths_.size()) return {};
      first = *next;
      if (first / 2 == start) break;
    }
    // A path that comes back to itself the wrong way round is no ring; one alone is closed by its
    // own ends.
    if (partner_[2 * start] != (out.back() ^ 1U)) return {};
    std::size_t points = 0;
    for (const End end : out) points += paths_[end / 2]->points.size() - 1;
    if (points < 3) return {};
    return out;
  }

  Path join(const std::vector<End>& ends) const {
    const Path* longest = nullptr;
    double most = -1;
    std::vector<Vec2> points;
    for (const End end : ends) {
      const Path& p = *paths_[end / 2];
      double length = 0;
      for (std::size_t k = 0; k + 1 < p.points.size(); ++k) {
        length += glm::distance(p.points[k], p.points[k + 1]);
        const std::size_t at = end % 2 == 0 ? k : p.points.size() - 1 - k;
        points.push_back(p.points[at]);  // the last is the first of the next
      }
      if (length > most) longest = &p;
      most = std::max(most, length);
    }
    Path ring = without_points(*longest);
    ring.closed = true;
    ring.points = std::move(points);
    ring.width = {mean_width(*longest)};
    return ring;
  }

  std::span<const Path* const> paths_;
  std::vector<std::optional<End>> partner_;
  std::vector<State> state_;
};

}  // namespace

JoinedPaths join_rings(std::span<const Path* const> paths,
                       const std::function<bool(const Path& ring)>& wanted) {
  return PieceJoiner(paths).run(wanted);
}

}  // namespace burin
