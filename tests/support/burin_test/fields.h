#pragma once
/// Realised shapes and the angles of direction fields on them.

#include <burin/base/rng.h>
#include <burin/field/smoothed_field.h>

#include <burin_test/exact.h>
#include <burin_test/facets.h>
#include <burin_test/shapes.h>

#include <cmath>
#include <memory>
#include <optional>
#include <vector>

namespace burin::test {

/// What a stroke tracer asks at a point: the arm of a family, or, on the way, the one that goes on.
struct Asked {
  FieldQuery query;
  int family = 1;
  Vec3 previous{0};
};

/// `field`: a Field, or what has its function `cross`.
template <class HasCross>
std::optional<Vec3> direction(const HasCross& field, const Asked& asked) {
  const auto cross = field.cross(asked.query);
  if (!cross) return std::nullopt;
  return asked.previous == Vec3(0) ? family_direction(*cross, asked.family)
                                   : direction_along(*cross, asked.previous);
}

/// How clearly a field speaks; 0 where it says nothing.
inline double certainty(const Field& field, const Asked& asked) {
  const auto cross = field.cross(asked.query);
  return cross ? cross->certainty : 0;
}

/// A point with its frame.
struct Probe {
  SurfacePoint point;
  Frame frame;

  Probe(const Surface& s, ProxyPoint at) : point(s.lift(at)), frame(s.frame(point)) {}
  Asked query(int family = 1, Vec3 previous = Vec3(0)) const {
    return {{0, point, frame}, family, previous};
  }
};

/// Points all over a surface, the same for any pose of it: some in every `stride`-th triangle.
inline std::vector<Probe> probes(const Surface& s, std::uint32_t stride = 1) {
  std::vector<Probe> result;
  const Rng rng(11);
  for (std::uint32_t f = 0; f < s.proxy().mesh.triangles.size(); f += stride) {
    const double a = rng.uniform(2 * f), b = rng.uniform(2 * f + 1);
    result.emplace_back(
        s, ProxyPoint{f, a + b < 1 ? Vec3(1 - a - b, a, b) : Vec3(a + b - 1, 1 - a, 1 - b)});
  }
  return result;
}

/// Degrees between a direction and the nearest arm of the cross of `arm` in the tangent plane.
inline double cross_angle(Vec3 direction, Vec3 arm, Vec3 normal) {
  return std::min(line_angle(direction, arm), line_angle(direction, glm::cross(normal, arm)));
}

/// A smoothed field on one surface.
struct Smoothed {
  std::shared_ptr<const Surface> surface;
  std::unique_ptr<field::SmoothedField> field;

  explicit Smoothed(TriMesh mesh, field::SmoothedOptions options = {})
      : surface(realised(std::move(mesh))) {
    const RunContext context;
    field = std::make_unique<field::SmoothedField>(std::vector<const Surface*>{surface.get()},
                                                   options, context);
  }
  std::optional<Vec3> at(const Probe& p, int family = 1, Vec3 previous = Vec3(0)) const {
    return direction(*field, p.query(family, previous));
  }
  int index_sum() const {
    int sum = 0;
    for (const field::Singularity& s : field->singularities(0)) sum += s.index;
    return sum;
  }
};

}  // namespace burin::test
