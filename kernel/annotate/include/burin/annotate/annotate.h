#pragma once
/// Numbers, leaders and a parts list, laid over a finished drawing.

#include <burin/annotate/options.h>
#include <burin/annotate/title_block.h>
#include <burin/base/run_context.h>
#include <burin/camera/paper.h>
#include <burin/camera/sheet.h>
#include <burin/drawing/drawing.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace burin {

/// A colour and what has it.
struct LegendRow {
  /// Number of the item; 0: none.
  int item = 0;
  std::string name;
  /// Part, fill, opacity and ink of the square; without rings.
  Area square{};
  /// Whether the drawing has the colour. Room is kept for rows that are not seen, too: a drawing is
  /// placed before that is known.
  bool seen = true;
};

/// What is laid over a drawing.
struct Annotations {
  /// Of the parts that are drawn, by number.
  std::vector<DrawingItem> items;
  /// A number at each item, with a leader; ISO 6433.
  bool callouts = false;
  /// The items as a table above the lower right corner, from the bottom up; ISO 7573.
  bool parts_list = false;
  /// Squares in the colours of parts, with names beside them; empty: none.
  std::vector<LegendRow> legend = {};
  /// In the lower right corner, below the list.
  std::optional<TitleBlock> title_block = {};
  /// The empty border of the sheet, in which nothing of it stands.
  Margin margin{};
  /// Lines that are laid over the drawing later, as of sections and details, paper mm: callouts
  /// keep clear of them.
  std::vector<std::vector<Vec2>> over_it = {};
  /// Width and height of what is drawn, in any unit; 0: not known. Tables are placed where they
  /// leave it the largest scale.
  Vec2 shape{0};
};

/// The border that a drawing must keep so that what is laid over it has space:
/// `Annotations::margin` and that space.
Margin annotation_margin(const Annotations& annotations, const CalloutOptions& style,
                         const Paper& paper);

/// Whether callouts and the list have room on a sheet whose drawing keeps that border, for sheets
/// that are as large as they need be.
bool annotations_fit(const Annotations& annotations, const CalloutOptions& style,
                     const Paper& paper, const Margin& border);

/// What the title block, the parts list and the legend that the annotations have leave of the sheet
/// without its margin.
Box2 beside_tables(const Annotations& annotations, const CalloutOptions& style, const Paper& paper);

/// Where the list stands; nothing where there is none or it has no room.
std::optional<Box2> parts_list_box(const Annotations& annotations, const CalloutOptions& style,
                                   const Paper& paper);

/// Whether there is a title block with a place for the symbol of the projection method.
bool has_symbol(const Annotations& annotations, const CalloutOptions& style, const Paper& paper);

/// Lays the title block, the parts list and the legend alone over a sheet, with the diagnostics of
/// `annotate` about them.
void lay_tables(Drawing& drawing, const Annotations& annotations, const CalloutOptions& style);

/// Lays callouts (layer "callouts"), the title block (layer "title_block"), the parts list (layer
/// "parts_list") and the legend (layer "legend", its squares last of all areas) over a drawing that
/// stands in its sheet. `seen`: what is seen of each part, by even-odd, also through others; its
/// parts and rings alone count. The leader of an item begins in the largest disc that is seen of
/// one of its parts, with a dot, or on the longest line of one with an arrow where that disc has a
/// radius of 0.8 mm or less. Tells in the diagnostics of items that are not seen
/// ("callouts.not_shown"), of numbers that have no room
/// ("callouts.crowded"), of a list or a legend that has none ("parts_list.no_room",
/// "legend.no_room"; "title_block.no_room", ".narrow", ".cut") and of characters that the font has
/// not ("text.no_glyph"). Throws Cancelled. Cost: that of `largest_disc` for each part, and 5 ms
/// for 100 items.
void annotate(Drawing& drawing, std::span<const Area> seen, const Annotations& annotations,
              const CalloutOptions& style, const RunContext& context);

}  // namespace burin
