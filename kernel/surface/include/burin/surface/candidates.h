#pragma once
/// What every coverage by rejection shares: candidates are tried in order until enough are kept.

#include <burin/base/parallel.h>
#include <burin/base/vec.h>
#include <burin/surface/surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace burin {

/// Candidates a point at the most, so that a weight that is zero everywhere ends.
inline constexpr std::size_t kMaxCandidates = 200;

/// A point uniform in a triangle, from two uniform numbers: the square root undoes the narrowing
/// towards one corner. @cite Osada2002
inline Vec3 uniform_bary(double a, double b) {
  const double r = std::sqrt(a);
  return {1 - r, r * (1 - b), r * b};
}

/// Draws one of many by its weight, in constant time: a table tells where to begin to look.
class WeightedDraw {
 public:
  /// The weights are not negative.
  explicit WeightedDraw(std::vector<double> weights) : sums_(std::move(weights)) {
    double total = 0;
    for (double& s : sums_) s = total += s;
    begin_.reserve(sums_.size());
    const double step = total / static_cast<double>(std::max<std::size_t>(sums_.size(), 1));
    std::uint32_t at = 0;
    for (std::size_t i = 0; i < sums_.size(); ++i) {
      while (at + 1 < sums_.size() && sums_[at] <= static_cast<double>(i) * step) ++at;
      begin_.push_back(at);
    }
  }

  double total() const { return sums_.empty() ? 0 : sums_.back(); }

  /// The one that a uniform number in [0,1) falls on; `total` is greater than 0.
  std::uint32_t operator()(double uniform) const {
    const double at = uniform * sums_.back();
    const auto n = static_cast<double>(sums_.size());
    auto i = begin_[std::min(static_cast<std::size_t>(uniform * n), sums_.size() - 1)];
    while (i > 0 && sums_[i - 1] > at) --i;  // the table's own rounding
    while (i + 1 < sums_.size() && sums_[i] <= at) ++i;
    return i;
  }

 private:
  std::vector<double> sums_;
  std::vector<std::uint32_t> begin_;
};

/// The triangles of a mesh that may hold points of a coverage, by `weight(triangle)`, which is
/// asked for no others.
template <class Weight>
WeightedDraw weigh_triangles(const TriMesh& mesh, const CoverRequest& request,
                             const Weight& weight) {
  std::vector<double> weights(mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const bool counts =
        !request.among || request.among(mesh.positions[a], mesh.positions[b], mesh.positions[c]);
    weights[t] = counts ? weight(t) : 0;
  }
  return WeightedDraw(std::move(weights));
}

/// The first `count` of the candidates 0, 1, ... that are kept; fewer where `limit` candidates hold
/// no more. `candidate(i)` gives an optional and is a pure function of i, called from many threads:
/// blocks are tried on all cores, those kept are taken in order, and no result depends on the
/// blocks.
template <class T, class Candidate>
std::vector<T> keep_candidates(std::size_t count, std::size_t limit, const RunContext& context,
                               const Candidate& candidate) {
  constexpr std::size_t kGrain = 1024;
  constexpr std::size_t kMostAtOnce = std::size_t{1} << 16;
  std::vector<T> points;
  points.reserve(std::min(count, limit));
  std::vector<std::optional<T>> kept;
  std::size_t block = std::max(kGrain, count);
  for (std::size_t first = 0; first < limit && points.size() < count; first += kept.size()) {
    kept.assign(std::min({limit - first, block, kMostAtOnce}), std::nullopt);
    parallel_for(
        kept.size(), kGrain,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t k = begin; k < end; ++k) kept[k] = candidate(first + k);
        },
        &context);
    for (std::size_t k = 0; k < kept.size() && points.size() < count; ++k) {
      if (kept[k]) points.push_back(*kept[k]);
    }
    // As many as should do, by the share kept so far.
    const std::size_t tried = first + kept.size(), missing = count - points.size();
    block = std::max(kGrain, missing + missing * tried / std::max<std::size_t>(points.size(), 1));
  }
  return points;
}

}  // namespace burin
