#include "multigrid.h"

#include <burin/base/parallel.h>

#include <algorithm>
#include <deque>

namespace burin::field {
namespace {

// Nodes a range: small enough to share out, large enough that Gauss-Seidel is hardly disturbed.
constexpr std::size_t kRange = 4096;
// A link belongs to a group only if it is at least this share of its node's strongest one.
constexpr double kStrong = 0.25;
// Values constant over a group exaggerate the energy of a smooth field by the group's diameter in
// nodes; the coarse stiffness is scaled back by it.
constexpr double kOvercorrection = 0.45;
constexpr std::uint32_t kCoarsest = 48;
constexpr int kCoarsestSweeps = 100;
// Sweeps after each step between levels; corrections by the coarser levels on every level, each of
// which corrects twice in turn.
constexpr int kSweeps = 2;
constexpr int kCycles = 3;
constexpr int kBranches = 2;

constexpr std::uint32_t kNoNode = 0xffffffffu;

// Groups of neighbouring nodes: value i is `phase[i]` times the value of its group `parent[i]`.
// Nodes without links have no group (kNoNode).
template <class Scalar>
struct Aggregates {
  std::vector<std::uint32_t> parent;
  std::vector<Scalar> phase;
  std::uint32_t count = 0;
};

template <class Scalar>
double strongest_link(const System<Scalar>& s, std::uint32_t i) {
  double best = 0;
  for (std::uint32_t k = s.first[i]; k < s.first[i + 1]; ++k) {
    best = std::max(best, size_of(s.coupling[k]));
  }
  return best;
}

// The factor that carries a value over a link.
template <class Scalar>
Scalar carry(Scalar coupling) {
  return coupling / size_of(coupling);
}

// Node i and its free, strongly linked neighbours become a group.
template <class Scalar>
void found_group(const System<Scalar>& s, std::uint32_t i, double threshold,
                 Aggregates<Scalar>& groups) {
  groups.parent[i] = groups.count;
  groups.phase[i] = unit_of(Scalar{});
  for (std::uint32_t k = s.first[i]; k < s.first[i + 1]; ++k) {
    const std::uint32_t j = s.neighbour[k];
    if (groups.parent[j] != kNoNode || size_of(s.coupling[k]) < threshold) continue;
    groups.parent[j] = groups.count;
    groups.phase[j] = conjugate(carry(s.coupling[k]));
  }
  ++groups.count;
}

template <class Scalar>
bool all_free(const System<Scalar>& s, std::uint32_t i, double threshold,
              const Aggregates<Scalar>& groups) {
  for (std::uint32_t k = s.first[i]; k < s.first[i + 1]; ++k) {
    if (size_of(s.coupling[k]) >= threshold && groups.parent[s.neighbour[k]] != kNoNode) {
      return false;
    }
  }
  return true;
}

// Joins node i to the group of its most strongly linked neighbour that has one of the first
// `founded` groups.
template <class Scalar>
bool join_group(const System<Scalar>& s, std::uint32_t i, std::vector<std::uint32_t>& joined,
                Aggregates<Scalar>& groups) {
  std::uint32_t best = kNoNode;
  for (std::uint32_t k = s.first[i]; k < s.first[i + 1]; ++k) {
    if (groups.parent[s.neighbour[k]] == kNoNode) continue;
    if (best == kNoNode || size_of(s.coupling[k]) > size_of(s.coupling[best])) best = k;
  }
  if (best == kNoNode || !(size_of(s.coupling[best]) > 0)) return false;
  const std::uint32_t j = s.neighbour[best];
  joined[i] = groups.parent[j];
  groups.phase[i] = times(carry(s.coupling[best]), groups.phase[j]);
  return true;
}

// The members of every group, in order.
struct Members {
  std::vector<std::uint32_t> first, node;
};

template <class Scalar>
Members members_of(const Aggregates<Scalar>& groups) {
  Members m;
  m.first.assign(groups.count + 1, 0);
  for (const std::uint32_t a : groups.parent) {
    if (a != kNoNode) ++m.first[a + 1];
  }
  for (std::uint32_t a = 0; a < groups.count; ++a) m.first[a + 1] += m.first[a];
  m.node.resize(m.first[groups.count]);
  std::vector<std::uint32_t> next(m.first.begin(), m.first.end() - 1);
  for (std::uint32_t i = 0; i < groups.parent.size(); ++i) {
    if (groups.parent[i] != kNoNode) m.node[next[groups.parent[i]]++] = i;
  }
  return m;
}

// The system and its ever coarser versions; level 0 is the finest.
template <class Scalar>
class Hierarchy {
 public:
  Hierarchy(const System<Scalar>& system, const RunContext& context);
  std::vector<Scalar> solve() const;

 private:
  std::size_t depth() const { return coarse_.size(); }
  const System<Scalar>& level(std::size_t l) const { return l == 0 ? *finest_ : coarse_[l - 1]; }
  // Adds the values of level l + 1 to those of level l.
  void hand_down(std::size_t l, const std::vector<Scalar>& coarse, std::vector<Scalar>& fine) const;
  // Brings `values` nearer to the minimiser of level l by solving for what is left on level l + 1.
  void correct(std::size_t l, const std::vector<Scalar>& pull, std::vector<Scalar>& values) const;

  const System<Scalar>* finest_;
  const RunContext& context_;
  std::deque<System<Scalar>> coarse_;
  std::vector<Aggregates<Scalar>> groups_;
};

// One range of rows of the coarse system, joined with the others afterwards.
template <class Scalar>
struct Rows {
  std::vector<std::uint32_t> degree, neighbour;
  std::vector<Scalar> coupling;
};

// Every group is a node and its strongly linked neighbours, about six nodes on a mesh.
template <class Scalar>
Aggregates<Scalar> aggregate(const System<Scalar>& s) {
  const auto n = static_cast<std::uint32_t>(s.size());
  Aggregates<Scalar> groups;
  groups.parent.assign(n, kNoNode);
  groups.phase.assign(n, unit_of(Scalar{}));
  std::vector<double> threshold(n);
  parallel_for(n, kRange, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      threshold[i] = kStrong * strongest_link(s, static_cast<std::uint32_t>(i));
    }
  });
  for (std::uint32_t i = 0; i < n; ++i) {
    if (threshold[i] > 0 && groups.parent[i] == kNoNode && all_free(s, i, threshold[i], groups)) {
      found_group(s, i, threshold[i], groups);
    }
  }
  std::vector<std::uint32_t> joined(n, kNoNode);
  for (std::uint32_t i = 0; i < n; ++i) {
    if (groups.parent[i] == kNoNode) join_group(s, i, joined, groups);
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    if (joined[i] != kNoNode) groups.parent[i] = joined[i];
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    if (threshold[i] > 0 && groups.parent[i] == kNoNode) found_group(s, i, threshold[i], groups);
  }
  return groups;
}

// The system of the groups.
template <class Scalar>
System<Scalar> coarsen(const System<Scalar>& s, const Aggregates<Scalar>& groups,
                       const RunContext& context) {
  const Members members = members_of(groups);
  System<Scalar> c;
  c.stiffness.assign(groups.count, 0);
  c.mass.assign(groups.count, 0);
  c.pull.assign(groups.count, Scalar{0});
  std::vector<Rows<Scalar>> ranges((groups.count + kRange - 1) / kRange);
  const auto build = [&](std::size_t begin, std::size_t end) {
    Rows<Scalar>& rows = ranges[begin / kRange];
    for (auto a = static_cast<std::uint32_t>(begin); a < end; ++a) {
      const std::size_t row = rows.neighbour.size();
      for (std::uint32_t m = members.first[a]; m < members.first[a + 1]; ++m) {
        const std::uint32_t i = members.node[m];
        const Scalar back = conjugate(groups.phase[i]);
        c.mass[a] += s.mass[i];
        c.pull[a] += times(back, s.pull[i]);
        c.stiffness[a] += kOvercorrection * s.stiffness[i];
        for (std::uint32_t k = s.first[i]; k < s.first[i + 1]; ++k) {
          const std::uint32_t j = s.neighbour[k], b = groups.parent[j];
          if (b == kNoNode) continue;
          const Scalar coupling =
              kOvercorrection * times(times(back, s.coupling[k]), groups.phase[j]);
          if (b == a) {
            c.stiffness[a] -= real_of(coupling);
            continue;
          }
          const auto begin_row = rows.neighbour.begin() + static_cast<std::ptrdiff_t>(row);
          const auto it = std::find(begin_row, rows.neighbour.end(), b);
          if (it != rows.neighbour.end()) {
            rows.coupling[static_cast<std::size_t>(it - rows.neighbour.begin())] += coupling;
          } else {
            rows.neighbour.push_back(b);
            rows.coupling.push_back(coupling);
          }
        }
      }
      rows.degree.push_back(static_cast<std::uint32_t>(rows.neighbour.size() - row));
    }
  };
  parallel_for(groups.count, kRange, build, &context);
  c.first.reserve(groups.count + 1);
  for (const Rows<Scalar>& rows : ranges) {
    for (const std::uint32_t d : rows.degree) c.first.push_back(c.first.back() + d);
    c.neighbour.insert(c.neighbour.end(), rows.neighbour.begin(), rows.neighbour.end());
    c.coupling.insert(c.coupling.end(), rows.coupling.begin(), rows.coupling.end());
  }
  return c;
}

}  // namespace

template <class Scalar>
void relax(const System<Scalar>& s, const std::vector<Scalar>& pull, std::vector<Scalar>& values,
           int sweeps, const RunContext& context) {
  std::vector<Scalar> before(values.size());
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    before.swap(values);
    parallel_for(
        s.size(), kRange,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i) {
            Scalar sum = pull[i];
            for (std::uint32_t k = s.first[i]; k < s.first[i + 1]; ++k) {
              const std::size_t j = s.neighbour[k];
              sum += times(s.coupling[k], j >= begin && j < i ? values[j] : before[j]);
            }
            const double diagonal = s.stiffness[i] + s.mass[i];
            values[i] = diagonal > 0 ? sum / diagonal : Scalar{0};
          }
        },
        &context);
  }
}

template <class Scalar>
std::vector<Scalar> Hierarchy<Scalar>::solve() const {
  // Full multigrid: each level begins with what the next coarser one found.
  std::vector<Scalar> values(level(depth()).size(), Scalar{0});
  relax(level(depth()), level(depth()).pull, values, kCoarsestSweeps, context_);
  for (std::size_t l = depth(); l-- > 0;) {
    std::vector<Scalar> finer(level(l).size(), Scalar{0});
    hand_down(l, values, finer);
    relax(level(l), level(l).pull, finer, kSweeps, context_);
    for (int cycle = 0; cycle < kCycles; ++cycle) correct(l, level(l).pull, finer);
    values = std::move(finer);
  }
  return values;
}

template <class Scalar>
Hierarchy<Scalar>::Hierarchy(const System<Scalar>& system, const RunContext& context)
    : finest_(&system), context_(context) {
  while (level(depth()).size() > kCoarsest) {
    const System<Scalar>& last = level(depth());
    Aggregates<Scalar> next = aggregate(last);
    // A level that shrinks by less than a fifth is not worth its sweeps.
    if (next.count == 0 || next.count > 0.8 * static_cast<double>(last.size())) break;
    coarse_.push_back(coarsen(last, next, context));
    groups_.push_back(std::move(next));
  }
}

template <class Scalar>
void Hierarchy<Scalar>::hand_down(std::size_t l, const std::vector<Scalar>& coarse,
                                  std::vector<Scalar>& fine) const {
  const Aggregates<Scalar>& groups = groups_[l];
  parallel_for(fine.size(), kRange, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t a = groups.parent[i];
      if (a != kNoNode) fine[i] += times(groups.phase[i], coarse[a]);
    }
  });
}

template <class Scalar>
void Hierarchy<Scalar>::correct(std::size_t l, const std::vector<Scalar>& pull,
                                std::vector<Scalar>& values) const {
  const System<Scalar>& s = level(l);
  std::vector<Scalar> rest(s.size());
  parallel_for(
      s.size(), kRange,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          rest[i] = pull[i] - (s.stiffness[i] + s.mass[i]) * values[i];
          for (std::uint32_t k = s.first[i]; k < s.first[i + 1]; ++k) {
            rest[i] += times(s.coupling[k], values[s.neighbour[k]]);
          }
        }
      },
      &context_);
  const Aggregates<Scalar>& groups = groups_[l];
  std::vector<Scalar> coarse_pull(groups.count, Scalar{0}), coarse(groups.count, Scalar{0});
  for (std::size_t i = 0; i < s.size(); ++i) {
    const std::uint32_t a = groups.parent[i];
    if (a != kNoNode) coarse_pull[a] += times(conjugate(groups.phase[i]), rest[i]);
  }
  if (l + 1 == depth()) {
    relax(level(l + 1), coarse_pull, coarse, kCoarsestSweeps, context_);
  } else {
    relax(level(l + 1), coarse_pull, coarse, kSweeps, context_);
    for (int i = 0; i < kBranches; ++i) correct(l + 1, coarse_pull, coarse);
  }
  hand_down(l, coarse, values);
  relax(s, pull, values, kSweeps, context_);
}

template <class Scalar>
std::vector<Scalar> minimise(const System<Scalar>& system, const RunContext& context) {
  return Hierarchy<Scalar>(system, context).solve();
}

template void relax(const System<Vec2>&, const std::vector<Vec2>&, std::vector<Vec2>&, int,
                    const RunContext&);
template std::vector<Vec2> minimise(const System<Vec2>&, const RunContext&);
template std::vector<double> minimise(const System<double>&, const RunContext&);

}  // namespace burin::field
