#include "frame_path.h"
#include "layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace burin::detail {
namespace {

/// Paper mm between what is measured and the extension line that begins at it.
constexpr double kGap = 0.8;
/// Paper mm: ink that near is on an extension line.
constexpr double kOnLine = 0.05;
/// Share of its length that a direction is seen with at the least, and sine between lines.
constexpr double kSeen = 0.2;
/// Steps outwards that are tried.
constexpr int kMostSteps = 40;
/// Ends beside each other that are tried in an oblique view.
constexpr std::size_t kMostEnds = 12;

struct Ends {
  Vec3 from{0}, to{0};
};

/// Where a number stands: in the middle of its line, between that and an end, beyond an end, or a
/// step beyond it.
enum class NumberAt { Within, TowardsRight, TowardsLeft, Right, Left, FarRight, FarLeft };
constexpr std::array kNumberPlaces{NumberAt::Within, NumberAt::TowardsRight, NumberAt::TowardsLeft,
                                   NumberAt::Right,  NumberAt::Left,         NumberAt::FarRight,
                                   NumberAt::FarLeft};

bool is_far(NumberAt number) { return number == NumberAt::FarRight || number == NumberAt::FarLeft; }
bool is_at_right(NumberAt number) {
  return number == NumberAt::Right || number == NumberAt::FarRight;
}
bool is_at_left(NumberAt number) { return number == NumberAt::Left || number == NumberAt::FarLeft; }
bool is_within(NumberAt number) { return !is_at_right(number) && !is_at_left(number); }

/// A length with its line on one side.
class LengthSide {
 public:
  LengthSide(const Dimension& dimension, const Ends& ends, Vec3 outwards,
             const DimensionGround& ground)
      : ground_(ground),
        letters_(dimension, ground.style.height),
        from_(ground.view.at(ends.from)),
        to_(ground.view.at(ends.to)) {
    length_ = glm::distance(from_, to_);
    along_ = (to_ - from_) / length_;
    way_ = glm::normalize(Vec2(ground.view.axes * outwards));
    across_ = std::abs(cross2(along_, way_));
    const Vec2 side(-along_.y, along_.x);
    outwards_ = glm::dot(side, way_) < 0 ? -side : side;
    upwards_ = std::abs(outwards.z) > 1 - 1e-6 && !is_seen_square(ground.view.axes, outwards);
    deep_ = -ground.view.scale * glm::dot(glm::transpose(ground.view.axes)[2], ends.from);
    square_ = across_ > 1 - 1e-6;
    exit_ = exit_of(from_, to_, way_, ground.outline);
    reach_ = exit_ + (ground.first() + ground.taken_in(way_)) / across_;
    step_beyond_others();
    from_ink_ = dimension.from_points.empty() && dimension.to_points.empty();
    starts_ = {start_of(from_, dimension.from_points), start_of(to_, dimension.to_points)};
  }

  DimensionPlace best() const {
    DimensionPlace best;
    best.cost = std::numeric_limits<double>::infinity();
    const double h = ground_.style.height, room = letters_.width() + kBeyondLine * h;
    const bool within = length_ >= room;
    for (const NumberAt number : kNumberPlaces) {
      if (!within && is_within(number)) continue;
      DimensionPlace place =
          first_free([&](int step) { return at_step(step, number); }, kMostSteps, ground_);
      if (place.cost < best.cost - 1e-9) best = std::move(place);
    }
    return best;
  }

 private:
  /// Whether the number reads from the first end to the second: to the right, or upwards.
  bool reads_along() const {
    constexpr double kUpright = 1e-9;
    return along_.x > kUpright || (along_.x > -kUpright && along_.y > 0);
  }

  /// Shorter ones that measure along the same stretch stay nearer to the drawing.
  void step_beyond_others() {
    constexpr double kSame = 1e-6, kTouch = 0.1;  // paper mm
    const double low = std::min(glm::dot(from_, along_), glm::dot(to_, along_)),
                 high = std::max(glm::dot(from_, along_), glm::dot(to_, along_));
    for (std::size_t i = 0; i < std::min(ground_.own, ground_.laid.size()); ++i) {
      const DimensionPlace& other = ground_.laid[i];
      if (glm::distance(other.outwards, outwards_) > kSame) continue;
      const double sense = glm::dot(Vec2(-other.outwards.y, other.outwards.x), along_);
      const double a = sense * other.low, b = sense * other.high;
      if (std::min(a, b) > high - kTouch || std::max(a, b) < low + kTouch) continue;
      const double now = glm::dot(from_ + reach_ * way_, outwards_);
      reach_ += std::max(0.0, other.level + ground_.step() - now) / across_;
    }
  }

  /// How far out an extension line begins: at the outermost point on it, or at its last ink.
  double start_of(Vec2 end, const std::vector<Vec3>& points) const {
    std::optional<double> last;
    const auto look_at = [&](Vec2 p) {
      const double out = glm::dot(p - end, way_);
      if (out > reach_ || std::abs(cross2(p - end, way_)) > kOnLine) return;
      last = last ? std::max(*last, out) : out;
    };
    for (const Vec3& p : points) look_at(ground_.view.at(p));
    if (!points.empty()) return last.value_or(0);
    if (!ground_.drawn) return exit_of(end, end, way_, ground_.part);
    if (!square_) last = 0;
    for (const Layer& layer : ground_.drawn->layers) {
      for (const Path& path : layer.paths) {
        // Frames and letters are no outline of the part.
        if (path.visible && path.kind != LineClass::Frame)
          std::ranges::for_each(path.points, look_at);
      }
    }
    return last.value_or(0);
  }

  void add_line(Vec2 a, Vec2 b, Stroke stroke, DimensionPlace& out) const {
    out.layer.paths.push_back(line(a, b, ground_.style.line));
    out.print.pieces.push_back({a, b, stroke});
  }

  DimensionPlace at_step(int step, NumberAt number) const {
    const double h = ground_.style.height, reach = reach_ + step * ground_.step() / across_;
    DimensionPlace out;
    const Vec2 a = from_ + reach * way_, b = to_ + reach * way_;
    for (int end = 0; end < 2; ++end) {
      const Vec2 at = end == 0 ? from_ : to_;
      const double start = starts_[static_cast<std::size_t>(end)] + kGap,
                   stop = reach + kBeyondLine * h;
      if (start < stop) add_line(at + start * way_, at + stop * way_, Stroke::Extension, out);
    }
    const double arrow = kArrow * h, width = letters_.width();
    const bool inside = is_within(number) && length_ >= width + 2.5 * arrow;
    const Vec2 right_way = reads_along() ? along_ : -along_;
    const Vec2 left = reads_along() ? a : b, right = reads_along() ? b : a;
    Vec2 middle = 0.5 * (a + b);
    const double room = 0.5 * std::max(length_ - width - (inside ? 2.5 * arrow : 0), 0.0);
    if (number == NumberAt::TowardsRight) middle += room * right_way;
    if (number == NumberAt::TowardsLeft) middle -= room * right_way;
    if (inside) {
      add_line(a + 0.5 * arrow * along_, b - 0.5 * arrow * along_, Stroke::Dimension, out);
    } else {
      const double away = 2 * arrow + (is_far(number) ? ground_.step() : 0),
                   beyond = width + kBeyondLine * h;
      const double to_right = is_at_right(number) ? away + beyond : 2 * arrow,
                   to_left = is_at_left(number) ? away + beyond : 2 * arrow;
      add_line(left - to_left * right_way, right + to_right * right_way, Stroke::Dimension, out);
      if (is_at_right(number)) middle = right + (away + 0.5 * beyond) * right_way;
      if (is_at_left(number)) middle = left - (away + 0.5 * beyond) * right_way;
    }
    out.layer.paths.push_back(arrow_head(a, inside ? -along_ : along_, arrow));
    out.layer.paths.push_back(arrow_head(b, inside ? along_ : -along_, arrow));
    const Vec2 up(-right_way.y, right_way.x);
    const Vec2 low = middle - 0.5 * width * right_way + kBelowText * h * up;
    letters_.lay(low, right_way, out.layer);
    out.print.letters.push_back(letters_.quad(low, right_way));
    out.outwards = outwards_;
    out.level = glm::dot(a, outwards_);
    const Vec2 axis(-outwards_.y, outwards_.x);
    out.low = std::min(glm::dot(a, axis), glm::dot(b, axis));
    out.high = std::max(glm::dot(a, axis), glm::dot(b, axis));
    out.cost = cost_of(reach, number);
    return out;
  }

  /// Across its length, below what is wide and at the left of what is high; extension lines short,
  /// above all those that run over the drawing.
  double cost_of(double reach, NumberAt number) const {
    constexpr double kSide = 5, kSlant = 20, kLong = 0.1;
    // The other side is better than 7 mm more over the part; in oblique views lines over it lead
    // from what is seen.
    const double over = square_ ? 1.5 : 0.3;
    constexpr double kBeyondEnd = 3, kOtherEnd = 1, kOffMiddle = 2, kFar = 4;
    // Lengths on the ground are measured there, where a view shows more than one way.
    constexpr double kUpwards = 12;
    const bool wide = std::abs(along_.x) >= std::abs(along_.y) - 1e-9;
    const double slant = std::abs(glm::dot(along_, way_));
    const double start = 0.5 * (starts_[0] + starts_[1]);
    // Of ends that may do, those before the part.
    constexpr double kDeep = 0.2;
    return kDeep * deep_ + kSlant * slant + kSide * (wide ? way_.y : way_.x) +
           (from_ink_ ? 0 : over * std::max(exit_ - start, 0.0)) + kLong * (reach - exit_) +
           (is_within(number) ? 0 : kBeyondEnd) + (number == NumberAt::Within ? 0 : kOffMiddle) +
           (is_at_left(number) ? kOtherEnd : 0) + (is_far(number) ? kFar : 0) +
           (upwards_ ? kUpwards : 0);
  }

  const DimensionGround& ground_;
  DimensionLetters letters_;
  Vec2 from_, to_, along_{1, 0}, way_{0, 1}, outwards_{0, 1};
  double length_ = 0, across_ = 1, exit_ = 0, reach_ = 0;
  /// Paper mm away from the viewer.
  double deep_ = 0;
  bool square_ = false, upwards_ = false, from_ink_ = false;
  std::array<double, 2> starts_{};
};

/// The ways across a length in which its line may stand: across it on paper where it lies in the
/// sheet, else along the axes of space.
std::vector<Vec3> ways_of(const Dimension& dimension, Vec3 along, const PaperView& view) {
  if (dimension.outwards != Vec3(0)) return {dimension.outwards};
  std::vector<Vec3> ways;
  const auto add = [&](Vec3 way) {
    const Vec3 across = reject(way, along);
    if (glm::length(across) < kSeen) return;
    for (const double sign : {-1.0, 1.0}) ways.push_back(sign * glm::normalize(across));
  };
  if (is_seen_square(view.axes, along)) {
    add(glm::cross(glm::transpose(view.axes)[2], along));
  } else {
    for (int k = 0; k < 3; ++k) {
      Vec3 axis(0);
      axis[k] = 1;
      add(axis);
    }
  }
  return ways;
}

/// Where both ends have points side by side: those farthest out, so that lines are short.
std::vector<Ends> ends_of(const Dimension& dimension, Vec3 along, Vec3 way, const PaperView& view) {
  const Ends own{dimension.from, dimension.to};
  if (is_seen_square(view.axes, along) || dimension.from_points.empty()) return {own};
  const Vec3 side = glm::cross(along, way);
  const double near = 1e-6 * glm::distance(own.from, own.to);
  std::vector<Ends> out;
  const auto at = [&](double across, double outwards, Vec3 end) {
    return end + (across - glm::dot(end, side)) * side + (outwards - glm::dot(end, way)) * way;
  };
  const auto farthest = [&](const std::vector<Vec3>& points, double across) {
    std::optional<double> most;
    for (const Vec3& p : points) {
      if (std::abs(glm::dot(p, side) - across) > near) continue;
      most = std::max(most.value_or(glm::dot(p, way)), glm::dot(p, way));
    }
    return most;
  };
  std::vector<double> tried;
  for (const Vec3& p : dimension.from_points) {
    const double across = glm::dot(p, side);
    if (std::ranges::any_of(tried, [&](double t) { return std::abs(t - across) <= near; }))
      continue;
    tried.push_back(across);
    const auto from = farthest(dimension.from_points, across),
               to = farthest(dimension.to_points, across);
    if (!from || !to) continue;
    // The line is along the length: both ends are as far out.
    const double outwards = std::max(*from, *to);
    out.push_back({at(across, outwards, own.from), at(across, outwards, own.to)});
  }
  std::ranges::stable_sort(
      out, {}, [&](const Ends& e) { return std::round(-1e6 * glm::dot(e.from + e.to, way)); });
  if (out.size() > kMostEnds) out.resize(kMostEnds);
  if (out.empty()) out.push_back(own);
  return out;
}

}  // namespace

DimensionPlace place_length(const Dimension& dimension, const DimensionGround& ground) {
  const PaperView& view = ground.view;
  DimensionPlace best;
  best.cost = std::numeric_limits<double>::infinity();
  const Vec3 gap = dimension.to - dimension.from;
  if (!(glm::length(gap) > 0)) return {};
  const Vec3 along = glm::normalize(gap);
  const Vec2 on_paper(view.axes * along);
  if (glm::length(on_paper) < kSeen) return {};
  for (const Vec3& way : ways_of(dimension, along, view)) {
    const Vec2 out(view.axes * way);
    if (glm::length(out) < kSeen) continue;
    if (std::abs(cross2(glm::normalize(on_paper), glm::normalize(out))) < kSeen) continue;
    for (const Ends& ends : ends_of(dimension, along, way, view)) {
      DimensionPlace place = LengthSide(dimension, ends, way, ground).best();
      if (place.cost < best.cost - 1e-9) best = std::move(place);
    }
  }
  return best;
}

}  // namespace burin::detail
