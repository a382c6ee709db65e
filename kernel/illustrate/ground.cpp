#include <burin/illustrate/ground.h>

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
  // Which way is right and up is known without the scene: a camera in perspective asks for extents
  // along slanted axes, from which it could not be told.
  const Camera camera = Camera::fit(
      [](const Mat3&) {
        return Box3{Vec3(0), Vec3(1)};
      },
      {.direction = view.direction, .up = view.up});
  const Vec3 light = glm::normalize(style.tone.light);
  const Vec3 to_light =
      light.x * camera.right() + light.y * camera.up() + light.z * camera.direction();
  const bool casts = style.shadow.ground && casts_ground_shadow(to_light, camera.direction());
  return [=, &scene](const Mat3& axes) {
    Box3 box = drawn_bounds(scene, part_styles, axes);
    if (!casts || box.empty()) return box;
    const Placement down = onto_ground(to_light, drawn_bounds(scene, part_styles, Mat3(1)).min.z);
    const Box3 shadow = drawn_bounds(scene, part_styles, axes * down.linear);
    const Vec3 by = axes * down.offset;
    box.add({shadow.min + by, shadow.max + by});
    return box;
  };
}

}  // namespace burin
