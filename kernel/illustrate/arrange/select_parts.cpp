#include <burin/arrange/arrange.h>
#include <burin/assembly/select.h>
#include <burin/base/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace burin {
namespace {

/// Which look the style of each part is from: the last that names it.
class StyledBy {
 public:
  StyledBy(std::size_t parts, std::size_t looks)
      : look_(parts, looks), named_(looks), above_(parts) {}

  /// Whether a part takes the style of a look: a highlight leaves it to one that names the part
  /// more closely. `levels`: `levels_above` of the name.
  bool takes_style(std::size_t index, const Look& look, std::size_t number, std::size_t levels) {
    std::optional<std::size_t>& above = above_[index];
    if (!look.highlight) {
      above.reset();
      return true;
    }
    if (above && *above < levels) {
      named_[number] = index;
      return false;
    }
    above = levels;
    return true;
  }

  void set(std::size_t part, std::size_t look) {
    look_[part] = look;
    named_[look] = part;
  }

  /// Tells of each look that was asked for whose parts are all left out, or have the style of a
  /// later one.
  void report_lost(const Scene& scene, const std::vector<PartStyle>& styles,
                   const std::vector<Look>& looks, Diagnostics& diagnostics) const {
    std::vector<bool> seen(looks.size() + 1, false);
    for (std::size_t part = 0; part < look_.size(); ++part) {
      if (styles[part].drawn) seen[look_[part]] = true;
    }
    for (std::size_t i = 0; i < looks.size(); ++i) {
      if (seen[i] || !named_[i] || looks[i].asked.empty()) continue;
      const std::size_t part = *named_[i];
      const std::string& name = scene.parts[part].name;
      const bool hidden = !styles[part].drawn;
      diagnostics.add(
          Severity::Warning, "look.lost", 1,
          hidden ? fmt::format("{} has no effect: '{}' is left out of the drawing", looks[i].asked,
                               name)
                 : fmt::format(
                       "{} has no effect: {} is laid over all of its parts, such as '{}' "
                       "(of several looks the last one holds, of several highlights the one that "
                       "names a part most closely, and looks go over highlights)",
                       looks[i].asked,
                       looks[look_[part]].asked.empty() ? "another look" : looks[look_[part]].asked,
                       name));
    }
  }

 private:
  std::vector<std::size_t> look_;
  std::vector<std::optional<std::size_t>> named_;  // a part of the look
  std::vector<std::optional<std::size_t>> above_;  // `levels_above` of its highlight
};

}  // namespace

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
  StyledBy styled(scene.parts.size(), illustration.looks.size());
  for (std::size_t i = 0; i < illustration.looks.size(); ++i) {
    const Look& look = illustration.looks[i];
    for (const std::string& selector : look.select) {
      try {
        const std::vector<std::size_t> found = select(scene, selector);
        const std::vector<std::size_t> levels = levels_above(scene, found, selector);
        for (std::size_t k = 0; k < found.size(); ++k) {
          const std::size_t part = found[k];
          PartStyle& one = styles[part];
          one.drawn = look.drawn.value_or(one.drawn);
          one.hatched = look.hatched.value_or(one.hatched);
          one.transparent = look.transparent.value_or(one.transparent);
          one.listed = look.listed.value_or(one.listed);
          if (!look.style || !styled.takes_style(part, look, i, levels[k])) continue;
          one.style = look.style;
          styled.set(part, i);
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
  styled.report_lost(scene, styles, illustration.looks, scene.diagnostics);
}

}  // namespace burin
