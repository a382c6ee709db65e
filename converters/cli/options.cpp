#include "options.h"

#include <burin/converters/catalogues.h>
#include <burin/converters/illustration.h>
#include <burin/illustrate/style.h>

#include <fmt/format.h>

namespace burin::cli {
namespace {

std::string list() {
  std::string text, group;
  for (const RequestOption& option : all_options()) {
    if (option.group != group) text += fmt::format("\n{}\n", option.group);
    group = option.group;
    const std::string name = spelled(option.option.name, Spelling::Options);
    text += fmt::format("  {:<26} {}\n", name + " " + option.label, option.option.meaning);
  }
  return text.substr(1) + "\nburin styles --keys lists the keys of styles.\n";
}

}  // namespace

std::string run_options(const OptionsArguments& arguments) {
  if (arguments.style_schema) return style_schema();
  if (arguments.illustration_schema) return illustration_schema();
  return arguments.json ? catalogues_json() : list();
}

}  // namespace burin::cli
