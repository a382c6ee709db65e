#include <burin/base/nearest_along.h>
#include <burin/base/parallel.h>
#include <burin/visibility/halo.h>

#include "picture.h"
#include "segment_grid.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

namespace burin {
namespace {

// Paper mm within which lines touch; see Cutters::kReach.
constexpr double kTouch = 1e-7;
// Paper mm that lines of one place may be apart: chords, and strokes drawn over facets.
constexpr double kOnPaper = 0.05;
// How much deeper than its slope says a sheet may lie beside the line that it ends at: a sheet that
// bends away like a parabola lies twice as deep.
constexpr double kBending = 3;
// Multiples of the distance within which a line cannot be behind itself: half a turn.
constexpr double kOwnCourse = 3.2;
constexpr std::size_t kLineGrain = 8;

double span_of(const PictureSegment& s) { return glm::length(s.b - s.a); }

// Model mm of depth a paper mm along a segment; infinite where it is seen end on.
double steepness(const PictureSegment& s) {
  const double depth = std::abs(s.depth_b - s.depth_a);
  return depth == 0 ? 0 : depth / span_of(s);
}

// The segments of a line, and how far along the line they lie on paper.
class Course {
 public:
  explicit Course(const HaloLine& line) : line_(line), along_{0} {
    for (std::size_t i = 0; i < segment_count(); ++i) {
      along_.push_back(along_.back() + glm::length(line.points[next(i)] - line.points[i]));
    }
  }
  std::size_t segment_count() const {
    const std::size_t n = line_.points.size();
    return n < 2 ? 0 : line_.closed ? n : n - 1;
  }
  std::size_t next(std::size_t i) const { return i + 1 == line_.points.size() ? 0 : i + 1; }

  PictureSegment segment(std::size_t i, std::int32_t number) const {
    PictureSegment s;
    s.a = line_.points[i];
    s.b = line_.points[next(i)];
    s.depth_a = line_.depths[i];
    s.depth_b = line_.depths[next(i)];
    if (!line_.ranges.empty()) {
      s.range_a = line_.ranges[i];
      s.range_b = line_.ranges[next(i)];
    }
    s.curve = number;
    s.index = static_cast<std::uint32_t>(i);
    return s;
  }
  double mean(const std::vector<double>& a_point, std::size_t segment) const {
    return 0.5 * (a_point[segment] + a_point[next(segment)]);
  }
  // Paper mm along the line between two of its segments; 0 where they touch.
  double apart(std::size_t i, std::size_t j) const {
    if (i > j) std::swap(i, j);
    const double one_way = along_[j] - along_[std::min(i + 1, j)];
    if (!line_.closed) return one_way;
    return std::min(one_way, along_.back() - along_[j + 1] + along_[i]);
  }

 private:
  const HaloLine& line_;
  std::vector<double> along_;
};

struct Caster {
  PictureSegment segment;
  double half_width = 0;
};

// A stretch of a line that is near to one caster segment.
struct Near {
  std::int32_t curve = -1;
  double begin = 0, end = 0;
  bool behind = false;  // at its middle
  bool crosses = false;
};

struct Interval {
  double begin = 1, end = 0;
  bool empty() const { return begin > end; }
  void add(double low, double high) {
    low = std::max(low, 0.0);
    high = std::min(high, 1.0);
    if (low > high) return;
    begin = empty() ? low : std::min(begin, low);
    end = std::max(end, high);
  }
};

// The share of a segment from `p` along `d` that is nearer than `r` to a point.
void add_disc(Vec2 p, Vec2 d, Vec2 center, double r, Interval& out) {
  const Vec2 from = p - center;
  const double dd = glm::dot(d, d), b = glm::dot(from, d), c = glm::dot(from, from) - r * r;
  if (dd == 0) {
    if (c <= 0) out.add(0, 1);
    return;
  }
  const double root = b * b - dd * c;
  if (root < 0) return;
  const double half = std::sqrt(root) / dd;
  out.add(-b / dd - half, -b / dd + half);
}

// ... that lies beside the segment [a,b] and is nearer than `r` to it: two slabs at right angles.
void add_band(Vec2 p, Vec2 d, Vec2 a, Vec2 b, double r, Interval& out) {
  const double length = glm::length(b - a);
  if (length == 0) return;
  const Vec2 along = (b - a) / length, across(-along.y, along.x);
  double low = 0, high = 1;
  const auto clip = [&](double from, double speed, double least, double most) {
    if (speed == 0) {
      if (from < least || from > most) high = -1;
      return;
    }
    const double u = (least - from) / speed, v = (most - from) / speed;
    low = std::max(low, std::min(u, v));
    high = std::min(high, std::max(u, v));
  };
  clip(glm::dot(p - a, along), glm::dot(d, along), 0, length);
  clip(glm::dot(p - a, across), glm::dot(d, across), -r, r);
  if (low <= high) out.add(low, high);
}

// The share of `s` in the picture that is nearer than `r` to `c`: one stretch, for what is near to
// a segment is convex.
Interval near_share(const PictureSegment& s, const PictureSegment& c, double r) {
  Interval out;
  const Vec2 d = s.b - s.a;
  add_disc(s.a, d, c.a, r, out);
  add_disc(s.a, d, c.b, r, out);
  add_band(s.a, d, c.a, c.b, r, out);
  return out;
}

struct Crossing {
  double here, there;  // shares of both segments in the picture
};

std::optional<Crossing> crossing(const PictureSegment& s, const PictureSegment& c) {
  const Vec2 d = s.b - s.a, e = c.b - c.a;
  const double d_touch = kTouch * glm::length(d), e_touch = kTouch * glm::length(e);
  const double ca = cross2(d, c.a - s.a), cb = cross2(d, c.b - s.a);
  if ((ca > d_touch && cb > d_touch) || (ca < -d_touch && cb < -d_touch)) return std::nullopt;
  const double sa = cross2(e, s.a - c.a), sb = cross2(e, s.b - c.a);
  if ((sa > e_touch && sb > e_touch) || (sa < -e_touch && sb < -e_touch)) return std::nullopt;
  // Lines that run along each other do not cross.
  if (std::max(std::abs(ca), std::abs(cb)) <= d_touch || ca == cb) return std::nullopt;
  if (std::max(std::abs(sa), std::abs(sb)) <= e_touch || sa == sb) return std::nullopt;
  return Crossing{sa / (sa - sb), ca / (ca - cb)};
}

double picture_depth(const PictureSegment& s, double share) {
  return depth_at(s, to_space(s, share));
}

double nearest_share(const PictureSegment& s, Vec2 p) { return nearest_along(s.a, s.b - s.a, p); }

class Haloes {
 public:
  Haloes(std::span<const HaloLine> lines, const HaloOptions& options)
      : lines_(lines), options_(options) {
    courses_.reserve(lines.size());
    for (const HaloLine& line : lines) courses_.emplace_back(line);
    for (std::size_t l = 0; l < lines.size(); ++l) add_casters(l);
    std::vector<PictureSegment> segments;
    segments.reserve(casters_.size());
    double widest = 0, overhang = 0;
    for (const Caster& c : casters_) {
      segments.push_back(c.segment);
      widest = std::max(widest, c.half_width);
    }
    for (const HaloLine& line : lines) overhang = std::max(overhang, line.overhang);
    widest_ = options.gap + widest;
    grid_ = SegmentGrid(segments, widest_ + overhang);
  }

  std::vector<HaloGap> gaps(std::size_t l) const {
    std::vector<HaloGap> out;
    std::vector<Near> near;
    std::vector<std::uint32_t> found;
    for (std::size_t i = 0; i < courses_[l].segment_count(); ++i) {
      const PictureSegment s = courses_[l].segment(i, static_cast<std::int32_t>(l));
      if (!is_finite(s)) continue;
      found.clear();
      // Casters lie in the grid with the full reach; the segment itself need not be thickened.
      grid_.visit(s, kTouch, [&](std::uint32_t c) { found.push_back(c); });
      std::sort(found.begin(), found.end());
      found.erase(std::unique(found.begin(), found.end()), found.end());
      for (const std::uint32_t c : found) meet(l, s, casters_[c], near, out);
    }
    join(near, lines_[l].closed ? static_cast<double>(courses_[l].segment_count()) : 0, out);
    return apart(std::move(out));
  }

 private:
  void add_casters(std::size_t l) {
    const HaloLine& line = lines_[l];
    const std::size_t n = courses_[l].segment_count();
    for (const HaloCaster& cast : line.casters) {
      for (auto i = static_cast<std::size_t>(std::max(0.0, cast.begin));
           i < n && static_cast<double>(i) < cast.end; ++i) {
        const auto at = static_cast<double>(i);
        const double low = std::max(0.0, cast.begin - at), high = std::min(1.0, cast.end - at);
        const PictureSegment whole = courses_[l].segment(i, static_cast<std::int32_t>(l));
        const PictureSegment s = part_of(whole, low, high);
        if (!is_finite(s)) continue;
        const double scale = line.scale.empty() ? 1 : courses_[l].mean(line.scale, i);
        casters_.push_back({s, cast.half_width * scale});
      }
    }
  }

  void meet(std::size_t l, const PictureSegment& s, const Caster& caster, std::vector<Near>& near,
            std::vector<HaloGap>& gaps) const {
    const HaloLine& line = lines_[l];
    const PictureSegment& c = caster.segment;
    const double r = options_.gap + caster.half_width + line.overhang;
    if (s.curve == c.curve && courses_[l].apart(s.index, c.index) < kOwnCourse * r) return;
    const Interval share = near_share(s, c, r);
    if (share.empty()) return;
    Near n;
    n.curve = c.curve;
    n.begin = s.index + to_space(s, share.begin);
    n.end = s.index + to_space(s, share.end);
    const double middle = 0.5 * (share.begin + share.end);
    const Vec2 p = glm::mix(s.a, s.b, middle);
    const double beside = nearest_share(c, p);
    const double depth = picture_depth(c, beside) - picture_depth(s, middle);
    n.behind = depth > options_.behind;
    const double slope = line.slopes.empty() ? 0 : courses_[l].mean(line.slopes, s.index);
    if (const auto x = crossing(s, c)) {
      const double least = options_.behind + kOnPaper * (slope + steepness(s) + steepness(c));
      n.crosses = picture_depth(c, x->there) - picture_depth(s, x->here) > least;
    }
    if (!line.slopes.empty() && !n.crosses) {
      const double distance = glm::distance(p, glm::mix(c.a, c.b, beside));
      const double least = options_.behind + (kBending * distance + kOnPaper) * slope +
                           (distance + kOnPaper) * steepness(c);
      if (depth > least) gaps.push_back({n.begin, n.end});
    }
    if (n.behind || n.crosses) near.push_back(n);
  }

  // Runs of stretches that are near to one caster, as far as they hang together, count where one of
  // them crosses it. `turn`: the segment count of a closed line.
  static void join(std::vector<Near>& near, double turn, std::vector<HaloGap>& out) {
    constexpr double kRounding = 1e-9;  // of a segment
    std::sort(near.begin(), near.end(), [](const Near& a, const Near& b) {
      return std::tie(a.curve, a.begin, a.end) < std::tie(b.curve, b.begin, b.end);
    });
    std::size_t first = 0;
    while (first < near.size()) {
      std::vector<Near> runs;
      std::size_t i = first;
      for (; i < near.size() && near[i].curve == near[first].curve; ++i) {
        if (runs.empty() || near[i].begin > runs.back().end + kRounding) {
          runs.push_back(near[i]);
        } else {
          runs.back().end = std::max(runs.back().end, near[i].end);
          runs.back().crosses = runs.back().crosses || near[i].crosses;
        }
      }
      first = i;
      if (turn > 0 && runs.size() > 1 && runs.front().begin <= kRounding &&
          runs.back().end >= turn - kRounding) {
        const bool either = runs.front().crosses || runs.back().crosses;
        runs.front().crosses = runs.back().crosses = either;
      }
      for (const Near& run : runs) {
        if (run.crosses) out.push_back({run.begin, run.end});
      }
    }
  }

  static std::vector<HaloGap> apart(std::vector<HaloGap> gaps) {
    std::sort(gaps.begin(), gaps.end(), [](const HaloGap& a, const HaloGap& b) {
      return std::tie(a.begin, a.end) < std::tie(b.begin, b.end);
    });
    std::vector<HaloGap> out;
    for (const HaloGap& g : gaps) {
      if (out.empty() || g.begin > out.back().end) {
        out.push_back(g);
      } else {
        out.back().end = std::max(out.back().end, g.end);
      }
    }
    return out;
  }

  std::span<const HaloLine> lines_;
  const HaloOptions& options_;
  std::vector<Course> courses_;
  std::vector<Caster> casters_;
  double widest_ = 0;
  SegmentGrid grid_;
};

}  // namespace

std::vector<std::vector<HaloGap>> halo_gaps(std::span<const HaloLine> lines,
                                            const HaloOptions& options, const RunContext& context) {
  std::vector<std::vector<HaloGap>> out(lines.size());
  const Haloes haloes(lines, options);
  parallel_for(
      lines.size(), kLineGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t l = begin; l < end; ++l) {
          if (lines[l].interrupted) out[l] = haloes.gaps(l);
        }
      },
      &context);
  return out;
}

}  // namespace burin
