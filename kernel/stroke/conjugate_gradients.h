#pragma once
// Sparse symmetric systems of the cells of a picture; the same bits for any number of threads.

#include <burin/base/parallel.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace burin::detail {

/// Conjugate gradients with the diagonal as preconditioner. `apply(x, image)` is the matrix,
/// positive semidefinite; `residual` the right side less the image of `x`, which is improved.
class ConjugateGradients {
 public:
  /// Done where the energy of the residual is `small` squared of the first one.
  ConjugateGradients(std::size_t count, double small, const RunContext& context)
      : count_(count), small_(small), context_(&context) {}

  /// How many of so many steps are left.
  template <class Apply>
  int solve(const Apply& apply, const std::vector<double>& diagonal, std::vector<double>& residual,
            std::vector<double>& x, int steps) {
    std::vector<double> z(count_), image(count_);
    const auto scaled = [&](std::size_t i) {
      return diagonal[i] > 0 ? residual[i] / diagonal[i] : 0.0;
    };
    for (std::size_t i = 0; i < count_; ++i) z[i] = scaled(i);
    std::vector<double> way = z;
    double energy = sum([&](std::size_t i) { return residual[i] * z[i]; });
    if (first_energy_ == 0) first_energy_ = energy;
    while (steps > 0 && energy > small_ * small_ * first_energy_) {
      context_->check();
      --steps;
      apply(way, image);
      const double curvature = sum([&](std::size_t i) { return way[i] * image[i]; });
      if (!(curvature > 0)) break;
      const double by = energy / curvature;
      parallel_for(count_, kRange, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          x[i] += by * way[i];
          residual[i] -= by * image[i];
          z[i] = scaled(i);
        }
      });
      const double before = energy;
      energy = sum([&](std::size_t i) { return residual[i] * z[i]; });
      const double kept = energy / before;
      parallel_for(count_, kRange, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) way[i] = z[i] + kept * way[i];
      });
    }
    return steps;
  }

 private:
  static constexpr std::size_t kRange = 8192;

  // A sum of the nodes' terms, in fixed ranges.
  template <class Term>
  double sum(const Term& term) {
    partial_.assign((count_ + kRange - 1) / kRange, 0.0);
    parallel_for(count_, kRange, [&](std::size_t begin, std::size_t end) {
      double s = 0;
      for (std::size_t i = begin; i < end; ++i) s += term(i);
      partial_[begin / kRange] = s;
    });
    double all = 0;
    for (const double s : partial_) all += s;
    return all;
  }

  std::size_t count_;
  double small_;
  const RunContext* context_;
  double first_energy_ = 0;
  std::vector<double> partial_;
};

}  // namespace burin::detail
