#include <burin/annotate/details.h>
#include <burin/annotate/title_block.h>

#include "frame_path.h"

#include <array>
#include <string>

namespace burin {
namespace {

using detail::line;

constexpr double kHeight = 36, kRow = 9;
constexpr double kInset = 1;  // paper mm between a line and letters
// Heights of letters, of which ISO 3098 has 1.8, 2.5, 3.5.
constexpr double kLabel = 1.8, kValue = 2.5, kImportant = 3.5;

/// Paper mm at the width of ISO 7200.
struct Cell {
  const char* field;
  const char* label;
  double left, right, bottom, top;
  double height = kValue;
  int lines = 1;
  /// What stands below its value.
  double below = 0;
};

constexpr double kOwner = 60, kTitleEnd = 128;   // where columns end
constexpr double kScale = 13;                    // the symbol has room beside it
constexpr double kSupplement = 1.4, kBelow = 4;  // the second title, and what it takes
constexpr std::array<Cell, 16> kCells{{
    {"department", "Responsible department", 0, 45, 3 * kRow, kHeight},
    {"reference", "Technical reference", 45, 90, 3 * kRow, kHeight},
    {"author", "Created by", 90, 135, 3 * kRow, kHeight},
    {"approved_by", "Approved by", 135, 180, 3 * kRow, kHeight},
    {"company", "Legal owner", 0, kOwner, kScale, 3 * kRow, kImportant, 2},
    {"document_type", "Document type", kOwner, 98, 2 * kRow, 3 * kRow},
    {"status", "Document status", 98, kTitleEnd, 2 * kRow, 3 * kRow},
    {"model", "Model", kTitleEnd, 180, 2 * kRow, 3 * kRow},
    {"scale", "Scale", 0, 30, 0, kScale, kImportant},
    {"", "", 30, kOwner, 0, kScale},
    {"title", "Title", kOwner, kTitleEnd, 0, 2 * kRow, kImportant, 2, kBelow},
    {"number", "Identification number", kTitleEnd, 180, kRow, 2 * kRow, kImportant},
    {"revision", "Rev.", kTitleEnd, 138, 0, kRow},
    {"date", "Date of issue", 138, 161, 0, kRow},
    {"language", "Lang.", 161, 170, 0, kRow},
    {"sheet", "Sheet", 170, 180, 0, kRow},
}};

/// A value in letters of a height, its base line at `y`.
TitleBlockText value(const Cell& cell, const char* field, double y, double height) {
  return {{{cell.left + kInset, y}, height, TextAnchor::Start, "", "title_block"},
          field,
          cell.right - cell.left - 2 * kInset};
}

}  // namespace

std::span<const TitleBlockField> title_block_fields() {
  static constexpr std::array<TitleBlockField, 16> kFields{{
      {"title",
       "what the drawing is called (default: the title of the illustration, or the name "
       "of the part or of the file)"},
      {"supplementary_title", "a second line of the title"},
      {"number", "identification number of the drawing"},
      {"revision", "revision index"},
      {"date", "date of issue; never that of today by itself"},
      {"sheet", "number of the sheet, such as 1/3"},
      {"language", "language code, such as en"},
      {"scale", "scale (default: that of the first view)"},
      {"company", "legal owner"},
      {"department", "responsible department"},
      {"reference", "technical reference: whom to ask"},
      {"author", "who made it"},
      {"approved_by", "who approved it"},
      {"document_type", "such as assembly drawing"},
      {"status", "document status, such as released"},
      {"model", "the model that is drawn (default: the name of its file)"},
  }};
  return kFields;
}

TitleBlockLayout iso_title_block(double width, const CalloutOptions& style) {
  const double f = width / kTitleBlockWidth, narrow = style.line, thick = 2 * style.line;
  TitleBlockLayout block;
  block.size = {width, kHeight};
  Path border = line({0, 0}, {width, 0}, thick);
  border.points.insert(border.points.end(), {{width, kHeight}, {0, kHeight}});
  border.closed = true;
  block.paths.push_back(std::move(border));
  for (Cell cell : kCells) {
    cell.left *= f, cell.right *= f;
    // Each line between cells is the left or the upper side of some.
    if (cell.left > 0) {
      block.paths.push_back(line({cell.left, cell.bottom}, {cell.left, cell.top}, narrow));
    }
    if (cell.top < kHeight) {
      block.paths.push_back(line({cell.left, cell.top}, {cell.right, cell.top}, narrow));
    }
    const std::string field = cell.field;
    if (field.empty()) {
      const Vec2 symbol = projection_symbol_size(), room(cell.right - cell.left, cell.top);
      if (symbol.x + kInset <= room.x) block.symbol = Vec2(cell.left, 0) + 0.5 * (room - symbol);
      continue;
    }
    TitleBlockText label = value(cell, "", cell.top - kInset - kLabel, kLabel);
    label.text.text = cell.label;
    block.texts.push_back(std::move(label));
    const double free = cell.top - cell.bottom - kInset - kLabel - cell.below;
    const double y = cell.bottom + cell.below + 0.5 * (free - cell.height);
    block.texts.push_back(value(cell, cell.field, y, cell.height));
    block.texts.back().lines = cell.lines;
    if (cell.below > 0) {
      block.texts.push_back(value(cell, "supplementary_title", kSupplement, kValue));
    }
  }
  return block;
}

}  // namespace burin
