#pragma once
/// A graph and its ever coarser versions.

#include "aggregation.h"

#include <deque>

namespace burin::field {

/// Level 0 is the finest. Built in linear time; the same for any number of threads.
template <class Scalar>
class Hierarchy {
 public:
  /// `links` must outlive the hierarchy.
  Hierarchy(const Links<Scalar>& links, const RunContext& context);

  /// The coarsest level.
  std::size_t depth() const { return coarse_.size(); }
  const Links<Scalar>& level(std::size_t l) const { return l == 0 ? *finest_ : coarse_[l - 1]; }

  /// For each group of level l + 1 the sum of its nodes' values, carried together.
  std::vector<Scalar> gathered(std::size_t l, const std::vector<Scalar>& fine) const;
  /// The same for sizes, which need no carrying (for real values: without signs).
  std::vector<double> summed(std::size_t l, const std::vector<double>& fine) const;
  /// Adds the values of level l + 1 to those of its nodes.
  void spread(std::size_t l, const std::vector<Scalar>& coarse, std::vector<Scalar>& fine) const;

  /// For each node how well the values around it agree, in [0,1]: the size of their sum over the
  /// sum of their sizes, in the largest group around the node whose `measure` is no more than the
  /// node's `limit`; 1 where there is no such group.
  std::vector<double> agreement(const std::vector<Scalar>& values,
                                const std::vector<double>& measure,
                                const std::vector<double>& limit) const;

 private:
  const Links<Scalar>* finest_;
  std::deque<Links<Scalar>> coarse_;
  std::vector<Groups<Scalar>> groups_;
};

}  // namespace burin::field
