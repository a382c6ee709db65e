#include "part_styles.h"

#include <algorithm>

namespace burin::detail {
PartStyles::PartStyles(std::size_t parts, const Style& style, const IllustrateOptions& options)
    : parts_(parts), styles_{&style} {
  std::vector<std::string> texts{style_to_json(style)};
  for (std::size_t i = 0; i < std::min(parts, options.part_styles.size()); ++i) {
    const PartStyle& look = options.part_styles[i];
    One& one = parts_[i];
    if (look.style) {
      const std::string text = style_to_json(*look.style);
      const auto known = std::find(texts.begin(), texts.end(), text);
      one.style = static_cast<std::size_t>(known - texts.begin());
      if (known == texts.end()) {
        texts.push_back(text);
        styles_.push_back(&*look.style);
      }
    }
    one.drawn = look.drawn;
    one.transparent = look.transparent;
    one.hatched = look.hatched;
  }
  for (One& one : parts_) {
    one.hatched = one.hatched && one.drawn && styles_[one.style]->hatch.enabled;
  }
}

bool PartStyles::any_transparent() const {
  return std::any_of(parts_.begin(), parts_.end(),
                     [](const One& one) { return one.transparent && one.drawn; });
}

std::vector<bool> PartStyles::hatched_by(std::size_t style) const {
  std::vector<bool> flags;
  flags.reserve(parts_.size());
  for (const One& one : parts_) {
    flags.push_back(one.hatched && !one.transparent && one.style == style);
  }
  return flags;
}

}  // namespace burin::detail
