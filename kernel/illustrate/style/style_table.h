#pragma once
/// All keys of styles: the rows of the modules, a group each. Text, JSON and help are made from
/// them.

#include <burin/illustrate/style.h>
#include <burin/options/row.h>

#include "key_needs.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace burin::detail {

struct StyleRow : OptionRow<Style> {
  /// One value for the whole drawing, whatever style a part has.
  bool of_whole = false;
  /// What must hold for it to have an effect.
  std::vector<KeyNeed> needs = {};
};

/// The key that parts have instead of one that holds for the whole drawing; empty: none.
std::string key_of_parts(std::string_view whole);

/// What people look for who know a key by another name.
std::vector<std::string> other_names_of(std::string_view key);

/// In groups, as files have them.
const std::vector<StyleRow>& style_rows();

using KindRow = OptionRow<StrokeKind>;

/// Keys of an entry of "strokes": those of "hatch" without the group, those of "tone" with it.
const std::vector<KindRow>& kind_rows();

/// `style_rows`, and for each stroke kind that the style has after the first, those of `kind_rows`
/// with its number: "strokes.2.taper". They set the kind of a style that has it.
std::vector<StyleRow> all_rows_of(const Style& style);

/// "strokes.2.taper" as 2 and "taper"; nothing for other keys. Throws UsageError where the number
/// is none that kinds have.
struct KindKey {
  std::size_t number = 1;
  std::string name;
};
std::optional<KindKey> kind_key(std::string_view key);

/// The name of a key's row: keys of the first kind of strokes have two names.
std::string row_of_key(std::string_view key);

/// The row of that name. Throws UsageError that names the nearest.
const StyleRow& find_row(std::string_view name);
const KindRow& find_kind_row(const std::string& name, std::size_t number);

/// What keys of a stroke kind begin with: "hatch.", "strokes.2.".
std::string kind_group(std::size_t number);

/// What a stroke kind is that a style gets beside what it has.
StrokeKind next_kind(const Style& style);

/// Changes a stroke kind to the row of `stroke_kinds` of that name. Throws UsageError that names
/// the nearest.
void become(std::string_view kind, StrokeKind& strokes);

}  // namespace burin::detail
