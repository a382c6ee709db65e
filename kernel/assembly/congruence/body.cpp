#include <burin/congruence/body.h>
#include <burin/mesh/spread.h>

#include "near_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace burin {
namespace {

/// Share of a part's size that its triangles may be off.
constexpr double kTolerance = 2e-4;
constexpr std::size_t kSamples = 400;
/// Samples that decide against a move.
constexpr std::size_t kFirst = 24;
/// Share of samples that may lie off: chord tolerances are what triangles aim at.
constexpr double kMissed = 0.01;

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
  for (std::size_t i = 0; i < kSamples; ++i) {
    const double at = area * (static_cast<double>(i) + 0.5) / kSamples;
    const auto found = std::ranges::lower_bound(until, at);
    const auto index = std::min<std::size_t>(static_cast<std::size_t>(found - until.begin()),
                                             mesh.triangles.size() - 1);
    const Triangle& t = mesh.triangles[index];
    const Vec3 a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
    const Vec3 bary = spread_bary(i);  // even in the triangles, too
    samples.push_back(a + bary.y * (b - a) + bary.z * (c - a));
  }
  return samples;
}

double reach_of(const Body& a, const Body& b, double place) {
  return place + a.tolerance() + b.tolerance();
}

/// The same triangles in the same order, each corner within `place`.
bool same_triangles(const Body& before, const Body& after, const Placement& move, double place) {
  const TriMesh &a = before.mesh(), &b = after.mesh();
  if (a.positions.size() != b.positions.size() || a.triangles != b.triangles) return false;
  for (std::size_t i = 0; i < a.positions.size(); ++i) {
    if (glm::distance(move.point(a.positions[i]), b.positions[i]) > place) return false;
  }
  return true;
}

}  // namespace

std::shared_ptr<const Surface> realised_to_compare(const Form& form, RunContext& context) {
  const double size = form.bounds(Mat3(1)).diagonal();
  const double share = form.looks_at_view() ? kTolerance : 1;
  RealiseOptions options;
  options.tolerance = size > 0 ? share * size : share;
  options.curvature = false;
  return form.realise(options, context);
}

Body::Body(const std::shared_ptr<const Surface>& surface)
    : Body(std::shared_ptr<const TriMesh>(surface, &surface->proxy().mesh),
           surface->proxy().tolerance) {}

Body::Body(std::shared_ptr<const TriMesh> mesh, double tolerance)
    : mesh_(std::move(mesh)),
      tolerance_(tolerance),
      pose_(pose_of(*mesh_, tolerance)),
      samples_(samples_of(*mesh_)),
      near_(std::make_shared<const NearSurface>(*mesh_)) {}

Body Body::mirrored() const {
  auto image = std::make_shared<TriMesh>(*mesh_);
  for (Vec3& p : image->positions) p.x = -p.x;
  for (Triangle& t : image->triangles) std::swap(t[1], t[2]);
  return {std::move(image), tolerance_};
}

bool Body::holds(Vec3 point, double reach) const { return near_->within(point, reach); }

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

}  // namespace burin
