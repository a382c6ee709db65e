#include <burin/base/parallel.h>
#include <burin/base/smoothstep.h>
#include <burin/mesh/curvature.h>

#include "../build_steps.h"
#include "face_tensors.h"
#include "tensor_smoothing.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace burin {

namespace {

/// Passes after which the tensors are looked at; each doubling halves the noise, at the cost of
/// detail.
constexpr int kLevels[] = {0, 1, 2, 4, 8, 16, 32};
/// A deviator over its noise: of pure noise one value in a hundred is over the first and one in a
/// thousand over the second, from where on it is left as it is. More smoothing would only blur.
constexpr double kNoise = 6, kSignal = 10;
/// |k1 - k2| over the larger |k|: below the first umbilic, above the second not.
constexpr double kUmbilic = 0.05, kAnisotropic = 0.15;
/// Largest |k| times the diagonal of the mesh: below the first flat (the whole part would bend by a
/// degree), above the second curved.
constexpr double kFlat = 0.02, kCurved = 0.06;
/// Wedges, of all, that may remain unresolved without another level of passes.
constexpr double kRest = 0.005;

double largest(const Tensor& t) { return std::abs(t.mean) + t.deviation(); }

/// What is left of the noise after some passes, measured on noisy planes and spheres; `edge` is the
/// share that wedges at creases and boundaries have in the average, which are noisier and average
/// out along a line only.
double noise_left(int passes, double edge) {
  return std::pow(1 + 1.6 * passes, -0.85) + 0.5 * edge;
}

/// The noise of each wedge's deviator: how far it is from the mean of its ring, across the
/// direction of that mean only, so that curvature that sets in or ends (as at fillets) without
/// turning is none; averaged over some rings.
std::vector<double> deviator_noise(const std::vector<Tensor>& tensors, const WedgeLinks& links,
                                   const RunContext& context) {
  std::vector<double> squares(tensors.size());
  const std::vector<Tensor> mean = smoothed(tensors, links, 1, context);
  parallel_for(
      squares.size(), kFaceGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t w = begin; w < end; ++w) {
          const double d = mean[w].deviation();
          const double across = tensors[w].dx * mean[w].dy - tensors[w].dy * mean[w].dx;
          // The mean holds a seventh of the wedge itself.
          squares[w] = d > 0 ? across * across / (d * d) * (7.0 / 6) : 0;
        }
      },
      &context);
  squares = smoothed(std::move(squares), links, 2, context);
  std::vector<double> sorted = squares;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  if (!sorted.empty()) std::nth_element(sorted.begin(), middle, sorted.end());
  const double floor = sorted.empty() ? 0 : 0.25 * *middle;
  for (double& s : squares) s = std::sqrt(std::max(s, floor));
  return squares;
}

/// Smooths each wedge as much as its noise asks for.
class AdaptiveSmoothing {
 public:
  AdaptiveSmoothing(const ProxyMesh& proxy, const WedgeLinks& links, std::vector<Tensor> tensors,
                    const RunContext& context)
      : links_(links),
        diagonal_(proxy.mesh.bounds().diagonal()),
        context_(context),
        tensors_(std::move(tensors)),
        result_(tensors_),
        noise_(deviator_noise(tensors_, links, context)),
        settled_(tensors_.size(), 0) {
    edge_.assign(tensors_.size(), 0);
    for (std::size_t h = 0; h < proxy.edge_kind.size(); ++h) {
      if (proxy.edge_kind[h] == EdgeKind::Smooth) continue;
      edge_[wedge_of(proxy, static_cast<HalfEdge>(h))] = 1;
      edge_[wedge_of(proxy, next_in_face(static_cast<HalfEdge>(h)))] = 1;
    }
  }

  void run() {
    for (const int level : kLevels) {
      smooth_to(level);
      const auto unsettled = static_cast<double>(settle(false));
      if (unsettled <= kRest * static_cast<double>(tensors_.size())) break;
    }
    settle(true);
  }

  void run_fixed(int passes) {
    smooth_to(passes);
    settle(true);
  }

  const Tensor& tensor(std::size_t w) const { return result_[w]; }

  double confidence(std::size_t w) const {
    const Tensor& t = result_[w];
    const double d = t.deviation(), k = largest(t), noise = noise_[w];
    if (!(k > 0)) return 0;
    return smoothstep(kNoise, kSignal, noise > 0 ? d / noise : kSignal) *
           smoothstep(kUmbilic, kAnisotropic, 2 * d / k) *
           smoothstep(kFlat, kCurved, k * diagonal_);
  }

 private:
  void smooth_to(int passes) {
    tensors_ = smoothed(std::move(tensors_), links_, passes - passes_, context_);
    edge_ = smoothed(std::move(edge_), links_, passes - passes_, context_);
    passes_ = passes;
  }

  /// Keeps the tensors that the present passes resolve (or `all`); returns how many wedges remain.
  std::size_t settle(bool all) {
    std::atomic<std::size_t> rest{0};
    parallel_for(
        tensors_.size(), kFaceGrain,
        [&](std::size_t begin, std::size_t end) {
          std::size_t unsettled = 0;
          for (std::size_t w = begin; w < end; ++w) {
            if (settled_[w]) continue;
            const double noise = noise_[w] * noise_left(passes_, edge_[w]);
            const double d = tensors_[w].deviation(), k = largest(tensors_[w]);
            const bool no_matter =
                (k + 2 * noise) * diagonal_ < kFlat || 2 * (d + 2 * noise) < kUmbilic * k;
            if (!all && d < kSignal * noise && !no_matter) {
              ++unsettled;
              continue;
            }
            settled_[w] = 1;
            result_[w] = tensors_[w];
            noise_[w] = noise;
          }
          rest += unsettled;
        },
        &context_);
    return rest;
  }

  const WedgeLinks& links_;
  double diagonal_;
  const RunContext& context_;
  int passes_ = 0;
  std::vector<Tensor> tensors_, result_;
  std::vector<double> noise_, edge_;
  std::vector<std::uint8_t> settled_;
};

struct Measured {
  WedgeLinks links;
  std::vector<Tensor> tensors;
};

/// What the walks around vertices give; the OpenMesh does not outlive them.
Measured measured(const ProxyMesh& proxy, const RunContext& context) {
  const RingMesh rings(proxy.mesh, proxy.topology.opposite, context);
  const Groups<RingHandle> of_wedge = wedge_rings(rings, proxy, context);
  return {wedge_links(rings, of_wedge, proxy, context),
          wedge_tensors(rings, of_wedge, proxy, context)};
}

Curvature principal(const Tensor& t, const TangentFrame& frame, double confidence) {
  const double angle = 0.5 * std::atan2(t.dy, t.dx), d = t.deviation();
  const Vec3 d1 = std::cos(angle) * frame.u + std::sin(angle) * frame.v;
  return {t.mean + d, t.mean - d, d1, glm::cross(frame.n, d1), confidence};
}

}  // namespace

std::vector<Curvature> estimate_curvature(const ProxyMesh& proxy, const CurvatureOptions& options,
                                          const RunContext& context) {
  auto [links, tensors] = measured(proxy, context);
  AdaptiveSmoothing smoothing(proxy, links, std::move(tensors), context);
  if (options.smoothing < 0) {
    smoothing.run();
  } else {
    smoothing.run_fixed(options.smoothing);
  }
  std::vector<Curvature> result(proxy.wedge_vertex.size());
  parallel_for(
      result.size(), kFaceGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t w = begin; w < end; ++w) {
          result[w] = principal(smoothing.tensor(w), tangent_frame(proxy.wedge_normal[w]),
                                smoothing.confidence(w));
        }
      },
      &context);
  return result;
}

}  // namespace burin
