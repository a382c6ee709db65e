#pragma once
/// What the sample models are built of: loops of points joined by strips and planar faces, as a CAD
/// program tessellates the faces of a part: neighbouring faces share the points of their common
/// edge. Lengths in mm.

#include <burin/mesh/tri_mesh.h>

#include <functional>
#include <string>
#include <vector>

namespace burin::samples {

/// Largest distance between an arc and the chords that stand for it.
inline constexpr double kChord = 0.015;

using Loop = std::vector<Vec3>;
using Outline = std::vector<Vec2>;

/// A named solid of an assembly.
struct Solid {
  std::string name;
  TriMesh mesh;
};

/// Chords of a full circle of `radius` at the chord tolerance.
int circle_segments(double radius, double tolerance = kChord);

/// A corner of an outline, rounded by an arc of `radius` tangent to both sides (0 = sharp).
struct Corner {
  Vec2 at;
  double radius = 0;
};

/// The points of a rounded polyline; arcs end on their tangent points.
Outline rounded(const std::vector<Corner>& corners, bool closed, double tolerance = kChord);
/// Points of an arc about `center` from angle `from` to `to` (radians), both ends included.
Outline arc(Vec2 center, double radius, double from, double to, double tolerance = kChord);
Outline circle(Vec2 center, double radius, int segments);

/// Places the outline's (x, y) at origin + x * u + y * v.
Loop place(const Outline& outline, Vec3 origin, Vec3 u, Vec3 v);

/// Collects faces; orientation is put right at the end.
class Builder {
 public:
  void triangle(Vec3 a, Vec3 b, Vec3 c);
  /// Quads between two loops (or open rows) of one size, or a fan where one of them is a single
  /// point.
  void strip(const Loop& a, const Loop& b, bool closed = true);
  /// A planar face with holes, triangulated over its own points alone.
  void plane(const Loop& outer, const std::vector<Loop>& holes = {});
  /// Strips between successive loops.
  void loft(const std::vector<Loop>& loops, bool closed = true);
  /// Turns the profile of (radius, height) points about the axis; ends at radius 0 close to a
  /// point. Returns the circles.
  std::vector<Loop> revolve(const Outline& profile, Vec3 origin, Vec3 axis, int segments);
  void add(const TriMesh& mesh);

  /// Welds equal points, orients neighbours alike and closed components outwards. Throws
  /// GeometryError where an edge has not exactly two triangles, unless `open`.
  TriMesh finish(bool open = false) const;

 private:
  std::vector<Vec3> corners_;
};

/// A plate: the outline from z = 0 to `height` with holes and its edges rounded or chamfered at top
/// and bottom.
struct PlateEdge {
  double size = 0;
  bool round = true;
};
TriMesh plate(const Outline& outline, const std::vector<Outline>& holes, double height,
              PlateEdge edge);

/// A tube of `radius(t)` about a curve for t in [0,1], closed or with flat ends.
TriMesh tube(const std::function<Vec3(double)>& curve, const std::function<double(double)>& radius,
             int along, int around, bool closed);

TriMesh transformed(TriMesh mesh, const std::function<Vec3(Vec3)>& f);
TriMesh moved(TriMesh mesh, Vec3 by);
/// Takes the z axis to `axis` (unit), by the smallest rotation.
TriMesh turned(TriMesh mesh, Vec3 axis);

}  // namespace burin::samples
