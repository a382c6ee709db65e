#include "frame_path.h"
#include "layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace burin::detail {
namespace {

/// Paper mm between a side and the extension line that begins at it.
constexpr double kSideGap = 0.8;
constexpr int kMostArcs = 200;

/// A side of an angle from where both meet: its way on paper, and from where to where there is
/// something of it.
struct Side {
  Vec2 way{1, 0};
  double near = 0, far = 0;
};

Side side_of(Vec2 vertex, Vec2 end, const std::vector<Vec3>& points, const PaperView& view) {
  Side out{glm::normalize(end - vertex), 0, glm::distance(end, vertex)};
  out.near = out.far;
  for (const Vec3& p : points)
    out.near = std::min(out.near, glm::dot(view.at(p) - vertex, out.way));
  out.near = std::max(out.near, 0.0);
  return out;
}

/// An arc between the sides, or between what they would be beyond where they meet.
class AngleArc {
 public:
  AngleArc(const Dimension& dimension, bool beyond, const DimensionGround& ground)
      : ground_(ground),
        letters_(dimension, ground.style.height),
        vertex_(ground.view.at(dimension.from)),
        beyond_(beyond),
        sides_{
            side_of(vertex_, ground.view.at(dimension.to), dimension.from_points, ground.view),
            side_of(vertex_, ground.view.at(dimension.other), dimension.to_points, ground.view)} {
    const Vec2 a = sense() * sides_[0].way, b = sense() * sides_[1].way;
    first_ = std::atan2(a.y, a.x);
    sweep_ = std::atan2(cross2(a, b), glm::dot(a, b));
  }

  DimensionPlace best() const {
    return first_free([this](int step) { return at_step(step); }, kMostArcs, ground_);
  }

 private:
  double sense() const { return beyond_ ? -1 : 1; }
  Vec2 at(double radius, double angle) const {
    return vertex_ + radius * Vec2(std::cos(angle), std::sin(angle));
  }

  void add_extensions(double radius, DimensionPlace& out) const {
    for (const Side& side : sides_) {
      // Beyond where both meet a line goes on from the near end of its side.
      const double start = beyond_ ? -side.near + kSideGap : side.far + kSideGap,
                   stop = radius + kBeyondLine * ground_.style.height;
      if (start >= stop) continue;
      const Vec2 a = vertex_ + start * sense() * side.way, b = vertex_ + stop * sense() * side.way;
      out.layer.paths.push_back(line(a, b, ground_.style.line));
      out.print.pieces.push_back({a, b, Stroke::Extension});
    }
  }

  void add_arc(double radius, DimensionPlace& out) const {
    const double arrow = kArrow * ground_.style.height, turn = arrow / radius,
                 way = sweep_ < 0 ? -1 : 1;
    const bool inside = std::abs(sweep_) > 2.5 * turn;
    const double over = inside ? -0.5 * turn : 2 * turn;  // beyond both sides
    const double begin = first_ - way * over, whole = sweep_ + 2 * way * over;
    constexpr double kChord = 1;  // paper mm
    const int count = std::clamp(static_cast<int>(std::abs(whole) * radius / kChord), 8, 400);
    Path arc = line(vertex_, vertex_, ground_.style.line);
    arc.points.clear();
    for (int i = 0; i <= count; ++i) arc.points.push_back(at(radius, begin + whole * i / count));
    // With its arrows, and as much beyond their tips.
    const Vec2 before = at(radius, first_ - way * (over + turn)),
               behind = at(radius, first_ + sweep_ + way * (over + turn));
    out.print.pieces.push_back({before, arc.points.front(), Stroke::Dimension});
    for (std::size_t i = 0; i + 1 < arc.points.size(); ++i) {
      out.print.pieces.push_back({arc.points[i], arc.points[i + 1], Stroke::Dimension});
    }
    out.print.pieces.push_back({arc.points.back(), behind, Stroke::Dimension});
    out.layer.paths.push_back(std::move(arc));
    for (const bool second : {false, true}) {
      const double end = second ? first_ + sweep_ : first_;
      const double to = (second == inside ? 1 : -1) * way;
      // Along the chord, so that the arrow lies on the arc.
      const double along = end + 0.5 * std::numbers::pi - 0.5 * to * turn;
      out.layer.paths.push_back(
          arrow_head(at(radius, end), to * Vec2(std::cos(along), std::sin(along)), arrow));
    }
  }

  /// Paper mm of the arc that lie over the drawing.
  double over_drawing(const DimensionPlace& place) const {
    double over = 0;
    for (const PrintedPiece& piece : place.print.pieces) {
      const std::array<Vec2, 2> ends{piece.a, piece.b};
      if (piece.stroke == Stroke::Dimension && overlap(ground_.outline, ends)) {
        over += glm::distance(piece.a, piece.b);
      }
    }
    return over;
  }

  DimensionPlace at_step(int step) const {
    DimensionPlace out;
    const double h = ground_.style.height;
    const double start = beyond_ ? 0 : std::min(sides_[0].far, sides_[1].far);
    const double radius = start + ground_.first() + 0.5 * step * ground_.step();
    add_extensions(radius, out);
    add_arc(radius, out);
    const double mid = first_ + 0.5 * sweep_, width = letters_.width(), height = letters_.height();
    const double reach = 0.5 * (std::abs(std::cos(mid)) * width + std::abs(std::sin(mid)) * height);
    const Vec2 low = at(radius + 0.4 * h + reach, mid) - 0.5 * Vec2(width, height);
    letters_.lay(low, {1, 0}, out.layer);
    out.print.letters.push_back(letters_.quad(low, {1, 0}));
    out.cost = radius + over_drawing(out);
    return out;
  }

  const DimensionGround& ground_;
  DimensionLetters letters_;
  Vec2 vertex_;
  bool beyond_;
  std::array<Side, 2> sides_;
  double first_ = 0, sweep_ = 0;
};

}  // namespace

DimensionPlace place_angle(const Dimension& dimension, const DimensionGround& ground) {
  DimensionPlace best = AngleArc(dimension, false, ground).best();
  DimensionPlace beyond = AngleArc(dimension, true, ground).best();
  return beyond.cost < best.cost ? beyond : best;
}

}  // namespace burin::detail
