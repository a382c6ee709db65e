#pragma once
// The candidates of Algorithm 1 and the test that each has to pass.

#include <burin/base/rng.h>
#include <burin/forms/charted/coverage.h>

namespace burin {

/// Candidate i of a stream: random (u,v), kept with a probability that is in proportion to the
/// measure. A pure function of i.
class Candidates {
 public:
  /// Numbers of streams that do not meet: the points, and the places where they are measured.
  enum Stream : std::uint64_t { Points = 0, Checks = 1 };

  Candidates(const Chart& chart, const CoverageOptions& options);

  struct Result {
    bool kept = false;
    CoveragePoint point;
    double density = 1;
    /// |Su x Sv| of the chart, to be held against the bound; 0 where it was not needed.
    double area = 0;
  };
  Result draw(std::uint64_t i, double bound, Stream stream) const;
  /// The number that decides about density.
  double coin(std::uint64_t i) const { return rng_.uniform(kDraws * i + 3); }
  /// The mean of the measure over the domain, from random places: estimates sizes only.
  double mean_measure() const;
  double domain_area() const { return box_.size().x * box_.size().y; }

 private:
  static constexpr std::uint64_t kDraws = 4;

  double measure(const SurfaceDerivatives& d) const;
  double picture_bound() const;

  const Chart& chart_;
  const CoverageOptions& options_;
  ParameterBox box_;
  Rng rng_;
  bool even_;                  // all areas grow alike where it is placed
  double scale2_;              // area in place over area of the chart, at the most
  double picture_scale2_ = 1;  // a bound of area on paper over area in space
};

}  // namespace burin
