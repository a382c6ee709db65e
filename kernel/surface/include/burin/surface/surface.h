#pragma once
/// The contract between forms and everything above: a surface covers itself with points and marches
/// on itself.
/// @cite Elber1998

#include <burin/base/diagnostics.h>
#include <burin/base/run_context.h>
#include <burin/base/vec.h>
#include <burin/mesh/proxy_mesh.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace burin {

/// A point on a surface.
struct SurfacePoint {
  /// The face of an atlas (B-rep, splines); 0 where a form has no charts.
  std::int32_t chart = -1;
  /// (u, v, 0) in the chart; barycentric in the triangle where there are no charts.
  Vec3 coords{0};
  /// Model mm.
  Vec3 position{0};
  /// Of the proxy, at the point or next to it.
  std::uint32_t triangle = 0;
};

/// The kind of surface of a CAD face, as far as strokes treat kinds differently.
enum class FaceKind : std::uint8_t { Plane, Cylinder, Cone, Sphere, Torus, Freeform };

/// Local geometry at a surface point: all that fields, tone and strokes know of a form.
struct Frame {
  Vec3 position{0};
  /// Unit, outward for closed surfaces.
  Vec3 normal{0, 0, 1};
  /// Principal curvatures in 1/mm, k1 >= k2, positive on a sphere; unit tangent directions d1, d2.
  double k1 = 0, k2 = 0;
  Vec3 d1{1, 0, 0}, d2{0, 1, 0};
  /// Partial derivatives in the chart; zero where the form has no parameters.
  Vec3 du{0}, dv{0};
  /// No principal directions are defined here: the surface is flat, or bends alike all round.
  bool umbilic = true;
  /// How certain d1 and d2 are, in [0,1].
  double confidence = 0;
  /// Freeform also where nothing is known.
  FaceKind kind = FaceKind::Freeform;
};

/// Why a march ended.
enum class MarchStop {
  Completed,     // the length was travelled
  Boundary,      // the surface ends here
  Crease,        // a sharp edge
  Singular,      // the tangent vanished or the point has no tangent plane
  NotConverged,  // a numeric method gave up
};

/// What came of a march: where it ended, the direction there (the tangent carried along), how
/// far it went in model mm, and why it stopped.
struct MarchStep {
  SurfacePoint end;
  Vec3 direction{0};
  double length = 0;
  MarchStop stop = MarchStop::Completed;
};

/// What `cover` shall do: `count` independent points, uniform by area in model space, or by the
/// weight where one is given. The stream of random numbers is keyed by (seed, part, face).
struct CoverRequest {
  std::size_t count = 1000;
  std::uint64_t seed = 1;
  std::int32_t part = 0;
  /// Relative density in [0,1] at a point with its unit normal; absent = 1 everywhere. With the
  /// cosine between normal and view it makes the points uniform in the picture.
  /// Called from many threads.
  std::function<double(Vec3 position, Vec3 normal)> weight = {};
  /// Whether a triangle of the proxy, given by its corners, may hold points; absent = all may.
  /// Spares the candidates that the weight would reject.
  std::function<bool(Vec3 a, Vec3 b, Vec3 c)> among = {};
};

/// A point of the proxy mesh: triangle and barycentric coordinates.
struct ProxyPoint {
  std::uint32_t face = 0;
  Vec3 bary{1, 0, 0};
};

/// Any surface form. Immutable; every function may be called from many threads.
class Surface {
 public:
  Surface() = default;
  Surface(const Surface&) = delete;
  Surface& operator=(const Surface&) = delete;
  virtual ~Surface() = default;

  /// Operation 1. The default draws points on the proxy by area and lifts them by `lift`; forms
  /// made of charts draw them in (u,v), by Algorithm 1 of the paper. A larger `count` gives the
  /// same points first.
  virtual std::vector<SurfacePoint> cover(const CoverRequest& request,
                                          const RunContext& context) const;
  /// Operation 2. Goes `length` model mm from `from` in the direction of `tangent` (need not be
  /// unit nor exactly tangent: it is projected), straight on the surface, over smooth edges and
  /// seams but not over creases.
  virtual MarchStep march(const SurfacePoint& from, Vec3 tangent, double length) const = 0;
  /// Local geometry. Curvature is present where the surface was realised with it.
  virtual Frame frame(const SurfacePoint& point) const = 0;
  /// The triangles that stand for the surface: they hide what is behind them.
  /// `ProxyMesh::tolerance` is how far they may lie from the surface.
  virtual const ProxyMesh& proxy() const = 0;

  /// Where on the proxy a point lies, and the point of the surface at (nearest to) a place of the
  /// proxy.
  virtual ProxyPoint to_proxy(const SurfacePoint& point) const = 0;
  virtual SurfacePoint lift(const ProxyPoint& point) const = 0;
  /// u and v of a point, from 0 to 1 over its chart; nothing where the form has no parameters.
  virtual std::optional<Vec2> parameters(const SurfacePoint& /*point*/) const {
    return std::nullopt;
  }
  /// Whether frames come from the equations of faces that the proxy names (`source_face`); else
  /// they are estimates, or nothing is known of faces.
  virtual bool exact() const { return false; }
  /// Whether any coarser tolerance would have given this surface, too. False proves nothing.
  virtual bool holds_for_coarser() const { return false; }
  /// Where ink at a surface point is drawn: the point itself for exact forms; for a mesh the smooth
  /// surface that its facets stand for, so that strokes meet the contours.
  virtual Vec3 drawn_position(const SurfacePoint& point) const { return point.position; }
  /// Frames at all wedges of the proxy. The default lifts each wedge and asks `frame`.
  virtual std::vector<Frame> wedge_frames(const RunContext& context) const;
};

}  // namespace burin
