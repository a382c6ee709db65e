#pragma once
/// From a graph to a coarser one: groups of strongly linked nodes.

#include <burin/base/run_context.h>

#include "links.h"

namespace burin::field {

inline constexpr std::uint32_t kNoGroup = 0xffffffffu;
/// Nodes a range of a parallel loop: small enough to share out, large enough that Gauss-Seidel
/// inside ranges is hardly disturbed by the others.
inline constexpr std::size_t kNodeRange = 4096;

/// Value i is `phase[i]` times the value of its group `parent[i]`; nodes without links have
/// kNoGroup.
template <class Scalar>
struct Groups {
  std::vector<std::uint32_t> parent;
  std::vector<Scalar> phase;
  std::uint32_t count = 0;
};

/// Every group is a node and its strongly linked neighbours: about six nodes on a mesh.
template <class Scalar>
Groups<Scalar> aggregate(const Links<Scalar>& links);

/// The graph of the groups: the energy of `links` for values that are constant (but for their
/// phases) in each group, scaled to that of smooth values.
template <class Scalar>
Links<Scalar> coarsen(const Links<Scalar>& links, const Groups<Scalar>& groups,
                      const RunContext& context);

}  // namespace burin::field
