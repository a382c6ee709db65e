#include <burin/base/near_turn.h>

#include <cmath>

namespace burin {

std::optional<Placement> near_turn(const Placement& place) {
  constexpr double kDigits = 3e-6;  // of numbers up to 1
  const double scale = place.scale();
  if (!(scale > 0) || off_rotation(place.linear / scale) > kDigits) return std::nullopt;
  // By Newton's method for the polar decomposition.
  Mat3 turn = place.linear / scale;
  for (int i = 0; i < 4; ++i) turn = 0.5 * (turn + glm::transpose(glm::inverse(turn)));
  return Placement{std::abs(scale - 1) <= kDigits ? turn : scale * turn, place.offset};
}

}  // namespace burin
