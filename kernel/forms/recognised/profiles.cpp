#include "profiles.h"

#include "facets.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace burin::recognised {
namespace {

// Slopes below this are those of a line.
constexpr double kStraight = 1e-6;
// How far joints may lie off a circle, as a share of the sagitta.
constexpr double kOffCircle = 0.05;

double slope(const Segment& s, Vec2 tangent) {
  return glm::dot(tangent, s.normal) / std::max(glm::dot(tangent, s.along()), 0.1);
}

/// The tangent at the joint of two segments: that of the circle through the three points, or of the
/// line that one of them is.
Vec2 tangent_at(const Segment& a, const Segment& b) {
  const double la = a.length(), lb = b.length();
  if (la > kLong * lb) return a.along();
  if (lb > kLong * la) return b.along();
  return glm::normalize(lb * a.along() + la * b.along());
}

struct Circle {
  Vec2 middle{0};
  double radius = 0;
  bool found = false;
};

Circle circle_through(const std::vector<Vec2>& points, double longest, double noise) {
  Circle c;
  if (points.size() < 4) return c;
  Eigen::MatrixXd m(points.size(), 3);
  Eigen::VectorXd b(points.size());
  const Vec2 o = points.front();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2 p = points[i] - o;
    const auto row = static_cast<Eigen::Index>(i);
    m.row(row) << 2 * p.x, 2 * p.y, 1.0;
    b(row) = glm::dot(p, p);
  }
  const Eigen::Vector3d x = m.colPivHouseholderQr().solve(b);
  const double square = x(2) + x(0) * x(0) + x(1) * x(1);
  if (!x.allFinite() || !(square > 0)) return c;
  c.middle = o + Vec2(x(0), x(1));
  c.radius = std::sqrt(square);
  const double sagitta = longest * longest / (8 * c.radius);
  c.found = std::all_of(points.begin(), points.end(), [&](Vec2 p) {
    return std::abs(glm::length(p - c.middle) - c.radius) <= kOffCircle * sagitta + 3 * noise;
  });
  return c;
}

class Bender {
 public:
  Bender(const std::vector<Segment>& segments, bool closed, double noise,
         std::vector<Patch*> patches)
      : segments_(segments), closed_(closed), noise_(noise), patches_(std::move(patches)) {}

  void run() {
    for (std::size_t i = 0; i < segments_.size(); ++i) set_cubic(i);
    for (std::size_t i = 0; i < segments_.size();) {
      std::size_t end = i;
      while (end < segments_.size() && patches_[end]->profile == Patch::Profile::Cubic) ++end;
      if (end > i) set_circle(i, end);
      i = std::max(end, i + 1);
    }
  }

 private:
  std::size_t count() const { return segments_.size(); }

  void set_cubic(std::size_t i) {
    const Segment& s = segments_[i];
    Patch& p = *patches_[i];
    const bool first = i == 0 && !closed_, last = i + 1 == count() && !closed_;
    double m0 = 0, m1 = 0;
    if (!first) m0 = slope(s, tangent_at(segments_[(i + count() - 1) % count()], s));
    if (!last) m1 = slope(s, tangent_at(s, segments_[(i + 1) % count()]));
    // Where the profile ends it bends on as it did.
    if (first) m0 = -m1;
    if (last) m1 = -m0;
    if (std::abs(m0) < kStraight && std::abs(m1) < kStraight) return;
    p.profile = Patch::Profile::Cubic;
    p.kind = FaceKind::Freeform;
    p.start = s.begin;
    p.length = s.length();
    p.slope0 = m0;
    p.slope1 = m1;
    p.sagitta += p.length * std::max(std::abs(m0), std::abs(m1)) / 4;
    p.turn = std::max(p.turn, std::abs(std::atan(m0)) + std::abs(std::atan(m1)));
  }

  void set_circle(std::size_t begin, std::size_t end) {
    std::vector<Vec2> points;
    double longest = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const Segment& s = segments_[i];
      if (s.begin_known && (i == begin || !segments_[i - 1].end_known)) points.push_back(s.begin);
      if (s.end_known) points.push_back(s.end);
      longest = std::max(longest, s.length());
    }
    const Circle c = circle_through(points, longest, noise_);
    if (!c.found) return;
    for (std::size_t i = begin; i < end; ++i) {
      Patch& p = *patches_[i];
      p.profile = Patch::Profile::Circle;
      p.middle = c.middle;
      const Vec2 out = 0.5 * (segments_[i].begin + segments_[i].end) - c.middle;
      p.radius = glm::dot(out, segments_[i].normal) >= 0 ? c.radius : -c.radius;
      const double off = 0.1 * longest * longest / (8 * c.radius) + 10 * noise_;
      p.kind = FaceKind::Torus;
      if (std::abs(c.middle.x) > off) continue;
      p.kind = FaceKind::Sphere;
      p.middle.x = 0;
    }
  }

  const std::vector<Segment>& segments_;
  bool closed_;
  double noise_;
  std::vector<Patch*> patches_;
};

}  // namespace

double turn_between(const Segment& a, const Segment& b) {
  return std::atan2(a.normal.x * b.normal.y - a.normal.y * b.normal.x,
                    glm::dot(a.normal, b.normal));
}

std::vector<bool> smooth_joints(const std::vector<Segment>& segments, bool closed) {
  const std::size_t n = closed ? segments.size() : segments.size() - 1;
  std::vector<double> turn(n);
  for (std::size_t i = 0; i < n; ++i) {
    turn[i] = turn_between(segments[i], segments[(i + 1) % segments.size()]);
  }
  return smooth_turns(turn, closed);
}

std::vector<bool> smooth_turns(const std::vector<double>& turn, bool closed, const TurnRule& rule) {
  constexpr double kRound = 15 * kDegree, kLargest = 40.5 * kDegree;
  const std::size_t n = turn.size();
  const auto agrees = [&](std::size_t i, std::size_t k) {
    const double a = std::abs(turn[i]), b = std::abs(turn[k]);
    if (a > kLargest || b > kLargest) return false;
    if (a <= kRound) return a <= 3 * b + kDegree;
    return std::abs(turn[i] - turn[k]) <= rule.unequal * a;
  };
  // Where a curve bends back and forth its turns go through zero: each lies between its neighbours.
  const auto goes_on = [&](std::size_t i) {
    const double before = turn[(i + n - 1) % n], after = turn[(i + 1) % n];
    const double largest = std::max(std::abs(before), std::abs(after));
    return std::max(std::abs(turn[i]), largest) <= kLargest &&
           std::abs(turn[i] - 0.5 * (before + after)) <= 0.5 * largest + kDegree;
  };
  std::vector<bool> smooth(n, false);
  for (std::size_t i = 0; i < n; ++i) {
    if (i > 0 || closed) smooth[i] = agrees(i, (i + n - 1) % n);
    if (!smooth[i] && (i + 1 < n || closed)) smooth[i] = agrees(i, (i + 1) % n);
    if (!smooth[i] && rule.waves && (closed || (i > 0 && i + 1 < n))) smooth[i] = goes_on(i);
  }
  // Three in a row: a cone between two cylinders has two joints and is what it is.
  if (closed && std::find(smooth.begin(), smooth.end(), false) == smooth.end()) return smooth;
  std::vector<bool> kept(n, false);
  for (std::size_t i = 0; i < n;) {
    std::size_t end = i;
    while (end < n && smooth[end]) ++end;
    if (end - i >= 3) std::fill_n(kept.begin() + static_cast<std::ptrdiff_t>(i), end - i, true);
    i = std::max(end, i + 1);
  }
  return kept;
}

void bend(const std::vector<Segment>& segments, bool closed, double noise,
          std::vector<Patch*> patches) {
  Bender(segments, closed, noise, std::move(patches)).run();
}

}  // namespace burin::recognised
