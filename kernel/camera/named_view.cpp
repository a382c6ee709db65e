#include <burin/base/ascii.h>
#include <burin/base/error.h>
#include <burin/camera/standards.h>

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>

namespace burin {
namespace {

std::optional<Vec3> parse_vector(std::string_view text) {
  Vec3 v(0);
  const char* at = text.data();
  const char* end = at + text.size();
  for (int i = 0; i < 3; ++i) {
    if (i > 0) {
      if (at == end || *at != ',') return std::nullopt;
      ++at;
    }
    while (at != end && *at == ' ') ++at;
    if (at != end && *at == '+') ++at;
    const auto [next, error] = std::from_chars(at, end, v[i]);
    if (error != std::errc() || !std::isfinite(v[i])) return std::nullopt;
    at = next;
  }
  return at == end ? std::optional(v) : std::nullopt;
}

// From the model to a viewer to whom the x axis shows at `azimuth` and who looks down by
// `elevation`, in degrees.
Vec3 axonometric(double azimuth, double elevation) {
  const double a = glm::radians(azimuth), e = glm::radians(elevation);
  return {std::sin(a) * std::cos(e), -std::cos(a) * std::cos(e), std::sin(e)};
}

}  // namespace

std::span<const StandardView> standard_views() {
  static const Vec3 y(0, 1, 0), z(0, 0, 1);
  // ISO 5456-3: dimetric shortens one axis by half (edges at 7 and 42 degrees); trimetric has three
  // scales.
  static const std::array views{
      StandardView{"front", {{0, -1, 0}, z}},
      StandardView{"back", {{0, 1, 0}, z}},
      StandardView{"left", {{-1, 0, 0}, z}},
      StandardView{"right", {{1, 0, 0}, z}},
      StandardView{"top", {{0, 0, 1}, y}},
      StandardView{"bottom", {{0, 0, -1}, y}},
      StandardView{"iso", {{1, -1, 1}, z}},
      StandardView{"dimetric", {axonometric(20.705, 19.471), z}},
      StandardView{"trimetric", {axonometric(30, 25), z}},
  };
  return views;
}

NamedView named_view(std::string_view name) {
  const std::string lower = lowered(name);
  std::string names;
  for (const StandardView& known : standard_views()) {
    if (lower == known.name) return known.view;
    names += std::string(known.name) + ", ";
  }
  if (const auto v = parse_vector(lower)) {
    if (glm::length(*v) > 0) return {*v, Vec3(0, 0, 1)};
    throw UsageError("the view 0,0,0 has no direction: give X,Y,Z from the model to the viewer");
  }
  throw UsageError(
      fmt::format("unknown view '{}': use {}or X,Y,Z from the model to the viewer", name, names));
}

}  // namespace burin
