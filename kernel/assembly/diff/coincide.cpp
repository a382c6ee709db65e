#include "coincide.h"

#include "surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace burin::detail {
namespace {

constexpr std::size_t kSamples = 400;
/// Samples that decide against a move.
constexpr std::size_t kFirst = 24;
/// Share of samples that may lie off: chord tolerances are what triangles aim at.
constexpr double kMissed = 0.01;
/// What a shift has to gain.
constexpr double kGain = 0.02;

Placement inverse(const Placement& move) {
  const Mat3 back = glm::transpose(move.linear);
  return {back, -(back * move.offset)};
}

std::vector<Vec3> samples_of(const TriMesh& mesh) {
  std::vector<double> until;
  double area = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
    area += 0.5 * glm::length(glm::cross(b - a, c - a));
    until.push_back(area);
  }
  std::vector<Vec3> samples;
  if (!(area > 0)) return samples;
  // The lattice of the plastic number: even in the triangles, too.
  constexpr double kFirstStep = 0.7548776662466927, kSecondStep = 0.5698402909980532;
  for (std::size_t i = 0; i < kSamples; ++i) {
    const double at = area * (static_cast<double>(i) + 0.5) / kSamples;
    const auto found = std::ranges::lower_bound(until, at);
    const auto index = std::min<std::size_t>(static_cast<std::size_t>(found - until.begin()),
                                             mesh.triangles.size() - 1);
    const Triangle& t = mesh.triangles[index];
    const Vec3 a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
    const double step = static_cast<double>(i) + 0.5;
    double u = step * kFirstStep - std::floor(step * kFirstStep);
    double v = step * kSecondStep - std::floor(step * kSecondStep);
    if (u + v > 1) u = 1 - u, v = 1 - v;
    samples.push_back(a + u * (b - a) + v * (c - a));
  }
  return samples;
}

double reach_of(const Body& a, const Body& b, double place) {
  return place + a.proxy().tolerance + b.proxy().tolerance;
}

/// The same triangles in the same order, each corner within `place`.
bool same_triangles(const Body& before, const Body& after, const Placement& move, double place) {
  const TriMesh &a = before.proxy().mesh, &b = after.proxy().mesh;
  if (a.positions.size() != b.positions.size() || a.triangles != b.triangles) return false;
  for (std::size_t i = 0; i < a.positions.size(); ++i) {
    if (glm::distance(move.point(a.positions[i]), b.positions[i]) > place) return false;
  }
  return true;
}

}  // namespace

Body::Body(std::shared_ptr<const Surface> surface)
    : surface_(std::move(surface)),
      pose_(pose_of(surface_->proxy())),
      samples_(samples_of(surface_->proxy().mesh)),
      near_(surface_->proxy().mesh) {}

double share_on_each_other(const Body& before, const Body& after, const Placement& move,
                           double place) {
  const double reach = reach_of(before, after, place);
  const std::size_t all = before.samples().size() + after.samples().size();
  if (all == 0) return 1;
  const Placement back = inverse(move);
  const auto on_after = std::ranges::count_if(
      before.samples(), [&](const Vec3& s) { return after.holds(move.point(s), reach); });
  const auto on_before = std::ranges::count_if(
      after.samples(), [&](const Vec3& s) { return before.holds(back.point(s), reach); });
  return static_cast<double>(on_after + on_before) / static_cast<double>(all);
}

bool coincide(const Body& before, const Body& after, const Placement& move, double place) {
  if (same_triangles(before, after, move, place)) return true;
  const double reach = reach_of(before, after, place);
  // Every so many of them, as neighbours lie in one triangle.
  const std::size_t step = std::max<std::size_t>(1, before.samples().size() / kFirst);
  std::size_t off = 0;
  for (std::size_t i = 0; i < before.samples().size(); i += step) {
    off += after.holds(move.point(before.samples()[i]), reach) ? 0 : 1;
    if (off > 2) return false;
  }
  return share_on_each_other(before, after, move, place) >= 1 - kMissed;
}

Shift best_shift(const Body& before, const Body& after, double place) {
  Shift best{Vec3(0), share_on_each_other(before, after, {}, place)};
  const Box3 &was = before.pose().box, &is = after.pose().box;
  std::vector<Vec3> shifts{after.pose().middle - before.pose().middle};
  // Sides of the boxes, or their middles, laid on each other.
  const std::array<Vec3, 3> sides{is.min - was.min, is.center() - was.center(), is.max - was.max};
  for (std::size_t n = 0; n < 27; ++n) {
    shifts.emplace_back(sides[n % 3].x, sides[n / 3 % 3].y, sides[n / 9].z);
  }
  for (std::size_t i = 0; i < shifts.size(); ++i) {
    const auto near = [&](Vec3 other) { return glm::distance(other, shifts[i]) <= place; };
    if (near(Vec3(0)) || near(best.by)) continue;
    if (std::any_of(shifts.begin(), shifts.begin() + static_cast<std::ptrdiff_t>(i), near))
      continue;
    const double share = share_on_each_other(before, after, {Mat3(1), shifts[i]}, place);
    // A shift has to be worth it; among shifts the better one.
    const double least = best.by == Vec3(0) ? best.share + kGain : best.share;
    if (share > least) best = {shifts[i], share};
  }
  return best;
}

}  // namespace burin::detail
