#include "wave_density.h"

#include <burin/base/parallel.h>

#include "conjugate_gradients.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace burin::detail {
namespace {

// Of what a wave may be scaled by: gaps are at most 1.43 times the style's.
const double kLeast = std::log(0.7);
// Lines end rather than become denser than this; on a face of which everybody knows how lines run,
// a line that ends shows more than many that meet at a contour.
constexpr double kDensest = 1.8, kDensestRuled = 4;
constexpr double kPenalty = 100;        // of a node out of bounds, in masses
constexpr int kDensityRounds = 4;       // of penalties
constexpr int kDensitySteps = 500;      // of conjugate gradients, in all rounds
constexpr double kDensitySmall = 5e-3;  // of the residual at which they are done
constexpr std::size_t kDensityRange = 8192;

// A square of four nodes, two cells wide: how much the waves around it miss being a gradient,
// `miss` + `by` . h, h being the logarithms of the scales at its corners.
struct Square {
  std::array<std::uint32_t, 4> at{};
  std::array<float, 4> by{};
  float miss = 0;
};

// Only every second cell of every second row takes part: h is smooth.
class Density {
 public:
  Density(const ViewRaster& raster, const WaveGraph& graph, double spacing, double length,
          double ruled, const RunContext& context)
      : raster_(raster), graph_(graph), ruled_(ruled), context_(context) {
    coarse_.assign(graph.nodes.size(), kNone);
    for (std::int32_t y = 0; y + 2 < raster.ny; y += 2) {
      for (std::int32_t x = 0; x + 2 < raster.nx; x += 2) add_square(x, y, spacing * length);
    }
    around_ = grouped(
        count_, squares_.size(), [&](std::size_t s) { return squares_[s].at; },
        [](std::size_t s) {
          const auto corner = static_cast<std::uint32_t>(4 * s);
          return std::array{corner, corner + 1, corner + 2, corner + 3};
        });
    mass_.assign(count_, 1.0);
    pull_.assign(count_, 0.0);
    h_.assign(count_, 0.0);
    missed_.resize(squares_.size());
    gradients_ = {count_, kDensitySmall, context};
  }

  // The logarithms of the scales of all nodes.
  std::vector<double> solve() {
    int left = kDensitySteps;
    for (int round = 0; round < kDensityRounds && left > 0; ++round) {
      left = descend(left);
      bool bounded = true;
      for (std::size_t i = 0; i < count_; ++i) {
        const double bound = std::clamp(h_[i], kLeast, most_[i]);
        if (h_[i] == bound && mass_[i] == 1) continue;
        if (mass_[i] == 1) bounded = false;
        mass_[i] = 1 + kPenalty;
        pull_[i] = kPenalty * bound;
      }
      if (bounded) break;
    }
    return spread();
  }

 private:
  // Whether two cells that are two apart are one sheet with the one between them.
  bool joined(const std::vector<std::int32_t>& links, std::size_t a, std::size_t b) const {
    return links[a] != kNone && links[b] != kNone;
  }

  void add_square(std::int32_t x, std::int32_t y, double weight) {
    const std::array cells{raster_.index(x, y), raster_.index(x + 2, y),
                           raster_.index(x + 2, y + 2), raster_.index(x, y + 2)};
    const std::size_t right = raster_.index(x + 1, y), up = raster_.index(x, y + 1),
                      top = raster_.index(x + 1, y + 2), side = raster_.index(x + 2, y + 1);
    if (!joined(graph_.right, cells[0], right) || !joined(graph_.right, cells[3], top) ||
        !joined(graph_.up, cells[0], up) || !joined(graph_.up, cells[1], side)) {
      return;
    }
    // Half the sum of the steps to and from each corner.
    const double p = raster_.pitch;
    const std::array<Vec2, 4> steps{Vec2(p, -p), Vec2(p, p), Vec2(-p, p), Vec2(-p, -p)};
    std::array<double, 4> round{};
    std::array<Vec2, 4> wave;
    double sum = 0;
    for (std::size_t c = 0; c < 4; ++c) {
      wave[c] = graph_.nodes[static_cast<std::size_t>(graph_.node[cells[c]])].wave;
      if (c > 0 && glm::dot(wave[c], wave[c - 1]) < 0) wave[c] = -wave[c];
      round[c] = glm::dot(wave[c], steps[c]);
      sum += round[c];
    }
    if (glm::dot(wave[3], wave[0]) < 0) return;  // a singularity of the field
    const bool ruled = std::ranges::all_of(cells, [&](std::size_t c) {
      return graph_.nodes[static_cast<std::size_t>(graph_.node[c])].ruled;
    });
    const double scale = (ruled ? ruled_ : 1) * weight / (4 * p * p);
    Square s;
    for (std::size_t c = 0; c < 4; ++c) {
      std::int32_t& number = coarse_[static_cast<std::size_t>(graph_.node[cells[c]])];
      if (number == kNone) {
        number = static_cast<std::int32_t>(count_++);
        const bool known = graph_.nodes[static_cast<std::size_t>(graph_.node[cells[c]])].ruled;
        most_.push_back(std::log(known ? kDensestRuled : kDensest));
      }
      s.at[c] = static_cast<std::uint32_t>(number);
      s.by[c] = static_cast<float>(scale * (round[c] - 0.25 * sum));
    }
    s.miss = static_cast<float>(scale * sum);
    squares_.push_back(s);
  }

  // The left side of the normal equations.
  void apply(const std::vector<double>& x, std::vector<double>& out) {
    parallel_for(
        squares_.size(), kDensityRange,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t s = begin; s < end; ++s) {
            const Square& q = squares_[s];
            double sum = 0;
            for (std::size_t c = 0; c < 4; ++c) sum += q.by[c] * x[q.at[c]];
            missed_[s] = sum;
          }
        },
        &context_);
    gather([&](std::size_t i, double sum) { out[i] = sum + mass_[i] * x[i]; });
  }

  // Calls `take(node, sum)` with what the squares around each node miss, weighed.
  template <class Take>
  void gather(const Take& take) {
    parallel_for(count_, kDensityRange, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        double sum = 0;
        for (const std::uint32_t k : around_[i]) {
          sum += squares_[k / 4].by[k % 4] * missed_[k / 4];
        }
        take(i, sum);
      }
    });
  }

  // How many steps are left.
  int descend(int steps) {
    std::vector<double> r(count_), diagonal(count_), image(count_);
    apply(h_, image);
    for (std::size_t s = 0; s < squares_.size(); ++s) missed_[s] = squares_[s].miss;
    gather([&](std::size_t i, double miss) { r[i] = pull_[i] - miss - image[i]; });
    for (std::size_t i = 0; i < count_; ++i) {
      diagonal[i] = mass_[i];
      for (const std::uint32_t k : around_[i]) {
        const double by = squares_[k / 4].by[k % 4];
        diagonal[i] += by * by;
      }
    }
    const auto matrix = [&](const std::vector<double>& x, std::vector<double>& out) {
      apply(x, out);
    };
    return gradients_.solve(matrix, diagonal, r, h_, steps);
  }

  // From every second cell to all: the mean of what is known around, ring by ring.
  std::vector<double> spread() const {
    const std::size_t n = graph_.nodes.size();
    std::vector<double> value(n, 0);
    std::vector<bool> known(n, false);
    for (std::size_t i = 0; i < n; ++i) {
      if (coarse_[i] == kNone) continue;
      const auto c = static_cast<std::size_t>(coarse_[i]);
      value[i] = std::clamp(h_[c], kLeast, most_[c]);
      known[i] = true;
    }
    constexpr int kRings = 4;
    std::vector<double> sum(n), weight(n);
    for (int ring = 0; ring < kRings; ++ring) {
      context_.check();
      std::fill(sum.begin(), sum.end(), 0.0);
      std::fill(weight.begin(), weight.end(), 0.0);
      const auto give = [&](std::uint32_t from, std::uint32_t to, double w) {
        if (!known[from] || known[to]) return;
        sum[to] += w * value[from];
        weight[to] += w;
      };
      for (const WaveLink& l : graph_.links) {
        give(l.a, l.b, l.weight);
        give(l.b, l.a, l.weight);
      }
      for (std::size_t i = 0; i < n; ++i) {
        if (weight[i] == 0) continue;
        value[i] = sum[i] / weight[i];
        known[i] = true;
      }
    }
    return value;
  }

  const ViewRaster& raster_;
  const WaveGraph& graph_;
  double ruled_;
  const RunContext& context_;
  std::vector<std::int32_t> coarse_;
  std::size_t count_ = 0;
  std::vector<Square> squares_;
  Groups<std::uint32_t> around_;  // the corners of squares at each number: 4 * square + corner
  std::vector<double> mass_, pull_, h_, missed_, most_;
  ConjugateGradients gradients_{0, kDensitySmall, context_};
};

}  // namespace

void make_integrable(const ViewRaster& raster, WaveGraph& graph, double spacing, double length,
                     double ruled, const RunContext& context) {
  const std::vector<double> h = Density(raster, graph, spacing, length, ruled, context).solve();
  for (std::size_t i = 0; i < h.size(); ++i) graph.nodes[i].wave *= std::exp(h[i]);
}

}  // namespace burin::detail
