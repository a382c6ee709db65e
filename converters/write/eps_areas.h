#pragma once
// Areas of flat colour in PostScript, which knows no opacity; internal to the module.

#include <burin/drawing/drawing.h>
#include <burin/drawing/text.h>

#include <cstddef>
#include <string>
#include <vector>

namespace burin {

/// The areas of a drawing that are painted, in order. What one that can be looked through lies over
/// is painted again within it, in the mixed colours. What lies beneath is found at a place every
/// 0.25 mm. Through more than three such areas on each other the paper is seen.
class EpsAreas {
 public:
  /// The drawing must outlive it.
  explicit EpsAreas(const Drawing& drawing);

  std::size_t size() const { return areas_.size(); }
  /// Over the paper.
  std::string color(std::size_t area) const { return color(area, {}); }
  /// The area, where that colour is set.
  void append(Buffer& out, std::size_t area) const { append(out, area, {}); }

 private:
  /// `through`: areas that lie over it, the nearest first.
  void append(Buffer& out, std::size_t area, const std::vector<std::size_t>& through) const;
  void find_beneath();
  std::string color(std::size_t area, const std::vector<std::size_t>& through) const;

  const Drawing& drawing_;
  std::vector<const Area*> areas_;
  /// For each area that can be looked through those that it lies over, in order.
  std::vector<std::vector<std::size_t>> beneath_;
};

}  // namespace burin
