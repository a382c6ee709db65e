#pragma once
/// The `d` attribute of SVG paths.

#include <burin/drawing/bezier.h>
#include <burin/drawing/text.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace burin {

/// The most elements that readers make of a chain: one for where it begins and for closing it, one
/// a line, three a curve.
std::size_t path_elements(std::span<const CubicBezier> curves, bool close);

/// Writes path data in relative commands on a grid of 0.001 mm. Steps are differences of rounded
/// places, so that no error adds up. Flips y: paper's origin is bottom left, SVG's top left.
class SvgPen {
 public:
  SvgPen(Buffer& out, double paper_height) : out_(out), height_(paper_height) {}

  /// A chain of curves as one subpath; straight ones become lines.
  void chain(std::span<const CubicBezier> curves, bool close);
  /// A line of no length, which a round line cap makes a dot.
  void dot(Vec2 p);
  /// "x,y x,y ..." in absolute coordinates, for polylines.
  void points(std::span<const Vec2> points);

 private:
  struct Place {
    std::int64_t x = 0, y = 0;
  };
  Place place(Vec2 p) const;
  void number(std::int64_t thousandths);
  void command(char c);
  void step(Place from, Place to);
  void line(Place to);

  Buffer& out_;
  double height_;
  Place at_;
  char last_ = 0;
  bool glued_ = true;
};

}  // namespace burin
