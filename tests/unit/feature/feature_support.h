#pragma once
// Features of meshes as the tests of this module ask for them.

#include <burin/feature/feature.h>

#include <burin_test/shapes.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace burin::test {

/// Meshes, a camera that fits them, and their features.
struct Looked {
  RunContext context;
  std::vector<ProxyMesh> proxies;
  Camera camera;
  Diagnostics diagnostics;
  std::vector<Curve3> curves;

  Looked(std::vector<TriMesh> meshes, const ViewOptions& view, const FeatureOptions& options = {},
         double crease_angle = 30)
      : proxies(build(std::move(meshes), crease_angle, context)), camera(fit(proxies, view)) {
    std::vector<const ProxyMesh*> pointers;
    for (const ProxyMesh& p : proxies) pointers.push_back(&p);
    curves = extract_features(pointers, camera, options, diagnostics, context);
  }

  static std::vector<ProxyMesh> build(std::vector<TriMesh> meshes, double crease_angle,
                                      const RunContext& run) {
    std::vector<ProxyMesh> out;
    for (TriMesh& m : meshes) {
      out.push_back(build_proxy(std::move(m), {.crease_angle = crease_angle}, run));
    }
    return out;
  }
  static Camera fit(const std::vector<ProxyMesh>& proxies, const ViewOptions& view) {
    return Camera::fit(
        [&](const Mat3& axes) {
          Box3 box;
          for (const ProxyMesh& proxy : proxies) {
            for (const Vec3& p : proxy.mesh.positions) box.add(axes * p);
          }
          return box;
        },
        view);
  }

  std::vector<Curve3> of(LineClass kind) const {
    std::vector<Curve3> out;
    std::ranges::copy_if(curves, std::back_inserter(out),
                         [&](const Curve3& c) { return c.kind == kind; });
    return out;
  }
};

inline bool hidden(const Curve3& c, std::size_t segment) {
  return !c.self_hidden.empty() && c.self_hidden[segment] != 0;
}
inline bool all_hidden(const Curve3& c) {
  return !c.self_hidden.empty() &&
         std::ranges::all_of(c.self_hidden, [](std::uint8_t h) { return h != 0; });
}
inline bool none_hidden(const Curve3& c) {
  return std::ranges::all_of(c.self_hidden, [](std::uint8_t h) { return h == 0; });
}

/// Length on paper of the segments that do not hide themselves.
inline double open_length(const Camera& camera, const Curve3& c) {
  double sum = 0;
  for (std::size_t i = 0; i < c.segment_count(); ++i) {
    if (hidden(c, i)) continue;
    sum += glm::length(camera.to_paper(c.points[c.next(i)]) - camera.to_paper(c.points[i]));
  }
  return sum;
}

inline double length(const Curve3& c) {
  double sum = 0;
  for (std::size_t i = 0; i < c.segment_count(); ++i) {
    sum += glm::length(c.points[c.next(i)] - c.points[i]);
  }
  return sum;
}

/// How many ends of open curves lie exactly on `p`.
inline int ends_at(const std::vector<Curve3>& curves, Vec3 p) {
  int count = 0;
  for (const Curve3& c : curves) {
    if (c.closed) continue;
    count += (c.points.front() == p) + (c.points.back() == p);
  }
  return count;
}

}  // namespace burin::test
