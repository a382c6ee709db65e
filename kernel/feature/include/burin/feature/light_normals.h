#pragma once
/// Normals of a mesh for flat tones and lines of equal light, without the noise of its triangles.

#include <burin/base/run_context.h>
#include <burin/base/vec.h>
#include <burin/camera/camera.h>
#include <burin/feature/isophotes.h>
#include <burin/mesh/proxy_mesh.h>

#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// The unit normals by which flat tones are told on a mesh, one a wedge; empty where they are the
/// proxy's. Where the mesh bends evenly they are those, bit for bit. Where its normals change from
/// triangle to triangle at random they are averages within the smooth region, over some eight
/// widths of `pen` (paper mm) or two edges, whichever is more: a border of tone follows the shape
/// then, not the triangles. Long triangles count as even: a tessellator chose them. The averages
/// are a step of heat by the cotangents of the triangles. Throws Cancelled. Cost: 0.1 s per million
/// triangles, and 20 passes over the uneven ones. @cite Meyer2003
std::vector<Vec3> light_normals(const ProxyMesh& proxy, const Camera& camera, double pen,
                                const RunContext& context);

/// Normals of `light_normals` without the islands of tone that are noise: each is turned until it
/// has the step of what is around it. Of places that hang together on one side of a level within a
/// smooth region, none of them at its edge, those go that are smaller than the disc over which
/// noise is averaged, and those that differ by less than a fifth of a step from the level and are
/// smaller than a square of 30 pens. Where no normal is an average all stay. Cost: a pass over the
/// triangles a level, 0.1 s per million of them.
std::vector<Vec3> without_islands(const ProxyMesh& proxy, std::vector<Vec3> normals,
                                  const Isophotes& isophotes, const Camera& camera, double pen);

/// Both: what flat tones and lines of equal light on a mesh are found by.
std::vector<Vec3> tone_normals(const ProxyMesh& proxy, const Isophotes& isophotes,
                               const Camera& camera, double pen, const RunContext& context);

/// The unit normal between those of its wedges, at a place of a triangle; `normals` may be empty.
Vec3 light_normal(const ProxyMesh& proxy, std::span<const Vec3> normals, std::uint32_t face,
                  Vec3 bary);

}  // namespace burin
