// Recursive descent: sum -> product -> signed -> power -> atom.

#include <burin/base/error.h>
#include <burin/base/nearest.h>
#include <burin/converters/implicit_reader.h>

#include "lexer.h"
#include "vocabulary.h"

#include <fmt/format.h>

#include <map>
#include <vector>

namespace burin {
namespace {

using implicit_text::fail;
using implicit_text::Place;
using implicit_text::Token;
using implicit_text::TokenKind;
using implicit_text::Word;

constexpr int kMaxNesting = 200;
constexpr std::size_t kMaxText = 1 << 20;
constexpr std::size_t kMaxArguments = 10'000;
constexpr std::size_t kShownName = 40;  // letters of a word that an error repeats

std::string in_quotes(std::string_view text) {
  return fmt::format("'{}{}'", text.substr(0, kShownName), text.size() > kShownName ? "..." : "");
}

std::string shown(const Token& t) {
  return t.kind == TokenKind::End ? "the end of the file" : in_quotes(t.text);
}

class Parser {
 public:
  Parser(std::string_view text, const std::string& file) : file_(file), lexer_(text, file) {
    token_ = lexer_.next();
    ahead_ = lexer_.next();
  }

  Expression file() {
    for (;;) {
      if (token_.kind == TokenKind::End) {
        fail(file_, token_.place, "no function; end the file with the expression to be drawn");
      }
      if (token_.kind == TokenKind::Name && ahead_.kind == TokenKind::Sign && ahead_.text == "=") {
        definition();
        continue;
      }
      Expression result = sum();
      if (is(";")) take();
      if (token_.kind != TokenKind::End) {
        fail(file_, token_.place,
             fmt::format("{} after the last expression; the file ends with it", shown(token_)));
      }
      return result;
    }
  }

 private:
  bool is(std::string_view sign) const {
    return token_.kind == TokenKind::Sign && token_.text == sign;
  }
  Token take() {
    const Token t = token_;
    token_ = ahead_;
    if (token_.kind != TokenKind::End) ahead_ = lexer_.next();
    return t;
  }
  void expect(std::string_view sign, const std::string& where) {
    if (!is(sign)) {
      fail(file_, token_.place,
           fmt::format("'{}' expected {}, not {}", sign, where, shown(token_)));
    }
    take();
  }

  void definition() {
    const Token name = take();
    const std::string text(name.text);
    if (text == "x" || text == "y" || text == "z" || text == "pi" ||
        implicit_text::find_word(text) != nullptr) {
      fail(file_, name.place,
           fmt::format("{} has a meaning already; take another name", in_quotes(text)));
    }
    if (names_.contains(text)) {
      fail(file_, name.place, fmt::format("{} is defined twice", in_quotes(text)));
    }
    take();  // =
    const Expression value = sum();
    expect(";", fmt::format("after the definition of {}", in_quotes(text)));
    names_.emplace(text, value);
  }

  Expression sum() {
    const Nesting nesting(*this);
    Expression value = product();
    while (is("+") || is("-")) {
      const Token sign = take();
      const Expression right = product();
      value = at(sign.place, [&] { return sign.text == "+" ? value + right : value - right; });
    }
    return value;
  }

  Expression product() {
    Expression value = signed_value();
    while (is("*") || is("/")) {
      const Token sign = take();
      const Expression right = signed_value();
      value = at(sign.place, [&] { return sign.text == "*" ? value * right : value / right; });
    }
    return value;
  }

  // -x^2 is -(x^2), 2^-3 is allowed, 2^3^2 is 2^(3^2).
  Expression signed_value() {
    const Nesting nesting(*this);
    if (is("+")) {
      take();
      return signed_value();
    }
    if (is("-")) {
      take();
      return -signed_value();
    }
    Expression base = atom();
    if (!is("^")) return base;
    const Token sign = take();
    const Expression exponent = signed_value();
    return at(sign.place, [&] { return implicit::pow(base, exponent); });
  }

  Expression atom() {
    if (token_.kind == TokenKind::Number) return take().number;
    if (is("(")) {
      take();
      Expression inner = sum();
      expect(")", "here");
      return inner;
    }
    if (token_.kind != TokenKind::Name) {
      fail(file_, token_.place,
           fmt::format("a number, a name or '(' expected, not {}", shown(token_)));
    }
    const Token name = take();
    if (is("(")) return call(name);
    if (name.text == "x") return Expression::x();
    if (name.text == "y") return Expression::y();
    if (name.text == "z") return Expression::z();
    if (name.text == "pi") return 3.14159265358979323846;
    const auto it = names_.find(std::string(name.text));
    if (it != names_.end()) return it->second;
    if (const Word* word = implicit_text::find_word(name.text)) {
      fail(file_, name.place,
           fmt::format("{} is a function; write {}", in_quotes(name.text), word->usage));
    }
    unknown(name, false);
  }

  Expression call(const Token& name) {
    const Word* word = implicit_text::find_word(name.text);
    if (!word) {
      if (names_.contains(std::string(name.text)) || name.text == "x" || name.text == "y" ||
          name.text == "z" || name.text == "pi") {
        fail(file_, name.place,
             fmt::format("{} is no function; it takes no (", in_quotes(name.text)));
      }
      unknown(name, true);
    }
    take();  // (
    std::vector<Expression> formulas;
    std::vector<double> numbers;
    if (!is(")")) {
      for (;;) {
        const Place place = token_.place;
        const Expression value = sum();
        const std::size_t index = formulas.size() + numbers.size();
        if (word->any || index < word->formulas) {
          formulas.push_back(value);
        } else if (index < word->count) {
          numbers.push_back(number(value, place, *word));
        } else {
          fail(file_, place, fmt::format("too many arguments; write {}", word->usage));
        }
        if (index > kMaxArguments) fail(file_, place, "more than 10,000 arguments");
        if (!is(",")) break;
        take();
      }
    }
    if (formulas.size() + numbers.size() < word->count && is(")")) {
      fail(file_, name.place, fmt::format("too few arguments; write {}", word->usage));
    }
    expect(")", fmt::format("at the end of {}", word->usage));
    return at(name.place, [&] { return word->make(formulas, numbers); });
  }

  double number(const Expression& value, Place place, const Word& word) {
    const Box3 nowhere{Vec3(0), Vec3(0)};
    if (!is_constant(value)) {
      fail(file_, place, fmt::format("a number expected, without x, y and z: {}", word.usage));
    }
    const double v = make_function(value)->range(nowhere).min;
    if (!(v > -1e300 && v < 1e300)) fail(file_, place, "this number is not finite");
    return v;
  }
  // Constants fold, so that formulas without variables have no operations.
  static bool is_constant(const Expression& e) {
    const bool variable = e.node() == Expression::x().node() ||
                          e.node() == Expression::y().node() || e.node() == Expression::z().node();
    return e.depth() == 0 && !variable;
  }

  // Errors of the vocabulary get their place.
  template <class Make>
  Expression at(Place place, const Make& make) {
    try {
      return make();
    } catch (const UsageError& e) {
      fail(file_, place, e.what());
    }
  }

  [[noreturn]] void unknown(const Token& name, bool function) {
    std::vector<std::string> known = implicit_text::word_names();
    if (!function) {
      known = {"x", "y", "z", "pi"};
      for (const auto& [text, value] : names_) known.push_back(text);
    }
    fail(file_, name.place,
         fmt::format("unknown {} {}; the nearest is '{}'", function ? "function" : "name",
                     in_quotes(name.text), nearest(name.text.substr(0, kShownName), known)));
  }

  // Counts how deep the descent is: the stack has an end.
  class Nesting {
   public:
    explicit Nesting(Parser& p) : parser_(p) {
      if (++parser_.nesting_ > 2 * kMaxNesting) {
        fail(parser_.file_, parser_.token_.place,
             fmt::format("nested more than {} deep; give parts names of their own", kMaxNesting));
      }
    }
    ~Nesting() { --parser_.nesting_; }
    Nesting(const Nesting&) = delete;
    Nesting& operator=(const Nesting&) = delete;

   private:
    Parser& parser_;
  };

  const std::string& file_;
  implicit_text::Lexer lexer_;
  Token token_, ahead_;
  std::map<std::string, Expression> names_;
  int nesting_ = 0;
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
