#include <burin/base/ascii.h>
#include <burin/base/error.h>
#include <burin/converters/values.h>
#include <burin/options/request.h>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <span>
#include <string_view>

namespace burin {
namespace {

template <class T>
std::optional<T> parse(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return {};
  return value;
}

}  // namespace

bool parse_list(std::string_view text, std::span<double> out) {
  std::string_view rest = text;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const std::size_t comma = i + 1 < out.size() ? rest.find(',') : rest.size();
    if (comma == std::string_view::npos) return false;
    std::string_view word = rest.substr(0, comma);
    while (word.starts_with(' ')) word.remove_prefix(1);
    const auto x = parse<double>(word);
    if (!x || !std::isfinite(*x)) return false;
    out[i] = *x;
    rest.remove_prefix(std::min(comma + 1, rest.size()));
  }
  return true;
}

std::uint64_t whole_option(const std::string& option, const std::string& text, std::uint64_t low,
                           std::uint64_t high, const char* what) {
  const auto n = parse<std::uint64_t>(text);
  if (!n || *n < low || *n > high) refuse_value(option, what, text);
  return *n;
}

std::optional<Vec3> point_option(const std::string& option, const std::string& text) {
  if (text.empty()) return {};
  double v[3];
  if (!parse_list(text, v)) refuse_value(option, "a point X,Y,Z", text);
  return Vec3(v[0], v[1], v[2]);
}

SectionPlane cut_option(const std::string& option, const std::string& text) {
  const auto refuse = [&] {
    refuse_value(option, "an axis x, y or z, one with a sign, or X,Y,Z; and =MM", text);
  };
  SectionPlane cut;
  const std::size_t equals = text.find('=');
  std::string_view axis = std::string_view(text).substr(0, equals);
  if (equals != std::string::npos) {
    cut.offset = parse<double>(std::string_view(text).substr(equals + 1));
    if (!cut.offset || !std::isfinite(*cut.offset)) refuse();
  }
  if (axis.find(',') != std::string_view::npos) {
    double v[3];
    if (!parse_list(axis, v)) refuse();
    const double length = glm::length(Vec3(v[0], v[1], v[2]));
    if (!(length > 0)) refuse();
    cut.axis = Vec3(v[0], v[1], v[2]) / length;
    cut.side = 1;
    return cut;
  }
  if (axis.starts_with('+') || axis.starts_with('-')) {
    cut.side = axis.front() == '+' ? 1 : -1;
    axis.remove_prefix(1);
  }
  const std::size_t which = axis.size() == 1 ? std::string_view("xyz").find(axis) : axis.npos;
  if (which == std::string_view::npos) refuse();
  cut.axis = Vec3(0);
  cut.axis[static_cast<int>(which)] = 1;
  return cut;
}

std::optional<Box3> box_option(const std::string& option, const std::string& text) {
  constexpr const char* kWhat = "a box x0,y0,z0,x1,y1,z1 with each minimum below its maximum";
  if (text.empty()) return {};
  double v[6];
  if (!parse_list(text, v)) refuse_value(option, kWhat, text);
  const Box3 box{{v[0], v[1], v[2]}, {v[3], v[4], v[5]}};
  for (int i = 0; i < 3; ++i) {
    if (!(box.min[i] < box.max[i])) refuse_value(option, kWhat, text);
  }
  return box;
}

std::optional<double> scale_option(const std::string& option, const std::string& text, double low,
                                   double high) {
  if (text.empty()) return {};
  const std::size_t colon = text.find(':');
  const std::string_view all = text;
  std::optional<double> x = parse<double>(all.substr(0, colon));
  if (colon != std::string::npos) {
    const auto y = parse<double>(all.substr(colon + 1));
    x = x && y ? std::optional(*x / *y) : std::nullopt;
  }
  if (!x || !std::isfinite(*x) || !(*x > 0))
    refuse_value(option, "a number over 0, or a ratio like 1:2", text);
  if (*x < low || *x > high) {
    refuse_value(option, fmt::format("{:g} to {:g}, or a ratio like 1:2", low, high), text);
  }
  return x;
}

std::optional<Margin> margin_option(const std::string& option, const std::string& text,
                                    Vec2 sheet) {
  constexpr double kLeast = 2;  // mm of the sheet that are left
  if (text.empty()) return {};
  if (text.find(',') == std::string::npos) {
    const double most = 0.5 * (std::min(sheet.x, sheet.y) - kLeast);
    const auto all = parse<double>(text);
    if (all && *all >= 0 && *all <= most) return Margin(*all);
    const std::string range = fmt::format(
        "0 to {} mm on this paper ({} without it), or four of them, TOP,RIGHT,BOTTOM,LEFT", most,
        Margin().top);
    refuse_value(option, range, text);
  }
  double v[4];
  const bool sane = parse_list(text, v) &&
                    std::all_of(std::begin(v), std::end(v), [](double x) { return x >= 0; }) &&
                    v[0] + v[2] <= sheet.y - kLeast && v[1] + v[3] <= sheet.x - kLeast;
  if (!sane) {
    const std::string what =
        fmt::format("mm, one number or four, TOP,RIGHT,BOTTOM,LEFT, that leave {} mm of {} x {} mm",
                    kLeast, sheet.x, sheet.y);
    refuse_value(option, what, text);
  }
  return Margin(v[0], v[1], v[2], v[3]);
}

std::string id_prefix_option(const std::string& option, const std::string& text) {
  const auto is_first = [](char c) { return is_letter(c) || c == '_'; };
  const auto is_later = [&](char c) { return is_first(c) || is_digit(c) || c == '-' || c == '.'; };
  if (!text.empty() &&
      !(is_first(text.front()) && std::all_of(text.begin(), text.end(), is_later))) {
    refuse_value(option, "a letter and then letters, digits, - _ and dots", text);
  }
  return text;
}

}  // namespace burin
