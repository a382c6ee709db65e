#include "places_of_feature.h"
#include "seen_feature.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

namespace burin::detail {
namespace {

constexpr std::size_t kMostPlaces = 8;
/// Rays along the longer side of what a feature may cover.
constexpr int kCells = 48;

/// What a view sees of a feature, in square cells.
class SeenCells {
 public:
  /// `box`: along the axes of the view.
  explicit SeenCells(const Box3& box) : box_(box) {
    const Vec2 size = Vec2(box.max - box.min);
    cell_ = std::max(size.x, size.y) / kCells;
    if (!(cell_ > 0)) return;
    const auto cells = [&](double side) {
      return std::clamp(static_cast<int>(std::ceil(side / cell_)), 1, kCells);
    };
    nx_ = cells(size.x);
    ny_ = cells(size.y);
    at_.resize(static_cast<std::size_t>(nx_ * ny_));
  }

  /// `look`: the point of the feature that a ray through a place of the view meets first, if any,
  /// and its face.
  template <class Look>
  void fill(const Look& look) {
    const Vec2 low =
        Vec2(box_.min) + 0.5 * (Vec2(box_.max - box_.min) - cell_ * Vec2(Vec2(nx_, ny_) - Vec2(1)));
    for (int y = 0; y < ny_; ++y) {
      for (int x = 0; x < nx_; ++x) at_[index(x, y)] = look(low + cell_ * Vec2(x, y));
    }
  }

  /// The middles of what is seen, each beyond twice the radius of those before.
  std::vector<SeenPlace> middles() const {
    std::vector<double> room = rooms();
    std::vector<SeenPlace> out;
    while (out.size() < kMostPlaces) {
      const auto best = std::ranges::max_element(room);
      if (best == room.end() || !(*best > 0)) break;
      const auto at = static_cast<std::size_t>(best - room.begin());
      const double radius = *best;
      out.push_back({at_[at]->first, radius * cell_});
      for (std::size_t k = 0; k < room.size(); ++k) {
        if (distance(at, k) <= 2 * radius) room[k] = 0;
      }
    }
    return out;
  }

 private:
  std::size_t index(int x, int y) const { return static_cast<std::size_t>(y * nx_ + x); }

  double distance(std::size_t a, std::size_t b) const {
    const auto n = static_cast<std::size_t>(nx_);
    const auto along = [](std::size_t p, std::size_t q) {
      return static_cast<double>(p) - static_cast<double>(q);
    };
    return std::hypot(along(a % n, b % n), along(a / n, b / n));
  }

  /// Cells from each that is seen to the next that is not, or shows another face, by a chamfer in
  /// two sweeps.
  std::vector<double> rooms() const {
    std::vector<double> room(at_.size(), 0.0);
    const auto relax = [&](int x, int y, int back) {
      const auto& own_at = at_[index(x, y)];
      if (!own_at) return;
      const auto of = [&](int i, int j) {
        if (i < 0 || j < 0 || i >= nx_ || j >= ny_) return 0.0;
        const auto& other = at_[index(i, j)];
        return other && other->second == own_at->second ? room[index(i, j)] : 0.0;
      };
      const double straight = std::min(of(x - back, y), of(x, y - back)) + 1;
      const double slanted =
          std::min(of(x - back, y - back), of(x + back, y - back)) + std::numbers::sqrt2;
      const double found = std::min(straight, slanted);
      double& own = room[index(x, y)];
      own = back > 0 ? found : std::min(own, found);
    };
    for (int y = 0; y < ny_; ++y) {
      for (int x = 0; x < nx_; ++x) relax(x, y, 1);
    }
    for (int y = ny_ - 1; y >= 0; --y) {
      for (int x = nx_ - 1; x >= 0; --x) relax(x, y, -1);
    }
    // The middle of a cell is half a cell from its side.
    for (double& r : room) r = std::max(0.0, r - 0.5);
    return room;
  }

  Box3 box_;
  double cell_ = 0;
  int nx_ = 0, ny_ = 0;
  std::vector<std::optional<std::pair<Vec3, std::int32_t>>> at_;
};

Box3 box_in_view(const SeenFeature& seen, const Mat3& axes) {
  Box3 box;
  const ProxyMesh& proxy = seen.surface.proxy();
  for (std::uint32_t i = 0; i < proxy.mesh.triangles.size(); ++i) {
    if (!is_of_feature(proxy, i, seen)) continue;
    for (const std::uint32_t corner : proxy.mesh.triangles[i]) {
      box.add(axes * (proxy.mesh.positions[corner] + seen.moved));
    }
  }
  return box;
}

}  // namespace

std::vector<SeenPlace> FeatureSight::places_by_rays(const SeenFeature& seen,
                                                    const Mat3& axes) const {
  const Box3 box = box_in_view(seen, axes);
  if (box.empty() || seen.part >= surfaces_.size()) return {};
  const ProxyMesh& proxy = surfaces_[seen.part]->proxy();
  if (proxy.mesh.triangles.empty()) return {};  // of glass
  SeenCells cells(box);
  const Mat3 to_model = glm::transpose(axes);
  const double beyond = box.max.z + 2 * occluder_->diagonal();
  cells.fill([&](Vec2 at) -> std::optional<std::pair<Vec3, std::int32_t>> {
    const Vec3 eye = to_model * Vec3(at, beyond);
    const auto hit =
        occluder_->first_hit(eye, -to_model[2], 0, std::numeric_limits<double>::infinity());
    if (!hit || static_cast<std::size_t>(hit->where.part) != seen.part) return std::nullopt;
    if (!is_of_feature(proxy, hit->where.face, seen)) return std::nullopt;
    const std::int32_t face =
        proxy.is_cut(hit->where.face) ? -1 : proxy.face_source(hit->where.face);
    return std::pair(eye - hit->distance * to_model[2], face);
  });
  return cells.middles();
}

std::vector<SeenPlace> FeatureSight::places_by_triangles(const SeenFeature& seen,
                                                         Vec3 to_viewer) const {
  std::vector<SeenPlace> all;
  const bool edge = seen.kind == FeatureRow::Kind::Edge;
  // A flat face that is seen from its edge is a line, and so is a wall that is seen along its axis.
  // What else is round or has more than one face is seen elsewhere too, or something of the same
  // outline stands before it.
  constexpr double kSlanted = 0.3;
  constexpr double kAlong = 1 - 1e-6;
  const Feature& f = seen.feature;
  const bool wall = f.has_axis() && std::abs(glm::dot(f.along, to_viewer)) > kAlong;
  const bool line = seen.kind == FeatureRow::Kind::Face && (f.kind == FeatureKind::Plane || wall);
  const double least = line ? -1 : kSlanted;
  for (const SampledPlace& place : sampled_places(seen, to_viewer)) {
    if (glm::dot(place.normal, to_viewer) <= least) continue;
    if (!shows_place(place.at + seen.moved, place.normal, to_viewer)) continue;
    all.push_back({(edge ? place.on_edge : place.at) + seen.moved, 0});
  }
  // Spread over all of them, neither the first nor the last.
  std::vector<SeenPlace> out;
  const std::size_t count = std::min(kMostPlaces, all.size());
  for (std::size_t k = 0; k < count; ++k)
    out.push_back(all[(2 * k + 1) * all.size() / (2 * count)]);
  return out;
}

std::vector<SeenPlace> FeatureSight::seen_places(const SeenFeature& seen, const Mat3& axes) const {
  if (seen.kind == FeatureRow::Kind::Point) return {{seen.feature.point + seen.moved, 0}};
  std::vector<SeenPlace> out;
  if (seen.kind != FeatureRow::Kind::Edge) out = places_by_rays(seen, axes);
  if (out.empty()) out = places_by_triangles(seen, glm::transpose(axes)[2]);
  return out;
}

}  // namespace burin::detail
