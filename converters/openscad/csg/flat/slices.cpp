#include "slices.h"

#include "fragments.h"
#include "sweep.h"

#include <algorithm>
#include <cmath>

namespace burin::csg {
namespace {

/// Along a spiral r = a t from t = 0.
double spiral_length(double a, double t) {
  return 0.5 * a * (t * std::sqrt(1 + t * t) + std::asinh(t));
}

/// The way of a point that turns by `twist` radians and rises by `height`, at a constant distance r
/// from the axis.
double helix_length(double r, double height, double twist) { return std::hypot(r * twist, height); }

/// The same, its distance going from r to scale * r.
double conical_length(double r, double height, double twist, double scale) {
  const double end = scale > 1 ? twist * scale / (scale - 1) : twist / (1 - scale);
  const double a = r / end;
  return std::hypot(spiral_length(a, end) - spiral_length(a, end - twist), height);
}

double twisted(const Fineness& f, const Extrusion& x, double r) {
  const double degrees = std::abs(x.twist);
  // Never more than a third of a turn: what turns by a half folds over.
  const double fewest = std::max(std::ceil(degrees / 120), 1.0);
  if (r < kFinest || !std::isfinite(f.fn)) return fewest;
  if (f.fn > 0) return std::max(std::ceil(degrees / 360 * f.fn), fewest);
  const double turn = degrees * M_PI / 180;
  const bool conical = x.scale.x == x.scale.y && x.scale.x != 1;
  const double length =
      conical ? conical_length(r, x.height, turn, x.scale.x) : helix_length(r, x.height, turn);
  return std::max(std::min(std::ceil(degrees / f.fa), std::ceil(length / f.fs)), fewest);
}

double narrowed(const Fineness& f, double height, double most) {
  if (most < kFinest || !std::isfinite(f.fn)) return 1;
  if (f.fn > 0) return std::max(std::floor(f.fn), 1.0);
  return std::max(std::ceil(std::hypot(most, height) / f.fs), 1.0);
}

}  // namespace

double slices_of(const Node& node, const Extrusion& x, const Region& region) {
  const bool bent = x.twist != 0 || x.scale.x != x.scale.y;
  if (!bent) return 1;
  const double given = std::trunc(node.number("slices", 0));
  if (given > 0) return given;
  double farthest = 0, moved = 0;
  for (const Outline& o : region.outlines) {
    for (const Vec2& p : o.points) {
      farthest = std::max(farthest, glm::length(p));
      moved = std::max(moved, glm::length(p - p * x.scale));
    }
  }
  const Fineness f = fineness_of(node);
  return x.twist != 0 ? twisted(f, x, farthest) : narrowed(f, x.height, moved);
}

}  // namespace burin::csg
