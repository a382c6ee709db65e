#pragma once
/// What a drawing is called where a format asks for it.

#include <burin/base/version.h>
#include <burin/drawing/drawing.h>

#include <fmt/format.h>

#include <string>

namespace burin {

/// Its own title, the name of its part, "NAME and 3 more", or "drawing".
inline std::string title_of(const Drawing& drawing) {
  if (!drawing.title.empty()) return drawing.title;
  std::string name;
  for (const DrawingPart& part : drawing.parts) {
    if (name.empty()) name = part.name;
  }
  if (name.empty()) return "drawing";
  if (drawing.parts.size() == 1) return name;
  return fmt::format("{} and {} more", name, drawing.parts.size() - 1);
}

inline std::string creator() { return fmt::format("burin {}", version()); }

inline std::string subject_of(const Drawing& drawing) {
  if (drawing.style.empty()) return "line art";
  return fmt::format("style {}, seed {}", drawing.style, drawing.seed);
}

}  // namespace burin
