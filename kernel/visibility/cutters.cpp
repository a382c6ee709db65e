#include "cutters.h"

#include "picture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace burin {
Cutters::Cutters(std::vector<PictureSegment> segments, double same_depth)
    : segments_(std::move(segments)), same_depth_(same_depth) {
  std::erase_if(segments_, [](const PictureSegment& s) { return !is_finite(s); });
  grid_ = SegmentGrid(segments_, kReach);
}

void Cutters::cross(const PictureSegment& s, CutRule rule, Crossings& out) const {
  if (segments_.empty() || !is_finite(s)) return;
  if (even_ > 0) {
    const double length = glm::length(s.b - s.a);
    for (double at = 0; at < length; at += even_) out.cuts.push_back(to_space(s, at / length));
    return;
  }
  grid_.visit(s, kReach, [&](std::uint32_t i) {
    ++out.tests;
    if (!follow_each_other(s, segments_[i])) cross_one(s, segments_[i], rule, out);
  });
}

double Cutters::expected_cuts(double length) const {
  Box2 box;
  double own = 0;
  for (const PictureSegment& s : segments_) {
    box.add(s.a);
    box.add(s.b);
    own += glm::length(s.b - s.a);
  }
  const double area = box.empty() ? 0 : box.size().x * box.size().y;
  return area > 0 ? 2 * own * length / (std::numbers::pi * area) : 0;
}

bool Cutters::nearer_at(const PictureSegment& s, double space, const PictureSegment& cutter,
                        double share, double sign) const {
  return depth_at(cutter, to_space(cutter, share)) > depth_at(s, space) + sign * same_depth_;
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
  if (rule == CutRule::AnyDepth || nearer_at(s, space, cutter, share, -1)) {
    out.cuts.push_back(space);
  }
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
      if (rule == CutRule::AnyDepth || nearer_at(s, end, cutter, u, -1)) out.cuts.push_back(end);
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
    if (rule == CutRule::AnyDepth || nearer_at(s, ends[i], cutter, share(at), -1)) {
      out.cuts.push_back(ends[i]);
    }
    nearer = nearer && nearer_at(s, ends[i], cutter, share(at), +1);
  }
  if (nearer) out.covered.push_back({ends[0], ends[1]});
}

}  // namespace burin
