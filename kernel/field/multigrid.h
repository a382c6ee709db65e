#pragma once
/// Fields on a graph by a hierarchy of aggregates: the linear system behind crosses and family
/// labels.

#include <burin/base/run_context.h>
#include <burin/surface/tangent_basis.h>

#include <cstdint>
#include <vector>

namespace burin::field {

/// A value at a node is a complex number (a cross, as its direction to the fourth power) or a real
/// one (a label).
inline Vec2 times(Vec2 a, Vec2 b) { return complex_mul(a, b); }
inline Vec2 conjugate(Vec2 a) { return complex_conj(a); }
inline double size_of(Vec2 a) { return glm::length(a); }
inline double real_of(Vec2 a) { return a.x; }
inline Vec2 unit_of(Vec2) { return {1, 0}; }
inline double times(double a, double b) { return a * b; }
inline double conjugate(double a) { return a; }
inline double size_of(double a) { return std::abs(a); }
inline double real_of(double a) { return a; }
inline double unit_of(double) { return 1; }

inline constexpr std::uint32_t kNoNode = 0xffffffffu;

/// The energy  sum over links w |z_i - r z_j|^2 + sum over nodes mass |z_i|^2 - 2 Re(conj(z_i)
/// pull). Row i has the links first[i] .. first[i+1]; `coupling` is w r, where r carries a value
/// from the neighbour to i.
template <class Scalar>
struct System {
  std::vector<std::uint32_t> first{0};
  std::vector<std::uint32_t> neighbour;
  std::vector<Scalar> coupling;
  std::vector<double> stiffness;  // sum of the w of a row
  std::vector<double> mass;
  std::vector<Scalar> pull;

  std::size_t size() const { return stiffness.size(); }
};

/// Groups of neighbouring nodes: value i is `phase[i]` times the value of its group `parent[i]`.
/// Nodes without links have no group (kNoNode).
template <class Scalar>
struct Aggregates {
  std::vector<std::uint32_t> parent;
  std::vector<Scalar> phase;
  std::uint32_t count = 0;
};

/// Every group is a node and its strongly linked neighbours, about six nodes on a mesh.
template <class Scalar>
Aggregates<Scalar> aggregate(const System<Scalar>& system);

/// The system of the groups.
template <class Scalar>
System<Scalar> coarsen(const System<Scalar>& system, const Aggregates<Scalar>& groups,
                       const RunContext& context);

/// Sweeps of Gauss-Seidel inside fixed ranges of nodes (Jacobi between them): the result does not
/// depend on the number of threads.
template <class Scalar>
void relax(const System<Scalar>& system, std::vector<Scalar>& values, int sweeps,
           const RunContext& context);

/// An approximate minimiser: solved on the coarsest groups, then handed down and relaxed level by
/// level. Linear in the number of links.
template <class Scalar>
std::vector<Scalar> minimise(const System<Scalar>& system, const RunContext& context);

}  // namespace burin::field
