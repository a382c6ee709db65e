#pragma once
/// Views and sheets that have a name.

#include <burin/camera/camera.h>

#include <span>
#include <string_view>

namespace burin {

/// A view that `named_view` knows: "front", "iso", ...
struct StandardView {
  std::string_view name;
  NamedView view;
};
std::span<const StandardView> standard_views();

/// A sheet that `Paper::named` knows, "A4" or "letter", with its sides in millimetres: ISO 216 A
/// and B, and the American ones.
struct StandardPaper {
  std::string_view name;
  double longer, shorter;
};
std::span<const StandardPaper> standard_papers();

}  // namespace burin
