#include <burin/base/error.h>
#include <burin/converters/openscad_reader.h>

#include "text.h"

#include <fmt/format.h>

#include <string_view>

namespace burin {
namespace {

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '$';
}

bool is_name(std::string_view name) {
  if (name.empty() || !is_letter(name.front()) || name == "$") return false;
  for (std::size_t i = 1; i < name.size(); ++i) {
    const char c = name[i];
    if (c == '$' || !(is_letter(c) || (c >= '0' && c <= '9'))) return false;
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

}  // namespace

void check_openscad_defines(const std::vector<std::string>& defines) {
  for (const std::string& define : defines) {
    const std::size_t equals = define.find('=');
    if (equals == std::string::npos || !is_name(std::string_view(define).substr(0, equals))) {
      throw UsageError(
          fmt::format("option -D takes NAME=VALUE as OpenSCAD does, say -D '$fn=64' or -D "
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
