#pragma once
/// The linear system behind crosses and labels.

#include "hierarchy.h"

namespace burin::field {

/// An approximate minimiser, by full multigrid, of
///   sum over links of w |z_i - r z_j|^2 + sum over nodes of mass_i |z_i|^2 - 2 Re(conj(z_i)
///   pull_i).
/// Linear in the number of links; the same for any number of threads.
template <class Scalar>
std::vector<Scalar> minimise(const Hierarchy<Scalar>& graph, std::vector<double> mass,
                             const std::vector<Scalar>& pull, const RunContext& context);

/// Sweeps of Gauss-Seidel inside fixed ranges of nodes, Jacobi between them, towards the minimiser.
template <class Scalar>
void relax(const Links<Scalar>& links, const std::vector<double>& mass,
           const std::vector<Scalar>& pull, std::vector<Scalar>& values, int sweeps,
           const RunContext& context);

}  // namespace burin::field
