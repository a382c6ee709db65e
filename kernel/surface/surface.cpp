#include <burin/base/parallel.h>
#include <burin/base/rng.h>
#include <burin/surface/candidates.h>
#include <burin/surface/scene.h>
#include <burin/surface/surface.h>

#include <algorithm>
#include <optional>

namespace burin {
namespace {

// Random numbers that one candidate uses: the triangle, two coordinates in it, the test against the
// weight.
constexpr std::uint64_t kDraws = 4;

// The candidate number `i`, uniform by area; nothing where the weight rejects it.
std::optional<ProxyPoint> candidate(const ProxyMesh& p, const WeightedDraw& triangles,
                                    const Rng& rng, const CoverRequest& request, std::size_t i) {
  const std::uint32_t face = triangles(rng.uniform(kDraws * i));
  const ProxyPoint place{face,
                         uniform_bary(rng.uniform(kDraws * i + 1), rng.uniform(kDraws * i + 2))};
  if (request.weight) {
    const double keep = request.weight(p.position(face, place.bary), p.normal(face, place.bary));
    if (rng.uniform(kDraws * i + 3) >= keep) return std::nullopt;
  }
  return place;
}

}  // namespace

std::vector<SurfacePoint> Surface::cover(const CoverRequest& request,
                                         const RunContext& context) const {
  const ProxyMesh& p = proxy();
  const WeightedDraw triangles =
      weigh_triangles(p.mesh, request, [&](std::uint32_t f) { return p.mesh.area(f); });
  if (!(triangles.total() > 0)) return {};
  const Rng rng(request.seed, static_cast<std::uint64_t>(request.part));
  const auto places = keep_candidates<ProxyPoint>(
      request.count, kMaxCandidates * request.count, context,
      [&](std::size_t i) { return candidate(p, triangles, rng, request, i); });
  std::vector<SurfacePoint> points;
  points.reserve(places.size());
  for (const ProxyPoint& place : places) points.push_back(lift(place));
  return points;
}

std::vector<Frame> Surface::wedge_frames(const RunContext& context) const {
  const ProxyMesh& p = proxy();
  std::vector<ProxyPoint> place(p.wedge_vertex.size());
  for (std::uint32_t f = 0; f < p.wedges.size(); ++f) {
    for (int k = 0; k < 3; ++k) {
      Vec3 bary(0);
      bary[k] = 1;
      place[p.wedges[f][static_cast<std::size_t>(k)]] = {f, bary};
    }
  }
  std::vector<Frame> frames(place.size());
  parallel_for(
      place.size(), 1024,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t w = begin; w < end; ++w) frames[w] = frame(lift(place[w]));
      },
      &context);
  return frames;
}

Box3 Scene::bounds(const Mat3& axes) const {
  Box3 box;
  for (const Part& part : parts) box.add(part.form->bounds(axes));
  return box;
}

}  // namespace burin
