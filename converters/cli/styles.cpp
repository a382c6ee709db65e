#include "styles.h"

#include <burin/illustrate/style.h>

#include <fmt/format.h>

#include <algorithm>

namespace burin::cli {
namespace {

std::string list_styles() {
  std::string text;
  for (const StyleInfo& s : builtin_styles()) {
    text += fmt::format("{:<11} {}\n", s.name, s.description);
  }
  return text +
         "\nburin styles --keys lists what can be changed by --set KEY=VALUE or in a style file;\n"
         "burin styles --show NAME prints a style as such a file.\n";
}

std::string list_keys(const std::string& style) {
  std::string text =
      fmt::format("{:<22} {:<26} {:<15} {}\n", "KEY", "TAKES", "IN " + style, "MEANING");
  for (const StyleKey& k : style_keys(builtin_style(style))) {
    text += fmt::format("{:<22} {:<26} {:<15} {}\n", k.name, takes_text(k), k.value, k.meaning);
  }
  return text;
}

}  // namespace

std::string run_styles(const StylesArguments& arguments) {
  const std::string style = arguments.show.empty() ? "technical" : arguments.show;
  if (arguments.keys) return list_keys(style);
  return arguments.show.empty() ? list_styles() : style_to_json(builtin_style(style));
}

}  // namespace burin::cli
