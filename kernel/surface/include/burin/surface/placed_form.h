#pragma once
/// A form that stands elsewhere than it was read.

#include <burin/base/placement.h>
#include <burin/surface/scene.h>

#include <memory>

namespace burin {

class Instances;

/// One form, placed any number of times. In an orthographic view placed forms that differ by their
/// offsets alone are realised once, as long as one of their surfaces lives; each has its own copy
/// of the triangles. Safe from many threads.
class Placer {
 public:
  explicit Placer(std::shared_ptr<const Form> form);

  /// The form where the placement takes it. Turned, scaled and moved (within 1e-9): points,
  /// normals, curvatures (divided by the scale), parameters and triangles are its own, placed.
  /// Mirrored, stretched or sheared: what `Form::mapped` makes of it, once for all copies that
  /// differ by their offsets alone. The form itself where the placement moves nothing. Throws
  /// UsageError where the placement is not invertible or not finite. A form that is placed already
  /// is moved on from there, not wrapped again. Cost: that of `Form::mapped`, for a mesh a copy of
  /// its points.
  std::shared_ptr<const Form> at(const Placement& placement) const;

 private:
  std::shared_ptr<Instances> instances_;
  /// What it was given, and where that stands.
  std::shared_ptr<const Form> form_;
  Placement before_;
};

/// A form placed once.
std::shared_ptr<const Form> placed(std::shared_ptr<const Form> form, const Placement& placement);

}  // namespace burin
