// How a march passes the lines of a face at which its parametrisation breaks.

#include <burin/forms/charted/continuity.h>

#include "march.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace burin::detail {
namespace {

constexpr int kLineIterations = 60;

// The share of a step at which a coordinate that begins at or below 0 and ends above it passes 0;
// 0 where it never was below.
template <class Function>
double passes_zero(const Function& f) {
  double low = 0, high = 1;
  for (double x = 0.5; f(low) >= 0; x *= 0.5) {  // it begins on the line
    if (x < 1e-6) return 0;
    if (f(x) < 0) low = x;
  }
  for (int i = 0; i < kLineIterations && high - low > 1e-15; ++i) {
    const double x = 0.5 * (low + high);
    (f(x) > 0 ? high : low) = x;
  }
  return high;
}

}  // namespace

bool March::start(Vec2 uv, Vec3 tangent) {
  if (!path().start(uv, tangent, state_)) return false;
  const std::int32_t face = triangles_.face(triangle_);
  if (lines_.none(face)) return true;
  cell_ = lines_.cell(face, uv, state_.velocity);
  inner_ = {cell_.min + lines_.noise(face), cell_.max - lines_.noise(face)};
  return path().start(uv, tangent, state_);
}

// The cell that the path is in, or goes into: there the same direction has other components.
std::optional<MarchStop> March::enter_cell() {
  const std::int32_t face = triangles_.face(triangle_);
  if (lines_.none(face)) return std::nullopt;
  const ParameterBox cell = lines_.cell(face, state_.uv, state_.velocity);
  if (cell.min == cell_.min && cell.max == cell_.max) return std::nullopt;
  const Vec3 before = path().normal(state_), direction = state_.direction();
  cell_ = cell;
  inner_ = {cell.min + lines_.noise(face), cell.max - lines_.noise(face)};
  if (!path().start(Vec2(state_.uv), direction, state_)) return MarchStop::Singular;
  const Vec3 after = path().normal(state_);
  const bool known = before != Vec3(0) && after != Vec3(0);
  const double limit = std::cos(kSharpAngle * std::numbers::pi / 180);
  if (known && glm::dot(before, after) < limit) return MarchStop::Crease;
  return std::nullopt;
}

// A step that leaves the cell ends on its side instead.
void March::stop_at_line(PathState& to, double& length) const {
  double share = 1;
  int direction = -1;
  double line = 0;
  const Vec2 noise = lines_.noise(triangles_.face(triangle_));
  for (int i = 0; i < 2; ++i) {
    const bool up = to.uv[i] > cell_.max[i] + noise[i];
    if (!up && !(to.uv[i] < cell_.min[i] - noise[i])) continue;
    const double side = up ? cell_.max[i] : cell_.min[i];
    const double x = passes_zero([&](double t) {
      const double beyond = between(state_, to, length, t * length)[i] - side;
      return up ? beyond : -beyond;
    });
    if (direction >= 0 && x >= share) continue;
    share = x;
    direction = i;
    line = side;
  }
  // Beside a line, and out of it at once: what rounding makes of a march along it.
  if (direction < 0 || !(share > 0)) return;
  PathState at;
  PathError error;
  double x = share * length;
  for (int i = 0; i <= kMaxRefinements; ++i) {
    if (!path().step(state_, x, at, error)) return;
    const double gap = line - at.uv[direction];
    if (std::abs(gap) <= noise[direction] || i == kMaxRefinements) break;
    const double next = x + gap / at.velocity[direction];
    if (!(next > 0 && next <= length)) break;
    x = next;
  }
  at.uv[direction] = line;
  to = at;
  length = x;
}

}  // namespace burin::detail
