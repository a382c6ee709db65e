#pragma once
/// What stands at the end of the leader of a note: lines, fills and texts in a box.

#include <burin/base/vec.h>
#include <burin/drawing/drawing.h>

#include <string_view>
#include <vector>

namespace burin {

/// A piece of a drawing, paper mm from its lower left corner, that is placed as one.
struct Label {
  /// Width and height.
  Vec2 size{0};
  /// Where its leader meets its left or right side, above the lower edge.
  double shoulder = 0;
  /// Whether the leader goes on below it, from side to side.
  bool underlined = false;
  /// Whether its lines of text end at its right side where that is the leader's.
  bool ragged = false;
  std::vector<Path> paths = {};
  /// With a fill each, later ones over earlier ones; "" is the colour of lines.
  std::vector<Area> areas = {};
  std::vector<Text> texts = {};
};

/// All of it, moved on paper.
void move(Label& label, Vec2 by);

/// How letters of labels are drawn, paper mm.
struct LabelPens {
  /// Of capital letters.
  double height = 3.5;
  /// Width of lines.
  double line = 0.18;
};

/// UTF-8 text; "\n" begins a new line. A single line without a frame stands on the shoulder of its
/// leader (ISO 128-22), others beside its end.
Label text_label(std::string_view text, bool framed, const LabelPens& pens);

}  // namespace burin
