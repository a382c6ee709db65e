#include <burin/field/smoothed_field.h>
#include <burin/surface/tangent_basis.h>

#include "bends.h"
#include "constraints.h"
#include "exact_faces.h"
#include "family.h"
#include "multigrid.h"
#include "plane_faces.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace burin::field {
namespace {

// Mean of the three unit crosses of a triangle below which the field is singular: with crosses that
// turn by an index of one quarter around the triangle, the mean falls below it in the middle tenth
// of the triangle's area, where the field turns by more than a right angle over a third of the
// triangle's size.
constexpr double kSingular = 0.1;

double smooth_step(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

// The circle of latitude on a ball and the meridian.
std::optional<CrossDirections> ball_directions(Vec3 normal, Vec3 axis) {
  constexpr double kPole = 0.03;  // sine of the angle to a pole
  const Vec3 circle = glm::cross(axis, normal);
  const double sine = glm::length(circle);
  if (sine < kPole) return std::nullopt;
  return CrossDirections{circle / sine, glm::cross(normal, circle / sine)};
}

// The cross of the exact lines, where there are some to follow: always on cylinders, cones and
// tori; on freeform faces as far as the smoothed cross, which knows what is noise and what is
// shape, agrees, and away from umbilics. Strokes so follow lines of curvature and not the long
// triangles of a proxy.
Vec2 with_exact_lines(Vec2 cross, const Frame& frame, const TangentBasis& basis) {
  // Cosines of four times the angle between both crosses: 20 and 10 degrees.
  constexpr double kForeign = 0.17, kSame = 0.77;
  constexpr double kUmbilic = 0.05, kClear = 0.2;  // confidence
  const Vec2 d = basis.coords(frame.d1);
  const double length = glm::length(d), size = glm::length(cross);
  if (frame.umbilic || !(length > 0)) return cross;
  const Vec2 own = complex_square(complex_square(d / length));
  if (has_exact_lines(frame)) return own;
  if (size < kSingular) return cross;
  const double follow = smooth_step(kForeign, kSame, glm::dot(own, cross) / size) *
                        smooth_step(kUmbilic, kClear, frame.confidence);
  return (1 - follow) * cross + follow * size * own;
}

}  // namespace

struct SmoothedField::Part {
  const Surface* surface = nullptr;
  bool exact = false;
  BallAxes balls;
  FlatPatches flats;
  // For each wedge the line of family 1, a direction to the second power in the basis on `axis`.
  std::vector<Vec2> line;
  std::vector<Vec3> axis;

  Part(const Surface& s, const SmoothedOptions& options, const RunContext& context) : surface(&s) {
    const ProxyMesh& proxy = s.proxy();
    exact = s.exact();
    CurvedFrames frames;
    std::vector<FaceKind> kinds;
    if (exact) {
      kinds = find_face_kinds(s, context);
      flats = find_plane_faces(s, kinds, options, context);
      balls = find_balls(proxy, kinds, options);
      frames = curved_frames(s, flats, context);
    } else {
      frames.best = s.wedge_frames(context);
      flats = find_flat_patches(proxy, frames.best, options.fallback, context);
    }
    std::vector<std::uint8_t> skipped(flats.face_patch.size());
    for (std::size_t f = 0; f < skipped.size(); ++f) skipped[f] = flats.face_patch[f] >= 0;
    WedgeGraph graph = build_wedge_graph(proxy, skipped, context);
    const Hierarchy<Vec2> hierarchy(graph.crosses, context);
    const Constraints wanted =
        find_constraints(proxy, frames, exact, flats, graph, hierarchy, options, context);
    frames = {};
    const std::vector<Vec2> crosses = minimise(hierarchy, wanted.mass, wanted.pull, context);
    line = choose_family(proxy, graph, crosses, wanted, kinds, exact ? &flats : nullptr, context);
    bend_over_cuts(proxy, graph, wanted, line, context);
    if (!exact) {
      match_flat_families(proxy, graph, line, flats);
    } else if (options.policy.plane == FacePolicy::Plane::Differ) {
      make_planes_differ(proxy, flats);
    }
    axis = std::move(graph.axis);
  }

  // The line of a triangle's wedge in the basis at a point.
  Vec2 carried(std::uint32_t wedge, const TangentBasis& to) const {
    const TangentBasis from(surface->proxy().wedge_normal[wedge], axis[wedge]);
    return complex_mul(line[wedge], complex_square(turn(from, to)));
  }

  const std::optional<Vec3>& ball_axis(std::uint32_t face) const {
    return balls[static_cast<std::size_t>(surface->proxy().face_region[face])];
  }
  int index(std::uint32_t face) const;
};

int SmoothedField::Part::index(std::uint32_t face) const {
  // The crosses' turn from corner to corner, each within half a turn of the fourth power, less what
  // the basis turns by itself on the way round.
  const ProxyMesh& proxy = surface->proxy();
  const Triangle& w = proxy.wedges[face];
  double total = 0, around = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t a = w[k], b = w[(k + 1) % 3];
    const TangentBasis from(proxy.wedge_normal[a], axis[a]), to(proxy.wedge_normal[b], axis[b]);
    const Vec2 r = turn(from, to);
    const Vec2 change =
        complex_mul(complex_square(line[b]),
                    complex_conj(complex_square(complex_mul(complex_square(r), line[a]))));
    total += std::atan2(change.y, change.x);
    around += std::atan2(r.y, r.x);
  }
  const double holonomy = std::remainder(around, 2 * std::numbers::pi);
  return static_cast<int>(std::lround((total + 4 * holonomy) / (2 * std::numbers::pi)));
}

SmoothedField::SmoothedField(const std::vector<const Surface*>& surfaces,
                             const SmoothedOptions& options, const RunContext& context) {
  for (const Surface* s : surfaces) parts_.push_back(std::make_unique<Part>(*s, options, context));
}

SmoothedField::~SmoothedField() = default;

std::optional<Cross> SmoothedField::cross(const FieldQuery& q) const {
  const Part& part = *parts_[static_cast<std::size_t>(q.part)];
  const ProxyPoint at = part.surface->to_proxy(q.point);
  const std::int32_t flat = part.flats.face_patch[at.face];
  const bool ball = part.exact && part.ball_axis(at.face).has_value();
  const double certainty = flat >= 0 ? 2 : q.frame.confidence;
  if (flat >= 0 || ball) {
    const auto arms = ball
                          ? ball_directions(q.frame.normal, *part.ball_axis(at.face))
                          : part.flats.patches[static_cast<std::size_t>(flat)].at(q.point.position);
    if (!arms) return std::nullopt;
    return Cross{arms->first, arms->second, certainty};
  }
  const TangentBasis basis(q.frame.normal);
  const Triangle& wedges = part.surface->proxy().wedges[at.face];
  Vec2 cross(0), line(0);
  for (int k = 0; k < 3; ++k) {
    const Vec2 y = part.carried(wedges[static_cast<std::size_t>(k)], basis);
    cross += at.bary[k] * complex_square(y);
    line += at.bary[k] * y;
  }
  if (part.exact) cross = with_exact_lines(cross, q.frame, basis);
  const double size = glm::length(cross);
  if (size < kSingular) return std::nullopt;
  Vec2 first = complex_sqrt(cross / size);
  if (glm::dot(first, line) < 0) first = -first;
  const Vec3 x = basis.vector(complex_sqrt(first));
  return Cross{x, glm::cross(basis.normal, x), certainty};
}

std::vector<Singularity> SmoothedField::singularities(std::int32_t part) const {
  const Part& p = *parts_[static_cast<std::size_t>(part)];
  std::vector<Singularity> found;
  for (std::uint32_t f = 0; f < p.flats.face_patch.size(); ++f) {
    if (p.flats.face_patch[f] >= 0) continue;
    const int index = p.index(f);
    if (index != 0) found.push_back({f, index});
  }
  return found;
}

const std::vector<std::int32_t>& SmoothedField::flat_patches(std::int32_t part) const {
  return parts_[static_cast<std::size_t>(part)]->flats.face_patch;
}

Field smoothed(const std::vector<const Surface*>& surfaces, const SmoothedOptions& options,
               const RunContext& context) {
  auto built = std::make_shared<const SmoothedField>(surfaces, options, context);
  return {"smoothed", [built](const FieldQuery& q) { return built->cross(q); }, true};
}

}  // namespace burin::field
