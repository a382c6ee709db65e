#pragma once
// The functions of the text form.

#include <burin/forms/implicit/expression.h>

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace burin::implicit_text {

// What an argument of a function has to be.
struct Word {
  std::string_view name;
  // As the user reads it, e.g. "translate(f, x, y, z)".
  std::string_view usage;
  // Leading arguments that may be any formula; the rest are numbers.
  std::size_t formulas = 0;
  // How many arguments; `any` = that many or more, all formulas.
  std::size_t count = 0;
  bool any = false;
  Expression (*make)(std::span<const Expression> formulas,
                     std::span<const double> numbers) = nullptr;
};

// nullptr where there is no such function.
const Word* find_word(std::string_view name);
std::vector<std::string> word_names();

}  // namespace burin::implicit_text
