#include <burin/drawing/arcs.h>

#include "schneider.h"
#include "turned.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace burin {
namespace {

constexpr double kWhole = 2 * std::numbers::pi;
constexpr double kLongestRadius = 2000;  // paper mm: what is longer is straight on any sheet
constexpr double kFlattest = 0.01;       // short half axis over long one: beyond it nearly a line
constexpr std::size_t kLeastOfCircle = 3, kLeastOfEllipse = 6;  // segments: one more than decide it
// Radians that a line turns: less tells little of the axes of an ellipse, and where it ends between
// corners something else goes on.
constexpr double kLeastTurnOfEllipse = 0.5, kLeastTurnOfPart = 1.2;

/// What makes a circle of an ellipse: stretching it across its long axis.
struct AxisStretch {
  Vec2 along{1, 0};
  double ratio = 1;

  Vec2 to(Vec2 p) const { return {glm::dot(p, along), cross2(along, p) / ratio}; }
  Vec2 from(Vec2 q) const { return q.x * along + q.y * ratio * turned_left(along); }
  /// Paper mm from q, relative to its centre, to the circle of radius r, to first order.
  double off(Vec2 q, double r) const {
    const double steep = glm::length(Vec2(q.x, q.y / ratio));
    return steep > 0 ? std::abs(glm::dot(q, q) - r * r) / (2 * steep) : r;
  }
};

struct Circle {
  Vec2 center{0};
  double radius = 0;
};

/// The circle that all points lie nearest to, by its equation in the least squares.
std::optional<Circle> whole_circle(const std::vector<Vec2>& q) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  const Vec2 o = q.front();
  for (const Vec2& p : q) {
    const Eigen::Vector3d row(2 * (p.x - o.x), 2 * (p.y - o.y), 1);
    normal += row * row.transpose();
    right += row * glm::dot(p - o, p - o);
  }
  const Eigen::Vector3d s = normal.ldlt().solve(right);
  const Vec2 c(s.x(), s.y());
  const double r2 = s.z() + glm::dot(c, c);
  if (!(r2 > 0)) return std::nullopt;
  return Circle{o + c, std::sqrt(r2)};
}

/// The circle through the first and the last point that the others lie nearest to.
std::optional<Circle> circle_through_ends(const std::vector<Vec2>& q) {
  const Vec2 half = 0.5 * (q.back() - q.front()), middle = q.front() + half;
  const double d2 = glm::dot(half, half);
  const Vec2 across = turned_left(half) / std::sqrt(d2);
  double above = 0, below = 0;
  for (const Vec2& p : q) {
    const Vec2 v = p - middle;
    const double high = glm::dot(v, across);
    above += (glm::dot(v, v) - d2) * high;
    below += 2 * high * high;
  }
  if (!(below > 0)) return std::nullopt;
  const double h = above / below;
  return Circle{middle + h * across, std::sqrt(d2 + h * h)};
}

/// Which ellipse the points lie on, but for its place and size: numerically stable direct least
/// squares.
std::optional<AxisStretch> stretch_of(std::span<const Vec2> points) {
  Vec2 middle(0);
  for (const Vec2& p : points) middle += p;
  middle /= static_cast<double>(points.size());
  double size = 0;
  for (const Vec2& p : points) size = std::max(size, glm::distance(p, middle));
  if (!(size > 0)) return std::nullopt;
  Eigen::Matrix3d s1 = Eigen::Matrix3d::Zero(), s2 = s1, s3 = s1;
  for (const Vec2& p : points) {
    const Vec2 v = (p - middle) / size;
    const Eigen::Vector3d square(v.x * v.x, v.x * v.y, v.y * v.y), linear(v.x, v.y, 1);
    s1 += square * square.transpose();
    s2 += square * linear.transpose();
    s3 += linear * linear.transpose();
  }
  const Eigen::Matrix3d m = s1 - s2 * s3.ldlt().solve(s2.transpose());
  Eigen::Matrix3d reduced;
  reduced << m.row(2) / 2, -m.row(1), m.row(0) / 2;
  const Eigen::EigenSolver<Eigen::Matrix3d> solver(reduced);
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d a = solver.eigenvectors().col(i).real();
    if (!(4 * a(0) * a(2) - a(1) * a(1) > 0)) continue;
    Eigen::Matrix2d form;
    form << a(0), a(1) / 2, a(1) / 2, a(2);
    if (a(0) < 0) form = -form;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(form);
    const double ratio = std::sqrt(axes.eigenvalues()(0) / axes.eigenvalues()(1));
    if (!(ratio >= kFlattest && ratio <= 1)) return std::nullopt;
    const Eigen::Vector2d along = axes.eigenvectors().col(0);
    return AxisStretch{{along.x(), along.y()}, ratio};
  }
  return std::nullopt;
}

/// Radians by which a polyline turns, all its turns one way.
double turning(std::span<const Vec2> p) {
  double turn = 0;
  for (std::size_t i = 1; i + 1 < p.size(); ++i) {
    const Vec2 a = p[i] - p[i - 1], b = p[i + 1] - p[i];
    turn += std::atan2(cross2(a, b), glm::dot(a, b));
  }
  return std::abs(turn);
}

class Fitter {
 public:
  Fitter(std::vector<Vec2> points, const ArcOptions& options)
      : p_(std::move(points)), options_(options) {
    for (std::size_t i = 1; i + 1 < p_.size(); ++i) {
      const Vec2 a = p_[i] - p_[i - 1], b = p_[i + 1] - p_[i];
      const double lengths = glm::length(a) * glm::length(b);
      // What is as short as that has no direction.
      const bool tiny = std::min(glm::length(a), glm::length(b)) <= options_.points;
      if (!tiny && glm::dot(a, b) < kCornerCosine * lengths) corners_.push_back(i);
    }
    if (!p_.empty()) corners_.push_back(p_.size() - 1);
  }

  std::vector<CurvePiece> run() {
    std::size_t i = 0;
    const std::size_t last = p_.size() - 1;
    for (const std::size_t corner : corners_) {
      run_begin_ = i;
      while (i < corner) i = step(i, corner);
    }
    leave(last);
    return std::move(out_);
  }

  /// The whole of it as one arc, whose ends may be one point.
  std::optional<ConicArc> whole() const {
    if (corners_.size() > 1) return std::nullopt;
    const std::span<const Vec2> all(p_);
    if (auto arc = fitted(all, {}, true); arc && is_worth(*arc, all)) return arc;
    if (auto arc = ellipse(all, true); arc && is_worth(*arc, all)) return arc;
    return std::nullopt;
  }

 private:
  /// Looks for an arc that begins at a point; where to go on.
  std::size_t step(std::size_t i, std::size_t corner) {
    const auto round = [&](std::span<const Vec2> s) { return circle(s); };
    const auto oval = [&](std::span<const Vec2> s) { return ellipse(s); };
    std::size_t end = reach(i, corner, kLeastOfCircle, round);
    std::optional<ConicArc> arc = end > i ? circle(part(i, end)) : std::nullopt;
    if (options_.ellipses && end < corner) {
      // Few points, nearly in a line, do not determine an ellipse: it begins with those that lie
      // on a circle.
      const std::size_t least = std::max(kLeastOfEllipse, end - i);
      const bool all = corner - i >= least && oval(part(i, corner));
      const std::size_t far = all ? corner : reach(i, corner, least, oval);
      const bool better = far > i && (far == corner || far - i >= 2 * (end - i));
      const auto found = better ? ellipse(part(i, far)) : std::nullopt;
      const bool complete = i == run_begin_ && far == corner;
      const double least_turn = complete ? kLeastTurnOfEllipse : kLeastTurnOfPart;
      if (found && turning(part(i, far)) >= least_turn) {
        end = far;
        arc = found;
      }
    }
    if (!arc) return i + 1;
    if (!options_.approximate && !(leaves(*arc, end, corner) && leaves(*arc, i, run_begin_))) {
      return i + 1;
    }
    // Nearly straight: the arc that comes may begin within it.
    if (!is_worth(*arc, part(i, end))) return i + 1 + (end - i) / 2;
    // A curve that goes over into an arc: leave to the arc what is its own.
    for (std::size_t j = i + 1; j < std::min(end, i + 4) && end < corner; ++j) {
      const std::size_t far = reach(j, corner, kLeastOfCircle, round);
      if (far >= end + (end - i)) return j;
    }
    leave(i);
    CurvePiece piece;
    piece.points.assign(p_.begin() + static_cast<std::ptrdiff_t>(i),
                        p_.begin() + static_cast<std::ptrdiff_t>(end) + 1);
    piece.arc = arc;
    out_.push_back(std::move(piece));
    left_ = end;
    return end;
  }

  /// Whether an arc's end is one of the line between corners, or the next point beyond it is far
  /// off.
  bool leaves(const ConicArc& arc, std::size_t end, std::size_t of_run) const {
    constexpr double kAtOnce = 3;
    const AxisStretch stretch{arc.major / arc.radius(), arc.ratio};
    for (std::size_t i = end; i != of_run;) {
      of_run > end ? ++i : --i;
      // Ends that were joined may be two points.
      if (glm::distance(p_[i], p_[end]) <= options_.points) continue;
      return stretch.off(stretch.to(p_[i] - arc.center), arc.radius()) > kAtOnce * options_.points;
    }
    return true;
  }

  /// Everything since the last piece up to a point is no arc.
  void leave(std::size_t to) {
    if (to <= left_) return;
    CurvePiece piece;
    piece.points.assign(p_.begin() + static_cast<std::ptrdiff_t>(left_),
                        p_.begin() + static_cast<std::ptrdiff_t>(to) + 1);
    out_.push_back(std::move(piece));
    left_ = to;
  }

  /// The last point, up to a corner, of an arc that begins at a point; that point where there is
  /// none.
  template <class Fit>
  std::size_t reach(std::size_t i, std::size_t corner, std::size_t least, const Fit& fit) const {
    if (i + least > corner || !fit(part(i, i + least))) return i;
    std::size_t good = i + least, bad = corner + 1;
    while (bad - good > 1) {
      // Twice as far as long as that goes well, then halving.
      const std::size_t twice = good + (good - i);
      const std::size_t next = bad > corner ? std::min(twice, corner) : good + (bad - good) / 2;
      (fit(part(i, next)) ? good : bad) = next;
    }
    return good;
  }

  std::span<const Vec2> part(std::size_t first, std::size_t last) const {
    return std::span(p_).subspan(first, last - first + 1);
  }

  std::optional<ConicArc> circle(std::span<const Vec2> s) const { return fitted(s, {}, false); }

  std::optional<ConicArc> ellipse(std::span<const Vec2> s, bool whole = false) const {
    if (!options_.ellipses || s.size() <= kLeastOfEllipse) return std::nullopt;
    const auto stretch = stretch_of(s);
    if (!stretch) return std::nullopt;
    return fitted(s, *stretch, whole);
  }

  std::optional<ConicArc> fitted(std::span<const Vec2> s, const AxisStretch& stretch,
                                 bool whole) const {
    if (!whole && glm::distance(s.front(), s.back()) <= options_.points) return std::nullopt;
    std::vector<Vec2> q;
    q.reserve(s.size());
    for (const Vec2& p : s) q.push_back(stretch.to(p - s.front()));
    const auto found = whole ? whole_circle(q) : circle_through_ends(q);
    if (!found || !(found->radius <= kLongestRadius)) return std::nullopt;
    const double r = found->radius;
    double turn = 0, back = 0;
    for (std::size_t i = 0; i < q.size(); ++i) {
      q[i] -= found->center;
      if (stretch.off(q[i], r) > options_.points) return std::nullopt;
      if (i == 0) continue;
      if (stretch.off(0.5 * (q[i - 1] + q[i]), r) > options_.chords) return std::nullopt;
      const double angle = std::atan2(cross2(q[i - 1], q[i]), glm::dot(q[i - 1], q[i]));
      turn += angle;
      back = turn * angle < 0 ? std::max(back, std::abs(angle)) : back;
    }
    if (back * r > options_.points) return std::nullopt;
    if (whole ? std::abs(turn) < 1 : std::abs(turn) >= kWhole) return std::nullopt;
    ConicArc arc;
    arc.center = s.front() + stretch.from(found->center);
    arc.major = r * stretch.along;
    arc.ratio = stretch.ratio;
    arc.begin = std::atan2(q.front().y, q.front().x);
    arc.turn = whole ? std::copysign(kWhole, turn) : turn;
    // Once round, not twice.
    if (whole && std::abs(std::abs(turn) - kWhole) * r > 2 * options_.points) return std::nullopt;
    return arc;
  }

  /// Whether it bows so much that nobody would take it for a line.
  bool is_worth(const ConicArc& arc, std::span<const Vec2> s) const {
    const double least = std::max(2 * options_.points, 0.1 * options_.chords);
    if (s.size() <= (arc.is_circle() ? kLeastOfCircle : kLeastOfEllipse)) return false;
    if (std::abs(arc.turn) > 1) return arc.radius() * arc.ratio > least;
    const Vec2 along = glm::normalize(s.back() - s.front());
    double bow = 0;
    for (const Vec2& p : s) bow = std::max(bow, std::abs(cross2(along, p - s.front())));
    return bow > least;
  }

  std::vector<Vec2> p_;
  const ArcOptions& options_;
  /// Where it turns sharply, and the last point.
  std::vector<std::size_t> corners_;
  std::vector<CurvePiece> out_;
  std::size_t left_ = 0, run_begin_ = 0;
};

/// A closed polyline (its first point not repeated) begun where an arc may end: at its sharpest
/// corner or the end of its longest segment; the first point is repeated at the end.
std::vector<Vec2> opened_ring(const std::vector<Vec2>& p) {
  const std::size_t n = p.size();
  std::size_t sharpest = 0, longest = 0;
  double least = kCornerCosine, most = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 a = p[i] - p[(i + n - 1) % n], b = p[(i + 1) % n] - p[i];
    const double cosine = glm::dot(a, b) / (glm::length(a) * glm::length(b));
    if (cosine < least) least = cosine, sharpest = i;
    if (glm::length(a) > most) most = glm::length(a), longest = i;
  }
  std::vector<Vec2> out = p;
  const std::size_t start = least < kCornerCosine ? sharpest : longest;
  std::rotate(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(start), out.end());
  out.push_back(out.front());
  return out;
}

}  // namespace

Vec2 ConicArc::at(double t) const {
  return center + std::cos(t) * major + std::sin(t) * ratio * turned_left(major);
}

bool ConicArc::is_whole() const { return std::abs(turn) > kWhole - 1e-9; }

std::vector<CurvePiece> fit_arcs(std::span<const Vec2> points, bool closed,
                                 const ArcOptions& options) {
  std::vector<Vec2> p;
  p.reserve(points.size() + 1);
  for (const Vec2& one : points) {
    if (p.empty() || p.back() != one) p.push_back(one);
  }
  while (closed && p.size() > 1 && p.back() == p.front()) p.pop_back();
  if (p.empty()) return {};
  if (p.size() < 2) return {{std::move(p), std::nullopt}};
  if (closed && p.size() < 3) closed = false;
  const bool ring = closed || (p.size() > 3 && p.front() == p.back());
  if (closed) p.push_back(p.front());
  if (ring) {
    if (const auto arc = Fitter(p, options).whole()) return {{std::move(p), arc}};
  }
  if (closed) {
    p.pop_back();
    p = opened_ring(p);
  }
  return Fitter(std::move(p), options).run();
}

}  // namespace burin
