#include <burin/forms/mesh/texture_map.h>

#include "texture/nearest_triangle.h"

#include <cmath>
#include <mutex>
#include <utility>

namespace burin {
namespace {

Vec3 barycentric_in_space(Vec3 a, Vec3 b, Vec3 c, Vec3 p) {
  const Vec3 ab = b - a, ac = c - a, n = glm::cross(ab, ac);
  const double whole = glm::dot(n, n);
  const double at_b = glm::dot(glm::cross(p - a, ac), n) / whole,
               at_c = glm::dot(glm::cross(ab, p - a), n) / whole;
  return {1 - at_b - at_c, at_b, at_c};
}

class TexturedSurface final : public Surface {
 public:
  TexturedSurface(std::shared_ptr<const Surface> surface, std::shared_ptr<const TextureMap> texture)
      : surface_(std::move(surface)), texture_(std::move(texture)) {}

  std::vector<SurfacePoint> cover(const CoverRequest& request,
                                  const RunContext& context) const override {
    return surface_->cover(request, context);
  }
  MarchStep march(const SurfacePoint& from, Vec3 tangent, double length) const override {
    return surface_->march(from, tangent, length);
  }
  Frame frame(const SurfacePoint& point) const override { return surface_->frame(point); }
  const ProxyMesh& proxy() const override { return surface_->proxy(); }
  ProxyPoint to_proxy(const SurfacePoint& point) const override {
    return surface_->to_proxy(point);
  }
  SurfacePoint lift(const ProxyPoint& point) const override { return surface_->lift(point); }
  std::optional<Vec2> parameters(const SurfacePoint& point) const override {
    return texture_->at(point.position);
  }
  bool exact() const override { return surface_->exact(); }
  bool holds_for_coarser() const override { return surface_->holds_for_coarser(); }
  Vec3 drawn_position(const SurfacePoint& point) const override {
    return surface_->drawn_position(point);
  }
  std::vector<Frame> wedge_frames(const RunContext& context) const override {
    return surface_->wedge_frames(context);
  }

 private:
  std::shared_ptr<const Surface> surface_;
  std::shared_ptr<const TextureMap> texture_;
};

}  // namespace

struct TextureMap::Impl {
  TriMesh mesh;
  std::vector<glm::vec2> corners;
  // Made when u and v are first asked for: most drawings do without.
  std::once_flag once;
  std::optional<detail::NearestTriangle> nearest;
};

TextureMap::TextureMap(TriMesh mesh, std::vector<glm::vec2> corners)
    : impl_(std::make_unique<Impl>()) {
  std::size_t kept = 0;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const double area = mesh.area(i);
    if (!(area > 0 && std::isfinite(area))) continue;
    mesh.triangles[kept] = mesh.triangles[i];
    for (std::size_t k = 0; k < 3; ++k) corners[3 * kept + k] = corners[3 * std::size_t{i} + k];
    ++kept;
  }
  mesh.triangles.resize(kept);
  corners.resize(3 * kept);
  impl_->mesh = std::move(mesh);
  impl_->corners = std::move(corners);
}
TextureMap::~TextureMap() = default;

std::shared_ptr<const TextureMap> TextureMap::mapped(const Placement& by) const {
  TriMesh mesh = impl_->mesh;
  for (Vec3& p : mesh.positions) p = by.point(p);
  return std::make_shared<TextureMap>(std::move(mesh), impl_->corners);
}

std::optional<Vec2> TextureMap::at(Vec3 position) const {
  const TriMesh& mesh = impl_->mesh;
  if (mesh.triangles.empty()) return std::nullopt;
  std::call_once(impl_->once, [&] { impl_->nearest.emplace(mesh); });
  const auto found = impl_->nearest->at(position);
  const Triangle& t = mesh.triangles[found.triangle];
  const Vec3 bary = barycentric_in_space(mesh.positions[t[0]], mesh.positions[t[1]],
                                         mesh.positions[t[2]], found.position);
  Vec2 uv(0);
  for (std::size_t k = 0; k < 3; ++k) {
    uv += bary[static_cast<glm::length_t>(k)] *
          Vec2(impl_->corners[3 * std::size_t{found.triangle} + k]);
  }
  if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) return std::nullopt;
  return uv;
}

std::shared_ptr<const Surface> textured(std::shared_ptr<const Surface> surface,
                                        std::shared_ptr<const TextureMap> texture) {
  if (!texture) return surface;
  return std::make_shared<TexturedSurface>(std::move(surface), std::move(texture));
}

}  // namespace burin
