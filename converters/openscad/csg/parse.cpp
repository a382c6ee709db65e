#include <burin/base/error.h>

#include "text.h"
#include "tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>

namespace burin::csg {
namespace {

// Lists hold points and matrices: deeper ones are nonsense, and would exhaust the stack.
constexpr int kDeepestList = 8;
// So many nodes pass between two looks at the context.
constexpr std::size_t kPoll = 4096;

bool is_name(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '$';
}

class Parser {
 public:
  explicit Parser(Tree& tree) : tree_(tree), text_(tree.source) {}

  void run(RunContext& context) {
    tree_.nodes.emplace_back();  // the group of all
    std::vector<std::uint32_t> open;
    for (skip(); p_ < text_.size(); skip()) {
      if (tree_.nodes.size() % kPoll == 0) {
        context.progress(static_cast<double>(p_) / static_cast<double>(text_.size()));
      }
      if (text_[p_] == '}') {
        if (open.empty()) fail("a } that closes nothing");
        ++p_;
        close(open.back());
        open.pop_back();
        continue;
      }
      const auto node = static_cast<std::uint32_t>(tree_.nodes.size());
      head();
      skip();
      if (take(';')) {
        close(node);
      } else if (take('{')) {
        open.push_back(node);
      } else {
        fail(fmt::format("; or {{ expected behind {}()", name_of(tree_.nodes[node].module)));
      }
    }
    if (!open.empty()) {
      fail(fmt::format("the {{ of line {} is never closed", tree_.line_of(open.back())));
    }
    tree_.nodes[0].finish = text_.size();
    tree_.nodes[0].end = static_cast<std::uint32_t>(tree_.nodes.size());
  }

 private:
  void close(std::uint32_t node) {
    tree_.nodes[node].end = static_cast<std::uint32_t>(tree_.nodes.size());
    tree_.nodes[node].finish = p_;
  }

  /// Modifiers, name and arguments.
  void head() {
    Node node;
    for (;; skip()) {
      if (take('%'))
        node.background = true;
      else if (take('#'))
        node.highlight = true;
      else if (take('!'))
        node.root = true;
      else
        break;
    }
    node.begin = p_;
    node.module = module();
    skip();
    if (!take('(')) fail(fmt::format("( expected behind {}", name_of(node.module)));
    for (skip(); !take(')'); skip()) {
      node.arguments.push_back(argument());
      skip();
      if (p_ < text_.size() && text_[p_] == ')') continue;
      if (!take(','))
        fail(fmt::format(", or ) expected in the arguments of {}()", name_of(node.module)));
    }
    tree_.nodes.push_back(std::move(node));
  }

  Module module() {
    const std::string_view word = name();
    if (word.empty()) fail(fmt::format("the name of a module expected, not {}", here()));
    for (int m = 0; m <= static_cast<int>(Module::Multmatrix); ++m) {
      if (word == name_of(static_cast<Module>(m))) return static_cast<Module>(m);
    }
    fail(fmt::format("{} is no module of a tree that OpenSCAD has evaluated", in_quotes(word)));
  }

  Argument argument() {
    Argument out;
    const std::size_t start = p_;
    const std::string_view word = name();
    skip();
    if (!word.empty() && take('=')) {
      out.name = word;
      skip();
    } else {
      p_ = start;
    }
    out.value = value(0);
    return out;
  }

  Value value(int depth) {
    Value out;
    if (p_ >= text_.size()) fail("a value expected, not the end of the text");
    if (text_[p_] == '[') return list(depth);
    if (text_[p_] == '"') {
      out.kind = Value::Kind::String;
      out.text = string();
      return out;
    }
    if (const std::optional<bool> truth = word_of_truth()) {
      out.kind = Value::Kind::Bool;
      out.number = *truth ? 1 : 0;
      return out;
    }
    if (word("undef")) return out;
    out.kind = Value::Kind::Number;
    const char* end = scan_double(text_.data() + p_, text_.data() + text_.size(), out.number);
    if (!end) fail(fmt::format("a value expected, not {}", here()));
    p_ = static_cast<std::size_t>(end - text_.data());
    return out;
  }

  Value list(int depth) {
    if (depth == kDeepestList) fail("lists in lists in lists without end");
    Value out;
    out.kind = Value::Kind::List;
    ++p_;
    for (skip(); !take(']'); skip()) {
      out.list.push_back(value(depth + 1));
      skip();
      if (p_ < text_.size() && text_[p_] == ']') continue;
      if (!take(',')) fail("a list that is not closed");
    }
    return out;
  }

  /// OpenSCAD 2021.01 does not escape quotes within a text: it ends at a quote that an argument or
  /// the end of the arguments follows.
  std::string string() {
    const std::size_t start = ++p_;
    for (std::size_t at = text_.find('"', start); at != std::string_view::npos;
         at = text_.find('"', at + 1)) {
      p_ = at + 1;
      if (ends_string()) {
        p_ = at + 1;
        return std::string(text_.substr(start, at - start));
      }
    }
    p_ = start - 1;
    fail("a text that is not closed");
  }
  bool ends_string() {
    skip();
    if (p_ < text_.size() && (text_[p_] == ')' || text_[p_] == ']')) {
      ++p_;
      skip();
      return p_ < text_.size() &&
             (text_[p_] == ';' || text_[p_] == '{' || text_[p_] == ',' || text_[p_] == ')');
    }
    if (!take(',')) return false;
    skip();
    if (name().empty()) return false;
    skip();
    return take('=');
  }

  std::optional<bool> word_of_truth() {
    if (word("true")) return true;
    if (word("false")) return false;
    return std::nullopt;
  }
  bool word(std::string_view w) {
    if (!text_.substr(p_).starts_with(w)) return false;
    if (p_ + w.size() < text_.size() && is_name(text_[p_ + w.size()])) return false;
    p_ += w.size();
    return true;
  }
  std::string_view name() {
    const std::size_t start = p_;
    while (p_ < text_.size() && is_name(text_[p_])) ++p_;
    return text_.substr(start, p_ - start);
  }
  bool take(char c) {
    if (p_ >= text_.size() || text_[p_] != c) return false;
    ++p_;
    return true;
  }
  /// Blanks, ends of lines and comments.
  void skip() {
    for (; p_ < text_.size(); ++p_) {
      const char c = text_[p_];
      if (is_blank(c) || is_line_end(c)) continue;
      if (text_.substr(p_).starts_with("//")) {
        p_ = std::min(text_.find('\n', p_), text_.size() - 1);
      } else if (text_.substr(p_).starts_with("/*")) {
        const std::size_t close = text_.find("*/", p_ + 2);
        if (close == std::string_view::npos) fail("a comment that is not closed");
        p_ = close + 1;
      } else {
        return;
      }
    }
  }

  std::string here() const {
    if (p_ >= text_.size()) return "the end of the text";
    constexpr std::size_t kShown = 20;
    return in_quotes(text_.substr(p_, kShown));
  }
  [[noreturn]] void fail(const std::string& what) const {
    const std::size_t at = std::min(p_, text_.size());
    throw InputError(
        what, tree_.file,
        1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
  }

  Tree& tree_;
  std::string_view text_;
  std::size_t p_ = 0;
};

}  // namespace

Tree parse(std::string source, std::string file, RunContext& context) {
  Tree tree;
  tree.source = std::move(source);
  tree.file = std::move(file);
  Parser(tree).run(context);
  return tree;
}

}  // namespace burin::csg
