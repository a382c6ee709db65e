#include "source_names.h"

#include "program_text.h"

#include <optional>

namespace burin::detail {
namespace {

// Blocks within each other that are looked into: each is read once for every one around it.
constexpr int kDeepestBlock = 8;

/// One statement that may make an object.
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
    for (text_.skip(); !text_.at_end(); text_.skip()) {
      if (!add_statement(out, 0)) return std::nullopt;
    }
    return out;
  }

 private:
  /// False where the text is not understood.
  bool add_statement(std::vector<Statement>& out, int depth) {
    if (text_.take(';')) return true;
    const bool disabled = text_.modifiers();
    const std::string_view first = text_.word();
    if (first.empty() || first == "include") return false;
    if (first == "use") {
      text_.behind('>');
    } else if (first == "module" || first == "function") {
      if (first == "module") word_after_space();
      text_.to_end(first == "module");
    } else if (text_.assigns()) {
      text_.to_end(false);
    } else if (first == "echo" || first == "assert") {
      // echo() and assert() may have a statement behind them, which is one of its own.
      text_.skip();
      text_.round();
    } else {
      Statement s = statement(first, depth);
      if (!disabled) out.push_back(std::move(s));
    }
    return true;
  }

  /// From behind the first word to the end of the statement.
  Statement statement(std::string_view first, int depth) {
    Statement out;
    out.condition = first == "if";
    for (std::string_view name = first; !name.empty(); name = text_.word()) {
      // The innermost: what stands before it moves or colours it.
      if (!is_own_module(name)) out.name = name;
      text_.skip();
      text_.round();
      text_.skip();
      text_.modifiers();
      text_.skip();
    }
    if (out.name.empty()) out.name = name_in_block(depth);
    end_of_statement();
    for (text_.skip(); out.condition && text_.here_word("else"); text_.skip()) {
      text_.word();
      text_.skip();
      end_of_statement();
    }
    return out;
  }

  /// The name of the one statement of the block that begins here; empty where there are several.
  std::string name_in_block(int depth) {
    const ProgramText here = text_;
    std::vector<Statement> inside;
    bool good = depth < kDeepestBlock && text_.take('{');
    for (text_.skip(); good && !text_.at_end() && text_.here() != '}'; text_.skip()) {
      good = add_statement(inside, depth + 1) && inside.size() < 2;
    }
    text_ = here;
    return good && inside.size() == 1 ? inside.front().name : std::string();
  }

  /// A block, or all up to the next semicolon.
  void end_of_statement() {
    text_.skip();
    if (text_.here() == '{') {
      text_.brackets();
    } else {
      text_.to_end(true);
    }
  }
  void word_after_space() {
    text_.skip();
    text_.word();
  }

  ProgramText text_;
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
