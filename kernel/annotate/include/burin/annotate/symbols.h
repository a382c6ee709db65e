#pragma once
/// Kinds of symbols that stand at the end of a leader in the place of words alone: a row each.

#include <burin/annotate/label.h>
#include <burin/options/declared.h>

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// What a symbol is drawn for.
struct SymbolRequest {
  /// UTF-8, lines parted by "\n"; may be empty.
  std::string text;
  LabelPens pens = {};
  /// By "row.option".
  DeclaredValues values = {};
};

struct SymbolKind {
  std::string_view name;
  /// What it is, in a few words.
  std::string_view meaning;
  /// May throw PluginError where a plug-in draws it.
  std::function<Label(const SymbolRequest&)> draw;
  std::vector<DeclaredOption> options{};
};

/// Burin's own ("surface", "weld", "balloon", "warning", "mandatory", "prohibition"), then what was
/// added.
std::span<const SymbolKind> symbol_kinds();

/// Null where there is none of the name.
const SymbolKind* find_symbol(std::string_view name);

/// Adds a kind, or puts it in the place of one of its name. Its texts live as long as the program.
/// Throws UsageError where one of Burin's own has the name.
void add(SymbolKind kind);

}  // namespace burin
