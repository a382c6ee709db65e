#pragma once
// How each kind of change is drawn, and the legend that says so; internal to the module.

#include <burin/drawing/drawing.h>
#include <burin/revisions/overlay.h>

#include <cstddef>
#include <string>
#include <vector>

namespace burin::detail {

/// How lines of one kind of change are drawn.
struct ChangeLook {
  const char* group;
  /// "#rrggbb"; empty: the drawing's ink; kLight: halfway to its paper.
  const char* color;
  std::vector<double> dashes;
  /// Of the widths that lines have, which are no less than `least` paper mm then; strokes keep
  /// theirs.
  double factor = 1, least = 0;
};
inline constexpr const char* kLight = "light";

/// By `ChangeLook::group`; throws std::out_of_range.
const ChangeLook& look_of(const std::string& group);

/// Layers of one drawing under way, in the order in which they come.
class Layers {
 public:
  Layers(const Drawing& drawing, std::vector<Layer>& layers);

  /// To the layer "GROUP-NAME" with its looks; dashes of hidden lines and trails stay.
  void add(const std::string& group, const std::string& name, Path path);
  /// The layer of that very name and the looks of a group.
  Layer& named(const std::string& name, const ChangeLook& look);

 private:
  std::string color_of(const ChangeLook& look) const;

  std::string ink_, light_;
  std::vector<Layer>& layers_;
};

/// An entry of the legend: lines in the looks of these groups, and words.
struct LegendEntry {
  std::vector<std::string> groups;
  std::string text;
};

/// Lays it above the lower left corner of what the margin leaves; returns where its letters end
/// above, paper mm.
double lay_legend(Drawing& drawing, const std::vector<LegendEntry>& entries,
                  const OverlayOptions& options);

/// Puts the layers in the order of painting: light ones first.
void sort_layers(std::vector<Layer>& layers);

}  // namespace burin::detail
