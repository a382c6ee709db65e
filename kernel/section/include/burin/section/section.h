#pragma once
/// Forms cut open: what lies beyond planes is taken away, and what was inside is closed by flat
/// faces.

#include <burin/base/vec.h>
#include <burin/surface/scene.h>

#include <memory>
#include <string>
#include <vector>

namespace burin {

/// A plane n . p = offset in model mm; what lies beyond it (n . p > offset) is taken away.
struct CutPlane {
  Vec3 normal{0, 0, 1};  // unit
  double offset = 0;

  bool operator==(const CutPlane&) const = default;
};

/// What lies beyond ALL of its planes is taken away: one for a half, two for a quarter, those of a
/// convex body, turned inwards, for an opening. At least one plane.
using CutRegion = std::vector<CutPlane>;

/// `form` without a region. Its surface is that of the form, strokes stop at the planes, and
/// triangles of the proxy that lie in plane i (`ProxyMesh::cut_plane` is `number` + i there) close
/// what it runs through, so that closed forms stay closed. Loops close by construction: a vertex
/// within 1e-6 of the form's size of a plane lies on it, and a point between two vertices is
/// computed once. Where the form is open its loops may not close: then these stay open and the form
/// is named in a diagnostic (`section.open`). `name` is what diagnostics call the part. Where
/// nothing is left the surface is empty; forms that were cut may be cut again, by which several
/// regions go. Cost: each plane looks at the triangles that lie beyond those before it.
std::shared_ptr<const Form> cut_form(std::shared_ptr<const Form> form, CutRegion region,
                                     std::int32_t number, std::string name);
/// By one plane.
std::shared_ptr<const Form> cut_form(std::shared_ptr<const Form> form, const CutPlane& plane,
                                     std::int32_t number, std::string name);

}  // namespace burin
