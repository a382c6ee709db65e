#include <burin/base/error.h>
#include <burin/base/version.h>

#include "command_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace burin::cli {
namespace {

/// Text as man(7) prints it unchanged: hyphens that can be copied, no escapes, no requests.
std::string roff(const std::string& text) {
  std::string out;
  bool starts = true;
  for (const char c : text) {
    if (starts && (c == '.' || c == '\'')) out += "\\&";
    starts = c == '\n';
    if (c == '\\') {
      out += "\\e";
    } else if (c == '-') {
      out += "\\-";
    } else {
      out += c;
    }
  }
  return out;
}

std::string bold(const std::string& text) { return "\\fB" + roff(text) + "\\fR"; }
std::string slanted(const std::string& text) { return "\\fI" + roff(text) + "\\fR"; }

std::string spelled_out(const CommandOption& option) {
  std::string out;
  for (const std::string& name : option.names) out += (out.empty() ? "" : ", ") + bold(name);
  return option.label.empty() ? out : out + " " + slanted(option.label);
}

std::string capitals(std::string text) {
  std::ranges::transform(text, text.begin(), [](char c) {
    return 'a' <= c && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  });
  return text;
}

void head(std::string& out, const std::string& page, const std::string& meaning) {
  out += fmt::format(".TH {} 1 \"\" \"burin {}\" \"Burin\"\n", capitals(roff(page)), version());
  out += fmt::format(".SH NAME\n{} \\- {}\n", roff(page), roff(meaning));
}

void list_options(std::string& out, const Command& command) {
  std::vector<std::string> groups;
  for (const CommandOption& option : command.options) {
    if (std::ranges::find(groups, option.group) == groups.end()) groups.push_back(option.group);
  }
  out += ".SH OPTIONS\n";
  for (const std::string& group : groups) {
    if (groups.size() > 1) out += ".SS " + roff(group) + "\n";
    for (const CommandOption& option : command.options) {
      if (option.group != group) continue;
      out += ".TP\n" + spelled_out(option) + "\n" + roff(option.meaning) + "\n";
    }
  }
}

/// Lines that end with a colon are headings of what follows; indented ones are commands.
void add_footer(std::string& out, const std::string& footer) {
  std::istringstream lines(footer);
  bool as_is = false;
  for (std::string line; std::getline(lines, line);) {
    const bool command = line.starts_with("  ");
    if (command != as_is) out += command ? ".nf\n" : ".fi\n";
    as_is = command;
    if (line == "Examples:") {
      out += ".SH EXAMPLES\n";
    } else if (line.starts_with("Exit status: ")) {
      out += ".SH EXIT STATUS\n" + roff(line.substr(13)) + "\n";
    } else {
      out += line.empty() ? ".PP\n" : roff(line) + "\n";
    }
  }
  if (as_is) out += ".fi\n";
}

std::string page_of(const Command& command) {
  std::string out;
  head(out, "burin-" + command.name, command.meaning);
  out += ".SH SYNOPSIS\n" + bold("burin " + command.name) + " [" + slanted("OPTIONS") + "]";
  for (const CommandOption& argument : command.arguments) {
    out += " " + slanted(argument.names.front()) + "...";
  }
  out += "\n";
  if (!command.arguments.empty()) out += ".SH DESCRIPTION\n";
  for (const CommandOption& argument : command.arguments) {
    out += ".TP\n" + slanted(argument.names.front()) + "\n" + roff(argument.meaning) + "\n";
  }
  list_options(out, command);
  add_footer(out, command.footer);
  return out + ".SH SEE ALSO\n.BR burin (1)\n";
}

std::string whole_page(const std::vector<Command>& tree) {
  std::string out;
  head(out, "burin", "line art of models: hidden lines removed, tone carried by strokes");
  out += ".SH SYNOPSIS\n" + bold("burin") + " " + slanted("COMMAND") + " [" + slanted("OPTIONS") +
         "]\n.SH COMMANDS\n";
  for (const Command& command : tree) {
    if (command.name.empty()) continue;
    out += ".TP\n.BR burin\\-" + roff(command.name) + " (1)\n" + roff(command.meaning) + "\n";
  }
  list_options(out, tree.front());
  return out;
}

}  // namespace

std::string manual_page(const std::vector<Command>& tree, const std::string& command) {
  if (command.empty() || command == "burin") return whole_page(tree);
  const auto found = std::ranges::find(tree, command, &Command::name);
  if (found == tree.end()) throw UsageError("option --manual: there is no command " + command);
  return page_of(*found);
}

}  // namespace burin::cli
