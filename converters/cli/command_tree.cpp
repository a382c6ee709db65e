#include "command_tree.h"

#include <burin/converters/request.h>

#include <CLI/App.hpp>

#include <algorithm>
#include <variant>

namespace burin::cli {
namespace {

std::string joined_lines(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  return text;
}

/// What an option of drawings or of reading can be completed to.
std::vector<std::string> words_of(const std::string& long_name) {
  for (const RequestOption& option : all_options()) {
    if (spelled(option.option.name, Spelling::Options) != "--" + long_name) continue;
    const auto* list = std::get_if<WordList>(&option.option.takes);
    return list ? list->words : option.choices;
  }
  return {};
}

CommandOption read(const CLI::Option& option) {
  CommandOption out;
  for (const std::string& name : option.get_lnames()) out.names.push_back("--" + name);
  for (const std::string& name : option.get_snames()) out.names.push_back("-" + name);
  if (option.get_items_expected_max() > 0) out.label = option.get_type_name();
  out.meaning = joined_lines(option.get_description());
  out.group = option.get_group();
  if (!option.get_lnames().empty()) out.words = words_of(option.get_lnames().front());
  return out;
}

Command read(const CLI::App& app, const std::string& name) {
  Command out;
  out.name = name;
  out.meaning = app.get_description();
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_positional()) {
      out.arguments.push_back(read(*option));
      out.arguments.back().names = {option->get_name(true)};
    } else {
      out.options.push_back(read(*option));
    }
  }
  out.footer = app.get_footer();
  return out;
}

}  // namespace

std::vector<Command> command_tree(const CLI::App& app) {
  std::vector<Command> tree = {read(app, "")};
  for (const CLI::App* sub : app.get_subcommands({})) {
    const bool hidden = sub->get_group().empty();
    if (!sub->get_name().empty() && !hidden) tree.push_back(read(*sub, sub->get_name()));
  }
  return tree;
}

}  // namespace burin::cli
