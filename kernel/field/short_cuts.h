#pragma once
/// Cuts between two names of families, as short as they can be.

#include <burin/base/run_context.h>
#include <burin/mesh/proxy_mesh.h>

#include "links.h"
#include "wedge_graph.h"

#include <vector>

namespace burin::field {

/// Where the labels of a smooth region change along a cut more than twice as long as needed, other
/// labels: cuts then join odd singularities and borders of the region in pairs, the nearest first;
/// along a border they take no length. They have to be worth it: `pull` is what is wanted of each
/// node's label. `sign`: labels, 1 or -1; nodes behind the wedges keep theirs. Cost: for each odd
/// singularity a search as far as what it is joined to. What is done is decided by order of length,
/// then of number: the same for any number of threads.
void shorten_cuts(const ProxyMesh& proxy, const WedgeGraph& graph, const Links<double>& links,
                  const std::vector<double>& pull, std::vector<double>& sign,
                  const RunContext& context);

}  // namespace burin::field
