#include "source_names.h"

#include <burin/base/ascii.h>

#include <algorithm>
#include <array>
#include <optional>

namespace burin::detail {
namespace {

constexpr std::array<std::string_view, 42> kOwn = {"assign",
                                                   "circle",
                                                   "color",
                                                   "cube",
                                                   "cylinder",
                                                   "difference",
                                                   "echo",
                                                   "for",
                                                   "group",
                                                   "hull",
                                                   "if",
                                                   "import",
                                                   "import_dxf",
                                                   "import_off",
                                                   "import_stl",
                                                   "intersection",
                                                   "intersection_for",
                                                   "let",
                                                   "linear_extrude",
                                                   "minkowski",
                                                   "mirror",
                                                   "multmatrix",
                                                   "offset",
                                                   "polygon",
                                                   "polyhedron",
                                                   "projection",
                                                   "render",
                                                   "resize",
                                                   "rotate",
                                                   "rotate_extrude",
                                                   "scale",
                                                   "sphere",
                                                   "square",
                                                   "surface",
                                                   "text",
                                                   "translate",
                                                   "union",
                                                   "children",
                                                   "child",
                                                   "dxf_linear_extrude",
                                                   "else",
                                                   "dxf_rotate_extrude"};

bool is_word(char c) { return is_letter(c) || is_digit(c) || c == '_' || c == '$'; }

/// One statement at the top that may make an object.
struct Statement {
  std::string name;
  bool condition = false;
};

class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  /// Nothing where the text is not understood.
  std::optional<std::vector<Statement>> run() {
    std::vector<Statement> out;
    for (skip(); p_ < text_.size(); skip()) {
      if (text_[p_] == ';') {
        ++p_;
        continue;
      }
      const bool disabled = modifiers();
      const std::string_view first = word();
      if (first.empty()) return std::nullopt;
      if (first == "include") return std::nullopt;
      if (first == "use") {
        p_ = std::min(text_.find('>', p_), text_.size() - 1) + 1;
      } else if (first == "module" || first == "function") {
        if (first == "module") word_after_space();
        to_end(first == "module");
      } else if (assigns()) {
        to_end(false);
      } else if (first == "echo" || first == "assert") {
        // echo() and assert() may have a statement behind them, which is one of its own.
        skip();
        round();
      } else {
        Statement s = statement(first);
        if (!disabled) out.push_back(std::move(s));
      }
    }
    return out;
  }

 private:
  /// Whether `*` is among them.
  bool modifiers() {
    bool disabled = false;
    for (; p_ < text_.size() && std::string_view("%#!*").find(text_[p_]) != std::string_view::npos;
         skip()) {
      disabled = disabled || text_[p_] == '*';
      ++p_;
    }
    return disabled;
  }

  /// From behind the first word to the end of the statement.
  Statement statement(std::string_view first) {
    Statement out;
    out.condition = first == "if";
    for (std::string_view name = first; !name.empty(); name = word()) {
      if (std::ranges::find(kOwn, name) == kOwn.end()) {
        // The innermost: what stands before it moves or colours it.
        out.name = name;
      }
      skip();
      round();
      skip();
      modifiers();
      skip();
    }
    end_of_statement();
    for (skip(); out.condition && text_.substr(p_).starts_with("else"); skip()) {
      if (p_ + 4 < text_.size() && is_word(text_[p_ + 4])) break;
      p_ += 4;
      skip();
      end_of_statement();
    }
    return out;
  }

  /// A block, or all up to the next semicolon.
  void end_of_statement() {
    skip();
    if (p_ < text_.size() && text_[p_] == '{') {
      brackets();
    } else {
      to_end(true);
    }
  }

  bool assigns() {
    const std::size_t start = p_;
    skip();
    const bool yes =
        p_ < text_.size() && text_[p_] == '=' && !(p_ + 1 < text_.size() && text_[p_ + 1] == '=');
    if (!yes) p_ = start;
    return yes;
  }

  /// Behind the next semicolon outside brackets, or where `block` behind the first {}.
  void to_end(bool block) {
    for (skip(); p_ < text_.size(); skip()) {
      const char c = text_[p_];
      if (c == ';') {
        ++p_;
        return;
      }
      if (c == '{') {
        brackets();
        if (block) return;
      } else if (c == '(' || c == '[') {
        brackets();
      } else {
        next();
      }
    }
  }
  void round() {
    if (p_ < text_.size() && text_[p_] == '(') brackets();
  }
  /// From an opening bracket to behind the one that closes it.
  void brackets() {
    int depth = 0;
    for (; p_ < text_.size(); skip()) {
      const char c = text_[p_];
      if (c == '(' || c == '[' || c == '{') ++depth;
      if (c == ')' || c == ']' || c == '}') --depth;
      next();
      if (depth == 0) return;
    }
  }
  /// A character, or a whole text in quotes.
  void next() {
    if (text_[p_++] != '"') return;
    for (; p_ < text_.size(); ++p_) {
      if (text_[p_] == '\\') {
        ++p_;
      } else if (text_[p_] == '"') {
        ++p_;
        return;
      }
    }
  }
  std::string_view word() {
    const std::size_t start = p_;
    while (p_ < text_.size() && is_word(text_[p_])) ++p_;
    return text_.substr(start, p_ - start);
  }
  void word_after_space() {
    skip();
    word();
  }
  /// Blanks and comments.
  void skip() {
    for (; p_ < text_.size(); ++p_) {
      if (text_.substr(p_).starts_with("//")) {
        p_ = std::min(text_.find('\n', p_), text_.size() - 1);
      } else if (text_.substr(p_).starts_with("/*")) {
        p_ = std::min(text_.find("*/", p_ + 2), text_.size() - 2) + 1;
      } else if (!(text_[p_] == ' ' || (text_[p_] >= '\t' && text_[p_] <= '\r'))) {
        return;
      }
    }
  }

  std::string_view text_;
  std::size_t p_ = 0;
};

}  // namespace

std::vector<std::string> source_names(std::string_view program, std::size_t count) {
  std::vector<std::string> names(count);
  const auto statements = Scanner(program).run();
  if (!statements) return names;
  std::vector<std::string> all, unconditional;
  for (const Statement& s : *statements) {
    all.push_back(s.name);
    if (!s.condition) unconditional.push_back(s.name);
  }
  if (all.size() == count) return all;
  if (unconditional.size() == count) return unconditional;
  return names;
}

}  // namespace burin::detail
