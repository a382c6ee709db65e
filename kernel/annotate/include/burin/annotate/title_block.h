#pragma once
/// The title block of a sheet: that of ISO 7200, or one of the user's own.

#include <burin/annotate/options.h>
#include <burin/base/box.h>
#include <burin/camera/view_grid.h>
#include <burin/drawing/drawing.h>

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// A text of a title block.
struct TitleBlockText {
  /// What it says without a value, and where: its place is that of its one line, or of the middle
  /// of its lines.
  Text text{};
  /// The field whose value it shows; empty: it is the same in all drawings.
  std::string field = {};
  /// Paper mm that a line may take; 0: as much as it needs. A value that is longer has more lines,
  /// then smaller letters, and is cut at last.
  double width = 0;
  int lines = 1;
};

/// Lines and texts, in paper mm from the lower left corner.
struct TitleBlockLayout {
  Vec2 size{0};
  std::vector<Path> paths = {};
  std::vector<TitleBlockText> texts = {};
  /// The lower left corner of the symbol of the projection method.
  std::optional<Vec2> symbol = {};
  /// Of a layout of a whole sheet: what drawings keep clear of.
  std::optional<Box2> kept_clear = {};
  /// Texts of a template that it does not have, as they do not stand level.
  int left_out = 0;
};

/// A field of the block of ISO 7200.
struct TitleBlockField {
  const char* name;
  const char* meaning;
};
std::span<const TitleBlockField> title_block_fields();

struct TitleBlock {
  /// One of the size of the sheet lies over it; a smaller one stands in the lower right corner
  /// within the margin. Null: that of ISO 7200.
  std::shared_ptr<const TitleBlockLayout> layout = {};
  /// Values by the names of fields. Without one "title" is what the drawing is called, "scale" that
  /// of its first view, "model" the name of its file.
  std::map<std::string, std::string> fields = {};
  /// Of the views of the sheet, for the symbol.
  std::optional<ProjectionMethod> method = {};

  bool operator==(const TitleBlock&) const = default;
};

/// Paper mm: the width of ISO 7200, and the least that is drawn where a sheet has no more.
inline constexpr double kTitleBlockWidth = 180, kLeastTitleBlock = 120;

/// The block of ISO 7200 of that width; 36 mm high, its letters have their sizes at any width.
TitleBlockLayout iso_title_block(double width, const CalloutOptions& style);

}  // namespace burin
