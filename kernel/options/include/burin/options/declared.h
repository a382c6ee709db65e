#pragma once
/// Options that rows of catalogues declare themselves: those of plug-ins and of formats. A struct
/// holds the values of all of them in one member.

#include <burin/options/row.h>

#include <concepts>
#include <map>
#include <span>
#include <string>
#include <string_view>
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

/// A plain struct that is read from declared values: the row that declares its members, and an
/// option for each.
template <class T>
concept Declared = requires {
  { T::kRow } -> std::convertible_to<std::string_view>;
  { T::rows() } -> std::same_as<std::vector<OptionRow<T>>>;
};

/// What the row of a struct declares; its defaults are the values that hold where none is given.
template <Declared T>
std::vector<DeclaredOption> declared() {
  std::vector<DeclaredOption> out;
  for (const OptionRow<T>& row : T::rows()) out.push_back({row, row.get(T{})});
  return out;
}

/// The struct that values stand for. Cost: a look-up by name for each member, so call it once.
template <Declared T>
T values_in(const DeclaredValues& values) {
  T out{};
  for (const OptionRow<T>& row : T::rows()) {
    row.set(out, value_of(values, T::kRow, {row, row.get(out)}));
  }
  return out;
}

/// Sets all values of a struct: `values_in` gives it back.
template <Declared T>
void put(DeclaredValues& values, const T& from) {
  const T fallback{};
  for (const OptionRow<T>& row : T::rows()) {
    set_value(values, T::kRow, {row, row.get(fallback)}, row.get(from));
  }
}

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
