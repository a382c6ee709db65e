#include "picture_samples.h"

#include <burin/base/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace burin::python {
namespace {

constexpr double kMostCells = 1e6;
// Cells beside the four around a place that are looked at where none of the four shows its surface.
constexpr std::int64_t kReach = 3;
// Cosine of the largest turn between normals of one stretch of surface.
constexpr double kSameSide = 0.3;

}  // namespace

PictureSamples::PictureSamples(const HatchScene& scene) : scene_(&scene), camera_(&scene.camera) {
  const Paper& paper = scene.camera.paper();
  pitch_ = std::max(pitch_, std::sqrt(paper.width * paper.height / kMostCells));
  nx_ = static_cast<std::int64_t>(paper.width / pitch_) + 1;
  ny_ = static_cast<std::int64_t>(paper.height / pitch_) + 1;
  const auto nx = static_cast<std::size_t>(nx_), ny = static_cast<std::size_t>(ny_);
  std::vector<std::optional<std::pair<Vec3, Vec3>>> seen(nx * ny);
  parallel_for(
      ny, 4,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t y = begin; y < end; ++y) {
          for (std::size_t x = 0; x < nx; ++x) {
            const Vec2 centre =
                pitch_ * Vec2(static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5);
            const auto hit = scene.probe(centre);
            if (!hit || !hit->hatched) continue;
            const ProxyMesh& proxy = scene.surfaces[static_cast<std::size_t>(hit->part)]->proxy();
            const Vec3 p = proxy.position(hit->point.face, hit->point.bary);
            Vec3 n = proxy.normal(hit->point.face, hit->point.bary);
            if (glm::dot(n, scene.camera.to_viewer(p)) < 0) n = -n;
            seen[y * nx + x] = {p, n};
          }
        }
      },
      &scene.context);
  cells_.assign(seen.size(), -1);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (!seen[i]) continue;
    cells_[i] = static_cast<std::int32_t>(positions_.size());
    positions_.push_back(seen[i]->first);
    normals_.push_back(seen[i]->second);
  }
  add_slivers();
}

bool PictureSamples::seen(Vec3 position) const {
  const auto hit = scene_->probe(camera_->to_paper(position));
  // Beside the triangles, though not beside the surface: at the very outline.
  if (!hit) return true;
  return camera_->depth(hit->position) - camera_->depth(position) <=
         pitch_ / camera_->scale_at(position);
}

void PictureSamples::add_slivers() {
  for (std::size_t part = 0; part < scene_->surfaces.size(); ++part) {
    const TriMesh& mesh = scene_->surfaces[part]->proxy().mesh;
    scene_->context.check();
    for (std::uint32_t face = 0; face < mesh.triangles.size(); ++face) {
      const Triangle& t = mesh.triangles[face];
      std::array<Vec2, 3> corner;
      for (std::size_t k = 0; k < 3; ++k) corner[k] = camera_->to_paper(mesh.positions[t[k]]);
      // Along the middle of the longest side's height, a sample a cell.
      std::size_t longest = 0;
      for (std::size_t k = 1; k < 3; ++k) {
        if (glm::distance(corner[k], corner[(k + 1) % 3]) >
            glm::distance(corner[longest], corner[(longest + 1) % 3])) {
          longest = k;
        }
      }
      const double length = glm::distance(corner[longest], corner[(longest + 1) % 3]);
      const double count = std::clamp(std::ceil(length / pitch_), 1.0, kMostCells);
      for (double i = 0; i < count; ++i) {
        const double along = (i + 0.5) / count;
        const double height = 0.5 * std::min(1.0, 2 * std::min(along, 1 - along));
        Vec3 bary(0);
        bary[static_cast<glm::length_t>(longest)] = (1 - along) * (1 - height);
        bary[static_cast<glm::length_t>((longest + 1) % 3)] = along * (1 - height);
        bary[static_cast<glm::length_t>((longest + 2) % 3)] = height;
        add_sliver(static_cast<std::int32_t>(part), face, bary);
      }
    }
  }
}

void PictureSamples::add_sliver(std::int32_t part, std::uint32_t face, Vec3 bary) {
  const ProxyMesh& proxy = scene_->surfaces[static_cast<std::size_t>(part)]->proxy();
  const Vec3 p = proxy.position(face, bary);
  Vec3 n = proxy.normal(face, bary);
  if (glm::dot(n, camera_->to_viewer(p)) < 0) n = -n;
  const Vec2 place = camera_->to_paper(p) / pitch_;
  if (!(place.x >= 0 && place.y >= 0 && place.x < static_cast<double>(nx_) &&
        place.y < static_cast<double>(ny_))) {
    return;
  }
  if (static_cast<double>(positions_.size()) >= 2 * kMostCells || near(p, n).count > 0) return;
  const auto hit = scene_->probe(camera_->to_paper(p));
  if (!hit || hit->part != part || !seen(p)) return;
  slivers_[static_cast<std::int64_t>(place.y) * nx_ + static_cast<std::int64_t>(place.x)].push_back(
      static_cast<std::uint32_t>(positions_.size()));
  positions_.push_back(p);
  normals_.push_back(n);
}

PictureSamples::Near PictureSamples::near_sliver(Vec3 position, Vec3 normal, Vec2 place,
                                                 double reach) const {
  Near out;
  if (slivers_.empty()) return out;
  double least = 0;
  const auto x0 = static_cast<std::int64_t>(std::floor(place.x + 0.5));
  const auto y0 = static_cast<std::int64_t>(std::floor(place.y + 0.5));
  for (std::int64_t y = y0 - 1; y <= y0 + 1; ++y) {
    for (std::int64_t x = x0 - 1; x <= x0 + 1; ++x) {
      if (x < 0 || x >= nx_) continue;
      const auto it = slivers_.find(y * nx_ + x);
      if (it == slivers_.end()) continue;
      for (const std::uint32_t s : it->second) {
        if (!same_surface(static_cast<std::int32_t>(s), position, normal, reach)) continue;
        const double distance = glm::distance(positions_[s], position);
        if (out.count == 1 && distance >= least) continue;
        out = {{s}, {1}, 1};
        least = distance;
      }
    }
  }
  return out;
}

std::int32_t PictureSamples::at(std::int64_t x, std::int64_t y) const {
  if (x < 0 || y < 0 || x >= nx_ || y >= ny_) return -1;
  return cells_[static_cast<std::size_t>(y * nx_ + x)];
}

bool PictureSamples::same_surface(std::int32_t sample, Vec3 position, Vec3 normal,
                                  double reach) const {
  if (sample < 0) return false;
  const auto i = static_cast<std::size_t>(sample);
  return glm::dot(normals_[i], normal) > kSameSide &&
         std::abs(glm::dot(normals_[i], position - positions_[i])) <= reach;
}

PictureSamples::Near PictureSamples::near(Vec3 position, Vec3 normal) const {
  Near out;
  const Vec2 place = camera_->to_paper(position) / pitch_ - 0.5;
  if (!std::isfinite(place.x + place.y)) return out;
  // A cell's width in the model: that far a stretch of surface may bend away from its neighbour's
  // tangent plane.
  const double reach = pitch_ / camera_->scale_at(position);
  const double fx = std::floor(place.x), fy = std::floor(place.y);
  const auto x0 = static_cast<std::int64_t>(fx), y0 = static_cast<std::int64_t>(fy);
  const Vec2 t(place.x - fx, place.y - fy);
  double sum = 0;
  for (int k = 0; k < 4; ++k) {
    const std::int64_t dx = k & 1, dy = k >> 1;
    const std::int32_t s = at(x0 + dx, y0 + dy);
    if (!same_surface(s, position, normal, reach)) continue;
    const double w = (dx == 1 ? t.x : 1 - t.x) * (dy == 1 ? t.y : 1 - t.y);
    const auto c = static_cast<std::size_t>(out.count++);
    out.sample[c] = static_cast<std::uint32_t>(s);
    out.weight[c] = w;
    sum += w;
    if (w > out.weight[0]) {
      std::swap(out.weight[0], out.weight[c]);
      std::swap(out.sample[0], out.sample[c]);
    }
  }
  if (sum > 1e-6) {  // of 1: else the place is on the border of the only cell
    for (double& w : out.weight) w /= sum;
    return out;
  }
  out.count = 0;
  double least = 0;
  for (std::int64_t y = y0 - kReach; y <= y0 + 1 + kReach; ++y) {
    for (std::int64_t x = x0 - kReach; x <= x0 + 1 + kReach; ++x) {
      const std::int32_t s = at(x, y);
      if (!same_surface(s, position, normal, reach)) continue;
      const double distance =
          glm::length(place - Vec2(static_cast<double>(x), static_cast<double>(y)));
      if (out.count == 1 && distance >= least) continue;
      out = {{static_cast<std::uint32_t>(s)}, {1}, 1};
      least = distance;
    }
  }
  return out.count > 0 ? out : near_sliver(position, normal, place, reach);
}

}  // namespace burin::python
