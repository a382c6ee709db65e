// What a .implicit file says, by the grammar of formulas.

#include <burin/base/error.h>
#include <burin/base/nearest.h>
#include <burin/converters/implicit_reader.h>
#include <burin/expression/grammar.h>

#include "vocabulary.h"

#include <fmt/format.h>

#include <map>
#include <vector>

namespace burin {
namespace {

using expression::in_quotes;
using expression::kShownName;
using expression::shown;
using expression::Token;
using expression::TokenKind;
using implicit_text::Word;

constexpr std::size_t kMaxText = 1 << 20;
constexpr std::size_t kMaxArguments = 10'000;

class Parser : public expression::Grammar<Parser, Expression> {
 public:
  Parser(std::string_view text, const std::string& file) : Grammar(text, file) {}

  Expression file() {
    for (;;) {
      if (token_.kind == TokenKind::End) {
        fail_at(file_, token_.place, "no function; end the file with the expression to be drawn");
      }
      if (token_.kind == TokenKind::Name && ahead_.kind == TokenKind::Sign && ahead_.text == "=") {
        definition();
        continue;
      }
      Expression result = sum();
      if (is(";")) take();
      if (token_.kind != TokenKind::End) {
        fail_at(file_, token_.place,
                fmt::format("{} after the last expression; the file ends with it", shown(token_)));
      }
      return result;
    }
  }

 private:
  friend Grammar;

  void definition() {
    const Token name = take();
    const std::string text(name.text);
    if (text == "x" || text == "y" || text == "z" || text == "pi" ||
        implicit_text::find_word(text) != nullptr) {
      fail_at(file_, name.place,
              fmt::format("{} has a meaning already; take another name", in_quotes(text)));
    }
    if (names_.contains(text)) {
      fail_at(file_, name.place, fmt::format("{} is defined twice", in_quotes(text)));
    }
    take();  // =
    const Expression value = sum();
    expect(";", fmt::format("after the definition of {}", in_quotes(text)));
    names_.emplace(text, value);
  }

  static Expression number(double value) { return value; }
  static Expression negated(const Expression& a) { return -a; }
  static Expression joined(char sign, const Expression& a, const Expression& b) {
    switch (sign) {
      case '+':
        return a + b;
      case '-':
        return a - b;
      case '*':
        return a * b;
      case '/':
        return a / b;
      default:
        return implicit::pow(a, b);
    }
  }

  Expression named(const Token& name) {
    if (name.text == "x") return Expression::x();
    if (name.text == "y") return Expression::y();
    if (name.text == "z") return Expression::z();
    if (name.text == "pi") return 3.14159265358979323846;
    const auto it = names_.find(std::string(name.text));
    if (it != names_.end()) return it->second;
    if (const Word* word = implicit_text::find_word(name.text)) {
      fail_at(file_, name.place,
              fmt::format("{} is a function; write {}", in_quotes(name.text), word->usage));
    }
    unknown(name, false);
  }

  Expression called(const Token& name) {
    const Word* word = implicit_text::find_word(name.text);
    if (!word) {
      if (names_.contains(std::string(name.text)) || name.text == "x" || name.text == "y" ||
          name.text == "z" || name.text == "pi") {
        fail_at(file_, name.place,
                fmt::format("{} is no function; it takes no (", in_quotes(name.text)));
      }
      unknown(name, true);
    }
    take();  // (
    std::vector<Expression> formulas;
    std::vector<double> numbers;
    if (!is(")")) {
      for (;;) {
        const TextPlace place = token_.place;
        const Expression value = sum();
        const std::size_t index = formulas.size() + numbers.size();
        if (word->any || index < word->formulas) {
          formulas.push_back(value);
        } else if (index < word->count) {
          numbers.push_back(constant(value, place, *word));
        } else {
          fail_at(file_, place, fmt::format("too many arguments; write {}", word->usage));
        }
        if (index > kMaxArguments) fail_at(file_, place, "more than 10,000 arguments");
        if (!is(",")) break;
        take();
      }
    }
    if (formulas.size() + numbers.size() < word->count && is(")")) {
      fail_at(file_, name.place, fmt::format("too few arguments; write {}", word->usage));
    }
    expect(")", fmt::format("at the end of {}", word->usage));
    return at(name.place, [&] { return word->make(formulas, numbers); });
  }

  double constant(const Expression& value, TextPlace place, const Word& word) {
    const Box3 nowhere{Vec3(0), Vec3(0)};
    if (!is_constant(value)) {
      fail_at(file_, place, fmt::format("a number expected, without x, y and z: {}", word.usage));
    }
    const double v = make_function(value)->range(nowhere).min;
    if (!(v > -1e300 && v < 1e300)) fail_at(file_, place, "this number is not finite");
    return v;
  }
  // Constants fold, so that formulas without variables have no operations.
  static bool is_constant(const Expression& e) {
    const bool variable = e.node() == Expression::x().node() ||
                          e.node() == Expression::y().node() || e.node() == Expression::z().node();
    return e.depth() == 0 && !variable;
  }

  [[noreturn]] void unknown(const Token& name, bool function) {
    std::vector<std::string> known = implicit_text::word_names();
    if (!function) {
      known = {"x", "y", "z", "pi"};
      for (const auto& [text, value] : names_) known.push_back(text);
    }
    fail_at(file_, name.place,
            fmt::format("unknown {} {}; the nearest is '{}'", function ? "function" : "name",
                        in_quotes(name.text), nearest(name.text.substr(0, kShownName), known)));
  }

  std::map<std::string, Expression> names_;
};

}  // namespace

Expression parse_implicit(std::string_view text, const std::string& file) {
  if (text.size() > kMaxText) {
    throw InputError("is larger than 1 MB, the most for a function; is it a file of another kind?",
                     file);
  }
  return Parser(text, file).file();
}

}  // namespace burin
