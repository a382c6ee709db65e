#include <burin/base/error.h>
#include <burin/base/nearest.h>
#include <burin/base/rng.h>
#include <burin/expression/formula.h>
#include <burin/expression/grammar.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace burin::expression {
namespace {

constexpr std::size_t kMaxText = 4000;
constexpr std::size_t kMaxSteps = 250;

double lattice(double x, double y, double z) {
  const auto whole = [](double a) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(a));
  };
  return Rng(whole(x), whole(y), whole(z)).uniform(0);
}

// Random numbers at whole coordinates, smoothly joined. @cite Perlin1985
double noise(double x, double y, double z) {
  constexpr double kFar = 1e15;  // beyond, doubles have no fraction
  if (!(std::abs(x) < kFar && std::abs(y) < kFar && std::abs(z) < kFar)) return 0.5;
  const std::array<double, 3> p{x, y, z};
  std::array<double, 3> low{}, t{};
  for (std::size_t i = 0; i < 3; ++i) {
    low[i] = std::floor(p[i]);
    const double s = p[i] - low[i];
    t[i] = s * s * (3 - 2 * s);
  }
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const int i = corner & 1, j = (corner >> 1) & 1, k = corner >> 2;
    const double weight = (i ? t[0] : 1 - t[0]) * (j ? t[1] : 1 - t[1]) * (k ? t[2] : 1 - t[2]);
    sum += weight * lattice(low[0] + i, low[1] + j, low[2] + k);
  }
  return sum;
}

struct Function {
  std::string_view name, usage;
  std::size_t count;
  double (*call)(double, double, double);
};

constexpr std::array kFunctions{
    Function{"sqrt", "sqrt(x)", 1, [](double x, double, double) { return std::sqrt(x); }},
    Function{"exp", "exp(x)", 1, [](double x, double, double) { return std::exp(x); }},
    Function{"log", "log(x)", 1, [](double x, double, double) { return std::log(x); }},
    Function{"sin", "sin(x)", 1, [](double x, double, double) { return std::sin(x); }},
    Function{"cos", "cos(x)", 1, [](double x, double, double) { return std::cos(x); }},
    Function{"tan", "tan(x)", 1, [](double x, double, double) { return std::tan(x); }},
    Function{"asin", "asin(x)", 1, [](double x, double, double) { return std::asin(x); }},
    Function{"acos", "acos(x)", 1, [](double x, double, double) { return std::acos(x); }},
    Function{"atan", "atan(x)", 1, [](double x, double, double) { return std::atan(x); }},
    Function{"atan2", "atan2(y, x)", 2,
             [](double y, double x, double) { return std::atan2(y, x); }},
    Function{"abs", "abs(x)", 1, [](double x, double, double) { return std::abs(x); }},
    Function{"floor", "floor(x)", 1, [](double x, double, double) { return std::floor(x); }},
    Function{"round", "round(x)", 1, [](double x, double, double) { return std::round(x); }},
    Function{"min", "min(a, b)", 2, [](double a, double b, double) { return std::min(a, b); }},
    Function{"max", "max(a, b)", 2, [](double a, double b, double) { return std::max(a, b); }},
    Function{"mod", "mod(x, period)", 2,
             [](double x, double period, double) { return x - period * std::floor(x / period); }},
    Function{"step", "step(x)", 1, [](double x, double, double) { return x > 0 ? 1.0 : 0.0; }},
    Function{"clamp", "clamp(x, low, high)", 3,
             [](double x, double low, double high) { return std::max(low, std::min(x, high)); }},
    Function{"mix", "mix(a, b, share)", 3,
             [](double a, double b, double share) { return a + share * (b - a); }},
    Function{"noise", "noise(x, y, z)", 3, noise},
};

using Step = Formula::Step;
using Value = std::uint16_t;

class Parser : public Grammar<Parser, Value> {
 public:
  Parser(std::string_view text, std::span<const std::string_view> variables,
         std::span<const std::string_view> outside)
      : Grammar(text, kNowhere), variables_(variables), outside_(outside) {}

  std::vector<Step> steps() {
    sum();
    if (token_.kind != TokenKind::End) {
      fail_at(file_, token_.place, fmt::format("{} after the formula", shown(token_)));
    }
    return std::move(steps_);
  }

  Value number(double value) { return add({.op = Step::Op::Number, .number = value}); }
  Value negated(Value a) { return add({.op = Step::Op::Negate, .a = a}); }
  Value joined(char sign, Value a, Value b) {
    const auto op = sign == '+'   ? Step::Op::Add
                    : sign == '-' ? Step::Op::Subtract
                    : sign == '*' ? Step::Op::Multiply
                    : sign == '/' ? Step::Op::Divide
                                  : Step::Op::Power;
    return add({.op = op, .a = a, .b = b});
  }
  Value named(const Token& name) {
    if (name.text == "pi") return number(std::numbers::pi);
    const auto it = std::ranges::find(variables_, name.text);
    if (it != variables_.end()) {
      return add({.op = Step::Op::Variable, .a = static_cast<Value>(it - variables_.begin())});
    }
    if (const Function* f = find(name.text)) {
      fail_at(file_, name.place,
              fmt::format("{} is a function; write {}", in_quotes(name.text), f->usage));
    }
    std::vector<std::string> known(variables_.begin(), variables_.end());
    known.emplace_back("pi");
    fail_at(
        file_, name.place,
        fmt::format("unknown name {}; there are {}", in_quotes(name.text), fmt::join(known, ", ")));
  }
  Value called(const Token& name) {
    const auto own = std::ranges::find(outside_, name.text);
    if (own != outside_.end()) {
      take();  // (
      const std::string usage = fmt::format("{}(a, b)", name.text);
      const Value a = sum();
      expect(",", fmt::format("in {}", usage));
      const Value b = sum();
      expect(")", fmt::format("at the end of {}", usage));
      return add({.op = Step::Op::Outside,
                  .a = a,
                  .b = b,
                  .c = static_cast<Value>(own - outside_.begin())});
    }
    const Function* f = find(name.text);
    if (f == nullptr) {
      std::vector<std::string> known;
      for (const Function& one : kFunctions) known.emplace_back(one.name);
      known.insert(known.end(), outside_.begin(), outside_.end());
      fail_at(file_, name.place,
              fmt::format("unknown function {}; the nearest is '{}'", in_quotes(name.text),
                          nearest(name.text.substr(0, kShownName), known)));
    }
    take();  // (
    std::array<Value, 3> of{};
    for (std::size_t i = 0; i < f->count; ++i) {
      if (i > 0) expect(",", fmt::format("in {}", f->usage));
      of[i] = sum();
    }
    expect(")", fmt::format("at the end of {}", f->usage));
    return add({.op = Step::Op::Call, .a = of[0], .b = of[1], .c = of[2], .call = f->call});
  }

 private:
  static const Function* find(std::string_view name) {
    const auto* it = std::ranges::find(kFunctions, name, &Function::name);
    return it == kFunctions.end() ? nullptr : it;
  }
  Value add(const Step& step) {
    if (steps_.size() == kMaxSteps) {
      fail_at(file_, token_.place, fmt::format("more than {} operations", kMaxSteps));
    }
    steps_.push_back(step);
    return static_cast<Value>(steps_.size() - 1);
  }

  static inline const std::string kNowhere;
  std::span<const std::string_view> variables_, outside_;
  std::vector<Step> steps_;
};

}  // namespace

std::string in_quotes(std::string_view text) {
  return fmt::format("'{}{}'", text.substr(0, kShownName), text.size() > kShownName ? "..." : "");
}

std::string shown(const Token& token) {
  return token.kind == TokenKind::End ? "the end of the file" : in_quotes(token.text);
}

Formula::Formula(std::string_view text, std::span<const std::string_view> variables,
                 std::span<const std::string_view> outside) {
  if (text.size() > kMaxText) {
    throw UsageError(fmt::format("the formula is longer than {} characters", kMaxText));
  }
  try {
    steps_ = Parser(text, variables, outside).steps();
  } catch (const InputError& e) {
    throw UsageError(e.what());
  }
}

double Formula::operator()(std::span<const double> values, const Outside& outside) const {
  std::array<double, kMaxSteps> of;  // NOLINT: each is written before it is read
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const Step& s = steps_[i];
    switch (s.op) {
      case Step::Op::Number:
        of[i] = s.number;
        break;
      case Step::Op::Variable:
        of[i] = values[s.a];
        break;
      case Step::Op::Negate:
        of[i] = -of[s.a];
        break;
      case Step::Op::Add:
        of[i] = of[s.a] + of[s.b];
        break;
      case Step::Op::Subtract:
        of[i] = of[s.a] - of[s.b];
        break;
      case Step::Op::Multiply:
        of[i] = of[s.a] * of[s.b];
        break;
      case Step::Op::Divide:
        of[i] = of[s.a] / of[s.b];
        break;
      case Step::Op::Power:
        of[i] = std::pow(of[s.a], of[s.b]);
        break;
      case Step::Op::Call:
        of[i] = s.call(of[s.a], of[s.b], of[s.c]);
        break;
      case Step::Op::Outside:
        of[i] = outside(s.c, of[s.a], of[s.b]);
        break;
    }
  }
  return of[steps_.size() - 1];
}

bool Formula::uses(std::size_t variable) const {
  return std::ranges::any_of(
      steps_, [&](const Step& s) { return s.op == Step::Op::Variable && s.a == variable; });
}

bool Formula::calls_outside() const {
  return std::ranges::any_of(steps_, [](const Step& s) { return s.op == Step::Op::Outside; });
}

bool Formula::is(double value) const {
  return steps_.size() == 1 && steps_[0].op == Step::Op::Number && steps_[0].number == value;
}

}  // namespace burin::expression
