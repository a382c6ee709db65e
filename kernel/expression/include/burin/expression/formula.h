#pragma once
/// Formulas of numbers that a user writes: "0.5 + 0.5 * sin(40 * u)".

#include <cstddef>
#include <cstdint>
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
  /// Throws UsageError, "column 5: ...", where the text is none, is longer than 4,000 characters or
  /// has more than 250 operations.
  Formula(std::string_view text, std::span<const std::string_view> variables);

  /// Its value where the variables have these, in their order; may be no finite number. Costs some
  /// nanoseconds an operation; from many threads.
  double operator()(std::span<const double> values) const;
  /// Whether a variable, by its place in the list, stands in it.
  bool uses(std::size_t variable) const;
  /// Whether it is this number whatever the variables are.
  bool is(double value) const;

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
      Call
    };
    Op op = Op::Number;
    double number = 0;
    std::uint16_t a = 0, b = 0, c = 0;  // steps before; of Variable `a`, its place in the list
    double (*call)(double, double, double) = nullptr;
  };

 private:
  std::vector<Step> steps_;
};

}  // namespace burin::expression
