#include "region_options.h"

#include <burin/tone/catalogue.h>

#include "fill/fills.h"

#include <utility>

namespace burin::detail {
namespace {

// Whether lines over regions have the colour of these.
bool hatches_in_fill(const FillOptions& fill) {
  return fill.hatch.lines != FillHatch::Lines::None && fill.hatch.color == "fill";
}

}  // namespace

FeatureOptions feature_options(const PartStyles& part_styles) {
  FeatureOptions options{.intersections = false, .smooth = false};
  for (const Style* style : part_styles.styles()) {
    options.intersections |= style->feature.intersections;
    options.smooth |= style->feature.smooth;
    options.seams |= style->feature.seams;
  }
  return options;
}

std::vector<std::shared_ptr<const FaceColors>> face_colors(const Scene& scene,
                                                           const PartStyles& part_styles) {
  std::vector<std::shared_ptr<const FaceColors>> out;
  for (std::size_t i = 0; i < part_styles.size(); ++i) {
    const FillOptions& fill = part_styles.style(i).fill;
    const bool by_face = fill.color == "part" && (fill.opacity > 0 || hatches_in_fill(fill));
    out.push_back(part_styles.drawn(i) && by_face ? scene.parts[i].face_colors : nullptr);
  }
  return out;
}

RegionOptions region_options(const Scene& scene, const PartStyles& part_styles,
                             const Camera& camera, bool shadows) {
  RegionOptions options{.found = feature_options(part_styles)};
  for (std::size_t i = 0; i < part_styles.size(); ++i) {
    const FillOptions& fill = part_styles.style(i).fill;
    const bool shown = fill.color != "none" || fill.hatch.lines != FillHatch::Lines::None;
    const bool toned = part_styles.drawn(i) && shown && fill.steps > 1;
    std::vector<double> levels = even_levels(toned ? static_cast<std::size_t>(fill.steps) : 1);
    if (shadows && levels.empty()) levels = {tone::kUnlit};
    options.tones.push_back({tone::to_light(camera, part_styles.style(i).tone), std::move(levels)});
  }
  options.colors = face_colors(scene, part_styles);
  return options;
}

std::vector<bool> told_faces(const PartStyles& part_styles, bool all) {
  std::vector<bool> out;
  for (std::size_t i = 0; i < part_styles.size(); ++i) {
    out.push_back(part_styles.drawn(i) && (all || part_styles.style(i).fill.faces));
  }
  return out;
}

std::vector<bool> nested_fills(const PartStyles& part_styles) {
  std::vector<bool> out;
  for (std::size_t i = 0; i < part_styles.size(); ++i) {
    out.push_back(nests(part_styles.style(i).fill));
  }
  return out;
}

std::vector<bool> without_shadow(const PartStyles& part_styles, std::vector<bool> transparent) {
  for (std::size_t i = 0; i < part_styles.size(); ++i) {
    if (part_styles.drawn(i) && !part_styles.style(i).fill.shadow) transparent[i] = true;
  }
  return transparent;
}

}  // namespace burin::detail
