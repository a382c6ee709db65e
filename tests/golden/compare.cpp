#include "compare.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <charconv>
#include <cmath>
#include <filesystem>

namespace burin::golden {

namespace {

// Numbers of a file are few kinds; three decimals are a micrometre of paper.
void round_numbers(nlohmann::ordered_json& value) {
  if (value.is_number_float()) {
    value = std::round(value.get<double>() * 1000) / 1000 + 0.0;
  } else if (value.is_structured()) {
    for (auto& item : value) round_numbers(item);
  }
}

bool digit(char c) { return c >= '0' && c <= '9'; }

// The next token: a number, or a run of other characters.
std::string_view next_token(std::string_view& text) {
  std::size_t n = 0;
  const auto starts_number = [&](std::size_t i) {
    return digit(text[i]) || (text[i] == '-' && i + 1 < text.size() && digit(text[i + 1]));
  };
  if (!text.empty() && starts_number(0)) {
    n = 1;
    while (n < text.size() && (digit(text[n]) || text[n] == '.')) ++n;
    if (n + 1 < text.size() && text[n] == 'e' && (digit(text[n + 1]) || text[n + 1] == '-')) {
      n += 2;
      while (n < text.size() && digit(text[n])) ++n;
    }
  } else {
    while (n < text.size() && (n == 0 || (!starts_number(n) && text[n - 1] != '\n'))) ++n;
  }
  const std::string_view token = text.substr(0, n);
  text.remove_prefix(n);
  return token;
}

std::optional<double> number(std::string_view token) {
  double value = 0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (token.empty() || error != std::errc() || end != token.data() + token.size())
    return std::nullopt;
  return value;
}

bool same(std::string_view a, std::string_view b, double tolerance) {
  if (a == b) return true;
  const bool decimals = a.find('.') != a.npos || b.find('.') != b.npos;
  const auto x = number(a), y = number(b);
  return decimals && x && y && std::abs(*x - *y) <= tolerance;
}

}  // namespace

std::string canonical(const std::string& drawing_json) {
  auto drawing = nlohmann::ordered_json::parse(drawing_json);
  drawing.erase("generator");
  for (auto& part : drawing["parts"]) {
    part["source"] = std::filesystem::path(part["source"].get<std::string>()).filename().string();
  }
  round_numbers(drawing);
  std::string out;
  for (auto& [key, value] : drawing.items()) {
    if (key != "layers") {
      out += fmt::format("{}: {}\n", key, value.dump());
      continue;
    }
    for (const auto& layer : value) {
      out += fmt::format("layer: {}\n", layer.at("name").dump());
      for (const auto& path : layer.at("paths")) out += path.dump() + "\n";
    }
  }
  return out;
}

std::optional<std::string> difference(std::string_view expected, std::string_view actual,
                                      double tolerance) {
  std::size_t line = 1;
  while (!expected.empty() || !actual.empty()) {
    const std::string_view a = next_token(expected), b = next_token(actual);
    if (!same(a, b, tolerance)) {
      const auto shown = [](std::string_view t) {
        return t.empty() ? "the end" : std::string(t.substr(0, 60));
      };
      return fmt::format("line {}: {} instead of {}", line, shown(b), shown(a));
    }
    for (const char c : a) line += c == '\n' ? 1 : 0;
  }
  return std::nullopt;
}

}  // namespace burin::golden
