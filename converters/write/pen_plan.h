#pragma once
/// What pens draw of a drawing, and in which order.

#include <burin/base/run_context.h>
#include <burin/converters/write.h>
#include <burin/drawing/arcs.h>
#include <burin/drawing/drawing.h>
#include <burin/drawing/pen_order.h>
#include <burin/drawing/text.h>

#include "pen_options.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// Bytes of text that are written at once.
constexpr std::size_t kFlushed = 1 << 16;
/// Writes the text, and empties it.
inline void flush(Buffer& text, std::ostream& out) {
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  text.clear();
}

struct Pen {
  std::uint32_t number = 0;
  /// Paper mm: that of most of its lines, in its first layer.
  double width = 0;
  std::vector<std::string> layers;
};

/// The lines of all pens, cut at the sheet, hidden ones in dashes, letters as outlines, strokes
/// along their middle; ordered.
struct PenPlan {
  /// By number; the groups of `paths` count them from 0.
  std::vector<Pen> pens;
  std::deque<std::vector<Vec2>> points;
  std::vector<PenPath> paths;
  PenOrder order;

  /// Whether the pen stays on the paper between a line and the one before it: their ends are no
  /// farther apart than `join` mm, and neither is a dash.
  bool goes_on(std::size_t line, Vec2 before, Vec2 first, double join) const;
};

/// A line that is drawn in pieces: arcs of circles where `arcs` wants them and they are some, and
/// what is between them. A closed line ends where it begins.
std::vector<CurvePiece> pen_pieces(const PenLine& line, const PenPlan& plan, bool arcs);

/// Plans the lines of a drawing for a format ("hpgl"), whose name begins the keys in messages. What
/// a pen cannot show goes to `options.report`. Throws UsageError where `pens` says nothing that can
/// be read, Cancelled.
PenPlan plan_pens(const Drawing& drawing, const PenOptions& pens, std::string_view format,
                  const WriteOptions& options, const RunContext& context);

}  // namespace burin
