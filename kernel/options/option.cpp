#include <burin/options/option.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <charconv>
#include <cmath>
#include <iterator>

namespace burin {
namespace {

using Json = nlohmann::ordered_json;

template <class... F>
struct Cases : F... {
  using F::operator()...;
};
template <class... F>
Cases(F...) -> Cases<F...>;

std::string_view trimmed(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

template <class T>
std::optional<T> to_number(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('+')) text.remove_prefix(1);
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return {};
  return value;
}

std::optional<OptionValue> to_value(const NumberRange& range, std::string_view text) {
  const auto x = to_number<double>(text);
  if (!x || !(*x >= range.low && *x <= range.high)) return {};
  return *x;
}

std::optional<OptionValue> to_value(const WholeRange& range, std::string_view text) {
  const auto n = to_number<std::uint64_t>(text);
  if (!n || *n < range.low || *n > range.high) return {};
  return *n;
}

std::optional<OptionValue> to_value(const Switch& words, std::string_view text) {
  if (text == words.on) return true;
  if (text == words.off) return false;
  for (const std::string_view on : {"true", "True", "1", "yes", "on"}) {
    if (text == on) return true;
  }
  for (const std::string_view off : {"false", "False", "0", "no", "off"}) {
    if (text == off) return false;
  }
  return {};
}

std::optional<OptionValue> to_value(const WordList& list, std::string_view text) {
  for (std::size_t i = 0; i < list.words.size(); ++i) {
    if (list.words[i] == text) return std::uint64_t{i};
  }
  return {};
}

std::optional<OptionValue> to_value(const Direction&, std::string_view text) {
  Vec3 v(0);
  for (int i = 0; i < 3; ++i) {
    const std::size_t comma = i < 2 ? text.find(',') : text.size();
    if (comma == std::string_view::npos) return {};
    const auto x = to_number<double>(text.substr(0, comma));
    if (!x || !std::isfinite(*x)) return {};
    v[i] = *x;
    text.remove_prefix(std::min(comma + 1, text.size()));
  }
  if (v == Vec3(0)) return {};
  return v;
}

std::optional<OptionValue> to_value(const FreeText&, std::string_view text) {
  return std::string(text);
}

std::string listed(const std::vector<std::string>& words) {
  if (words.size() < 2) return words.empty() ? "" : words.front();
  return fmt::format("{} or {}", fmt::join(words.begin(), words.end() - 1, ", "), words.back());
}

bool is_plain_switch(const Switch& words) { return words.on == "true" && words.off == "false"; }

void describe(const Option& option, Json& json) {
  std::visit(Cases{[&](const NumberRange& range) {
                     json["low"] = range.low;
                     json["high"] = range.high;
                     json["unit"] = range.unit;
                   },
                   [&](const WholeRange& range) {
                     json["low"] = range.low;
                     json["high"] = range.high;
                   },
                   [&](const Switch& words) {
                     json["words"] = {words.off, words.on};
                   },
                   [&](const WordList& list) { json["words"] = list.words; },
                   [](const Direction&) {}, [](const FreeText&) {}},
             option.takes);
}

}  // namespace

std::string takes_text(const Option& option) {
  if (!option.phrase.empty()) return option.phrase;
  return std::visit(
      Cases{[](const NumberRange& range) { return fmt::format("{} to {}", range.low, range.high); },
            [](const WholeRange& range) { return fmt::format("{} to {}", range.low, range.high); },
            [](const Switch& words) { return fmt::format("{} or {}", words.on, words.off); },
            [](const WordList& list) { return listed(list.words); },
            [](const Direction&) { return std::string("X,Y,Z"); },
            [](const FreeText&) { return std::string("text"); }},
      option.takes);
}

std::optional<OptionValue> parse_value(const Option& option, std::string_view text) {
  return std::visit([&](const auto& takes) { return to_value(takes, trimmed(text)); },
                    option.takes);
}

std::string value_text(const Option& option, const OptionValue& value) {
  return std::visit(
      Cases{[](double x) { return fmt::format("{}", x); },
            [&](std::uint64_t n) {
              const auto* list = std::get_if<WordList>(&option.takes);
              return list && n < list->words.size() ? list->words[n] : fmt::format("{}", n);
            },
            [&](bool on) {
              const auto* words = std::get_if<Switch>(&option.takes);
              const Switch plain;
              return on ? (words ? words : &plain)->on : (words ? words : &plain)->off;
            },
            [](Vec3 v) { return fmt::format("{},{},{}", v.x, v.y, v.z); },
            [](const std::string& text) { return text; }},
      value);
}

std::string_view kind_of(const Option& option) {
  constexpr std::string_view kKinds[] = {"number", "whole", "flag", "word", "direction", "text"};
  static_assert(std::size(kKinds) == std::variant_size_v<Takes>);
  return kKinds[option.takes.index()];
}

std::string to_json(const Option& option,
                    const std::vector<std::pair<std::string, std::string>>& more) {
  Json json{{"name", option.name}, {"meaning", option.meaning}, {"kind", kind_of(option)}};
  describe(option, json);
  json["takes"] = takes_text(option);
  for (const auto& [key, value] : more) json[key] = value;
  return json.dump();
}

std::string value_schema(const Option& option) {
  Json json{{"description", option.meaning}};
  std::visit(Cases{[&](const NumberRange& range) {
                     json["type"] = "number";
                     json["minimum"] = range.low;
                     json["maximum"] = range.high;
                   },
                   [&](const WholeRange& range) {
                     json["type"] = "integer";
                     json["minimum"] = range.low;
                     json["maximum"] = range.high;
                   },
                   [&](const Switch& words) {
                     if (is_plain_switch(words)) {
                       json["type"] = "boolean";
                     } else {
                       json["enum"] = {words.off, words.on};
                     }
                   },
                   [&](const WordList& list) { json["enum"] = list.words; },
                   [&](const Direction&) {
                     json["type"] = "array";
                     json["items"] = {{"type", "number"}};
                     json["minItems"] = json["maxItems"] = 3;
                   },
                   [&](const FreeText&) { json["type"] = "string"; }},
             option.takes);
  return json.dump();
}

}  // namespace burin
