#include <burin/arrange/arrange.h>
#include <burin/assembly/select.h>
#include <burin/base/error.h>

#include <algorithm>
#include <string>
#include <vector>

namespace burin {

void select_parts(Scene& scene, Illustration& illustration) {
  std::vector<PartStyle>& styles = illustration.illustrate.part_styles;
  split_parts(scene, illustration, styles);
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    // What can be looked through is drawn as --ghost has it; looks say otherwise.
    if (scene.parts[i].opacity < 1) styles[i].transparent = true, styles[i].hatched = false;
  }
  if (!illustration.only.empty()) {
    std::vector<bool> meant(scene.parts.size(), false);
    for (const std::string& selector : illustration.only) {
      for (const std::size_t part : select(scene, selector)) meant[part] = true;
    }
    for (std::size_t i = 0; i < meant.size(); ++i) {
      if (!meant[i]) styles[i].drawn = false;
    }
  }
  for (const Look& look : illustration.looks) {
    for (const std::string& selector : look.select) {
      try {
        for (const std::size_t part : select(scene, selector)) {
          PartStyle& one = styles[part];
          one.drawn = look.drawn.value_or(one.drawn);
          one.hatched = look.hatched.value_or(one.hatched);
          one.transparent = look.transparent.value_or(one.transparent);
          one.listed = look.listed.value_or(one.listed);
          if (look.style) one.style = look.style;
        }
      } catch (const UsageError& e) {
        throw UsageError(look.place + e.what());
      }
    }
  }
  const auto is_drawn = [](const PartStyle& style) { return style.drawn; };
  const bool chosen = !illustration.only.empty() || !illustration.looks.empty();
  if (chosen && std::ranges::none_of(styles, is_drawn)) {
    throw UsageError("all parts are left out; nothing is left to draw");
  }
}

}  // namespace burin
