#include "saved_view.h"

#include <burin/base/error.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <vector>

namespace burin::detail {

void take_saved_view(const Scene& scene, Illustration& illustration) {
  const std::string& name = illustration.saved_view;
  if (name.empty()) return;
  if (!illustration.views.empty()) {
    throw UsageError("`saved_view` is one view: leave `views` out");
  }
  std::vector<std::string> names;
  for (const Part& part : scene.parts) {
    if (!part.pmi) continue;
    for (const PmiView& view : part.pmi.pmi->views) {
      if (view.name == name) {
        illustration.view.direction = glm::normalize(part.pmi.placement.vector(view.to_viewer));
        illustration.view.up = glm::normalize(part.pmi.placement.vector(view.up));
        illustration.style.pmi.view = name;
        return;
      }
      if (std::ranges::find(names, view.name) == names.end()) names.push_back(view.name);
    }
  }
  if (names.empty()) {
    throw UsageError(fmt::format(
        "there is no saved view '{}': no file names any; `view` takes a direction", name));
  }
  throw UsageError(
      fmt::format("there is no saved view '{}'; the file has {}", name, fmt::join(names, ", ")));
}

}  // namespace burin::detail
