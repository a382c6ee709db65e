#pragma once
// The spans of a NURBS surface as Bezier patches.

#include <burin/forms/charted/nurbs.h>

#include "knot_spans.h"

#include <span>

namespace burin {

using Vec4 = glm::dvec4;

/// Throws GeometryError that says what is wrong.
void check_nurbs(const NurbsData& data);

/// Homogeneous control points (w (P - origin), w) of one Bezier patch a span; span = span_u *
/// v.size() + span_v, each with (degree_u + 1) * (degree_v + 1) points, row-major along u. Weights
/// are scaled so that the largest is 1.
struct NurbsSpans {
  explicit NurbsSpans(const NurbsData& data);

  std::span<const Vec4> patch(std::size_t index) const {
    return std::span(points).subspan(index * per_patch, per_patch);
  }

  KnotSpans u, v;
  int degree_u, degree_v;
  Vec3 origin{0};
  bool rational = false;
  std::size_t per_patch = 0;
  std::vector<Vec4> points;
};

}  // namespace burin
