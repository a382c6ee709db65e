#pragma once
/// The curve of an edge in the parameters of a face.

#include <burin/base/vec.h>

#include <Geom2d_Curve.hxx>

namespace burin {

/// A point of a face's (u,v) for each parameter t of the EDGE. Geom2d curves keep no cache (their
/// adaptors do), so that it is safe for many threads.
class Pcurve {
 public:
  Pcurve() = default;
  /// `first`..`last` of the curve run along `edge_first`..`edge_last` of the edge.
  Pcurve(const Handle(Geom2d_Curve) & curve, double first, double last, double edge_first,
         double edge_last);

  bool known() const { return straight_ || !curve_.IsNull(); }
  bool straight() const { return straight_; }
  Vec2 at(double t) const;

 private:
  Handle(Geom2d_Curve) curve_;
  double scale_ = 1, shift_ = 0;
  /// Lines are most of them: origin + t * direction.
  bool straight_ = false;
  Vec2 origin_{0}, direction_{0};
};

}  // namespace burin
