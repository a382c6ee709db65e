#include "contours.h"
#include "paper_limits.h"

#include <cstddef>
#include <optional>

namespace burin {

namespace {

/// Follows a sum and tells where it turns for good: a turn counts once the sum has come back from
/// its extreme by the threshold.
class Hysteresis {
 public:
  explicit Hysteresis(double threshold) : threshold_(threshold) {}

  /// The sum at the next point. Returns the index of a turn that has just been proven.
  std::optional<std::size_t> add(double sum) {
    const std::size_t i = count_++;
    if (i == 0 || sum > high_) high_ = sum, high_at_ = i;
    if (i == 0 || sum < low_) low_ = sum, low_at_ = i;
    if (direction_ <= 0 && sum - low_ >= threshold_) return turn(+1, low_at_, sum, i);
    if (direction_ >= 0 && high_ - sum >= threshold_) return turn(-1, high_at_, sum, i);
    return {};
  }
  /// +1 up, -1 down, 0 not known yet.
  int direction() const { return direction_; }

 private:
  std::optional<std::size_t> turn(int direction, std::size_t at, double sum, std::size_t i) {
    const bool first = direction_ == 0;
    direction_ = direction;
    high_ = low_ = sum;
    high_at_ = low_at_ = i;
    if (first) return {};
    return at;
  }

  double threshold_;
  double high_ = 0, low_ = 0;
  std::size_t high_at_ = 0, low_at_ = 0, count_ = 0;
  int direction_ = 0;
};

/// Paper mm that each segment goes to the right way: positive where the front side is the nearer
/// one.
std::vector<double> signed_lengths(const std::vector<Vec3>& points,
                                   const std::vector<Vec3>& normals, bool closed,
                                   const Camera& camera) {
  const std::size_t n = points.size();
  std::vector<double> out(closed ? n : n - 1);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const std::size_t j = (i + 1) % n;
    const Vec3 v = camera.to_viewer(points[i]);
    const Vec3 right_way = normalize_or(glm::cross(v, normals[i] + normals[j]), Vec3(0));
    out[i] = glm::dot(points[j] - points[i], right_way) * camera.scale_at(points[i]);
  }
  return out;
}

}  // namespace

std::vector<std::uint8_t> folded_under(const std::vector<Vec3>& points,
                                       const std::vector<Vec3>& normals, bool closed,
                                       const Camera& camera) {
  const std::vector<double> lengths = signed_lengths(points, normals, closed, camera);
  const std::size_t m = lengths.size();
  // A closed curve is gone round three times: the first lap finds the state that the second begins
  // in, the third proves the turns at the end of the second.
  const std::size_t laps = closed ? 3 : 1, first = closed ? m : 0;
  std::vector<std::uint8_t> folded(laps * m, 0);
  Hysteresis hysteresis(kCuspLength);
  double sum = 0;
  std::size_t done = 0;
  hysteresis.add(0);
  for (std::size_t i = 0; i < folded.size(); ++i) {
    const int before = hysteresis.direction();
    sum += lengths[i % m];
    const auto turned = hysteresis.add(sum);
    if (!turned) continue;
    for (; done < *turned; ++done) folded[done] = before < 0;
  }
  const bool rest = hysteresis.direction() == 0 ? sum < 0 : hysteresis.direction() < 0;
  for (; done < folded.size(); ++done) folded[done] = rest;
  return {folded.begin() + static_cast<std::ptrdiff_t>(first),
          folded.begin() + static_cast<std::ptrdiff_t>(first + m)};
}

}  // namespace burin
