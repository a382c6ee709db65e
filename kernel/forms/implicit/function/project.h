#pragma once
// Points moved onto f = 0, onto the curve f = g = 0, and to the point f = g = h = 0.

#include <burin/forms/implicit/implicit_function.h>

#include <array>
#include <optional>
#include <span>

namespace burin {

/// Cosine of 2 degrees: pieces whose normals differ by less meet smoothly, and have no crease.
constexpr double kSmooth = 0.99939;

/// Newton along the gradient from `p`, at most `reach` away. Ends at |f| / |gradient| below
/// `accuracy` (model mm). `gradient`, where asked for, is that of the last evaluation.
std::optional<Vec3> onto_surface(const ImplicitFunction& f, Vec3 p, double reach, double accuracy,
                                 Gradient1* last = nullptr);

/// The same for two or three functions at once: the shortest step that solves all of them.
std::optional<Vec3> onto_all(std::span<const ImplicitFunction* const> functions, Vec3 p,
                             double reach, double accuracy);

/// Whether a gradient tells a direction.
inline bool usable(Vec3 g) {
  const double l = glm::dot(g, g);
  return l > 0 && l < 1e300;
}

}  // namespace burin
