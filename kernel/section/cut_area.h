#pragma once
/// What parts show in the planes that cut them; internal to the module.

#include <burin/base/box.h>
#include <burin/base/curve.h>
#include <burin/camera/camera.h>
#include <burin/mesh/proxy_mesh.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace burin::detail {

/// What one part shows in one plane.
struct Area {
  std::int32_t part = 0;
  Vec3 normal{0}, u{0}, v{0};  // u: horizontal
  double offset = 0;
  std::vector<std::uint32_t> faces = {};
  std::vector<std::array<Vec2, 3>> triangles = {};
  std::vector<std::array<Vec2, 2>> outline = {};
  /// Of each triangle and each piece of the outline the connected piece of the area.
  std::vector<std::int32_t> regions = {}, outline_regions = {};
  Box2 box = {};
  double size = 0;  // model mm2
  double angle = 0;
  bool again = false;  // a neighbour has the angle
};

/// The areas of a part, in the order of their planes.
std::vector<Area> areas_of(const ProxyMesh& proxy, std::int32_t part);
/// Whether they lie in one plane, up to so many model mm.
bool in_one_plane(const Area& a, const Area& b, double near);
/// Whether two areas lie in one plane and overlap or come nearer to each other than `near`, in
/// model mm.
bool neighbours(const Area& a, const Area& b, double near);
/// Paper mm for a model mm in the middle of it.
double scale_of(const Area& area, const Camera& camera);
/// Nothing is seen of such an area but its outline, which the lines would blacken.
bool edge_on(const Area& area, const Camera& camera);
/// Takes the connected pieces that are narrower than `width` (model mm) everywhere out of an area:
/// each by itself.
std::vector<Area> take_narrow(Area& area, double width);

/// What lines keep clear of: pieces of an outline, by so many model mm; and areas in the same
/// plane.
struct Clearance {
  std::vector<std::array<Vec2, 2>> outline = {};
  double width = 0;
  std::vector<const Area*> areas = {};
};
/// Lines over an area at an angle (degrees from its horizontal), `spacing` (model mm) apart, on a
/// lattice that is fixed in the model.
void hatch_lines(const Area& area, double degrees, double spacing, const Clearance& clear,
                 std::vector<Curve3>& out);

}  // namespace burin::detail
