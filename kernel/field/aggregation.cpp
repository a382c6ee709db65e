#include "aggregation.h"

#include <burin/base/parallel.h>

#include <algorithm>

namespace burin::field {

// The members of every group, in order.
struct GroupMembers {
  std::vector<std::uint32_t> first, node;
};

// One range of rows of the coarse graph, joined with the others afterwards.
template <class Scalar>
struct CoarseRows {
  std::vector<std::uint32_t> degree, neighbour;
  std::vector<Scalar> coupling;
};

namespace {

// A link belongs to a group only if it is at least this share of its node's strongest one.
constexpr double kStrong = 0.25;
// Values constant over a group exaggerate the energy of a smooth field by the group's diameter in
// nodes; the coarse weights are scaled back by it. @cite Braess1995
constexpr double kOvercorrection = 0.45;

template <class Scalar>
double strongest_link(const Links<Scalar>& s, std::uint32_t i) {
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
void found_group(const Links<Scalar>& s, std::uint32_t i, double threshold,
                 Groups<Scalar>& groups) {
  groups.parent[i] = groups.count;
  groups.phase[i] = unit_of(Scalar{});
  for (std::uint32_t k = s.first[i]; k < s.first[i + 1]; ++k) {
    const std::uint32_t j = s.neighbour[k];
    if (groups.parent[j] != kNoGroup || size_of(s.coupling[k]) < threshold) continue;
    groups.parent[j] = groups.count;
    groups.phase[j] = conjugate(carry(s.coupling[k]));
  }
  ++groups.count;
}

template <class Scalar>
bool all_free(const Links<Scalar>& s, std::uint32_t i, double threshold,
              const Groups<Scalar>& groups) {
  for (std::uint32_t k = s.first[i]; k < s.first[i + 1]; ++k) {
    if (size_of(s.coupling[k]) >= threshold && groups.parent[s.neighbour[k]] != kNoGroup) {
      return false;
    }
  }
  return true;
}

// Joins node i to the group of its most strongly linked neighbour that has one of the first
// `founded` groups.
template <class Scalar>
bool join_group(const Links<Scalar>& s, std::uint32_t i, std::vector<std::uint32_t>& joined,
                Groups<Scalar>& groups) {
  std::uint32_t best = kNoGroup;
  for (std::uint32_t k = s.first[i]; k < s.first[i + 1]; ++k) {
    if (groups.parent[s.neighbour[k]] == kNoGroup) continue;
    if (best == kNoGroup || size_of(s.coupling[k]) > size_of(s.coupling[best])) best = k;
  }
  if (best == kNoGroup || !(size_of(s.coupling[best]) > 0)) return false;
  const std::uint32_t j = s.neighbour[best];
  joined[i] = groups.parent[j];
  groups.phase[i] = times(carry(s.coupling[best]), groups.phase[j]);
  return true;
}

template <class Scalar>
GroupMembers members_of(const Groups<Scalar>& groups) {
  GroupMembers m;
  m.first.assign(groups.count + 1, 0);
  for (const std::uint32_t a : groups.parent) {
    if (a != kNoGroup) ++m.first[a + 1];
  }
  for (std::uint32_t a = 0; a < groups.count; ++a) m.first[a + 1] += m.first[a];
  m.node.resize(m.first[groups.count]);
  std::vector<std::uint32_t> next(m.first.begin(), m.first.end() - 1);
  for (std::uint32_t i = 0; i < groups.parent.size(); ++i) {
    if (groups.parent[i] != kNoGroup) m.node[next[groups.parent[i]]++] = i;
  }
  return m;
}

}  // namespace

template <class Scalar>
Groups<Scalar> aggregate(const Links<Scalar>& s) {
  const auto n = static_cast<std::uint32_t>(s.size());
  Groups<Scalar> groups;
  groups.parent.assign(n, kNoGroup);
  groups.phase.assign(n, unit_of(Scalar{}));
  std::vector<double> threshold(n);
  parallel_for(n, kNodeRange, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      threshold[i] = kStrong * strongest_link(s, static_cast<std::uint32_t>(i));
    }
  });
  for (std::uint32_t i = 0; i < n; ++i) {
    if (threshold[i] > 0 && groups.parent[i] == kNoGroup && all_free(s, i, threshold[i], groups)) {
      found_group(s, i, threshold[i], groups);
    }
  }
  std::vector<std::uint32_t> joined(n, kNoGroup);
  for (std::uint32_t i = 0; i < n; ++i) {
    if (groups.parent[i] == kNoGroup) join_group(s, i, joined, groups);
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    if (joined[i] != kNoGroup) groups.parent[i] = joined[i];
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    if (threshold[i] > 0 && groups.parent[i] == kNoGroup) found_group(s, i, threshold[i], groups);
  }
  return groups;
}

template <class Scalar>
Links<Scalar> coarsen(const Links<Scalar>& s, const Groups<Scalar>& groups,
                      const RunContext& context) {
  const GroupMembers members = members_of(groups);
  Links<Scalar> c;
  c.stiffness.assign(groups.count, 0);
  std::vector<CoarseRows<Scalar>> ranges((groups.count + kNodeRange - 1) / kNodeRange);
  const auto build = [&](std::size_t begin, std::size_t end) {
    CoarseRows<Scalar>& rows = ranges[begin / kNodeRange];
    for (auto a = static_cast<std::uint32_t>(begin); a < end; ++a) {
      const std::size_t row = rows.neighbour.size();
      for (std::uint32_t m = members.first[a]; m < members.first[a + 1]; ++m) {
        const std::uint32_t i = members.node[m];
        const Scalar back = conjugate(groups.phase[i]);
        c.stiffness[a] += kOvercorrection * s.stiffness[i];
        for (std::uint32_t k = s.first[i]; k < s.first[i + 1]; ++k) {
          const std::uint32_t j = s.neighbour[k], b = groups.parent[j];
          if (b == kNoGroup) continue;
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
  parallel_for(groups.count, kNodeRange, build, &context);
  c.first.reserve(groups.count + 1);
  for (const CoarseRows<Scalar>& rows : ranges) {
    for (const std::uint32_t d : rows.degree) c.first.push_back(c.first.back() + d);
    c.neighbour.insert(c.neighbour.end(), rows.neighbour.begin(), rows.neighbour.end());
    c.coupling.insert(c.coupling.end(), rows.coupling.begin(), rows.coupling.end());
  }
  return c;
}

template Groups<Vec2> aggregate(const Links<Vec2>&);
template Groups<double> aggregate(const Links<double>&);
template Links<Vec2> coarsen(const Links<Vec2>&, const Groups<Vec2>&, const RunContext&);
template Links<double> coarsen(const Links<double>&, const Groups<double>&, const RunContext&);

}  // namespace burin::field
