#include "multigrid.h"

#include <burin/base/parallel.h>

namespace burin::field {
namespace {

constexpr int kCoarsestSweeps = 100;
// Sweeps after each step between levels; corrections by the coarser levels on every level, each of
// which corrects twice in turn.
constexpr int kSweeps = 2;
constexpr int kCycles = 3;
constexpr int kBranches = 2;

template <class Scalar>
class Solver {
 public:
  Solver(const Hierarchy<Scalar>& graph, std::vector<double> mass, const RunContext& context)
      : graph_(graph), context_(context), mass_{std::move(mass)} {
    for (std::size_t l = 0; l < graph.depth(); ++l) mass_.push_back(graph.summed(l, mass_[l]));
  }

  // Full multigrid: each level begins with what the next coarser one found.
  std::vector<Scalar> solve(const std::vector<Scalar>& pull) const {
    std::vector<std::vector<Scalar>> pulls{pull};
    for (std::size_t l = 0; l < graph_.depth(); ++l) pulls.push_back(graph_.gathered(l, pulls[l]));
    std::vector<Scalar> values(pulls.back().size(), Scalar{0});
    sweep(graph_.depth(), pulls.back(), values, kCoarsestSweeps);
    for (std::size_t l = graph_.depth(); l-- > 0;) {
      std::vector<Scalar> finer(pulls[l].size(), Scalar{0});
      graph_.spread(l, values, finer);
      sweep(l, pulls[l], finer, kSweeps);
      for (int cycle = 0; cycle < kCycles; ++cycle) correct(l, pulls[l], finer);
      values = std::move(finer);
    }
    return values;
  }

 private:
  void sweep(std::size_t l, const std::vector<Scalar>& pull, std::vector<Scalar>& values,
             int sweeps) const {
    relax(graph_.level(l), mass_[l], pull, values, sweeps, context_);
  }

  std::vector<Scalar> rest(std::size_t l, const std::vector<Scalar>& pull,
                           const std::vector<Scalar>& values) const {
    const Links<Scalar>& s = graph_.level(l);
    std::vector<Scalar> result(s.size());
    parallel_for(
        s.size(), kNodeRange,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i) {
            result[i] = pull[i] - (s.stiffness[i] + mass_[l][i]) * values[i];
            for (std::uint32_t k = s.first[i]; k < s.first[i + 1]; ++k) {
              result[i] += times(s.coupling[k], values[s.neighbour[k]]);
            }
          }
        },
        &context_);
    return result;
  }

  // Brings `values` nearer to the minimiser of level l by solving for what is left on level l + 1.
  void correct(std::size_t l, const std::vector<Scalar>& pull, std::vector<Scalar>& values) const {
    const std::vector<Scalar> coarse_pull = graph_.gathered(l, rest(l, pull, values));
    std::vector<Scalar> coarse(coarse_pull.size(), Scalar{0});
    if (l + 1 == graph_.depth()) {
      sweep(l + 1, coarse_pull, coarse, kCoarsestSweeps);
    } else {
      sweep(l + 1, coarse_pull, coarse, kSweeps);
      for (int i = 0; i < kBranches; ++i) correct(l + 1, coarse_pull, coarse);
    }
    graph_.spread(l, coarse, values);
    sweep(l, pull, values, kSweeps);
  }

  const Hierarchy<Scalar>& graph_;
  const RunContext& context_;
  std::vector<std::vector<double>> mass_;  // of each level
};

}  // namespace

template <class Scalar>
void relax(const Links<Scalar>& s, const std::vector<double>& mass, const std::vector<Scalar>& pull,
           std::vector<Scalar>& values, int sweeps, const RunContext& context) {
  std::vector<Scalar> before(values.size());
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    before.swap(values);
    parallel_for(
        s.size(), kNodeRange,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i) {
            Scalar sum = pull[i];
            for (std::uint32_t k = s.first[i]; k < s.first[i + 1]; ++k) {
              const std::size_t j = s.neighbour[k];
              sum += times(s.coupling[k], j >= begin && j < i ? values[j] : before[j]);
            }
            const double diagonal = s.stiffness[i] + mass[i];
            values[i] = diagonal > 0 ? sum / diagonal : Scalar{0};
          }
        },
        &context);
  }
}

template <class Scalar>
std::vector<Scalar> minimise(const Hierarchy<Scalar>& graph, std::vector<double> mass,
                             const std::vector<Scalar>& pull, const RunContext& context) {
  return Solver<Scalar>(graph, std::move(mass), context).solve(pull);
}

template void relax(const Links<Vec2>&, const std::vector<double>&, const std::vector<Vec2>&,
                    std::vector<Vec2>&, int, const RunContext&);
template void relax(const Links<double>&, const std::vector<double>&, const std::vector<double>&,
                    std::vector<double>&, int, const RunContext&);
template std::vector<Vec2> minimise(const Hierarchy<Vec2>&, std::vector<double>,
                                    const std::vector<Vec2>&, const RunContext&);
template std::vector<double> minimise(const Hierarchy<double>&, std::vector<double>,
                                      const std::vector<double>&, const RunContext&);

}  // namespace burin::field
