#include "program_text.h"

#include <burin/base/ascii.h>

#include <algorithm>
#include <array>

namespace burin::detail {
namespace {

constexpr std::array<std::string_view, 43> kOwn = {"assert",
                                                   "assign",
                                                   "child",
                                                   "children",
                                                   "circle",
                                                   "color",
                                                   "cube",
                                                   "cylinder",
                                                   "difference",
                                                   "dxf_linear_extrude",
                                                   "echo",
                                                   "else",
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
                                                   "dxf_rotate_extrude"};

bool is_word(char c) { return is_letter(c) || is_digit(c) || c == '_' || c == '$'; }

}  // namespace

bool is_own_module(std::string_view name) { return std::ranges::find(kOwn, name) != kOwn.end(); }

bool assigns_at_top(std::string_view program, std::string_view name) {
  ProgramText text(program);
  for (text.skip(); !text.at_end(); text.skip()) {
    const char c = text.here();
    if (c == '(' || c == '[' || c == '{') {
      text.brackets();
    } else if (const std::string_view word = text.word(); word.empty()) {
      text.next();
    } else if (word == name && text.assigns()) {
      return true;
    }
  }
  return false;
}

bool ProgramText::here_word(std::string_view word) const {
  const std::size_t end = p_ + word.size();
  return here(word) && !(end < text_.size() && is_word(text_[end]));
}

void ProgramText::skip() {
  for (; p_ < text_.size(); ++p_) {
    if (here("//")) {
      p_ = std::min(text_.find('\n', p_), text_.size() - 1);
    } else if (here("/*")) {
      p_ = std::min(text_.find("*/", p_ + 2), text_.size() - 2) + 1;
    } else if (!(text_[p_] == ' ' || (text_[p_] >= '\t' && text_[p_] <= '\r'))) {
      return;
    }
  }
}

bool ProgramText::take(char c) {
  if (here() != c || at_end()) return false;
  ++p_;
  return true;
}

std::string_view ProgramText::word() {
  const std::size_t start = p_;
  while (p_ < text_.size() && is_word(text_[p_])) ++p_;
  return text_.substr(start, p_ - start);
}

bool ProgramText::modifiers() {
  bool disabled = false;
  for (; !at_end() && std::string_view("%#!*").find(here()) != std::string_view::npos; skip()) {
    disabled = disabled || here() == '*';
    ++p_;
  }
  return disabled;
}

bool ProgramText::assigns() {
  const std::size_t start = p_;
  skip();
  const bool yes = here("=") && !here("==");
  if (!yes) p_ = start;
  return yes;
}

void ProgramText::brackets() {
  int depth = 0;
  for (; !at_end(); skip()) {
    const char c = here();
    if (c == '(' || c == '[' || c == '{') ++depth;
    if (c == ')' || c == ']' || c == '}') --depth;
    next();
    if (depth == 0) return;
  }
}

void ProgramText::round() {
  if (here() == '(') brackets();
}

void ProgramText::to_end(bool block) {
  for (skip(); !at_end(); skip()) {
    const char c = here();
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

void ProgramText::behind(char c) { p_ = std::min(text_.find(c, p_), text_.size() - 1) + 1; }

void ProgramText::next() {
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

}  // namespace burin::detail
