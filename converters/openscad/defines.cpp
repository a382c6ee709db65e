#include <burin/base/error.h>
#include <burin/converters/openscad_reader.h>

#include "text.h"

#include <fmt/format.h>

#include <string_view>

namespace burin {
namespace {

bool begins_name(char c) { return is_letter(c) || c == '_' || c == '$'; }

bool is_name(std::string_view name) {
  if (name.empty() || !begins_name(name.front()) || name == "$") return false;
  for (std::size_t i = 1; i < name.size(); ++i) {
    const char c = name[i];
    if (c == '$' || !(begins_name(c) || is_digit(c))) return false;
  }
  return true;
}

/// What is wrong with a value, empty where nothing is. OpenSCAD pastes it into the program: it must
/// not end the assignment and go on.
std::string fault_of(std::string_view value) {
  std::string open;
  bool quoted = false, blank = true;
  for (std::size_t i = 0; i < value.size(); ++i) {
    const char c = value[i];
    blank = blank && is_blank(c);
    if (static_cast<unsigned char>(c) < ' ' && c != '\t') return "has a control character";
    if (quoted) {
      if (c == '\\') {
        ++i;
      } else if (c == '"') {
        quoted = false;
      }
    } else if (c == '"') {
      quoted = true;
    } else if (c == '[' || c == '(') {
      open += c == '[' ? ']' : ')';
    } else if (c == ']' || c == ')') {
      if (open.empty() || open.back() != c) return "has brackets that do not match";
      open.pop_back();
    } else if (c == ';' || c == '{' || c == '}') {
      return fmt::format("holds '{}'", c);
    } else if (c == '/' && i + 1 < value.size() && (value[i + 1] == '/' || value[i + 1] == '*')) {
      return "holds a comment";
    }
  }
  if (blank) return "is empty";
  if (quoted) return "has a quote that does not close";
  return open.empty() ? "" : "has brackets that do not match";
}

/// Whether a program names a variable anywhere, in a comment too.
bool names(std::string_view program, std::string_view variable) {
  const auto is_part = [](char c) { return begins_name(c) || is_digit(c); };
  for (std::size_t at = program.find(variable); at != std::string_view::npos;
       at = program.find(variable, at + 1)) {
    const std::size_t end = at + variable.size();
    if ((at == 0 || !is_part(program[at - 1])) && (end == program.size() || !is_part(program[end])))
      return true;
  }
  return false;
}

}  // namespace

std::vector<std::string> unused_defines(std::string_view program,
                                        const std::vector<std::string>& defines) {
  std::vector<std::string> unused;
  // Other files may name it.
  if (names(program, "include") || names(program, "use")) return unused;
  for (const std::string& define : defines) {
    const std::string name = define.substr(0, define.find('='));
    if (name.starts_with('$') || names(program, name)) continue;
    unused.push_back(name);
  }
  return unused;
}

void check_openscad_defines(const std::vector<std::string>& defines) {
  for (const std::string& define : defines) {
    const std::size_t equals = define.find('=');
    if (equals == std::string::npos || !is_name(std::string_view(define).substr(0, equals))) {
      throw UsageError(
          fmt::format("option -D takes NAME=VALUE as OpenSCAD does, e.g. -D '$fn=64' or -D "
                      "'label=\"A\"', not {}",
                      in_quotes(define)));
    }
    const std::string fault = fault_of(std::string_view(define).substr(equals + 1));
    if (!fault.empty()) {
      throw UsageError(fmt::format("option -D {}: the value {}", in_quotes(define), fault));
    }
  }
}

}  // namespace burin
