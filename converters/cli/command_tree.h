#pragma once
/// The command as data: what manual pages and completions of shells are made from. Read off CLI11,
/// so that they tell what the command takes, plug-ins included.

#include <CLI/App.hpp>

#include <string>
#include <vector>

namespace burin::cli {

struct CommandOption {
  /// "--output", "-o"; the long one first.
  std::vector<std::string> names;
  /// What it takes: "FILE"; empty for a switch.
  std::string label;
  /// One paragraph, its lines joined.
  std::string meaning;
  std::string group;
  /// Words that it takes: "none", "dashed"; empty where nobody can list them.
  std::vector<std::string> words;
};

struct Command {
  /// "draw"; that of the whole command is empty.
  std::string name;
  std::string meaning;
  /// As they stand in the help: "INPUT"; and what each is.
  std::vector<CommandOption> arguments;
  std::vector<CommandOption> options;
  /// What follows in the help: examples, exit status; with its line breaks.
  std::string footer;
};

/// First the command as a whole, then each of its commands in the order of the help.
std::vector<Command> command_tree(const CLI::App& app);

/// A page of the manual of section 1 in the language of man(7); `command` empty: that of the
/// command as a whole, which lists the others. Throws UsageError for a command that is none.
std::string manual_page(const std::vector<Command>& tree, const std::string& command);

/// Completion for "bash", "zsh" or "fish". Throws UsageError for another shell.
std::string completion(const std::vector<Command>& tree, const std::string& shell);

}  // namespace burin::cli
