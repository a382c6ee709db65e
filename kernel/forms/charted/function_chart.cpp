#include <burin/base/error.h>
#include <burin/forms/charted/nurbs.h>

#include "knot_spans.h"

#include <array>

namespace burin {
namespace {

/// Folds parameters into the domain.
class FoldedChart : public Chart {
 public:
  explicit FoldedChart(const FunctionChartOptions& options) : options_(options) {
    const ParameterBox& box = options.domain;
    for (int i = 0; i < 2; ++i) {
      if (!(box.max[i] > box.min[i]) || !std::isfinite(box.min[i]) || !std::isfinite(box.max[i])) {
        throw GeometryError("function chart without a domain: min must be smaller than max");
      }
    }
  }
  ParameterBox domain() const override { return options_.domain; }
  Vec2 period() const override { return options_.period; }

 protected:
  double fold(double x, int i) const {
    return fold_parameter(x, options_.domain.min[i], options_.domain.max[i], options_.period[i]);
  }
  Vec2 fold(Vec2 uv) const { return {fold(uv.x, 0), fold(uv.y, 1)}; }

  FunctionChartOptions options_;
};

class AnalyticChart final : public FoldedChart {
 public:
  AnalyticChart(std::function<SurfaceDerivatives(Vec2)> evaluate,
                const FunctionChartOptions& options)
      : FoldedChart(options), evaluate_(std::move(evaluate)) {}
  Vec3 position(Vec2 uv) const override { return evaluate_(fold(uv)).p; }
  SurfaceDerivatives derivatives(Vec2 uv) const override { return evaluate_(fold(uv)); }

 private:
  std::function<SurfaceDerivatives(Vec2)> evaluate_;
};

constexpr int kNodes = 7;

/// Weights of the first and second derivative at node `at` of the nodes 0..6, by Lagrange's
/// polynomials.
struct Weights {
  std::array<double, kNodes> first{}, second{};

  constexpr explicit Weights(int at) {
    for (int j = 0; j < kNodes; ++j) {
      // The polynomial that is 1 at j and 0 at the other nodes, as powers of (x - at).
      std::array<double, kNodes + 1> c{1};
      for (int k = 0; k < kNodes; ++k) {
        if (k == j) continue;
        const double root = k - at, scale = 1.0 / (j - k);
        for (std::size_t i = kNodes; i > 0; --i) c[i] = (c[i - 1] - root * c[i]) * scale;
        c[0] *= -root * scale;
      }
      first[static_cast<std::size_t>(j)] = c[1];
      second[static_cast<std::size_t>(j)] = 2 * c[2];
    }
  }
};
constexpr std::array<Weights, kNodes> kWeights = {Weights(0), Weights(1), Weights(2), Weights(3),
                                                  Weights(4), Weights(5), Weights(6)};

/// Derivatives by seven nodes in each direction: central ones, shifted where the domain ends.
class DifferenceChart final : public FoldedChart {
 public:
  DifferenceChart(std::function<Vec3(Vec2)> position, const FunctionChartOptions& options)
      : FoldedChart(options), position_(std::move(position)) {}

  Vec3 position(Vec2 uv) const override { return position_(fold(uv)); }

  SurfaceDerivatives derivatives(Vec2 uv) const override {
    const Vec2 at = fold(uv);
    // The sixth-order error and that of rounding meet near 1/500 of a domain that holds one turn.
    const Vec2 step = options_.domain.size() / 512.0;
    const Nodes nu = nodes(at.x, step.x, 0), nv = nodes(at.y, step.y, 1);
    SurfaceDerivatives d;
    for (std::size_t i = 0; i < kNodes; ++i) {
      const bool row = i == nu.at;
      Vec3 dv(0);
      for (std::size_t j = 0; j < kNodes; ++j) {
        const bool column = j == nv.at;
        const double wi = nu.weights->first[i], wj = nv.weights->first[j];
        if (!row && !column && (wi == 0 || wj == 0)) continue;
        const Vec3 p = position_({nu.x[i], nv.x[j]});
        dv += wj * p;
        if (row) d.vv += nv.weights->second[j] * p;
        if (column) {
          d.u += wi * p;
          d.uu += nu.weights->second[i] * p;
        }
        if (row && column) d.p = p;
      }
      if (row) d.v = dv;
      d.uv += nu.weights->first[i] * dv;
    }
    d.u /= step.x;
    d.v /= step.y;
    d.uu /= step.x * step.x;
    d.uv /= step.x * step.y;
    d.vv /= step.y * step.y;
    return d;
  }

 private:
  struct Nodes {
    std::array<double, kNodes> x;
    std::size_t at;  // the node that is the point itself
    const Weights* weights;
  };
  Nodes nodes(double x, double step, int direction) const {
    Nodes n;
    constexpr int kHalf = kNodes / 2;
    int at = kHalf;
    if (options_.period[direction] == 0) {
      const double below = (x - options_.domain.min[direction]) / step;
      const double above = (options_.domain.max[direction] - x) / step;
      if (below < at) at = static_cast<int>(below);
      if (above < kHalf) at = kNodes - 1 - static_cast<int>(above);
    }
    n.at = static_cast<std::size_t>(at);
    n.weights = &kWeights[n.at];
    for (int k = 0; k < kNodes; ++k) {
      n.x[static_cast<std::size_t>(k)] = k == at ? x : fold(x + (k - at) * step, direction);
    }
    return n;
  }

  std::function<Vec3(Vec2)> position_;
};

}  // namespace

std::shared_ptr<const Chart> make_function_chart(std::function<SurfaceDerivatives(Vec2)> evaluate,
                                                 const FunctionChartOptions& options) {
  return std::make_shared<AnalyticChart>(std::move(evaluate), options);
}

std::shared_ptr<const Chart> make_function_chart(std::function<Vec3(Vec2)> position,
                                                 const FunctionChartOptions& options) {
  return std::make_shared<DifferenceChart>(std::move(position), options);
}

}  // namespace burin
