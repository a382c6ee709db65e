#include <burin/annotate/symbols.h>
#include <burin/base/catalogue.h>

#include "own_symbols.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace burin {
namespace {

GrowingCatalogue<SymbolKind>& all_symbols() {
  using namespace detail;
  static GrowingCatalogue<SymbolKind> kinds({surface_symbol(), weld_symbol(), balloon_symbol(),
                                             warning_symbol(), mandatory_symbol(),
                                             prohibition_symbol()});
  return kinds;
}

}  // namespace

std::span<const SymbolKind> symbol_kinds() { return all_symbols().rows(); }

const SymbolKind* find_symbol(std::string_view name) {
  const auto found = std::ranges::find(symbol_kinds(), name, &SymbolKind::name);
  return found == symbol_kinds().end() ? nullptr : &*found;
}

void add(SymbolKind kind) { all_symbols().add(std::move(kind)); }

std::string detail::in_one_line(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  return text;
}

Path detail::label_line(std::vector<Vec2> points, double width, bool closed) {
  Path path;
  path.kind = LineClass::Frame;
  path.points = std::move(points);
  path.width = {width};
  path.closed = closed;
  return path;
}

void detail::put_beside(std::string_view words, const LabelPens& pens, Label& label) {
  if (words.empty()) return;
  constexpr double kGap = 0.8;  // of the height of letters
  Label beside = text_label(words, false, pens);
  // A single line would stand above its shoulder.
  if (beside.underlined) {
    for (Text& text : beside.texts) text.at.y = 0;
    beside.size.y = pens.height;
  }
  const double left = label.size.x + kGap * pens.height;
  const double height = std::max(label.size.y, beside.size.y);
  const Vec2 words_up(left, 0.5 * (height - beside.size.y));
  move(label, {0, 0.5 * (height - label.size.y)});
  move(beside, words_up);
  std::ranges::move(beside.texts, std::back_inserter(label.texts));
  label.size = {left + beside.size.x, height};
  label.shoulder = 0.5 * height;
}

}  // namespace burin
