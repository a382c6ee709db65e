#pragma once
/// How far the triangles of a proxy lie from what they stand for.

#include <burin/mesh/proxy_mesh.h>

#include <cstdint>

namespace burin {

/// Model mm between a triangle and the surface that it stands for, from the normals at its
/// corners; 0 where the mesh has none.
double chord_error(const ProxyMesh& proxy, std::uint32_t face);

}  // namespace burin
