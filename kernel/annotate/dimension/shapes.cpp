#include "shapes.h"

#include <burin/planar/convex_hull.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin::detail {
namespace {

/// Paper mm: what lies that little on each other only touches.
constexpr double kTouch = 0.05;
/// Sine of the angle up to which lines run beside each other.
constexpr double kBeside = 0.02;

struct Reach {
  double low = std::numeric_limits<double>::infinity(), high = -low;
};

Reach reach_of(std::span<const Vec2> points, Vec2 along) {
  Reach out;
  for (const Vec2& p : points) {
    out.low = std::min(out.low, glm::dot(p, along));
    out.high = std::max(out.high, glm::dot(p, along));
  }
  return out;
}

/// Whether some side of `a` has all of `b` beyond it.
bool parted_by(std::span<const Vec2> a, std::span<const Vec2> b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vec2 side = a[(i + 1) % a.size()] - a[i];
    const double length = glm::length(side);
    if (!(length > 0)) continue;
    const Vec2 normal(side.y / length, -side.x / length);
    if (reach_of(b, normal).low >= reach_of(a, normal).high - kTouch) return true;
    if (a.size() == 2 && reach_of(a, normal).low >= reach_of(b, normal).high - kTouch) return true;
  }
  return false;
}

bool cross_inside(const PrintedPiece& p, const PrintedPiece& q) {
  const Vec2 u = p.b - p.a, v = q.b - q.a;
  const double turn = cross2(u, v), lengths = glm::length(u) * glm::length(v);
  if (!(std::abs(turn) > kBeside * lengths)) return false;
  const double s = cross2(q.a - p.a, v) / turn, t = cross2(q.a - p.a, u) / turn;
  const double near_s = kTouch / glm::length(u), near_t = kTouch / glm::length(v);
  return s > near_s && s < 1 - near_s && t > near_t && t < 1 - near_t;
}

bool run_beside(const PrintedPiece& p, const PrintedPiece& q, double apart) {
  const Vec2 u = p.b - p.a, v = q.b - q.a;
  const double length = glm::length(u);
  if (!(std::abs(cross2(u, v)) <= kBeside * length * glm::length(v)) || !(length > 0)) return false;
  const Vec2 along = u / length;
  if (std::abs(cross2(along, q.a - p.a)) > apart) return false;
  const double a = glm::dot(q.a - p.a, along), b = glm::dot(q.b - p.a, along);
  return std::min(a, b) < length - kTouch && std::max(a, b) > kTouch;
}

Conflicts of_pieces(const PrintedPiece& p, const PrintedPiece& q, double apart) {
  Conflicts out;
  const bool both = p.stroke == Stroke::Dimension && q.stroke == Stroke::Dimension;
  if (both && run_beside(p, q, apart)) ++out.hard;
  // Lines that lie on each other are taken for one; extension lines may be one.
  constexpr double kBetween = 1;  // paper mm
  const bool extensions = p.stroke == Stroke::Extension && q.stroke == Stroke::Extension;
  if (!both && !extensions && run_beside(p, q, kBetween)) ++out.hard;
  if (cross_inside(p, q)) both ? ++out.hard : ++out.crossings;
  return out;
}

int letters_on(const Footprint& one, const Footprint& other) {
  constexpr double kClear = 0.4;  // paper mm
  int out = 0;
  for (const Quad& quad : one.letters) {
    const Quad around = grown(quad, kClear);
    for (const PrintedPiece& piece : other.pieces) {
      const std::array<Vec2, 2> ends{piece.a, piece.b};
      if (overlap(around, ends)) ++out;
    }
  }
  return out;
}

}  // namespace

Quad quad_of(Vec2 low, Vec2 along, double width, double height) {
  const Vec2 up(-along.y, along.x);
  return {low, low + width * along, low + width * along + height * up, low + height * up};
}

Quad grown(const Quad& quad, double by) {
  const Vec2 along = glm::normalize(quad[1] - quad[0]), up(-along.y, along.x);
  return {quad[0] - by * (along + up), quad[1] + by * (along - up), quad[2] + by * (along + up),
          quad[3] - by * (along - up)};
}

bool overlap(std::span<const Vec2> a, std::span<const Vec2> b) {
  if (a.size() < 2 || b.size() < 2) return false;
  return !parted_by(a, b) && !parted_by(b, a);
}

double exit_of(Vec2 a, Vec2 b, Vec2 way, std::span<const Vec2> outline) {
  // It is inside for as long as `way` t is in the outline less the segment, which is convex.
  std::vector<Vec2> less;
  for (const Vec2& p : outline) less.push_back(p - a), less.push_back(p - b);
  less = convex_hull(std::move(less));
  if (less.size() < 3) return 0;
  double out = std::numeric_limits<double>::infinity(), in = -out;
  for (std::size_t i = 0; i < less.size(); ++i) {
    const Vec2 side = less[(i + 1) % less.size()] - less[i], normal(side.y, -side.x);
    const double room = glm::dot(less[i], normal), speed = glm::dot(way, normal);
    const double rounding = 1e-9 * glm::length(side);
    if (std::abs(speed) <= rounding) {
      if (room <= rounding) return 0;  // it passes by
    } else if (speed > 0) {
      out = std::min(out, room / speed);
    } else {
      in = std::max(in, room / speed);
    }
  }
  return out > in ? std::max(out, 0.0) : 0;
}

int crossings_of(const PrintedPiece& piece, std::span<const Vec2> line) {
  int out = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    out += cross_inside(piece, {line[i], line[i + 1]}) ? 1 : 0;
  }
  return out;
}

Box2 Footprint::box() const {
  Box2 out;
  for (const PrintedPiece& piece : pieces) out.add(piece.a), out.add(piece.b);
  for (const Quad& quad : letters) {
    for (const Vec2& corner : quad) out.add(corner);
  }
  return out;
}

Conflicts conflicts_of(const Footprint& one, const Footprint& other, double apart) {
  constexpr double kBetween = 0.5;  // paper mm between letters
  Conflicts out;
  for (const PrintedPiece& p : one.pieces) {
    for (const PrintedPiece& q : other.pieces) {
      const Conflicts both = of_pieces(p, q, apart);
      out.hard += both.hard;
      out.crossings += both.crossings;
    }
  }
  for (const Quad& p : one.letters) {
    const Quad around = grown(p, kBetween);
    for (const Quad& q : other.letters) out.hard += overlap(around, q) ? 1 : 0;
  }
  out.hard += letters_on(one, other) + letters_on(other, one);
  return out;
}

}  // namespace burin::detail
