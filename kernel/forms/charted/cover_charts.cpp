#include "cover_charts.h"

#include <burin/base/affine.h>
#include <burin/base/parallel.h>
#include <burin/base/rng.h>
#include <burin/forms/charted/coverage.h>
#include <burin/surface/candidates.h>

#include <algorithm>
#include <cmath>

namespace burin::detail {
namespace {

// Random numbers that one candidate uses: the triangle, two coordinates in it, the test.
constexpr std::uint64_t kDraws = 4;
// Candidates a point from which a face is covered by the areas of its triangles instead.
constexpr double kMostWaste = 4;

}  // namespace

// What the candidates of one request are drawn from.
struct ChartsCover::Draw {
  Rng rng;
  WeightedDraw triangles;
};

ChartsCover::ChartsCover(const PlacedAtlas& atlas, const TriMesh& mesh,
                         const UvTriangles& triangles, const RunContext& context)
    : atlas_(atlas), mesh_(mesh), triangles_(triangles), bound_(atlas.atlas->face_count(), 0) {
  const std::size_t faces = bound_.size();
  std::vector<double> in_space(faces, 0), in_parameters(faces, 0);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto f = static_cast<std::size_t>(triangles.face(t));
    in_space[f] += mesh.area(t);
    in_parameters[f] += triangles.draw_area(t);
  }
  const double grown = area_stretch(atlas.placement);
  parallel_for(
      faces, 1,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) {
          if (!(in_space[f] > 0)) continue;
          const auto bound =
              proved_area_bound(atlas_.atlas->chart(static_cast<std::int32_t>(f)), context);
          if (!bound || !(bound->value > 0) || !std::isfinite(bound->value)) continue;
          const double value = bound->value * grown;
          if (value * in_parameters[f] <= kMostWaste * in_space[f]) bound_[f] = value;
        }
      },
      &context);
}

double ChartsCover::weight(std::uint32_t triangle) const {
  const double bound = bound_[static_cast<std::size_t>(triangles_.face(triangle))];
  return bound > 0 ? bound * triangles_.draw_area(triangle) : mesh_.area(triangle);
}

std::optional<SurfacePoint> ChartsCover::candidate(const Draw& draw, const CoverRequest& request,
                                                   std::size_t i) const {
  const std::uint32_t triangle = draw.triangles(draw.rng.uniform(kDraws * i));
  const std::int32_t face = triangles_.face(triangle);
  const double a = draw.rng.uniform(kDraws * i + 1), b = draw.rng.uniform(kDraws * i + 2);
  const double bound = bound_[static_cast<std::size_t>(face)];
  const UvDraw place = bound > 0 ? triangles_.draw(triangle, a, b) : UvDraw{uniform_bary(a, b)};
  const Vec2 uv = triangles_.uv(triangle, place.bary);
  const SurfaceDerivatives d = atlas_.derivatives(face, uv);
  double keep = bound > 0 ? place.keep * glm::length(glm::cross(d.u, d.v)) / bound : 1;
  const double dice = draw.rng.uniform(kDraws * i + 3);
  if (!(dice < keep)) return std::nullopt;
  if (request.weight) {
    keep *= request.weight(d.p, atlas_.normal(face, uv, d));
    if (!(dice < keep)) return std::nullopt;
  }
  return SurfacePoint{face, Vec3(uv, 0), d.p, triangle};
}

std::vector<SurfacePoint> ChartsCover::points(const CoverRequest& request,
                                              const RunContext& context) const {
  double in_space = 0;
  const Draw draw{Rng(request.seed, static_cast<std::uint64_t>(request.part)),
                  weigh_triangles(mesh_, request, [&](std::uint32_t t) {
                    in_space += mesh_.area(t);
                    return weight(t);
                  })};
  if (!(draw.triangles.total() > 0) || !(in_space > 0)) return {};
  const double waste = std::clamp(draw.triangles.total() / in_space, 1.0, kMostWaste);
  const auto limit =
      static_cast<std::size_t>(waste * static_cast<double>(kMaxCandidates * request.count));
  return keep_candidates<SurfacePoint>(request.count, limit, context,
                                       [&](std::size_t i) { return candidate(draw, request, i); });
}

}  // namespace burin::detail
