#include <burin/work_mesh/division.h>

#include <bit>

namespace burin {

namespace {

using Corner = std::uint8_t;

constexpr Corner next(Corner k) { return static_cast<Corner>((k + 1) % 3); }
constexpr Corner on(Corner side) { return static_cast<Corner>(side + 3); }

}  // namespace

Division divide(std::uint8_t marks, const std::array<Vec3, 6>& points) {
  const auto marked = [&](Corner side) { return (marks >> side & 1U) != 0; };
  if (marks == 0) return {{{{0, 1, 2}}}, 1};
  if (marks == 7) return {{{{0, 3, 5}, {1, 4, 3}, {2, 5, 4}, {3, 4, 5}}}, 4};
  if (std::popcount(marks) == 1) {
    const auto a = static_cast<Corner>(std::countr_zero(marks));
    const Corner b = next(a), c = next(b);
    return {{{{a, on(a), c}, {on(a), b, c}}}, 2};
  }
  // From the whole side c-a on: a, the point on a-b, the tip b, the point on b-c, c.
  Corner a = 0;
  while (!marked(a) || !marked(next(a))) ++a;
  const Corner b = next(a), c = next(b), left = on(a), right = on(b);
  const double from_a = glm::distance(points[a], points[right]);
  const double from_c = glm::distance(points[c], points[left]);
  if (from_a <= from_c) return {{{{b, right, left}, {a, left, right}, {a, right, c}}}, 3};
  return {{{{b, right, left}, {a, left, c}, {left, right, c}}}, 3};
}

int side_of(std::uint8_t p, std::uint8_t q) {
  for (Corner k = 0; k < 3; ++k) {
    const auto lies = [&](Corner i) { return i == k || i == next(k) || i == on(k); };
    if (lies(p) && lies(q)) return k;
  }
  return -1;
}

}  // namespace burin
