#include "mesh_surface.h"

#include <burin/base/parallel.h>
#include <burin/surface/tangent_basis.h>

#include <cmath>

namespace burin {
namespace {

// Share of confidence below which directions are noise: hatching them would be worse than having
// none.
constexpr double kUmbilicConfidence = 0.02;
constexpr std::size_t kGrain = 4096;

WedgeTensor to_tensor(const Curvature& c, Vec3 normal) {
  const TangentBasis basis(normal);
  const Vec2 d = basis.coords(c.d1);
  const double n = glm::length(d);
  WedgeTensor t;
  t.mean = 0.5 * (c.k1 + c.k2);
  t.confidence = c.confidence;
  if (n > 0) t.deviator = complex_square(d / n) * (0.5 * (c.k1 - c.k2));
  return t;
}

void set_tensor(Frame& frame, const TangentBasis& basis, const WedgeTensor& t) {
  const double m = glm::length(t.deviator);
  frame.k1 = t.mean + m;
  frame.k2 = t.mean - m;
  frame.d1 = m > 0 ? basis.vector(complex_sqrt(t.deviator / m)) : basis.x;
  frame.d2 = glm::cross(frame.normal, frame.d1);
  frame.confidence = m > 0 ? t.confidence : 0;
  frame.umbilic = frame.confidence < kUmbilicConfidence;
}

}  // namespace

MeshSurface::MeshSurface(ProxyMesh proxy, const std::vector<Curvature>& curvature, bool fine)
    : proxy_(std::move(proxy)), fine_(fine), tensors_(curvature.size()) {
  parallel_for(curvature.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t w = begin; w < end; ++w) {
      tensors_[w] = to_tensor(curvature[w], proxy_.wedge_normal[w]);
    }
  });
}

Vec3 MeshSurface::drawn_position(const SurfacePoint& point) const {
  if (fine_) return point.position;
  std::call_once(rounding_, [this] { rounded_.emplace(proxy_); });
  return rounded_->facet(point.triangle).at(point.coords);
}

Frame MeshSurface::frame(const SurfacePoint& point) const {
  const std::uint32_t face = point.triangle;
  const Vec3 b = point.coords;
  Frame f;
  f.position = point.position;
  f.normal = proxy_.normal(face, b);
  const TangentBasis basis(f.normal);
  if (tensors_.empty()) {
    f.d1 = basis.x;
    f.d2 = basis.y;
    return f;
  }
  // The tensor is interpolated, not the directions: these turn by half a turn around an umbilic.
  WedgeTensor sum;
  double size = 0;
  const Triangle& wedges = proxy_.wedges[face];
  for (int k = 0; k < 3; ++k) {
    const std::uint32_t w = wedges[static_cast<std::size_t>(k)];
    const WedgeTensor& t = tensors_[w];
    const Vec2 r = turn(TangentBasis(proxy_.wedge_normal[w]), basis);
    sum.mean += b[k] * t.mean;
    sum.deviator += b[k] * complex_mul(t.deviator, complex_square(r));
    sum.confidence += b[k] * t.confidence;
    size += b[k] * glm::length(t.deviator);
  }
  // Wedges that contradict one another leave little of the mean deviator and of the certainty.
  if (size > 0) sum.confidence *= std::min(1.0, glm::length(sum.deviator) / size);
  set_tensor(f, basis, sum);
  return f;
}

std::vector<Frame> MeshSurface::wedge_frames(const RunContext& context) const {
  std::vector<Frame> frames(proxy_.wedge_vertex.size());
  parallel_for(
      frames.size(), kGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t w = begin; w < end; ++w) {
          Frame& f = frames[w];
          f.position = proxy_.wedge_position(static_cast<std::uint32_t>(w));
          f.normal = proxy_.wedge_normal[w];
          set_tensor(f, TangentBasis(f.normal), tensors_.empty() ? WedgeTensor{} : tensors_[w]);
        }
      },
      &context);
  return frames;
}

}  // namespace burin
