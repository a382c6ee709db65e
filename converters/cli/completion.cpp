#include <burin/base/error.h>

#include "command_tree.h"

#include <fmt/format.h>

#include <algorithm>

namespace burin::cli {
namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string out;
  for (const std::string& word : words) out += (out.empty() ? "" : " ") + word;
  return out;
}

/// In single quotes, for any of the three shells: fish reads \' there, the others end the quotes.
std::string quoted(const std::string& text, bool fish) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'') {
      out += fish ? "\\'" : "'\\''";
    } else if (fish && c == '\\') {
      out += "\\\\";
    } else {
      out += c;
    }
  }
  return out + "'";
}

std::string names_of_commands(const std::vector<Command>& tree) {
  std::vector<std::string> names;
  for (const Command& command : tree) {
    if (!command.name.empty()) names.push_back(command.name);
  }
  return joined(names);
}

std::string names_of_options(const Command& command) {
  std::vector<std::string> names;
  for (const CommandOption& option : command.options) {
    names.insert(names.end(), option.names.begin(), option.names.end());
  }
  return joined(names);
}

/// A list of words may have a file among what it takes (--style): where no word fits, bash goes on
/// to file names.
std::string for_bash(const std::vector<Command>& tree) {
  std::string out =
      "# Completion of burin for bash.\n"
      "_burin() {\n"
      "  local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} words=\n"
      "  if ((COMP_CWORD == 1)); then\n";
  out += fmt::format("    words={}\n",
                     quoted(names_of_commands(tree) + " " + names_of_options(tree.front()), false));
  out +=
      "    COMPREPLY=($(compgen -W \"$words\" -- \"$current\"))\n"
      "    return\n"
      "  fi\n"
      "  case ${COMP_WORDS[1]}:$before in\n";
  for (const Command& command : tree) {
    for (const CommandOption& option : command.options) {
      if (command.name.empty() || option.words.empty()) continue;
      for (const std::string& name : option.names) {
        out += fmt::format("    {}:{}) words={} ;;\n", command.name, name,
                           quoted(joined(option.words), false));
      }
    }
  }
  out +=
      "  esac\n"
      "  if [[ -z $words && $current == -* ]]; then\n"
      "    case ${COMP_WORDS[1]} in\n";
  for (const Command& command : tree) {
    if (command.name.empty()) continue;
    out += fmt::format("      {}) words={} ;;\n", command.name,
                       quoted(names_of_options(command), false));
  }
  return out +
         "    esac\n"
         "  fi\n"
         "  COMPREPLY=($(compgen -W \"$words\" -- \"$current\"))\n"
         "}\n"
         "complete -o bashdefault -o default -F _burin burin\n";
}

/// What stands in brackets after an option: no bracket or colon may end it.
std::string bracketed(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') out += '\\';
    out += c;
  }
  return out;
}

std::string for_zsh(const std::vector<Command>& tree) {
  std::string out =
      "#compdef burin\n"
      "_burin() {\n"
      "  local -a commands\n"
      "  commands=(\n";
  for (const Command& command : tree) {
    if (command.name.empty()) continue;
    out += "    " + quoted(command.name + ":" + bracketed(command.meaning), false) + "\n";
  }
  out +=
      "  )\n"
      "  if ((CURRENT == 2)); then\n"
      "    _describe command commands\n"
      "    return\n"
      "  fi\n"
      "  local command=$words[2]\n"
      "  shift words\n"
      "  ((CURRENT--))\n"
      "  case $command in\n";
  for (const Command& command : tree) {
    if (command.name.empty()) continue;
    out += "    " + command.name + ") _arguments -S";
    for (const CommandOption& option : command.options) {
      for (const std::string& name : option.names) {
        std::string spec = "*" + name + "[" + bracketed(option.meaning) + "]";
        if (!option.label.empty()) {
          spec += ":" + bracketed(option.label) + ":";
          spec += option.words.empty() ? "_files" : "(" + joined(option.words) + ")";
        }
        out += " \\\n      " + quoted(spec, false);
      }
    }
    out += " \\\n      '*:file:_files' ;;\n";
  }
  return out +
         "  esac\n"
         "}\n"
         "if [[ $zsh_eval_context[-1] == loadautofunc ]]; then _burin \"$@\"; else compdef _burin "
         "burin; fi\n";
}

std::string for_fish(const std::vector<Command>& tree) {
  std::string out = "# Completion of burin for fish.\n";
  for (const Command& command : tree) {
    const bool whole = command.name.empty();
    const std::string when =
        whole ? "__fish_use_subcommand" : "__fish_seen_subcommand_from " + command.name;
    if (!whole) {
      out += fmt::format("complete -c burin -f -n __fish_use_subcommand -a {} -d {}\n",
                         command.name, quoted(command.meaning, true));
    }
    for (const CommandOption& option : command.options) {
      out += "complete -c burin -n " + quoted(when, true);
      for (const std::string& name : option.names) {
        out += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
      }
      if (!option.words.empty()) out += " -x -a " + quoted(joined(option.words), true);
      if (!option.label.empty() && option.words.empty()) out += " -r";
      out += " -d " + quoted(option.meaning, true) + "\n";
    }
  }
  return out;
}

}  // namespace

std::string completion(const std::vector<Command>& tree, const std::string& shell) {
  if (shell == "bash") return for_bash(tree);
  if (shell == "zsh") return for_zsh(tree);
  if (shell == "fish") return for_fish(tree);
  throw UsageError(fmt::format("option --completion takes bash, zsh or fish, not '{}'", shell));
}

}  // namespace burin::cli
