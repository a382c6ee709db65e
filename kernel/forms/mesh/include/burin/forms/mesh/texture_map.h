#pragma once
/// Texture coordinates of a mesh file, found again by place.

#include <burin/base/placement.h>
#include <burin/mesh/tri_mesh.h>
#include <burin/surface/surface.h>

#include <glm/vec2.hpp>

#include <memory>
#include <optional>
#include <vector>

namespace burin {

/// u and v over the triangles that a file gave. Repair joins, turns and drops triangles, rounding
/// divides them, sections cut them: so u and v are asked for by place, and those of the nearest
/// triangle of the file are taken. Immutable; safe from many threads.
class TextureMap {
 public:
  /// `corners`: u and v of the three corners of each triangle, in turn; not a number where the file
  /// gives none. Triangles without area and such whose positions are no finite numbers are left
  /// out.
  TextureMap(TriMesh mesh, std::vector<glm::vec2> corners);
  ~TextureMap();
  TextureMap(const TextureMap&) = delete;
  TextureMap& operator=(const TextureMap&) = delete;

  /// The same over the triangles where `by` takes them.
  std::shared_ptr<const TextureMap> mapped(const Placement& by) const;

  /// u and v at a place (model mm), beyond 0 and 1 where the texture repeats; none where the
  /// nearest triangle has none. Cost: O(log n); the first call builds a tree, 0.5 s a million
  /// triangles.
  std::optional<Vec2> at(Vec3 position) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// `surface` with u and v of `texture` in place of its own; the surface itself where there is no
/// texture.
std::shared_ptr<const Surface> textured(std::shared_ptr<const Surface> surface,
                                        std::shared_ptr<const TextureMap> texture);

}  // namespace burin
