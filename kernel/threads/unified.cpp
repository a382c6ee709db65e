#include <burin/threads/unified.h>

#include <array>
#include <charconv>
#include <cstddef>
#include <optional>
#include <span>

namespace burin {
namespace {

// ASME B1.1: inches, threads an inch.
constexpr auto kUnc = std::to_array<std::string_view>(
    {"#1-64",   "#2-56",   "#3-48",   "#4-40",   "#5-40",     "#6-32",   "#8-32",
     "#10-24",  "#12-24",  "1/4-20",  "5/16-18", "3/8-16",    "7/16-14", "1/2-13",
     "9/16-12", "5/8-11",  "3/4-10",  "7/8-9",   "1-8",       "1 1/8-7", "1 1/4-7",
     "1 3/8-6", "1 1/2-6", "1 3/4-5", "2-4.5",   "2 1/4-4.5", "2 1/2-4", "2 3/4-4",
     "3-4",     "3 1/4-4", "3 1/2-4", "3 3/4-4", "4-4"});
constexpr auto kUnf = std::to_array<std::string_view>(
    {"#0-80",  "#1-72",  "#2-64",  "#3-56",   "#4-48",    "#5-44",    "#6-40",    "#8-36",
     "#10-32", "#12-28", "1/4-28", "5/16-24", "3/8-24",   "7/16-20",  "1/2-20",   "9/16-18",
     "5/8-18", "3/4-16", "7/8-14", "1-12",    "1 1/8-12", "1 1/4-12", "1 3/8-12", "1 1/2-12"});
constexpr auto kUnef = std::to_array<std::string_view>(
    {"#12-32",   "1/4-32",    "5/16-32",   "3/8-32",    "7/16-28",  "1/2-28",
     "9/16-24",  "5/8-24",    "11/16-24",  "3/4-20",    "13/16-20", "7/8-20",
     "15/16-20", "1-20",      "1 1/16-18", "1 1/8-18",  "1 1/4-18", "1 5/16-18",
     "1 3/8-18", "1 7/16-18", "1 1/2-18",  "1 9/16-18", "1 5/8-18", "1 11/16-18"});

constexpr double kInch = 25.4;

std::optional<double> number_of(std::string_view text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value, std::chars_format::fixed);
  if (error != std::errc() || rest != end || text.empty()) return std::nullopt;
  return value;
}

/// "1 1/4", "3/8", "#10", which begin at 0.060 inch and go on by 0.013.
std::optional<double> inches(std::string_view text) {
  if (text.starts_with("#")) {
    const auto number = number_of(text.substr(1));
    return number ? std::optional(0.06 + 0.013 * *number) : std::nullopt;
  }
  std::optional<double> whole = 0;
  if (const std::size_t space = text.find(' '); space != text.npos) {
    whole = number_of(text.substr(0, space));
    text.remove_prefix(space + 1);
  }
  const std::size_t slash = text.find('/');
  const auto above = number_of(text.substr(0, slash));
  const auto below = slash == text.npos ? std::optional(1.0) : number_of(text.substr(slash + 1));
  if (!whole || !above || !below) return std::nullopt;
  return *whole + *above / *below;
}

std::optional<UnifiedSize> size_of(std::string_view listed, std::string_view series) {
  const std::size_t dash = listed.find('-');
  const auto diameter = inches(listed.substr(0, dash));
  const auto threads = number_of(listed.substr(dash + 1));
  if (!diameter || !threads) return std::nullopt;
  return UnifiedSize{std::string(listed) + " " + std::string(series), kInch * *diameter,
                     kInch / *threads};
}

struct Series {
  std::string_view name;
  std::span<const std::string_view> sizes;
};

constexpr std::array kSeries = {Series{"UNC", kUnc}, Series{"UNF", kUnf}, Series{"UNEF", kUnef}};

}  // namespace

std::optional<UnifiedSize> unified_size(std::string_view series, std::size_t number) {
  for (const Series& one : kSeries) {
    if (one.name == series && number < one.sizes.size()) return size_of(one.sizes[number], series);
  }
  return std::nullopt;
}

std::optional<UnifiedSize> unified_size(std::string_view text) {
  const std::size_t space = text.rfind(' ');
  if (space == text.npos) return std::nullopt;
  const std::string_view series = text.substr(space + 1), size = text.substr(0, space);
  for (const Series& one : kSeries) {
    if (one.name != series) continue;
    for (const std::string_view listed : one.sizes) {
      if (size == listed || size == listed.substr(0, listed.find('-'))) {
        return size_of(listed, series);
      }
    }
  }
  return std::nullopt;
}

std::optional<MetricSize> known_size(std::string_view text) {
  if (const auto unified = unified_size(text)) return MetricSize{unified->diameter, unified->pitch};
  return metric_size(text);
}

}  // namespace burin
