#pragma once
/// Sizes of ISO metric screw threads.
/// @cite ISO261, ISO724

#include <optional>
#include <string_view>

namespace burin {

/// The pitch of a coarse thread of ISO 261, mm; nothing where it has none of that diameter. Small
/// sizes and those of the second and third choice are among them.
std::optional<double> coarse_pitch(double diameter);

/// The coarse thread whose minor diameter is nearest to that of a hole, mm; nothing where none is
/// within 4 %.
std::optional<double> coarse_of_minor(double minor);

/// The minor diameter D1 = D - 1.0825 P of ISO 724, mm: five eighths of the height of the
/// sharp triangle of 60 degrees on each side.
double minor_diameter(double diameter, double pitch);

/// What a designation says, mm.
struct MetricSize {
  double diameter = 0;
  std::optional<double> pitch = {};
};

/// "M6", "M6x0.75", "m6 x 1", "M6-6H"; nothing where a text is none of these.
std::optional<MetricSize> metric_size(std::string_view text);

}  // namespace burin
