#include "build_steps.h"
#include "flood.h"

namespace burin {

void find_components(Topology& topology) {
  const std::int32_t components = flood(
      topology.opposite, [](HalfEdge) { return true; }, topology.face_component);
  topology.component_closed.assign(static_cast<std::size_t>(components), 1);
  for (std::size_t h = 0; h < topology.opposite.size(); ++h) {
    if (topology.opposite[h] != kNoHalfEdge) continue;
    topology.component_closed[static_cast<std::size_t>(topology.face_component[h / 3])] = 0;
  }
}

void find_regions(ProxyMesh& proxy) {
  const auto smooth = [&](HalfEdge h) {
    return proxy.edge_kind[static_cast<std::size_t>(h)] == EdgeKind::Smooth;
  };
  proxy.region_count = flood(proxy.topology.opposite, smooth, proxy.face_region);
}

}  // namespace burin
