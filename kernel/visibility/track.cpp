#include "track.h"

#include <algorithm>
#include <cmath>

namespace burin {

Track::Track(const Curve3& curve, const Camera& camera) : closed_(curve.closed) {
  const std::size_t n = curve.points.size();
  xy_.reserve(n);
  depth_.reserve(n);
  range_.reserve(n);
  const double eye = camera.perspective() ? camera.depth(camera.eye()) : 0;
  for (const Vec3& p : curve.points) {
    xy_.push_back(camera.to_paper(p));
    depth_.push_back(camera.depth(p));
    range_.push_back(camera.perspective() ? eye - depth_.back() : 1.0);
  }
  const std::size_t segments = curve.segment_count();
  length_.reserve(segments + 1);
  length_.push_back(0);
  for (std::size_t i = 0; i < segments; ++i) {
    length_.push_back(length_.back() + glm::length(end(i) - start(i)));
  }
}

PictureSegment Track::segment(std::size_t i, std::int32_t curve) const {
  const std::size_t j = next(i), n = segment_count();
  const std::size_t before = i > 0 ? i - 1 : closed_ ? n - 1 : i;
  const std::size_t after = i + 1 < n ? i + 1 : closed_ ? 0 : i;
  return {xy_[i],
          xy_[j],
          depth_[i],
          depth_[j],
          range_[i],
          range_[j],
          curve,
          static_cast<std::uint32_t>(i),
          static_cast<std::uint32_t>(before),
          static_cast<std::uint32_t>(after)};
}

double Track::length_at(double parameter) const {
  const auto n = static_cast<double>(segment_count());
  const double turns = closed_ ? std::floor(parameter / n) : 0;
  parameter -= turns * n;
  const auto i = std::min(static_cast<std::size_t>(parameter), segment_count() - 1);
  const double s = picture_share(parameter - static_cast<double>(i), range_[i], range_[next(i)]);
  return turns * length() + length_[i] + s * (length_[i + 1] - length_[i]);
}

double Track::parameter_at(double length) const {
  const double turns = closed_ && length_.back() > 0 ? std::floor(length / length_.back()) : 0;
  length -= turns * length_.back();
  const auto after = std::upper_bound(length_.begin() + 1, length_.end() - 1, length);
  const auto i = static_cast<std::size_t>(after - length_.begin()) - 1;
  const double d = length_[i + 1] - length_[i];
  const double s = d > 0 ? std::clamp((length - length_[i]) / d, 0.0, 1.0) : 0.5;
  return turns * static_cast<double>(segment_count()) + static_cast<double>(i) +
         space_share(s, range_[i], range_[next(i)]);
}

Vec2 Track::direction(std::size_t segment) const {
  const Vec2 d = end(segment) - start(segment);
  const double n = glm::length(d);
  return n > 0 ? d / n : Vec2(0);
}

}  // namespace burin
