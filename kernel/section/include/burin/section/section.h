#pragma once
/// Forms cut open: one side of a plane is taken away, and what was inside is closed by a flat face.

#include <burin/base/vec.h>
#include <burin/surface/scene.h>

#include <memory>
#include <string>

namespace burin {

/// A plane n . p = offset in model mm; what lies beyond it (n . p > offset) is taken away.
struct CutPlane {
  Vec3 normal{0, 0, 1};  // unit
  double offset = 0;

  bool operator==(const CutPlane&) const = default;
};

/// `form` without what lies beyond the plane. Its surface is that of the form, strokes stop at the
/// plane, and triangles of the proxy that lie in it (`ProxyMesh::cut_plane` is `number` there)
/// close what the plane runs through, so that closed forms stay closed. Loops close by
/// construction: a vertex within 1e-6 of the form's size of the plane lies on it, and a point
/// between two vertices is computed once. Where the form is open its loops do not close: then the
/// cut stays open and is named in a diagnostic (`section.open`). `name` is what diagnostics call
/// the part. Where nothing is left the surface is empty.
std::shared_ptr<const Form> cut_form(std::shared_ptr<const Form> form, const CutPlane& plane,
                                     std::int32_t number, std::string name);

}  // namespace burin
