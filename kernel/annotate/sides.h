#pragma once
// The sides of a rectangle about a drawing, and how numbers are shared between them; internal to
// the module.

#include <burin/annotate/place.h>

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace burin::detail {

/// A side of the rectangle: a line along x (rows) or y (columns).
struct Side {
  bool row = false;
  /// The other coordinate, and from where to where middles may stand.
  double across = 0, low = 0, high = 0;
  /// Anchors by place along the side.
  std::vector<std::size_t> labels;
  std::vector<double> along;

  Vec2 at(std::size_t i) const { return row ? Vec2(along[i], across) : Vec2(across, along[i]); }
  std::size_t room(double pitch) const {
    return high < low ? 0 : static_cast<std::size_t>((high - low) / pitch + 1e-9) + 1;
  }
};

enum Edge : std::size_t { Left, Right, Bottom, Top };
using Sides = std::array<Side, 4>;

/// `corners`: rows go beyond the columns, which end below them.
Sides sides_of(const Box2& drawing, const Box2& frame, const CalloutSizes& sizes, bool corners);

/// How many numbers each side gets.
struct Share {
  bool corners = false;
  std::array<std::size_t, 4> counts{};
};

/// A share with room for all, over the drawing at need; nothing where there is none.
std::optional<Share> any_share(std::size_t n, const Box2& drawing, const Box2& frame,
                               const CalloutSizes& sizes, CalloutOptions::Layout layout);

/// The share that leaves the drawing clear; nothing where there is none.
std::optional<Share> share_of(std::size_t n, const Box2& drawing, const Box2& frame,
                              const CalloutSizes& sizes, CalloutOptions::Layout layout);

/// Where all numbers stand on two opposite sides, those go to each whose anchors are nearer to it,
/// as far as both have room.
void lean(std::span<const Vec2> anchors, const Box2& drawing, double pitch, const Sides& sides,
          Share& share);

/// Deals the anchors to the sides: those farthest up, down, left, then the rest; each side by
/// place.
void deal(std::span<const Vec2> anchors, const Share& share, double pitch, Sides& sides);

/// All places as one list: who stands where.
struct Place {
  std::size_t side, index;
};

std::vector<Place> all_places(const Sides& sides);
/// Of `count` numbers, in the order of their anchors.
std::vector<Vec2> places_of(std::size_t count, const Sides& sides);

}  // namespace burin::detail
