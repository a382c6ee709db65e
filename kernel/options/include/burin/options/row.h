#pragma once
/// Options of a struct: a row each with the way to the member. A module with options declares its
/// struct and its rows; larger structs are made of smaller ones, and so are their rows.

#include <burin/options/option.h>

#include <algorithm>
#include <concepts>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace burin {

template <class T>
struct OptionRow : Option {
  std::function<OptionValue(const T&)> get;
  /// The value is one that the option takes.
  std::function<void(T&, const OptionValue&)> set;
  /// Numbers: the row of the same struct whose value may not be less than this one's; empty: none.
  std::string at_most = {};
};

namespace options {

template <class T>
OptionRow<T> number(const std::string& name, double T::*member, const NumberRange& range,
                    const std::string& meaning, const std::string& at_most = {}) {
  return {{name, meaning, range},
          [member](const T& s) { return OptionValue(s.*member); },
          [member](T& s, const OptionValue& v) { s.*member = std::get<double>(v); },
          at_most};
}

template <class T>
OptionRow<T> flag(const std::string& name, bool T::*member, const std::string& meaning,
                  const Switch& words = {}) {
  return {{name, meaning, words},
          [member](const T& s) { return OptionValue(s.*member); },
          [member](T& s, const OptionValue& v) { s.*member = std::get<bool>(v); }};
}

template <class T>
OptionRow<T> direction(const std::string& name, Vec3 T::*member, const std::string& meaning) {
  return {{name, meaning, Direction{}},
          [member](const T& s) { return OptionValue(s.*member); },
          [member](T& s, const OptionValue& v) { s.*member = std::get<Vec3>(v); }};
}

/// `words` name the values of the enumeration from 0 on.
template <class T, class E>
requires std::is_enum_v<E> OptionRow<T> word(const std::string& name, E T::*member,
                                             const std::vector<std::string>& words,
                                             const std::string& meaning) {
  return {{name, meaning, WordList{words}},
          [member](const T& s) { return OptionValue(static_cast<std::uint64_t>(s.*member)); },
          [member](T& s, const OptionValue& v) {
            s.*member = static_cast<E>(std::get<std::uint64_t>(v));
          }};
}

/// The word itself is kept: names of rows of a catalogue. One that is none of them is told by
/// `first_fault`.
template <class T>
OptionRow<T> word(const std::string& name, std::string T::*member,
                  const std::vector<std::string>& words, const std::string& meaning) {
  return {{name, meaning, WordList{words}},
          [member, words](const T& s) {
            const auto at = std::find(words.begin(), words.end(), s.*member);
            return at == words.end() ? OptionValue(s.*member)
                                     : OptionValue(static_cast<std::uint64_t>(at - words.begin()));
          },
          [member, words](T& s, const OptionValue& v) {
            s.*member = words[std::get<std::uint64_t>(v)];
          }};
}

/// Free text; `phrase` says what it takes.
template <class T>
OptionRow<T> text(const std::string& name, std::string T::*member, const std::string& meaning,
                  const std::string& phrase) {
  return {{name, meaning, FreeText{}, phrase},
          [member](const T& s) { return OptionValue(s.*member); },
          [member](T& s, const OptionValue& v) { s.*member = std::get<std::string>(v); }};
}

/// Appends the rows of a member (or of a base of it), each name after `group`.
template <class S, class M, class T>
requires std::derived_from<M, T>
void append(std::vector<OptionRow<S>>& rows, const std::string& group, M S::*member,
            const std::vector<OptionRow<T>>& of_member) {
  for (const OptionRow<T>& row : of_member) {
    OptionRow<S> lifted{{group + row.name, row.meaning, row.takes, row.phrase},
                        [member, get = row.get](const S& s) { return get(s.*member); },
                        [member, set = row.set](S& s, const OptionValue& v) { set(s.*member, v); }};
    if (!row.at_most.empty()) lifted.at_most = group + row.at_most;
    rows.push_back(std::move(lifted));
  }
}

/// What is wrong with the values of a struct that no text made: "'taper' takes 0 to 1000, not
/// '-1'", "'width_min' (2) is more than 'width_max' (1)"; nothing where all is well.
template <class T>
std::optional<std::string> first_fault(const std::vector<OptionRow<T>>& rows, const T& s) {
  for (const OptionRow<T>& row : rows) {
    const std::string text = value_text(row, row.get(s));
    if (!parse_value(row, text)) {
      return "'" + row.name + "' takes " + takes_text(row) + ", not '" + text + "'";
    }
    const auto most = std::find_if(rows.begin(), rows.end(), [&](const OptionRow<T>& other) {
      return !row.at_most.empty() && other.name == row.at_most;
    });
    if (most != rows.end() && std::get<double>(row.get(s)) > std::get<double>(most->get(s))) {
      return "'" + row.name + "' (" + text + ") is more than '" + most->name + "' (" +
             value_text(*most, most->get(s)) + ")";
    }
  }
  return std::nullopt;
}

}  // namespace options
}  // namespace burin
