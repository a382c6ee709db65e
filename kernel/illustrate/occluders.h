#pragma once
// What hides what when some parts can be looked through; internal to the module.

#include <burin/base/run_context.h>
#include <burin/surface/surface.h>
#include <burin/visibility/occluder.h>

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace burin::detail {

/// One a part.
using Surfaces = std::vector<std::shared_ptr<const Surface>>;

/// Model mm^2 of the triangles of each, 0 of one alone. Cost: a pass over them.
std::vector<double> sizes_of(const Surfaces& surfaces);

/// The tree of rays of the solid parts, and what it takes for those of the transparent ones.
class Occluders {
 public:
  /// `transparent`: one a part. `ranks`: `PartStyles::meeting_ranks`.
  Occluders(Surfaces surfaces, std::vector<bool> transparent, std::vector<double> ranks,
            const RunContext& context);

  const Surfaces& surfaces() const { return surfaces_; }
  std::size_t size() const { return proxies_.size(); }
  std::span<const ProxyMesh* const> proxies() const { return proxies_; }
  bool transparent(std::size_t part) const { return transparent_[part]; }
  const std::vector<bool>& transparent() const { return transparent_; }
  bool any_transparent() const;

  /// The parts that hide others; the proxies of others are empty.
  const Occluder& solid() const { return solid_; }
  std::span<const ProxyMesh* const> solid_proxies() const { return solid_proxies_; }
  /// What stands before a transparent part: the solid ones and itself.
  std::vector<const ProxyMesh*> proxies_before(std::size_t part) const;
  /// The solid parts and those of a flag.
  std::vector<const ProxyMesh*> proxies_with(const std::vector<bool>& parts) const;
  /// Of any tree of rays of these parts, so that all agree which of those that lie on each other is
  /// seen.
  OccluderOptions tree_options() const { return {.ranks = ranks_}; }
  const std::vector<double>& ranks() const { return ranks_; }

 private:
  Surfaces surfaces_;
  std::vector<bool> transparent_;
  std::vector<double> ranks_;
  std::vector<const ProxyMesh*> proxies_, solid_proxies_;
  Occluder solid_;
};

}  // namespace burin::detail
