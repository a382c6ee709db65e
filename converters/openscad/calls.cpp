#include "calls.h"

#include "program_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace burin::detail {
namespace {

// The first point of a mark; no mark of burin.scad, and no point that a model would have.
constexpr std::array kCallSign = {0.161803, 0.577216, 0.693147};
// The first number of a call: all have six digits, so that what is alike has texts alike.
constexpr std::size_t kFirstNumber = 100'000, kMostCalls = 800'000;
// Statements within each other: more is no program that anyone has written.
constexpr int kDeepestStatement = 200;

/// OpenSCAD's modules that show their children as they are, each for itself.
bool keeps_apart(std::string_view name) {
  constexpr std::array<std::string_view, 15> kApart = {
      "assert", "assign", "child", "children", "color",      "echo",   "else",     "for",
      "group",  "if",     "let",   "mirror",   "multmatrix", "rotate", "translate"};
  return name == "scale" || std::ranges::find(kApart, name) != kApart.end();
}

class Marker {
 public:
  explicit Marker(std::string_view program) : program_(program), text_(program) {}

  std::optional<MarkedProgram> run() {
    for (text_.skip(); !text_.at_end(); text_.skip()) {
      if (!statement(true)) return std::nullopt;
    }
    if (out_.calls.empty() || out_.calls.size() > kMostCalls) return std::nullopt;
    write();
    return std::move(out_);
  }

 private:
  struct Insertion {
    std::size_t at;
    std::string text;
  };

  /// One statement, to behind its end; false where it is none. `report`: calls in it are marked.
  bool statement(bool report) {
    if (depth_ == kDeepestStatement) return false;
    ++depth_;
    const bool good = any(report);
    --depth_;
    return good;
  }

  bool any(bool report) {
    name_ = {};
    text_.skip();
    if (text_.take(';')) return true;
    if (text_.take('{')) return block(report);
    text_.modifiers();
    const std::size_t start = text_.at();
    const std::string_view first = text_.word();
    if (first.empty()) return false;
    if (first == "include" || first == "use") {
      text_.behind('>');
      return true;
    }
    if (first == "module") return definition();
    if (first == "function" || text_.assigns()) {
      text_.to_end(false);
      return true;
    }
    return call(first, start, report);
  }

  bool block(bool report) {
    for (text_.skip(); !text_.take('}'); text_.skip()) {
      if (text_.at_end() || !statement(report)) return false;
    }
    name_ = {};
    return true;
  }

  bool definition() {
    text_.skip();
    const std::string_view name = text_.word();
    // The marks are made of these.
    if (name == "polyhedron" || name == "group") return false;
    text_.skip();
    text_.round();
    const bool outer = in_module_;
    in_module_ = true;
    const bool good = statement(true);
    in_module_ = outer;
    return good;
  }

  bool call(std::string_view first, std::size_t start, bool report) {
    const bool own = is_own_module(first);
    text_.skip();
    if (text_.here() != '(') return false;
    text_.brackets();
    if (!statement(report && (!own || keeps_apart(first)))) return false;
    if (first == "if") {
      const std::string_view name = name_;
      const std::size_t end = text_.at();
      text_.skip();
      if (text_.here_word("else")) {
        text_.word();
        if (!statement(report)) return false;
      } else {
        text_ = ProgramText(program_, end);
      }
      name_ = name;
    }
    if (own) return true;
    if (name_.empty()) name_ = first;
    if (report) mark(start, first);
    return true;
  }

  void mark(std::size_t start, std::string_view module) {
    insertions_.push_back(
        {start, fmt::format("group(){{polyhedron([[{},{},{}],[{},0,0]],[]);", kCallSign[0],
                            kCallSign[1], kCallSign[2], kFirstNumber + out_.calls.size())});
    insertions_.push_back({text_.at(), "}"});
    out_.calls.push_back({std::string(name_), std::string(module), in_module_});
  }

  void write() {
    // What begins at one place is told last that stands outermost; ends are alike.
    std::ranges::stable_sort(insertions_, {}, &Insertion::at);
    std::size_t from = 0;
    for (const Insertion& i : insertions_) {
      out_.text.append(program_, from, i.at - from);
      out_.text += i.text;
      from = i.at;
    }
    out_.text.append(program_, from);
  }

  std::string_view program_;
  ProgramText text_;
  MarkedProgram out_;
  std::vector<Insertion> insertions_;
  /// Of the innermost module of the statement that was read last.
  std::string_view name_;
  bool in_module_ = false;
  int depth_ = 0;
};

/// The number of a call that a polyhedron() says; -1 where it is no mark.
std::int32_t mark_of(const csg::Node& node, std::size_t calls) {
  if (node.module != csg::Module::Polyhedron) return -1;
  const csg::Value* points = node.argument("points");
  if (!points || points->list.size() != 2) return -1;
  const auto& sign = points->list[0].list;
  if (sign.size() != 3 || points->list[1].list.empty()) return -1;
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::abs(sign[i].number - kCallSign[i]) > 1e-9) return -1;
  }
  const double number = points->list[1].list[0].number - static_cast<double>(kFirstNumber);
  return number >= 0 && number < static_cast<double>(calls) ? static_cast<std::int32_t>(number)
                                                            : -1;
}

}  // namespace

std::optional<MarkedProgram> mark_calls(std::string_view program) { return Marker(program).run(); }

TreeCalls take_calls(csg::Tree& tree, std::vector<ModuleCall> calls) {
  TreeCalls out{std::move(calls), {}};
  std::vector<csg::Node>& nodes = tree.nodes;
  std::vector<std::uint32_t> moved(nodes.size() + 1);
  std::uint32_t kept = 0;
  for (std::uint32_t n = 0; n < nodes.size(); ++n) {
    moved[n] = kept;
    const std::int32_t call = mark_of(nodes[n], out.calls.size());
    if (call >= 0 && n > 0) {
      // It is the first child of the group before it.
      out.of[kept - 1] = call;
      std::fill(tree.source.begin() + static_cast<std::ptrdiff_t>(nodes[n].begin),
                tree.source.begin() + static_cast<std::ptrdiff_t>(nodes[n].finish), ' ');
      continue;
    }
    out.of.push_back(-1);
    if (kept != n) nodes[kept] = std::move(nodes[n]);
    ++kept;
  }
  moved[nodes.size()] = kept;
  nodes.resize(kept);
  for (csg::Node& node : nodes) node.end = moved[node.end];
  return out;
}

}  // namespace burin::detail
