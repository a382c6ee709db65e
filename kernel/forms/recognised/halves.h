#pragma once
// Middles of edges on the surfaces that they lie on; internal to the module.

#include "meet.h"
#include "refine.h"

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace burin::recognised {

/// A corner on a round surface.
struct KnownPlace {
  SurfaceRef of = -1;  // no round surface
  Vec3 normal{0};
  Vec2 uv{0};  // of a sheet
};

struct Middle {
  Vec3 at{0};
  KnownPlace place;
};

/// Holds references to all it is given. Corners of the mesh may be added but not moved.
class Halves {
 public:
  using Ends = std::pair<std::uint32_t, std::uint32_t>;

  Halves(const FacetMesh& mesh, const Recognised& round, const Meeting& meet)
      : mesh_(mesh), round_(round), meet_(meet) {}

  /// The middle of an edge, on all of `refs`, of which `round` is a round one; none where it cannot
  /// be put there. `within`: both sides are that one.
  std::optional<Middle> find(Ends ends, std::span<const SurfaceRef> refs, SurfaceRef round,
                             bool within) const;
  Vec3 normal_at(SurfaceRef ref, std::uint32_t vertex) const {
    return place_of(ref, vertex).normal;
  }
  /// What is known of the last corner.
  void keep_last(const KnownPlace& place);

 private:
  std::optional<Middle> on_sheet(Ends ends, SurfaceRef ref) const;
  std::optional<Middle> around(Ends ends, std::span<const SurfaceRef> refs, SurfaceRef ref) const;
  const KnownPlace& place_of(SurfaceRef ref, std::uint32_t vertex) const;

  const Patch& patch(SurfaceRef ref) const { return round_.patches[static_cast<std::size_t>(ref)]; }
  const Vec3& position(std::uint32_t vertex) const { return mesh_.mesh.positions[vertex]; }

  const FacetMesh& mesh_;
  const Recognised& round_;
  const Meeting& meet_;
  /// For each corner the surface that was asked for last.
  mutable std::vector<KnownPlace> places_;
};

}  // namespace burin::recognised
