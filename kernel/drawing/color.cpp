#include <burin/base/ascii.h>
#include <burin/drawing/color.h>

#include "css_colors.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>

namespace burin {

std::optional<Rgb> rgb_of(std::string_view text) {
  constexpr std::size_t kLength = 7;
  constexpr int kHexadecimal = 16;
  if (text.size() != kLength || text[0] != '#') return std::nullopt;
  Rgb rgb{};
  for (std::size_t i = 0; i < rgb.size(); ++i) {
    const char* begin = text.data() + 1 + 2 * i;
    const auto read = std::from_chars(begin, begin + 2, rgb[i], kHexadecimal);
    if (read.ec != std::errc{} || read.ptr != begin + 2) return std::nullopt;
  }
  return rgb;
}

namespace {

struct Named {
  std::string_view name, color;
};
constexpr std::array kNamed{
    Named{"orange", "#f28e2b"}, Named{"red", "#d62728"},    Named{"blue", "#3b7dd8"},
    Named{"green", "#4caf50"},  Named{"yellow", "#f5d547"}, Named{"purple", "#9467bd"},
    Named{"cyan", "#4dc4d9"},   Named{"pink", "#f4a6c0"},   Named{"brown", "#a0693d"},
    Named{"gray", "#9e9e9e"},   Named{"grey", "#9e9e9e"},   Named{"black", "#000000"},
    Named{"white", "#ffffff"}};

}  // namespace

std::vector<std::string> color_names() {
  std::vector<std::string> names;
  for (const Named& row : kNamed) names.emplace_back(row.name);
  for (const std::string_view name : detail::css_color_names()) names.emplace_back(name);
  return names;
}

std::string said_color_names() {
  std::string said;
  for (const Named& row : kNamed) said += fmt::format("{}, ", row.name);
  return said + "another name of CSS such as steelblue";
}

std::string without_name(std::string_view text) {
  const std::string small = lowered(std::string(text));
  const auto* row = std::ranges::find(kNamed, std::string_view(small), &Named::name);
  if (row != kNamed.end()) return std::string(row->color);
  if (const std::string_view color = detail::css_color(small); !color.empty()) {
    return std::string(color);
  }
  constexpr std::size_t kShort = 4;  // "#abc" of CSS: each digit twice
  if (text.size() != kShort || text[0] != '#') return std::string(text);
  const std::string whole{'#', text[1], text[1], text[2], text[2], text[3], text[3]};
  return rgb_of(whole) ? whole : std::string(text);
}

std::string hint_of_alpha(std::string_view text) {
  constexpr std::size_t kLength = 7, kWithAlpha = 9;
  if (text.size() != kWithAlpha || !rgb_of(text.substr(0, kLength)) ||
      !rgb_of("#0000" + std::string(text.substr(kLength))))
    return {};
  return fmt::format("; a colour has no alpha: write {}, and set the opacity by fill.opacity",
                     text.substr(0, kLength));
}

bool is_grey(const Rgb& color) { return color[0] == color[1] && color[1] == color[2]; }

std::string fault_of_ink(std::string_view name) {
  constexpr std::size_t kLongest = 127;  // bytes of a name in PDF
  constexpr char kDelete = 127;
  const auto is_control = [](char c) { return (c >= 0 && c < ' ') || c == kDelete; };
  if (name.empty()) return "takes the name of an ink, not nothing";
  if (name.size() > kLongest) {
    return fmt::format("takes a name of {} bytes at most, not {}", kLongest, name.size());
  }
  if (name == "All" || name == "None") {
    return fmt::format("takes the name of an ink, not '{}', which has a meaning of its own in PDF",
                       name);
  }
  if (std::ranges::any_of(name, is_control)) return "takes a name without control characters";
  return {};
}

std::string to_text(const Rgb& color) {
  return fmt::format("#{:02x}{:02x}{:02x}", color[0], color[1], color[2]);
}

namespace {

/// The curve of sRGB, and back.
double linear(std::uint8_t byte) {
  const double c = byte / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}
std::uint8_t byte_of(double c) {
  const double curved = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(curved, 0.0, 1.0)));
}

}  // namespace

// In OKLab lightness and both opponent colours are linear in the cube roots of the cones' answers,
// so all three times a share are those answers times its cube: light in RGB, too.
Rgb with_lightness(const Rgb& color, double share) {
  const double light = share * share * share;
  Rgb out{};
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = byte_of(light * linear(color[i]));
  return out;
}

namespace {

constexpr double kStray = 0.05;    // the share of light that any surface gives back
constexpr double kNearest = 0.86;  // share of lightness at which two flat tones are told apart
constexpr double kPale = 0.5;      // light beyond which colours are hardly told apart

double light_of(const Rgb& c) {
  return 0.2126 * linear(c[0]) + 0.7152 * linear(c[1]) + 0.0722 * linear(c[2]);
}

/// Mixed with white until it has that much light, if any colour has.
Rgb lightened(const Rgb& color, double light) {
  const double is = light_of(color), wanted = std::min(light, 1.0);
  if (is >= wanted) return color;
  const double white = (wanted - is) / (1 - is);
  Rgb out{};
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double own = linear(color[i]);
    out[i] = byte_of(own + white * (1 - own));
  }
  return out;
}

/// The least light beside lines of a dark ink, and the most beside those of a light one.
double least_light(const Rgb& ink, double contrast) {
  return contrast * (light_of(ink) + kStray) - kStray;
}
double most_light(const Rgb& ink) { return (light_of(ink) + kStray) / kLeastContrast - kStray; }

}  // namespace

double contrast(const Rgb& a, const Rgb& b) {
  const auto [low, high] = std::minmax({light_of(a) + kStray, light_of(b) + kStray});
  return high / low;
}

double readable_darkest(const Tones& tones, const Rgb& ink) {
  const double is = light_of(tones.light), least = least_light(ink, kLeastShadeContrast);
  const bool seen = is <= most_light(ink) || is * std::pow(tones.darkest, 3) >= least;
  if (seen || least_light(ink, kLeastContrast) > 1) return tones.darkest;
  return std::max(tones.darkest, std::min(std::cbrt(least / is), kNearest));
}

Tones readable(const Tones& tones, const Rgb& ink) {
  const double is = light_of(tones.light), least = least_light(ink, kLeastContrast),
               most = most_light(ink);
  if (is <= most) return tones;
  if (least > 1) return {with_lightness(tones.light, std::cbrt(most / is)), tones.darkest};
  Tones out = tones;
  const double shade = least_light(ink, kLeastShadeContrast);
  const double wanted = std::max(least, shade / std::pow(std::max(tones.darkest, kNearest), 3));
  if (is < wanted) {
    out.light = lightened(tones.light, std::min(wanted, std::max(least, kPale)));
  }
  out.darkest = readable_darkest(out, ink);
  return out;
}

Rgb over(const Rgb& color, double opacity, const Rgb& below) {
  Rgb out{};
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] = static_cast<std::uint8_t>(std::lround(below[i] + opacity * (color[i] - below[i])));
  }
  return out;
}

}  // namespace burin
