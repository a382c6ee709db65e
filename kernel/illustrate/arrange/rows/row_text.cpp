#include "row_text.h"

#include <burin/annotate/symbols.h>

#include <algorithm>
#include <utility>

namespace burin::detail {

std::string replaced(std::string text, const std::string& name, const std::string& by) {
  for (std::size_t at = text.find(name); at != std::string::npos;
       at = text.find(name, at + by.size())) {
    text.replace(at, name.size(), by);
  }
  return text;
}

DimensionOptions style_of(const DimensionRow& row, DimensionOptions style) {
  style.decimals = row.decimals.value_or(style.decimals);
  style.unit = row.unit.value_or(style.unit);
  style.sign = row.sign.value_or(style.sign);
  return style;
}

namespace {

/// What stands in the braces of a note.
std::string value_text(const std::string& name, double value, const MeasuredRow& row,
                       const DimensionOptions& style) {
  if (name == "part.name") return row.part_name;
  if (name == "item") return std::to_string(row.item);
  // Areas and volumes stay in mm2 and mm3.
  DimensionOptions plain = style;
  if (name == "area" || name == "volume") plain.unit = DimensionOptions::Unit::Millimetre;
  return dimension_text(value, plain);
}

std::string text_of(const MeasuredRow& row, const DimensionOptions& style) {
  std::string text = row.row.text;
  std::ranges::replace(text, '\t', ' ');  // no font has a sign for it
  for (const auto& [name, value] : row.values) {
    text = replaced(std::move(text), "{" + name + "}", value_text(name, value, row, style));
  }
  return text;
}

}  // namespace

std::shared_ptr<const Label> note_words(const MeasuredRow& row, const DimensionOptions& sheet) {
  const DimensionOptions style = style_of(row.row, sheet);
  return std::make_shared<const Label>(
      text_label(text_of(row, style), row.row.framed, {style.height, style.line}));
}

std::shared_ptr<const Label> note_label(const MeasuredRow& row, const DimensionOptions& sheet) {
  const SymbolKind* symbol = find_symbol(row.row.symbol);
  if (!symbol) return note_words(row, sheet);
  const DimensionOptions style = style_of(row.row, sheet);
  return std::make_shared<const Label>(
      symbol->draw({text_of(row, style), {style.height, style.line}, row.row.symbol_values}));
}

}  // namespace burin::detail
