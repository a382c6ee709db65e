#pragma once
/// All keys of styles: the rows of the rooms, a group each. Text, JSON and help are made from them.

#include <burin/illustrate/style.h>
#include <burin/options/row.h>

#include <string_view>
#include <vector>

namespace burin::detail {

using StyleRow = OptionRow<Style>;

/// In groups, as files have them.
const std::vector<StyleRow>& style_rows();

/// The row of that name. Throws UsageError that names the nearest.
const StyleRow& find_row(std::string_view name);

}  // namespace burin::detail
