#pragma once
// From where what is new is seen; internal to the module.

#include <burin/base/run_context.h>
#include <burin/book/build_steps.h>
#include <burin/camera/camera.h>
#include <burin/mesh/proxy_mesh.h>

#include <cstddef>
#include <span>
#include <vector>

namespace burin::detail {

/// A direction to the viewer, and parts that hide what is new from there all the same.
struct Look {
  Vec3 direction{0};
  Vec3 up{0};
  std::vector<std::size_t> ghosts;
};

/// The asked direction, or the one of eight from which the least seen of the moves is seen best.
/// `moved`: where each part is, relative to its place.
Look best_look(std::span<const ProxyMesh* const> proxies, const BuildStep& step,
               const std::vector<Vec3>& moved, const ViewOptions& asked, const RunContext& context);

}  // namespace burin::detail
