#include <burin/base/parallel.h>
#include <burin/base/rng.h>
#include <burin/surface/scene.h>
#include <burin/surface/surface.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace burin {
namespace {

// Random numbers that one candidate uses: the triangle, two coordinates in it, the test against the
// weight.
constexpr std::uint64_t kDraws = 4;
// Candidates a point at the most, so that a weight that is zero everywhere ends.
constexpr std::size_t kMaxCandidates = 200;

std::vector<double> cumulative_areas(const TriMesh& mesh, const CoverRequest& request) {
  std::vector<double> sums(mesh.triangles.size());
  double total = 0;
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
    const auto& [a, b, c] = mesh.triangles[f];
    const bool counts =
        !request.among || request.among(mesh.positions[a], mesh.positions[b], mesh.positions[c]);
    sums[f] = total += counts ? mesh.area(f) : 0;
  }
  return sums;
}

constexpr std::size_t kGrain = 1024;

// The candidate number `i`, uniform by area; nothing where the weight rejects it.
std::optional<ProxyPoint> candidate(const ProxyMesh& p, const std::vector<double>& sums,
                                    const Rng& rng, const CoverRequest& request, std::size_t i) {
  const double at = rng.uniform(kDraws * i) * sums.back();
  const auto it = std::upper_bound(sums.begin(), sums.end(), at);
  const auto face = static_cast<std::uint32_t>(
      std::min<std::ptrdiff_t>(it - sums.begin(), static_cast<std::ptrdiff_t>(sums.size()) - 1));
  // Uniform in the triangle: the square root undoes the narrowing towards one corner. @cite
  // Osada2002
  const double r = std::sqrt(rng.uniform(kDraws * i + 1)), s = rng.uniform(kDraws * i + 2);
  const ProxyPoint place{face, Vec3(1 - r, r * (1 - s), r * s)};
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
  const std::vector<double> sums = cumulative_areas(p.mesh, request);
  std::vector<SurfacePoint> points;
  if (sums.empty() || !(sums.back() > 0)) return points;
  const Rng rng(request.seed, static_cast<std::uint64_t>(request.part));
  points.reserve(request.count);
  // Candidates are tried in blocks on all cores; those kept are taken in the order of the
  // candidates, so that no result depends on the blocks.
  const std::size_t limit = kMaxCandidates * request.count;
  std::vector<std::optional<ProxyPoint>> kept;
  for (std::size_t first = 0; first < limit && points.size() < request.count;) {
    const std::size_t block =
        std::min(limit - first, std::max<std::size_t>(kGrain, request.count - points.size()));
    kept.assign(block, std::nullopt);
    parallel_for(
        block, kGrain,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t k = begin; k < end; ++k)
            kept[k] = candidate(p, sums, rng, request, first + k);
        },
        &context);
    for (std::size_t k = 0; k < block && points.size() < request.count; ++k) {
      if (kept[k]) points.push_back(lift(*kept[k]));
    }
    first += block;
  }
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
