#pragma once
/// What a face or an edge of a part is, as far as something of it can be measured.

#include <burin/base/box.h>
#include <burin/base/run_context.h>
#include <burin/base/vec.h>
#include <burin/surface/surface.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace burin {

enum class FeatureKind : std::uint8_t {
  Point,
  Line,    // a straight edge
  Circle,  // a round edge, whole or an arc
  Plane,
  Cylinder,
  Cone,
  Sphere,
  Torus,
  Turned,  // another surface of revolution
  Other,
};

/// "a plane", "a cylinder", "a straight edge" ...
const char* to_string(FeatureKind kind);

/// A face or an edge with what it is. Lengths are model mm.
struct Feature {
  FeatureKind kind = FeatureKind::Other;
  /// As the drawing numbers faces and edges; -1 of a point.
  std::int32_t number = -1;
  /// A point of it; of what has a centre or an axis that, or one on this.
  Vec3 point{0};
  /// Unit: the normal of a plane, outward; the way of a line; an axis.
  Vec3 along{0, 0, 1};
  /// Of a circle, a cylinder, a sphere; of a torus that of the tube; else the largest distance from
  /// the axis.
  double radius = 0;
  /// Of a torus: from the axis to the middle of the tube.
  double ring = 0;
  /// Of a cone: degrees between opposite sides.
  double opening = 0;
  /// Whether it is the wall of a hole: its normals point to its axis or its centre.
  bool hollow = false;
  /// Degrees of the way round the axis that there are.
  double turn = 0;
  /// From `point`, along `along`: where it begins and ends.
  double low = 0, high = 0;
  /// Points of it, its borders among them.
  std::vector<Vec3> points;
  /// mm2 of a face, mm of an edge.
  double size = 0;

  bool has_axis() const {
    return kind == FeatureKind::Circle || kind == FeatureKind::Cylinder ||
           kind == FeatureKind::Cone || kind == FeatureKind::Torus || kind == FeatureKind::Turned;
  }
  bool is_round() const { return has_axis() || kind == FeatureKind::Sphere; }
};

/// A point of the model.
Feature point_feature(Vec3 point);

/// The face of that number (`ProxyMesh::face_source`); nothing where the surface has none. Of exact
/// forms by points and normals of the surface itself, so that radii and normals are those of its
/// equation within rounding; else by the corners of the triangles. Faces that are one cylinder in
/// pieces are each measured by themselves. Cost: 100 frames, and some microseconds a triangle.
std::optional<Feature> face_feature(const Surface& surface, std::int32_t number,
                                    const RunContext& context);

/// The edge of that number (`ProxyMesh::source_edge`); nothing where the surface has none, as where
/// it has no numbered edges.
std::optional<Feature> edge_feature(const Surface& surface, std::int32_t number);

/// The face or edge that is nearest to a point, and how far from it, mm; -1 where there is none.
struct NearFeature {
  std::int32_t number = -1;
  double distance = 0;
};
NearFeature nearest_face(const Surface& surface, Vec3 to);
NearFeature nearest_edge(const Surface& surface, Vec3 to);

}  // namespace burin
