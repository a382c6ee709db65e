#pragma once
/// Whether one point of a curve can be seen: one occlusion ray that knows which surfaces the point
/// lies on.

#include <burin/base/curve.h>
#include <burin/camera/camera.h>
#include <burin/mesh/proxy_mesh.h>
#include <burin/visibility/occluder.h>

#include <optional>
#include <span>

namespace burin {

class Cutters;

/// Multiples of the occluder's resolution: distance from a plane within which a point lies on it.
/// Covers vertices that went through single precision (STL) once in each part.
constexpr double kOnPlane = 4;

/// Whether a curve is drawn on a surface rather than where surfaces bend, end or meet.
inline bool lies_on_surface(const Curve3& curve) {
  return curve.kind == LineClass::Stroke || curve.kind == LineClass::Pattern ||
         curve.kind == LineClass::Isophote || curve.kind == LineClass::Thread ||
         curve.kind == LineClass::ThreadEnd;
}

/// Casts rays from points of curves to the viewer. A ray does not count
/// - the triangle that the point lies on, and those whose plane runs through the point: the ray
/// leaves them there, however
///   flat it is to them (coplanar and touching parts, faces seen edge on);
/// - triangles within the chord error of the two meshes of the point: nearer than that the proxies
/// do not tell which one is
///   in front;
/// - of a rounded fold that the point lies on, the triangles around it: a contour does not hide
/// behind its own fold.
class Probe {
 public:
  Probe(const Occluder& occluder, std::span<const ProxyMesh* const> proxies, const Camera& camera)
      : occluder_(occluder), proxies_(proxies), camera_(camera) {}

  /// The occluding lines of the picture from now on. Where they are not known none is between.
  void know_lines(const Cutters& lines) { lines_ = &lines; }
  /// Whether an occluding line runs between two points of the paper, clear of the first.
  bool line_between(Vec2 from, Vec2 to) const;

  /// `segment` of `curve` at the share `t`.
  bool visible(const Curve3& curve, std::size_t segment, double t) const;
  /// Whether something hides it whose plane passes farther off than `clear` times what the proxies
  /// do not tell apart; with 1, whether it cannot be seen.
  bool hidden_by(const Curve3& curve, std::size_t segment, double t, double clear) const;
  /// The same of the surfaces that the proxies stand for: lines of intersection, which lie on the
  /// triangles, are a chord error of both parts off those.
  bool hidden_by_smooth(const Curve3& curve, std::size_t segment, double t, double clear) const;
  /// Whether another part hides it: what no fold of its own makes doubtful.
  bool hidden_by_others(const Curve3& curve, std::size_t segment, double t) const;
  bool several_parts() const { return proxies_.size() > 1; }
  /// Whether any surface lies on the line of sight through a point of the paper.
  bool paper_covered(Vec2 paper) const;
  /// The foremost surface on that line of sight, and where it is in the model.
  struct Seen {
    FaceRef where;
    Vec3 position;
  };
  std::optional<Seen> seen_at(Vec2 paper) const;
  /// Model mm between the triangles at `face` of `part` and the surface they stand for; 0 where
  /// unknown.
  double chord_error(std::int32_t part, std::int32_t face) const;
  /// Model mm that an edge may lie off its own triangle.
  double most_off_edge(Vec3 p) const;

  const Camera& camera() const { return camera_; }
  const Occluder& occluder() const { return occluder_; }
  /// The proxy of a part, or null.
  const ProxyMesh* proxy(std::int32_t part) const;

 private:
  double own_error(const Curve3& curve, std::int32_t face, Vec3 p) const;

  struct Asked {
    double clear = 1;
    bool others = false, smooth = false;
  };
  bool hidden(const Curve3& curve, std::size_t segment, double t, Asked asked) const;

  const Occluder& occluder_;
  std::span<const ProxyMesh* const> proxies_;
  const Camera& camera_;
  const Cutters* lines_ = nullptr;
};

}  // namespace burin
