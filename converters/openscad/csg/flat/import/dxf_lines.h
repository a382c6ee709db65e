#pragma once
// From the lines of a DXF file to outlines; for converters/openscad alone.

#include <burin/base/vec.h>

#include "solid.h"

#include <array>
#include <cstdint>
#include <functional>
#include <queue>
#include <unordered_map>
#include <vector>

namespace burin::csg {

/// Lines whose ends meet within a thousandth of a millimetre, as OpenSCAD joins them.
class DxfLines {
 public:
  /// `arc`: the number of the arc that the line stands for, -1 for none.
  void add(Vec2 a, Vec2 b, std::int32_t arc = -1);
  /// Chains of lines, each line once; first those that begin at a loose end. What is open is
  /// closed.
  std::vector<Outline> outlines();

 private:
  struct Place {
    std::int64_t x, y;
    bool operator==(const Place&) const = default;
  };
  struct PlaceHash {
    std::size_t operator()(const Place& p) const;
  };
  /// The number of the place of `p`, which becomes that place's middle.
  std::uint32_t place(Vec2 p);
  bool loose(std::uint32_t line, int end) const;
  /// The first line at a place that is in no chain, or -1.
  std::int64_t next_at(std::uint32_t place);
  void follow(std::uint32_t line, int end, bool closed, std::vector<Outline>& out);

  std::unordered_map<Place, std::uint32_t, PlaceHash> numbers_;
  std::vector<Vec2> points_;
  /// Lines at each place, in the order of the file.
  std::vector<std::vector<std::uint32_t>> at_;
  /// Those before are in a chain.
  std::vector<std::uint32_t> begin_;
  /// How many of them are not yet in a chain.
  std::vector<std::uint32_t> left_at_;
  std::vector<std::array<std::uint32_t, 2>> lines_;
  std::vector<std::int32_t> arc_;
  std::vector<bool> used_;
  /// Some chain began at a loose end.
  bool open_ = false;
  /// Lines that may have a loose end, the first of the file on top.
  std::priority_queue<std::uint32_t, std::vector<std::uint32_t>, std::greater<>> candidates_;
};

}  // namespace burin::csg
