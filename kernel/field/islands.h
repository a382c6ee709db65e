#pragma once
/// Labels without needless borders.

#include "links.h"

#include <vector>

namespace burin::field {

/// Flips the signs of whole islands (nodes connected by links that agree) so that neighbouring
/// islands agree, along the longest borders first; of the two choices for all islands that are
/// connected, the one nearer to `pull` is taken. What borders remain end at odd singularities or go
/// around a handle.
void join_islands(const Links<double>& links, const std::vector<double>& pull,
                  std::vector<double>& sign);

}  // namespace burin::field
