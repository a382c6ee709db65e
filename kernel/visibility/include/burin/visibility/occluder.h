#pragma once
/// The scene as something that hides: ray queries against all proxies (Embree behind it).

#include <burin/base/run_context.h>
#include <burin/base/vec.h>
#include <burin/mesh/proxy_mesh.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace burin {

/// A triangle of a part's proxy.
struct FaceRef {
  std::int32_t part = -1;
  std::uint32_t face = 0;
};

/// Where a ray meets a triangle; `bary` (not negative) and `distance` (model mm) in double
/// precision.
struct Hit {
  FaceRef where;
  Vec3 bary{0};
  double distance = 0;
};

/// How an occluder answers.
struct OccluderOptions {
  /// Embree's configuration, as "isa=sse2" for its code for processors of that kind; the answers
  /// are the same. For tests.
  std::string embree{};
  /// One a part, or fewer (0): of parts that lie on each other the one of the highest rank is met
  /// first.
  std::vector<double> ranks{};
};

/// Built once, read by many threads. Which triangles a ray meets, and where, is decided in double
/// precision and is the same on every processor: a ray within 1e-10 of the scene's diagonal of an
/// edge meets it, one in the plane of a triangle does not. Coordinates are taken relative to the
/// scene's centre and scaled to unit size before they become single precision, and a ray from far
/// away starts for Embree where it enters the scene, so that a part of any size and place gives the
/// same answers. The proxies must outlive the occluder. Throws Cancelled where the run is cancelled
/// while the tree is built. Cost: about 0.2 s and 80 MB a million triangles; 0.1 to 1.5 us a ray.
/// @cite Wald2014, Woop2013
class Occluder {
 public:
  Occluder(std::span<const ProxyMesh* const> proxies, const RunContext& context,
           const OccluderOptions& options = {});
  ~Occluder();
  Occluder(const Occluder&) = delete;
  Occluder& operator=(const Occluder&) = delete;

  /// The first triangle that a ray meets between `near` and `far` model mm from its origin;
  /// `direction` is a unit vector. Of those that lie within 1e-10 of the diagonal behind it the one
  /// of the highest rank, then of the lowest part, then of the lowest number.
  std::optional<Hit> first_hit(Vec3 origin, Vec3 direction, double near, double far) const;
  /// Whether any triangle that `ignore` does not name lies on the ray between `near` and `far`.
  bool occluded(Vec3 origin, Vec3 direction, double near, double far,
                const std::function<bool(FaceRef)>& ignore = {}) const;
  /// Whether any hit between `near` and `far` satisfies `counts`, which is asked in no particular
  /// order, and may be asked about one hit twice.
  bool occluded_by(Vec3 origin, Vec3 direction, double near, double far,
                   const std::function<bool(const Hit&)>& counts) const;
  /// Model mm: the length below which single precision cannot tell two places of this scene apart.
  double resolution() const;
  /// Diagonal of the scene's bounds in model mm.
  double diagonal() const;
  /// Model mm along a ray within which hits are at one place, so that ranks decide: 1e-10 of the
  /// diagonal.
  double tie() const;
  /// Of these bounds, model mm.
  Vec3 center() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace burin
