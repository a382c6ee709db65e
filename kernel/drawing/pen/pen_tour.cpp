#include "pen_tour.h"

#include <burin/base/parallel.h>

#include "point_tree.h"

#include <algorithm>
#include <deque>
#include <memory>
#include <span>
#include <utility>

namespace burin {
namespace {

// Points of a ring at which it is first thought to begin.
constexpr std::size_t kRingPoints = 16;
// Ends that are looked at around each end.
constexpr std::size_t kMostNearPaths = 8;
// With its own, which are of no use.
constexpr std::size_t kAsked = kMostNearPaths + 2;
// Lines that are moved at once.
constexpr std::int64_t kMostMoved = 3;
// Lines that a change may turn round or shift; and, for each line, in all changes.
constexpr std::int64_t kMostShifted = 25'000, kShiftedForEach = 3000;
// Of the work, for the first order.
constexpr double kFirstShare = 0.3;
// mm that a change must save.
constexpr double kLeastSaved = 1e-6;

using Progress = std::function<void(double)>;

// The nearest end that is left comes next.
std::vector<std::uint32_t> nearest_first(std::vector<TourLine>& lines, Vec2 from,
                                         const RunContext& context, const Progress& progress) {
  struct Entry {
    std::uint32_t line = 0;
    std::size_t point = 0;
  };
  std::vector<Vec2> places;
  std::vector<Entry> entries;
  std::vector<std::uint32_t> first_entry;
  for (std::uint32_t i = 0; i < lines.size(); ++i) {
    context.check();
    first_entry.push_back(static_cast<std::uint32_t>(entries.size()));
    const TourLine& line = lines[i];
    const std::size_t step = (line.ring.size() + kRingPoints - 1) / kRingPoints;
    for (std::size_t k = 0; k < (line.ring.empty() ? 2 : line.ring.size());
         k += line.ring.empty() ? 1 : step) {
      entries.push_back({i, k});
      places.push_back(line.ring.empty() ? line.ends[k] : line.ring[k]);
    }
  }
  first_entry.push_back(static_cast<std::uint32_t>(entries.size()));
  PointTree tree(std::move(places), context);
  std::vector<std::uint32_t> order;
  order.reserve(lines.size());
  while (const auto found = tree.nearest(from)) {
    if (order.size() % 256 == 0) {
      context.check();
      progress(kFirstShare * static_cast<double>(order.size()) / static_cast<double>(lines.size()));
    }
    const Entry& entry = entries[*found];
    TourLine& line = lines[entry.line];
    if (line.ring.empty()) {
      line.reversed = entry.point == 1;
      from = line.ends[1 - entry.point];
    } else {
      line.start = entry.point;
      line.ends = {line.ring[entry.point], line.ring[entry.point]};
      from = line.ends[0];
    }
    order.push_back(entry.line);
    for (std::uint32_t e = first_entry[entry.line]; e < first_entry[entry.line + 1]; ++e) {
      tree.remove(e);
    }
  }
  return order;
}

/// An end and how far it is; there are many of them.
struct NearEnd {
  std::uint32_t end;
  float distance;
};

/// An order under change. Places are counted from 0; at place -1 the pen stands before.
class Tour {
 public:
  using Place = std::int64_t;

  Tour(std::vector<TourLine>& lines, std::vector<std::uint32_t>& order, Vec2 from,
       const RunContext& context)
      : lines_(lines),
        order_(order),
        from_(from),
        context_(context),
        n_(static_cast<Place>(order.size())),
        place_(order.size()),
        waits_(order.size(), true),
        left_(kShiftedForEach * n_) {
    for (Place i = 0; i < n_; ++i) place_[at(i)] = i;
    find_near();
  }

  /// Changes the order until no change saves anything, or too many lines were shifted.
  void improve(const Progress& progress) {
    std::deque<std::uint32_t> waiting(order_.begin(), order_.end());
    for (std::size_t tried = 0; !waiting.empty() && left_ > 0; ++tried) {
      if (tried % 64 == 0) {
        context_.check();
        // About two looks at each line are enough for most.
        const double looks = 0.5 * static_cast<double>(tried) / static_cast<double>(n_);
        progress(kFirstShare + (1 - kFirstShare) * std::min(looks, 1.0));
      }
      const std::uint32_t line = waiting.front();
      waiting.pop_front();
      waits_[line] = false;
      while (improve_after(place_[line]) || improve_before(place_[line])) {
        for (const Place i : touched_) {
          if (i < 0 || i >= n_ || waits_[at(i)]) continue;
          waits_[at(i)] = true;
          waiting.push_back(at(i));
        }
      }
    }
  }

 private:
  std::uint32_t at(Place i) const { return order_[static_cast<std::size_t>(i)]; }
  Vec2 head(Place i) const { return lines_[at(i)].ends[lines_[at(i)].reversed ? 1 : 0]; }
  Vec2 tail(Place i) const {
    return i < 0 ? from_ : lines_[at(i)].ends[lines_[at(i)].reversed ? 0 : 1];
  }
  // Travel behind a place; none behind the last.
  double gap(Place i) const { return i + 1 < n_ ? glm::distance(tail(i), head(i + 1)) : 0; }

  void find_near() {
    std::vector<Vec2> ends;
    for (const TourLine& line : lines_) ends.insert(ends.end(), line.ends.begin(), line.ends.end());
    const PointTree tree(std::move(ends), context_);
    // Not filled with zeros, which would take long and cannot be cancelled.
    near_ = std::make_unique_for_overwrite<NearEnd[]>(tree.points().size() * kAsked);
    near_count_.resize(tree.points().size());
    parallel_for(
        tree.points().size(), 1024,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t e = begin; e < end; ++e) {
            for (const PointTree::Near& one : tree.near(tree.points()[e], kAsked)) {
              if (one.point / 2 == e / 2) continue;
              near_[e * kAsked + near_count_[e]++] = {one.point, static_cast<float>(one.distance)};
            }
          }
        },
        &context_);
  }
  std::span<const NearEnd> near(Place i, bool tail) const {
    const std::size_t end = 2 * std::size_t{at(i)} + (lines_[at(i)].reversed != tail ? 1 : 0);
    return {near_.get() + end * kAsked, near_count_[end]};
  }
  bool is_tail(std::uint32_t end) const { return (end % 2 == 1) != lines_[end / 2].reversed; }

  // Something better behind the line at a place.
  bool improve_after(Place i) {
    const double now = gap(i);
    for (const auto& [end, distance] : near(i, true)) {
      if (distance >= now) break;
      const Place j = place_[end / 2];
      if (is_tail(end)) {
        if (turn(std::min(i, j) + 1, std::max(i, j))) return true;
        if (move_up_to(j, i, true)) return true;
      } else if (move_from(j, i, false)) {
        return true;
      }
    }
    return false;
  }

  // Something better before it.
  bool improve_before(Place i) {
    const double now = gap(i - 1);
    for (const auto& [end, distance] : near(i, false)) {
      if (distance >= now) break;
      const Place j = place_[end / 2];
      if (!is_tail(end)) {
        if (turn(std::min(i, j), std::max(i, j) - 1)) return true;
        if (move_from(j, i - 1, true)) return true;
      } else if (move_up_to(j, i - 1, false)) {
        return true;
      }
    }
    return false;
  }

  // Turns the lines of places a to b round where that saves way (2-opt).
  bool turn(Place a, Place b) {
    if (b - a >= kMostShifted) return false;
    const double before = gap(a - 1) + gap(b);
    const double after = glm::distance(tail(a - 1), tail(b)) +
                         (b + 1 < n_ ? glm::distance(head(a), head(b + 1)) : 0);
    if (before - after < kLeastSaved) return false;
    reverse(a, b);
    touched_ = {a - 1, a, b, b + 1};
    return true;
  }

  // Moves one to three lines that begin, or end, at place j behind place p.
  bool move_from(Place j, Place p, bool turned) {
    for (Place count = 1; count <= kMostMoved; ++count) {
      if (move(j, j + count - 1, p, turned)) return true;
    }
    return false;
  }
  bool move_up_to(Place j, Place p, bool turned) {
    for (Place count = 1; count <= kMostMoved; ++count) {
      if (move(j - count + 1, j, p, turned)) return true;
    }
    return false;
  }

  // Moves the lines of places a to b behind place p, turned round or not, where that saves way
  // (Or-opt).
  bool move(Place a, Place b, Place p, bool turned) {
    if (a < 0 || b >= n_ || (p >= a - 1 && p <= b)) return false;
    if (std::max(b, p) - std::min(a, p) >= kMostShifted) return false;
    const double before = gap(a - 1) + gap(b) + gap(p);
    double after = glm::distance(tail(p), turned ? tail(b) : head(a));
    if (b + 1 < n_) after += glm::distance(tail(a - 1), head(b + 1));
    if (p + 1 < n_) after += glm::distance(turned ? head(a) : tail(b), head(p + 1));
    if (before - after < kLeastSaved) return false;
    const Place count = b - a + 1;
    if (turned) reverse(a, b);
    const auto it = [&](Place i) { return order_.begin() + i; };
    const Place low = std::min(a, p + 1), high = std::max(b, p);
    if (p > b) {
      std::rotate(it(a), it(b + 1), it(p + 1));
      touched_ = {a - 1, a, p - count, p - count + 1, p, p + 1};
    } else {
      std::rotate(it(p + 1), it(a), it(b + 1));
      touched_ = {p, p + 1, p + count, p + count + 1, b, b + 1};
    }
    for (Place i = low; i <= high; ++i) place_[at(i)] = i;
    left_ -= high - low + 1;
    return true;
  }

  void reverse(Place a, Place b) {
    std::reverse(order_.begin() + a, order_.begin() + b + 1);
    for (Place i = a; i <= b; ++i) {
      lines_[at(i)].reversed = !lines_[at(i)].reversed;
      place_[at(i)] = i;
    }
    left_ -= b - a + 1;
  }

  std::vector<TourLine>& lines_;
  std::vector<std::uint32_t>& order_;
  Vec2 from_;
  const RunContext& context_;
  Place n_;
  std::vector<Place> place_;  // of each line
  std::vector<bool> waits_;
  Place left_;                       // lines that may still be shifted
  std::unique_ptr<NearEnd[]> near_;  // kAsked places for each end
  std::vector<std::uint8_t> near_count_;
  std::vector<Place> touched_;
};

// Lets each ring begin where the way from the line before and to the one after is shortest.
void turn_rings(std::vector<TourLine>& lines, const std::vector<std::uint32_t>& order, Vec2 from,
                const RunContext& context) {
  for (std::size_t i = 0; i < order.size(); ++i) {
    context.check();
    TourLine& line = lines[order[i]];
    if (!line.ring.empty()) {
      const TourLine* next = i + 1 < order.size() ? &lines[order[i + 1]] : nullptr;
      const auto way = [&](Vec2 p) {
        const double on = next ? glm::distance(p, next->ends[next->reversed ? 1 : 0]) : 0;
        return glm::distance(from, p) + on;
      };
      const auto best = std::ranges::min_element(line.ring, {}, way);
      line.start = static_cast<std::size_t>(best - line.ring.begin());
      line.ends = {*best, *best};
    }
    from = line.ends[line.reversed ? 0 : 1];
  }
}

}  // namespace

std::vector<std::uint32_t> shortest_tour(std::vector<TourLine>& lines, Vec2 from,
                                         const RunContext& context, const Progress& progress) {
  std::vector<std::uint32_t> order = nearest_first(lines, from, context, progress);
  turn_rings(lines, order, from, context);
  Tour(lines, order, from, context).improve(progress);
  // Twice: a ring looks at where its neighbours begin.
  for (int round = 0; round < 2; ++round) turn_rings(lines, order, from, context);
  return order;
}

}  // namespace burin
