#pragma once
/// Formulas of numbers that a user writes: "0.5 + 0.5 * sin(40 * u)".

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace burin::expression {

/// A formula over variables by name: numbers, + - * / ^, parentheses, pi; sqrt exp log sin cos tan
/// asin acos atan atan2 abs floor round min max mod, step(x) (1 where x is more than 0, else 0),
/// clamp(x, low, high), mix(a, b, share) and noise(x, y, z) (smooth, in [0, 1], about 1 apart).
/// Immutable.
class Formula {
 public:
  /// A function of two numbers that the caller brings, by its place in the list of their names.
  using Outside = std::function<double(std::size_t, double, double)>;

  /// `outside`: names of functions of the caller. Throws UsageError, "column 5: ...", where the
  /// text is none, is longer than 4,000 characters or has more than 250 operations.
  Formula(std::string_view text, std::span<const std::string_view> variables,
          std::span<const std::string_view> outside = {});

  /// Its value where the variables have these, in their order; may be no finite number. `outside`
  /// is there where the formula may call it. Costs some nanoseconds an operation; from many
  /// threads.
  double operator()(std::span<const double> values, const Outside& outside = {}) const;
  /// Whether a variable, by its place in the list, stands in it.
  bool uses(std::size_t variable) const;
  /// Whether it is this number whatever the variables are.
  bool is(double value) const;
  /// Whether it calls any function of the caller's.
  bool calls_outside() const;

  struct Step {
    enum class Op : std::uint8_t {
      Number,
      Variable,
      Negate,
      Add,
      Subtract,
      Multiply,
      Divide,
      Power,
      Call,
      Outside
    };
    Op op = Op::Number;
    double number = 0;
    std::uint16_t a = 0, b = 0,
                  c = 0;  // steps before; of Variable `a`, of Outside `c`: place in the list
    double (*call)(double, double, double) = nullptr;
  };

 private:
  std::vector<Step> steps_;
};

}  // namespace burin::expression
