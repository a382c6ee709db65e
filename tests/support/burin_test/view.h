#pragma once
/// Meshes looked at: proxies, occluder, camera, features and their visibility, as tests want them.

#include <burin/camera/camera.h>
#include <burin/feature/feature.h>
#include <burin/visibility/visible_spans.h>

#include <burin_test/shapes.h>

#include <memory>
#include <utility>
#include <vector>

namespace burin::test {

/// A camera that fits the meshes' vertices.
inline Camera camera_for(const std::vector<ProxyMesh>& proxies, const ViewOptions& options) {
  return Camera::fit(
      [&](const Mat3& axes) {
        Box3 box;
        for (const ProxyMesh& proxy : proxies) {
          for (const Vec3& p : proxy.mesh.positions) box.add(axes * p);
        }
        return box;
      },
      options);
}

struct View {
  RunContext context;
  std::vector<ProxyMesh> proxies;
  std::vector<const ProxyMesh*> pointers;
  Camera camera;
  std::unique_ptr<Occluder> occluder;
  std::vector<Curve3> features;
  std::unique_ptr<VisibilityMap> map;
  std::vector<std::vector<Span>> spans;

  View(std::vector<TriMesh> meshes, const ViewOptions& options, const VisibilityOptions& how = {},
       double crease_angle = 30)
      : proxies(build(std::move(meshes), crease_angle, context)),
        camera(camera_for(proxies, options)) {
    for (const ProxyMesh& p : proxies) pointers.push_back(&p);
    occluder = std::make_unique<Occluder>(pointers, context);
    Diagnostics diagnostics;
    features = extract_features(pointers, camera, {}, diagnostics, context);
    map = std::make_unique<VisibilityMap>(*occluder, pointers, camera, features, context);
    spans = map->classify(features, how, context);
  }

  static std::vector<ProxyMesh> build(std::vector<TriMesh> meshes, double crease_angle,
                                      const RunContext& run) {
    std::vector<ProxyMesh> out;
    for (TriMesh& m : meshes) {
      out.push_back(build_proxy(std::move(m), {.crease_angle = crease_angle}, run));
    }
    return out;
  }

  std::vector<Span> classify(const Curve3& curve, const VisibilityOptions& how = {}) const {
    return map->classify(std::span(&curve, 1), how, context)[0];
  }
};

/// A straight line in space without any knowledge of surfaces.
inline Curve3 line(Vec3 a, Vec3 b, int segments = 1) {
  Curve3 c;
  for (int i = 0; i <= segments; ++i) {
    c.points.push_back(a + (b - a) * (static_cast<double>(i) / segments));
  }
  return c;
}

/// Length on paper of a stretch of a curve.
inline double paper_length(const Camera& camera, const Curve3& curve, double begin, double end) {
  const Curve3 part = slice(curve, begin, end);
  double length = 0;
  for (std::size_t i = 0; i < part.segment_count(); ++i) {
    length +=
        glm::length(camera.to_paper(part.points[part.next(i)]) - camera.to_paper(part.points[i]));
  }
  return length;
}

/// The point of a curve at a parameter.
inline Vec3 point_at(const Curve3& curve, double parameter) {
  const auto i = std::min(static_cast<std::size_t>(parameter), curve.segment_count() - 1);
  const double t = parameter - static_cast<double>(i);
  return glm::mix(curve.points[i], curve.points[curve.next(i)], t);
}

}  // namespace burin::test
