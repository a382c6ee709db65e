#pragma once
/// Faces of a file in named groups, made into one soup a part.

#include <burin/base/run_context.h>
#include <burin/converters/mesh_reader.h>

#include "look.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace burin {

inline constexpr std::uint32_t kNoGroup = std::numeric_limits<std::uint32_t>::max();

struct GroupedFaces {
  std::vector<Vec3> positions;
  std::vector<std::uint32_t> indices;
  std::vector<std::size_t> offsets{0};
  /// As that of PolygonSoup.
  std::vector<glm::vec2> texture;
  /// For each face an index into `names`, or kNoGroup.
  std::vector<std::uint32_t> group;
  std::vector<std::string> names;
  /// For each face its colour; empty where none has any.
  std::vector<std::optional<Rgba>> color = {};
  /// Connected: groups whose open borders fit together become one part: many programs write the
  /// faces or materials of one closed body as groups, and its inner borders are no ends of the
  /// surface; and so do open ones of one name. OneName: only those of one name whose borders fit.
  /// Closed ones of one name are copies.
  enum class Join { None, OneName, Connected } join = Join::None;
};

/// Adds a use of the next object, which looks so; with `polygon_colors` where its faces differ.
void add_use(const FaceLooks& looks, MeshFile& file);

/// Adds one object a group that has faces, in the order of their first faces; what looks even has
/// its colour.
void split_groups(GroupedFaces faces, MeshFile& file, const RunContext& context);

}  // namespace burin
