#include <burin/threads/metric.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string>

namespace burin {
namespace {

struct Coarse {
  double diameter, pitch;
};

constexpr std::array kCoarse = {
    Coarse{1, 0.25},   Coarse{1.1, 0.25}, Coarse{1.2, 0.25}, Coarse{1.4, 0.3},  Coarse{1.6, 0.35},
    Coarse{1.8, 0.35}, Coarse{2, 0.4},    Coarse{2.2, 0.45}, Coarse{2.5, 0.45}, Coarse{3, 0.5},
    Coarse{3.5, 0.6},  Coarse{4, 0.7},    Coarse{4.5, 0.75}, Coarse{5, 0.8},    Coarse{6, 1},
    Coarse{7, 1},      Coarse{8, 1.25},   Coarse{9, 1.25},   Coarse{10, 1.5},   Coarse{11, 1.5},
    Coarse{12, 1.75},  Coarse{14, 2},     Coarse{16, 2},     Coarse{18, 2.5},   Coarse{20, 2.5},
    Coarse{22, 2.5},   Coarse{24, 3},     Coarse{27, 3},     Coarse{30, 3.5},   Coarse{33, 3.5},
    Coarse{36, 4},     Coarse{39, 4},     Coarse{42, 4.5},   Coarse{45, 4.5},   Coarse{48, 5},
    Coarse{52, 5},     Coarse{56, 5.5},   Coarse{60, 5.5},   Coarse{64, 6},     Coarse{68, 6},
};

/// Relative: a model in inches or in single precision still has the size.
constexpr double kSame = 1e-4;
/// Of a diameter: drills differ from ISO 724 by less.
constexpr double kNearMinor = 0.04;

/// A number at the start of a text, which it takes away.
std::optional<double> take_number(std::string_view& text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value, std::chars_format::fixed);
  if (error != std::errc() || !(value > 0) || value > 1e6) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(rest - text.data()));
  return value;
}

void skip_spaces(std::string_view& text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
}

/// x, X or the sign of multiplication.
bool take_times(std::string_view& text) {
  for (const std::string_view sign : {"x", "X", "*", "\xc3\x97"}) {
    if (!text.starts_with(sign)) continue;
    text.remove_prefix(sign.size());
    return true;
  }
  return false;
}

}  // namespace

std::optional<double> coarse_pitch(double diameter) {
  const auto found = std::ranges::find_if(kCoarse, [&](const Coarse& one) {
    return std::abs(one.diameter - diameter) <= kSame * one.diameter;
  });
  if (found == kCoarse.end()) return std::nullopt;
  return found->pitch;
}

double minor_diameter(double diameter, double pitch) {
  return diameter - 1.25 * (0.5 * std::sqrt(3.0)) * pitch;
}

std::optional<double> coarse_of_minor(double minor) {
  const auto off = [&](const Coarse& one) {
    return std::abs(minor_diameter(one.diameter, one.pitch) - minor);
  };
  const Coarse& nearest = *std::ranges::min_element(kCoarse, {}, off);
  if (off(nearest) > kNearMinor * minor) return std::nullopt;
  return nearest.diameter;
}

std::optional<MetricSize> metric_size(std::string_view text) {
  skip_spaces(text);
  if (text.empty() || (text.front() != 'M' && text.front() != 'm')) return std::nullopt;
  text.remove_prefix(1);
  const std::optional<double> diameter = take_number(text);
  if (!diameter) return std::nullopt;
  MetricSize size{*diameter};
  skip_spaces(text);
  if (take_times(text)) {
    skip_spaces(text);
    size.pitch = take_number(text);
    if (!size.pitch) return std::nullopt;
    skip_spaces(text);
  }
  // Tolerance classes and left hand threads follow a dash.
  if (!text.empty() && text.front() != '-') return std::nullopt;
  return size;
}

}  // namespace burin
