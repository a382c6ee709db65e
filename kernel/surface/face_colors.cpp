#include <burin/surface/face_colors.h>

#include <algorithm>
#include <map>
#include <utility>

namespace burin {
namespace {

constexpr std::size_t kOpaque = 7;  // letters of "#rrggbb"

}  // namespace

PaintedFaces painted_faces(std::span<const std::string> color, std::span<const double> area) {
  if (color.empty()) return {};
  std::map<std::string, double> sums;
  for (std::size_t i = 0; i < color.size(); ++i) {
    sums[color[i]] += i < area.size() ? area[i] : 0;
  }
  // A part is of glass where all of it is. Of several of one area the first.
  const auto is_glass = [](const std::string& one) { return one.size() > kOpaque; };
  const bool solid = !std::ranges::all_of(color, is_glass);
  const std::string* most = nullptr;
  for (const std::string& one : color) {
    if (solid && is_glass(one)) continue;
    if (!most || sums[one] > sums[*most]) most = &one;
  }
  PaintedFaces out{*most, {}};
  FaceColors faces;
  std::map<std::string, std::int32_t> numbers{{out.color, -1}, {"", -1}};
  for (const std::string& one : color) {
    const auto [at, is_new] =
        numbers.try_emplace(one, static_cast<std::int32_t>(faces.colors.size()));
    if (is_new) faces.colors.push_back(one);
    faces.of_face.push_back(at->second);
  }
  if (!faces.colors.empty()) out.faces = std::make_shared<const FaceColors>(std::move(faces));
  return out;
}

std::int64_t count_colors(const std::string& part, const FaceColors* faces) {
  return (part.empty() ? 0 : 1) + (faces ? static_cast<std::int64_t>(faces->colors.size()) : 0);
}

}  // namespace burin
