#include <burin/illustrate/ground.h>
#include <burin/tone/catalogue.h>

#include "pmi/lay_pmi.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace burin {

bool casts_ground_shadow(Vec3 to_light, Vec3 to_viewer) {
  constexpr double kLeastLight = 0.1, kLeastView = 0.02;  // sines of their heights
  return to_light.z > kLeastLight && to_viewer.z > kLeastView;
}

Placement onto_ground(Vec3 to_light, double ground) {
  const Vec3 along = to_light / to_light.z;
  Mat3 linear(1);
  linear[2] -= along;  // the column of z
  return {linear, along * ground};
}

Style style_in_grid(Style style, Vec3 to_viewer) {
  constexpr double kAbove = 0.999;  // sine of its height
  if (to_viewer.z > kAbove) style.shadow.ground = false;
  return style;
}

Camera::ExtentFn extent_with_shadow(const Scene& scene, const Style& style,
                                    std::span<const PartStyle> part_styles,
                                    const ViewOptions& view) {
  const auto plain = [&scene, part_styles, pmi = style.pmi, view](const Mat3& axes) {
    Box3 box = drawn_bounds(scene, part_styles, axes);
    box.add(detail::pmi_bounds(scene, part_styles, pmi, view, axes));
    return box;
  };
  if (!style.shadow.ground) return plain;
  // How the sheet lies, whatever is on it: a perspective view asks for axes that are none of it.
  const Camera level = Camera::fit(
      [](const Mat3&) {
        return Box3{Vec3(-1), Vec3(1)};
      },
      {.direction = view.direction, .up = view.up});
  const Vec3 to_light = tone::to_light(level, style.tone);
  const double ground = drawn_bounds(scene, part_styles).min.z;
  if (!std::isfinite(ground) || !casts_ground_shadow(to_light, level.direction())) return plain;
  std::vector<PartStyle> casting(part_styles.begin(), part_styles.end());
  casting.resize(scene.parts.size());
  for (PartStyle& one : casting) {
    one.drawn = one.drawn && !one.transparent && (one.style ? *one.style : style).fill.shadow;
  }
  if (std::ranges::none_of(casting, &PartStyle::drawn)) return plain;
  return [&scene, plain, casting = std::move(casting),
          down = onto_ground(to_light, ground)](const Mat3& axes) {
    Box3 box = plain(axes);
    if (box.empty()) return box;
    const Box3 shadow = drawn_bounds(scene, casting, axes * down.linear);
    const Vec3 by = axes * down.offset;
    box.add({shadow.min + by, shadow.max + by});
    return box;
  };
}

}  // namespace burin
