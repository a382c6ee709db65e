#pragma once
/// Which patches lie side by side.

#include <burin/base/disjoint_sets.h>
#include <burin/forms/charted/chart.h>

#include <memory>
#include <vector>

namespace burin::irit {

/// How far apart, as a share of the size of a part, sides may lie that are one edge: text files
/// print six digits.
inline constexpr double kWeld = 2e-6;

using Patches = std::vector<std::shared_ptr<const Chart>>;

/// Joins the sets of lists that have a side of the same ends and the same middle. Cost: linear.
void join_sides(const std::vector<Patches>& lists, DisjointSets& sets);

}  // namespace burin::irit
