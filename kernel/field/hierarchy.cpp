#include "hierarchy.h"

#include <burin/base/parallel.h>

#include <algorithm>

namespace burin::field {
namespace {

// Nodes of the coarsest level, about; and the share of nodes of the next level from which on
// coarsening is not worth its work.
constexpr std::size_t kCoarsest = 48;
constexpr double kPoor = 0.8;

}  // namespace

template <class Scalar>
Hierarchy<Scalar>::Hierarchy(const Links<Scalar>& links, const RunContext& context)
    : finest_(&links) {
  while (level(depth()).size() > kCoarsest) {
    const Links<Scalar>& last = level(depth());
    Groups<Scalar> next = aggregate(last);
    if (next.count == 0 || next.count > kPoor * static_cast<double>(last.size())) break;
    coarse_.push_back(coarsen(last, next, context));
    groups_.push_back(std::move(next));
  }
}

template <class Scalar>
std::vector<Scalar> Hierarchy<Scalar>::gathered(std::size_t l,
                                                const std::vector<Scalar>& fine) const {
  const Groups<Scalar>& groups = groups_[l];
  std::vector<Scalar> coarse(groups.count, Scalar{0});
  for (std::size_t i = 0; i < fine.size(); ++i) {
    const std::uint32_t a = groups.parent[i];
    if (a != kNoGroup) coarse[a] += times(conjugate(groups.phase[i]), fine[i]);
  }
  return coarse;
}

template <class Scalar>
std::vector<double> Hierarchy<Scalar>::summed(std::size_t l,
                                              const std::vector<double>& fine) const {
  const Groups<Scalar>& groups = groups_[l];
  std::vector<double> coarse(groups.count, 0);
  for (std::size_t i = 0; i < fine.size(); ++i) {
    if (groups.parent[i] != kNoGroup) coarse[groups.parent[i]] += fine[i];
  }
  return coarse;
}

template <class Scalar>
void Hierarchy<Scalar>::spread(std::size_t l, const std::vector<Scalar>& coarse,
                               std::vector<Scalar>& fine) const {
  const Groups<Scalar>& groups = groups_[l];
  parallel_for(fine.size(), kNodeRange, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t a = groups.parent[i];
      if (a != kNoGroup) fine[i] += times(groups.phase[i], coarse[a]);
    }
  });
}

template <class Scalar>
std::vector<double> Hierarchy<Scalar>::agreement(const std::vector<Scalar>& values,
                                                 const std::vector<double>& measure,
                                                 const std::vector<double>& limit) const {
  std::vector<std::vector<Scalar>> sum{values};
  std::vector<std::vector<double>> total{std::vector<double>(values.size())}, size{measure},
      allowed{limit};
  std::transform(values.begin(), values.end(), total[0].begin(),
                 [](Scalar v) { return size_of(v); });
  for (std::size_t l = 0; l < depth(); ++l) {
    sum.push_back(gathered(l, sum[l]));
    total.push_back(summed(l, total[l]));
    size.push_back(summed(l, size[l]));
    // All nodes of a group have the limit of their region.
    allowed.emplace_back(groups_[l].count, 0);
    for (std::size_t i = 0; i < allowed[l].size(); ++i) {
      if (groups_[l].parent[i] != kNoGroup) allowed[l + 1][groups_[l].parent[i]] = allowed[l][i];
    }
  }
  // From the top down: a node takes its group's answer where the group is small enough to give one.
  std::vector<double> answer, finer;
  for (std::size_t l = depth() + 1; l-- > 0;) {
    finer.assign(sum[l].size(), 1);
    for (std::size_t i = 0; i < finer.size(); ++i) {
      const std::uint32_t a = l < depth() ? groups_[l].parent[i] : kNoGroup;
      const bool inherits = a != kNoGroup && size[l + 1][a] <= allowed[l + 1][a];
      if (inherits) {
        finer[i] = answer[a];
      } else if (total[l][i] > 0) {
        finer[i] = std::min(1.0, size_of(sum[l][i]) / total[l][i]);
      }
    }
    answer.swap(finer);
  }
  return answer;
}

template class Hierarchy<Vec2>;
template class Hierarchy<double>;

}  // namespace burin::field
