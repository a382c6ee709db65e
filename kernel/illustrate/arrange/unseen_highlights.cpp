#include "unseen_highlights.h"

#include <burin/assembly/select.h>
#include <burin/base/short_list.h>

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace burin::detail {
namespace {

/// One a part: whether a line or an area of it is drawn.
std::vector<bool> seen_parts(const Scene& scene, const Drawing& drawing) {
  std::vector<bool> seen(scene.parts.size(), false);
  const auto see = [&](std::int32_t part) {
    const auto i = static_cast<std::size_t>(part);
    if (i < seen.size()) seen[i] = true;
  };
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      see(path.source.part);
      for (const PathSource& other : path.also) see(other.source.part);
    }
  }
  for (const Area& area : drawing.areas) {
    if (area.role.empty()) see(area.part);
  }
  return seen;
}

}  // namespace

void report_unseen_highlights(const Scene& scene, const Illustration& illustration,
                              Drawing& drawing) {
  constexpr std::size_t kNamed = 2;
  const auto asked = [](const Look& look) { return look.highlight && !look.asked.empty(); };
  if (std::ranges::none_of(illustration.looks, asked)) return;
  const std::vector<PartStyle>& styles = illustration.illustrate.part_styles;
  const std::vector<bool> seen = seen_parts(scene, drawing);
  for (const Look& look : illustration.looks) {
    if (!asked(look)) continue;
    std::vector<std::size_t> hidden;
    bool any = false;
    for (const std::string& selector : look.select) {
      for (const std::size_t part : select(scene, selector)) {
        any = any || seen[part];
        if (part >= styles.size() || styles[part].drawn) hidden.push_back(part);
      }
    }
    if (any || hidden.empty()) continue;
    const std::string names = short_list(
        hidden, kNamed, [&](std::size_t part) { return "'" + scene.parts[part].name + "'"; });
    drawing.diagnostics.add(
        Severity::Warning, "look.unseen", 1,
        fmt::format("{} shows nothing: other parts hide {}; draw from another `view`, leave out "
                    "(`hide`) or ghost (`ghost`) what is before it, cut (`section`) or explode",
                    look.asked, names));
  }
}

}  // namespace burin::detail
