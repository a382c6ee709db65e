#include "name_faces.h"

#include <burin/base/short_list.h>

#include <fmt/format.h>

#include <cstddef>

namespace burin {

std::string face_list(std::vector<std::int32_t> faces, const Atlas& atlas) {
  for (std::int32_t& face : faces) face = atlas.source_face(face);
  constexpr std::size_t kNamed = 10;
  return (faces.size() > 1 ? "faces " : "face ") +
         short_list(faces, kNamed, [](std::int32_t face) { return std::to_string(face); });
}

void name_loose_faces(const std::vector<std::uint8_t>& marked, const std::string& reason,
                      const Atlas& atlas, Diagnostics* diagnostics) {
  std::vector<std::int32_t> faces;
  for (std::size_t f = 0; f < marked.size(); ++f) {
    if (marked[f]) faces.push_back(static_cast<std::int32_t>(f));
  }
  if (faces.empty() || !diagnostics) return;
  diagnostics->add(Severity::Warning, "brep.face_loose", static_cast<std::int64_t>(faces.size()),
                   fmt::format("drawn from triangles alone, joined to nothing ({}): {}", reason,
                               face_list(faces, atlas)));
}

}  // namespace burin
