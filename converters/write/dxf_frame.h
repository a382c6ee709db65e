#pragma once
/// What stands before and after the entities of a DXF file.

#include <burin/base/box.h>
#include <burin/drawing/color.h>
#include <burin/drawing/drawing.h>
#include <burin/drawing/text.h>

#include "dxf_groups.h"

#include <cstdint>
#include <string>
#include <vector>

namespace burin::dxf {

/// A layer of the file.
struct LayerRow {
  std::string name;
  std::string_view linetype = kContinuous;
  /// The line weight that most of its paths have, in 1/100 mm.
  int weight = 25;
  /// Of AutoCAD's colours; 7 is black on paper, white on a black screen.
  int color = 7;
};

/// The nearest of AutoCAD's first nine colours.
int nearest_color(const Rgb& color);

/// The nearest of all of AutoCAD's colours but the first nine, for areas: 24 hues in five
/// brightnesses, each whole and half as strong, and six greys.
int nearest_of_all_colors(const Rgb& color);

/// A name as any reader of DXF takes it, other than those in `taken`: printable ASCII, "_" for what
/// is forbidden.
std::string symbol_name(std::string_view name, const std::vector<LayerRow>& taken);

/// Sizes that the head tells of.
struct Frame {
  Vec2 sheet{0}, low{0}, high{0};
  std::vector<double> dashes, dash_dots, long_dash_dots;
  std::uint64_t next_handle = 0;
};

/// HEADER, CLASSES, TABLES, BLOCKS, and ENTITIES up to the first.
void append_head(Buffer& out, const Frame& frame, const std::vector<LayerRow>& layers);

/// The end of ENTITIES, and OBJECTS.
void append_tail(Buffer& buffer, const Frame& frame);

}  // namespace burin::dxf
