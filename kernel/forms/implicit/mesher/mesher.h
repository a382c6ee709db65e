#pragma once
// From a function to its triangles.

#include <burin/base/box.h>
#include <burin/base/diagnostics.h>
#include <burin/base/run_context.h>
#include <burin/forms/implicit/implicit_function.h>

#include "exact_mesh.h"

#include <memory>
#include <string>

namespace burin {

/// A component that lies between the samples of a look.
struct Component {
  Box3 box;
  Vec3 point{0};    // of its surface
  double step = 0;  // of the grid that has found it, in model mm
};

/// Components that may have been missed: those smaller or thinner than `below` model mm, 0 = none.
struct Unseen {
  double below = 0;
  std::string why;
  /// A note where that is so of all functions of a kind.
  Severity severity = Severity::Warning;
};

/// What a first look over the domain tells.
struct Survey {
  /// The function to be drawn: clipped where it reaches the domain.
  std::shared_ptr<const ImplicitFunction> function;
  /// A coarse mesh with its creases, and what of it lies between the samples.
  ExactMesh mesh;
  std::vector<Component> pieces;
  /// Of the surface itself, with what is left out.
  Box3 box;
  double area = 0;
  /// Radius of curvature in model mm that all but a fiftieth of the surface exceeds.
  double small_radius = 0;
  /// Components with a smaller diagonal, in model mm, are left out.
  double smallest = 0;
  Unseen unseen;
  Diagnostics diagnostics;
};

/// Looks for the surface at a 128th of the domain, and between the samples where the function tells
/// its slopes. Components smaller than `smallest` of the largest one are left out. Throws
/// GeometryError where there is none.
Survey survey(const std::shared_ptr<const ImplicitFunction>& function, const Box3& domain,
              bool given, double smallest, const RunContext& context);

/// What came of the meshing.
struct MeshCounts {
  std::size_t strays = 0;  // vertices that could not be brought to the surface
  std::size_t specks = 0;  // components left out
};

/// Triangles of edge length about `step`, creases cut. The mesh has what is left of the budget.
/// Throws TooMuchWork where that does not do.
ExactMesh mesh_surface(const Survey& survey, double step, WorkBudget budget, MeshCounts& counts,
                       const RunContext& context);

/// The step for chords within `tolerance` model mm, bounded by the size of the surface and by the
/// number of triangles, and what of that is worth a word to the user.
double choose_step(const Survey& survey, double tolerance, std::size_t max_triangles,
                   Diagnostics& diagnostics);

}  // namespace burin
