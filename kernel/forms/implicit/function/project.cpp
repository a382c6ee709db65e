#include "project.h"

#include <cmath>

namespace burin {
namespace {

constexpr int kMaxSteps = 20;

// The shortest d with rows . d = -values; false where the rows depend on one another.
bool solve(std::span<const Gradient1> g, Vec3& d) {
  // Sine of the angle between normals below which they are one.
  constexpr double kParallel = 1e-7;
  if (g.size() == 2) {
    const Vec3 a = g[0].gradient, b = g[1].gradient;
    const double aa = glm::dot(a, a), bb = glm::dot(b, b), ab = glm::dot(a, b);
    const double det = aa * bb - ab * ab;
    if (!(det > kParallel * kParallel * aa * bb)) return false;
    const double s = (-g[0].value * bb + g[1].value * ab) / det;
    const double t = (-g[1].value * aa + g[0].value * ab) / det;
    d = s * a + t * b;
    return true;
  }
  const Vec3 a = g[0].gradient, b = g[1].gradient, c = g[2].gradient;
  const Vec3 bc = glm::cross(b, c), ca = glm::cross(c, a), ab = glm::cross(a, b);
  const double det = glm::dot(a, bc);
  if (!(std::abs(det) > kParallel * glm::length(a) * glm::length(b) * glm::length(c))) return false;
  d = -(g[0].value * bc + g[1].value * ca + g[2].value * ab) / det;
  return true;
}

}  // namespace

std::optional<Vec3> onto_surface(const ImplicitFunction& f, Vec3 p, double reach, double accuracy,
                                 Gradient1* last) {
  const Vec3 start = p;
  for (int i = 0; i < kMaxSteps; ++i) {
    const Gradient1 g = f.gradient(p);
    if (last) *last = g;
    if (!usable(g.gradient) || !std::isfinite(g.value)) return std::nullopt;
    const Vec3 d = -g.value / glm::dot(g.gradient, g.gradient) * g.gradient;
    p += d;
    if (!(glm::distance(p, start) <= reach)) return std::nullopt;
    // The step just made squares what is left.
    if (glm::length(d) <= accuracy) return p;
  }
  return std::nullopt;
}

std::optional<Vec3> onto_all(std::span<const ImplicitFunction* const> functions, Vec3 p,
                             double reach, double accuracy) {
  const Vec3 start = p;
  std::array<Gradient1, 3> g;
  for (int i = 0; i < kMaxSteps; ++i) {
    for (std::size_t k = 0; k < functions.size(); ++k) {
      g[k] = functions[k]->gradient(p);
      if (!usable(g[k].gradient) || !std::isfinite(g[k].value)) return std::nullopt;
    }
    Vec3 d;
    if (!solve(std::span(g).first(functions.size()), d)) return std::nullopt;
    p += d;
    if (!(glm::distance(p, start) <= reach)) return std::nullopt;
    if (glm::length(d) <= accuracy) return p;
  }
  return std::nullopt;
}

}  // namespace burin
