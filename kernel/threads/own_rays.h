#pragma once
// Rays against the part that a thread is on, and no other; internal to the module.

#include <burin/base/run_context.h>
#include <burin/mesh/proxy_mesh.h>
#include <burin/visibility/occluder.h>

#include <cstdint>
#include <optional>

namespace burin::detail {

/// A place of the part's surface.
struct OwnPlace {
  Vec3 point{0}, normal{0};
  std::int32_t triangle = -1;
  Vec3 bary{0};
  /// Model mm from where the ray began.
  double distance = 0;
};

class OwnRays {
 public:
  /// The proxy must outlive it.
  OwnRays(const ProxyMesh& proxy, const RunContext& context);

  const ProxyMesh& proxy() const { return proxy_; }
  /// The first place that a ray meets up to `far` model mm from its start; `along` is unit.
  std::optional<OwnPlace> first(Vec3 from, Vec3 along, double far) const;
  /// The same where the ray leaves the solid there, so that it began within.
  std::optional<OwnPlace> out_of(Vec3 from, Vec3 along, double far) const;

 private:
  const ProxyMesh& proxy_;
  const ProxyMesh* only_;
  Occluder occluder_;
};

}  // namespace burin::detail
