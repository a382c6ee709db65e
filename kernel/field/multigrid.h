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

/// An approximate minimiser by full multigrid on aggregates of nodes (each a node and its strongly
/// linked neighbours). Linear in the number of links; the result does not depend on the number of
/// threads.
template <class Scalar>
std::vector<Scalar> minimise(const System<Scalar>& system, const RunContext& context);

/// Sweeps of Gauss-Seidel inside fixed ranges of nodes, Jacobi between them, towards the minimiser
/// for `pull`.
template <class Scalar>
void relax(const System<Scalar>& system, const std::vector<Scalar>& pull,
           std::vector<Scalar>& values, int sweeps, const RunContext& context);

}  // namespace burin::field
