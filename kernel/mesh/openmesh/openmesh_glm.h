#pragma once
/// Lets OpenMesh store GLM vectors. The order of the includes matters to OpenMesh.

#include <OpenMesh/Core/Utils/vector_traits.hh>
#include <glm/glm.hpp>

#include <fstream>  // OpenMesh 9 uses it without including it

namespace OpenMesh {
template <glm::length_t L, class T, glm::qualifier Q>
struct vector_traits<glm::vec<L, T, Q>> {
  // NOLINTBEGIN(readability-identifier-naming): OpenMesh's names
  using vector_type = glm::vec<L, T, Q>;
  using value_type = T;
  static const size_t size_ = L;
  static size_t size() { return L; }
  // NOLINTEND(readability-identifier-naming)
};
}  // namespace OpenMesh

namespace glm {  // found by argument-dependent look-up
template <length_t L, class T, qualifier Q>
T norm(const vec<L, T, Q>& v) {
  return length(v);
}
template <length_t L, class T, qualifier Q>
T sqrnorm(const vec<L, T, Q>& v) {
  return dot(v, v);
}
template <length_t L, class T, qualifier Q, class S>
vec<L, T, Q>& vectorize(vec<L, T, Q>& v, S s) {
  v = vec<L, T, Q>(T(s));
  return v;
}
}  // namespace glm

#include <OpenMesh/Core/IO/MeshIO.hh>  // before the kernel header
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

namespace burin {

struct OpenMeshTraits : OpenMesh::DefaultTraits {
  using Point = glm::dvec3;
  using Normal = glm::dvec3;
};
using OpenMeshTriMesh = OpenMesh::TriMesh_ArrayKernelT<OpenMeshTraits>;

}  // namespace burin
