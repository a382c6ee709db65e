#pragma once
/// Averages of tensors over neighbouring wedges.

#include "ring_mesh.h"
#include "tensor.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace burin {

/// A neighbour of a wedge in its smooth region, and the turn (cosine and sine of twice the angle)
/// that carries deviators from the neighbour's frame to the wedge's.
struct WedgeLink {
  std::uint32_t to;
  Vec2 turn;
};

/// The neighbours of wedge w are links[offsets[w]] .. links[offsets[w + 1] - 1].
struct WedgeLinks {
  std::vector<std::uint32_t> offsets;
  std::unique_ptr<WedgeLink[]> links;
};

WedgeLinks wedge_links(const RingMesh& rings, const Groups<RingHandle>& of_wedge,
                       const ProxyMesh& proxy, const RunContext& context);

/// The mean of each wedge and its neighbours, `passes` times.
std::vector<Tensor> smoothed(std::vector<Tensor> tensors, const WedgeLinks& links, int passes,
                             const RunContext& context);

/// The same for plain numbers.
std::vector<double> smoothed(std::vector<double> values, const WedgeLinks& links, int passes,
                             const RunContext& context);

}  // namespace burin
