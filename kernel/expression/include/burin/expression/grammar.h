#pragma once
/// The grammar of formulas, whatever they are made into: sum -> product -> signed -> power -> atom.

#include <burin/base/error.h>
#include <burin/expression/lexer.h>

#include <string>
#include <string_view>
#include <utility>

namespace burin::expression {

/// A word of a text in quotes, for messages; of long ones the beginning.
std::string in_quotes(std::string_view text);
std::string shown(const Token& token);
constexpr std::size_t kShownName = 40;  // letters

/// Recursive descent. `Self` derives from it and makes the values: `number(double)`,
/// `negated(value)`, `joined(sign, a, b)` for + - * / ^, `named(token)`, and `called(token)`, which
/// stands before the "(" and takes it. -x^2 is -(x^2), 2^-3 is allowed, 2^3^2 is 2^(3^2). Errors
/// are InputErrors with line and column; UsageErrors of `joined` get theirs.
template <class Self, class Value>
class Grammar {
 protected:
  Grammar(std::string_view text, const std::string& file) : file_(file), lexer_(text, file) {
    token_ = lexer_.next();
    ahead_ = lexer_.next();
  }

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
      fail_at(file_, token_.place,
              "'" + std::string(sign) + "' expected " + where + ", not " + shown(token_));
    }
    take();
  }

  Value sum() {
    const Nesting nesting(*this);
    Value value = product();
    while (is("+") || is("-")) {
      const Token sign = take();
      Value right = product();
      value = at(sign.place, [&] { return self().joined(sign.text.front(), value, right); });
    }
    return value;
  }

  // Errors of what is made get their place.
  template <class Make>
  Value at(TextPlace place, const Make& make) {
    try {
      return make();
    } catch (const UsageError& e) {
      fail_at(file_, place, e.what());
    }
  }

  const std::string& file_;
  Lexer lexer_;
  Token token_, ahead_;

 private:
  static constexpr int kMaxNesting = 200;

  Self& self() { return static_cast<Self&>(*this); }

  Value product() {
    Value value = signed_value();
    while (is("*") || is("/")) {
      const Token sign = take();
      Value right = signed_value();
      value = at(sign.place, [&] { return self().joined(sign.text.front(), value, right); });
    }
    return value;
  }

  Value signed_value() {
    const Nesting nesting(*this);
    if (is("+")) {
      take();
      return signed_value();
    }
    if (is("-")) {
      take();
      return self().negated(signed_value());
    }
    Value base = atom();
    if (!is("^")) return base;
    const Token sign = take();
    Value exponent = signed_value();
    return at(sign.place, [&] { return self().joined('^', base, exponent); });
  }

  Value atom() {
    if (token_.kind == TokenKind::Number) return self().number(take().number);
    if (is("(")) {
      take();
      Value inner = sum();
      expect(")", "here");
      return inner;
    }
    if (token_.kind != TokenKind::Name) {
      fail_at(file_, token_.place, "a number, a name or '(' expected, not " + shown(token_));
    }
    const Token name = take();
    return is("(") ? self().called(name) : self().named(name);
  }

  // Counts how deep the descent is: the stack has an end.
  class Nesting {
   public:
    explicit Nesting(Grammar& grammar) : grammar_(grammar) {
      if (++grammar_.nesting_ > 2 * kMaxNesting) {
        fail_at(grammar_.file_, grammar_.token_.place,
                "nested more than " + std::to_string(kMaxNesting) +
                    " deep; give parts names of their own");
      }
    }
    ~Nesting() { --grammar_.nesting_; }
    Nesting(const Nesting&) = delete;
    Nesting& operator=(const Nesting&) = delete;

   private:
    Grammar& grammar_;
  };

  int nesting_ = 0;
};

}  // namespace burin::expression
