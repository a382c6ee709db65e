#pragma once
/// Options that rows of catalogues declare themselves: those of plug-ins. A struct holds the values
/// of all of them in one member.

#include <burin/options/row.h>

#include <map>
#include <span>
#include <string>
#include <vector>

namespace burin {

/// An option by its name alone ("turns"), and the value that holds where none is given.
struct DeclaredOption {
  Option option;
  OptionValue fallback;
};

/// Values by "row.option" ("spiral.turns"); those that are as they were declared are not among
/// them.
struct DeclaredValues {
  std::map<std::string, OptionValue, std::less<>> changed;

  bool operator==(const DeclaredValues&) const = default;
};

OptionValue value_of(const DeclaredValues& values, std::string_view row,
                     const DeclaredOption& declared);

/// The values of all options of a row, in their order.
std::vector<OptionValue> values_of(const DeclaredValues& values, std::string_view row,
                                   std::span<const DeclaredOption> declared);

void set_value(DeclaredValues& values, std::string_view row, const DeclaredOption& declared,
               const OptionValue& value);

namespace options {

/// Appends an option row "row.option" for each option of each row of a catalogue.
template <class T, class Row>
void append_declared(std::vector<OptionRow<T>>& rows, DeclaredValues T::*member,
                     std::span<const Row> catalogue) {
  for (const Row& row : catalogue) {
    for (const DeclaredOption& declared : row.options) {
      const std::string name(row.name);
      Option option = declared.option;
      option.name = name + "." + option.name;
      rows.push_back(
          {std::move(option), [=](const T& s) { return value_of(s.*member, name, declared); },
           [=](T& s, const OptionValue& v) { set_value(s.*member, name, declared, v); }});
    }
  }
}

}  // namespace options
}  // namespace burin
