#include "cutters.h"

#include "picture.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

double depth_at(const PictureSegment& s, double space) {
  return s.depth_a + space * (s.depth_b - s.depth_a);
}

double to_space(const PictureSegment& s, double picture) {
  return space_share(std::clamp(picture, 0.0, 1.0), s.range_a, s.range_b);
}

bool finite(const PictureSegment& s) {
  return std::isfinite(s.a.x + s.a.y + s.b.x + s.b.y) && s.range_a > 0 && s.range_b > 0;
}

}  // namespace

Cutters::Cutters(std::vector<PictureSegment> segments, double same_depth)
    : segments_(std::move(segments)), same_depth_(same_depth) {
  std::erase_if(segments_, [](const PictureSegment& s) { return !finite(s); });
  if (segments_.empty()) return;
  double total = 0;
  for (const PictureSegment& s : segments_) {
    box_.add(s.a);
    box_.add(s.b);
    total += glm::length(s.b - s.a);
  }
  box_.min -= 2 * kReach;
  box_.max += 2 * kReach;
  // About one cutter a cell where they are dense; never much smaller than a cutter, which would be
  // in many cells.
  const Vec2 size = box_.size();
  const auto n = static_cast<double>(segments_.size());
  cell_ =
      std::max({std::sqrt(size.x * size.y / n), 0.5 * total / n, 1e-4 * std::max(size.x, size.y)});
  columns_ = static_cast<int>(size.x / cell_) + 1;
  rows_ = static_cast<int>(size.y / cell_) + 1;
  first_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
  for (const PictureSegment& s : segments_) {
    visit_cells(s, [&](std::size_t cell) { ++first_[cell + 1]; });
  }
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  members_.resize(first_.back());
  std::vector<std::uint32_t> fill(first_.begin(), first_.end() - 1);
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    visit_cells(segments_[i],
                [&](std::size_t cell) { members_[fill[cell]++] = static_cast<std::uint32_t>(i); });
  }
}

// All cells that the segment, thickened by the reach, touches: row by row.
template <class Visit>
void Cutters::visit_cells(const PictureSegment& s, Visit&& visit) const {
  const Vec2 lo = glm::min(s.a, s.b) - kReach, hi = glm::max(s.a, s.b) + kReach;
  if (hi.x < box_.min.x || hi.y < box_.min.y || lo.x > box_.max.x || lo.y > box_.max.y) return;
  const auto column = [&](double x) {
    return std::clamp(
        static_cast<int>((std::clamp(x, box_.min.x, box_.max.x) - box_.min.x) / cell_), 0,
        columns_ - 1);
  };
  const auto row = [&](double y) {
    return std::clamp(
        static_cast<int>((std::clamp(y, box_.min.y, box_.max.y) - box_.min.y) / cell_), 0,
        rows_ - 1);
  };
  const int first_row = row(lo.y), last_row = row(hi.y);
  const double slope = s.a.y == s.b.y ? 0 : (s.b.x - s.a.x) / (s.b.y - s.a.y);
  for (int j = first_row; j <= last_row; ++j) {
    double x0 = lo.x, x1 = hi.x;
    if (first_row != last_row && s.a.y != s.b.y) {
      const double y0 = box_.min.y + j * cell_ - kReach, y1 = y0 + cell_ + 2 * kReach;
      const double u = s.a.x + (y0 - s.a.y) * slope, v = s.a.x + (y1 - s.a.y) * slope;
      x0 = std::max(x0, std::min(u, v) - kReach);
      x1 = std::min(x1, std::max(u, v) + kReach);
      if (x0 > x1) continue;
    }
    if (x0 > box_.max.x || x1 < box_.min.x) continue;
    const int last = column(x1);
    for (int i = column(x0); i <= last; ++i) {
      visit(static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) +
            static_cast<std::size_t>(i));
    }
  }
}

void Cutters::cross(const PictureSegment& s, CutRule rule, Crossings& out) const {
  if (segments_.empty() || !finite(s)) return;
  visit_cells(s, [&](std::size_t cell) {
    for (std::uint32_t i = first_[cell]; i < first_[cell + 1]; ++i) {
      const PictureSegment& cutter = segments_[members_[i]];
      if (!follow_each_other(s, cutter)) cross_one(s, cutter, rule, out);
    }
  });
}

bool Cutters::cuts_at(const PictureSegment& s, double space, const PictureSegment& cutter,
                      double share, CutRule rule, double sign) const {
  return rule == CutRule::AnyDepth ||
         depth_at(cutter, to_space(cutter, share)) > depth_at(s, space) + sign * same_depth_;
}

void Cutters::cross_one(const PictureSegment& s, const PictureSegment& cutter, CutRule rule,
                        Crossings& out) const {
  const Vec2 d = s.b - s.a, e = cutter.b - cutter.a;
  const double d_reach = kReach * glm::length(d), e_reach = kReach * glm::length(e);
  // Twice the areas: distances of the ends from the other's line times its length.
  const double ca = cross2(d, cutter.a - s.a), cb = cross2(d, cutter.b - s.a);
  if ((ca > d_reach && cb > d_reach) || (ca < -d_reach && cb < -d_reach)) return;
  const double sa = cross2(e, s.a - cutter.a), sb = cross2(e, s.b - cutter.a);
  if ((sa > e_reach && sb > e_reach) || (sa < -e_reach && sb < -e_reach)) return;
  const bool along_s = std::max(std::abs(ca), std::abs(cb)) <= d_reach;
  const bool along_cutter = std::max(std::abs(sa), std::abs(sb)) <= e_reach;
  if (along_s || along_cutter) return cross_parallel(s, cutter, rule, out);
  if (sa == sb || ca == cb) return;
  const double at = sa / (sa - sb), share = ca / (ca - cb);
  const double space = to_space(s, at);
  if (cuts_at(s, space, cutter, share, rule, -1)) out.cuts.push_back(space);
}

// One lies within the reach of the other's line: they share a stretch, a point or nothing.
void Cutters::cross_parallel(const PictureSegment& s, const PictureSegment& cutter, CutRule rule,
                             Crossings& out) const {
  const Vec2 d = s.b - s.a, e = cutter.b - cutter.a;
  const double dd = glm::dot(d, d), ee = glm::dot(e, e);
  if (dd == 0) {  // seen end on: one place in the picture
    const double u = ee > 0 ? glm::dot(s.a - cutter.a, e) / ee : 0;
    if (glm::length(cutter.a + std::clamp(u, 0.0, 1.0) * e - s.a) > kReach) return;
    for (const double end : {0.0, 1.0}) {
      if (cuts_at(s, end, cutter, u, rule, -1)) out.cuts.push_back(end);
    }
    return;
  }
  const double reach = kReach / std::sqrt(dd);
  const double u = glm::dot(cutter.a - s.a, d) / dd, v = glm::dot(cutter.b - s.a, d) / dd;
  const double from = std::max(0.0, std::min(u, v)), to = std::min(1.0, std::max(u, v));
  if (from > to + reach) return;
  const auto share = [&](double at) {
    return ee > 0 ? glm::dot(s.a + at * d - cutter.a, e) / ee : 0;
  };
  bool nearer = to - from > reach;
  double ends[2];
  for (int i = 0; i < 2; ++i) {
    const double at = std::clamp(i == 0 ? from : to, 0.0, 1.0);
    ends[i] = to_space(s, at);
    if (cuts_at(s, ends[i], cutter, share(at), rule, -1)) out.cuts.push_back(ends[i]);
    nearer = nearer && cuts_at(s, ends[i], cutter, share(at), rule, +1);
  }
  if (nearer && rule == CutRule::NearerOrAt) out.covered.push_back({ends[0], ends[1]});
}

}  // namespace burin
